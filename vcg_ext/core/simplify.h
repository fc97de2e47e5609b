// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/attributes/corner_values.h"
#include "vcg_ext/core/attributes/measure.h"
#include "vcg_ext/core/attributes/transfer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/bound/bound_keeper.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/refine/refine.h"
#include "vcg_ext/core/repair/repair_folds.h"

namespace vcg_ext
{

/// A simplified mesh and what there is to say about it. Where the run was cancelled the mesh is empty.
struct Simplification {
    DecimatedMesh mesh;
    DecimationReport report;
};

/// Checks what does not depend on the mesh. \throws std::invalid_argument that names parameter, value and
/// range
inline void CheckParameters(const DecimationParameters& parameters)
{
    const double weight = parameters.featureWeight;
    if (!(weight >= 0 && weight <= 50)) // negated, so NaN is refused too
        throw std::invalid_argument("feature_weight = " + std::to_string(weight) + " is outside [0, 50]");
    const double error = parameters.maxError;
    if (!(error >= 0 && error <= 100))
        throw std::invalid_argument("max_error = " + std::to_string(error) + " is outside [0, 100]");
    if (parameters.targetFaces < 1) throw std::invalid_argument("target_faces = 0 is less than 1");
    if (parameters.threads < 0)
        throw std::invalid_argument("threads = " + std::to_string(parameters.threads) + " is less than 0");
    const double attributes = parameters.attributeWeight;
    if (!(attributes >= 0 && attributes <= 100))
        throw std::invalid_argument("attribute_weight = " + std::to_string(attributes) +
                                    " is outside [0, 100]");
    if (!(parameters.costLimit >= 0)) throw std::invalid_argument("cost_limit is less than 0");
    if (!(parameters.descriptorScale >= 0)) throw std::invalid_argument("descriptor_scale is less than 0");
}

/// Checks that the view can be simplified. \throws std::invalid_argument that says what is wrong, with the
/// count
inline void CheckMesh(const MeshView& view)
{
    if (view.faceCount == 0) throw std::invalid_argument("the mesh has no faces");
    if (const std::size_t bad = CountNonFinite(view))
        throw std::invalid_argument("the coordinates of " + std::to_string(bad) + " of " +
                                    std::to_string(view.vertexCount) + " vertices are not finite");
    if (view.attributes == nullptr) return;
    if (const std::size_t bad = CountNonFinite(*view.attributes, view.faceCount))
        throw std::invalid_argument("the attributes of " + std::to_string(bad) + " of " +
                                    std::to_string(view.faceCount) + " faces are not finite");
}

/// What is done with a collapsed surface, and when: percent of the time, roughly.
struct PipelineStages {
    bool refine = true;
    bool repairFolds = true;
    int collapseEnds = 52; ///< of the refinement there is none where it is equal to repairBegins
    int repairBegins = 95;
    BoundKeeper* bound = nullptr; ///< what the stages have to keep; null: no bound
};

constexpr std::size_t kDistanceSamples = 100000; ///< a side, beside all vertices

/// The tree of the original's faces that fold repair and measurement share, in the frame of the result;
/// nothing where no face is left.
inline std::optional<FaceTree> TreeOf(const MeshView& original, const DecimatedMesh& mesh,
                                      const std::vector<std::uint32_t>& faceOrder, int threads)
{
    if (mesh.triangles.empty()) return std::nullopt;
    std::vector<std::uint8_t> fixed;
    return std::make_optional<FaceTree>(original, FrameOf(ViewOf(mesh, original, fixed)), threads, faceOrder);
}

/// The surface as the caller will have it.
inline DecimatedMesh ResultOf(const MeshView& view, const CollapsedSurface& surface, const BoundKeeper* bound)
{
    DecimatedMesh mesh = ToMesh(view, surface);
    if (bound) bound->Round(mesh);
    return mesh;
}

/// Refines the surface where that is asked for, and takes it as a mesh.
inline DecimatedMesh RefinedMesh(const MeshView& view, CollapsedSurface& surface,
                                 const PipelineStages& stages, int threads, const StageProgress& progress)
{
    if (!stages.refine || surface.simplified.FaceCount() == 0) return ResultOf(view, surface, stages.bound);
    std::optional<DecimatedMesh> before;
    if (stages.bound) before = ResultOf(view, surface, stages.bound);
    RefinementParameters refinement;
    refinement.threads = threads;
    refinement.progress = progress.Part(stages.collapseEnds, stages.repairBegins);
    refinement.flip = !before; // moves can be taken back one by one
    if (surface.wedges) surface.simplified.wedges = &*surface.wedges;
    Refine(surface.original, surface.simplified, surface.root, refinement);
    DecimatedMesh mesh = ResultOf(view, surface, stages.bound);
    if (before) stages.bound->TakeBack(mesh, *before);
    return mesh;
}

inline void RepairMesh(const MeshView& view, const FaceTree& tree, DecimatedMesh& mesh, Boundary boundary,
                       BoundKeeper* bound, int threads, const StageProgress& progress)
{
    std::optional<DecimatedMesh> before;
    if (bound) before = mesh;
    RepairFolds(view, tree, mesh, boundary, threads, progress);
    if (!bound) return;
    bound->Round(mesh);
    bound->TakeBackAll(mesh, *before);
}

/// What can be told of the attributes without a measurement. \pre the mesh has wedges and values
inline AttributeReport AttributeCounts(const MeshView& view, const DecimatedMesh& mesh,
                                       const DecimationReport& counts, std::size_t targetFaces)
{
    AttributeReport report;
    report.turnedFaces = CountTurnedFaces(view, mesh);
    for (const std::uint32_t chart : mesh.wedges->inputChart)
        if (chart != kNone) report.charts = std::max<std::size_t>(report.charts, std::size_t{chart} + 1);
    if (counts.stopReason == StopReason::Seams) report.heldFaces = counts.faces - targetFaces;
    return report;
}

/// The way from a mesh to its simplification, the same for every collapse:
///
///     descriptor and weights -> collapse -> refinement -> fold repair -> report
///
/// \param collapse called as collapse(view, KeptForLater, StageProgress), returns a CollapsedSurface. It
///        computes the descriptor that guides it and hands it on.
/// \pre CheckParameters and CheckMesh pass
template <class Collapse>
Simplification RunPipeline(const MeshView& view, const DecimationParameters& parameters,
                           const PipelineStages& stages, const Collapse& collapse)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const int threads = ResolveThreads(parameters.threads);
    const StageProgress progress(parameters.progress);
    Simplification result;
    try {
        std::vector<std::uint32_t> faceOrder;
        std::vector<float> descriptor;
        CollapseTrace trace;
        {
            const KeptForLater kept{stages.refine, parameters.measureError};
            CollapsedSurface surface = collapse(view, kept, progress.Part(0, stages.collapseEnds));
            result.mesh = RefinedMesh(view, surface, stages, threads, progress);
            trace = std::move(surface.trace);
            faceOrder = std::move(surface.faceOrder);
            descriptor = std::move(surface.descriptor);
        }
        std::optional<FaceTree> built;
        if (!stages.bound) built = TreeOf(view, result.mesh, faceOrder, threads);
        const FaceTree* const tree = stages.bound ? stages.bound->task.tree.get() : built ? &*built : nullptr;
        if (stages.repairFolds && tree)
            RepairMesh(view, *tree, result.mesh, parameters.boundary, stages.bound, threads,
                       progress.Part(stages.repairBegins, 100));
        if (result.mesh.wedges && tree) AttributeTransfer(view, *tree, result.mesh, threads).Run(faceOrder);
        if (result.mesh.wedges) WriteCornerValues(result.mesh);
        result.report = CountsOf(view, result.mesh, parameters.targetFaces);
        if (result.mesh.wedges)
            result.report.attributes =
                AttributeCounts(view, result.mesh, result.report, parameters.targetFaces);
        if (stages.bound) result.report.certifiedError = stages.bound->CertifiedError();
        result.report.trace = std::move(trace);
        result.report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (parameters.measureError && tree) {
            if (descriptor.empty()) {
                const std::vector<double> values = LaplacianDescriptor(view, threads);
                descriptor.assign(values.begin(), values.end());
            }
            if (result.mesh.wedges)
                AttributeMeasure(view, *tree, result.mesh, threads).Measure(*result.report.attributes);
            result.report.distances =
                MeasureDistances(view, *tree, result.mesh, descriptor, kDistanceSamples, threads);
        }
        result.mesh.wedges.reset();
    } catch (const Cancelled&) {
        result = {};
        result.mesh.stopReason = result.report.stopReason = StopReason::Cancelled;
        result.report.facesBefore = result.report.faces = view.faceCount;
        result.report.vertices = view.vertexCount;
    }
    return result;
}

/// CollapseEngine as the first stage of the pipeline.
struct SweepCollapse {
    const DecimationParameters& parameters;
    BoundKeeper* bound = nullptr;

    CollapsedSurface operator()(const MeshView& view, KeptForLater kept, StageProgress progress) const
    {
        if (!bound) return Run(view, kept, std::move(progress));
        kept.bound = &bound->task;
        for (int run = 0;; ++run) { // again, more careful, where the certificate fails
            constexpr int kRuns = 5;
            CollapsedSurface surface = Run(view, kept, progress.Part(20 * run, 20 * run + 20));
            if (bound->Accepts(surface.coveredBy, ResultOf(view, surface, bound)) || run + 1 == kRuns)
                return surface;
        }
    }

  private:
    CollapsedSurface Run(const MeshView& view, KeptForLater kept, StageProgress progress) const
    {
        CollapseEngine engine(view, parameters, kept, std::move(progress));
        engine.Collapse(parameters.targetFaces);
        return std::move(engine).Extract();
    }
};

/// The sweep engine from a mesh to its report.
inline Simplification RunSweeps(const MeshView& view, const DecimationParameters& parameters)
{
    PipelineStages stages;
    stages.refine = parameters.effort != Effort::Fast;
    if (!stages.refine) stages.collapseEnds = stages.repairBegins;
    std::optional<BoundKeeper> bound;
    if (parameters.maxError > 0)
        stages.bound = &bound.emplace(view, parameters.maxError, ResolveThreads(parameters.threads));
    return RunPipeline(view, parameters, stages, SweepCollapse{parameters, stages.bound});
}

/// Simplifies a mesh of plain arrays, which stays as it is. The collapse is that of CollapseEngine.
///
///     vcg_ext::MeshView view;               // points to the caller's arrays
///     vcg_ext::DecimationParameters parameters;
///     parameters.targetFaces = 1000;
///     const auto [mesh, report] = vcg_ext::Simplify(view, parameters);
///
/// \throws std::invalid_argument as CheckParameters and CheckMesh, and where order or effort need VCG's
///         queue, which only vcg_ext/decimate.h has; std::length_error for 2^29 faces and more;
///         std::bad_alloc
/// \pre indices of the view are below its vertexCount
inline Simplification Simplify(const MeshView& view, const DecimationParameters& parameters)
{
    CheckParameters(parameters);
    CheckMesh(view);
    if (parameters.order == Order::Strict || parameters.effort == Effort::Best)
        throw std::invalid_argument("order = strict and effort = best need vcg_ext/decimate.h");
    return RunSweeps(view, parameters);
}

} // namespace vcg_ext
