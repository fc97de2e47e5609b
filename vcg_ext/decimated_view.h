// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "decimation_types.h"

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

} // namespace vcg_ext
