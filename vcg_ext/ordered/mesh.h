// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/topology.h>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

class StrictVertex;
class StrictFace;
struct StrictTypes : vcg::UsedTypes<vcg::Use<StrictVertex>::AsVertexType, vcg::Use<StrictFace>::AsFaceType> {
};
class StrictVertex : public vcg::Vertex<StrictTypes, vcg::vertex::Coord3d, vcg::vertex::VFAdj,
                                        vcg::vertex::Mark, vcg::vertex::BitFlags>
{
};
class StrictFace : public vcg::Face<StrictTypes, vcg::face::VertexRef, vcg::face::VFAdj, vcg::face::BitFlags>
{
};
/// The mesh that DecimateStrict works on: double precision and nothing but what collapses need.
class StrictMesh : public vcg::tri::TriMesh<std::vector<StrictVertex>, std::vector<StrictFace>>
{
};

/// The outcome of DecimateStrict.
struct StrictDecimation {
    DecimatedMesh mesh;
    /// For every input vertex the vertex of the result that it became part of; kNoVertex where it has no
    /// face.
    std::vector<std::uint32_t> root;
    static constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;
};

namespace strict_detail
{

/// The input with all its vertices; faces that name a vertex twice are left out.
/// \param faceOrigin becomes the input face of every face of the mesh
inline void FillMesh(const MeshView& view, StrictMesh& mesh, std::vector<std::uint32_t>& faceOrigin)
{
    auto vertex = vcg::tri::Allocator<StrictMesh>::AddVertices(mesh, view.vertexCount);
    for (std::size_t v = 0; v < view.vertexCount; ++v, ++vertex) {
        const auto p = view.Position(v);
        vertex->P() = vcg::Point3d(p[0], p[1], p[2]);
    }
    for (std::size_t f = 0; f < view.faceCount; ++f) {
        const std::uint32_t* v = view.triangles + 3 * f;
        if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) faceOrigin.push_back(static_cast<std::uint32_t>(f));
    }
    auto face = vcg::tri::Allocator<StrictMesh>::AddFaces(mesh, faceOrigin.size());
    for (const std::uint32_t f : faceOrigin) {
        for (int k = 0; k < 3; ++k)
            face->V(k) = &mesh.vert[view.triangles[3 * f + static_cast<std::size_t>(k)]];
        ++face;
    }
    vcg::tri::UpdateTopology<StrictMesh>::VertexFace(mesh);
}

/// Vertices that must not move: those of the view and, where the border is locked, all on it.
inline std::vector<std::uint8_t> FixedVertices(const MeshView& view, StrictMesh& mesh, Boundary boundary)
{
    std::vector<std::uint8_t> fixed;
    if (view.fixedVertices != nullptr)
        fixed.assign(view.fixedVertices, view.fixedVertices + view.vertexCount);
    if (boundary != Boundary::Lock) return fixed;
    fixed.resize(view.vertexCount, 0);
    RingEdges<StrictMesh> ring(mesh);
    for (std::size_t v = 0; v < view.vertexCount; ++v)
        if (TouchesBorder<StrictMesh>(ring.Collect(mesh.vert[v]))) fixed[v] = 1;
    return fixed;
}

/// What is left, in input order.
template <class Method>
StrictDecimation Collect(const MeshView& view, const StrictMesh& mesh,
                         const std::vector<std::uint32_t>& faceOrigin, Method& method)
{
    StrictDecimation result;
    std::vector<std::uint32_t> place(view.vertexCount, StrictDecimation::kNoVertex);
    for (const StrictFace& face : mesh.face)
        for (int k = 0; k < 3 && !face.IsD(); ++k) place[vcg::tri::Index(mesh, face.cV(k))] = 0;
    for (std::size_t v = 0; v < view.vertexCount; ++v) {
        if (place[v] == StrictDecimation::kNoVertex) continue;
        place[v] = static_cast<std::uint32_t>(result.mesh.positions.size());
        const vcg::Point3d p = method.Position(v);
        result.mesh.positions.push_back(method.HasMoved(v) ? std::array<double, 3>{p[0], p[1], p[2]}
                                                           : view.Position(v));
        result.mesh.vertexOrigin.push_back(static_cast<std::uint32_t>(v));
    }
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
        const StrictFace& face = mesh.face[f];
        if (face.IsD()) continue;
        const auto corner = [&](int k) { return place[vcg::tri::Index(mesh, face.cV(k))]; };
        result.mesh.triangles.push_back({corner(0), corner(1), corner(2)});
        result.mesh.faceOrigin.push_back(faceOrigin[f]);
    }
    result.root.resize(view.vertexCount);
    for (std::size_t v = 0; v < view.vertexCount; ++v) result.root[v] = place[method.Root(v)];
    return result;
}

} // namespace strict_detail

} // namespace vcg_ext
