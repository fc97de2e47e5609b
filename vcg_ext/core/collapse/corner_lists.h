// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/collapse/workspace.h"

namespace vcg_ext
{

/// Copies the corner lists to one pool in vertex order, so that reading them is coherent again, and forgets
/// who merged. Arenas have to be reset. \return where the pool's free room begins
inline std::uint32_t CompactCornerLists(SweepState& state, int threads)
{
    constexpr std::size_t kGrain = 8192;
    const std::size_t count = state.VertexCount();
    const std::size_t ranges = (count + kGrain - 1) / kGrain;
    std::vector<std::uint32_t> begin(ranges + 1, 0);
    ParallelRanges(threads, count, kGrain, [&](std::size_t first, std::size_t last, int) {
        std::uint32_t total = 0;
        for (std::size_t v = first; v < last; ++v) total += state.cornerCount[v];
        begin[first / kGrain + 1] = total;
    });
    for (std::size_t range = 0; range < ranges; ++range) begin[range + 1] += begin[range];
    const std::size_t wanted = CornerArena::PoolSize(begin[ranges], threads);
    if (state.spareCorners.size() < wanted) state.spareCorners.Allocate(wanted);
    ParallelRanges(threads, count, kGrain, [&](std::size_t first, std::size_t last, int) {
        std::uint32_t place = begin[first / kGrain];
        for (std::size_t v = first; v < last; ++v) {
            const Corner* list = state.CornersOf(static_cast<std::uint32_t>(v));
            std::copy(list, list + state.cornerCount[v], state.spareCorners.begin() + place);
            state.cornerOffset[v] = place;
            place += state.cornerCount[v];
            state.flags[v] = static_cast<std::uint8_t>(state.flags[v] & ~kMergedVertex);
        }
    });
    std::swap(state.corners, state.spareCorners);
    if (state.keepOriginal && state.originalCorners.empty())
        state.originalCorners = std::move(state.spareCorners);
    return begin[ranges];
}

} // namespace vcg_ext
