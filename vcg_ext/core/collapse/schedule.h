// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/collapse/sweep.h"
#include "vcg_ext/core/collapse/trace.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// Chooses the threshold of every sweep and decides when there is nothing left to do.
class SweepSchedule
{
    static constexpr float kLowestThreshold = 1e-30f;
    /// Quantile of the lowest costs that the first sweep reaches at most.
    static constexpr double kHighestStart = 0.9;
    static constexpr std::uint32_t kCostSamples = 4000;
    static constexpr std::uint32_t kKeySamples = 4000;
    /// Part of the vertices that every sweep should reach.
    static constexpr double kMinCandidates = 0.1;
    /// With more faces than this part to go, errors of the size of rounding drown.
    static constexpr double kDeepReduction = 0.7;

    // Ratios of one threshold to the next. The nearer the target, the smaller the step, as the last collapses
    // are the dearest and should be well chosen. Each was measured by itself, efforts fast, eight meshes at
    // 20 and 5 %, geometric means of rms and Hausdorff distance: a ratio of 9 far away costs 23 % and 16 %
    // for a fifth of the time, sqrt(3) there changes nothing; without the middle steps 7 % and 22 %, without
    // the near ones 3 % and 3 %; near steps half as large change nothing.
    static constexpr float kRatio = 3;
    static constexpr double kMiddle = 2.3; ///< times the target: the steps become half as large, sqrt(3)
    static constexpr float kMiddleRatio = 1.7320508f;
    static constexpr double kNear = 1.3; ///< times the target: small steps, 2^(1/4)
    static constexpr float kNearRatio = 1.19f;
    /// Times the target: 2^(1/8). The last sweep takes whatever is below the threshold in the order of the
    /// vertices, so what is below it should be little.
    static constexpr double kLast = 1.05;
    static constexpr float kLastRatio = 1.09f;
    /// Part of the faces below which a sweep was not worth its time: the next step is larger.
    static constexpr double kSlow = 1.0 / 400;
    static constexpr float kSlowRatio = 2;

    // Near a limit of the cost the steps are small, from this part of it on: otherwise the sweep that reaches
    // it takes much of what costs nearly as much in the order of the vertices.
    static constexpr float kNearLimit = 1.0f / 3;
    static constexpr float kNearLimitRatio = 1.44f;

    SweepState& state_;
    SweepRunner runner_;
    double costUnit_; ///< the mesh's unit for one of the frame
    float limit_;     ///< no collapse costs more
    std::vector<CollapseTrace::Step> steps_;

  public:
    /// \param costLimit of DecimationParameters
    SweepSchedule(SweepState& state, int threads, double costLimit = 0)
        : state_(state), runner_(state, threads), costUnit_(FourthPower(state.frame.unit)),
          limit_(costLimit > 0 ? static_cast<float>(
                                     std::min(costLimit / costUnit_, static_cast<double>(kHighestThreshold)))
                               : kHighestThreshold)
    {
    }

    /// What every sweep so far has left.
    const std::vector<CollapseTrace::Step>& Steps() const { return steps_; }

    /// Collapses until at most \p target faces are left. \param report called between sweeps with the part of
    /// the way that is done, in [0, 1]
    template <class Report>
    StopReason Run(std::size_t target, const Report& report)
    {
        const std::size_t start = state_.aliveFaces;
        const double area = DoubleArea();
        SweepStep step;
        MeasureDistancesBy(area);
        if (start > target) step.threshold = FirstThreshold(target);
        while (state_.aliveFaces > target) {
            const auto way =
                static_cast<double>(start - state_.aliveFaces) / static_cast<double>(start - target);
            report(way);
            MeasureDistancesBy(area); // costs rise with it, so that what the keys say stays true
            const std::size_t died = runner_.Sweep(step, target);
            steps_.push_back({static_cast<double>(step.threshold) * costUnit_, state_.aliveFaces});
            if (IsAtLimit(step, died)) return StopReason::ErrorBound;
            if (died > 0)
                step = NextStep(step, died, target);
            else if (!NextIdleStep(step, target))
                return WhatHolds();
        }
        return StopReason::Target;
    }

  private:
    /// Why nothing more may collapse: under a bound that has refused something the bound, whatever else.
    StopReason WhatHolds() const
    {
        if (runner_.RefusedByBound()) return StopReason::ErrorBound;
        const bool seams = state_.wedges && state_.wedges->keepSeams && runner_.RefusedBySeams();
        return seams ? StopReason::Seams : StopReason::NoLegalCollapse;
    }

    static double FourthPower(double length) { return length * length * length * length; }

    /// Has everything within the limit of the cost been looked at, and hardly anything been left to collapse?
    bool IsAtLimit(const SweepStep& step, std::size_t died) const
    {
        return limit_ < kHighestThreshold && step.threshold >= limit_ &&
               static_cast<double>(died) < kSlow * static_cast<double>(state_.aliveFaces);
    }

    /// \p next, in small steps where the limit is near.
    float Limited(float last, float next) const
    {
        if (!(limit_ < kHighestThreshold) || next < kNearLimit * limit_) return next;
        return std::min(limit_, std::max(kNearLimitRatio * last, kNearLimit * limit_));
    }

    /// Twice the area of the surface.
    double DoubleArea() const
    {
        double area = 0;
        for (const FaceRecord& face : state_.faces) {
            const Vector3<float> m = face.Normal();
            if (face.Alive()) area += static_cast<double>(Dot(m, m));
        }
        return area;
    }
    void MeasureDistancesBy(double doubleArea)
    {
        state_.distanceArea = static_cast<float>(DistanceArea(doubleArea, state_.aliveFaces));
    }

    SweepStep NextStep(const SweepStep& step, std::size_t died, std::size_t target)
    {
        if (!step.lastResort)
            return {Limited(step.threshold, NextThreshold(step.threshold, died, target)), false, false};
        ForgetKeys(); // the knot is cut: cheap collapses may have become legal
        return {FirstThreshold(target), false, false};
    }

    /// What to do after a sweep without a collapse: first look at everything again, as a collapse may have
    /// made another one cheaper or legal; then raise the threshold, to the lowest cost at least; at last try
    /// other placements. \return false if all that was tried
    bool NextIdleStep(SweepStep& step, std::size_t target)
    {
        if (step.everything) {
            const float lowest = LowestKey();
            const bool refused = lowest > kHighestThreshold;
            if (refused && step.lastResort) return false;
            if (refused) {
                step.lastResort = true;
                step.threshold =
                    FirstThreshold(target); // what becomes legal comes in the order of its cost too
            } else {
                step.threshold = std::min(std::max(lowest, step.threshold * kRatio), limit_);
            }
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
        const double part = 1 - static_cast<double>(target) / static_cast<double>(state_.aliveFaces);
        const double quantile = std::clamp(part, 0.0, kHighestStart);
        const float floor = part > kDeepReduction ? LowestUsefulThreshold() : kLowestThreshold;
        return std::min(std::clamp(Quantile(std::move(lowest), quantile), floor, kHighestThreshold), limit_);
    }

    static float Quantile(std::vector<float> values, double part)
    {
        if (values.empty()) return 0;
        const auto place = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), values.begin() + place, values.end());
        return values[static_cast<std::size_t>(place)];
    }

    /// Costs of a distance that the frame's floats can hardly tell from none, over a star of average area and
    /// by itself. What is cheaper differs by rounding only.
    float LowestUsefulThreshold() const
    {
        double area = 0;
        std::size_t samples = 0;
        const std::size_t step = std::max<std::size_t>(1, state_.faces.size() / kCostSamples);
        for (std::size_t f = 0; f < state_.faces.size(); f += step) {
            const Vector3<float> m = state_.faces[f].Normal();
            if (!state_.faces[f].Alive()) continue;
            area += static_cast<double>(Dot(m, m));
            ++samples;
        }
        const double starArea = samples > 0 ? 12 * area / static_cast<double>(samples) : 0;
        const double counted = starArea + static_cast<double>(state_.distanceArea);
        return std::max(kLowestThreshold, static_cast<float>(counted * kNoDistance * kNoDistance));
    }

    /// A multiple of the last threshold, and more where that would reach hardly anybody.
    float NextThreshold(float threshold, std::size_t died, std::size_t target) const
    {
        const double need = static_cast<double>(state_.aliveFaces) / static_cast<double>(target);
        float ratio = need < kNear ? kNearRatio : need < kMiddle ? kMiddleRatio : kRatio;
        if (need < kLast)
            ratio = kLastRatio;
        else if (static_cast<double>(died) < kSlow * static_cast<double>(state_.aliveFaces))
            ratio = std::max(ratio, kSlowRatio);
        const double part = std::min(kMinCandidates, 0.5 * std::max(0.0, 1 - 1 / need));
        return std::min(std::max(threshold * ratio, KeyQuantile(part)), kHighestThreshold);
    }

    /// The quantile of the live vertices' keys, from an even sample.
    float KeyQuantile(double part) const
    {
        std::vector<float> keys;
        const std::uint32_t step = std::max(1u, state_.VertexCount() / kKeySamples);
        for (std::uint32_t v = 0; v < state_.VertexCount(); v += step)
            if (state_.cornerCount[v] > 0) keys.push_back(state_.key[v]);
        return Quantile(std::move(keys), part);
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

} // namespace vcg_ext
