// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/levels.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/on_clean_input.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"
#include "vcg_ext/core/simplify.h"
#include "vcg_ext/decimate.h"
#include "vcg_ext/ordered/decimate.h"

namespace vcg_ext
{

VCG_EXT_INLINE Simplification Decimate(const MeshView& view, const DecimationParameters& parameters)
{
    if (parameters.order == Order::Sweeps) return Simplify(view, parameters);
    CheckParameters(parameters);
    CheckMesh(view);
    if (parameters.maxError > 0)
        throw std::invalid_argument("max_error = " + std::to_string(parameters.maxError) +
                                    " needs order sweeps");
    PipelineStages stages = StagesOf(parameters.effort);
    stages.guardsCrossings = true;
    stages.collapseEnds = stages.refine ? 64 : stages.repairBegins;
    const auto collapse = [&](const MeshView& mesh, KeptForLater kept, const StageProgress& progress) {
        if (mesh.attributes) return SweepCollapse{parameters, nullptr}(mesh, kept, progress);
        return CollapseInOrder(mesh, parameters, kept, progress);
    };
    return OnCleanInput(
        view, parameters,
        [&](const MeshView& mesh, const DecimationParameters& own) {
            return RunPipeline(mesh, own, stages, collapse);
        },
        CancelledRun);
}

VCG_EXT_INLINE std::vector<Simplification>
DecimateLevels(const MeshView& view, const DecimationParameters& parameters, const std::vector<Level>& levels)
{
    if (parameters.order == Order::Sweeps) return SimplifyLevels(view, parameters, levels);
    CheckLevels(levels);
    for (const Level& level : levels) CheckParameters(ParametersOf(parameters, level));
    return EachLevelByItself(parameters, levels,
                             [&](const DecimationParameters& own) { return Decimate(view, own); });
}

VCG_EXT_INLINE Simplification SimplifyWeighted(const MeshView& view, const WeightedParameters& weighted,
                                               Progress progress)
{
    CheckMesh(view);
    DecimationParameters parameters;
    parameters.targetFaces = weighted.targetFaces;
    parameters.progress = std::move(progress);
    PipelineStages stages;
    stages.refine = stages.repairFolds = false;
    stages.collapseEnds = stages.repairBegins;
    return RunPipeline(view, parameters, stages,
                       [&](const MeshView& mesh, KeptForLater, const StageProgress& stage) {
                           return ToSurface(mesh, DecimateWeighted(mesh, weighted, stage), false, 1);
                       });
}

} // namespace vcg_ext
