// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// No vertex, no face, the end of a list.
constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// A point of the engine's frame (p - box centre) * 1024 / diagonal, and one number that belongs to it.
struct alignas(16) SurfacePoint {
    float x, y, z;
    float weight; ///< original surface: e^{lambda l} with lambda = 2; simplified surface: unused
};
static_assert(sizeof(SurfacePoint) == 16, "loaded as one vector of four floats");

struct SurfaceWedges;

struct SurfaceTriangle {
    std::uint32_t v[3];
};

/// A corner names a face and which of its three vertices is meant, as 4 * face + index.
using Corner = std::uint32_t;
inline std::uint32_t FaceOf(Corner corner)
{
    return corner >> 2;
}
inline int IndexOf(Corner corner)
{
    return static_cast<int>(corner & 3);
}
inline Corner MakeCorner(std::uint32_t face, int index)
{
    return face << 2 | static_cast<std::uint32_t>(index);
}

// Tables, because what a corner's index is cannot be predicted.
inline constexpr std::uint8_t kNextIndex[4] = {1, 2, 0, 0};
inline constexpr std::uint8_t kPreviousIndex[4] = {2, 0, 1, 0};

/// A triangle mesh with the corners around every vertex: what the sweep engine hands to the refinement.
///
/// The corners of vertex v are corners[cornerOffset[v] .. cornerOffset[v] + cornerCount[v]), in no special
/// order; its list has room for cornerCapacity of them where lists must be able to grow.
struct SurfaceArrays {
    Buffer<SurfacePoint> points;
    Buffer<SurfaceTriangle> triangles;
    Buffer<std::uint32_t> cornerOffset; ///< one more than vertices: the last is the end of the pool
    Buffer<std::uint32_t> cornerCount;
    Buffer<Corner> corners;
    Buffer<std::uint8_t> flags;      ///< of SurfaceFlag, one byte per vertex
    bool sharedSeams = false;        ///< of MeshView
    SurfaceWedges* wedges = nullptr; ///< the attributes of the triangles, where they have any

    std::size_t VertexCount() const { return points.size(); }
    std::size_t FaceCount() const { return triangles.size(); }
};

inline SurfaceArrays CopyOf(const SurfaceArrays& surface)
{
    SurfaceArrays copy;
    copy.points = surface.points.Copy();
    copy.triangles = surface.triangles.Copy();
    copy.cornerOffset = surface.cornerOffset.Copy();
    copy.cornerCount = surface.cornerCount.Copy();
    copy.corners = surface.corners.Copy();
    copy.flags = surface.flags.Copy();
    copy.sharedSeams = surface.sharedSeams;
    copy.wedges = surface.wedges;
    return copy;
}

enum SurfaceFlag : std::uint8_t {
    kBorderVertex = 1, ///< on an edge that does not have exactly two faces
    kFixedVertex = 2,  ///< must keep its position (selection, lock)
    kMovedVertex = 4,  ///< simplified surface: is not where the input had it
    kSeamVertex = 8,   ///< on a seam of the attributes
    kSeamCorner = 16   ///< where seams end or meet each other or a border: stays once the collapse is over
};

/// Walks over the corners of SurfaceArrays.
inline const Corner* BeginCorners(const SurfaceArrays& surface, std::uint32_t v)
{
    return surface.corners.data() + surface.cornerOffset[v];
}
inline const Corner* EndCorners(const SurfaceArrays& surface, std::uint32_t v)
{
    return BeginCorners(surface, v) + surface.cornerCount[v];
}
/// Corners that the list of \p v has room for.
inline std::uint32_t CornerCapacity(const SurfaceArrays& surface, std::uint32_t v)
{
    return surface.cornerOffset[v + 1] - surface.cornerOffset[v];
}
/// The vertex after that of \p corner in its face, and the one after that.
inline std::uint32_t NextVertex(const SurfaceArrays& surface, Corner corner)
{
    return surface.triangles[FaceOf(corner)].v[kNextIndex[IndexOf(corner)]];
}
inline std::uint32_t PreviousVertex(const SurfaceArrays& surface, Corner corner)
{
    return surface.triangles[FaceOf(corner)].v[kPreviousIndex[IndexOf(corner)]];
}
inline bool HasVertex(const SurfaceTriangle& triangle, std::uint32_t v)
{
    return triangle.v[0] == v || triangle.v[1] == v || triangle.v[2] == v;
}
inline Vector3<float> PositionOf(const SurfaceArrays& surface, std::uint32_t v)
{
    const SurfacePoint& p = surface.points[v];
    return {p.x, p.y, p.z};
}
inline Vector3<float> Centroid(const SurfaceArrays& surface, std::uint32_t f)
{
    const SurfaceTriangle& t = surface.triangles[f];
    const Vector3<float> a = PositionOf(surface, t.v[0]);
    return a + (1.0F / 3) * ((PositionOf(surface, t.v[1]) - a) + (PositionOf(surface, t.v[2]) - a));
}
/// Along the normal, as long as twice the area.
inline Vector3<float> AreaVector(const SurfaceArrays& surface, std::uint32_t f)
{
    const SurfaceTriangle& t = surface.triangles[f];
    const Vector3<float> a = PositionOf(surface, t.v[0]);
    return Cross(PositionOf(surface, t.v[1]) - a, PositionOf(surface, t.v[2]) - a);
}

/// Takes \p corner out of the list of \p v. \pre it is in it
inline void RemoveCorner(SurfaceArrays& surface, std::uint32_t v, Corner corner)
{
    Corner* list = surface.corners.data() + surface.cornerOffset[v];
    const std::uint32_t last = --surface.cornerCount[v];
    Corner* found = std::find(list, list + last, corner);
    *found = list[last];
}
/// \pre the list of \p v has room
inline void AddCorner(SurfaceArrays& surface, std::uint32_t v, Corner corner)
{
    surface.corners[surface.cornerOffset[v] + surface.cornerCount[v]++] = corner;
}

/// Copies the corner lists so that each has room for \p room corners more.
inline void MakeRoomForCorners(SurfaceArrays& surface, std::uint32_t room)
{
    const std::size_t vertices = surface.VertexCount();
    Buffer<std::uint32_t> offset(vertices + 1);
    std::uint32_t end = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        offset[v] = end;
        end += surface.cornerCount[v] + room;
    }
    offset[vertices] = end;
    Buffer<Corner> corners(end);
    for (std::size_t v = 0; v < vertices; ++v)
        std::copy_n(surface.corners.data() + surface.cornerOffset[v], surface.cornerCount[v],
                    corners.data() + offset[v]);
    surface.cornerOffset = std::move(offset);
    surface.corners = std::move(corners);
}

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
    surface.sharedSeams = view.sharedSeams;
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
