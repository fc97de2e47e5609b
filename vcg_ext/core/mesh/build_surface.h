// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// The frame of the box of all vertices on faces of \p view.
inline Frame FrameOf(const MeshView& view)
{
    if (view.faceCount == 0) return {};
    Box3<double> box = EmptyBox<double>();
    for (std::size_t k = 0; k < 3 * view.faceCount; ++k) {
        const auto p = view.Position(view.triangles[k]);
        box.Add({p[0], p[1], p[2]});
    }
    return FrameOf(box);
}

/// Is every edge of \p v on exactly two faces, one in each direction?
inline bool HasClosedStar(const SurfaceArrays& surface, std::uint32_t v, std::vector<std::uint32_t>& next,
                          std::vector<std::uint32_t>& previous)
{
    next.clear();
    previous.clear();
    for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c) {
        next.push_back(NextVertex(surface, *c));
        previous.push_back(PreviousVertex(surface, *c));
    }
    std::sort(next.begin(), next.end());
    std::sort(previous.begin(), previous.end());
    return next == previous && std::adjacent_find(next.begin(), next.end()) == next.end();
}

/// Fills offsets, counts and lists from the triangles, faces in ascending order in every list.
inline void BuildCornerLists(SurfaceArrays& surface)
{
    const std::size_t vertices = surface.VertexCount(), faces = surface.FaceCount();
    surface.cornerOffset.Allocate(vertices + 1);
    surface.cornerCount.Allocate(vertices);
    surface.corners.Allocate(3 * faces);
    std::fill(surface.cornerCount.begin(), surface.cornerCount.end(), 0);
    for (const SurfaceTriangle& t : surface.triangles)
        for (const std::uint32_t v : t.v) ++surface.cornerCount[v];
    surface.cornerOffset[0] = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        surface.cornerOffset[v + 1] = surface.cornerOffset[v] + surface.cornerCount[v];
        surface.cornerCount[v] = 0;
    }
    for (std::size_t f = 0; f < faces; ++f)
        for (int k = 0; k < 3; ++k)
            AddCorner(surface, surface.triangles[f].v[k], MakeCorner(static_cast<std::uint32_t>(f), k));
}

/// Marks the vertices on edges that do not have exactly two faces of opposite direction.
inline void MarkBorderVertices(SurfaceArrays& surface, int threads = 1)
{
    ParallelRanges(threads, surface.VertexCount(), 4096, [&](std::size_t begin, std::size_t end, int) {
        std::vector<std::uint32_t> next, previous;
        for (std::size_t v = begin; v < end; ++v) {
            auto& flags = surface.flags[v];
            flags = static_cast<std::uint8_t>(flags & ~kBorderVertex);
            if (!HasClosedStar(surface, static_cast<std::uint32_t>(v), next, previous))
                flags = static_cast<std::uint8_t>(flags | kBorderVertex);
        }
    });
}

/// A mesh as the refinement reads it, vertices and faces in the order of \p view; fixed vertices are marked.
///
/// \param frame the same for both meshes of a pair
/// \param weights of the vertices as sample weights, e^{2 l}; null: 1 each
/// \throws std::bad_alloc
inline SurfaceArrays BuildSurfaceArrays(const MeshView& view, const Frame& frame,
                                        const float* weights = nullptr, int threads = 1)
{
    SurfaceArrays surface;
    surface.points.Allocate(view.vertexCount);
    surface.flags.Allocate(view.vertexCount);
    surface.triangles.Allocate(view.faceCount);
    ParallelRanges(threads, view.vertexCount, 8192, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v) {
            const Vector3<float> p = frame.Into(view.Position(v));
            surface.points[v] = {p.x, p.y, p.z, weights ? weights[v] : 1.0F};
            surface.flags[v] = view.fixedVertices && view.fixedVertices[v] ? kFixedVertex : 0;
        }
    });
    for (std::size_t f = 0; f < view.faceCount; ++f)
        for (std::size_t k = 0; k < 3; ++k) surface.triangles[f].v[k] = view.triangles[3 * f + k];
    BuildCornerLists(surface);
    MarkBorderVertices(surface, threads);
    return surface;
}

} // namespace vcg_ext
