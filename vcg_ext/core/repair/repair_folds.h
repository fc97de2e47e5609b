// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "vcg_ext/core/mesh/decimated_view.h"
#include "vcg_ext/core/mesh/decimation_types.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface_builder.h"
#include "vcg_ext/core/repair/fold_repair.h"

namespace vcg_ext
{

/// Folded faces before and after the mending.
struct UnfoldingReport {
    std::size_t before = 0, after = 0;
    bool cancelled = false;
};

namespace unfold_detail
{

inline PlacedTriangle Placed(const DecimatedMesh& mesh, std::size_t f, const SurfaceFrame& frame)
{
    const auto corner = [&](std::size_t k) {
        const SurfacePoint p = frame.ToFrame(mesh.positions[mesh.triangles[f][k]], 0);
        return Vector3{p.x, p.y, p.z};
    };
    const Vector3 a = corner(0);
    return {a, PrepareTriangle(corner(1) - a, corner(2) - a)};
}

/// A corner of the input face that \p face was, if that looks along it.
inline std::optional<Vector3> PointBeside(const MeshView& original, std::size_t origin,
                                          const SurfaceFrame& frame, const PlacedTriangle& face)
{
    const auto corner = [&](std::size_t k) {
        const SurfacePoint p = frame.ToFrame(original.Position(original.triangles[3 * origin + k]), 0);
        return Vector3{p.x, p.y, p.z};
    };
    const Vector3 a = corner(0);
    if (!(Dot(Cross(corner(1) - a, corner(2) - a), NormalOf(face.shape)) > 0)) return std::nullopt;
    return a;
}

/// In ascending order.
inline std::vector<std::uint32_t> FoldedFaces(const MeshView& original, const FaceTree& tree,
                                              const DecimatedMesh& mesh, const SurfaceFrame& frame,
                                              int threads)
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

/// Do many edges have faces that look to different sides? Then it says nothing that a face looks against the
/// closest one.
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

} // namespace unfold_detail

/// Mends folded faces: those that look against the original where it is closest to their centroid. Slivers
/// that a collapse turned over are such faces, and large ones that cut through a wall thinner than the error.
///
/// Edges are flipped and vertices moved, those that have the most favourable effect on the distances between
/// the surfaces; fixed vertices, locked borders and the number of faces stay. What little cannot be mended
/// without doubling the local error stays folded. Vertices on borders that are not locked may move. Flips
/// give faces other corners: what is stored per wedge does not follow. The bytes of the result do not depend
/// on the number of threads. \param mesh a decimated \p original, changed in place; vertices that stay keep
/// their bits \param threads 0: all \pre finite coordinates
inline UnfoldingReport UnfoldFaces(const MeshView& original, DecimatedMesh& mesh, Boundary boundary,
                                   int threads, const Progress& progress = {})
{
    // Cheap mendings first: they often mend a neighbour too.
    constexpr float kTolerances[] = {1, 1.05F, 1.1F, 1.3F, 2};
    // A bound on the time: a face takes milliseconds, and in a shell thinner than the error most are folded.
    constexpr std::size_t kAttempts = 2000, kFacesPerAttempt = 50;
    constexpr std::size_t kSuspiciousShare = 8;
    threads = ResolveThreads(threads);
    UnfoldingReport report;
    if (mesh.triangles.empty()) return report;
    std::vector<std::uint8_t> fixed;
    const MeshView simplified = ViewOf(mesh, original, fixed);
    const SurfaceFrame frame = FrameOf(simplified);
    const FaceTree tree(original, frame, threads, mesh.inputOrder);
    std::vector<std::uint32_t> folded = unfold_detail::FoldedFaces(original, tree, mesh, frame, threads);
    report.before = report.after = folded.size();
    if (folded.empty()) return report;
    if (folded.size() > mesh.triangles.size() / kSuspiciousShare &&
        unfold_detail::HasMixedOrientation(original))
        return report;

    SurfaceArrays surface = BuildSurfaceArrays(simplified, frame, nullptr, threads);
    MakeRoomForCorners(surface, kFlipRoom);
    const FaceTree simplifiedTree(simplified, frame, threads);
    Unfolder unfolder(tree, simplifiedTree, surface);
    constexpr std::size_t kPasses = std::size(kTolerances);
    std::size_t attempts = kAttempts + mesh.triangles.size() / kFacesPerAttempt;
    for (std::size_t pass = 0; pass < kPasses; ++pass) {
        const auto percent = static_cast<int>(100 * pass / kPasses);
        for (const std::uint32_t f : folded) {
            if (attempts == 0) break;
            --attempts;
            report.cancelled = progress && !progress(percent, "Repairing folds");
            if (report.cancelled) return report;
            unfolder.Mend(f, kTolerances[pass], pass > 0 && boundary != Boundary::Lock);
        }
        folded.insert(folded.end(), unfolder.Changed().begin(), unfolder.Changed().end());
        std::sort(folded.begin(), folded.end());
        folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
        folded.erase(std::remove_if(folded.begin(), folded.end(),
                                    [&](std::uint32_t f) { return !unfolder.IsFoldedNow(f); }),
                     folded.end());
    }
    report.after = folded.size();
    WriteBack(surface, frame, mesh);
    return report;
}

} // namespace vcg_ext
