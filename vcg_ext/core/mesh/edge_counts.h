// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vcg_ext
{

/// Edges by the number of faces on them.
struct EdgeCounts {
    std::size_t boundary = 0;    ///< one face
    std::size_t nonManifold = 0; ///< three or more
};

/// \param triangle triangle(f) is something with three vertex indices
template <class TriangleOf>
EdgeCounts CountEdges(std::size_t faces, const TriangleOf& triangle)
{
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * faces);
    for (std::size_t f = 0; f < faces; ++f) {
        const auto corner = triangle(f);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = corner[k], b = corner[(k + 1) % 3];
            edges.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    EdgeCounts counts;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        counts.boundary += end - i == 1;
        counts.nonManifold += end - i > 2;
        i = end;
    }
    return counts;
}

} // namespace vcg_ext
