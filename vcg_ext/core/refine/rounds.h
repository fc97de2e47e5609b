// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

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

/// A place of the original near a face: below its centroid, or where a sample of it comes from.
inline SurfacePlace PlaceNear(const RefinementState& state, std::uint32_t face)
{
    if (state.centroidHints[face] != kNone) return state.centroidHints[face];
    const std::uint32_t sample = state.samples.faces[face].first;
    return sample == kNone ? kNone : state.samples.samples[sample].origin;
}

/// What exchanges have renewed, and where it is now.
inline RenewedPlaces PlacesOfRenewed(const RefinementState& state)
{
    const SurfaceArrays& surface = state.simplified;
    RenewedPlaces places;
    for (std::uint32_t f = 0; f < surface.FaceCount(); ++f)
        if (state.renewed.faces[f]) places.faces.push_back({f, PlaceNear(state, f)});
    for (std::uint32_t v = 0; v < surface.VertexCount(); ++v) {
        if (!state.renewed.vertices[v]) continue;
        SurfacePlace place = state.vertexHints[v];
        if (place == kNone) place = PlaceNear(state, FaceOf(*BeginCorners(surface, v)));
        places.vertices.push_back({v, place});
    }
    return places;
}

/// Rounds of exchanges, flips and moves; from the second one on flips and moves only near what has changed.
/// They end where a round gains little. \param reached called with the part of the way that is done, the one
/// that the next loops lead to, and how many they are; may throw
template <class Reached>
void RefineInRounds(RefinementState& state, int threads, RefinementReport& report, const Reached& reached)
{
    const SurfaceArrays& surface = state.simplified;
    state.changed = NoMarks(surface.VertexCount());
    state.renewed = {NoMarks(surface.VertexCount()), NoMarks(surface.FaceCount())};
    state.backward2.Allocate(surface.VertexCount());
    std::fill(state.backward2.begin(), state.backward2.end(), 0.0F);
    ActiveVertices active(surface.VertexCount()), hasNewFaces(surface.VertexCount());
    ExchangeRounds exchanges(state, threads);
    float valenceWeight = kValenceWeight;
    double meanSquare = static_cast<double>(state.meanSquare);
    for (int round = 0; round < kRounds; ++round) {
        // Without exchanges a round takes half of the time.
        constexpr double kAll = (kExchangeRounds + kRounds) / 2.0;
        const auto at = [&](double part) {
            const bool exchanged = round < kExchangeRounds;
            return (exchanged ? round + part : (round + kExchangeRounds + part) / 2) / kAll;
        };
        constexpr double kExchangesEnd = 0.7, kFlipsEnd = 0.75;
        reached(at(0), at(kExchangesEnd), 7);
        const auto update = [&] {
            if (round > 0) active.Update(surface, state.changed, kMovedLately | kNewFaces, threads);
        };
        if (round < kExchangeRounds) report.exchanges += exchanges.Run(hasNewFaces);
        update();
        state.valenceWeight = round < kRounds - kRoundsWithoutValence ? valenceWeight : 0;
        reached(at(kExchangesEnd), at(kFlipsEnd), 1);
        report.flips += FlipEdges(state, threads, active);
        update();
        hasNewFaces.Update(surface, state.changed, kNewFaces, threads);
        for (int sweep = 0; sweep < 2; ++sweep) {
            const double begins = kFlipsEnd + (1 - kFlipsEnd) / 2 * sweep;
            reached(at(begins), at(begins + (1 - kFlipsEnd) / 2), 1);
            std::fill(state.changed.begin(), state.changed.end(), std::uint8_t{0});
            report.moves += MoveVertices(state, threads, active);
            ++report.sweeps;
            if (sweep > 0)
                active.Update(surface, state.changed, kMovedLately, threads);
            else
                update();
        }
        const double before = std::exchange(meanSquare, MeanSquare(state.samples));
        if (!(meanSquare < before * (1 - kMinRoundGain))) break;
        state.gainFactor *= kGainDecay;
        valenceWeight *= kGainDecay;
    }
}

} // namespace vcg_ext
