// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/core/base/first_equal.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// A VCG mesh as a MeshView: positions are read in place, the live faces' indices are written out once.
/// Vertex indices are those of mesh.vert, deleted ones included; they are simply on no face.
/// \pre the mesh outlives this object and is not changed while it is used
template <class Mesh>
class MeshArrays
{
    std::vector<std::uint32_t> triangles_;
    std::vector<std::uint32_t> faceIndex_; // empty where no face is deleted
    std::vector<std::uint8_t> fauxEdges_;  // empty where no edge is faux
    MeshView view_;

    /// Of the face last added.
    void AddFauxEdges(int bits)
    {
        if (bits == 0) return;
        fauxEdges_.resize(triangles_.size() / 3, 0);
        fauxEdges_.back() = static_cast<std::uint8_t>(bits);
    }

  public:
    explicit MeshArrays(const Mesh& mesh)
    {
        using Scalar = typename Mesh::ScalarType;
        static_assert(std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>);
        triangles_.reserve(3 * static_cast<std::size_t>(mesh.fn));
        const bool holes = mesh.face.size() != static_cast<std::size_t>(mesh.fn);
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            const auto& face = mesh.face[f];
            if (face.IsD()) continue;
            for (int k = 0; k < 3; ++k)
                triangles_.push_back(static_cast<std::uint32_t>(vcg::tri::Index(mesh, face.cV(k))));
            if (holes) faceIndex_.push_back(static_cast<std::uint32_t>(f));
            AddFauxEdges(face.IsF(0) | face.IsF(1) << 1 | face.IsF(2) << 2);
        }
        // P(), as cP() returns a copy in vcglib before 2024.
        if (!mesh.vert.empty()) view_.positions = &mesh.vert.front().P()[0];
        view_.positionStride = sizeof(typename Mesh::VertexType);
        view_.doublePositions = std::is_same_v<Scalar, double>;
        view_.vertexCount = mesh.vert.size();
        view_.triangles = triangles_.data();
        view_.faceCount = triangles_.size() / 3;
        if (!fauxEdges_.empty()) {
            fauxEdges_.resize(view_.faceCount, 0);
            view_.fauxEdges = fauxEdges_.data();
        }
    }
    MeshArrays(const MeshArrays&) = delete;
    MeshArrays& operator=(const MeshArrays&) = delete;

    const MeshView& View() const { return view_; }

    /// The index in mesh.face of the view's face.
    std::size_t FaceIndex(std::size_t viewFace) const
    {
        return faceIndex_.empty() ? viewFace : faceIndex_[viewFace];
    }

    /// One byte a vertex: 1 on vertices of faces that are not selected. They must not move or go.
    std::vector<std::uint8_t> OutsideSelection(const Mesh& mesh) const
    {
        std::vector<std::uint8_t> outside(view_.vertexCount, 0);
        for (std::size_t f = 0; f < view_.faceCount; ++f) {
            if (mesh.face[FaceIndex(f)].IsS()) continue;
            for (std::size_t k = 0; k < 3; ++k) outside[view_.triangles[3 * f + k]] = 1;
        }
        return outside;
    }
};

/// Marks the selected vertices in \p fixed, which has one byte an element of mesh.vert or is empty.
template <class Mesh>
void AddSelectedVertices(const Mesh& mesh, std::vector<std::uint8_t>& fixed)
{
    fixed.resize(mesh.vert.size(), 0);
    for (std::size_t v = 0; v < mesh.vert.size(); ++v)
        if (!mesh.vert[v].IsD() && mesh.vert[v].IsS()) fixed[v] = 1; // deleted ones keep their flags
}

/// One number an element of mesh.vert, the same for the same color and texture coordinates; empty if vertices
/// have neither.
template <class Mesh>
std::vector<std::uint32_t> AttributeKeys(const Mesh& mesh)
{
    const bool color = vcg::tri::HasPerVertexColor(mesh), texture = vcg::tri::HasPerVertexTexCoord(mesh);
    std::vector<std::uint32_t> keys;
    if (!color && !texture) return keys;
    keys.reserve(mesh.vert.size());
    for (const auto& vertex : mesh.vert) {
        std::uint64_t key = 0;
        if (color)
            for (int k = 0; k < 4; ++k) key = key << 8U | vertex.cC()[k];
        if (texture) {
            const std::array<float, 2> uv{static_cast<float>(vertex.cT().U()),
                                          static_cast<float>(vertex.cT().V())};
            std::uint64_t bits = 0;
            std::memcpy(&bits, uv.data(), sizeof bits);
            key = Mixed(Mixed(key + bits) + static_cast<std::uint64_t>(vertex.cT().N()));
        }
        keys.push_back(static_cast<std::uint32_t>(key));
    }
    return keys;
}

} // namespace vcg_ext
