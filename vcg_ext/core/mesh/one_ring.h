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
#include "vcg_ext/core/base/float4.h"
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
    Buffer<std::size_t> offset_;          // of every ring and two more
    Buffer<RingCorner> corners_;

    static RingCorner CornerOf(const MeshView& mesh, std::size_t face, std::size_t k);
    template <class FaceAt, class RingOf>
    void Fill(const MeshView& mesh, std::size_t rings, std::size_t faces, const FaceAt& faceAt,
              const RingOf& ringOf, int threads);
    bool IsRegular(ArrayView<RingCorner> corners) const;

  public:
    /// Two passes over the faces. \pre every index of mesh.triangles is below mesh.vertexCount < 2^31
    /// \param threads used as they are
    explicit OneRings(const MeshView& mesh, int threads = 1);

    /// The rings of some vertices, in one pass over all faces and two over theirs.
    /// \param wanted one byte a vertex, not 0: it has a ring, numbered in the order of the vertices
    /// \pre one of them at least, and fewer than 2^32 faces
    OneRings(const MeshView& mesh, const std::uint8_t* wanted, int threads);

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

/// Puts the corners of the faces faceAt(0) .. faceAt(faces - 1) into rings. Every thread walks over all of
/// them for a range of rings of its own: nothing is shared, and the corners of a ring keep the order of the
/// faces. \param ringOf ring of a vertex; \p rings where it has none
template <class FaceAt, class RingOf>
void OneRings::Fill(const MeshView& mesh, std::size_t rings, std::size_t faces, const FaceAt& faceAt,
                    const RingOf& ringOf, int threads)
{
    constexpr std::size_t kAhead = 16; // about what memory takes to answer
    const auto ranges = static_cast<std::size_t>(threads);
    const auto forEachCorner = [&](const auto& visit) {
        ParallelFor(threads, ranges, [&](std::size_t range, int) {
            const std::size_t first = rings * range / ranges;
            const std::size_t count = rings * (range + 1) / ranges - first;
            for (std::size_t i = 0; i < faces; ++i) {
                const std::uint32_t* ahead = mesh.triangles + 3 * faceAt(std::min(i + kAhead, faces - 1));
                for (std::size_t k = 0; k < 3; ++k) Prefetch(&offset_[ringOf(ahead[k]) + 1]);
                const std::size_t f = faceAt(i);
                const std::uint32_t* v = mesh.triangles + 3 * f;
                if (NamesAVertexTwice(v)) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::size_t ring = ringOf(v[k]);
                    if (ring - first < count) visit(f, ring, k);
                }
            }
        });
    };
    // Counts are stored two places on, so that afterwards offset_[ring + 1] is where a ring begins, and after
    // filling where it ends.
    offset_.AllocateZeros(rings + 2);
    forEachCorner([&](std::size_t, std::size_t ring, std::size_t) { ++offset_[ring + 2]; });
    for (std::size_t ring = 2; ring < offset_.size(); ++ring) offset_[ring] += offset_[ring - 1];
    corners_.AllocateZeros(offset_[rings + 1]);
    forEachCorner([&](std::size_t f, std::size_t ring, std::size_t k) {
        corners_[offset_[ring + 1]++] = CornerOf(mesh, f, k);
    });
}

inline OneRings::OneRings(const MeshView& mesh, int threads)
{
    const auto itself = [](std::size_t i) { return i; };
    Fill(mesh, mesh.vertexCount, mesh.faceCount, itself, itself, threads);
}

inline OneRings::OneRings(const MeshView& mesh, const std::uint8_t* wanted, int threads)
{
    Buffer<std::uint32_t> ringOf(mesh.vertexCount); // of those that are wanted; memory that is not touched
    Buffer<std::uint32_t> faces(mesh.faceCount);    // costs nothing
    for (std::size_t v = 0; v < mesh.vertexCount; ++v) {
        if (!wanted[v]) continue;
        ringOf[v] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(static_cast<std::uint32_t>(v));
    }
    std::size_t count = 0;
    for (std::size_t f = 0; f < mesh.faceCount; ++f) {
        const std::uint32_t* v = mesh.triangles + 3 * f;
        if ((wanted[v[0]] | wanted[v[1]] | wanted[v[2]]) != 0) faces[count++] = static_cast<std::uint32_t>(f);
    }
    const std::size_t rings = vertices_.size();
    Fill(
        mesh, rings, count, [&](std::size_t i) { return faces[i]; },
        [&](std::size_t v) { return wanted[v] != 0 ? ringOf[v] : rings; }, UsefulThreadCount(threads, count));
}

/// Whether the `next` of the corners alone are the neighbours: none is a diagonal, none is there twice, and
/// each is the `previous` of another corner. True for every vertex inside a triangulated surface; a vertex
/// may be called irregular by mistake, which costs time only.
inline bool OneRings::IsRegular(ArrayView<RingCorner> corners) const
{
    std::uint32_t balance = 0;
    std::uint64_t seen = 0;
    for (const RingCorner& corner : corners) {
        const std::uint32_t mixed = MixedBits(corner.next);
        const std::uint64_t bit = std::uint64_t{1} << (mixed >> 26);
        if ((seen & bit) != 0 || corner.nextIsFaux || corner.previousIsFaux) return false;
        balance += mixed - MixedBits(corner.previous);
        seen |= bit;
    }
    return balance == 0;
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
