// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/space/index/kdtree/kdtree.h>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// For every vertex of \p original the nearest one of \p simplified that is on a face; kNone where there is
/// none. Stands in for the map of a collapse that nobody kept.
inline Buffer<std::uint32_t> NearestVertices(const SurfaceArrays& original, const SurfaceArrays& simplified,
                                             int threads = 1)
{
    const auto pointOf = [](const SurfacePoint& p) { return vcg::Point3f(p.x, p.y, p.z); };
    std::vector<vcg::Point3f> points;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < simplified.VertexCount(); ++v) {
        if (simplified.cornerCount[v] == 0) continue;
        points.push_back(pointOf(simplified.points[v]));
        vertices.push_back(v);
    }
    Buffer<std::uint32_t> nearest(original.VertexCount());
    std::fill(nearest.begin(), nearest.end(), kNone);
    if (points.empty()) return nearest;
    vcg::KdTree<float> tree(vcg::VectorConstDataWrapper<std::vector<vcg::Point3f>>{points});
    ParallelRanges(threads, nearest.size(), 4096, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v) {
            unsigned int found = 0;
            float distance2 = 0;
            tree.doQueryClosest(pointOf(original.points[v]), found, distance2);
            nearest[v] = vertices[found];
        }
    });
    return nearest;
}

} // namespace vcg_ext
