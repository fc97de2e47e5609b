// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/edge_guesses.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/exchange.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/per_thread.h"

// One round of exchanges. Edges are measured in parallel, chosen one after the other such that no two share a
// vertex that changes, and then exchanged in parallel: the outcome does not depend on the number of threads.

namespace vcg_ext
{

/// The offers that were measured, by edge, so that a later round need not measure them again where no face is
/// new. What has moved in the meantime makes an offer a guess; it is confirmed before it is carried out.
class MeasuredOffers
{
    std::vector<ExchangeOffer> byEdge_;

  public:
    /// Measures the offers of \p guesses, or remembers them. \param measure measure(exchanger, a, b)
    /// \return those that stand, the best first
    template <class IsNew, class Measure>
    std::vector<ExchangeOffer> Update(const std::vector<EdgeGuess>& guesses, const IsNew& isNew,
                                      PerThread<VertexExchanger>& exchangers, int threads,
                                      const Measure& measure)
    {
        constexpr std::size_t kGrain = 32;
        std::vector<ExchangeOffer> offers(guesses.size());
        ParallelRanges(threads, guesses.size(), kGrain, [&](std::size_t begin, std::size_t end, int thread) {
            for (std::size_t i = begin; i < end; ++i) {
                const EdgeGuess& guess = guesses[i];
                const ExchangeOffer* known =
                    isNew(guess.a) || isNew(guess.b) ? nullptr : Find(guess.a, guess.b);
                offers[i] = known ? *known : measure(exchangers[thread].tool, guess.a, guess.b);
            }
        });
        std::sort(offers.begin(), offers.end(),
                  [](const ExchangeOffer& l, const ExchangeOffer& r) { return l.HasEdgeBefore(r); });
        byEdge_ = offers;
        KeepStanding(offers);
        return offers;
    }

    /// Drops what may not be; the best first.
    static void KeepStanding(std::vector<ExchangeOffer>& offers)
    {
        offers.erase(std::remove_if(offers.begin(), offers.end(),
                                    [](const ExchangeOffer& offer) { return !offer.stands; }),
                     offers.end());
        std::sort(offers.begin(), offers.end(),
                  [](const ExchangeOffer& l, const ExchangeOffer& r) { return l.IsBetterThan(r); });
    }

  private:
    const ExchangeOffer* Find(std::uint32_t a, std::uint32_t b) const
    {
        const ExchangeOffer edge{0, a, b, {}};
        const auto at = std::lower_bound(
            byEdge_.begin(), byEdge_.end(), edge,
            [](const ExchangeOffer& l, const ExchangeOffer& r) { return l.HasEdgeBefore(r); });
        return at != byEdge_.end() && at->a == a && at->b == b ? &*at : nullptr;
    }
};

/// Does the new vertex gain enough for what the collapse costs?
inline bool IsWorthIt(const ExchangeOffer& collapse, const ExchangeOffer& division)
{
    return division.energy < 0 && -division.energy >= kMinExchangeRatio * collapse.energy;
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

    /// \pre the best ones are first
    ChosenExchanges Choose(const std::vector<ExchangeOffer>& collapses,
                           const std::vector<ExchangeOffer>& divisions)
    {
        const std::size_t most =
            static_cast<std::size_t>(kMaxExchanges * static_cast<double>(surface_.VertexCount())) + 1;
        ChosenExchanges chosen;
        auto division = divisions.begin();
        for (const ExchangeOffer& collapse : collapses) {
            if (chosen.collapses.size() == most) break;
            if (division == divisions.end() || !IsWorthIt(collapse, *division)) break;
            if (!Take([&](const auto& visit) { ForEachVertexOfCollapse(collapse, visit); })) continue;
            chosen.collapses.push_back(collapse);
            while (division != divisions.end() &&
                   !Take([&](const auto& visit) { ForEachVertexOfDivision(*division, visit); }))
                ++division;
            if (division != divisions.end()) chosen.divisions.push_back(*division++);
        }
        return chosen;
    }
};

/// Rounds of exchanges: cheap collapses pay for new vertices that gain more.
class ExchangeRounds
{
    RefinementState& state_;
    int threads_;
    PerThread<VertexExchanger> exchangers_;
    MeasuredOffers collapses_, divisions_;

  public:
    /// \pre state.changed and state.renewed have their sizes
    ExchangeRounds(RefinementState& state, int threads)
        : state_(state), threads_(threads), exchangers_(state, threads)
    {
    }

    /// Returns how many exchanges there were.
    /// \param isNew isNew(v): faces around it or its neighbours are new since the last call
    template <class IsNew>
    std::size_t Run(const IsNew& isNew)
    {
        ChosenExchanges chosen = Choose(isNew);
        Confirm(chosen.collapses, [](VertexExchanger& tool, const ExchangeOffer& offer) {
            return tool.ConfirmCollapse(offer);
        });
        Confirm(chosen.divisions, [](VertexExchanger& tool, const ExchangeOffer& offer) {
            return tool.ConfirmDivision(offer);
        });
        std::size_t count = 0;
        const std::size_t pairs = std::min(chosen.collapses.size(), chosen.divisions.size());
        while (count < pairs && IsWorthIt(chosen.collapses[count], chosen.divisions[count])) ++count;
        ParallelFor(threads_, count, [&](std::size_t i, int thread) {
            VertexExchanger& exchanger = exchangers_[thread].tool;
            exchanger.Divide(chosen.divisions[i], exchanger.Collapse(chosen.collapses[i]));
        });
        return count;
    }

  private:
    template <class IsNew>
    ChosenExchanges Choose(const IsNew& isNew)
    {
        const EdgeGuesses guesses(state_, threads_);
        const auto collapses = collapses_.Update(
            guesses.collapses, isNew, exchangers_, threads_,
            [](VertexExchanger& tool, std::uint32_t a, std::uint32_t b) { return tool.OfferCollapse(a, b); });
        const auto divisions = divisions_.Update(
            guesses.divisions, isNew, exchangers_, threads_,
            [](VertexExchanger& tool, std::uint32_t a, std::uint32_t b) { return tool.OfferDivision(a, b); });
        return ExchangeChoice(state_.simplified).Choose(collapses, divisions);
    }
    template <class Again>
    void Confirm(std::vector<ExchangeOffer>& offers, const Again& again)
    {
        ParallelFor(threads_, offers.size(), [&](std::size_t i, int thread) {
            offers[i] = again(exchangers_[thread].tool, offers[i]);
        });
        MeasuredOffers::KeepStanding(offers);
    }
};

} // namespace vcg_ext
