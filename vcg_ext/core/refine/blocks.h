// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// Orders of work over the vertices that threads can share. They depend on the surface and the size of the
/// blocks only; so does every result, because two vertices treated at the same time share nothing that is
/// written.

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

/// Calls treat(v, thread) for all vertices \p wanted whose star lies in their block, block by block, and
/// returns the others in ascending order.
template <class Wanted, class Treat>
std::vector<std::uint32_t> TreatBlocks(const SurfaceArrays& surface, const std::vector<VertexRange>& blocks,
                                       int threads, const Wanted& wanted, const Treat& treat)
{
    std::vector<std::vector<std::uint32_t>> seams(blocks.size());
    ParallelFor(threads, blocks.size(), [&](std::size_t b, int thread) {
        for (std::uint32_t v = blocks[b].begin; v < blocks[b].end; ++v) {
            if (!wanted(v)) continue;
            if (HasStar(blocks[b], surface, v))
                treat(v, thread);
            else
                seams[b].push_back(v);
        }
    });
    std::vector<std::uint32_t> rest;
    for (const auto& seam : seams) rest.insert(rest.end(), seam.begin(), seam.end());
    return rest;
}

/// Classes of \p vertices, no two of a class on a common face: each takes the first class that is free.
inline std::vector<std::vector<std::uint32_t>> Colours(const SurfaceArrays& surface,
                                                       const std::vector<std::uint32_t>& vertices)
{
    Buffer<std::uint32_t> colour(surface.VertexCount());
    std::fill(colour.begin(), colour.end(), kNone);
    std::vector<std::vector<std::uint32_t>> classes;
    std::vector<std::uint32_t> takenBy; // the last vertex that found each colour around it
    for (const std::uint32_t v : vertices) {
        for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
            for (const std::uint32_t w : {NextVertex(surface, *c), PreviousVertex(surface, *c)})
                if (colour[w] != kNone) takenBy[colour[w]] = v;
        std::uint32_t free = 0;
        while (free < takenBy.size() && takenBy[free] == v) ++free;
        if (free == takenBy.size()) {
            takenBy.push_back(kNone);
            classes.emplace_back();
        }
        colour[v] = free;
        classes[free].push_back(v);
    }
    return classes;
}

/// treat may write to the faces around its vertex and to the vertex: blocks, then what lies between them by
/// colours.
template <class Wanted, class Treat>
void TreatStars(const SurfaceArrays& surface, std::uint32_t blockVertices, int threads, const Wanted& wanted,
                const Treat& treat)
{
    constexpr std::size_t kGrain = 64;
    const auto blocks = VertexBlocks(surface.VertexCount(), blockVertices, false);
    const auto rest = TreatBlocks(surface, blocks, threads, wanted, treat);
    for (const auto& sameColour : Colours(surface, rest))
        ParallelRanges(threads, sameColour.size(), kGrain,
                       [&](std::size_t begin, std::size_t end, int thread) {
                           for (std::size_t i = begin; i < end; ++i) treat(sameColour[i], thread);
                       });
}

/// treat may also change the connectivity around its vertex: blocks, blocks shifted by half, then one by one.
template <class Wanted, class Treat>
void TreatConnectivity(const SurfaceArrays& surface, std::uint32_t blockVertices, int threads,
                       const Wanted& wanted, const Treat& treat)
{
    std::vector<std::uint32_t> rest = TreatBlocks(
        surface, VertexBlocks(surface.VertexCount(), blockVertices, false), threads, wanted, treat);
    const auto isLeft = [&](std::uint32_t v) { return std::binary_search(rest.begin(), rest.end(), v); };
    const std::vector<std::uint32_t> last = TreatBlocks(
        surface, VertexBlocks(surface.VertexCount(), blockVertices, true), threads, isLeft, treat);
    for (const std::uint32_t v : last) treat(v, 0);
}

} // namespace vcg_ext
