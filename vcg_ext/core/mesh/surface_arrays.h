// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "vcg_ext/core/base/buffer.h"

namespace vcg_ext
{

/// A point of the engine's frame (p - box centre) * 1024 / diagonal, and one number that belongs to it.
struct alignas(16) SurfacePoint {
    float x, y, z;
    float weight; ///< original surface: e^{lambda l} with lambda = 2; simplified surface: unused
};
static_assert(sizeof(SurfacePoint) == 16, "loaded as one vector of four floats");

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
    Buffer<std::uint8_t> flags; ///< of SurfaceFlag, one byte per vertex

    std::size_t VertexCount() const { return points.size(); }
    std::size_t FaceCount() const { return triangles.size(); }
};

enum SurfaceFlag : std::uint8_t {
    kBorderVertex = 1, ///< on an edge that does not have exactly two faces
    kFixedVertex = 2,  ///< must keep its position (selection, lock)
    kMovedVertex = 4   ///< simplified surface: is not where the input had it
};

} // namespace vcg_ext
