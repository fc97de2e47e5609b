// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"
#include "vcg_ext/core/levels.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/on_clean_input.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline_inl.h"
#include "vcg_ext/core/simplify.h"
#include "vcg_ext/core/simplify_inl.h"

namespace vcg_ext
{

namespace levels_detail
{

/// The collapse of a chain of levels: each goes on where the one before it stopped. Where one has to be done
/// again, as faces would cross, it starts from the original, and those after it go on from there.
class LevelCollapse
{
    const DecimationParameters& parameters_;
    std::optional<CollapseEngine> engine_;
    std::size_t targetFaces_ = 0;
    bool again_ = false, last_ = false;

  public:
    /// \pre the parameters outlive this object
    explicit LevelCollapse(const DecimationParameters& parameters) : parameters_(parameters) {}

    void Begin(std::size_t targetFaces, bool last)
    {
        targetFaces_ = targetFaces;
        last_ = last;
        again_ = false;
    }

    /// As RunPipeline's collapse.
    CollapsedSurface Run(const MeshView& view, const KeptForLater& kept, StageProgress progress)
    {
        if (engine_ && !again_)
            engine_->ReportTo(std::move(progress));
        else
            engine_.emplace(view, parameters_, kept, std::move(progress));
        again_ = true;
        engine_->Collapse(targetFaces_);
        return last_ ? std::move(*engine_).Extract() : engine_->Copy();
    }
};

/// Where each level ends, percent of the whole: as the collapses that are left, and what every level costs by
/// itself.
inline std::vector<int> EndsOf(const std::vector<Level>& levels, std::size_t faces, bool refine)
{
    const double own = refine ? 0.5 : 0.1; // of the time that collapsing all faces takes, roughly
    std::vector<double> ends;
    double end = 0, left = static_cast<double>(faces);
    for (const Level& level : levels) {
        const double target = std::min(left, static_cast<double>(level.targetFaces));
        end += (left - target) / static_cast<double>(faces) + own;
        left = target;
        ends.push_back(end);
    }
    std::vector<int> percent;
    percent.reserve(ends.size());
    for (const double at : ends) percent.push_back(static_cast<int>(100 * at / end));
    return percent;
}

/// \pre no level has a bound
inline std::vector<Simplification> RunChain(const MeshView& view, const DecimationParameters& parameters,
                                            const std::vector<Level>& levels)
{
    const int threads = ResolveThreads(parameters.threads);
    const PipelineStages stages = StagesOfSweeps(parameters, view.attributes != nullptr);
    RunProgress caller(parameters.progress);
    const StageProgress progress{std::ref(caller)};
    const LoopPoll poll([&](int percent) { caller.GoOn(percent); });
    const std::vector<int> ends = EndsOf(levels, view.faceCount, stages.refine);
    std::vector<Simplification> results;
    results.reserve(levels.size());
    // What the first level asks for scales the attributes, as in a run for it alone.
    const DecimationParameters own = ParametersOf(parameters, levels.front());
    try {
        LevelCollapse chain(own);
        const CollapseStage collapse = [&](const MeshView& mesh, const KeptForLater& kept,
                                           StageProgress part) {
            return chain.Run(mesh, kept, std::move(part));
        };
        PipelineRun run(view, own, stages, collapse, threads);
        CrossingKeeper keeper(view, threads);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            chain.Begin(levels[i].targetFaces, i + 1 == levels.size());
            const StageProgress part = progress.Part(i == 0 ? 0 : ends[i - 1], ends[i]);
            results.push_back(ResultOf(run, keeper, levels[i].targetFaces, part));
        }
    } catch (const Cancelled&) {
        return std::vector<Simplification>(levels.size(), CancelledRun(view));
    }
    return results;
}

} // namespace levels_detail

VCG_EXT_INLINE std::vector<Simplification>
SimplifyLevels(const MeshView& view, const DecimationParameters& parameters, const std::vector<Level>& levels)
{
    CheckLevels(levels);
    for (const Level& level : levels) CheckParameters(ParametersOf(parameters, level));
    CheckForSweeps(view, ParametersOf(parameters, levels.front()));
    const auto cancelled = [&](const MeshView& mesh) {
        return std::vector<Simplification>(levels.size(), CancelledRun(mesh));
    };
    const auto run = [&](const MeshView& mesh, const DecimationParameters& own) {
        const bool bound =
            std::any_of(levels.begin(), levels.end(), [](const Level& level) { return level.maxError > 0; });
        if (!bound) return levels_detail::RunChain(mesh, own, levels);
        return EachLevelByItself(
            own, levels, [&](const DecimationParameters& ofLevel) { return RunSweeps(mesh, ofLevel); });
    };
    return OnCleanInput(view, parameters, run, cancelled);
}

} // namespace vcg_ext
