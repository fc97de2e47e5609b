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

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/bound/bound_keeper.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/refine/refine.h"
#include "vcg_ext/core/refine/renewed_origins.h"
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
    const double weld = parameters.weldDistance;
    if (!(weld >= 0 && weld <= 100))
        throw std::invalid_argument("weld_distance = " + std::to_string(weld) + " is outside [0, 100]");
    if (parameters.targetFaces < 1) throw std::invalid_argument("target_faces = 0 is less than 1");
    if (parameters.threads < 0)
        throw std::invalid_argument("threads = " + std::to_string(parameters.threads) + " is less than 0");
    if (!(parameters.costLimit >= 0)) throw std::invalid_argument("cost_limit is less than 0");
    if (!(parameters.descriptorScale >= 0)) throw std::invalid_argument("descriptor_scale is less than 0");
}

/// Checks that the view can be simplified. \throws std::invalid_argument that says what is wrong, with the
/// count
inline void CheckMesh(const MeshView& view)
{
    if (view.faceCount == 0) throw std::invalid_argument("the mesh has no faces");
    if (!HasSoundFace(view))
        throw std::invalid_argument("all " + std::to_string(view.faceCount) +
                                    " faces are degenerate: each has the same vertex at two corners");
    if (const std::size_t bad = CountNonFinite(view))
        throw std::invalid_argument("the coordinates of " + std::to_string(bad) + " of " +
                                    std::to_string(view.vertexCount) + " vertices are not finite");
}

/// What is done with a collapsed surface, and when: percent of the time, roughly.
struct PipelineStages {
    bool refine = true;
    bool exchange = false; ///< RefinementParameters::exchange; under a bound more passes of moves instead
    bool repairFolds = true;
    int collapseEnds = 52; ///< of the refinement there is none where it is equal to repairBegins
    int repairBegins = 95;
    BoundKeeper* bound = nullptr; ///< what the stages have to keep; null: no bound
    bool guardsCrossings = false; ///< the collapse can be run again, guarded where faces cross
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
inline DecimatedMesh ResultOf(const MeshView& view, const CollapsedSurface& surface)
{
    DecimatedMesh mesh = ToMesh(view, surface);
    RoundAsInput(view, mesh);
    return mesh;
}

/// Passes of moves for effort best where a bound has to hold: an exchange could not be taken back by itself.
constexpr int kBoundedSweeps = 8;

/// Refines the surface where that is asked for, and takes it as a mesh.
/// \param crossings where the collapse was guarded against them; null: it was not
inline DecimatedMesh RefinedMesh(const MeshView& view, CollapsedSurface& surface,
                                 const PipelineStages& stages, const CrossingKeeper* crossings, int threads,
                                 const StageProgress& progress)
{
    // Two who take moves back, each its own, might go round in circles.
    const bool refine = stages.refine && surface.simplified.FaceCount() > 0 && !(stages.bound && crossings);
    if (!refine) return ResultOf(view, surface);
    std::optional<DecimatedMesh> before; // moves can be taken back one by one, flips cannot
    if (stages.bound || crossings) before = ResultOf(view, surface);
    RefinementParameters refinement;
    refinement.threads = threads;
    refinement.progress = progress.Part(stages.collapseEnds, stages.repairBegins);
    refinement.flip = !before;
    refinement.exchange = stages.exchange && !before;
    if (stages.exchange && before) refinement.moveSweeps = kBoundedSweeps;
    const RefinementReport report = Refine(surface.original, surface.simplified, surface.root, refinement);
    RenameRenewed(view, report.renewed, surface);
    DecimatedMesh mesh = ResultOf(view, surface);
    if (stages.bound) stages.bound->TakeBack(mesh, *before);
    if (crossings) crossings->TakeBack(mesh, *before);
    return mesh;
}

inline void RepairMesh(const MeshView& view, const FaceTree& tree, DecimatedMesh& mesh, Boundary boundary,
                       BoundKeeper* bound, const CrossingKeeper* crossings, int threads,
                       const StageProgress& progress)
{
    std::optional<DecimatedMesh> before;
    if (bound || crossings) before = mesh;
    RepairFolds(view, tree, mesh, boundary, threads, progress);
    RoundAsInput(view, mesh);
    if (crossings) crossings->TakeBackAll(mesh, *before);
    if (bound) bound->TakeBackAll(mesh, *before);
}

/// The stages up to fold repair, and what they share.
template <class Collapse>
class PipelineRun
{
    const MeshView& view_;
    const DecimationParameters& parameters_;
    const PipelineStages& stages_;
    const Collapse& collapse_;
    int threads_;
    std::optional<FaceTree> built_;
    std::vector<std::uint32_t> faceOrder_;
    std::vector<float> descriptor_; ///< of the input's vertices; may be empty

  public:
    CollapseTrace trace;

    PipelineRun(const MeshView& view, const DecimationParameters& parameters, const PipelineStages& stages,
                const Collapse& collapse, int threads)
        : view_(view), parameters_(parameters), stages_(stages), collapse_(collapse), threads_(threads)
    {
    }

    /// Of the original's faces; null where no face is left.
    const FaceTree* Tree() const
    {
        return stages_.bound ? stages_.bound->task.tree.get() : built_ ? &*built_ : nullptr;
    }

    /// \param keeper guards the collapse if it has a reason to; null: nobody does
    DecimatedMesh Run(const CrossingKeeper* keeper, const StageProgress& progress)
    {
        const CrossingKeeper* const guard = keeper && keeper->Guarded() ? keeper : nullptr;
        DecimatedMesh mesh = CollapsedAndRefined(guard, progress);
        if (!stages_.bound && !built_) built_ = TreeOf(view_, mesh, faceOrder_, threads_);
        if (stages_.repairFolds && Tree())
            RepairMesh(view_, *Tree(), mesh, parameters_.boundary, stages_.bound, guard, threads_,
                       progress.Part(stages_.repairBegins, 100));
        return mesh;
    }

    /// \pre there is a tree
    DistanceReport Measure(const DecimatedMesh& mesh)
    {
        if (descriptor_.empty()) {
            const std::vector<double> values = LaplacianDescriptor(view_, threads_);
            descriptor_.assign(values.begin(), values.end());
        }
        return MeasureDistances(view_, *Tree(), mesh, descriptor_, kDistanceSamples, threads_);
    }

  private:
    DecimatedMesh CollapsedAndRefined(const CrossingKeeper* guard, const StageProgress& progress)
    {
        KeptForLater kept{stages_.refine, parameters_.measureError};
        if (guard) kept.guarded = guard->Guarded();
        CollapsedSurface surface = collapse_(view_, kept, progress.Part(0, stages_.collapseEnds));
        DecimatedMesh mesh = RefinedMesh(view_, surface, stages_, guard, threads_, progress);
        trace = std::move(surface.trace);
        faceOrder_ = std::move(surface.faceOrder);
        descriptor_ = std::move(surface.descriptor);
        return mesh;
    }
};

/// Runs the stages, and again, guarded where faces cross, until no more of them cross than before.
template <class Collapse>
DecimatedMesh RunWithoutCrossings(PipelineRun<Collapse>& run, const PipelineStages& stages,
                                  CrossingKeeper& keeper, DecimationReport& report,
                                  const StageProgress& progress)
{
    constexpr int kRuns = 4; // the last of them is guarded everywhere
    for (int i = 0;; ++i) {
        DecimatedMesh mesh = run.Run(&keeper, i == 0 ? progress : progress.Part(99, 100));
        const std::vector<CrossingPair> crossings = keeper.Find(mesh);
        report.selfIntersections = crossings.size();
        const bool done = mesh.triangles.empty() || keeper.Allows(crossings.size(), *run.Tree());
        report.selfIntersectionsBefore = keeper.Before();
        if (done || i + 1 == kRuns || !stages.guardsCrossings) return mesh;
        keeper.Guard(crossings, mesh, *run.Tree(), i + 2 == kRuns);
    }
}

/// The way from a mesh to its simplification, the same for every collapse:
///
///     descriptor and weights -> collapse -> refinement -> fold repair -> crossings -> report
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
    DecimationReport& report = result.report;
    try {
        PipelineRun<Collapse> run(view, parameters, stages, collapse, threads);
        DecimationReport found;
        CrossingKeeper keeper(view, threads);
        result.mesh = parameters.avoidSelfIntersections
                          ? RunWithoutCrossings(run, stages, keeper, found, progress)
                          : run.Run(nullptr, progress);
        report = CountsOf(view, result.mesh, parameters.targetFaces);
        report.selfIntersections = found.selfIntersections;
        report.selfIntersectionsBefore = found.selfIntersectionsBefore;
        if (stages.bound) report.certifiedError = stages.bound->CertifiedError();
        report.trace = std::move(run.trace);
        report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (parameters.measureError && run.Tree()) report.distances = run.Measure(result.mesh);
    } catch (const Cancelled&) {
        result = {};
        result.mesh.stopReason = report.stopReason = StopReason::Cancelled;
        report.facesBefore = report.faces = view.faceCount;
        report.vertices = view.vertexCount;
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
            if (bound->Accepts(surface.coveredBy, ResultOf(view, surface)) || run + 1 == kRuns)
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

inline PipelineStages StagesOf(Effort effort)
{
    PipelineStages stages;
    stages.refine = effort != Effort::Fast;
    stages.exchange = effort == Effort::Best;
    return stages;
}

/// Runs on what is left of a mesh when it has been cleaned, and names faces as the input does.
/// \param run called as run(view), returns a Simplification
/// \throws std::invalid_argument if no face is left
template <class Run>
Simplification OnCleanInput(const MeshView& view, const DecimationParameters& parameters, const Run& run)
{
    if (!parameters.cleanInput) return run(view);
    const double distance =
        parameters.weldDistance > 0 ? parameters.weldDistance / 100 * kFrameDiagonal * FrameOf(view).unit : 0;
    const CleanedInput clean(view, distance, parameters.threads);
    if (clean.View().faceCount == 0)
        throw std::invalid_argument("weld_distance = " + std::to_string(parameters.weldDistance) +
                                    " leaves no face: every one has two corners that are welded");
    Simplification result = run(clean.View());
    for (std::uint32_t& face : result.mesh.faceOrigin) face = clean.FaceOrigin(face);
    result.report.facesBefore = view.faceCount;
    if (result.report.stopReason == StopReason::Cancelled)
        result.report.faces = view.faceCount;
    else
        result.report.cleaning = clean.Report();
    return result;
}

/// The sweep engine from a mesh to its report.
inline Simplification RunSweeps(const MeshView& view, const DecimationParameters& parameters)
{
    PipelineStages stages = StagesOf(parameters.effort);
    stages.guardsCrossings = true;
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
/// \throws std::invalid_argument as CheckParameters and CheckMesh, and where the order needs VCG's queue,
///         which only vcg_ext/decimate.h has; std::length_error for 2^29 faces and more;
///         std::bad_alloc
/// \pre indices of the view are below its vertexCount
inline Simplification Simplify(const MeshView& view, const DecimationParameters& parameters)
{
    CheckParameters(parameters);
    CheckMesh(view);
    if (parameters.order == Order::Strict)
        throw std::invalid_argument("order = strict needs vcg_ext/decimate.h");
    return OnCleanInput(view, parameters, [&](const MeshView& mesh) { return RunSweeps(mesh, parameters); });
}

} // namespace vcg_ext
