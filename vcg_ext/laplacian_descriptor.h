// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "buffer.h"
#include "decimation_types.h"
#include "edge_reader.h"
#include "one_ring.h"
#include "one_ring_descriptors.h"
#include "parallel.h"
#include "simd.h"
#include "vertex_normals.h"

namespace vcg_ext
{

/// What one pass over the faces reads and gathers at a vertex: with float coordinates one line of the cache,
/// since waiting for memory is what costs most. Every neighbour is counted by the face in which it is the
/// next vertex.
/// \tparam Position Float4 or MarkedDouble3: the mark, x, y, z
template <class Position>
struct Star {
    Position position;
    Float4 balanceAndEdges; ///< sum of the previous minus the next vertices' marks; sum of edges
    Float4 lengthAndNormal; ///< sum of edge lengths; of chord-weighted normals
    std::uint64_t bits;     ///< of the vertex
    std::uint64_t seen;     ///< bits of the next vertices
};
static_assert(sizeof(Star<Float4>) == 64);

/// A whole number below 2^21 that stands for a vertex. Where the faces close up around a vertex, every next
/// vertex of one is the previous of another: the sum of their marks' differences is 0, and exactly so, since
/// the partial sums of a few such numbers fit a float's 24 bits. Where they do not close up it is 0 only if
/// the marks of the ends agree, by one chance in two million.
inline float MarkOf(std::uint32_t mixed)
{
    return static_cast<float>(static_cast<std::int32_t>(mixed >> 11));
}

/// Of 64 bits, a few that stand for a vertex among the neighbours of another: with seven of them one vertex
/// of valence 6 in 250 seems to have a neighbour twice.
inline std::uint64_t BitsOf(std::uint32_t mixed)
{
    constexpr int kBits = 7;
    const std::uint64_t places = mixed * 0x9E3779B97F4A7C15u;
    std::uint64_t bits = 0;
    for (int i = 0; i < kBits; ++i) bits |= std::uint64_t{1} << (places >> (58 - 6 * i) & 63);
    return bits;
}

struct MarkedDouble3 {
    Double2 markAndX, yz;
};
inline Float4 Marked(float mark, Float4 position)
{
    return Float4{mark, position[0], position[1], position[2]};
}
inline MarkedDouble3 Marked(float mark, const Double3& position)
{
    return {Double2{static_cast<double>(mark), position.x}, Double2{position.y, position.z}};
}
/// The difference of the marks, and the edge.
inline Float4 MarkedEdge(const MarkedDouble3& from, const MarkedDouble3& to)
{
    return Narrow(to.markAndX - from.markAndX, to.yz - from.yz);
}
inline Float4 MarkedEdge(Float4 from, Float4 to)
{
    return to - from;
}

/// Adds faces, four at a time, to the stars of their vertices in [firstVertex, lastVertex).
template <class Position>
class StarPass
{
    struct Corner {
        Float4 balanceAndEdge, lengthAndNormal;
    };

    Star<Position>* stars_;
    std::size_t firstVertex_, vertices_;
    const std::uint32_t* faces_[kLanes]{};
    Corner corners_[kLanes][3]{};
    std::size_t count_ = 0;

    /// With b and c the edges at a corner, N = b x c and g = |b||c| + b.c, the chord over |N| is
    /// sqrt(2 / (|b||c| g)). Where N is rounding, or the numbers leave the range of float, the normal becomes
    /// NaN: such a star is found irregular.
    void WeighCorners()
    {
        constexpr float kSharp2 = 1e-5f, kTiny = 1e-30f; // sin^2; a length^4
        Float4x3 edge[3];
        Float4 length[3], weight[3];
        for (std::size_t k = 0; k < 3; ++k) {
            Float4 balance = corners_[0][k].balanceAndEdge;
            edge[k] = {corners_[1][k].balanceAndEdge, corners_[2][k].balanceAndEdge,
                       corners_[3][k].balanceAndEdge};
            Transpose(balance, edge[k].x, edge[k].y, edge[k].z);
            length[k] = Sqrt(Dot(edge[k], edge[k]));
        }
        Float4x3 normal = Cross(edge[0], edge[1]);
        const Float4 normal2 = Dot(normal, normal), product01 = length[0] * length[1];
        const Int4 usual = normal2 > kSharp2 * (product01 * product01) + kTiny;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t previous = (k + 2) % 3; // the edge that leads to vertex k
            const Float4 product = length[k] * length[previous], minusDot = Dot(edge[k], edge[previous]);
            // at blunt angles the difference is rounding, but |N|^2 = (|b||c| - b.c) g
            const Float4 g = Select(minusDot < 0.0f, product - minusDot, normal2 / (product + minusDot));
            weight[k] = Sqrt(2.0f / (product * g));
        }
        normal.x = Floats(Bits(normal.x) | ~usual);
        for (std::size_t k = 0; k < 3; ++k) {
            Float4 row = length[k];
            Float4x3 weighted = normal * weight[k];
            Transpose(row, weighted.x, weighted.y, weighted.z);
            corners_[0][k].lengthAndNormal = row;
            corners_[1][k].lengthAndNormal = weighted.x;
            corners_[2][k].lengthAndNormal = weighted.y;
            corners_[3][k].lengthAndNormal = weighted.z;
        }
    }

    void ReadEdges()
    {
        for (std::size_t i = 0; i < count_; ++i) {
            const std::uint32_t* v = faces_[i];
            const Position a = stars_[v[0]].position, b = stars_[v[1]].position, c = stars_[v[2]].position;
            const Float4 ab = MarkedEdge(a, b), bc = MarkedEdge(b, c), ca = MarkedEdge(c, a);
            corners_[i][0].balanceAndEdge = FirstOfOther(ab, bc);
            corners_[i][1].balanceAndEdge = FirstOfOther(bc, ca);
            corners_[i][2].balanceAndEdge = FirstOfOther(ca, ab);
        }
    }

    void AddCorners()
    {
        for (std::size_t i = 0; i < count_; ++i) {
            const std::uint32_t v[3]{faces_[i][0], faces_[i][1], faces_[i][2]};
            for (std::size_t k = 0; k < 3; ++k) {
                if (!IsMine(v[k])) continue;
                Star<Position>& star = stars_[v[k]];
                star.balanceAndEdges += corners_[i][k].balanceAndEdge;
                star.lengthAndNormal += corners_[i][k].lengthAndNormal;
                const std::uint64_t seen = star.seen | stars_[v[(k + 1) % 3]].bits;
                if (seen == star.seen) // perhaps twice the same neighbour
                    star.balanceAndEdges[0] = std::numeric_limits<float>::infinity();
                star.seen = seen;
            }
        }
    }

  public:
    StarPass(Star<Position>* stars, std::size_t firstVertex, std::size_t lastVertex)
        : stars_(stars), firstVertex_(firstVertex), vertices_(lastVertex - firstVertex)
    {
    }

    bool IsMine(std::uint32_t vertex) const { return vertex - firstVertex_ < vertices_; }

    void Add(const std::uint32_t* face)
    {
        faces_[count_++] = face;
        if (count_ == kLanes) Flush();
    }
    void Flush()
    {
        ReadEdges();
        WeighCorners();
        AddCorners();
        count_ = 0;
    }
};

/// The descriptors |sum e.n| / sum |e| of four stars.
/// \param regular the faces close up around the vertex with two of them at every edge, and all of them could
/// be weighed. Sometimes false without reason.
template <class Position>
Float4 FourDescriptors(const Star<Position>* stars, Int4& regular)
{
    constexpr float kLongest = 1e9f;      // its fourth power is a float
    constexpr float kMostNeighbours = 64; // of a regular star: each of them adds a bit to `seen`
    constexpr float kCancelled2 = kCancelledNormal * kMostNeighbours * (kCancelledNormal * kMostNeighbours);
    Float4 balance = stars[0].balanceAndEdges, length = stars[0].lengthAndNormal;
    Float4x3 edges{stars[1].balanceAndEdges, stars[2].balanceAndEdges, stars[3].balanceAndEdges};
    Float4x3 normal{stars[1].lengthAndNormal, stars[2].lengthAndNormal, stars[3].lengthAndNormal};
    Transpose(balance, edges.x, edges.y, edges.z);
    Transpose(length, normal.x, normal.y, normal.z);
    const Float4 normal2 = Dot(normal, normal), height = Dot(normal, edges);
    regular = (balance == Float4{}) & (normal2 > kCancelled2) & (length < kLongest);
    return Max(height, -height) / (Sqrt(normal2) * length);
}

/// Takes the positions of the vertices [first, last) into their stars, and empties these.
template <class Position, class Scalar>
void StartStars(const EdgeReader<Scalar>& reader, Star<Position>* stars, std::size_t first, std::size_t last)
{
    for (std::size_t v = first; v < last; ++v) {
        const std::uint32_t mixed = MixedBits(static_cast<std::uint32_t>(v));
        stars[v] = {Marked(MarkOf(mixed), reader.At(v)), Float4{}, Float4{}, BitsOf(mixed), 0};
    }
}

/// Adds all faces at the vertices [first, last) to their stars.
template <class Position>
void AddFaces(const MeshView& mesh, Star<Position>* stars, std::size_t first, std::size_t last)
{
    constexpr std::size_t kAhead = 48; // faces: about what memory takes to answer
    const bool all = last - first == mesh.vertexCount;
    StarPass<Position> pass(stars, first, last);
    const auto add = [&](std::size_t f) {
        const std::uint32_t* v = mesh.triangles + 3 * f;
        if (all || pass.IsMine(v[0]) || pass.IsMine(v[1]) || pass.IsMine(v[2])) pass.Add(v);
    };
    std::size_t f = 0;
    for (; f + kAhead < mesh.faceCount; ++f) {
        const std::uint32_t* ahead = mesh.triangles + 3 * (f + kAhead);
        for (std::size_t k = 0; k < 3; ++k) Prefetch(stars + ahead[k]);
        add(f);
    }
    for (; f < mesh.faceCount; ++f) add(f);
    pass.Flush();
}

/// LaplacianDescriptor of a mesh of triangles, on exactly so many threads.
template <class Scalar>
std::vector<double> LaplacianDescriptorOf(const MeshView& mesh, int threads)
{
    using Position = std::conditional_t<std::is_same_v<Scalar, double>, MarkedDouble3, Float4>;
    std::vector<double> values(mesh.vertexCount);
    std::vector<std::uint8_t> irregular(mesh.vertexCount, 0);
    Buffer<Star<Position>> stars;
    stars.AllocateOnLargePages(mesh.vertexCount);
    // Every thread walks over all faces for a range of vertices of its own: nothing is shared, and whatever
    // their number, the faces of a vertex are added in the same order.
    const auto ranges = static_cast<std::size_t>(threads);
    const auto bound = [&](std::size_t range) { // four stars are read at once
        return range == ranges ? mesh.vertexCount : mesh.vertexCount * range / ranges / kLanes * kLanes;
    };
    ParallelFor(threads, ranges, [&](std::size_t range, int) {
        StartStars(EdgeReader<Scalar>(mesh), stars.data(), bound(range), bound(range + 1));
    });
    ParallelFor(threads, ranges, [&](std::size_t range, int) {
        AddFaces(mesh, stars.data(), bound(range), bound(range + 1));
        for (std::size_t v = bound(range); v < bound(range + 1); v += kLanes) {
            Int4 regular;
            const Float4 four = FourDescriptors(stars.data() + v, regular);
            for (std::size_t i = 0; i < std::min<std::size_t>(kLanes, bound(range + 1) - v); ++i) {
                values[v + i] = regular[i] ? static_cast<double>(four[i]) : 0;
                irregular[v + i] = !regular[i] && stars[v + i].seen != 0;
            }
        }
    });
    if (std::find(irregular.begin(), irregular.end(), 1) == irregular.end()) return values;
    FoldOneRings<LaplacianFold, Scalar>(mesh, OneRings(mesh, irregular), threads, values);
    return values;
}

/// The Laplacian descriptor (Eq. 5) of every vertex, 0 where it has no faces; within float rounding the same
/// as OneRingDescriptor<LaplacianFold>, several times faster: one pass over the faces counts every neighbour
/// twice; the few vertices where that is not so (borders, non-manifold edges) or where a face is a needle are
/// done again by their rings.
/// \param threads 0: all \pre as OneRings
inline std::vector<double> LaplacianDescriptor(const MeshView& mesh, int threads = 1)
{
    if (mesh.fauxEdges != nullptr) return OneRingDescriptor<LaplacianFold>(mesh, threads);
    threads = ThreadsThatPay(threads, mesh.faceCount);
    return mesh.doublePositions ? LaplacianDescriptorOf<double>(mesh, threads)
                                : LaplacianDescriptorOf<float>(mesh, threads);
}

} // namespace vcg_ext
