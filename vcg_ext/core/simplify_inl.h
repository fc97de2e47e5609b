// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/bound/bound_keeper.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/on_clean_input.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline_inl.h"
#include "vcg_ext/core/simplify.h"

namespace vcg_ext
{

VCG_EXT_INLINE CollapsedSurface SweepCollapse::operator()(const MeshView& view, KeptForLater kept,
                                                          StageProgress progress) const
{
    if (!bound) return Run(view, kept, std::move(progress));
    kept.bound = &bound->task;
    for (int run = 0;; ++run) { // again, more careful, where the certificate fails
        constexpr int kRuns = 5;
        CollapsedSurface surface = Run(view, kept, progress.Part(20 * run, 20 * run + 20));
        if (bound->Accepts(surface.coveredBy, ResultOf(view, surface)) || run + 1 == kRuns) return surface;
    }
}

VCG_EXT_INLINE CollapsedSurface SweepCollapse::Run(const MeshView& view, const KeptForLater& kept,
                                                   StageProgress progress) const
{
    CollapseEngine engine(view, parameters, kept, std::move(progress));
    engine.Collapse(parameters.targetFaces);
    return std::move(engine).Extract();
}

inline PipelineStages StagesOfSweeps(Effort effort)
{
    PipelineStages stages = StagesOf(effort);
    stages.guardsCrossings = true;
    if (stages.refine) return stages;
    stages.collapseEnds = stages.repairBegins = 54; // what follows takes as long as ever
    stages.crossingsBegin = 62;
    stages.reportBegins = 71;
    return stages;
}

VCG_EXT_INLINE Simplification RunSweeps(const MeshView& view, const DecimationParameters& parameters)
{
    PipelineStages stages = StagesOfSweeps(parameters.effort);
    std::optional<BoundKeeper> bound;
    if (parameters.maxError > 0)
        stages.bound = &bound.emplace(view, parameters.maxError, ResolveThreads(parameters.threads));
    return RunPipeline(view, parameters, stages, SweepCollapse{parameters, stages.bound});
}

VCG_EXT_INLINE Simplification Simplify(const MeshView& view, const DecimationParameters& parameters)
{
    CheckForSweeps(view, parameters);
    return OnCleanInput(view, parameters, [&](const MeshView& mesh) { return RunSweeps(mesh, parameters); });
}

} // namespace vcg_ext
