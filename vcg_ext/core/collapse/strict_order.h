// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/collapse/collapse_vertex.h"
#include "vcg_ext/core/collapse/corner_lists.h"
#include "vcg_ext/core/collapse/edge_costs.h"
#include "vcg_ext/core/collapse/placement.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// Collapses one edge after the other, the cheapest legal one first, with the rules of the sweeps: what order
/// strict is for a mesh with attributes, which VCG's queue does not know.
///
/// A vertex waits in a queue with a lower bound of what its cheapest edge costs. The first of them is looked
/// at, and collapses what costs no more than the next one's bound; or it waits on with the cost that was
/// found. After a collapse the survivor and its neighbors are priced again. Once
/// nothing more is legal, the last resort of SweepStep is open to all collapses from then on: to leave it
/// again would mean to look at everything anew. On one thread.
class StrictOrder
{
    using Entry = std::pair<float, std::uint32_t>; ///< bound and vertex; of equal ones the first vertex

    SweepState& state_;
    Workspace workspace_;
    std::uint32_t poolEnd_ = 0;
    std::size_t longest_ = 0; ///< corner list, so far
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::vector<std::uint32_t> ring_;
    double doubleArea_ = 0;
    std::size_t visits_ = 0;

  public:
    /// \pre the state is loaded and started, and outlives this object
    explicit StrictOrder(SweepState& state) : state_(state)
    {
        for (const FaceRecord& face : state_.faces) {
            const Vector3<float> m = face.Normal();
            if (face.Alive()) doubleArea_ += static_cast<double>(Dot(m, m));
        }
    }

    /// Collapses until at most \p target faces are left. \param report as SweepSchedule::Run
    template <class Report>
    StopReason Run(std::size_t target, const Report& report)
    {
        constexpr std::size_t kReports = 1000;
        const std::size_t start = state_.aliveFaces;
        if (state_.wedges) CountCharts(*state_.wedges);
        if (state_.crossings) CrossingCheck::Open(state_);
        Compact();
        for (const std::uint32_t count : state_.cornerCount)
            longest_ = std::max<std::size_t>(longest_, count);
        SweepStep step;
        step.everything = true;
        QueueAll();
        const auto tell = [&] {
            const std::size_t way = start - state_.aliveFaces;
            report(static_cast<double>(way) / static_cast<double>(start - target));
        };
        for (std::size_t next = start; state_.aliveFaces > target;) {
            if (state_.aliveFaces <= next) {
                tell();
                next = state_.aliveFaces - std::min(state_.aliveFaces, (start - target) / kReports + 1);
            }
            if (CollapseFirst(step, tell)) continue;
            if (std::exchange(step.lastResort, true)) return WhatHolds();
            QueueAll();
        }
        return StopReason::Target;
    }

  private:
    StopReason WhatHolds() const
    {
        const bool seams = state_.wedges && state_.wedges->keepSeams && workspace_.wedges.refusedBySeams;
        return seams ? StopReason::Seams : StopReason::NoLegalCollapse;
    }

    void Compact()
    {
        poolEnd_ = CompactCornerLists(state_, 1);
        workspace_.arena.Reset();
    }

    void QueueAll()
    {
        workspace_.wedges.refusedBySeams = false;
        queue_ = {};
        state_.distanceArea = static_cast<float>(DistanceArea(doubleArea_, state_.aliveFaces));
        for (std::uint32_t v = 0; v < state_.VertexCount(); ++v) Queue(v);
    }

    /// With the lowest of its edges' costs without the faces around them, which can but raise it.
    void Queue(std::uint32_t v)
    {
        if (state_.cornerCount[v] == 0) return;
        NeighbourScratch& neighbours = workspace_.neighbours;
        CollectNeighbours(state_, v, {0, state_.VertexCount()}, neighbours);
        if (neighbours.size == 0) return;
        EvaluateEdges(state_, v, neighbours);
        const float* cost = neighbours.cost.data();
        state_.key[v] = *std::min_element(cost, cost + neighbours.size);
        queue_.emplace(state_.key[v], v);
    }

    /// Looks at vertices until one has merged. \param tell called now and then, as a run may be canceled
    /// there \return whether one has
    template <class Tell>
    bool CollapseFirst(SweepStep& step, const Tell& tell)
    {
        constexpr std::size_t kVisits = 4096;
        state_.distanceArea = static_cast<float>(DistanceArea(doubleArea_, state_.aliveFaces));
        while (!queue_.empty()) {
            const auto [bound, v] = queue_.top();
            queue_.pop();
            if (state_.cornerCount[v] == 0 || bound != state_.key[v]) continue; // priced again since
            if (bound > kHighestThreshold) return false;
            if (++visits_ % kVisits == 0) tell();
            step.threshold = queue_.empty() ? kHighestThreshold : std::max(bound, queue_.top().first);
            step.threshold = std::min(step.threshold, kHighestThreshold);
            VertexVisitor visitor(state_, workspace_, poolEnd_);
            if (visitor.Visit(v, {0, state_.VertexCount()}, step) == VisitResult::Collapsed) {
                state_.aliveFaces -= visitor.Died();
                QueueAround();
                return true;
            }
            if (state_.key[v] <= kHighestThreshold) queue_.emplace(state_.key[v], v);
        }
        return false;
    }

    /// Prices the survivor of the collapse just made and its ring. \pre its stars are still gathered
    void QueueAround()
    {
        const StarScratch& star = workspace_.star;
        ring_.assign(star.next.begin(), star.next.begin() + star.kept);
        ring_.insert(ring_.end(), star.previous.begin(), star.previous.begin() + star.kept);
        if (star.kept > 0) {
            const Corner first = star.corner[0];
            const std::uint32_t survivor = state_.faces[FaceOf(first)].v[IndexOf(first)];
            state_.flags[survivor] = static_cast<std::uint8_t>(state_.flags[survivor] & ~kMergedVertex);
            ring_.push_back(survivor);
        }
        std::sort(ring_.begin(), ring_.end());
        ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
        longest_ = std::max<std::size_t>(longest_, star.kept);
        // The next list is not longer than two of those that are there now, or takes a chunk of the arena.
        const std::size_t room = 2 * longest_ + CornerArena::PoolSize(0, 1);
        if (poolEnd_ + room > state_.corners.size()) Compact();
        for (const std::uint32_t v : ring_) Queue(v);
    }
};

} // namespace vcg_ext
