// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "vcg_ext/core/simplify.h"
#include "vcg_ext/ordered/collapse.h"
#include "vcg_ext/ordered/decimate.h"

namespace vcg_ext
{

/// The simplification of Zhang et al. (2012): their collapse alone in the pipeline of Simplify, without
/// refinement and fold repair. \param progress may be empty
/// \throws std::invalid_argument as CheckMesh and DecimateWeighted
inline Simplification SimplifyWeighted(const MeshView& view, const WeightedParameters& weighted,
                                       Progress progress = {})
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
