// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/attributes/attribute_report.h"
#include "vcg_ext/core/attributes/corner_values.h"
#include "vcg_ext/core/attributes/measure.h"
#include "vcg_ext/core/attributes/transfer.h"
#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/bound/bound_keeper.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/find_crossings.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"
#include "vcg_ext/core/refine/refine.h"
#include "vcg_ext/core/refine/renewed_origins.h"
#include "vcg_ext/core/repair/repair_crossings.h"
#include "vcg_ext/core/repair/repair_folds.h"

namespace vcg_ext
{

constexpr std::size_t kDistanceSamples = 100000; ///< at most, a side, beside all vertices

/// The surface as the caller will have it.
inline DecimatedMesh ResultOf(const MeshView& view, const CollapsedSurface& surface)
{
    DecimatedMesh mesh = ToMesh(view, surface);
    RoundAsInput(view, mesh);
    return mesh;
}

/// Passes of moves for effort best where a bound has to hold or the mesh has attributes: an exchange could
/// not be taken back by itself, and does not know of wedges.
constexpr int kSweepsWithoutExchanges = 8;

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
    refinement.exchange = stages.exchange && !before && !surface.wedges;
    if (stages.exchange && !refinement.exchange) refinement.moveSweeps = kSweepsWithoutExchanges;
    if (surface.wedges) surface.simplified.wedges = &*surface.wedges;
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
class PipelineRun
{
    const MeshView& view_;
    const DecimationParameters& parameters_;
    const PipelineStages& stages_;
    const CollapseStage& collapse_;
    int threads_;
    std::optional<FaceTree> built_;
    std::optional<FaceTree> resultTree_; ///< of the faces of the last result
    std::vector<std::uint32_t> faceOrder_;
    std::vector<float> descriptor_; ///< of the input's vertices; may be empty

  public:
    CollapseTrace trace;

    PipelineRun(const MeshView& view, const DecimationParameters& parameters, const PipelineStages& stages,
                const CollapseStage& collapse, int threads)
        : view_(view), parameters_(parameters), stages_(stages), collapse_(collapse), threads_(threads)
    {
    }

    const MeshView& View() const { return view_; }
    const DecimationParameters& Parameters() const { return parameters_; }
    const PipelineStages& Stages() const { return stages_; }

    /// Of the original's faces; null where no face is left.
    const FaceTree* Tree() const
    {
        return stages_.bound ? stages_.bound->task.tree.get() : built_ ? &*built_ : nullptr;
    }

    /// Pairs of faces of a result that cross; none where no face is left. Keeps its tree for the measurement.
    /// \pre nothing moves the faces of the mesh in memory until it is measured
    std::vector<CrossingPair> Crossings(const DecimatedMesh& mesh, const CrossingKeeper& keeper)
    {
        if (mesh.triangles.empty()) return {};
        BuildResultTree(mesh);
        std::vector<std::uint8_t> fixed;
        return keeper.Find(ViewOf(mesh, view_, fixed), *resultTree_);
    }

    /// \param keeper guards the collapse if it has a reason to; null: nobody does
    DecimatedMesh Run(const CrossingKeeper* keeper, const StageProgress& progress)
    {
        const CrossingKeeper* const guard = keeper && keeper->Guarded() ? keeper : nullptr;
        resultTree_.reset();
        DecimatedMesh mesh = CollapsedAndRefined(guard, progress);
        progress(stages_.repairBegins, "Repairing folds", stages_.crossingsBegin, 4);
        if (!stages_.bound && !built_) built_ = TreeOf(view_, mesh, faceOrder_, threads_);
        if (stages_.repairFolds && Tree())
            RepairMesh(view_, *Tree(), mesh, parameters_.boundary, stages_.bound, guard, threads_,
                       progress.Part(stages_.repairBegins, stages_.crossingsBegin));
        return mesh;
    }

    /// Repairs faces that cross until \p allowed pairs are left, where that is the order of the day.
    /// \param crossings of \p mesh \pre there is a tree
    void RepairCrossingsOf(DecimatedMesh& mesh, const std::vector<CrossingPair>& crossings,
                           std::size_t allowed, const StageProgress& progress) const
    {
        if (!stages_.repairFolds) return;
        std::optional<DecimatedMesh> before;
        if (stages_.bound) before = mesh;
        RepairCrossings(view_, *Tree(), mesh, crossings, allowed, parameters_.boundary, threads_, progress);
        RoundAsInput(view_, mesh);
        if (stages_.bound) stages_.bound->TakeBackAll(mesh, *before);
    }

    /// Gives the corners of a mesh with attributes their values. Nothing may change it after that.
    void TransferAttributes(DecimatedMesh& mesh) const
    {
        if (!mesh.wedges) return;
        if (Tree() && !mesh.triangles.empty() && mesh.wedges->channels.size() > 0)
            AttributeTransfer(view_, *Tree(), mesh, threads_).Run(faceOrder_);
        WriteCornerValues(mesh);
    }

    /// Distances and what the values of corners are off, into \p report. \pre there is a tree
    void Measure(const DecimatedMesh& mesh, DecimationReport& report, const StageProgress& progress)
    {
        const int attributesEnd = mesh.wedges && mesh.wedges->channels.size() > 0 ? 40 : 0;
        const StageProgress distances = progress.Part(attributesEnd, 100);
        constexpr int kLoops = 8;
        progress(0, "Measuring distances", attributesEnd, kLoops);
        if (descriptor_.empty()) {
            const std::vector<double> values = LaplacianDescriptor(view_, threads_);
            descriptor_.assign(values.begin(), values.end());
        }
        if (mesh.wedges && mesh.wedges->channels.size() > 0)
            AttributeMeasure(view_, *Tree(), mesh, threads_).Measure(*report.attributes);
        distances(0, "Measuring distances", 8);
        if (!resultTree_) BuildResultTree(mesh);
        report.distances = MeasureDistances(view_, *Tree(), mesh, *resultTree_, descriptor_, kDistanceSamples,
                                            threads_, distances);
    }

  private:
    void BuildResultTree(const DecimatedMesh& mesh)
    {
        std::vector<std::uint8_t> fixed;
        resultTree_.emplace(ViewOf(mesh, view_, fixed), Tree()->frame(), threads_);
    }

    DecimatedMesh CollapsedAndRefined(const CrossingKeeper* guard, const StageProgress& progress)
    {
        KeptForLater kept{stages_.refine, parameters_.measureError};
        if (guard) kept.guarded = guard->Guarded();
        CollapsedSurface surface = collapse_(view_, kept, progress.Part(0, stages_.collapseEnds));
        DecimatedMesh mesh = RefinedMesh(view_, surface, stages_, guard, threads_, progress);
        trace = std::move(surface.trace);
        faceOrder_ = std::move(surface.faceOrder);
        if (!surface.descriptor.empty()) descriptor_ = std::move(surface.descriptor); // or what was measured
        return mesh;
    }
};

/// Repairs faces of \p mesh that cross until no more do than before; those of the original are counted only
/// where that is not known without. \param crossings of \p mesh; afterwards those that are left
/// \return whether that was done
inline bool MendCrossings(PipelineRun& run, CrossingKeeper& keeper, DecimatedMesh& mesh,
                          std::vector<CrossingPair>& crossings, const StageProgress& progress)
{
    if (crossings.empty()) return true;
    const FaceTree& tree = *run.Tree();
    if (!AreFewCrossings(crossings.size(), mesh.triangles.size()))
        return keeper.Allows(crossings.size(), tree);
    std::size_t allowed = 0;
    if (keeper.Before() || keeper.OriginalCrossesNear(crossings, mesh, tree)) {
        if (keeper.Allows(crossings.size(), tree)) return true;
        allowed = *keeper.Before();
    }
    run.RepairCrossingsOf(mesh, crossings, allowed, progress);
    crossings = run.Crossings(mesh, keeper);
    return keeper.Allows(crossings.size(), tree);
}

/// Runs the stages, and again, guarded where faces cross that could not be repaired, until no more of them
/// cross than before.
inline DecimatedMesh RunWithoutCrossings(PipelineRun& run, CrossingKeeper& keeper, DecimationReport& report,
                                         const StageProgress& progress)
{
    constexpr int kRuns = 4; // the last of them is guarded everywhere
    for (int i = 0;; ++i) {
        const int begins = run.Stages().crossingsBegin, ends = run.Stages().reportBegins;
        const StageProgress last = progress.Part(ends - 1, ends);
        DecimatedMesh mesh = run.Run(&keeper, i == 0 ? progress : last);
        progress(i == 0 ? begins : ends - 1, "Counting self-intersections", ends - 1, 4);
        std::vector<CrossingPair> crossings = run.Crossings(mesh, keeper);
        const bool done = MendCrossings(run, keeper, mesh, crossings, last);
        report.selfIntersections = crossings.size();
        report.selfIntersectionsBefore = keeper.Before();
        if (done || i + 1 == kRuns || !run.Stages().guardsCrossings) return mesh;
        keeper.Guard(crossings, mesh, *run.Tree(), i + 2 == kRuns);
    }
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

/// One result, finished and reported.
inline Simplification ResultOf(PipelineRun& run, CrossingKeeper& keeper, std::size_t targetFaces,
                               const StageProgress& progress)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const MeshView& view = run.View();
    Simplification result;
    DecimationReport found, &report = result.report;
    result.mesh = run.Parameters().avoidSelfIntersections ? RunWithoutCrossings(run, keeper, found, progress)
                                                          : run.Run(nullptr, progress);
    const StageProgress last = progress.Part(run.Stages().reportBegins, 100);
    last(0, "Transferring attributes", 30, 8);
    run.TransferAttributes(result.mesh);
    last(30, "Counting edges", 32);
    report = CountsOf(view, result.mesh, targetFaces);
    report.selfIntersections = found.selfIntersections;
    report.selfIntersectionsBefore = found.selfIntersectionsBefore;
    if (result.mesh.wedges) report.attributes = AttributeCounts(view, result.mesh, report, targetFaces);
    if (run.Stages().bound) report.certifiedError = run.Stages().bound->CertifiedError();
    report.trace = std::move(run.trace);
    report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (run.Parameters().measureError && run.Tree()) run.Measure(result.mesh, report, last.Part(32, 100));
    result.mesh.wedges.reset();
    return result;
}

VCG_EXT_INLINE Simplification RunPipeline(const MeshView& view, const DecimationParameters& parameters,
                                          const PipelineStages& stages, const CollapseStage& collapse)
{
    const int threads = ResolveThreads(parameters.threads);
    RunProgress progress(parameters.progress);
    const LoopPoll poll([&](int percent) { progress.GoOn(percent); });
    try {
        PipelineRun run(view, parameters, stages, collapse, threads);
        CrossingKeeper keeper(view, threads);
        return ResultOf(run, keeper, parameters.targetFaces, StageProgress(std::ref(progress)));
    } catch (const Cancelled&) {
        return CancelledRun(view);
    }
}

} // namespace vcg_ext
