// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include "analytic_meshes.h"

/// VCG meshes of both scalars, plain and with optional components, made from the analytic ones.
namespace test_meshes
{

class FloatVertex;
class FloatFace;
struct FloatTypes : vcg::UsedTypes<vcg::Use<FloatVertex>::AsVertexType, vcg::Use<FloatFace>::AsFaceType> {
};
class FloatVertex
    : public vcg::Vertex<FloatTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::Qualityf,
                         vcg::vertex::Mark, vcg::vertex::VFAdj, vcg::vertex::BitFlags>
{
};
class FloatFace : public vcg::Face<FloatTypes, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::FFAdj,
                                   vcg::face::VFAdj, vcg::face::BitFlags>
{
};
/// Single precision, as in MeshLab.
class FloatMesh : public vcg::tri::TriMesh<std::vector<FloatVertex>, std::vector<FloatFace>>
{
};

class DoubleVertex;
class DoubleFace;
struct DoubleTypes : vcg::UsedTypes<vcg::Use<DoubleVertex>::AsVertexType, vcg::Use<DoubleFace>::AsFaceType> {
};
class DoubleVertex
    : public vcg::Vertex<DoubleTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::Qualityd,
                         vcg::vertex::Mark, vcg::vertex::VFAdj, vcg::vertex::BitFlags>
{
};
class DoubleFace : public vcg::Face<DoubleTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::FFAdj,
                                    vcg::face::VFAdj, vcg::face::BitFlags>
{
};
/// Double precision, as in pymeshlab.
class DoubleMesh : public vcg::tri::TriMesh<std::vector<DoubleVertex>, std::vector<DoubleFace>>
{
};

class OcfVertex;
class OcfFace;
struct OcfTypes : vcg::UsedTypes<vcg::Use<OcfVertex>::AsVertexType, vcg::Use<OcfFace>::AsFaceType> {
};
class OcfVertex : public vcg::Vertex<OcfTypes, vcg::vertex::InfoOcf, vcg::vertex::Coord3f,
                                     vcg::vertex::Normal3f, vcg::vertex::Qualityf, vcg::vertex::MarkOcf,
                                     vcg::vertex::VFAdjOcf, vcg::vertex::BitFlags>
{
};
class OcfFace : public vcg::Face<OcfTypes, vcg::face::InfoOcf, vcg::face::VertexRef, vcg::face::Normal3f,
                                 vcg::face::FFAdjOcf, vcg::face::VFAdjOcf, vcg::face::BitFlags>
{
};
/// Single precision with optional components, as MeshLab's own mesh; all of them are off at first.
class OcfMesh : public vcg::tri::TriMesh<vcg::vertex::vector_ocf<OcfVertex>, vcg::face::vector_ocf<OcfFace>>
{
};

/// Fills an empty \p mesh. Faux flags are set, nothing else is computed.
template <class Mesh>
void Fill(Mesh& mesh, const IndexedMesh& source)
{
    using Scalar = typename Mesh::ScalarType;
    auto vertex = vcg::tri::Allocator<Mesh>::AddVertices(mesh, source.points.size());
    for (const Point& p : source.points) {
        vertex->P() = typename Mesh::CoordType(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]),
                                               static_cast<Scalar>(p[2]));
        ++vertex;
    }
    auto face = vcg::tri::Allocator<Mesh>::AddFaces(mesh, source.triangles.size());
    for (std::size_t f = 0; f < source.triangles.size(); ++f, ++face)
        for (int k = 0; k < 3; ++k) {
            face->V(k) = &mesh.vert[source.triangles[f][static_cast<std::size_t>(k)]];
            if (!source.fauxEdges.empty() && (source.fauxEdges[f] >> k & 1)) face->SetF(k);
        }
}

/// What is left of \p mesh, compact, without its faux flags.
template <class Mesh>
IndexedMesh Arrays(const Mesh& mesh)
{
    IndexedMesh arrays;
    std::vector<std::size_t> newIndex(mesh.vert.size());
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        newIndex[v] = arrays.points.size();
        const auto& p = mesh.vert[v].cP();
        if (!mesh.vert[v].IsD())
            arrays.points.push_back(
                {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    for (const auto& face : mesh.face)
        if (!face.IsD())
            arrays.AddTriangle(newIndex[vcg::tri::Index(mesh, face.cV(0))],
                               newIndex[vcg::tri::Index(mesh, face.cV(1))],
                               newIndex[vcg::tri::Index(mesh, face.cV(2))]);
    return arrays;
}

} // namespace test_meshes
