// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/curvature.h>
#include <vcg/complex/algorithms/update/topology.h>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/one_ring.h"

namespace vcg_ext
{

/// One value a vertex, 0 where it has no faces or the value is not finite (faces without area).
struct DiscreteCurvatures {
    std::vector<double> mean;     ///< 1 / length, negative where the surface is hollow
    std::vector<double> gaussian; ///< 1 / length^2
};

namespace curvature_detail
{

/// Older VCG writes the curvatures to a vertex component, newer to the attributes "KH" and "KG".
template <class Base>
class CurvatureComponent : public Base
{
    double mean_ = 0, gaussian_ = 0;

  public:
    double& Kh() { return mean_; }
    double& Kg() { return gaussian_; }
    static bool HasCurvature() { return true; }
    static void Name(std::vector<std::string>& names)
    {
        names.emplace_back("Curvature");
        Base::Name(names);
    }
};

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {
};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::Normal3d, CurvatureComponent,
                                  vcg::vertex::BitFlags>
{
};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::FFAdj,
                              vcg::face::BitFlags>
{
};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>>
{
};

/// Copies the mesh into the frame (p - centre) / diagonal of its box, since VCG's curvature takes areas below
/// a fixed number for none. \returns the diagonal, 1 where it is 0
inline double CopyToUnitFrame(const MeshView& view, Mesh& mesh)
{
    auto vertex = vcg::tri::Allocator<Mesh>::AddVertices(mesh, view.vertexCount);
    vcg::Box3d box;
    for (std::size_t v = 0; v < view.vertexCount; ++v, ++vertex) {
        const std::array<double, 3> p = view.Position(v);
        vertex->P() = vcg::Point3d(p[0], p[1], p[2]);
    }
    for (std::size_t f = 0; f < view.faceCount; ++f) {
        const std::uint32_t* v = view.triangles + 3 * f;
        if (NamesAVertexTwice(v)) continue;
        vcg::tri::Allocator<Mesh>::AddFace(mesh, v[0], v[1], v[2]);
        for (std::size_t k = 0; k < 3; ++k) box.Add(mesh.vert[v[k]].P());
    }
    const double diagonal = !box.IsNull() && box.Diag() > 0 ? box.Diag() : 1;
    for (Vertex& v : mesh.vert) v.P() = (v.P() - box.Center()) / diagonal;
    return diagonal;
}

/// Edges with more than two faces become borders of all of them: VCG walks from border to border.
inline void CutNonManifoldEdges(Mesh& mesh)
{
    std::vector<std::pair<Face*, int>> cuts;
    for (Face& face : mesh.face)
        for (int k = 0; k < 3; ++k)
            if (!vcg::face::IsManifold(face, k)) cuts.emplace_back(&face, k);
    for (const auto& [face, k] : cuts) {
        face->FFp(k) = face;
        face->FFi(k) = static_cast<char>(k);
    }
}

} // namespace curvature_detail

/// Mean and Gaussian curvature by VCG's algorithm (Meyer et al. 2002), on a private copy with its topology.
inline DiscreteCurvatures ComputeDiscreteCurvatures(const MeshView& view)
{
    using curvature_detail::Mesh;
    using Attribute = Mesh::PerVertexAttributeHandle<double>;
    Mesh mesh;
    const double diagonal = curvature_detail::CopyToUnitFrame(view, mesh);
    vcg::tri::UpdateTopology<Mesh>::FaceFace(mesh);
    curvature_detail::CutNonManifoldEdges(mesh);
    vcg::tri::UpdateCurvature<Mesh>::MeanAndGaussian(mesh);

    Attribute mean = vcg::tri::Allocator<Mesh>::FindPerVertexAttribute<double>(mesh, "KH");
    Attribute gaussian = vcg::tri::Allocator<Mesh>::FindPerVertexAttribute<double>(mesh, "KG");
    const bool asAttributes = vcg::tri::Allocator<Mesh>::IsValidHandle(mesh, mean);
    const auto finite = [](double x) { return std::isfinite(x) ? x : 0; };
    DiscreteCurvatures curvatures;
    curvatures.mean.reserve(mesh.vert.size());
    curvatures.gaussian.reserve(mesh.vert.size());
    for (auto& vertex : mesh.vert) {
        curvatures.mean.push_back(finite((asAttributes ? mean[vertex] : vertex.Kh()) / diagonal));
        curvatures.gaussian.push_back(
            finite((asAttributes ? gaussian[vertex] : vertex.Kg()) / (diagonal * diagonal)));
    }
    for (const char* name : {"KH", "KG"}) // the mesh itself would leak them
        if (asAttributes) vcg::tri::Allocator<Mesh>::DeletePerVertexAttribute(mesh, name);
    return curvatures;
}

} // namespace vcg_ext
