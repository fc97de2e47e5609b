// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "result_checks.h"
#include "vcg_ext/core/levels.h"

namespace hostile
{
namespace
{

/// The caller's arrays, each of exactly its size, so that a sanitizer sees a step beyond.
struct Arrays {
    std::vector<double> positions;
    std::vector<float> floats;
    std::vector<std::uint32_t> faces;
    std::vector<std::uint64_t> longFaces;
    laplacian_simplify_mesh mesh{};

    explicit Arrays(const Case& given) : positions(given.positions), faces(given.faces)
    {
        for (const double x : positions) floats.push_back(Narrowed(x));
        for (const std::uint32_t v : faces) longFaces.push_back(v);
        const auto place = [](const auto& array) { return array.empty() ? nullptr : array.data(); };
        mesh.positions = given.singlePrecision ? static_cast<const void*>(floats.data()) : positions.data();
        mesh.double_positions = !given.singlePrecision;
        mesh.faces = given.longIndices ? static_cast<const void*>(longFaces.data()) : faces.data();
        mesh.index_bytes = given.longIndices ? 8 : 4;
        mesh.vertex_count = given.VertexCount();
        mesh.face_count = given.FaceCount();
        mesh.fixed_vertices = place(given.fixed);
        mesh.selected_faces = place(given.selected);
        mesh.stored_quality = place(given.quality);
        mesh.corner_values = place(given.corners);
        mesh.channel_kinds = place(given.channelKinds);
        mesh.channel_count = given.corners.empty() ? 0 : given.channelKinds.size();
        mesh.face_labels = place(given.labels);
    }

    /// The bits that the function was given, those of the other precision and width included.
    bool HaveBitsOf(const Arrays& other) const
    {
        const auto same = [](const auto& a, const auto& b) {
            return a.size() == b.size() &&
                   (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
        };
        return same(positions, other.positions) && same(floats, other.floats) && same(faces, other.faces) &&
               same(longFaces, other.longFaces);
    }
};

/// The C function's result, released at the end.
struct Result : laplacian_simplify_result {
    std::int32_t status;

    Result(const Arrays& arrays, laplacian_simplify_parameters parameters, int threads)
        : laplacian_simplify_result()
    {
        parameters.threads = threads;
        status = laplacian_simplify_arrays(&arrays.mesh, &parameters, this);
    }
    Result(const Result&) = delete;
    Result& operator=(const Result&) = delete;
    ~Result() { laplacian_simplify_release(this); }
};

bool SameBytes(const Result& a, const Result& b)
{
    const std::size_t vertices = 3 * a.vertex_count, faces = 3 * a.face_count;
    return a.status == b.status && a.vertex_count == b.vertex_count && a.face_count == b.face_count &&
           std::equal(a.positions, a.positions + vertices, b.positions) &&
           std::equal(a.faces, a.faces + faces, b.faces);
}

Ending ByTheFunction(const Case& given)
{
    const Arrays arrays(given);
    const Result result(arrays, given.parameters, 1);
    if (!arrays.HaveBitsOf(Arrays(given))) return {Ending::Fault, "the caller's arrays changed"};
    const std::string message = result.message;
    if (result.status == LAPLACIAN_SIMPLIFY_REFUSED)
        return message.empty() ? Ending{Ending::Fault, "refused without a word"}
                               : Ending{Ending::Refused, message};
    if (result.status != LAPLACIAN_SIMPLIFY_DONE) return {Ending::Fault, "failed: " + message};
    const Produced produced{result.positions, result.vertex_origin, result.vertex_count,
                            result.faces,     result.face_origin,   result.face_count};
    if (const std::string fault = FaultOfAMesh(given, produced); !fault.empty())
        return {Ending::Fault, fault};
    if (const std::string fault = FaultOfAReport(given, result); !fault.empty())
        return {Ending::Fault, fault};
    if (given.forEveryThreads && !SameBytes(result, Result(arrays, given.parameters, 3)))
        return {Ending::Fault, "3 threads give another result than 1"};
    return {};
}

/// The same levels for each number of faces: 100, 50 and 25 % of the target.
std::vector<vcg_ext::Level> LevelsOf(const Case& given)
{
    std::vector<vcg_ext::Level> levels;
    for (std::size_t i = 0; i < given.levelCount; ++i)
        levels.push_back(
            {std::max<std::size_t>(1, given.parameters.target_faces >> i), given.parameters.max_error});
    return levels;
}

vcg_ext::DecimationParameters CoreParametersOf(const laplacian_simplify_parameters& given)
{
    vcg_ext::DecimationParameters parameters;
    parameters.targetFaces = given.target_faces;
    parameters.featureWeight = given.feature_weight;
    parameters.effort = static_cast<vcg_ext::Effort>(given.effort % 3);
    parameters.boundary = static_cast<vcg_ext::Boundary>(given.boundary % 3);
    parameters.preserveTopology = given.preserve_topology != 0;
    parameters.avoidSelfIntersections = given.avoid_self_intersections != 0;
    parameters.cleanInput = given.clean_input != 0;
    parameters.weldDistance = given.weld_distance;
    parameters.measureError = given.measure_error != 0;
    parameters.threads = 1;
    return parameters;
}

/// The C++ core. Its preconditions are the caller's: indices in their range, coordinates that can be squared.
Ending ByTheCore(const Case& given)
{
    const Arrays arrays(given);
    for (const std::uint32_t v : given.faces)
        if (v >= given.VertexCount()) return {Ending::Refused, ""};
    if (HasTooLarge(given.positions)) return {Ending::Refused, ""};
    vcg_ext::MeshView view;
    view.positions = arrays.mesh.positions;
    view.doublePositions = !given.singlePrecision;
    view.positionStride = 3 * (given.singlePrecision ? sizeof(float) : sizeof(double));
    view.vertexCount = given.VertexCount();
    view.triangles = arrays.faces.data();
    view.faceCount = given.FaceCount();
    view.fixedVertices = arrays.mesh.fixed_vertices;
    try {
        const auto levels = SimplifyLevels(view, CoreParametersOf(given.parameters), LevelsOf(given));
        for (const vcg_ext::Simplification& level : levels) {
            const auto* positions =
                level.mesh.positions.empty() ? nullptr : level.mesh.positions.front().data();
            const auto* faces = level.mesh.triangles.empty() ? nullptr : level.mesh.triangles.front().data();
            const Produced produced{positions, level.mesh.vertexOrigin.data(), level.mesh.positions.size(),
                                    faces,     level.mesh.faceOrigin.data(),   level.mesh.triangles.size()};
            if (const std::string fault = FaultOfAMesh(given, produced); !fault.empty())
                return {Ending::Fault, fault};
        }
    } catch (const std::invalid_argument& refusal) {
        return {Ending::Refused, refusal.what()};
    } catch (const std::exception& failure) {
        return {Ending::Fault, failure.what()};
    }
    return {};
}

} // namespace

Ending CheckedRun(const Case& given)
{
    return given.levelCount > 0 ? ByTheCore(given) : ByTheFunction(given);
}

} // namespace hostile
