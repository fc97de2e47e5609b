// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simplify_arrays.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "array_input.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/simplify.h"

namespace
{

using array_library::Input;
using Mesh = laplacian_simplify_mesh;
using Parameters = laplacian_simplify_parameters;
using Result = laplacian_simplify_result;

/// What the arrays of a result point to.
struct Storage {
    vcg_ext::DecimatedMesh mesh;
    std::vector<laplacian_simplify_step> steps;
    vcg_ext::AttributeReport attributes;
    std::vector<laplacian_simplify_texture> textures;
};

/// The \p value-th of \p count enumerators. \throws std::invalid_argument where there is none
template <class E>
E Choice(const char* name, std::int32_t value, std::int32_t count)
{
    if (value >= 0 && value < count) return static_cast<E>(value);
    throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + " is outside [0, " +
                                std::to_string(count - 1) + "]");
}

vcg_ext::DecimationParameters ToCore(const Parameters& given)
{
    vcg_ext::DecimationParameters parameters;
    parameters.targetFaces = given.target_faces;
    parameters.maxError = given.max_error;
    parameters.featureWeight = given.feature_weight;
    parameters.effort = Choice<vcg_ext::Effort>("effort", given.effort, 3);
    parameters.boundary = Choice<vcg_ext::Boundary>("boundary", given.boundary, 3);
    parameters.attributeWeight = given.attribute_weight;
    parameters.seams = Choice<vcg_ext::Seams>("seams", given.seams, 2);
    parameters.preserveTopology = given.preserve_topology != 0;
    parameters.avoidSelfIntersections = given.avoid_self_intersections != 0;
    parameters.cleanInput = given.clean_input != 0;
    parameters.weldDistance = given.weld_distance;
    parameters.measureError = given.measure_error != 0;
    parameters.threads = given.threads;
    parameters.costLimit = given.cost_limit;
    parameters.descriptorScale = given.descriptor_scale;
    if (given.progress)
        parameters.progress = [call = given.progress](int percent, const char* stage) {
            return call(percent, stage) != 0;
        };
    return parameters;
}

/// The mesh as it came: it has no more faces than are asked for.
vcg_ext::Simplification Unchanged(const vcg_ext::MeshView& view,
                                  const vcg_ext::DecimationParameters& parameters)
{
    vcg_ext::Simplification all;
    for (std::uint32_t v = 0; v < view.vertexCount; ++v) {
        all.mesh.positions.push_back(view.Position(v));
        all.mesh.vertexOrigin.push_back(v);
    }
    for (std::uint32_t f = 0; f < view.faceCount; ++f) {
        const std::uint32_t* corners = view.triangles + 3 * std::size_t{f};
        all.mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        all.mesh.faceOrigin.push_back(f);
    }
    all.report = vcg_ext::CountsOf(view, all.mesh, parameters.targetFaces);
    if (parameters.measureError) all.report.distances.emplace(); // the surfaces are identical
    if (parameters.maxError > 0) all.report.certifiedError = 0;
    return all;
}

/// Puts the vertices of no face back, at their places among the others.
void KeepLooseVertices(const Input& input, vcg_ext::DecimatedMesh& mesh)
{
    const auto loose =
        static_cast<std::size_t>(std::count(input.onFace.begin(), input.onFace.end(), std::uint8_t{0}));
    if (loose == 0) return;
    vcg_ext::DecimatedMesh all;
    std::vector<std::uint32_t> place(mesh.positions.size());
    std::size_t next = 0;
    const auto add = [&](std::uint32_t origin, const std::array<double, 3>& position) {
        all.positions.push_back(position);
        all.vertexOrigin.push_back(origin);
    };
    for (std::uint32_t v = 0; v < input.view.vertexCount; ++v) {
        const bool survives = next < mesh.vertexOrigin.size() && mesh.vertexOrigin[next] == v;
        if (survives) {
            place[next] = static_cast<std::uint32_t>(all.positions.size());
            add(v, mesh.positions[next++]);
        } else if (!input.onFace[v]) {
            add(v, input.view.Position(v));
        }
    }
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) corner = place[corner];
    mesh.positions = std::move(all.positions);
    mesh.vertexOrigin = std::move(all.vertexOrigin);
}

void Report(const vcg_ext::DecimationReport& report, Result& result)
{
    result.target_reached = report.targetReached;
    result.stop_reason = static_cast<std::int32_t>(report.stopReason);
    result.non_manifold_edges = report.edges.nonManifold;
    result.boundary_edges = report.edges.boundary;
    result.has_self_intersections = report.selfIntersections.has_value();
    result.self_intersections = report.selfIntersections.value_or(0);
    result.has_self_intersections_before = report.selfIntersectionsBefore.has_value();
    result.self_intersections_before = report.selfIntersectionsBefore.value_or(0);
    result.has_cleaning = report.cleaning.has_value();
    if (report.cleaning) {
        result.welded_vertices = report.cleaning->weldedVertices;
        result.dropped_faces = report.cleaning->DroppedFaces();
    }
    result.has_certificate = report.certifiedError.has_value();
    result.certified_error = report.certifiedError.value_or(0);
    result.has_distances = report.distances.has_value();
    if (!report.distances) return;
    result.hausdorff = report.distances->hausdorff;
    result.rms = report.distances->rms;
    result.feature_rms = report.distances->featureRms;
    result.folded = report.distances->folded;
}

/// What has become of the attributes. \p storage holds the lists
void ReportAttributes(vcg_ext::AttributeReport report, Storage& storage, Result& result)
{
    storage.attributes = std::move(report);
    const vcg_ext::AttributeReport& attributes = storage.attributes;
    for (const auto& texture : attributes.textures)
        storage.textures.push_back({texture.rms, texture.largest});
    result.has_attributes = 1;
    result.charts = attributes.charts;
    result.turned_faces = attributes.turnedFaces;
    result.held_faces = attributes.heldFaces;
    result.rms_count = attributes.rms.size();
    result.attribute_rms = attributes.rms.data();
    result.texture_count = storage.textures.size();
    result.textures = storage.textures.data();
}

void HandOver(vcg_ext::Simplification done, Result& result)
{
    auto storage = std::make_unique<Storage>();
    if (done.report.attributes) ReportAttributes(std::move(*done.report.attributes), *storage, result);
    for (const auto& step : done.report.trace.steps) storage->steps.push_back({step.cost, step.faces});
    storage->mesh = std::move(done.mesh);
    const vcg_ext::DecimatedMesh& mesh = storage->mesh;
    result.vertex_count = mesh.positions.size();
    result.face_count = mesh.triangles.size();
    if (result.vertex_count > 0) result.positions = mesh.positions.front().data();
    if (result.face_count > 0) result.faces = mesh.triangles.front().data();
    result.vertex_origin = mesh.vertexOrigin.data();
    result.face_origin = mesh.faceOrigin.data();
    if (!mesh.cornerValues.empty()) result.corner_values = mesh.cornerValues.data();
    if (!mesh.cornerSides.empty()) result.corner_sides = mesh.cornerSides.data();
    result.step_count = storage->steps.size();
    result.steps = storage->steps.data();
    result.descriptor_scale = done.report.trace.descriptorScale;
    result.storage = storage.release();
}

void Run(const Mesh& mesh, const Parameters& given, Result& result)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const vcg_ext::ThreadsOfRun threads; // they end with the run
    const vcg_ext::DecimationParameters parameters = ToCore(given);
    vcg_ext::CheckParameters(parameters);
    Input input;
    array_library::Take(mesh, given, input);
    vcg_ext::Simplification done = mesh.face_count <= parameters.targetFaces
                                       ? Unchanged(input.view, parameters)
                                       : vcg_ext::Simplify(input.view, parameters);
    Report(done.report, result);
    if (done.report.stopReason != vcg_ext::StopReason::Cancelled) {
        if (mesh.face_count > parameters.targetFaces && !parameters.cleanInput)
            KeepLooseVertices(input, done.mesh);
        HandOver(std::move(done), result);
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

std::int32_t Failure(Result& result, std::int32_t status, const char* message)
{
    std::strncpy(result.message, message, sizeof result.message - 1);
    return status;
}

} // namespace

std::int32_t laplacian_simplify_arrays(const Mesh* mesh, const Parameters* parameters, Result* result)
{
    *result = {};
    try {
        Run(*mesh, *parameters, *result);
        return LAPLACIAN_SIMPLIFY_DONE;
    } catch (const std::invalid_argument& error) {
        return Failure(*result, LAPLACIAN_SIMPLIFY_REFUSED, error.what());
    } catch (const std::length_error& error) {
        return Failure(*result, LAPLACIAN_SIMPLIFY_REFUSED, error.what());
    } catch (const std::bad_alloc&) {
        return Failure(*result, LAPLACIAN_SIMPLIFY_NO_MEMORY, "there is not enough memory");
    } catch (const std::exception& error) {
        return Failure(*result, LAPLACIAN_SIMPLIFY_FAILED, error.what());
    }
}

void laplacian_simplify_release(Result* result)
{
    delete static_cast<Storage*>(result->storage);
    *result = {};
}
