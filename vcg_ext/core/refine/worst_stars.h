// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/fan.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/per_thread.h"

// The last pass: the stars that hold the largest distances, a few at a time, the worst ones first. Those of one
// turn share no face, so that the outcome does not depend on the number of threads.

namespace vcg_ext
{

/// Lowers the largest distance of one star, in either direction, by steps toward the point that has it.
/// One object per thread; it holds nothing but scratch between two calls.
class WorstStarMover
{
    RefinementState& state_;
    Fan fan_;

    Fan::Distances Measure(const Vector3<float>& x, const FaceTree& tree)
    {
        Fan::Distances both = fan_.MeasureForward(x, nullptr);
        const Fan::Distances backward = fan_.MeasureBackward(x, &tree);
        both.energy += backward.energy;
        if (backward.largest2 > both.largest2) {
            both.largest2 = backward.largest2;
            both.step = backward.step;
        } else {
            both.step = fan_.StepForSamples(x);
        }
        return both;
    }

  public:
    explicit WorstStarMover(RefinementState& state) : state_(state), fan_(state) {}

    /// True if \p v moved and the largest distance fell. \param tree of the original's faces
    bool Move(std::uint32_t v, const FaceTree& tree)
    {
        fan_.FillWithStar(v);
        if (!fan_.HasSamples()) return false;
        Vector3<float> x{};
        Fan::Distances best = Measure(x, tree);
        const double mean = static_cast<double>(state_.meanSquare * fan_.summary().weight);
        const double allowed = best.energy + kWorstPrice * (best.energy + mean);
        bool moved = false;
        float length = kWorstStep;
        for (int trial = 0; trial < kWorstTrials && length > kSmallestWorstStep; ++trial) {
            const Vector3<float> tried = x + length * best.step;
            const Fan::Distances now = Measure(tried, tree);
            const bool isBetter = now.largest2 < (1 - kMinWorstGain) * best.largest2 && now.energy < allowed &&
                                  fan_.KeepsFaces() && !fan_.FacesAway();
            if (!isBetter) {
                length /= 2;
                continue;
            }
            best = now;
            x = tried;
            moved = true;
        }
        if (!moved) return false;
        Measure(x, tree);
        fan_.Store(v, x);
        return true;
    }
};

/// How far the stars are from the other surface.
class StarDistances
{
    const RefinementState& state_;
    const FaceTree& tree_;
    PlaceSearch search_;
    Buffer<float> ofFaces_;    ///< squared; of their samples, their centroids and the midpoints of their edges
    Buffer<float> ofVertices_; ///< squared; of themselves

  public:
    StarDistances(const RefinementState& state, const FaceTree& tree, int threads)
        : state_(state), tree_(tree), search_(state.original), ofFaces_(state.simplified.FaceCount()),
          ofVertices_(state.simplified.VertexCount())
    {
        constexpr std::size_t kGrain = 1024;
        ParallelRanges(threads, ofFaces_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f) MeasureFace(static_cast<std::uint32_t>(f));
        });
        ParallelRanges(threads, ofVertices_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) MeasureVertex(static_cast<std::uint32_t>(v));
        });
    }

    /// The largest squared distance of the star of \p v.
    float Largest2(std::uint32_t v) const
    {
        const SurfaceArrays& s = state_.simplified;
        float largest2 = ofVertices_[v];
        for (const Corner* c = BeginCorners(s, v); c != EndCorners(s, v); ++c)
            largest2 = std::max(largest2, ofFaces_[FaceOf(*c)]);
        return largest2;
    }
    /// After \p v has moved.
    void MeasureStar(std::uint32_t v)
    {
        const SurfaceArrays& s = state_.simplified;
        MeasureVertex(v);
        for (const Corner* c = BeginCorners(s, v); c != EndCorners(s, v); ++c) MeasureFace(FaceOf(*c));
    }

  private:
    void MeasureFace(std::uint32_t face)
    {
        float largest2 = 0;
        const Buffer<Sample>& samples = state_.samples.samples;
        for (std::uint32_t i = state_.samples.faces[face].first; i != kNone; i = samples[i].next)
            largest2 = std::max(largest2, samples[i].distance2);
        Vector3<Float4> points{};
        std::array<SurfacePlace, kLanes> hints{};
        SetLane(points, 0, Centroid(state_.simplified, face));
        hints[0] = state_.centroidHints[face];
        for (int k = 0; k < 3; ++k) {
            const SurfaceTriangle& t = state_.simplified.triangles[face];
            const Vector3<float> a = PositionOf(state_.simplified, t.v[k]);
            const Vector3<float> b = PositionOf(state_.simplified, t.v[kNextIndex[k]]);
            SetLane(points, k + 1, 0.5F * (a + b));
            const SurfacePlace hint = state_.edgeHints[EdgeHint(MakeCorner(face, k))];
            hints[static_cast<std::size_t>(k) + 1] = hint == kNone ? hints[0] : hint;
        }
        ofFaces_[face] = MaxLane(Distances2(points, hints, largest2));
        ofFaces_[face] = std::max(ofFaces_[face], largest2);
    }
    void MeasureVertex(std::uint32_t v)
    {
        ofVertices_[v] = 0;
        if (state_.simplified.cornerCount[v] == 0) return;
        std::array<SurfacePlace, kLanes> hints{};
        hints.fill(state_.vertexHints[v]);
        const Vector3<Float4> point = Splat(PositionOf(state_.simplified, v));
        const float doubt = std::numeric_limits<float>::max(); // no spike is a single point
        ofVertices_[v] = Distances2(point, hints, doubt)[0];
    }
    /// Of four points, by walks from the hints. \param forward2 how far the samples nearby are
    Float4 Distances2(const Vector3<Float4>& points, std::array<SurfacePlace, kLanes> hints,
                      float forward2) const
    {
        std::array<SurfacePlace*, kLanes> at{};
        Int4 isKnown{};
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            isKnown[lane] = hints[lane] == kNone ? 0 : -1;
            if (hints[lane] == kNone) hints[lane] = kFacePlace; // any face does: the tree finds the right one
            at[lane] = &hints[lane];
        }
        const PlaceSearch::FourHits hits = search_.Find(points, at.data());
        Float4 distance2 = hits.distance2;
        const float doubtful2 = kDoubtful * std::max(forward2, state_.meanSquare);
        for (int lane = 0; lane < kLanes; ++lane)
            if (!hits.found[lane] || !isKnown[lane] || distance2[lane] > doubtful2)
                distance2[lane] = tree_.Distance2(Lane(points, lane));
        return distance2;
    }
};

/// Stars that share no face, the worst first, at most \p count of those that are left.
template <class Largest2>
std::vector<std::uint32_t> WorstOf(const SurfaceArrays& surface, std::vector<std::uint32_t> candidates,
                                   std::size_t count, const Largest2& largest2)
{
    std::sort(candidates.begin(), candidates.end(), [&](std::uint32_t l, std::uint32_t r) {
        const float l2 = largest2(l), r2 = largest2(r);
        return l2 != r2 ? l2 > r2 : l < r;
    });
    std::vector<std::uint8_t> isNear(surface.VertexCount(), 0);
    std::vector<std::uint32_t> chosen;
    for (const std::uint32_t v : candidates) {
        if (chosen.size() == count) break;
        if (isNear[v]) continue;
        chosen.push_back(v);
        for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
            isNear[NextVertex(surface, *c)] = isNear[PreviousVertex(surface, *c)] = 1;
    }
    return chosen;
}

/// Returns how many stars got better.
inline std::size_t ImproveWorstStars(RefinementState& state, const FaceTree& tree, int threads)
{
    constexpr std::uint32_t kMinFaces = 3;
    const SurfaceArrays& s = state.simplified;
    StarDistances distances(state, tree, threads);
    PerThread<WorstStarMover> movers(state, threads);
    const float floor2 = kWorstDistance * kWorstDistance * state.meanSquare;
    std::size_t budget = static_cast<std::size_t>(kWorstStars * static_cast<double>(s.VertexCount())) + 1;
    const std::size_t most = budget / kWorstTurns + 1;
    std::vector<std::uint8_t> isDone(s.VertexCount(), 0);
    std::vector<float> largest2(s.VertexCount());
    while (budget > 0) {
        std::vector<std::uint32_t> candidates;
        for (std::uint32_t v = 0; v < s.VertexCount(); ++v) {
            if (isDone[v] || s.cornerCount[v] < kMinFaces || s.cornerCount[v] > kMaxFanFaces) continue;
            if (s.flags[v] & (kBorderVertex | kFixedVertex)) continue;
            largest2[v] = distances.Largest2(v);
            if (largest2[v] > floor2) candidates.push_back(v);
        }
        const std::vector<std::uint32_t> chosen =
            WorstOf(s, candidates, std::min(budget, most), [&](std::uint32_t v) { return largest2[v]; });
        if (chosen.empty()) break;
        budget -= chosen.size();
        ParallelFor(threads, chosen.size(), [&](std::size_t i, int thread) {
            auto& slot = movers[thread];
            if (slot.tool.Move(chosen[i], tree)) {
                ++slot.count;
                distances.MeasureStar(chosen[i]);
            } else {
                isDone[chosen[i]] = 1;
            }
        });
    }
    return movers.Count();
}

} // namespace vcg_ext
