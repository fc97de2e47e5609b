// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/apply_decimation.h"
#include "vcg_ext/core/mesh/decimation_types.h"
#include "vcg_ext/descriptors.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/mesh/edge_counts.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/core/refine/refine_decimated.h"
#include "vcg_ext/ordered/decimate.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/repair/repair_folds.h"

namespace vcg_ext
{

/// What the decimation of a VCG mesh needs beside the parameters of the collapse.
struct MeshDecimationParameters : DecimationParameters {
    bool selectedOnly = false;   ///< faces that are not selected keep their vertices and stay
    bool measureError = true;    ///< fill DecimationReport::distances
    std::vector<float> guidance; ///< descriptor in [0, 1], one a mesh.vert element; empty: the Laplacian one
};

/// What was done. "Target not reached" is a report, not an error.
struct DecimationReport {
    std::size_t facesBefore = 0;
    std::size_t faces = 0;
    std::size_t vertices = 0;
    bool targetReached = false;
    StopReason stopReason = StopReason::Target;
    std::optional<DistanceReport> distances;
    EdgeCounts edges;
    double seconds = 0; ///< wall time of collapse, refinement and mending, without the measurement
};

struct Decimation {
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
    if (parameters.targetFaces < 1) throw std::invalid_argument("target_faces = 0 is below 1");
    if (parameters.threads < 0)
        throw std::invalid_argument("threads = " + std::to_string(parameters.threads) + " is below 0");
}

/// Checks that the view can be decimated. \throws std::invalid_argument that says what is wrong, with the
/// count
inline void CheckMesh(const MeshView& view)
{
    if (view.faceCount == 0) throw std::invalid_argument("the mesh has no faces");
    if (const std::size_t bad = CountNonFinite(view))
        throw std::invalid_argument("the mesh has " + std::to_string(bad) +
                                    " vertices with coordinates that are not finite numbers");
}

/// The strict order of collapses and, unless the effort is Fast, the refinement.
inline DecimatedMesh DecimateStrictly(const MeshView& view, const DecimationParameters& parameters)
{
    constexpr int kCollapsePart = 80; // of the time, roughly
    const bool refined = parameters.effort != Effort::Fast;
    DecimationParameters part = parameters;
    if (refined) part.progress = ProgressPart(parameters.progress, 0, kCollapsePart);
    OrderedDecimation result = DecimateOrdered(view, part);
    if (!refined || result.mesh.stopReason == StopReason::Cancelled) return std::move(result.mesh);
    part.progress = ProgressPart(parameters.progress, kCollapsePart, 100);
    if (!RefineDecimated(view, result.mesh, result.root, part))
        result.mesh.stopReason = StopReason::Cancelled;
    return std::move(result.mesh);
}

/// Collapse, refinement and the mending of folded faces, by the order asked for. Effort Best measures what
/// every collapse would change, which only the strict order can do: it is strict whatever the order asked
/// for. \pre CheckParameters and CheckMesh pass
inline DecimatedMesh Decimate(const MeshView& view, const DecimationParameters& parameters)
{
    constexpr int kUnfoldingPart = 95; // begins there, roughly
    const bool strict = parameters.order == Order::Strict || parameters.effort == Effort::Best;
    DecimationParameters part = parameters;
    part.progress = ProgressPart(parameters.progress, 0, kUnfoldingPart);
    DecimatedMesh mesh = strict ? DecimateStrictly(view, part) : DecimateSweeps(view, part);
    if (mesh.stopReason == StopReason::Cancelled) return mesh;
    const Progress progress = ProgressPart(parameters.progress, kUnfoldingPart, 100);
    if (UnfoldFaces(view, mesh, parameters.boundary, ResolveThreads(parameters.threads), progress).cancelled)
        mesh.stopReason = StopReason::Cancelled;
    return mesh;
}

/// What there is to say about a result, without the time that it took.
inline DecimationReport ReportOn(const MeshView& view, const DecimatedMesh& result, std::size_t targetFaces,
                                 bool measureError, int threads)
{
    DecimationReport report;
    report.facesBefore = view.faceCount;
    report.faces = result.triangles.size();
    report.vertices = result.positions.size();
    report.stopReason = result.stopReason;
    report.targetReached = report.faces <= targetFaces;
    if (report.stopReason == StopReason::Cancelled) return report;
    report.edges = CountEdges(report.faces, [&](std::size_t f) { return result.triangles[f]; });
    if (measureError && report.faces > 0) {
        const auto descriptor = ComputeDescriptor(view, Descriptor::Laplacian, threads);
        report.distances = MeasureDistances(view, result, descriptor, 100000, threads);
    }
    return report;
}

/// Decimates a VCG mesh without changing it: the result is a value, applied by ApplyDecimation.
///
/// \param mesh any VCG triangle mesh, float or double; deleted elements, unreferenced vertices, several
///        components, borders and non-manifold edges are welcome
/// \throws std::invalid_argument as CheckParameters and CheckMesh
template <class Mesh>
Decimation Decimate(const Mesh& mesh, const MeshDecimationParameters& parameters)
{
    using Clock = std::chrono::steady_clock;
    CheckParameters(parameters);
    const MeshArrays<Mesh> arrays(mesh);
    MeshView view = arrays.View();
    CheckMesh(view);
    std::vector<std::uint8_t> outside;
    if (parameters.selectedOnly) {
        outside = arrays.OutsideSelection(mesh);
        view.fixedVertices = outside.data();
    }
    if (!parameters.guidance.empty()) view.guidance = parameters.guidance.data();

    Decimation result;
    const auto start = Clock::now();
    result.mesh = Decimate(view, static_cast<const DecimationParameters&>(parameters));
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.report =
        ReportOn(view, result.mesh, parameters.targetFaces, parameters.measureError, parameters.threads);
    result.report.seconds = seconds;
    return result;
}

} // namespace vcg_ext
