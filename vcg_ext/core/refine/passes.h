// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/vertex_blocks.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/flip.h"
#include "vcg_ext/core/refine/move.h"
#include "vcg_ext/core/refine/per_thread.h"

namespace vcg_ext
{

struct AllVertices {
    bool operator()(std::uint32_t) const { return true; }
};

/// One pass of flips over the edges of all vertices \p wanted. Returns how many there were.
template <class Wanted = AllVertices>
std::size_t FlipEdges(RefinementState& state, int threads, const Wanted& wanted = {})
{
    PerThread<EdgeFlipper> flippers(state, threads);
    const SurfaceArrays& surface = state.simplified;
    const auto hasFaces = [&](std::uint32_t v) { return surface.cornerCount[v] > 0 && wanted(v); };
    ForEachStarWithEdges(surface, state.blockVertices, threads, hasFaces, [&](std::uint32_t v, int thread) {
        auto& slot = flippers[thread];
        slot.count += slot.tool.FlipAround(v);
    });
    return flippers.Count();
}

/// One pass of moves over all vertices \p wanted that may move. Returns how many did.
template <class Wanted = AllVertices>
std::size_t MoveVertices(RefinementState& state, int threads, const Wanted& wanted = {})
{
    constexpr std::uint32_t kMinFaces = 3;
    PerThread<VertexMover> movers(state, threads);
    const SurfaceArrays& surface = state.simplified;
    const auto mayMove = [&](std::uint32_t v) {
        if ((surface.flags[v] & (kFixedVertex | kSeamCorner)) || !wanted(v)) return false;
        if (surface.flags[v] & kBorderVertex) return state.border.MayMove(v);
        return surface.cornerCount[v] >= kMinFaces;
    };
    ForEachStar(surface, state.blockVertices, threads, mayMove, [&](std::uint32_t v, int thread) {
        auto& slot = movers[thread];
        if (slot.tool.Move(v)) ++slot.count;
    });
    return movers.Count();
}

/// The vertices around which something has changed: where a pass may find something to do.
class ActiveVertices
{
    Buffer<std::uint8_t> isActive_;

  public:
    /// All.
    explicit ActiveVertices(std::size_t vertices) : isActive_(vertices)
    {
        std::fill(isActive_.begin(), isActive_.end(), std::uint8_t{1});
    }

    /// Those that have changed in such a way, and their neighbours.
    void Update(const SurfaceArrays& surface, const Buffer<std::uint8_t>& changed, int changes, int threads)
    {
        constexpr std::size_t kGrain = 4096;
        const auto hasChanged = [&](std::uint32_t v) { return (changed[v] & changes) != 0; };
        ParallelRanges(threads, isActive_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto v = static_cast<std::uint32_t>(i);
                const bool isNear =
                    std::any_of(BeginCorners(surface, v), EndCorners(surface, v), [&](Corner c) {
                        return hasChanged(NextVertex(surface, c)) || hasChanged(PreviousVertex(surface, c));
                    });
                isActive_[v] = hasChanged(v) || isNear;
            }
        });
    }
    bool operator()(std::uint32_t v) const { return isActive_[v] != 0; }
};

} // namespace vcg_ext
