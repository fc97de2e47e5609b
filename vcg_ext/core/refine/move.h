// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/border_star.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/star.h"
#include "vcg_ext/core/refine/surface_walk.h"
#include "vcg_ext/core/refine/wedge_move.h"

namespace vcg_ext
{

/// Moves one vertex to where the energy of its star is least, if that is allowed and worth it.
/// One object per thread; it holds nothing but scratch between two calls.
class VertexMover
{
    /// A face of the star after the step.
    struct Trial {
        PreparedTriangle<float> triangle;
        std::uint32_t acrossNext, acrossPrevious; ///< the faces of the star beside it, kNone at a border
        GroupRange samples;
    };
    struct Energy {
        double sum = 0;
        float forward2 = 0, backward2 = 0, border2 = 0; ///< largest squared distances
    };

    RefinementState& state_;
    PlaceSearch search_;
    Star star_;
    Scratch<Trial> trials_;
    SampleGroups groups_;
    BackwardPoints points_;
    BorderStar border_;
    Scratch<std::pair<std::uint32_t, std::uint32_t>> byNext_; // (next vertex, face of the star)

  public:
    explicit VertexMover(RefinementState& state) : state_(state), search_(state.original) {}

    /// True if \p v moved.
    bool Move(std::uint32_t v)
    {
        const SampleSummary summary = SummarizeStar(v);
        const float negligible = state_.gainFactor * kMinMoveGainOfMean * state_.meanSquare * summary.weight;
        if (summary.count < kMinSamples || !(summary.weight > 0) || summary.energy < negligible) return false;
        Gather(v);
        if (groups_.size() == 0 || (IsOnBorder(v) && border_.Empty())) return false;
        EquationSums sums;
        const Energy before = MeasureStar(v, sums);
        if (!state_.backward2.empty()) state_.backward2[v] = before.backward2;
        const NormalEquations equations = sums.Total();
        const std::optional<Vector3<float>> best = SolveStep(equations, Regularization(before.sum));
        if (!best) return false;
        Vector3<float> step = Clipped(*best);
        if (state_.simplified.wedges && !MaySlide(state_.simplified, star_, v, step))
            step = AlongNormal(star_, step);
        step = border_.KeepStraight(step, kStraightBorder * state_.meanSquare);
        const double gain = std::max(before.sum * static_cast<double>(state_.gainFactor * kMinMoveGain),
                                     static_cast<double>(negligible));
        if (static_cast<double>(Dot(equations.right, step)) < gain) return false;
        for (int trial = 0; trial < kStepTrials; ++trial, step = 0.5F * step) {
            if (!Try(step, before, before.sum - gain) || FoldsFace()) continue;
            Accept(v, step);
            return true;
        }
        return false;
    }

  private:
    static constexpr std::size_t kMinSamples = 3;
    static constexpr std::size_t kMaxQuadraticStar =
        32; ///< larger stars are sorted to find who is beside whom

    bool IsOnBorder(std::uint32_t v) const { return (state_.simplified.flags[v] & kBorderVertex) != 0; }
    SampleSummary SummarizeStar(std::uint32_t v) const
    {
        SampleSummary summary;
        const SurfaceArrays& surface = state_.simplified;
        for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
            summary.Add(state_.samples.faces[FaceOf(*c)]);
        if (IsOnBorder(v))
            for (const std::uint32_t edge : {v, state_.border.loops.previous[v]})
                summary.Add(state_.border.lists.faces[edge]);
        return summary;
    }
    void Gather(std::uint32_t v)
    {
        GatherStar(state_.simplified, v, star_);
        const Vector3<float> origin = PositionOf(state_.simplified, v);
        trials_.Resize(star_.size());
        groups_.Clear();
        for (std::size_t i = 0; i < star_.size(); ++i) {
            trials_[i].acrossNext = trials_[i].acrossPrevious = kNone;
            trials_[i].samples.begin = groups_.size();
            CollectSamples(state_.samples, star_[i].face, static_cast<std::uint32_t>(i), origin, groups_);
            trials_[i].samples.end = groups_.size();
        }
        border_.Clear();
        if (IsOnBorder(v)) border_.Gather(state_.simplified, state_.border, v);
        if (star_.size() <= kMaxQuadraticStar)
            LinkSmallStar();
        else
            LinkLargeStar();
    }
    void Link(std::size_t i, std::size_t j) // i ends where j begins
    {
        trials_[i].acrossPrevious = static_cast<std::uint32_t>(j);
        trials_[j].acrossNext = static_cast<std::uint32_t>(i);
    }
    void LinkSmallStar()
    {
        for (std::size_t i = 0; i < star_.size(); ++i)
            for (std::size_t j = 0; j < star_.size(); ++j)
                if (star_[i].previous == star_[j].next) Link(i, j);
    }
    void LinkLargeStar()
    {
        byNext_.Resize(star_.size());
        for (std::size_t i = 0; i < star_.size(); ++i)
            byNext_[i] = {star_[i].next, static_cast<std::uint32_t>(i)};
        std::sort(byNext_.begin(), byNext_.end());
        for (std::size_t i = 0; i < star_.size(); ++i) {
            const std::pair<std::uint32_t, std::uint32_t> first{star_[i].previous, 0U};
            const auto* found = std::lower_bound(byNext_.begin(), byNext_.end(), first);
            if (found != byNext_.end() && found->first == star_[i].previous) Link(i, found->second);
        }
    }

    /// Energy where the vertex is, and the equations of the step from there.
    Energy MeasureStar(std::uint32_t v, EquationSums& equations)
    {
        Energy energy;
        MeasureForward(energy, equations);
        const BorderStar::Energy border = border_.Measure(equations);
        energy.sum += border.sum;
        energy.border2 = border.largest2;
        CollectBackwardPoints(v);
        const float limit2 = kBackwardOutlier * std::max(energy.forward2, state_.meanSquare);
        const BackwardEnergy backward = MeasureBackward(search_, points_, Vector3<float>{}, limit2,
                                                        std::numeric_limits<double>::max(), &equations);
        energy.sum += backward.energy;
        energy.backward2 = backward.largest2;
        return energy;
    }
    void MeasureForward(Energy& energy, EquationSums& equations);
    void CollectBackwardPoints(std::uint32_t v);
    /// Of the edge from the vertex to the next one of face i; the faces on both sides share one.
    SurfacePlace& NextEdgeHint(std::size_t i)
    {
        std::uint32_t hint = EdgeHint(star_[i].corner);
        if (const std::uint32_t across = trials_[i].acrossNext; across != kNone) {
            const Corner other = star_[across].corner;
            hint = std::min(hint, EdgeHint(MakeCorner(FaceOf(other), (IndexOf(other) + 2) % 3)));
        }
        return state_.edgeHints[hint];
    }

    float Regularization(double energy) const
    {
        float spokes2 = 0;
        for (std::size_t i = 0; i < star_.size(); ++i) spokes2 += star_[i].triangle.bb;
        const float mean2 = std::max(spokes2 / static_cast<float>(star_.size()), kSmallestSquare);
        return kStepRegularization * static_cast<float>(energy) / mean2;
    }
    Vector3<float> Clipped(const Vector3<float>& step) const
    {
        float shortest2 = std::numeric_limits<float>::max();
        for (std::size_t i = 0; i < star_.size(); ++i) {
            shortest2 = std::min(shortest2, star_[i].triangle.bb);
            if (trials_[i].acrossPrevious == kNone) shortest2 = std::min(shortest2, star_[i].triangle.cc);
        }
        const float largest = kMaxStep * std::sqrt(shortest2), length = Norm(step);
        return length > largest ? (largest / length) * step : step;
    }
    /// Would the step keep the faces, the limits, and the energy below \p allowed? Leaves the samples' new
    /// distances and owners.
    bool Try(const Vector3<float>& step, const Energy& before, double allowed)
    {
        if (!KeepsFaces(step)) return false;
        const float tolerable2 = state_.Tolerable2();
        const BackwardEnergy backward =
            MeasureBackward(search_, points_, step, std::numeric_limits<float>::max(), allowed, nullptr);
        if (backward.energy >= allowed || backward.largest2 > std::max(before.backward2, tolerable2))
            return false;
        double sum = backward.energy;
        return border_.StaysBelow(step, sum, allowed, std::max(before.border2, tolerable2)) &&
               ForwardStaysBelow(step, allowed - sum, std::max(before.forward2, tolerable2));
    }
    bool KeepsFaces(const Vector3<float>& step)
    {
        for (std::size_t i = 0; i < star_.size(); ++i) {
            const PreparedTriangle<float>& old = star_[i].triangle;
            trials_[i].triangle = PrepareTriangle(star_[i].toNext - step, star_[i].toPrevious - step);
            const PreparedTriangle<float>& moved = trials_[i].triangle;
            if (!(moved.doubleArea > 0) || Dot(NormalOf(moved), NormalOf(old)) < kMinTurnCosine ||
                moved.quality < std::min(kMinMoveQuality, old.quality / 2))
                return false;
        }
        return true;
    }
    bool ForwardStaysBelow(const Vector3<float>& step, double allowed, float limit2);
    /// Would a face of the trial face away from the original below its centroid, and did not before?
    bool FoldsFace() const
    {
        for (std::size_t i = 0; i < star_.size(); ++i) {
            const SurfacePlace below = state_.centroidHints[star_[i].face];
            if (FacesAwayFrom(state_.original, below, NormalOf(trials_[i].triangle)) &&
                !FacesAwayFrom(state_.original, below, NormalOf(star_[i].triangle)))
                return true;
        }
        return false;
    }
    void Accept(std::uint32_t v, const Vector3<float>& step)
    {
        SurfacePoint& point = state_.simplified.points[v];
        point.x += step.x;
        point.y += step.y;
        point.z += step.z;
        auto& flags = state_.simplified.flags[v];
        flags = static_cast<std::uint8_t>(flags | kMovedVertex);
        state_.MarkChanged(v, kMovedLately);
        StoreSamples(state_.samples, groups_, star_.size(), [&](std::size_t i) { return star_[i].face; });
        border_.Store(state_.border);
    }
};

inline void VertexMover::MeasureForward(Energy& energy, EquationSums& equations)
{
    constexpr float kOnSurface2 = 1e-12F; // a sample this near to the surface has no direction of its own
    Float4 sum = Splat(0.0F), largest = sum;
    for (const SampleGroup& group : groups_) {
        sum += group.weight * group.distance2;
        largest = Max(largest, group.distance2);
        const PreparedTriangle<float>& triangle = star_[group.owner].triangle;
        const FourClosestPoints closest = ClosestOnTriangle(group.point, triangle);
        const Int4 alongNormal = closest.inside | (closest.distance2 < Splat(kOnSurface2));
        const Float4 inverse = 1.0F / Sqrt(Max(closest.distance2, Splat(kOnSurface2)));
        const Vector3<Float4> direction =
            Select(alongNormal, Splat(NormalOf(triangle)), inverse * closest.difference);
        equations.Add(group.weight * closest.originWeight, closest.originWeight, direction,
                      closest.difference);
    }
    energy.sum = static_cast<double>(SumLanes(sum));
    energy.forward2 = MaxLane(largest);
}

inline void VertexMover::CollectBackwardPoints(std::uint32_t v)
{
    const Vector3<float> origin = PositionOf(state_.simplified, v);
    const GroupRange all{0, groups_.size()};
    const auto add = [&](const Vector3<float>& position, float weight, float leverage, const GroupRange& near,
                         SurfacePlace& hint) {
        if (hint == kNone)
            hint = NearestOrigin(state_.samples, groups_, near.begin < near.end ? near : all, position);
        points_.Add(origin + position, kBackwardWeight * weight, leverage, &hint);
    };
    points_.Clear();
    float area = 0;
    for (std::size_t i = 0; i < star_.size(); ++i) {
        const StarTriangle& s = star_[i];
        const float faceArea = s.triangle.doubleArea / 2;
        area += faceArea;
        add((1.0F / 3) * (s.toNext + s.toPrevious), kBackwardCentroidShare * faceArea, 1.0F / 3,
            trials_[i].samples, state_.centroidHints[s.face]);
        add(0.5F * s.toNext, kBackwardEdgeShare * faceArea, 0.5F, trials_[i].samples, NextEdgeHint(i));
        if (trials_[i].acrossPrevious == kNone) // a border edge: of no face's next
            add(0.5F * s.toPrevious, kBackwardEdgeShare * faceArea, 0.5F, trials_[i].samples,
                state_.edgeHints[EdgeHint(MakeCorner(s.face, (IndexOf(s.corner) + 2) % 3))]);
    }
    add(Vector3<float>{}, kBackwardVertexShare * area, 1, all, state_.vertexHints[v]);
}

/// Each sample on the face that held it and, unless it projects inside, on the two faces beside that.
inline bool VertexMover::ForwardStaysBelow(const Vector3<float>& step, double allowed, float limit2)
{
    double sum = 0;
    for (SampleGroup& group : groups_) {
        const Vector3<Float4> point = group.point - Splat(step);
        const Trial& own = trials_[group.owner];
        const FourClosestPoints closest = ClosestOnTriangle(point, own.triangle);
        group.newDistance2 = closest.distance2;
        group.newOwner = Splat(static_cast<std::int32_t>(group.owner));
        if (!AllLanes(closest.inside)) {
            for (const std::uint32_t beside : {own.acrossNext, own.acrossPrevious}) {
                if (beside == kNone) continue;
                const Float4 distance2 = ClosestOnTriangle(point, trials_[beside].triangle).distance2;
                const Int4 closer = distance2 < group.newDistance2;
                group.newDistance2 = Min(distance2, group.newDistance2);
                group.newOwner = Select(closer, Splat(static_cast<std::int32_t>(beside)), group.newOwner);
            }
        }
        sum += static_cast<double>(SumLanes(group.weight * group.newDistance2));
        if (sum >= allowed || MaxLane(group.newDistance2) > limit2) return false;
    }
    return true;
}

} // namespace vcg_ext
