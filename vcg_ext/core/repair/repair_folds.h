// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/repair/fold_faults.h"
#include "vcg_ext/core/repair/local_repair.h"
#include "vcg_ext/core/repair/repair_passes.h"
#include "vcg_ext/core/repair/surface_to_repair.h"

namespace vcg_ext
{

/// Folded faces before and after the repair.
struct FoldRepairReport {
    std::size_t before = 0, after = 0;
};

namespace fold_repair_detail
{

inline PlacedTriangle Placed(const DecimatedMesh& mesh, std::size_t f, const Frame& frame)
{
    const auto corner = [&](std::size_t k) { return frame.Into(mesh.positions[mesh.triangles[f][k]]); };
    const Vector3<float> a = corner(0);
    return {a, PrepareTriangle(corner(1) - a, corner(2) - a)};
}

/// A corner of the input face that \p face was, if that faces along it.
inline std::optional<Vector3<float>> PointBeside(const MeshView& original, std::size_t origin,
                                                 const Frame& frame, const PlacedTriangle& face)
{
    const auto corner = [&](std::size_t k) {
        return frame.Into(original.Position(original.triangles[3 * origin + k]));
    };
    const Vector3<float> a = corner(0);
    if (!(Dot(Cross(corner(1) - a, corner(2) - a), NormalOf(face.shape)) > 0)) return std::nullopt;
    return a;
}

/// In ascending order.
inline std::vector<std::uint32_t> FoldedFaces(const MeshView& original, const FaceTree& tree,
                                              const DecimatedMesh& mesh, const Frame& frame, int threads)
{
    constexpr std::size_t kGrain = 1024;
    std::vector<std::vector<std::uint32_t>> parts(mesh.triangles.size() / kGrain + 1);
    ParallelRanges(threads, mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t f = begin; f < end; ++f) {
            const PlacedTriangle face = Placed(mesh, f, frame);
            if (IsFolded(tree, face, PointBeside(original, mesh.faceOrigin[f], frame, face)))
                parts[begin / kGrain].push_back(static_cast<std::uint32_t>(f));
        }
    });
    std::vector<std::uint32_t> folded;
    for (const auto& part : parts) folded.insert(folded.end(), part.begin(), part.end());
    return folded;
}

/// Do many edges have faces that face to different sides? Then it says nothing that a face faces away from
/// the closest one.
inline bool HasMixedOrientation(const MeshView& view)
{
    constexpr std::size_t kMany = 100; // one in so many
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * view.faceCount);
    for (std::size_t f = 0; f < view.faceCount; ++f)
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back(std::uint64_t{view.triangles[3 * f + k]} << 32 |
                            view.triangles[3 * f + (k + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    const auto last = std::unique(edges.begin(), edges.end());
    return static_cast<std::size_t>(edges.end() - last) > edges.size() / kMany;
}

} // namespace fold_repair_detail

/// Repairs folded faces: those that face away from the original where it is closest to their centroid.
/// Slivers that a collapse turned over are such faces, and large ones that cut through a wall thinner than
/// the error.
///
/// Edges are flipped and vertices moved, those that have the most favourable effect on the distances between
/// the surfaces; fixed vertices, locked borders, ends of seams and the number of faces stay. What little
/// cannot be repaired without doubling the local error stays folded. Vertices on borders that are not locked
/// may move. Wedges follow flips. The bytes of the result do not depend on the number of threads. \param mesh
/// a decimated \p original, changed in place; vertices that stay keep their bits \param tree of the
/// original's faces \param threads used as they are \throws Cancelled \pre finite coordinates
inline FoldRepairReport RepairFolds(const MeshView& original, const FaceTree& tree, DecimatedMesh& mesh,
                                    Boundary boundary, int threads, const StageProgress& progress = {})
{
    using namespace fold_repair_detail;
    constexpr std::size_t kSuspiciousShare = 8; // one folded face in so many
    FoldRepairReport report;
    if (mesh.triangles.empty()) return report;
    const Frame& frame = tree.frame();
    std::vector<std::uint32_t> folded = FoldedFaces(original, tree, mesh, frame, threads);
    report.before = report.after = folded.size();
    if (folded.empty()) return report;
    if (folded.size() > mesh.triangles.size() / kSuspiciousShare && HasMixedOrientation(original))
        return report;

    SurfaceToRepair to(original, frame, mesh, threads);
    FoldFaults faults(tree, to.surface);
    LocalRepair repair(tree, to.tree, to.surface, faults);
    // A bound on the time: a face takes milliseconds, and in a shell thinner than the error most are folded.
    constexpr std::size_t kAttempts = 2000, kFacesPerAttempt = 50;
    RunRepairPasses(repair, folded, kAttempts + mesh.triangles.size() / kFacesPerAttempt, boundary, progress,
                    "Repairing folds");
    report.after = folded.size();
    WriteBack(to.surface, frame, mesh);
    return report;
}

} // namespace vcg_ext
