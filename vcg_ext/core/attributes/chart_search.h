// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

    Vector3<float> Corner(std::uint32_t face, std::size_t k) const
    {
        const SurfacePoint& p = points_[view_.triangles[3 * std::size_t{face} + k]];
        return {p.x, p.y, p.z};
    }
    /// Along the normal, as long as twice the area.
    Vector3<float> Normal(std::uint32_t face) const
    {
        const Vector3<float> a = Corner(face, 0);
        return Cross(Corner(face, 1) - a, Corner(face, 2) - a);
    }

    ChartPoint ClosestOf(std::uint32_t face, const Vector3<float>& point) const
    {
        const Vector3<float> a = Corner(face, 0);
        const ClosestPoint closest = ClosestOnTriangle(point - a, Corner(face, 1) - a, Corner(face, 2) - a);
        return {face, {closest.weights[0], closest.weights[1], closest.weights[2]}, closest.distance2};
    }

    /// The closest point of \p chart where it does not face away from \p normal; of all of the chart where it
    /// does everywhere; no face where the chart has none. \param hint a face to begin with, or kNone
    ChartPoint Closest(const Vector3<float>& point, const Vector3<float>& normal, std::uint32_t chart,
                       std::uint32_t hint = kNone) const
    {
        const ChartPoint along = Search(point, &normal, chart, hint);
        return along.face != kNone ? along : Search(point, nullptr, chart, hint);
    }

  private:
    ChartPoint Search(const Vector3<float>& point, const Vector3<float>* normal, std::uint32_t chart,
                      std::uint32_t hint) const
    {
        ChartPoint best;
        const auto visit = [&](std::uint32_t face) {
            if (charts_[face] != chart || (normal && Dot(Normal(face), *normal) < 0)) return best.distance2;
            const ChartPoint here = ClosestOf(face, point);
            // Of equally close faces the first, whatever the order in which they are met.
            if (here.distance2 < best.distance2 || (here.distance2 == best.distance2 && face < best.face))
                best = here;
            return best.distance2;
        };
        if (hint != kNone) visit(hint);
        tree_.ForEachInReach(point, best.distance2, visit);
        return best;
    }
};

} // namespace vcg_ext
