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

/// \param attributes they are to be transferred and measured
inline PipelineStages StagesOfSweeps(const DecimationParameters& parameters, bool attributes)
{
    PipelineStages stages = StagesOf(parameters.effort);
    stages.guardsCrossings = true;
    if (stages.exchange && !attributes &&
        !(parameters.maxError > 0)) { // rounds of exchanges take most of the time
        stages.collapseEnds = 12;
        stages.repairBegins = 86;
        stages.crossingsBegin = 88;
        stages.reportBegins = 90;
    } else if (!stages.refine) { // what follows takes as long as ever
        stages.collapseEnds = stages.repairBegins = 54;
        stages.crossingsBegin = 62;
        stages.reportBegins = 71;
    }
    if (attributes)
        for (int* const at :
             {&stages.collapseEnds, &stages.repairBegins, &stages.crossingsBegin, &stages.reportBegins})
            *at = *at * 3 / 4;
    return stages;
}

VCG_EXT_INLINE Simplification RunSweeps(const MeshView& view, const DecimationParameters& parameters)
{
    PipelineStages stages = StagesOfSweeps(parameters, view.attributes != nullptr);
    std::optional<BoundKeeper> bound;
    if (parameters.maxError > 0)
        stages.bound = &bound.emplace(view, parameters.maxError, ResolveThreads(parameters.threads));
    return RunPipeline(view, parameters, stages, SweepCollapse{parameters, stages.bound});
}

VCG_EXT_INLINE Simplification Simplify(const MeshView& view, const DecimationParameters& parameters)
{
    CheckForSweeps(view, parameters);
    return OnCleanInput(
        view, parameters,
        [](const MeshView& mesh, const DecimationParameters& own) { return RunSweeps(mesh, own); },
        CancelledRun);
}

} // namespace vcg_ext
