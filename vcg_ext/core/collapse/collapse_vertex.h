// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "vcg_ext/core/collapse/apply.h"
#include "vcg_ext/core/collapse/bound_check.h"
#include "vcg_ext/core/collapse/crossing_check.h"
#include "vcg_ext/core/collapse/edge_costs.h"
#include "vcg_ext/core/collapse/legality.h"
#include "vcg_ext/core/collapse/placement.h"
#include "vcg_ext/core/collapse/ring_trial.h"
#include "vcg_ext/core/collapse/wedge_placement.h"
#include "vcg_ext/core/collapse/wedge_writer.h"

namespace vcg_ext
{

/// What a sweep allows.
struct SweepStep {
    float threshold = 0;     ///< collapses of at most this cost
    bool everything = false; ///< all keys are fresh: what is illegal now stays so until something collapses
    /// The ends and the midpoint are tried as placements too, and triangular holes may close.
    bool lastResort = false;

    /// Key of what should be looked at in the next sweep again.
    float RetryKey() const { return threshold * 1.0001f; }
};

enum class VisitResult {
    Collapsed,
    Refused,
    PutOff ///< the stars leave the range of vertices that may be touched
};

/// Looks at one vertex after another on behalf of one thread.
class VertexVisitor
{
    SweepState& state_;
    Workspace& workspace_;
    CollapseWriter writer_;
    std::size_t died_ = 0;

  public:
    /// A collapse that is looked at.
    struct Attempt {
        bool outside = false;
        float cost = kRefusedKey; ///< of the edge with everything that is known now
        Vector3<float> placement{};
        bool atRemoved = false; ///< the placement is where the vertex that was to go is: that one stays
    };

    VertexVisitor(SweepState& state, Workspace& workspace, std::uint32_t& poolEnd)
        : state_(state), workspace_(workspace), writer_(state, workspace, poolEnd)
    {
    }

    /// Faces that died in all visits.
    std::size_t Died() const { return died_; }

    /// Where the new vertex of an edge would go and what the edge then costs, into \p attempt.
    /// \pre both stars are gathered, attempt.cost is that of EvaluateEdges
    void Place(std::uint32_t removed, std::uint32_t survivor, const SweepStep& step, Attempt& attempt)
    {
        const EdgeEnd<float> a = state_.vertices[removed].End(), b = state_.vertices[survivor].End();
        const bool fixed = state_.Has(survivor, kFixedVertex);
        const auto placed = PlaceEdge(
            a, b, fixed, attempt.cost, state_.distanceArea, step.threshold,
            [&] { return AreasOf(state_, workspace_.star); },
            [&](const Vector3<float>& x) { return EvaluateRing(state_, x, workspace_.star); });
        if (placed) {
            attempt.placement = placed->position;
            attempt.cost = placed->cost;
            attempt.atRemoved = placed->atA;
            return;
        }
        attempt.cost = kRefusedKey;
        if (step.lastResort && !fixed) TryOtherPlacements(a, b, step, attempt);
    }

    /// Merges \p v with a neighbour if that costs at most the threshold; otherwise its key becomes the lowest
    /// cost found. Writes only to vertices of \p range and to faces of which all vertices are in it.
    VisitResult Visit(std::uint32_t v, const VertexRange& range, const SweepStep& step)
    {
        NeighbourScratch& neighbours = workspace_.neighbours;
        if (IsClosed(v, v) || !CollectNeighbours(state_, v, range, neighbours)) return VisitResult::PutOff;
        if (neighbours.size == 0) {
            state_.key[v] = kNoKey;
            return VisitResult::Refused;
        }
        EvaluateEdges(state_, v, neighbours);
        float lowest = kRefusedKey;
        for (;;) {
            const std::uint32_t best = CheapestNeighbour(step.threshold);
            if (best == neighbours.size) break;
            const std::uint32_t w = neighbours.vertex[best];
            const bool into = state_.Has(w, kFixedVertex);
            const std::uint32_t removed = into ? v : w, survivor = into ? w : v;
            Attempt attempt = Try(removed, survivor, best, range, step);
            if ((state_.bound || state_.crossings) && !attempt.outside && attempt.cost <= step.threshold)
                KeepLimits(removed, survivor, range, attempt);
            if (attempt.outside) return VisitResult::PutOff;
            if (attempt.cost <= step.threshold) {
                Accept(removed, survivor, attempt, range, step);
                return VisitResult::Collapsed;
            }
            lowest = std::min(lowest, attempt.cost);
            neighbours.cost[best] = kNoKey;
        }
        for (std::uint32_t i = 0; i < neighbours.size; ++i) lowest = std::min(lowest, neighbours.cost[i]);
        state_.key[v] = lowest;
        return VisitResult::Refused;
    }

  private:
    /// The cheapest neighbour within the threshold that has not merged in this sweep; size if there is none.
    std::uint32_t CheapestNeighbour(float threshold) const
    {
        const NeighbourScratch& neighbours = workspace_.neighbours;
        std::uint32_t best = neighbours.size;
        float cheapest = threshold;
        for (std::uint32_t i = 0; i < neighbours.size; ++i) {
            if (!(neighbours.cost[i] <= cheapest) || state_.Has(neighbours.vertex[i], kMergedVertex))
                continue;
            cheapest = neighbours.cost[i];
            best = i;
        }
        return best;
    }

    Attempt Try(std::uint32_t removed, std::uint32_t survivor, std::uint32_t neighbour,
                const VertexRange& range, const SweepStep& step)
    {
        const NeighbourScratch& neighbours = workspace_.neighbours;
        Attempt attempt;
        StarScratch& star = workspace_.star;
        attempt.outside = !GatherStars(state_, removed, survivor, range, star);
        if (attempt.outside) return attempt;
        attempt.cost = neighbours.cost[neighbour];
        if (!CollapseGuard(state_, star, removed, survivor, step.lastResort).Allows()) {
            attempt.cost = step.everything ? kRefusedKey : std::max(attempt.cost, step.RetryKey());
            return attempt;
        }
        if (state_.wedges)
            PlaceWithWedges(removed, survivor, range, step, attempt);
        else
            Place(removed, survivor, step, attempt);
        return attempt;
    }

    bool IsAlone(const VertexRange& range) const
    {
        return range.begin == 0 && range.end == state_.VertexCount();
    }

    /// Place for a mesh with attributes. \pre the collapse is legal
    void PlaceWithWedges(std::uint32_t removed, std::uint32_t survivor, const VertexRange& range,
                         const SweepStep& step, Attempt& attempt)
    {
        WedgeTrial trial(state_, workspace_, removed, survivor);
        const WedgeVerdict verdict = trial.Gather(IsAlone(range));
        attempt.outside = verdict == WedgeVerdict::Later;
        if (verdict == WedgeVerdict::Refused) {
            workspace_.wedges.refusedBySeams = true;
            attempt.cost = step.everything ? kRefusedKey : std::max(attempt.cost, step.RetryKey());
        }
        if (verdict != WedgeVerdict::Allowed) return;
        WedgePlacer placer(state_, workspace_, trial, removed, survivor, step.threshold);
        const auto placed = placer.Place(attempt.cost, state_.Has(survivor, kFixedVertex), step.lastResort);
        attempt.cost = placed ? placed->cost : kRefusedKey;
        if (!placed) return;
        attempt.placement = placed->position;
        attempt.atRemoved = placed->atA;
    }

    /// May the vertex be at one of TryEndsAndMiddle's places? Leaves the values that its wedges then have.
    bool WedgesAllow(std::uint32_t removed, std::uint32_t survivor, int place, const Vector3<float>& x)
    {
        if (!state_.wedges) return true;
        WedgeTrial trial(state_, workspace_, removed, survivor);
        constexpr WedgePlace kPlaces[] = {WedgePlace::AtRemoved, WedgePlace::AtSurvivor,
                                          WedgePlace::Anywhere};
        if (place < 2) return trial.MayStayAt(kPlaces[place]) && trial.ErrorAt(x, kPlaces[place]);
        return WedgePlacer(state_, workspace_, trial, removed, survivor, 0).IsFree() &&
               trial.ErrorAt(x, kPlaces[place]);
    }

    void TryOtherPlacements(const EdgeEnd<float>& a, const EdgeEnd<float>& b, const SweepStep& step,
                            Attempt& attempt)
    {
        const Vector3<float> half = HalfEdgeVector(a, b);
        for (const Vector3<float>& offset : OtherOffsets(half)) {
            const Vector3<float> placement = offset + half + a.position;
            const std::optional<float> penalty = EvaluateRing(state_, placement, workspace_.star);
            if (!penalty) continue;
            attempt.placement = placement;
            attempt.cost = EdgeCost(a, b, half, offset, state_.distanceArea) * *penalty;
            if (attempt.cost <= step.threshold) return;
        }
    }

    /// Is one of the vertices guarded against crossings, and to be merged later only?
    bool IsClosed(std::uint32_t v, std::uint32_t w) const
    {
        return state_.crossings && !state_.crossings->isOpen && state_.crossings->Guards(v, w);
    }

    /// Moves a collapse that would exceed the bound or make faces cross to another place, or refuses it.
    void KeepLimits(std::uint32_t removed, std::uint32_t survivor, const VertexRange& range, Attempt& attempt)
    {
        attempt.outside = IsClosed(removed, survivor);
        if (attempt.outside) return;
        std::optional<BoundCheck> bound;
        if (state_.bound) bound.emplace(state_, workspace_, removed, survivor, range);
        const bool isGuarded = state_.crossings && state_.crossings->Guards(removed, survivor);
        const CrossingCheck crossings(state_, workspace_.star, removed, survivor);
        const auto settled = [&] {
            if (isGuarded && crossings.MakesCrossings(attempt.placement)) return false;
            if (!bound) return true;
            const BoundVerdict verdict = bound->Check(attempt.placement);
            attempt.outside = verdict == BoundVerdict::Outside;
            if (verdict == BoundVerdict::Within) bound->Commit(attempt.atRemoved ? removed : survivor);
            return verdict != BoundVerdict::Beyond;
        };
        if (!bound || !bound->IsRefusedStill()) {
            if (settled() || TryEndsAndMiddle(removed, survivor, attempt, settled)) return;
            if (bound) bound->Refuse();
        }
        workspace_.bound.refused |= bound.has_value();
        attempt.cost = kRefusedKey;
    }

    /// \param settled called without arguments once attempt is at another place; whether that does it
    template <class Settled>
    bool TryEndsAndMiddle(std::uint32_t removed, std::uint32_t survivor, Attempt& attempt,
                          const Settled& settled)
    {
        if (state_.Has(survivor, kFixedVertex)) return false;
        const bool removedFirst = state_.descriptor[removed] > state_.descriptor[survivor];
        const Vector3<float> ends[2] = {state_.Position(removed), state_.Position(survivor)};
        for (const int place : {removedFirst ? 0 : 1, removedFirst ? 1 : 0, 2}) {
            attempt.atRemoved = place == 0;
            attempt.placement = place < 2 ? ends[place] : 0.5F * (ends[0] + ends[1]);
            if (WedgesAllow(removed, survivor, place, attempt.placement) &&
                EvaluateRing(state_, attempt.placement, workspace_.star) && settled())
                return true;
        }
        return false;
    }

    void Accept(std::uint32_t removed, std::uint32_t survivor, const Attempt& attempt,
                const VertexRange& range, const SweepStep& step)
    {
        const std::uint32_t goes = attempt.atRemoved ? survivor : removed;
        const std::uint32_t stays = attempt.atRemoved ? removed : survivor;
        if (!state_.wedges) return Merge(goes, stays, attempt.placement, step);
        WedgeWriter writer(state_, workspace_, removed, survivor);
        writer.Before(attempt.placement);
        Merge(goes, stays, attempt.placement, step);
        writer.After(IsAlone(range), stays);
    }

    void Merge(std::uint32_t removed, std::uint32_t survivor, const Vector3<float>& placement,
               const SweepStep& step)
    {
        died_ += writer_.Collapse(removed, survivor, placement);
        if (state_.crossings) CrossingCheck::Follow(state_, workspace_.star, removed, survivor);
        state_.flags[survivor] = static_cast<std::uint8_t>(state_.flags[survivor] | kMergedVertex);
        if (state_.cornerCount[survivor] > 0) state_.key[survivor] = step.RetryKey();
    }
};

} // namespace vcg_ext
