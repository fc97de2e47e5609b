// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "array_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/descriptor/one_ring_descriptors.h"
#include "vcg_ext/core/descriptor/rescale.h"

namespace array_library
{
namespace
{

using Mesh = laplacian_simplify_mesh;
using Parameters = laplacian_simplify_parameters;

/// Coordinates beyond this are refused, as the filters refuse them.
constexpr double kMaxCoordinate = 1e18;

std::invalid_argument BadIndices(std::size_t bad, std::size_t first, const Mesh& mesh)
{
    return std::invalid_argument("the vertex indices of " + std::to_string(bad) + " of " +
                                 std::to_string(mesh.face_count) + " faces are outside [0, " +
                                 std::to_string(mesh.vertex_count) + "); the first of them is face " +
                                 std::to_string(first));
}

/// Checks every index and marks the vertices that are on faces.
template <class Index>
void CheckFaces(const Mesh& mesh, Input& input)
{
    const auto* indices = static_cast<const Index*>(mesh.faces);
    input.onFace.assign(mesh.vertex_count, 0);
    std::size_t bad = 0, first = 0;
    for (std::size_t f = 0; f < mesh.face_count; ++f) {
        const Index* corners = indices + 3 * f;
        if (corners[0] < mesh.vertex_count && corners[1] < mesh.vertex_count &&
            corners[2] < mesh.vertex_count)
            for (std::size_t k = 0; k < 3; ++k) input.onFace[corners[k]] = 1;
        else if (bad++ == 0)
            first = f;
    }
    if (bad > 0) throw BadIndices(bad, first, mesh);
}

void CheckPositions(const vcg_ext::MeshView& view)
{
    std::size_t bad = 0;
    for (std::size_t v = 0; v < view.vertexCount; ++v) {
        const std::array<double, 3> p = view.Position(v);
        const auto usable = [](double x) { return std::abs(x) <= kMaxCoordinate; }; // NaN is not
        bad += !(usable(p[0]) && usable(p[1]) && usable(p[2]));
    }
    if (bad > 0)
        throw std::invalid_argument("the coordinates of " + std::to_string(bad) + " of " +
                                    std::to_string(view.vertexCount) +
                                    " vertices are not finite or larger than 1e18");
}

/// Vertices of faces that are not selected may neither move nor go.
void FixOutsideSelection(const Mesh& mesh, Input& input)
{
    input.fixed.assign(mesh.vertex_count, 0);
    if (mesh.fixed_vertices) std::copy_n(mesh.fixed_vertices, mesh.vertex_count, input.fixed.begin());
    for (std::size_t f = 0; f < mesh.face_count; ++f) {
        if (mesh.selected_faces[f]) continue;
        for (std::size_t k = 0; k < 3; ++k) input.fixed[input.view.triangles[3 * f + k]] = 1;
    }
    input.view.fixedVertices = input.fixed.data();
}

void TakeFaces(const Mesh& mesh, Input& input)
{
    vcg_ext::MeshView& view = input.view;
    if (mesh.index_bytes == 8) {
        CheckFaces<std::uint64_t>(mesh, input);
        const auto* indices = static_cast<const std::uint64_t*>(mesh.faces);
        input.triangles.reserve(3 * mesh.face_count);
        for (std::size_t k = 0; k < 3 * mesh.face_count; ++k)
            input.triangles.push_back(static_cast<std::uint32_t>(indices[k]));
        view.triangles = input.triangles.data();
    } else {
        CheckFaces<std::uint32_t>(mesh, input);
        view.triangles = static_cast<const std::uint32_t*>(mesh.faces);
    }
    view.faceCount = mesh.face_count;
}

std::vector<double> DescriptorOf(const Mesh& mesh, const vcg_ext::MeshView& view,
                                 const Parameters& parameters)
{
    switch (parameters.descriptor) {
    case LAPLACIAN_SIMPLIFY_NORMALIZED_UMBRELLA:
        return vcg_ext::OneRingDescriptor<vcg_ext::NormalizedUmbrellaFold>(view, parameters.threads);
    case LAPLACIAN_SIMPLIFY_CURVATURE_ESTIMATION:
        return vcg_ext::OneRingDescriptor<vcg_ext::CurvatureEstimationFold>(view, parameters.threads);
    case LAPLACIAN_SIMPLIFY_STORED_QUALITY:
        if (mesh.stored_quality) return {mesh.stored_quality, mesh.stored_quality + mesh.vertex_count};
        break;
    default:
        break;
    }
    throw std::invalid_argument("descriptor = " + std::to_string(parameters.descriptor) +
                                " cannot be computed here");
}

/// Colors, texture coordinates and scalars at the corners, and labels of faces, read in place.
void TakeAttributes(const Mesh& mesh, Input& input)
{
    if (mesh.corner_values == nullptr && mesh.face_labels == nullptr) return;
    vcg_ext::CornerAttributes& attributes = input.attributes;
    attributes.values = mesh.corner_values;
    attributes.labels = mesh.face_labels;
    for (std::size_t k = 0; k < mesh.channel_count; ++k) {
        const std::int32_t kind = mesh.channel_kinds[k];
        if (kind < LAPLACIAN_SIMPLIFY_TEXTURE || kind > LAPLACIAN_SIMPLIFY_SCALAR)
            throw std::invalid_argument("channel " + std::to_string(k) + " is of the unknown kind " +
                                        std::to_string(kind));
        attributes.kinds.push_back(static_cast<vcg_ext::ChannelKind>(kind));
    }
    input.view.attributes = &attributes;
}

} // namespace

void Take(const Mesh& mesh, const Parameters& parameters, Input& input)
{
    vcg_ext::MeshView& view = input.view;
    if (mesh.face_count == 0)
        throw std::invalid_argument("the mesh has no faces (" + std::to_string(mesh.vertex_count) +
                                    " vertices)");
    view.positions = mesh.positions;
    view.doublePositions = mesh.double_positions != 0;
    view.positionStride = 3 * (view.doublePositions ? sizeof(double) : sizeof(float));
    view.vertexCount = mesh.vertex_count;
    view.fixedVertices = mesh.fixed_vertices;
    view.sharedSeams = mesh.shared_seams != 0;
    TakeFaces(mesh, input);
    CheckPositions(view);
    TakeAttributes(mesh, input);
    view.vertexNormals = mesh.vertex_normals;
    view.cornerNormals = mesh.corner_normals;
    if (mesh.selected_faces) FixOutsideSelection(mesh, input);
    if (parameters.descriptor == LAPLACIAN_SIMPLIFY_LAPLACIAN) return;
    for (const double value : vcg_ext::RescaledToUnit(DescriptorOf(mesh, view, parameters)))
        input.guidance.push_back(static_cast<float>(value));
    view.guidance = input.guidance.data();
}

} // namespace array_library
