// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/surface_wedges.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// The outcome: a subset of the input's vertices and faces, vertices at new places, both in input order.
struct DecimatedMesh {
    std::vector<std::array<double, 3>> positions;
    std::vector<std::uint32_t> vertexOrigin;             ///< the input vertex that each vertex was
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of positions
    std::vector<std::uint32_t> faceOrigin;               ///< the input face that each face was
    /// What MeshView::attributes have become: as many numbers a corner, three corners a face. Empty where the
    /// mesh had none.
    std::vector<float> cornerValues;
    /// One a corner: those of a vertex that have the same are shaded as one surface. Empty where the mesh has
    /// no hard edges.
    std::vector<std::uint32_t> cornerSides;
    std::optional<SurfaceWedges> wedges; ///< while the mesh is being made
    StopReason stopReason = StopReason::Target;
};

/// The result of a collapse as a view of its own. \param fixed holds the flags that the view points to
/// \pre \p mesh has faces, \p fixed is empty
inline MeshView ViewOf(const DecimatedMesh& mesh, const MeshView& original, std::vector<std::uint8_t>& fixed)
{
    MeshView view;
    view.positions = mesh.positions.data();
    view.positionStride = sizeof mesh.positions[0];
    view.doublePositions = true;
    view.vertexCount = mesh.positions.size();
    view.triangles = mesh.triangles.front().data();
    view.faceCount = mesh.triangles.size();
    if (original.fixedVertices != nullptr) {
        for (const std::uint32_t origin : mesh.vertexOrigin) fixed.push_back(original.fixedVertices[origin]);
        view.fixedVertices = fixed.data();
        view.sharedSeams = original.sharedSeams;
    }
    return view;
}

/// The coordinates as the caller will have them: where the original has floats, so has the result.
inline void RoundAsInput(const MeshView& original, DecimatedMesh& mesh)
{
    if (original.doublePositions) return;
    for (auto& p : mesh.positions)
        for (double& x : p) x = static_cast<double>(static_cast<float>(x));
}

/// Takes what became of the result into it: its faces, and the positions of vertices that moved; the others
/// keep their bits. \pre \p surface was built from ViewOf(mesh) in \p frame
inline void WriteBack(const SurfaceArrays& surface, const Frame& frame, DecimatedMesh& mesh)
{
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        if (surface.flags[v] & kMovedVertex) mesh.positions[v] = frame.OutOf(PositionOf(surface, v));
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) mesh.triangles[f][k] = surface.triangles[f].v[k];
}

} // namespace vcg_ext
