// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// This project's engine on plain arrays, without a host, behind the same interface as the peers.

#include "peer_interface.h"

#include "vcg_ext/decimate.h"

namespace
{
using vcg_ext::DecimatedMesh;
using vcg_ext::DecimationParameters;
using vcg_ext::Effort;
using vcg_ext::MeshView;

MeshView ViewOf(const PeerMesh& mesh)
{
    MeshView view;
    view.positions = mesh.points;
    view.positionStride = 3 * sizeof(float);
    view.vertexCount = mesh.pointCount;
    view.triangles = mesh.corners;
    view.faceCount = mesh.faceCount;
    return view;
}

void Store(const DecimatedMesh& result, PeerMesh& mesh)
{
    mesh.pointCount = result.positions.size();
    mesh.faceCount = result.triangles.size();
    float* coordinate = mesh.points;
    for (const auto& position : result.positions) {
        for (const double value : position) *coordinate++ = static_cast<float>(value);
    }
    std::uint32_t* corner = mesh.corners;
    for (const auto& triangle : result.triangles) {
        for (const std::uint32_t vertex : triangle) *corner++ = vertex;
    }
}

/// Everything is inside the clock: the result's own arrays, their filling and their release too.
int Run(PeerMesh& mesh, Effort effort, int threads)
{
    DecimationParameters parameters;
    parameters.targetFaces = mesh.targetFaces;
    parameters.effort = effort;
    parameters.threads = threads;
    parameters.measureError = false;
    const PeerTimer timer(mesh);
    Store(vcg_ext::Decimate(ViewOf(mesh), parameters).mesh, mesh);
    return 0;
}

} // namespace

extern "C" int EngineFast(PeerMesh* mesh)
{
    return Run(*mesh, Effort::Fast, 1);
}
extern "C" int EngineFastTwoThreads(PeerMesh* mesh)
{
    return Run(*mesh, Effort::Fast, 2);
}
extern "C" int EngineBalanced(PeerMesh* mesh)
{
    return Run(*mesh, Effort::Balanced, 1);
}
extern "C" int EngineBalancedTwoThreads(PeerMesh* mesh)
{
    return Run(*mesh, Effort::Balanced, 2);
}
extern "C" int EngineBest(PeerMesh* mesh)
{
    return Run(*mesh, Effort::Best, 1);
}
