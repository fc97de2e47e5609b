// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// A triangle in the frame.
struct PlacedTriangle {
    Vector3<float> origin; ///< the first corner
    PreparedTriangle<float> shape;

    Vector3<float> ToSecond() const { return {shape.bx, shape.by, shape.bz}; }
    Vector3<float> ToThird() const { return {shape.cx, shape.cy, shape.cz}; }
};

inline PlacedTriangle Placed(const SurfaceArrays& surface, const SurfaceTriangle& triangle)
{
    const Vector3<float> a = PositionOf(surface, triangle.v[0]);
    return {a,
            PrepareTriangle(PositionOf(surface, triangle.v[1]) - a, PositionOf(surface, triangle.v[2]) - a)};
}

/// Points of one surface, each with the area that it stands for, and how far they are from a part of another
/// surface that changes, and from the rest, which does not.
class LocalSamples
{
    struct Group {
        Vector3<Float4> point;
        Float4 area;       ///< 0 in lanes behind the last point
        Float4 far2;       ///< squared distance to what never changes
        Float4 elsewhere2; ///< and to what stays as it is now
    };
    struct Sample {
        Vector3<float> point;
        float area;
    };
    std::vector<Sample> samples_;
    std::vector<Group> groups_;

    static Float4 Distance2(const Vector3<Float4>& points, const PlacedTriangle& triangle)
    {
        return ClosestOnTriangle(points - Splat(triangle.origin), triangle.shape).distance2;
    }

  public:
    void Clear() { samples_.clear(); }
    void Add(const Vector3<float>& point, float area) { samples_.push_back({point, area}); }

    /// Starts to measure, with at most \p most of the points, evenly chosen, for all.
    void Begin(std::size_t most)
    {
        constexpr float kNothingNear = 1e30F;
        const std::size_t stride =
            (samples_.size() + most - 1) / most | 1; // odd, so that it meets no pattern of four
        groups_.clear();
        int lane = kLanes;
        for (std::size_t i = 0; i < samples_.size(); i += stride, ++lane) {
            const auto& [point, area] = samples_[i];
            if (lane == kLanes) {
                groups_.push_back({Splat(point), Splat(0.0F), Splat(kNothingNear), Splat(kNothingNear)});
                lane = 0;
            }
            Group& group = groups_.back();
            SetLane(group.point, lane, point);
            group.area[lane] = area * static_cast<float>(stride);
        }
    }
    /// \p triangle never changes.
    void AddFar(const PlacedTriangle& triangle)
    {
        for (Group& group : groups_) group.far2 = Min(group.far2, Distance2(group.point, triangle));
    }
    void ForgetElsewhere()
    {
        for (Group& group : groups_) group.elsewhere2 = group.far2;
    }
    /// \p triangle stays until ForgetElsewhere.
    void AddElsewhere(const PlacedTriangle& triangle)
    {
        for (Group& group : groups_)
            group.elsewhere2 = Min(group.elsewhere2, Distance2(group.point, triangle));
    }
    /// Area times squared distance, summed, with \p triangles for what changes; any number above \p limit
    /// where it is above that.
    float Energy(const std::vector<PlacedTriangle>& triangles, float limit) const
    {
        float sum = 0;
        for (const Group& group : groups_) {
            Float4 best = group.elsewhere2;
            for (const PlacedTriangle& triangle : triangles)
                best = Min(best, Distance2(group.point, triangle));
            sum += SumLanes(group.area * best);
            if (sum > limit) break;
        }
        return sum;
    }
};

} // namespace vcg_ext
