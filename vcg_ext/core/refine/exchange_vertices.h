// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/symmetric_matrix.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/exchange.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/per_thread.h"

// One round of exchanges. Edges are measured in parallel, chosen one after the other such that no two share a
// vertex that changes, and then exchanged in parallel: the outcome does not depend on the number of threads.

namespace vcg_ext
{

/// An edge and what it promises, without measuring samples.
struct EdgeGuess {
    float value;
    std::uint32_t a, b;
};

/// The quadric of the planes around every vertex, by area, without what the collapses have accumulated.
class PlaneQuadrics
{
    const SurfaceArrays& surface_;
    Buffer<SymmetricMatrix3<float>> quadrics_;

  public:
    PlaneQuadrics(const SurfaceArrays& surface, int threads)
        : surface_(surface), quadrics_(surface.VertexCount())
    {
        ParallelRanges(threads, surface.VertexCount(), 4096, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) quadrics_[v] = Around(static_cast<std::uint32_t>(v));
        });
    }

    /// What is left of both ends' quadrics where their sum is least.
    float CostOf(std::uint32_t a, std::uint32_t b) const
    {
        const SymmetricMatrix3<float>&qa = quadrics_[a], &qb = quadrics_[b], sum = qa + qb;
        const float added = kPlaneRegularization / 3 * sum.Trace();
        if (!(added > 0)) return 0;
        const Vector3<float> toB = PositionOf(surface_, b) - PositionOf(surface_, a);
        const Vector3<float> x = SolveRegularized(sum, qb * toB, added);
        return std::max(0.0F, QuadraticForm(qa, x) + QuadraticForm(qb, x - toB));
    }

  private:
    SymmetricMatrix3<float> Around(std::uint32_t v) const
    {
        SymmetricMatrix3<float> sum{};
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c) {
            const Vector3<float> n = AreaVector(surface_, FaceOf(*c));
            if (const float length = Norm(n); length > 0) sum = sum + 1 / length * OuterProduct(n);
        }
        return sum;
    }
};

/// The edges with two faces that promise most, as collapses and as places for a vertex.
class EdgeGuesses
{
    struct Lists {
        std::vector<EdgeGuess> collapses, divisions;
        std::size_t edges = 0;
    };

  public:
    std::vector<EdgeGuess> collapses; ///< what they cost
    std::vector<EdgeGuess> divisions; ///< minus the energy of the faces beside the edge

    EdgeGuesses(const RefinementState& state, int threads)
    {
        constexpr std::size_t kGrain = 2048;
        const PlaneQuadrics quadrics(state.simplified, threads);
        const std::size_t vertices = state.simplified.VertexCount();
        std::vector<Lists> parts((vertices + kGrain - 1) / kGrain);
        ParallelRanges(threads, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v)
                AddEdgesAt(state, quadrics, static_cast<std::uint32_t>(v), parts[begin / kGrain]);
        });
        std::size_t edges = 0;
        for (const Lists& part : parts) {
            edges += part.edges;
            collapses.insert(collapses.end(), part.collapses.begin(), part.collapses.end());
            divisions.insert(divisions.end(), part.divisions.begin(), part.divisions.end());
        }
        const auto count = static_cast<std::size_t>(kMeasuredEdges * static_cast<double>(edges)) + 1;
        KeepLeast(collapses, count);
        KeepLeast(divisions, count);
    }

  private:
    static void AddEdgesAt(const RefinementState& state, const PlaneQuadrics& quadrics, std::uint32_t v,
                           Lists& lists)
    {
        const SurfaceArrays& s = state.simplified;
        if (s.cornerCount[v] > kMaxSearchedStar) return;
        constexpr std::uint8_t kStays = kBorderVertex | kFixedVertex;
        const Corner *begin = BeginCorners(s, v), *end = EndCorners(s, v);
        for (const Corner* c = begin; c != end; ++c) {
            const std::uint32_t w = NextVertex(s, *c);
            if (w < v) continue; // the other face beside the edge leads to it
            ++lists.edges;
            const Corner* across = std::find_if(begin, end, [&](Corner k) { return PreviousVertex(s, k) == w; });
            if (across == end) continue;
            lists.divisions.push_back({-state.samples.faces[FaceOf(*c)].energy -
                                           state.samples.faces[FaceOf(*across)].energy,
                                       v, w});
            if (!((s.flags[v] | s.flags[w]) & kStays))
                lists.collapses.push_back({quadrics.CostOf(v, w), v, w});
        }
    }
    static void KeepLeast(std::vector<EdgeGuess>& guesses, std::size_t count)
    {
        if (guesses.size() <= count) return;
        std::nth_element(guesses.begin(), guesses.begin() + static_cast<std::ptrdiff_t>(count), guesses.end(),
                         [](const EdgeGuess& l, const EdgeGuess& r) {
                             if (l.value != r.value) return l.value < r.value;
                             return l.a != r.a ? l.a < r.a : l.b < r.b;
                         });
        guesses.resize(count);
    }
};

/// What measure(exchanger, guess) offers for each of \p guesses, as far as it offers anything.
template <class Measure>
std::vector<ExchangeOffer> MeasureOffers(const std::vector<EdgeGuess>& guesses,
                                         PerThread<VertexExchanger>& exchangers, int threads,
                                         const Measure& measure)
{
    constexpr std::size_t kGrain = 32;
    std::vector<std::optional<ExchangeOffer>> measured(guesses.size());
    ParallelRanges(threads, guesses.size(), kGrain, [&](std::size_t begin, std::size_t end, int thread) {
        for (std::size_t i = begin; i < end; ++i) measured[i] = measure(exchangers[thread].tool, guesses[i]);
    });
    std::vector<ExchangeOffer> offers;
    for (const auto& offer : measured)
        if (offer) offers.push_back(*offer);
    return offers;
}

/// Collapses, the cheapest first, each with the best new vertex that is left, as long as that is worth it. No
/// two of them share a vertex, so that none changes what another one has measured.
struct ChosenExchanges {
    std::vector<ExchangeOffer> collapses, divisions;
};

class ExchangeChoice
{
    const SurfaceArrays& surface_;
    std::vector<std::uint8_t> isTaken_;

    /// Calls visit for the vertices that the exchange changes, or whose faces it changes.
    template <class Visit>
    void ForEachRingVertex(std::uint32_t v, const Visit& visit) const
    {
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c) {
            visit(NextVertex(surface_, *c));
            visit(PreviousVertex(surface_, *c));
        }
    }
    template <class Visit>
    void ForEachVertexOfCollapse(const ExchangeOffer& offer, const Visit& visit) const
    {
        ForEachRingVertex(offer.a, visit);
        ForEachRingVertex(offer.b, visit);
    }
    template <class Visit>
    void ForEachVertexOfDivision(const ExchangeOffer& offer, const Visit& visit) const
    {
        for (const Corner* c = BeginCorners(surface_, offer.a); c != EndCorners(surface_, offer.a); ++c)
            if (HasVertex(surface_.triangles[FaceOf(*c)], offer.b))
                for (const std::uint32_t v : surface_.triangles[FaceOf(*c)].v) visit(v);
    }
    template <class ForEach>
    bool Take(const ForEach& forEach)
    {
        bool isFree = true;
        forEach([&](std::uint32_t v) { isFree &= isTaken_[v] == 0; });
        if (isFree) forEach([&](std::uint32_t v) { isTaken_[v] = 1; });
        return isFree;
    }

  public:
    explicit ExchangeChoice(const SurfaceArrays& surface)
        : surface_(surface), isTaken_(surface.VertexCount(), 0)
    {
    }

    /// \param losses ascending \param gains descending
    ChosenExchanges Choose(const std::vector<ExchangeOffer>& losses, const std::vector<ExchangeOffer>& gains)
    {
        const std::size_t most =
            static_cast<std::size_t>(kMaxExchanges * static_cast<double>(surface_.VertexCount())) + 1;
        ChosenExchanges chosen;
        auto gain = gains.begin();
        for (const ExchangeOffer& loss : losses) {
            if (chosen.collapses.size() == most) break;
            if (gain == gains.end() || gain->energy < kMinExchangeRatio * loss.energy) break;
            if (!Take([&](const auto& visit) { ForEachVertexOfCollapse(loss, visit); })) continue;
            chosen.collapses.push_back(loss);
            while (gain != gains.end() &&
                   !Take([&](const auto& visit) { ForEachVertexOfDivision(*gain, visit); }))
                ++gain;
            if (gain != gains.end()) chosen.divisions.push_back(*gain++);
        }
        return chosen;
    }
};

/// Drops what may not be. \param may may(exchanger, offer)
template <class May>
void DropForbidden(std::vector<ExchangeOffer>& offers, PerThread<VertexExchanger>& exchangers, int threads,
                   const May& may)
{
    std::vector<std::uint8_t> keeps(offers.size());
    ParallelFor(threads, offers.size(), [&](std::size_t i, int thread) {
        keeps[i] = may(exchangers[thread].tool, offers[i]) ? 1 : 0;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (keeps[i]) offers[kept++] = offers[i];
    offers.resize(kept);
}

/// One round: cheap collapses pay for new vertices that gain more. Returns how many there were.
/// \pre state.changed and state.renewed have their sizes
inline std::size_t ExchangeVertices(RefinementState& state, int threads)
{
    PerThread<VertexExchanger> exchangers(state, threads);
    ChosenExchanges chosen;
    {
        const EdgeGuesses guesses(state, threads);
        using Tool = VertexExchanger;
        std::vector<ExchangeOffer> losses =
            MeasureOffers(guesses.collapses, exchangers, threads,
                          [](Tool& tool, const EdgeGuess& e) { return tool.OfferCollapse(e.a, e.b); });
        std::vector<ExchangeOffer> gains =
            MeasureOffers(guesses.divisions, exchangers, threads,
                          [](Tool& tool, const EdgeGuess& e) { return tool.OfferVertex(e.a, e.b); });
        std::sort(losses.begin(), losses.end(), [](const ExchangeOffer& l, const ExchangeOffer& r) {
            return l.energy != r.energy ? l.energy < r.energy : l.Precedes(r);
        });
        std::sort(gains.begin(), gains.end(), [](const ExchangeOffer& l, const ExchangeOffer& r) {
            return l.energy != r.energy ? l.energy > r.energy : l.Precedes(r);
        });
        chosen = ExchangeChoice(state.simplified).Choose(losses, gains);
        DropForbidden(chosen.collapses, exchangers, threads,
                      [](Tool& tool, const ExchangeOffer& offer) { return tool.MayCollapse(offer); });
        DropForbidden(chosen.divisions, exchangers, threads,
                      [](Tool& tool, const ExchangeOffer& offer) { return tool.MayDivide(offer); });
    }
    std::size_t pairs = std::min(chosen.collapses.size(), chosen.divisions.size());
    const auto isWorthIt = [&](std::size_t i) {
        return chosen.divisions[i].energy >= kMinExchangeRatio * chosen.collapses[i].energy;
    };
    while (pairs > 0 && !isWorthIt(pairs - 1)) --pairs;
    ParallelFor(threads, pairs, [&](std::size_t i, int thread) {
        VertexExchanger& exchanger = exchangers[thread].tool;
        exchanger.Divide(chosen.divisions[i], exchanger.Collapse(chosen.collapses[i]));
    });
    return pairs;
}

} // namespace vcg_ext
