// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "vcg_ext/core/mesh/corner_attributes.h"

namespace vcg_ext
{

/// A triangle mesh that somebody else owns, read in place.
struct MeshView {
    const void* positions = nullptr; ///< x of the first vertex
    std::size_t positionStride = 0;  ///< bytes from one vertex to the next
    bool doublePositions = false;    ///< coordinates are double, otherwise float
    std::size_t vertexCount = 0;
    const std::uint32_t* triangles = nullptr; ///< three vertex indices a face
    std::size_t faceCount = 0;
    const std::uint8_t* fixedVertices =
        nullptr; ///< one byte a vertex, not 0: never moves and stays; may be null
    const std::uint32_t* vertexKeys =
        nullptr; ///< one number a vertex: vertices with different ones are never welded; may be null
    bool sharedSeams =
        false; ///< fixed vertices are those of other meshes, too, that are simplified at the
               ///< same time: no new edge joins two of them, as another mesh might make it, too
    const float* guidance =
        nullptr; ///< descriptor in [0, 1] a vertex; null: the Laplacian descriptor is computed
    const std::uint8_t* fauxEdges = nullptr; ///< one byte a face, bit k: the edge from its vertex k to k + 1
                                             ///< is a polygon's diagonal; may be null
    const CornerAttributes* attributes = nullptr; ///< that guide and are transferred; may be null
    /// Normals that the surface is shaded with, three numbers a vertex, or three a corner, which count more;
    /// may be null. They guide nothing, but seams run where they are apart: mesh/hard_normals.h.
    const float* vertexNormals = nullptr;
    const float* cornerNormals = nullptr;

    const unsigned char* PositionAddress(std::size_t vertex) const
    {
        return static_cast<const unsigned char*>(positions) + vertex * positionStride;
    }
    std::array<double, 3> Position(std::size_t vertex) const
    {
        const auto* bytes = PositionAddress(vertex);
        std::array<double, 3> p{};
        if (doublePositions) {
            std::memcpy(p.data(), bytes, sizeof p);
        } else {
            std::array<float, 3> q{};
            std::memcpy(q.data(), bytes, sizeof q);
            for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<double>(q[k]);
        }
        return p;
    }
};

/// Whether a face has three different vertices.
inline bool HasSoundFace(const MeshView& view)
{
    for (std::size_t f = 0; f < view.faceCount; ++f) {
        const std::uint32_t* v = view.triangles + 3 * f;
        if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) return true;
    }
    return false;
}

/// Referenced vertices with a coordinate that is not a finite number.
inline std::size_t CountNonFinite(const MeshView& view)
{
    std::vector<bool> counted(view.vertexCount);
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3 * view.faceCount; ++k) {
        const std::uint32_t v = view.triangles[k];
        if (counted[v]) continue;
        counted[v] = true;
        const auto p = view.Position(v);
        count += !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
    }
    return count;
}

} // namespace vcg_ext
