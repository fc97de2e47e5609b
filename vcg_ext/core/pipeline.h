// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

class BoundKeeper;

/// A simplified mesh and what there is to say about it. Where the run was cancelled the mesh is empty.
struct Simplification {
    DecimatedMesh mesh;
    DecimationReport report;
};

/// What is done with a collapsed surface, and when: percent of the time, roughly.
struct PipelineStages {
    bool refine = true;
    bool exchange = false; ///< RefinementParameters::exchange; more passes of moves under a bound or with
                           ///< attributes
    bool repairFolds = true;
    int collapseEnds = 42; ///< of the refinement there is none where it is equal to repairBegins
    int repairBegins = 75;
    int crossingsBegin = 79;
    int reportBegins = 83;        ///< attributes, counts and distances
    BoundKeeper* bound = nullptr; ///< what the stages have to keep; null: no bound
    bool guardsCrossings = false; ///< the collapse can be run again, guarded where faces cross
};

inline PipelineStages StagesOf(Effort effort)
{
    PipelineStages stages;
    stages.refine = effort != Effort::Fast;
    stages.exchange = effort == Effort::Best;
    return stages;
}

/// The first stage: collapses the view's mesh. It computes the descriptor that guides it and hands it on.
using CollapseStage = std::function<CollapsedSurface(const MeshView&, const KeptForLater&, StageProgress)>;

/// The tree of the original's faces that fold repair and measurement share, in the frame of the result;
/// nothing where no face is left.
inline std::optional<FaceTree> TreeOf(const MeshView& original, const DecimatedMesh& mesh,
                                      const std::vector<std::uint32_t>& faceOrder, int threads)
{
    if (mesh.triangles.empty()) return std::nullopt;
    std::vector<std::uint8_t> fixed;
    return std::make_optional<FaceTree>(original, FrameOf(ViewOf(mesh, original, fixed)), threads, faceOrder);
}

/// What is said of a run that was cancelled.
inline Simplification CancelledRun(const MeshView& view)
{
    Simplification result;
    result.mesh.stopReason = result.report.stopReason = StopReason::Cancelled;
    result.report.facesBefore = result.report.faces = view.faceCount;
    result.report.vertices = view.vertexCount;
    return result;
}

/// The way from a mesh to its simplification, the same for every collapse:
///
///     descriptor and weights -> collapse -> refinement -> fold repair -> crossings -> attributes
///         -> report
///
/// \pre CheckParameters and CheckMesh pass
VCG_EXT_INLINE Simplification RunPipeline(const MeshView& view, const DecimationParameters& parameters,
                                          const PipelineStages& stages, const CollapseStage& collapse);

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/core/pipeline_inl.h"
#endif
