// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/mesh/decimation_types.h"
#include "vcg_ext/core/mesh/surface_arrays.h"
#include "vcg_ext/core/mesh/surface_builder.h"

namespace vcg_ext
{

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
    }
    return view;
}

/// Takes what became of the result into it: its faces, and the positions of vertices that moved; the others
/// keep their bits. \pre \p surface was built from ViewOf(mesh) in \p frame
inline void WriteBack(const SurfaceArrays& surface, const SurfaceFrame& frame, DecimatedMesh& mesh)
{
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (surface.flags[v] & kMovedVertex) mesh.positions[v] = frame.FromFrame(surface.points[v]);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) mesh.triangles[f][k] = surface.triangles[f].v[k];
}

} // namespace vcg_ext
