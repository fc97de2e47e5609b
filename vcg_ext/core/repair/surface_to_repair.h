// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// A simplified mesh as LocalRepair works on it; wedges follow.
struct SurfaceToRepair {
    std::vector<std::uint8_t> fixed;
    MeshView simplified;
    SurfaceArrays surface;
    FaceTree tree; ///< of the faces as they are before the first change

    /// \pre \p mesh and \p frame outlive this object
    SurfaceToRepair(const MeshView& original, const Frame& frame, DecimatedMesh& mesh, int threads)
        : simplified(ViewOf(mesh, original, fixed)),
          surface(BuildSurfaceArrays(simplified, frame, nullptr, threads)), tree(simplified, frame, threads)
    {
        if (mesh.wedges) {
            surface.wedges = &*mesh.wedges;
            MarkSeams(surface);
        }
        MakeRoomForCorners(surface, kFlipRoom);
    }
    SurfaceToRepair(const SurfaceToRepair&) = delete;
    SurfaceToRepair& operator=(const SurfaceToRepair&) = delete;
};

} // namespace vcg_ext
