// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/bound/segment_proof.h"
#include "vcg_ext/core/geometry/point_triangle.h"

namespace vcg_ext
{

/// A face for many distances, in a ball that holds it.
struct TrialFace {
    Vector3<float> origin; ///< its first corner
    PreparedTriangle<float> shape;
    Vector3<float> center;
    float radius;

    TrialFace(const Vector3<float>& a, const Vector3<float>& b, const Vector3<float>& c)
        : origin(a), shape(PrepareTriangle(b - a, c - a))
    {
        const Vector3<float> toB = b - a, toC = c - a, middle = (1.0F / 3) * (toB + toC);
        constexpr float kRounding = 1.00001F;
        center = a + middle;
        radius =
            kRounding *
            std::sqrt(std::max({SquaredNorm(middle), SquaredNorm(toB - middle), SquaredNorm(toC - middle)}));
    }
    float Distance2(const Vector3<float>& p) const
    {
        return ClosestOnTriangle(Splat(p - origin), shape).distance2[0]; // no branches, no divisions
    }
    bool BallReaches(const Vector3<float>& p, float reach) const
    {
        const float both = reach + radius;
        return SquaredNorm(p - center) <= both * both;
    }
};

/// Four covered points, each with the face of the trial that is closest to it so far.
struct PointGroup {
    Vector3<Float4> position;
    Float4 distance2;
    Int4 owner; ///< index of a trial's face

    /// Looks at \p face where it may be closer to one of the points.
    void Try(const TrialFace& face, int index)
    {
        const Float4 reach = Sqrt(distance2) + face.radius;
        if (!AnyLane(SquaredNorm(position - Splat(face.center)) < reach * reach)) return;
        const Float4 here2 = ClosestOnTriangle(position - Splat(face.origin), face.shape).distance2;
        owner = Select(here2 < distance2, Splat(std::int32_t{index}), owner);
        distance2 = Min(here2, distance2);
    }
};

/// One thread's room for trials: the new faces of a star, and the points that they would have to cover.
struct BoundScratch {
    std::vector<TrialFace> faces; ///< the new ones, each with the new vertex as its first corner ...
    std::size_t starFaces = 0;    ///< ... so many; behind them others that were looked at
    std::vector<std::uint32_t> points;
    std::vector<PointGroup> groups; ///< of them, the last one repeated to fill four
    SegmentEnd vertex{};            ///< the new vertex
    std::vector<std::uint32_t> ring;
    bool aroundIsKnown = false; ///< the faces around the ring are among the faces
    SegmentStack segments;
    bool refused = false; ///< the bound has, since the run began; Clear leaves that

    void Clear()
    {
        faces.clear();
        points.clear();
        groups.clear();
        ring.clear();
        aroundIsKnown = false;
    }
    float Distance2(std::size_t point) const { return groups[point / kLanes].distance2[point % kLanes]; }
    std::uint32_t Owner(std::size_t point) const
    {
        return static_cast<std::uint32_t>(groups[point / kLanes].owner[point % kLanes]);
    }

    /// Appends the group of the points from \p first on.
    PointGroup& AddGroup(const CoveredPoints& covered, std::size_t first)
    {
        const auto at = [&](std::size_t i) {
            return &covered.points[points[std::min(first + i, points.size() - 1)]].x;
        };
        PointGroup group;
        Float4 unused;
        LoadTransposed(at(0), at(1), at(2), at(3), group.position.x, group.position.y, group.position.z,
                       unused);
        group.distance2 = Splat(std::numeric_limits<float>::max());
        group.owner = Splat(std::int32_t{0});
        groups.push_back(group);
        return groups.back();
    }
};

} // namespace vcg_ext
