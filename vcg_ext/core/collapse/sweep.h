// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/collapse_vertex.h"
#include "vcg_ext/core/collapse/corner_lists.h"

namespace vcg_ext
{

/// Runs single sweeps over all vertices, on several threads.
///
/// Vertices are split into blocks by index. A vertex is treated with its block only if its neighbours, and
/// those of the vertex it merges with, lie in the block too. All faces of such stars have their vertices in
/// the block, so blocks write to nothing that another reads. The others are put off: to blocks that are
/// shifted by half a block, and what is left there to the end, on one thread. Blocks and their quotas depend
/// on the mesh alone, and so does the outcome.
class SweepRunner
{
    static constexpr std::size_t kVerticesPerBlock = 8192;
    static constexpr std::size_t kMinBlocksToShift = 5;
    static constexpr std::size_t kNoQuota = std::numeric_limits<std::size_t>::max();

    SweepState& state_;
    int threads_;
    std::vector<Workspace> workspaces_;
    std::uint32_t poolEnd_;
    bool listsAreCompact_ = true; ///< as the loader makes them
    std::uint32_t blockSize_ = 1;
    std::size_t blocks_ = 1;
    std::vector<std::vector<std::uint32_t>> putOff_, putOffShifted_;
    std::vector<std::size_t> died_;

  public:
    /// \pre the state is loaded and started, and outlives this object
    SweepRunner(SweepState& state, int threads)
        : state_(state), threads_(threads), workspaces_(static_cast<std::size_t>(threads)),
          poolEnd_(static_cast<std::uint32_t>(3 * state.faces.size()))
    {
    }

    /// Looks at every vertex whose key is within the threshold, until \p target faces are left.
    /// \return the number of faces that died
    std::size_t Sweep(const SweepStep& step, std::size_t target)
    {
        if (!listsAreCompact_) {
            poolEnd_ = CompactCornerLists(state_, threads_);
            for (Workspace& workspace : workspaces_) workspace.arena.Reset();
        }
        listsAreCompact_ = false;
        if (state_.bound) ++state_.bound->sweep;
        if (state_.crossings) state_.crossings->isOpen = false;
        for (Workspace& workspace : workspaces_) workspace.wedges.refusedBySeams = false;
        const std::size_t before = state_.aliveFaces;
        FormBlocks();
        if (state_.wedges) CountCharts(*state_.wedges);
        SweepBlocks(step, target);
        SweepShiftedBlocks(step, target);
        if (state_.wedges && blocks_ > 1) CountCharts(*state_.wedges);
        SweepRest(step, target);
        return before - state_.aliveFaces;
    }

    /// Whether the bound has refused anything.
    bool RefusedByBound() const
    {
        return std::any_of(workspaces_.begin(), workspaces_.end(),
                           [](const Workspace& workspace) { return workspace.bound.refused; });
    }

    /// Whether seams have refused anything in the last sweep.
    bool RefusedBySeams() const
    {
        return std::any_of(workspaces_.begin(), workspaces_.end(),
                           [](const Workspace& workspace) { return workspace.wedges.refusedBySeams; });
    }

  private:
    void FormBlocks()
    {
        const std::uint32_t count = state_.VertexCount();
        blocks_ = std::max<std::size_t>(1, state_.aliveFaces / 2 / kVerticesPerBlock);
        blockSize_ = static_cast<std::uint32_t>((count + blocks_ - 1) / blocks_);
        blocks_ = (count + blockSize_ - 1) / blockSize_;
    }
    VertexRange Block(std::size_t block) const
    {
        const std::size_t begin = block * blockSize_;
        return {static_cast<std::uint32_t>(begin),
                static_cast<std::uint32_t>(std::min<std::size_t>(state_.VertexCount(), begin + blockSize_))};
    }
    /// Block \p block moved towards the first vertex by half its size.
    VertexRange ShiftedBlock(std::size_t block) const
    {
        const std::uint32_t shift = blockSize_ / 2;
        const std::size_t end = block * blockSize_ + blockSize_ - shift;
        const std::size_t begin = block == 0 ? 0 : block * blockSize_ - shift;
        return {static_cast<std::uint32_t>(begin),
                static_cast<std::uint32_t>(std::min<std::size_t>(state_.VertexCount(), end))};
    }

    /// How many faces each block may take where all candidates together could take too many.
    std::vector<std::size_t> Quotas(const std::vector<std::size_t>& candidates, std::size_t target) const
    {
        std::size_t all = 0;
        for (const std::size_t count : candidates) all += count;
        const std::size_t wanted = state_.aliveFaces > target ? state_.aliveFaces - target : 0;
        std::vector<std::size_t> quotas(candidates.size(), kNoQuota);
        if (2 * all <= wanted) return quotas;
        for (std::size_t block = 0; block < quotas.size(); ++block)
            quotas[block] = wanted * candidates[block] / all;
        return quotas;
    }

    void SweepBlocks(const SweepStep& step, std::size_t target)
    {
        std::vector<std::size_t> candidates(blocks_, 0);
        ParallelFor(threads_, blocks_, [&](std::size_t block, int) {
            const VertexRange range = Block(block);
            std::size_t count = 0;
            for (std::uint32_t v = range.begin; v < range.end; ++v) count += state_.key[v] <= step.threshold;
            candidates[block] = count;
        });
        const std::vector<std::size_t> quotas = Quotas(candidates, target);
        putOff_.resize(std::max(putOff_.size(), blocks_));
        died_.assign(blocks_, 0);
        ParallelFor(threads_, blocks_, [&](std::size_t block, int thread) {
            const VertexRange range = Block(block);
            VertexVisitor visitor = MakeVisitor(thread);
            std::vector<std::uint32_t>& later = putOff_[block];
            later.clear();
            const auto isDue = [&](std::uint32_t v) { return state_.key[v] <= step.threshold; };
            for (std::uint32_t v = range.begin; v < range.end; ++v) {
                ReadAhead(state_).At(v, range.end, isDue);
                if (!isDue(v)) continue;
                if (visitor.Died() + 2 > quotas[block]) break;
                if (visitor.Visit(v, range, step) == VisitResult::PutOff) later.push_back(v);
            }
            died_[block] = visitor.Died();
        });
        CountDied();
    }

    VertexVisitor MakeVisitor(int thread)
    {
        return {state_, workspaces_[static_cast<std::size_t>(thread)], poolEnd_};
    }
    void CountDied()
    {
        for (const std::size_t died : died_) state_.aliveFaces -= died;
    }
    bool IsCandidate(std::uint32_t v, const SweepStep& step) const
    {
        return state_.key[v] <= step.threshold && !state_.Has(v, kMergedVertex);
    }

    void SweepShiftedBlocks(const SweepStep& step, std::size_t target)
    {
        putOffShifted_.resize(std::max(putOffShifted_.size(), blocks_ + 1));
        for (auto& list : putOffShifted_) list.clear();
        for (std::size_t block = 0; block < blocks_; ++block)
            for (const std::uint32_t v : putOff_[block])
                if (IsCandidate(v, step)) putOffShifted_[(v + blockSize_ / 2) / blockSize_].push_back(v);
        if (blocks_ < kMinBlocksToShift || state_.aliveFaces <= target) return;
        std::vector<std::size_t> candidates(blocks_ + 1);
        for (std::size_t block = 0; block <= blocks_; ++block)
            candidates[block] = putOffShifted_[block].size();
        const std::vector<std::size_t> quotas = Quotas(candidates, target);
        died_.assign(blocks_ + 1, 0);
        ParallelFor(threads_, blocks_ + 1, [&](std::size_t block, int thread) {
            const VertexRange range = ShiftedBlock(block);
            VertexVisitor visitor = MakeVisitor(thread);
            std::vector<std::uint32_t>& list = putOffShifted_[block];
            std::size_t kept = 0;
            for (std::size_t i = 0; i < list.size(); ++i) {
                ReadAhead(state_).At(
                    i, list.size(), [&](std::size_t k) { return list[k]; },
                    [&](std::uint32_t v) { return IsCandidate(v, step); });
                const std::uint32_t v = list[i];
                if (!IsCandidate(v, step)) continue;
                if (visitor.Died() + 2 > quotas[block] ||
                    visitor.Visit(v, range, step) == VisitResult::PutOff)
                    list[kept++] = v;
            }
            list.resize(kept);
            died_[block] = visitor.Died();
        });
        CountDied();
    }

    /// What no block could treat, and near the target everything that the rounding of quotas left; so too
    /// where the sweep has to prove that nothing is legal.
    void SweepRest(const SweepStep& step, std::size_t target)
    {
        const VertexRange all{0, state_.VertexCount()};
        if (state_.crossings) CrossingCheck::Open(state_);
        const std::size_t before = state_.aliveFaces;
        VertexVisitor visitor = MakeVisitor(0);
        const auto isCandidate = [&](std::uint32_t v) { return IsCandidate(v, step); };
        const auto visit = [&](std::uint32_t v) {
            if (before - visitor.Died() > target && isCandidate(v)) visitor.Visit(v, all, step);
        };
        for (const auto& list : putOffShifted_)
            for (std::size_t i = 0; i < list.size(); ++i) {
                ReadAhead(state_).At(
                    i, list.size(), [&](std::size_t k) { return list[k]; }, isCandidate);
                visit(list[i]);
            }
        const std::size_t few = std::max<std::size_t>(8, target / 200);
        if (step.everything || before - visitor.Died() <= target + few)
            for (std::uint32_t v = 0; v < all.end && before - visitor.Died() > target; ++v) visit(v);
        state_.aliveFaces = before - visitor.Died();
    }
};

} // namespace vcg_ext
