// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Passes over the vertices of a surface that threads share. Which vertex is visited when depends on the
// surface and the size of the blocks only, and two vertices that are visited at the same time share nothing
// that is written; so no result depends on the number of threads.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// Do all faces around \p v lie in the range? Then nobody outside it changes what is read or written.
inline bool HasStar(const VertexRange& range, const SurfaceArrays& surface, std::uint32_t v)
{
    for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
        if (!range.Has(NextVertex(surface, *c)) || !range.Has(PreviousVertex(surface, *c))) return false;
    return true;
}

/// Consecutive blocks of about \p size vertices that cover all of them; \p shifted by half a block.
inline std::vector<VertexRange> VertexBlocks(std::size_t vertices, std::uint32_t size, bool shifted)
{
    std::vector<VertexRange> blocks;
    std::size_t end = shifted ? size / 2 : size;
    for (std::size_t begin = 0; begin < vertices; begin = end, end += size)
        blocks.push_back({static_cast<std::uint32_t>(begin),
                          static_cast<std::uint32_t>(std::min(vertices, std::max(end, begin + 1)))});
    return blocks;
}

/// Calls visit(v, thread) for all vertices \p wanted whose star lies in their block, block by block, and
/// returns the others in ascending order.
template <class Wanted, class Visit>
std::vector<std::uint32_t> VisitInBlocks(const SurfaceArrays& surface, const std::vector<VertexRange>& blocks,
                                         int threads, const Wanted& wanted, const Visit& visit)
{
    std::vector<std::vector<std::uint32_t>> seams(blocks.size());
    ParallelFor(threads, blocks.size(), [&](std::size_t b, int thread) {
        for (std::uint32_t v = blocks[b].begin; v < blocks[b].end; ++v) {
            if (!wanted(v)) continue;
            if (HasStar(blocks[b], surface, v))
                visit(v, thread);
            else
                seams[b].push_back(v);
        }
    });
    std::vector<std::uint32_t> rest;
    for (const auto& seam : seams) rest.insert(rest.end(), seam.begin(), seam.end());
    return rest;
}

/// Classes of \p vertices, no two of a class on a common face: each takes the first class that is free.
inline std::vector<std::vector<std::uint32_t>> ColorClasses(const SurfaceArrays& surface,
                                                            const std::vector<std::uint32_t>& vertices)
{
    Buffer<std::uint32_t> color(surface.VertexCount());
    std::fill(color.begin(), color.end(), kNone);
    std::vector<std::vector<std::uint32_t>> classes;
    std::vector<std::uint32_t> takenBy; // the last vertex that found each color around it
    for (const std::uint32_t v : vertices) {
        for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
            for (const std::uint32_t w : {NextVertex(surface, *c), PreviousVertex(surface, *c)})
                if (color[w] != kNone) takenBy[color[w]] = v;
        std::uint32_t free = 0;
        while (free < takenBy.size() && takenBy[free] == v) ++free;
        if (free == takenBy.size()) {
            takenBy.push_back(kNone);
            classes.emplace_back();
        }
        color[v] = free;
        classes[free].push_back(v);
    }
    return classes;
}

/// Calls visit(v, thread) for all vertices \p wanted. It may write to the vertex and to the faces around it,
/// but not change which faces those are: first in blocks, then what lies between them by colors.
template <class Wanted, class Visit>
void ForEachStar(const SurfaceArrays& surface, std::uint32_t blockVertices, int threads, const Wanted& wanted,
                 const Visit& visit)
{
    constexpr std::size_t kGrain = 64;
    const auto blocks = VertexBlocks(surface.VertexCount(), blockVertices, false);
    const auto rest = VisitInBlocks(surface, blocks, threads, wanted, visit);
    for (const auto& sameColor : ColorClasses(surface, rest))
        ParallelRanges(threads, sameColor.size(), kGrain,
                       [&](std::size_t begin, std::size_t end, int thread) {
                           for (std::size_t i = begin; i < end; ++i) visit(sameColor[i], thread);
                       });
}

/// Calls visit(v, thread) for all vertices \p wanted. It may also change the edges of the faces around the
/// vertex: first in blocks, then in blocks shifted by half, then one by one.
template <class Wanted, class Visit>
void ForEachStarWithEdges(const SurfaceArrays& surface, std::uint32_t blockVertices, int threads,
                          const Wanted& wanted, const Visit& visit)
{
    const auto blocks = VertexBlocks(surface.VertexCount(), blockVertices, false);
    const auto rest = VisitInBlocks(surface, blocks, threads, wanted, visit);
    const auto isLeft = [&](std::uint32_t v) { return std::binary_search(rest.begin(), rest.end(), v); };
    const auto shifted = VertexBlocks(surface.VertexCount(), blockVertices, true);
    for (const std::uint32_t v : VisitInBlocks(surface, shifted, threads, isLeft, visit)) visit(v, 0);
}

} // namespace vcg_ext
