// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/allocate.h>
#include <vcg/complex/algorithms/update/topology.h>

#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/polygon_edges.h"
#include "vcg_ext/write_attributes.h"

namespace vcg_ext
{

namespace decimation_detail
{

/// Adjacency pointers would be remapped through deleted elements: dropped before, built again after.
template <class Mesh>
void ForgetAdjacency(Mesh& mesh)
{
    if (vcg::tri::HasVFAdjacency(mesh)) {
        for (auto& vertex : mesh.vert) vertex.VFClear();
        for (auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) face.VFClear(k);
    }
    if (vcg::tri::HasFFAdjacency(mesh)) {
        for (auto& face : mesh.face) {
            for (int k = 0; k < 3; ++k) {
                face.FFp(k) = nullptr;
                face.FFi(k) = 0;
            }
        }
    }
}

} // namespace decimation_detail

/// Puts a result into the mesh it was made from: survivors keep their flags, their selection and what the
/// layout does not name, everything else that was on a face goes; polygons stay where all of their faces
/// stayed as they were; the mesh is compact afterwards and adjacency is rebuilt where the mesh has it.
/// Normals of vertices and faces and the box are the caller's. \param dropUnreferenced vertices that were on
/// no face go, too \param layout of the result's corner values; where it names none, survivors keep all of
/// their attributes \pre mesh has not changed since Decimate
template <class Mesh>
void ApplyDecimation(Mesh& mesh, const DecimatedMesh& result, bool dropUnreferenced = false,
                     const AttributeLayout& layout = {})
{
    using Coord = typename Mesh::CoordType;
    using Scalar = typename Mesh::ScalarType;
    using Allocator = vcg::tri::Allocator<Mesh>;
    std::vector<std::uint32_t> live; // index in mesh.face of every face of the view
    std::vector<bool> wasUsed(mesh.vert.size()), staysUsed(mesh.vert.size());
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
        if (mesh.face[f].IsD()) continue;
        live.push_back(static_cast<std::uint32_t>(f));
        for (int k = 0; k < 3; ++k) wasUsed[vcg::tri::Index(mesh, mesh.face[f].cV(k))] = true;
    }
    decimation_detail::ForgetAdjacency(mesh);
    std::optional<AttributeWriter<Mesh>> attributes;
    if (!layout.attributes.empty() || layout.vertexTextures || !result.cornerSides.empty() ||
        vcg::tri::HasPerWedgeNormal(mesh))
        attributes.emplace(mesh, layout, result, live);
    for (std::size_t v = 0; v < result.positions.size(); ++v) {
        const auto& p = result.positions[v];
        mesh.vert[result.vertexOrigin[v]].P() =
            Coord(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2]));
        staysUsed[result.vertexOrigin[v]] = true;
    }
    std::size_t next = 0;
    for (std::size_t f = 0; f < live.size(); ++f) {
        auto& face = mesh.face[live[f]];
        if (next == result.faceOrigin.size() || result.faceOrigin[next] != f) {
            Allocator::DeleteFace(mesh, face);
            continue;
        }
        bool changed = false;
        for (int k = 0; k < 3; ++k) {
            auto* vertex =
                &mesh.vert[result.vertexOrigin[result.triangles[next][static_cast<std::size_t>(k)]]];
            changed |= face.V(k) != vertex;
            face.V(k) = vertex;
        }
        if (changed)
            for (int k = 0; k < 3; ++k) face.ClearF(k);
        ++next;
    }
    if (attributes) attributes->Write();
    for (std::size_t v = 0; v < wasUsed.size(); ++v)
        if ((wasUsed[v] || (dropUnreferenced && !mesh.vert[v].IsD())) && !staysUsed[v])
            Allocator::DeleteVertex(mesh, mesh.vert[v]);
    ClearFauxEdgesOutsidePolygons(mesh);
    Allocator::CompactEveryVector(mesh);
    if (vcg::tri::HasFFAdjacency(mesh)) vcg::tri::UpdateTopology<Mesh>::FaceFace(mesh);
    if (vcg::tri::HasVFAdjacency(mesh)) vcg::tri::UpdateTopology<Mesh>::VertexFace(mesh);
}

} // namespace vcg_ext
