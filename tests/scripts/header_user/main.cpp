// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A program that has nothing of this project but its installed headers.

#include <array>
#include <cstdint>
#include <cstdio>

#include <vcg_ext/decimation.h>

int main()
{
    const std::array<std::array<double, 3>, 6> octahedron{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    const std::array<std::uint32_t, 24> triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                                  2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    vcg_ext::MeshView view;
    view.positions = octahedron.data();
    view.positionStride = sizeof octahedron[0];
    view.doublePositions = true;
    view.vertexCount = octahedron.size();
    view.triangles = triangles.data();
    view.faceCount = triangles.size() / 3;
    vcg_ext::DecimationParameters parameters;
    parameters.targetFaces = 4;
    const vcg_ext::DecimatedMesh result = vcg_ext::Decimate(view, parameters);
    std::printf("%zu faces\n", result.triangles.size());
    return result.triangles.size() == 4 ? 0 : 1;
}
