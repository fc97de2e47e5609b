// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/bound/bound_keeper.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/mesh/clean_input.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"

namespace vcg_ext
{

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
    if (!HasSoundFace(view))
        throw std::invalid_argument("all " + std::to_string(view.faceCount) +
                                    " faces are degenerate: each has the same vertex at two corners");
    if (const std::size_t bad = CountNonFinite(view))
        throw std::invalid_argument("the coordinates of " + std::to_string(bad) + " of " +
                                    std::to_string(view.vertexCount) + " vertices are not finite");
    if (view.attributes == nullptr) return;
    if (const std::size_t bad = CountNonFinite(*view.attributes, view.faceCount))
        throw std::invalid_argument("the attributes of " + std::to_string(bad) + " of " +
                                    std::to_string(view.faceCount) + " faces are not finite");
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

/// DecimationParameters::weldDistance in the mesh's unit of length.
inline double WeldDistance(const MeshView& view, const DecimationParameters& parameters)
{
    if (!(parameters.weldDistance > 0)) return 0;
    return parameters.weldDistance / 100 * kFrameDiagonal * FrameOf(view).unit;
}

/// Runs on what is left of a mesh when it has been cleaned, and names faces as the input does.
/// \param run called as run(view), returns a Simplification
/// \throws std::invalid_argument if no face is left
template <class Run>
Simplification OnCleanInput(const MeshView& view, const DecimationParameters& parameters, const Run& run)
{
    if (!parameters.cleanInput) return run(view);
    const CleanedInput clean(view, WeldDistance(view, parameters), parameters.threads);
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
