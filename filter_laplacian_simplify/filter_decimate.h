// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "decimation_summary.h"
#include "error_as_quality.h"
#include "guidance.h"
#include "host.h"
#include "number_text.h"
#include "progress.h"
#include "stopwatch.h"
#include "values.h"
#include "vcg_ext/decimate.h"

namespace laplacian_simplify
{

/// The number of faces that targets refer to: the selected ones if only those are decimated.
/// \throws std::invalid_argument if only the selection should be decimated and no face is selected
inline std::size_t DecimatedFaces(const Values& values, const MeshFacts& facts)
{
    const bool selectedOnly = values.Boolean("selected_only");
    if (selectedOnly && facts.selectedFaces == 0)
        throw std::invalid_argument("selected_only = true, but no face is selected");
    return selectedOnly ? facts.selectedFaces : facts.faces;
}

/// Percent of a number of faces, rounded.
inline std::size_t PercentOf(std::size_t faces, double percent)
{
    return static_cast<std::size_t>(std::llround(percent / 100 * static_cast<double>(faces)));
}

/// The number of faces that the whole mesh should have. \throws std::invalid_argument as DecimatedFaces
inline std::size_t TargetFaces(const Values& values, const MeshFacts& facts)
{
    const std::size_t decimated = DecimatedFaces(values, facts);
    const double percent = values.Real("target_percent");
    const auto target = percent > 0 ? PercentOf(decimated, percent)
                                    : static_cast<std::size_t>(values.Integer("target_faces"));
    return facts.faces - decimated + std::max<std::size_t>(target, 1);
}

template <class Mesh>
bool AnyVertexIsSelected(const Mesh& mesh)
{
    return std::any_of(mesh.vert.begin(), mesh.vert.end(),
                       [](const auto& vertex) { return !vertex.IsD() && vertex.IsS(); });
}

/// Turns the vertex indices of \p result into those of a copy of \p mesh without deleted vertices.
template <class Mesh>
void RenumberForCompactCopy(const Mesh& mesh, vcg_ext::DecimatedMesh& result)
{
    std::vector<std::uint32_t> indexInCopy(mesh.vert.size());
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < mesh.vert.size(); ++v)
        if (!mesh.vert[v].IsD()) indexInCopy[v] = next++;
    for (std::uint32_t& origin : result.vertexOrigin) origin = indexInCopy[origin];
}

template <class Mesh>
vcg_ext::EdgeCounts EdgesOf(const Mesh& mesh)
{
    const vcg_ext::MeshArrays<Mesh> arrays(mesh);
    const vcg_ext::MeshView& view = arrays.View();
    return vcg_ext::CountEdges(view.faceCount, [&](std::size_t f) { return view.triangles + 3 * f; });
}

/// The report if the mesh already has no more faces than the target: nothing is done.
template <class Mesh>
vcg_ext::DecimationReport ReportUnchanged(const Mesh& mesh, bool measureError)
{
    vcg_ext::DecimationReport report;
    report.facesBefore = report.faces = static_cast<std::size_t>(mesh.fn);
    report.vertices = static_cast<std::size_t>(mesh.vn);
    report.targetReached = true;
    report.edges = EdgesOf(mesh);
    if (measureError) report.distances.emplace(); // the surfaces are identical: all distances are 0
    return report;
}

constexpr const char* kLayerSuffix = "_simplified";

/// Goes on with a copy of the current mesh in a new layer, with everything that it carries.
template <class Host>
void ContinueOnWholeCopy(Host& host, const std::string& layerSuffix)
{
    const auto& original = host.Mesh();
    host.ContinueOnCopy(layerSuffix);
    vcg_ext::CopyCustomAttributes(original, host.Mesh());
}

/// What a run has come to, before anything is changed.
struct Outcome {
    vcg_ext::DecimationReport report;
    std::optional<vcg_ext::MeshSimplification> result; ///< none: the mesh stays as it is
    std::optional<ErrorAsQuality> error;               ///< to be written, too
};

/// Writes a result to the current mesh, or to a copy of it in a new layer, and counts there what was not
/// known before. \param layerSuffix of the new layer's name; empty: to the current mesh
/// \return a line for the log, empty where there is nothing to say
template <class Host>
std::string Commit(Host& host, Outcome& outcome, const std::string& layerSuffix, bool dropUnreferenced)
{
    auto& result = outcome.result;
    if (!layerSuffix.empty()) {
        if (result) RenumberForCompactCopy(host.Mesh(), result->mesh);
        ContinueOnWholeCopy(host, layerSuffix);
    }
    const auto apply = [&] {
        if (!result) return;
        vcg_ext::ApplyDecimation(host.Mesh(), *result, dropUnreferenced);
        host.GeometryChanged();
    };
    std::string line;
    if (outcome.error)
        line = outcome.error->StoreAfter(apply, host);
    else
        apply();
    if (result) outcome.report.vertices = static_cast<std::size_t>(host.Mesh().vn); // with those of no face
    if (result && result->attributes.doubledVertices)
        outcome.report.edges = EdgesOf(host.Mesh()); // open where seams are doubled
    return line;
}

/// What a decimation filter is asked for besides its collapses.
struct DecimationWishes {
    bool measureError = false;
    bool newLayer = false;
    bool errorBound = false; ///< the report says what is proven
    bool cleanInput = false; ///< vertices of no face go
    bool errorAsQuality = false;
    int threads = 0;
};

/// Decimates and measures, without a change of the mesh. \param simplify as of DecimateCurrentMesh
template <class Mesh, class Simplify>
Outcome DecimateValue(const Mesh& mesh, std::size_t target, const DecimationWishes& wishes,
                      const vcg_ext::Progress& progress, const Simplify& simplify)
{
    Outcome outcome;
    if (target >= static_cast<std::size_t>(mesh.fn)) {
        outcome.report = ReportUnchanged(mesh, wishes.measureError);
        if (wishes.errorBound) outcome.report.certifiedError = 0;
    } else {
        outcome.result = simplify(target, progress);
        outcome.report = outcome.result->report;
    }
    if (outcome.report.stopReason == vcg_ext::StopReason::Cancelled) throw vcg_ext::Cancelled();
    if (wishes.errorAsQuality)
        outcome.error = VertexErrors<Mesh>(mesh, wishes.threads)
                            .Of(outcome.result ? &outcome.result->mesh : nullptr, progress);
    return outcome;
}

/// What is said of a mesh whose decimation was canceled.
template <class Mesh>
vcg_ext::DecimationReport ReportCancelled(const Mesh& mesh)
{
    vcg_ext::DecimationReport report;
    report.stopReason = vcg_ext::StopReason::Cancelled;
    report.facesBefore = report.faces = static_cast<std::size_t>(mesh.fn);
    report.vertices = static_cast<std::size_t>(mesh.vn);
    return report;
}

/// What every decimation filter does besides its collapses: target, progress, result, report and log.
/// \param simplify called with the number of faces to keep and the progress, returns a
///        vcg_ext::MeshSimplification; not called if the mesh has no more faces than that
template <class Host, class Simplify>
Report DecimateCurrentMesh(Host& host, const Values& values, const DecimationWishes& wishes,
                           const Simplify& simplify)
{
    const Stopwatch stopwatch;
    const std::size_t target = TargetFaces(values, FactsOf(host.Mesh()));
    ThrottledProgress progress([&](int percent, const char* stage) { return host.Progress(percent, stage); });
    Outcome outcome;
    vcg_ext::AttributeLayout layout;
    std::string errorLine;
    try {
        outcome = DecimateValue(host.Mesh(), target, wishes, std::ref(progress), simplify);
        if (outcome.result) layout = outcome.result->attributes;
        errorLine = Commit(host, outcome, wishes.newLayer ? kLayerSuffix : "", wishes.cleanInput);
    } catch (const vcg_ext::Cancelled&) {
        outcome.report = ReportCancelled(host.Mesh());
    }
    outcome.report.seconds = stopwatch.Seconds();
    for (const std::string& line : LogLines(outcome.report, target, wishes.errorBound, layout))
        host.Log(line);
    if (!errorLine.empty()) host.Log(errorLine);
    return ToReport(outcome.report, layout);
}

/// What the guided decimation is asked for, but for targets, progress and guidance.
/// \throws std::invalid_argument if values do not fit each other or the mesh
template <class Host>
vcg_ext::MeshDecimationParameters GuidedParameters(Host& host, const Values& values)
{
    vcg_ext::MeshDecimationParameters parameters;
    parameters.maxError = values.Real("max_error");
    parameters.featureWeight = values.Real("feature_weight");
    parameters.effort = values.Choice<vcg_ext::Effort>("effort");
    parameters.boundary = values.Choice<vcg_ext::Boundary>("boundary");
    parameters.preserveTopology = values.Boolean("preserve_topology");
    parameters.avoidSelfIntersections = values.Boolean("avoid_self_intersections");
    parameters.order = values.Choice<vcg_ext::Order>("order");
    parameters.threads = values.Integer("threads");
    parameters.selectedOnly = values.Boolean("selected_only");
    parameters.lockSelectedVertices = values.Boolean("lock_selected_vertices");
    if (parameters.lockSelectedVertices && !AnyVertexIsSelected(host.Mesh()))
        throw std::invalid_argument("lock_selected_vertices = true, but no vertex is selected");
    parameters.keepAttributes = values.Boolean("keep_attributes");
    parameters.keepQuality = !IsStoredQuality(values.Integer("descriptor")); // it guides as a descriptor
    parameters.attributeWeight = values.Real("attribute_weight");
    parameters.seams = values.Choice<vcg_ext::Seams>("seams");
    parameters.cleanInput = values.Boolean("clean_input");
    parameters.weldDistance = values.Real("weld_distance");
    parameters.measureError = values.Boolean("measure_error");
    if (parameters.maxError > 0 && parameters.order == vcg_ext::Order::Strict)
        throw std::invalid_argument("max_error = " + NumberText(parameters.maxError) + " needs order sweeps");
    return parameters;
}

/// Filter "Simplification: Laplacian-Guided Quadric Edge Collapse".
template <class Host>
Report ApplyGuidedDecimation(Host& host, const Values& values)
{
    vcg_ext::MeshDecimationParameters parameters = GuidedParameters(host, values);
    const DecimationWishes wishes{
        parameters.measureError, values.Boolean("new_layer"),        parameters.maxError > 0,
        parameters.cleanInput,   values.Boolean("error_as_quality"), parameters.threads};
    return DecimateCurrentMesh(host, values, wishes, [&](std::size_t target, vcg_ext::Progress progress) {
        using Mesh = typename Host::MeshType;
        parameters.targetFaces = target;
        parameters.progress = std::move(progress);
        parameters.guidance = Guidance(host.Mesh(), values.Integer("descriptor"), parameters.threads);
        return vcg_ext::Decimate<Mesh>(host.Mesh(), parameters);
    });
}

} // namespace laplacian_simplify
