// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sweep_run.h"

namespace vcg_ext::sweeps
{

/// Chooses the threshold of every sweep and decides when there is nothing left to do.
class SweepSchedule
{
    static constexpr float kLowestThreshold = 1e-30f;
    static constexpr double kHighestStart =
        0.9; ///< quantile of the lowest costs that the first sweep reaches
    static constexpr std::uint32_t kCostSamples = 4000;
    static constexpr float kRatio = 3;     ///< from one threshold to the next
    static constexpr double kMiddle = 1.8; ///< times the target: the steps become half as large
    static constexpr float kMiddleRatio = 1.7320508f;
    static constexpr double kNear = 1.3; ///< times the target: small steps, so that the last are well chosen
    static constexpr float kNearRatio = 1.19f;
    static constexpr double kSlow = 1.0 / 400; ///< part of the faces below which a sweep was not worth it
    static constexpr float kSlowRatio = 2;

    SweepState& state_;
    SweepRunner runner_;
    int threads_;

  public:
    SweepSchedule(SweepState& state, int threads) : state_(state), runner_(state, threads), threads_(threads)
    {
    }

    /// Collapses until at most \p target faces are left. \param report called between sweeps with the part of
    /// the way that is done, in [0, 1]; false stops the run
    template <class Report>
    StopReason Run(std::size_t target, const Report& report)
    {
        const std::size_t start = state_.aliveFaces;
        SweepStep step;
        if (start > target) step.threshold = FirstThreshold(target);
        while (state_.aliveFaces > target) {
            const auto way =
                static_cast<double>(start - state_.aliveFaces) / static_cast<double>(start - target);
            if (!report(way)) return StopReason::Cancelled;
            const std::size_t died = runner_.Sweep(step, target);
            if (died > 0)
                step = NextStep(step, died, target);
            else if (!NextIdleStep(step))
                return StopReason::NoLegalCollapse;
        }
        return StopReason::Target;
    }

  private:
    SweepStep NextStep(const SweepStep& step, std::size_t died, std::size_t target)
    {
        if (!step.anyPlacement) return {NextThreshold(step.threshold, died, target), false, false};
        ForgetKeys(); // the knot is cut: cheap collapses may have become legal
        return {FirstThreshold(target), false, false};
    }

    /// What to do after a sweep without a collapse: first look at everything again, as a collapse may have
    /// made another one cheaper or legal; then raise the threshold, to the lowest cost at least; at last try
    /// other placements. \return false if all that was tried
    bool NextIdleStep(SweepStep& step)
    {
        if (step.everything) {
            const float lowest = LowestKey();
            const bool refused = lowest > kHighestThreshold;
            if (refused && step.anyPlacement) return false;
            if (refused) step.anyPlacement = true;
            step.threshold = std::min(std::max(lowest, step.threshold * kRatio), kHighestThreshold);
        }
        step.everything = true;
        ForgetKeys();
        return true;
    }

    /// The quantile of the vertices' lowest costs, from an even sample, that leaves the target for later
    /// sweeps to reach.
    float FirstThreshold(std::size_t target) const
    {
        Workspace workspace;
        std::vector<float> lowest;
        const std::uint32_t count = state_.VertexCount();
        const std::uint32_t step = std::max(1u, count / kCostSamples);
        for (std::uint32_t v = step / 2; v < count; v += step) {
            if (state_.cornerCount[v] == 0) continue;
            CollectNeighbours(state_, v, {0, count}, workspace.neighbours);
            EvaluateEdges(state_, v, workspace.neighbours);
            const float* cost = workspace.neighbours.cost.data();
            lowest.push_back(*std::min_element(cost, cost + workspace.neighbours.size));
        }
        if (lowest.empty()) return kLowestThreshold;
        const double part = 1 - static_cast<double>(target) / static_cast<double>(state_.aliveFaces);
        const double quantile = std::clamp(part, 0.0, kHighestStart);
        const auto place = static_cast<std::ptrdiff_t>(quantile * static_cast<double>(lowest.size() - 1));
        std::nth_element(lowest.begin(), lowest.begin() + place, lowest.end());
        return std::clamp(lowest[static_cast<std::size_t>(place)], kLowestThreshold, kHighestThreshold);
    }

    float NextThreshold(float threshold, std::size_t died, std::size_t target) const
    {
        const double need =
            static_cast<double>(state_.aliveFaces) / static_cast<double>(std::max<std::size_t>(1, target));
        float ratio = need < kNear ? kNearRatio : need < kMiddle ? kMiddleRatio : kRatio;
        if (static_cast<double>(died) < kSlow * static_cast<double>(state_.aliveFaces))
            ratio = std::max(ratio, kSlowRatio);
        return std::min(threshold * ratio, kHighestThreshold);
    }

    void ForgetKeys()
    {
        for (std::uint32_t v = 0; v < state_.VertexCount(); ++v)
            if (state_.cornerCount[v] > 0) state_.key[v] = 0;
    }

    float LowestKey() const
    {
        float lowest = kRefusedKey;
        for (std::uint32_t v = 0; v < state_.VertexCount(); ++v)
            if (state_.cornerCount[v] > 0) lowest = std::min(lowest, state_.key[v]);
        return lowest;
    }
};

} // namespace vcg_ext::sweeps
