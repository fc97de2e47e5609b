// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/find_crossings.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/repair/crossing_faults.h"
#include "vcg_ext/core/repair/local_repair.h"
#include "vcg_ext/core/repair/repair_passes.h"
#include "vcg_ext/core/repair/surface_to_repair.h"

namespace vcg_ext
{

/// Whether RepairCrossings would do anything about \p pairs of crossing faces, of so many \p faces.
inline bool AreFewCrossings(std::size_t pairs, std::size_t faces)
{
    constexpr std::size_t kFewPairs = 20, kFacesPerPair = 500, kMostPairs = 200;
    return pairs <= std::min(kMostPairs, kFewPairs + faces / kFacesPerPair);
}

/// Repairs faces that cross as RepairFolds does those that are folded, until no more pairs of them cross than
/// may, as far as that can be done without doubling the local error and without a new fold. Where many cross,
/// nothing is done: a wall is thinner than the error then, and to collapse again costs less.
/// \param mesh a decimated \p original, changed in place \param tree of the original's faces
/// \param crossings all of \p mesh \param allowed so many may stay \param threads used as they are
/// \throws Cancelled \pre finite coordinates
inline void RepairCrossings(const MeshView& original, const FaceTree& tree, DecimatedMesh& mesh,
                            const std::vector<CrossingPair>& crossings, std::size_t allowed,
                            Boundary boundary, int threads, const StageProgress& progress = {})
{
    constexpr std::size_t kAttemptsPerPair = 10;
    const std::size_t pairs = crossings.size();
    if (pairs <= allowed || !AreFewCrossings(pairs, mesh.triangles.size())) return;
    std::vector<std::uint32_t> faces;
    for (const CrossingPair& pair : crossings) faces.insert(faces.end(), {pair.first, pair.second});
    SortUnique(faces);
    const Frame& frame = tree.frame();
    SurfaceToRepair to(original, frame, mesh, threads);
    CrossingFaults faults(to.simplified, to.tree, to.surface, !original.doublePositions);
    LocalRepair repair(tree, to.tree, to.surface, faults);
    RunRepairPasses(repair, faces, kAttemptsPerPair * (pairs - allowed), boundary, progress,
                    "Repairing self-intersections", static_cast<std::ptrdiff_t>(pairs),
                    static_cast<std::ptrdiff_t>(allowed));
    WriteBack(to.surface, frame, mesh);
}

} // namespace vcg_ext
