// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// Normals of a mesh as MeshView has them: of corners where the mesh has such, otherwise of vertices where
/// they count.
template <class Mesh>
class MeshNormals
{
    std::vector<float> ofVertices_, ofCorners_;

    template <class Normal>
    static void Add(const Normal& normal, std::vector<float>& to)
    {
        for (int k = 0; k < 3; ++k) to.push_back(static_cast<float>(normal[k]));
    }

  public:
    /// \param ofVertices those of vertices count: they are their author's, and vertices may be welded
    MeshNormals(const Mesh& mesh, bool ofVertices)
    {
        if (vcg::tri::HasPerWedgeNormal(mesh)) {
            for (const auto& face : mesh.face)
                for (int k = 0; k < 3 && !face.IsD(); ++k) Add(face.cWN(k), ofCorners_);
        } else if (ofVertices && vcg::tri::HasPerVertexNormal(mesh)) {
            for (const auto& vertex : mesh.vert) Add(vertex.cN(), ofVertices_);
        }
    }
    MeshNormals(const MeshNormals&) = delete;
    MeshNormals& operator=(const MeshNormals&) = delete;

    /// \pre \p view is of the arrays of the mesh; this outlives it
    void AddTo(MeshView& view) const
    {
        if (!ofCorners_.empty()) view.cornerNormals = ofCorners_.data();
        if (!ofVertices_.empty()) view.vertexNormals = ofVertices_.data();
    }
};

/// Of every corner of a result the first one of its vertex on the same side.
inline std::vector<std::size_t> FirstCornersOfSides(const DecimatedMesh& result)
{
    std::vector<std::size_t> first(3 * result.triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> found; // of vertices and their sides
    for (std::size_t i = 0; i < first.size(); ++i) {
        const std::uint32_t side = result.cornerSides.empty() ? 0 : result.cornerSides[i];
        first[i] = found.emplace(std::pair{result.triangles[i / 3][i % 3], side}, i).first->second;
    }
    return first;
}

inline double LargestComponent(const Vector3<double>& v)
{
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}
/// \p v divided by a number whose reciprocal may be too large.
inline Vector3<double> Divided(const Vector3<double>& v, double by)
{
    return {v.x / by, v.y / by, v.z / by};
}

/// Unit normals of the corners of a result: of every side of a vertex the sum over its faces, weighted by
/// area. Zero where that has no area. \param first FirstCornersOfSides
inline std::vector<Vector3<double>> CornerNormals(const DecimatedMesh& result,
                                                  const std::vector<std::size_t>& first)
{
    const auto edge = [&](std::size_t f, std::size_t k) {
        const auto& a = result.positions[result.triangles[f][0]];
        const auto& b = result.positions[result.triangles[f][k]];
        return Vector3<double>{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    };
    // Areas of very small and very large faces are no numbers: those of a side are measured by its longest
    // edge.
    std::vector<double> unit(first.size(), 0);
    for (std::size_t i = 0; i < first.size(); ++i)
        for (const std::size_t k : {1, 2})
            unit[first[i]] = std::max(unit[first[i]], LargestComponent(edge(i / 3, k)));
    std::vector<Vector3<double>> normals(first.size(), {0, 0, 0});
    for (std::size_t i = 0; i < first.size(); ++i) {
        const double by = unit[first[i]];
        Vector3<double>& sum = normals[first[i]];
        if (by > 0) sum = sum + Cross(Divided(edge(i / 3, 1), by), Divided(edge(i / 3, 2), by));
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) {
            normals[i] = normals[first[i]];
            continue;
        }
        const double largest = LargestComponent(normals[i]);
        if (!(largest > 0)) continue;
        const Vector3<double> scaled = Divided(normals[i], largest);
        normals[i] = Divided(scaled, Norm(scaled));
    }
    return normals;
}

} // namespace vcg_ext
