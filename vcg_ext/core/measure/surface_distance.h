// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// Distances of points to the surface of a mesh, each to its exact closest point, in the unit of the
/// coordinates.
class SurfaceDistance
{
    static constexpr std::size_t kGrain = 1024; ///< points that one thread measures at a time
    static constexpr std::size_t kGrains = 8;   ///< and so often between two polls

    const MeshView& view_;
    int threads_;
    FaceTree tree_;

    /// The largest coordinate in the frame, which bounds what single precision does to the search.
    double LargestCoordinate(const std::vector<std::array<double, 3>>& points) const
    {
        double largest = 0;
        const auto add = [&](const std::array<double, 3>& p) {
            const Vector3<double> q = tree_.frame().Into<double>(p);
            largest = std::max({largest, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
        };
        for (std::size_t k = 0; k < 3 * view_.faceCount; ++k) add(view_.Position(view_.triangles[k]));
        for (const auto& point : points) add(point);
        return largest;
    }

  public:
    /// \param threads 0: all \pre the view outlives this object; a face; finite positions
    SurfaceDistance(const MeshView& view, int threads)
        : view_(view), threads_(ResolveThreads(threads)), tree_(view, FrameOf(view), threads_)
    {
    }

    /// One distance for each point: 0, to the bit, at a vertex of a face. The same for any number of threads.
    /// \param progress may be empty \throws Cancelled \pre finite points
    std::vector<double> Of(const std::vector<std::array<double, 3>>& points,
                           const Progress& progress = {}) const
    {
        const ExactSurface surface(view_, tree_, RoundingOf(LargestCoordinate(points)));
        const Frame& frame = tree_.frame();
        const StageProgress report(progress);
        std::vector<double> distances(points.size());
        const std::size_t step = kGrain * kGrains * static_cast<std::size_t>(threads_);
        for (std::size_t first = 0; first < points.size(); first += step) {
            report(static_cast<int>(100 * first / points.size()), "Distances to the original");
            const std::size_t count = std::min(step, points.size() - first);
            ParallelRanges(threads_, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
                ExactSurface::Search search;
                for (std::size_t i = first + begin; i < first + end; ++i)
                    distances[i] =
                        frame.unit * std::sqrt(surface.Distance2(frame.Into<double>(points[i]), search));
            });
        }
        return distances;
    }
};

} // namespace vcg_ext
