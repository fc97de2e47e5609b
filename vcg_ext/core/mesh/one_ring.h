// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// The two other vertices of a face, seen from one of its corners, in the face's order.
/// A polygon's diagonal is marked faux: its end shares a face with the vertex, but is not its neighbour.
struct RingCorner {
    std::uint32_t next : 31;
    std::uint32_t nextIsFaux : 1;
    std::uint32_t previous : 31;
    std::uint32_t previousIsFaux : 1;
};

/// The corners and the neighbours around the vertices of a triangle mesh, whatever its topology: open,
/// non-manifold, polygonal, with inconsistent orientation. Faces that name a vertex twice are left out.
/// Rings are numbered as the vertices, or as those that were asked for.
class OneRings
{
    std::vector<std::uint32_t> vertices_; // empty where all have a ring
    std::vector<std::size_t> offset_;
    Buffer<RingCorner> corners_;

    static RingCorner CornerOf(const MeshView& mesh, std::size_t face, std::size_t k);
    void CountsToOffsets();
    bool IsRegular(ArrayView<RingCorner> corners) const;

  public:
    /// Two passes over the faces. \pre every index of mesh.triangles is below mesh.vertexCount < 2^31
    /// \param threads used as they are
    explicit OneRings(const MeshView& mesh, int threads = 1);

    /// The rings of some vertices, in one pass over the faces. \param vertices in ascending order
    OneRings(const MeshView& mesh, std::vector<std::uint32_t> vertices);

    std::size_t Count() const { return offset_.size() - 2; }

    std::size_t Vertex(std::size_t ring) const { return vertices_.empty() ? ring : vertices_[ring]; }

    /// In the order of the faces.
    ArrayView<RingCorner> Corners(std::size_t ring) const
    {
        return {corners_.data() + offset_[ring], offset_[ring + 1] - offset_[ring]};
    }

    /// Every neighbour once: the ends of the edges at the vertex that are not diagonals.
    /// \param room is overwritten and holds the result, so that a loop over vertices allocates once
    ArrayView<std::uint32_t> Neighbours(std::size_t ring, std::vector<std::uint32_t>& room) const;
};

/// Whether a face has a corner less than three; such faces have neither a normal nor neighbours.
inline bool NamesAVertexTwice(const std::uint32_t* face)
{
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// One to one, and far from additive, so that sums over different vertices do not meet by accident.
/// \tparam Unsigned of 32 bits, or a vector of such
template <class Unsigned>
[[gnu::always_inline]] inline void MixBits(Unsigned& v)
{
    v *= 0x9E3779B1u;
    v ^= v >> 15;
    v *= 0x85EBCA77u;
    v ^= v >> 13;
    v *= 0xC2B2AE3Du;
    v ^= v >> 16;
}
inline std::uint32_t MixedBits(std::uint32_t v)
{
    MixBits(v);
    return v;
}

inline RingCorner OneRings::CornerOf(const MeshView& mesh, std::size_t face, std::size_t k)
{
    const std::size_t next = k == 2 ? 0 : k + 1;
    const std::size_t previous = k == 0 ? 2 : k - 1;
    const unsigned faux = mesh.fauxEdges == nullptr ? 0u : mesh.fauxEdges[face];
    const std::uint32_t* v = mesh.triangles + 3 * face;
    return {v[next] & 0x7fffffffu, faux >> k & 1u, v[previous] & 0x7fffffffu, faux >> previous & 1u};
}

/// Counts are stored two places on, so that afterwards offset_[ring + 1] is where a ring begins, and after
/// filling where it ends.
inline void OneRings::CountsToOffsets()
{
    for (std::size_t ring = 2; ring < offset_.size(); ++ring) offset_[ring] += offset_[ring - 1];
    corners_.Allocate(offset_.back());
}

inline OneRings::OneRings(const MeshView& mesh, int threads) : offset_(mesh.vertexCount + 2, 0)
{
    // Every thread walks over all faces for a range of vertices of its own: nothing is shared, and the
    // corners of a vertex keep the order of the faces.
    const std::size_t ranges = static_cast<std::size_t>(threads);
    const auto forEachCorner = [&](const auto& visit) {
        ParallelFor(threads, ranges, [&](std::size_t range, int) {
            const std::size_t first = mesh.vertexCount * range / ranges;
            const std::size_t count = mesh.vertexCount * (range + 1) / ranges - first;
            for (std::size_t f = 0; f < mesh.faceCount; ++f) {
                const std::uint32_t* v = mesh.triangles + 3 * f;
                if (NamesAVertexTwice(v)) continue;
                for (std::size_t k = 0; k < 3; ++k)
                    if (v[k] - first < count) visit(f, v[k], k);
            }
        });
    };
    forEachCorner([&](std::size_t, std::uint32_t v, std::size_t) { ++offset_[v + 2]; });
    CountsToOffsets();
    forEachCorner([&](std::size_t f, std::uint32_t v, std::size_t k) {
        corners_[offset_[v + 1]++] = CornerOf(mesh, f, k);
    });
}

inline OneRings::OneRings(const MeshView& mesh, std::vector<std::uint32_t> vertices)
    : vertices_(std::move(vertices)), offset_(vertices_.size() + 2, 0)
{
    std::vector<std::uint8_t> wanted(mesh.vertexCount, 0);
    for (const std::uint32_t v : vertices_) wanted[v] = 1;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found; // ring, corner of the mesh
    for (std::size_t f = 0; f < mesh.faceCount; ++f) {
        const std::uint32_t* v = mesh.triangles + 3 * f;
        if ((wanted[v[0]] | wanted[v[1]] | wanted[v[2]]) == 0 || NamesAVertexTwice(v)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!wanted[v[k]]) continue;
            const auto at = std::lower_bound(vertices_.begin(), vertices_.end(), v[k]);
            found.emplace_back(at - vertices_.begin(), 3 * f + k);
            ++offset_[found.back().first + 2];
        }
    }
    CountsToOffsets();
    for (const auto& [ring, corner] : found)
        corners_[offset_[ring + 1]++] = CornerOf(mesh, corner / 3, corner % 3);
}

/// Whether the `next` of the corners alone are the neighbours: none is a diagonal, none is there twice, and
/// each is the `previous` of another corner. True for every vertex inside a triangulated surface; a vertex
/// may be called irregular by mistake, which costs time only.
inline bool OneRings::IsRegular(ArrayView<RingCorner> corners) const
{
    std::uint32_t balance = 0;
    std::uint64_t seen = 0;
    bool repeated = false;
    for (const RingCorner& corner : corners) {
        const std::uint32_t mixed = MixedBits(corner.next);
        const std::uint64_t bit = std::uint64_t{1} << (mixed >> 26);
        balance += mixed - MixedBits(corner.previous);
        repeated |= (seen & bit) != 0 || corner.nextIsFaux || corner.previousIsFaux;
        seen |= bit;
    }
    return balance == 0 && !repeated;
}

inline ArrayView<std::uint32_t> OneRings::Neighbours(std::size_t ring, std::vector<std::uint32_t>& room) const
{
    const ArrayView<RingCorner> corners = Corners(ring);
    if (room.size() < 2 * corners.size()) room.resize(2 * corners.size());
    std::uint32_t* last = room.data();
    if (IsRegular(corners)) {
        for (const RingCorner& corner : corners) *last++ = corner.next;
    } else {
        for (const RingCorner& corner : corners) {
            if (!corner.nextIsFaux) *last++ = corner.next;
            if (!corner.previousIsFaux) *last++ = corner.previous;
        }
        std::sort(room.data(), last);
        last = std::unique(room.data(), last);
    }
    return {room.data(), static_cast<std::size_t>(last - room.data())};
}

} // namespace vcg_ext
