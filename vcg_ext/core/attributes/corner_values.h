// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// Faces whose texture has the other orientation than most of the area of their chart of the original; that
/// of charts that have none to speak of cannot turn. \pre the mesh has wedges and values
inline std::size_t CountTurnedFaces(const MeshView& view, const DecimatedMesh& mesh)
{
    const SurfaceWedges& wedges = *mesh.wedges;
    const std::size_t channels = wedges.channels.size();
    const auto area = [&](const float* values, std::size_t f, std::uint32_t first) {
        const float* corner = values + 3 * f * channels;
        return DoubleTextureArea(corner, corner + channels, corner + 2 * channels, first);
    };
    std::size_t turned = 0;
    for (const std::uint32_t first : wedges.channels.textures) {
        std::vector<double> charts;
        for (std::size_t f = 0; f < view.faceCount; ++f) {
            const std::uint32_t chart = wedges.inputChart[f];
            if (chart == kNone) continue;
            if (chart >= charts.size()) charts.resize(std::size_t{chart} + 1, 0);
            charts[chart] += area(view.attributes->values, f, first);
        }
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            turned += area(mesh.cornerValues.data(), f, first) * charts[wedges.chart[f]] < 0;
    }
    return turned;
}

/// The values and sides of all corners, from those of the wedges.
inline void WriteCornerValues(DecimatedMesh& mesh)
{
    for (const auto& corners : mesh.wedges->ofFace)
        for (const std::uint32_t w : corners) {
            if (!mesh.wedges->side.empty()) mesh.cornerSides.push_back(mesh.wedges->side[w]);
            const float* values = mesh.wedges->Values(w);
            mesh.cornerValues.insert(mesh.cornerValues.end(), values, values + mesh.wedges->channels.size());
        }
}

} // namespace vcg_ext
