// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// meshoptimizer's simplify and, where the version has it, simplifyWithUpdate (which also moves vertices).

#include "peer_interface.h"

#include <meshoptimizer.h>

#include <limits>
#include <vector>

namespace
{
constexpr float kAnyError = std::numeric_limits<float>::max();
constexpr std::size_t kStride = 3 * sizeof(float);
} // namespace

extern "C" int MeshoptimizerVersion()
{
    return MESHOPTIMIZER_VERSION;
}

extern "C" int MeshoptimizerSimplify(PeerMesh* mesh)
{
    std::vector<unsigned int> result(3 * mesh->faceCount);
    {
        const PeerTimer timer(*mesh);
        mesh->faceCount =
            meshopt_simplify(result.data(), mesh->corners, 3 * mesh->faceCount, mesh->points,
                             mesh->pointCount, kStride, 3 * mesh->targetFaces, kAnyError, 0, nullptr) /
            3;
    }
    for (std::size_t corner = 0; corner < 3 * mesh->faceCount; ++corner)
        mesh->corners[corner] = result[corner];
    return 0;
}

extern "C" int MeshoptimizerSimplifyWithUpdate(PeerMesh* mesh)
{
#if MESHOPTIMIZER_VERSION >= 1000
    const PeerTimer timer(*mesh);
    mesh->faceCount = meshopt_simplifyWithUpdate(mesh->corners, 3 * mesh->faceCount, mesh->points,
                                                 mesh->pointCount, kStride, nullptr, 0, nullptr, 0, nullptr,
                                                 3 * mesh->targetFaces, kAnyError, 0, nullptr) /
                      3;
    return 0;
#else
    (void)mesh;
    return 1;
#endif
}
