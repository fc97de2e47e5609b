// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>
#include <limits>
#include <optional>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// A point of a face.
struct ChartPoint {
    std::uint32_t face = kNone;
    float weights[3] = {0, 0, 0}; ///< barycentric
    float distance2 = std::numeric_limits<float>::max();
};

/// The faces of a mesh, for the closest point among those of one chart. Without the chart and the side it
/// would be found through thin walls and across seams.
class ChartSearch
{
    const MeshView& view_;
    const FaceTree& tree_;
    const std::vector<std::uint32_t>& charts_;
    Buffer<SurfacePoint> points_;
    Buffer<std::uint32_t> across_; ///< of every edge of every face the face beyond it; may be empty

    static constexpr float kOnEdge = 1e-4f; ///< a weight that may be 0 but for rounding
    static constexpr float kFar = std::numeric_limits<float>::max();

  public:
    /// \param tree of the view's faces \param charts of every face; all of them outlive this object
    ChartSearch(const MeshView& view, const FaceTree& tree, const std::vector<std::uint32_t>& charts,
                int threads)
        : view_(view), tree_(tree), charts_(charts), points_(view.vertexCount)
    {
        constexpr std::size_t kGrain = 1 << 14;
        ParallelRanges(threads, view.vertexCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                const Vector3<float> p = tree.frame().Into(view.Position(v));
                points_[v] = {p.x, p.y, p.z, 0};
            }
        });
    }

    /// Lets searches begin with a walk from their hint. \param surface of the same faces, with corner lists
    void LearnNeighbors(const SurfaceArrays& surface, int threads)
    {
        constexpr std::size_t kGrain = 4096;
        across_.Allocate(3 * surface.FaceCount());
        ParallelRanges(threads, surface.FaceCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f)
                for (int k = 0; k < 3; ++k) {
                    const Corner corner = MakeCorner(static_cast<std::uint32_t>(f), k);
                    const std::uint32_t v = surface.triangles[f].v[k], w = NextVertex(surface, corner);
                    std::uint32_t& beyond = across_[3 * f + static_cast<std::size_t>(k)];
                    beyond = kNone;
                    for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
                        if (FaceOf(*c) != f && HasVertex(surface.triangles[FaceOf(*c)], w))
                            beyond = FaceOf(*c);
                }
        });
    }

    Vector3<float> CornerAt(std::uint32_t face, std::size_t k) const
    {
        const SurfacePoint& p = points_[view_.triangles[3 * std::size_t{face} + k]];
        return {p.x, p.y, p.z};
    }
    /// Along the normal, as long as twice the area.
    Vector3<float> Normal(std::uint32_t face) const
    {
        const Vector3<float> a = CornerAt(face, 0);
        return Cross(CornerAt(face, 1) - a, CornerAt(face, 2) - a);
    }

    ChartPoint ClosestOf(std::uint32_t face, const Vector3<float>& point) const
    {
        const Vector3<float> a = CornerAt(face, 0);
        const ClosestPoint closest =
            ClosestOnTriangle(point - a, CornerAt(face, 1) - a, CornerAt(face, 2) - a);
        return {face, {closest.weights[0], closest.weights[1], closest.weights[2]}, closest.distance2};
    }

    /// The closest point of \p chart where it does not face away from \p normal; of all of the chart where it
    /// does everywhere nearby; no face where the chart has none. \param hint a face near it, or kNone
    ChartPoint Closest(const Vector3<float>& point, const Vector3<float>& normal, std::uint32_t chart,
                       std::uint32_t hint = kNone) const
    {
        const auto isOfChart = [&](std::uint32_t face) { return charts_[face] == chart; };
        const auto facesAlong = [&](std::uint32_t face) {
            return isOfChart(face) && !(Dot(Normal(face), normal) < 0);
        };
        const ChartPoint any = Search(point, isOfChart, hint);
        if (any.face == kNone || facesAlong(any.face)) return any;
        // The other side of a wall is not much farther than this one and a face; in all of the chart it would
        // take long to find that there is none.
        const float reach2 = 4 * any.distance2 + Norm(Normal(any.face));
        const auto along = tree_.ClosestWanted(point, reach2, facesAlong);
        return along.distance2 < kFar ? ClosestOf(along.face, point) : any;
    }

    /// The same whichever way the chart faces.
    ChartPoint ClosestInChart(const Vector3<float>& point, std::uint32_t chart) const
    {
        return Search(
            point, [&](std::uint32_t face) { return charts_[face] == chart; }, kNone);
    }

  private:
    template <class Wanted>
    ChartPoint Search(const Vector3<float>& point, const Wanted& wanted, std::uint32_t hint) const
    {
        constexpr float kRounding = 1.0001f;
        ChartPoint near;
        if (hint != kNone && wanted(hint)) near = WalkFrom(hint, point, wanted);
        if (near.face != kNone && !across_.empty() && IsBeside(near)) return near;
        const auto closest =
            tree_.ClosestWanted(point, near.face != kNone ? near.distance2 * kRounding : kFar, wanted);
        if (!(closest.distance2 < kFar) || closest.face == near.face) return near;
        return ClosestOf(closest.face, point);
    }

    /// Over the inside of the face or of an edge that the walk could not cross, and so close for the size of
    /// the face that no other part of the chart can be meant. At a vertex the walk may have missed its other
    /// faces.
    bool IsBeside(const ChartPoint& at) const
    {
        constexpr float kClose = 0.05f; // of twice the area; a fifth of an edge
        const int inside = (at.weights[0] > kOnEdge) + (at.weights[1] > kOnEdge) + (at.weights[2] > kOnEdge);
        return inside >= 2 && at.distance2 < kClose * Norm(Normal(at.face));
    }

    /// From face to face towards the point, as long as that comes closer.
    template <class Wanted>
    ChartPoint WalkFrom(std::uint32_t face, const Vector3<float>& point, const Wanted& wanted) const
    {
        ChartPoint best = ClosestOf(face, point);
        if (across_.empty()) return best;
        for (bool closer = true; closer;) {
            closer = false;
            const ChartPoint here = best;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t next = across_[3 * std::size_t{here.face} + k];
                if (here.weights[(k + 2) % 3] > kOnEdge || next == kNone || !wanted(next)) continue;
                const ChartPoint there = ClosestOf(next, point);
                if (!(there.distance2 < best.distance2)) continue;
                best = there;
                closer = true;
            }
        }
        return best;
    }
};

} // namespace vcg_ext
