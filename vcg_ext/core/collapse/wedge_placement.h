// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "vcg_ext/core/collapse/placement.h"
#include "vcg_ext/core/collapse/ring_trial.h"
#include "vcg_ext/core/collapse/wedge_trial.h"

namespace vcg_ext
{

/// Places the new vertex of an edge of a mesh with attributes, whose error adds to the cost:
///
///     no end on a seam         the minimum of the cost, where that is nothing an end
///     both, and the edge too   an end; or the minimum, if its foot is on the edge and neither is a corner
///     any other                an end
class WedgePlacer
{
    struct Candidate {
        Vector3<float> position{};
        float cost = 0; ///< without the penalty for slivers
        WedgePlace place = WedgePlace::AtSurvivor;
        float along = 0;
    };

    const SweepState& state_;
    StarScratch& star_;
    WedgeScratch& scratch_;
    WedgeTrial& trial_;
    EdgeEnd<float> a_, b_;
    Vector3<float> half_;
    float threshold_;
    bool onSeamA_, onSeamB_, corner_;
    std::array<Candidate, 3> candidates_{};
    std::size_t count_ = 0;
    std::size_t asked_ = 0; ///< how often the trial was, for these candidates

  public:
    /// \param threshold what costs more need not be known exactly \pre \p trial has gathered the wedges
    WedgePlacer(const SweepState& state, Workspace& workspace, WedgeTrial& trial, std::uint32_t removed,
                std::uint32_t survivor, float threshold)
        : state_(state), star_(workspace.star), scratch_(workspace.wedges), trial_(trial),
          a_(state.vertices[removed].End()), b_(state.vertices[survivor].End()),
          half_(HalfEdgeVector(a_, b_)), threshold_(threshold), onSeamA_(state.Has(removed, kSeamVertex)),
          onSeamB_(state.Has(survivor, kSeamVertex)),
          corner_(state.Has(removed, kSeamCorner) || state.Has(survivor, kSeamCorner))
    {
    }

    /// \param cost of the edge by its first estimate \param fixed the survivor does not move
    /// \param everywhere both ends and the midpoint are tried, too \return as PlaceEdge. Where the cost is
    /// within the threshold, the ring and the trial were asked about that place last
    std::optional<PlacedEdge<float>> Place(float cost, bool fixed, bool everywhere)
    {
        if (fixed) {
            OfferEnd(WedgePlace::AtSurvivor);
            return Cheapest(threshold_);
        }
        if (!IsFree()) {
            OfferEnds();
            if (IsAlongInnerSeam()) OfferBetween();
            return Cheapest(threshold_);
        }
        if (const auto atAnEnd = PlaceAtFlatEnd(cost)) return atAnEnd;
        OfferFree();
        std::optional<PlacedEdge<float>> placed = Cheapest(threshold_);
        if (placed || !everywhere) return placed;
        OfferEnds();
        Offer({0, 0, 0}, half_ + a_.position, WedgePlace::Anywhere);
        return Cheapest(threshold_);
    }

    /// May the vertex leave both ends and take the best values?
    bool IsFree() const { return !onSeamA_ && !onSeamB_ && trial_.MayLeaveBothEnds(); }

  private:
    bool IsAlongInnerSeam() const
    {
        return onSeamA_ && onSeamB_ && !corner_ && trial_.IsAlongSeam() && trial_.MayLeaveBothEnds();
    }

    void Offer(const Vector3<float>& offset, const Vector3<float>& position, WedgePlace place,
               float along = 0)
    {
        float cost = EdgeCost(a_, b_, half_, offset, state_.distanceArea);
        if (cost <= threshold_) {
            ++asked_;
            const std::optional<float> error = trial_.ErrorAt(position, place, along);
            if (!error) {
                scratch_.refusedBySeams = true;
                return;
            }
            cost += *error;
        }
        candidates_[count_++] = {position, cost, place, along};
    }
    void OfferEnd(WedgePlace end)
    {
        if (!trial_.MayStayAt(end)) return;
        if (end == WedgePlace::AtRemoved)
            Offer(-1.0f * half_, a_.position, end);
        else
            Offer(half_, b_.position, end);
    }
    void OfferEnds()
    {
        OfferEnd(WedgePlace::AtRemoved);
        OfferEnd(WedgePlace::AtSurvivor);
    }

    void OfferBetween()
    {
        const Vector3<float> offset = VolumeAwareOffset(a_, b_, half_, AreasOf(state_, star_));
        const float quarter2 = Dot(half_, half_);
        const float along = quarter2 > 0 ? 0.5f + 0.5f * Dot(offset, half_) / quarter2 : 0;
        if (along > 0 && along < 1) Offer(offset, offset + half_ + a_.position, WedgePlace::Between, along);
    }

    void OfferFree()
    {
        PlacementEquations<float> equations = VolumeAwareEquations(a_, b_, half_, AreasOf(state_, star_));
        SymmetricMatrix3<float> matrix;
        Vector3<float> linear;
        trial_.ForPlacement(half_, matrix, linear);
        equations.matrix = equations.matrix + matrix;
        equations.right = equations.right - linear;
        const Vector3<float> offset = SolvePlacement(equations);
        Offer(offset, offset + half_ + a_.position, WedgePlace::Anywhere);
    }

    /// As PlaceAtAnEnd: where the surface and all attributes are flat, a vertex stays where it is.
    std::optional<PlacedEdge<float>> PlaceAtFlatEnd(float cost)
    {
        const float rounding = RoundingCost(a_, b_, state_.distanceArea);
        if (cost > rounding) return std::nullopt;
        OfferEnds();
        const auto placed = Cheapest(rounding);
        return placed && placed->cost <= std::min(rounding, threshold_) ? placed : std::nullopt;
    }

    /// The candidate that costs least with the ring around it; nothing where all are refused.
    std::optional<PlacedEdge<float>> Cheapest(float affordable)
    {
        std::sort(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(count_),
                  [](const Candidate& p, const Candidate& q) { return p.cost < q.cost; });
        const Candidate *best = nullptr, *evaluated = nullptr;
        float lowest = kRefusedKey, beyond = kRefusedKey;
        for (std::size_t i = 0; i < count_; ++i) {
            const Candidate& candidate = candidates_[i];
            if (candidate.cost >= lowest) break;
            if (candidate.cost > affordable) {
                beyond = candidate.cost;
                break;
            }
            const std::optional<float> penalty = EvaluateRing(state_, candidate.position, star_);
            evaluated = &candidate;
            if (!penalty || candidate.cost * *penalty >= lowest) continue;
            lowest = candidate.cost * *penalty;
            best = &candidate;
        }
        const bool askAgain = asked_ > 1; // refused ones, too, have left their values
        count_ = asked_ = 0;
        if (!best && beyond == kRefusedKey) return std::nullopt;
        if (!best) return PlacedEdge<float>{{}, beyond};
        if (evaluated != best) EvaluateRing(state_, best->position, star_);
        if (askAgain) trial_.ErrorAt(best->position, best->place, best->along);
        return PlacedEdge<float>{best->position, std::min(lowest, beyond),
                                 best->place == WedgePlace::AtRemoved};
    }
};

} // namespace vcg_ext
