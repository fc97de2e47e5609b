// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/exchange_vertices.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/passes.h"

namespace vcg_ext
{

inline Buffer<std::uint8_t> NoMarks(std::size_t size)
{
    Buffer<std::uint8_t> marks(size);
    std::fill(marks.begin(), marks.end(), std::uint8_t{0});
    return marks;
}

/// Rounds of exchanges, flips and moves; from the second one on flips and moves only near what has changed.
/// \param reached called with the number of rounds done; may throw
template <class Reached>
void RefineInRounds(RefinementState& state, int threads, RefinementReport& report, const Reached& reached)
{
    const std::size_t vertices = state.simplified.VertexCount();
    state.changed = NoMarks(vertices);
    state.renewed = {NoMarks(vertices), NoMarks(state.simplified.FaceCount())};
    ActiveVertices active(vertices);
    float valenceWeight = kValenceWeight;
    for (int round = 0; round < kRounds; ++round) {
        reached(round);
        state.valenceWeight = round < kRounds - kRoundsWithoutValence ? valenceWeight : 0;
        std::size_t changes = round < kExchangeRounds ? ExchangeVertices(state, threads) : 0;
        report.exchanges += changes;
        if (round > 0) active.Update(state, threads);
        const std::size_t flips = FlipEdges(state, threads, active);
        report.flips += flips;
        changes += flips;
        if (round > 0) active.Update(state, threads);
        for (int sweep = 0; sweep < 2; ++sweep) {
            std::fill(state.changed.begin(), state.changed.end(), std::uint8_t{0});
            const std::size_t moves = MoveVertices(state, threads, active);
            report.moves += moves;
            ++report.sweeps;
            changes += moves;
            if (round > 0 || sweep > 0) active.Update(state, threads);
        }
        if (changes == 0) break;
        state.gainFactor *= kGainDecay;
        valenceWeight *= kGainDecay;
    }
}

} // namespace vcg_ext
