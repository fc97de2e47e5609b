// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"
#include "vcg_ext/core/simplify.h"

namespace vcg_ext
{

/// A level of detail: what takes the place of the members of DecimationParameters with these names.
struct Level {
    std::size_t targetFaces = 1; ///< at least 1
    double maxError = 0;         ///< percent of the diagonal; 0: no bound
};

/// \throws std::invalid_argument unless there are levels, in order from the finest to the coarsest; equal
/// ones
///         are welcome
inline void CheckLevels(const std::vector<Level>& levels)
{
    if (levels.empty()) throw std::invalid_argument("there are no levels");
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const Level &finer = levels[i - 1], &level = levels[i];
        if (level.targetFaces > finer.targetFaces)
            throw std::invalid_argument("target_faces = " + std::to_string(level.targetFaces) + " of level " +
                                        std::to_string(i + 1) + " is more than that of the level before it");
        if (!(level.maxError >= finer.maxError))
            throw std::invalid_argument("max_error = " + std::to_string(level.maxError) + " of level " +
                                        std::to_string(i + 1) + " is less than that of the level before it");
    }
}

/// The parameters of one level in a run of its own.
inline DecimationParameters ParametersOf(const DecimationParameters& parameters, const Level& level)
{
    DecimationParameters own = parameters;
    own.targetFaces = level.targetFaces;
    own.maxError = level.maxError;
    return own;
}

/// Every level by a run of its own, for what cannot go on from one level to the next: a bound, or order
/// strict. \param simplify called as simplify(DecimationParameters), returns a Simplification
/// \pre CheckLevels passes
template <class Simplify>
std::vector<Simplification> EachLevelByItself(const DecimationParameters& parameters,
                                              const std::vector<Level>& levels, const Simplify& simplify)
{
    std::vector<Simplification> results;
    const int count = static_cast<int>(levels.size());
    for (int i = 0; i < count; ++i) {
        DecimationParameters own = ParametersOf(parameters, levels[static_cast<std::size_t>(i)]);
        if (parameters.progress)
            own.progress = [&](int percent, const char* stage) {
                return parameters.progress((100 * i + percent) / count, stage);
            };
        results.push_back(simplify(own));
        if (results.back().report.stopReason != StopReason::Cancelled) continue;
        const Simplification cancelled = results.back();
        return std::vector<Simplification>(levels.size(), cancelled);
    }
    return results;
}

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
    const PipelineStages stages = StagesOfSweeps(parameters.effort);
    const StageProgress progress(parameters.progress);
    const std::vector<int> ends = EndsOf(levels, view.faceCount, stages.refine);
    std::vector<Simplification> results;
    results.reserve(levels.size());
    // What the first level asks for scales the attributes, as in a run for it alone.
    const DecimationParameters own = ParametersOf(parameters, levels.front());
    try {
        LevelCollapse chain(own);
        const auto collapse = [&](const MeshView& mesh, const KeptForLater& kept, StageProgress part) {
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

/// Levels of detail of a mesh of plain arrays, which stays as it is: each is a result as that of Simplify,
/// with everything that it promises, refined and measured against the original.
///
/// Without a bound the collapse of a level goes on where that of the level before it stopped; one that would
/// make faces cross is done again from the original, and those after it go on from there. Levels with a bound
/// are runs of their own. With effort fast, and without measurement, levels of 50, 25 and 10 % take about
/// twice as long as the last one alone, which is less than the sum. The first level is to the bit what
/// Simplify returns for it. Where the run is cancelled every level is as that of a cancelled Simplify.
///
/// \param parameters targetFaces and maxError are not read
/// \param levels from the finest to the coarsest; a bound for all of them or for none
/// \throws as Simplify and CheckLevels
inline std::vector<Simplification> SimplifyLevels(const MeshView& view, DecimationParameters parameters,
                                                  const std::vector<Level>& levels)
{
    CheckLevels(levels);
    for (const Level& level : levels) CheckParameters(ParametersOf(parameters, level));
    CheckForSweeps(view, ParametersOf(parameters, levels.front()));
    return OnCleanInput(view, parameters, [&](const MeshView& mesh) {
        const bool bound =
            std::any_of(levels.begin(), levels.end(), [](const Level& level) { return level.maxError > 0; });
        if (!bound) return levels_detail::RunChain(mesh, parameters, levels);
        return EachLevelByItself(parameters, levels,
                                 [&](const DecimationParameters& own) { return RunSweeps(mesh, own); });
    });
}

} // namespace vcg_ext
