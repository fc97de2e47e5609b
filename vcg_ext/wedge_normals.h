// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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

/// Unit normals of the corners of a result: of every side of a vertex the sum over its faces, weighted by
/// area.
inline std::vector<Vector3<double>> CornerNormals(const DecimatedMesh& result)
{
    std::vector<Vector3<double>> normals(3 * result.triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vector3<double>> sums; // of vertices and their sides
    const auto sumOf = [&](std::size_t corner) -> Vector3<double>& {
        const std::uint32_t side = result.cornerSides.empty() ? 0 : result.cornerSides[corner];
        return sums[{result.triangles[corner / 3][corner % 3], side}];
    };
    for (std::size_t f = 0; f < result.triangles.size(); ++f) {
        std::array<Vector3<double>, 3> at{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& p = result.positions[result.triangles[f][k]];
            at[k] = {p[0], p[1], p[2]};
        }
        for (std::size_t k = 0; k < 3; ++k) {
            Vector3<double>& sum = sumOf(3 * f + k);
            sum = sum + Cross(at[1] - at[0], at[2] - at[0]);
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vector3<double>& sum = sumOf(i);
        const double length = Norm(sum);
        normals[i] = length > 0 ? (1 / length) * sum : sum;
    }
    return normals;
}

} // namespace vcg_ext
