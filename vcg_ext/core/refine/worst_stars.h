// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/fan.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/per_thread.h"

// The last pass: the stars that hold the largest distances, a few at a time, the worst ones first. Those of
// one turn share no face, so that the outcome does not depend on the number of threads.

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

    /// The squared largest distance of the star, before and after.
    struct Outcome {
        float before2 = 0, after2 = 0;
    };

    /// \param tree of the original's faces
    Outcome Move(std::uint32_t v, const FaceTree& tree)
    {
        fan_.FillWithStar(v);
        if (!fan_.HasSamples()) return {};
        Vector3<float> x{};
        Fan::Distances best = Measure(x, tree);
        const float before2 = best.largest2;
        const double mean = static_cast<double>(state_.meanSquare * fan_.summary().weight);
        const double allowed = best.energy + kWorstPrice * (best.energy + mean);
        float length = kWorstStep;
        for (int trial = 0; trial < kWorstTrials && length > kSmallestWorstStep; ++trial) {
            const Vector3<float> tried = x + length * best.step;
            const Fan::Distances now = Measure(tried, tree);
            const bool isBetter = now.largest2 < (1 - kMinWorstGain) * best.largest2 &&
                                  now.energy < allowed && fan_.KeepsFaces() && !fan_.FacesAway();
            if (!isBetter) {
                length /= 2;
                continue;
            }
            best = now;
            x = tried;
        }
        if (best.largest2 < before2) {
            Measure(x, tree);
            fan_.Store(v, x);
        }
        return {before2, best.largest2};
    }
};

/// How far the stars are from the other surface: forward as the samples have it, backward as the moves have
/// seen it last. A star that has changed since may be nearer by now.
class StarDistances
{
    const RefinementState& state_;
    Buffer<float> ofFaces_; ///< squared, of their samples

  public:
    StarDistances(const RefinementState& state, int threads)
        : state_(state), ofFaces_(state.simplified.FaceCount())
    {
        constexpr std::size_t kGrain = 4096;
        ParallelRanges(threads, ofFaces_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f) UpdateFace(static_cast<std::uint32_t>(f));
        });
    }

    /// The largest squared distance of the star of \p v.
    float Largest2(std::uint32_t v) const
    {
        const SurfaceArrays& s = state_.simplified;
        float largest2 = state_.backward2[v];
        for (const Corner* c = BeginCorners(s, v); c != EndCorners(s, v); ++c)
            largest2 = std::max(largest2, ofFaces_[FaceOf(*c)]);
        return largest2;
    }
    void UpdateFaces(std::uint32_t v)
    {
        const SurfaceArrays& s = state_.simplified;
        for (const Corner* c = BeginCorners(s, v); c != EndCorners(s, v); ++c) UpdateFace(FaceOf(*c));
    }

  private:
    void UpdateFace(std::uint32_t face)
    {
        float largest2 = 0;
        const Buffer<Sample>& samples = state_.samples.samples;
        for (std::uint32_t i = state_.samples.faces[face].first; i != kNone; i = samples[i].next)
            largest2 = std::max(largest2, samples[i].distance2);
        ofFaces_[face] = largest2;
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

/// The stars that are still to be tried, and how far they are.
class WorstStars
{
    static constexpr std::uint32_t kMinFaces = 3;
    RefinementState& state_;
    const FaceTree& tree_;
    int threads_;
    StarDistances distances_;
    PerThread<WorstStarMover> movers_;
    std::vector<std::uint8_t> isDone_;
    std::vector<float> largest2_; ///< of the candidates

  public:
    WorstStars(RefinementState& state, const FaceTree& tree, int threads)
        : state_(state), tree_(tree), threads_(threads), distances_(state, threads), movers_(state, threads),
          isDone_(state.simplified.VertexCount(), 0), largest2_(state.simplified.VertexCount())
    {
        const SurfaceArrays& s = state.simplified;
        for (std::uint32_t v = 0; v < s.VertexCount(); ++v)
            isDone_[v] = s.cornerCount[v] < kMinFaces || s.cornerCount[v] > kMaxFanFaces ||
                         (s.flags[v] & (kBorderVertex | kFixedVertex));
    }

    /// The worst ones, at most \p count, that share no face.
    std::vector<std::uint32_t> Next(std::size_t count)
    {
        const float floor2 = kWorstDistance * kWorstDistance * state_.meanSquare;
        std::vector<std::uint32_t> candidates;
        for (std::uint32_t v = 0; v < isDone_.size(); ++v) {
            if (isDone_[v]) continue;
            largest2_[v] = distances_.Largest2(v);
            if (largest2_[v] > floor2) candidates.push_back(v);
        }
        return WorstOf(state_.simplified, std::move(candidates), count,
                       [&](std::uint32_t v) { return largest2_[v]; });
    }
    /// Tries to make them better. Returns how many were as bad as they seemed.
    std::size_t Move(const std::vector<std::uint32_t>& stars)
    {
        constexpr float kSeems = 0.5F; // of the squared distance
        std::vector<std::uint8_t> wasBad(stars.size());
        ParallelFor(threads_, stars.size(), [&](std::size_t i, int thread) {
            const std::uint32_t v = stars[i];
            auto& slot = movers_[thread];
            const WorstStarMover::Outcome outcome = slot.tool.Move(v, tree_);
            wasBad[i] = outcome.before2 > kSeems * largest2_[v];
            state_.backward2[v] = outcome.after2;
            if (outcome.after2 < outcome.before2) {
                ++slot.count;
                distances_.UpdateFaces(v);
            } else {
                isDone_[v] = 1;
            }
        });
        return static_cast<std::size_t>(std::count(wasBad.begin(), wasBad.end(), std::uint8_t{1}));
    }
    std::size_t Improved() const { return movers_.Count(); }
};

/// Returns how many times a star got better. \param tree of the original's faces
inline std::size_t ImproveWorstStars(RefinementState& state, const FaceTree& tree, int threads)
{
    WorstStars stars(state, tree, threads);
    const double vertices = static_cast<double>(state.simplified.VertexCount());
    std::size_t budget = static_cast<std::size_t>(kWorstStars * vertices) + 1;
    const std::size_t most = budget / kWorstTurns + 1;
    for (int turn = 0; turn < 2 * kWorstTurns && budget > 0; ++turn) {
        const std::vector<std::uint32_t> worst = stars.Next(std::min(budget, most));
        if (worst.empty()) break;
        budget -= stars.Move(worst);
    }
    return stars.Improved();
}

} // namespace vcg_ext
