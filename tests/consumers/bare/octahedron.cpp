// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A program that has the headers and nothing else: c++ -std=c++17 -I <top of the project> octahedron.cpp
#include "vcg_ext/core/simplify.h"

int main()
{
    const double points[][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const std::uint32_t triangles[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                       2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    vcg_ext::MeshView mesh;
    mesh.positions = points, mesh.positionStride = sizeof points[0], mesh.doublePositions = true;
    mesh.triangles = triangles, mesh.vertexCount = 6, mesh.faceCount = 8;
    vcg_ext::DecimationParameters parameters;
    parameters.targetFaces = 4;
    return vcg_ext::Simplify(mesh, parameters).mesh.triangles.size() == 4 ? 0 : 1;
}
