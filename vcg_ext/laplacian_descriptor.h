// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "buffer.h"
#include "edge_reader.h"
#include "one_ring.h"
#include "one_ring_descriptors.h"
#include "parallel.h"
#include "simd.h"
#include "vertex_normals.h"

namespace vcg_ext
{

/// Whether two of the first \p count of eight values are equal (or, rarely, one of them is below eight).
inline bool HasEqual(const std::uint16_t* values, std::uint16_t count)
{
    typedef std::uint16_t Short8 __attribute__((vector_size(16)));
    const Short8 place{0, 1, 2, 3, 4, 5, 6, 7};
    const Short8 counts = reinterpret_cast<Short8>(place < count);
    Short8 a;
    std::memcpy(&a, values, sizeof a);
    a = (a & counts) | (place & ~counts);
    // every two places are 1, 2, 3 or 4 apart on the circle of eight
    const auto equal = (a == __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 0)) |
                       (a == __builtin_shufflevector(a, a, 2, 3, 4, 5, 6, 7, 0, 1)) |
                       (a == __builtin_shufflevector(a, a, 3, 4, 5, 6, 7, 0, 1, 2)) |
                       (a == __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3));
    return AnyLane(reinterpret_cast<Int4>(equal));
}

/// What one pass over the faces gathers at a vertex: small, since room is what costs most.
struct alignas(16) StarSum {
    static constexpr std::uint16_t kNext = 7;

    float normalAndLength[4]; ///< sum of chord-weighted normals; sum of edge lengths
    float edgesAndBalance[4]; ///< sum of edges; 0 where every next vertex of a face is another's previous one
    std::uint16_t next[kNext]; ///< part of the next vertices' hashes, to see one come twice
    std::uint16_t faces;       ///< saturates

    void AddGeometry(Float4 weightedNormalAndLength, Float4 twoEdges)
    {
        Store(normalAndLength, Load(normalAndLength) + weightedNormalAndLength);
        Store(edgesAndBalance, Load(edgesAndBalance) + twoEdges);
    }
    void AddNext(std::uint32_t vertex)
    {
        constexpr std::uint32_t kOddFraction = 40503; // of the golden ratio: neighbours in memory spread
        next[std::min<std::uint16_t>(faces, kNext - 1)] =
            static_cast<std::uint16_t>(vertex * kOddFraction >> 3);
        faces = static_cast<std::uint16_t>(std::min(faces + 1, kNext + 1));
    }

    /// Whether the faces close up around the vertex with two of them at every edge, so that both sums counted
    /// every neighbour twice. Sometimes false without reason (many faces).
    bool IsRegular() const { return edgesAndBalance[3] == 0 && faces <= kNext && !HasEqual(next, faces); }

    /// |sum e.n| / sum |e|; that both sums count every neighbour twice cancels.
    double Descriptor() const
    {
        const float *n = normalAndLength, *e = edgesAndBalance;
        const float normalLength = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        const float divisor = normalLength * n[3];
        if (!(normalLength > kCancelledNormal * static_cast<float>(faces))) return 0;
        return divisor > 0 ? static_cast<double>(std::fabs(n[0] * e[0] + n[1] * e[1] + n[2] * e[2]) / divisor)
                           : 0;
    }
};
static_assert(sizeof(StarSum) == 48);

/// A whole number below 2^21 that stands for a vertex: one to one up to two million of them.
///
/// Edges get the sum of their ends' marks in the fourth lane. The edge to the next vertex of a face minus the
/// edge from the previous one then has the difference of these two's marks there: summed over faces that
/// close up it is 0, and exactly so, since floats add a dozen such numbers without rounding.
inline float MarkOf(std::uint32_t vertex)
{
    return static_cast<float>(static_cast<std::int32_t>(MixedBits(vertex) >> 11));
}

/// The position {x, y, z, mark}.
inline Float4 Marked(Float4 position, float mark)
{
    return Float4{position[0], position[1], position[2], mark};
}
inline Float4 MarkedEdge(Float4 from, Float4 to)
{
    constexpr std::int32_t kSign = std::numeric_limits<std::int32_t>::min();
    return to + Floats(Bits(from) ^ Int4{kSign, kSign, kSign, 0});
}

struct MarkedDouble3 {
    Double3 position;
    float mark;
};
inline MarkedDouble3 Marked(const Double3& position, float mark)
{
    return {position, mark};
}
inline Float4 MarkedEdge(const MarkedDouble3& from, const MarkedDouble3& to)
{
    Float4 edge = Edge(from.position, to.position);
    edge[3] = from.mark + to.mark;
    return edge;
}

/// Adds faces, four at a time, to the sums of their vertices in [firstVertex, lastVertex).
template <class Scalar>
class StarSumPass
{
    const EdgeReader<Scalar> reader_;
    StarSum* sums_;
    std::size_t firstVertex_, vertices_;

    /// Of every corner and face: the weighted normal, and the length of the two edges.
    static void WeighCorners(const Float4 (&edge)[3][kLanes], Float4 (&rows)[3][kLanes])
    {
        Float4x3 unit[3];
        Float4 length[3];
        for (std::size_t k = 0; k < 3; ++k) {
            unit[k] = ByCoordinate(edge[k][0], edge[k][1], edge[k][2], edge[k][3]);
            const Float4 length2 = Dot(unit[k], unit[k]);
            length[k] = Sqrt(length2);
            unit[k] = unit[k] * Select(length2 > kSmallestLength2, 1.0f / length[k], Float4{});
        }
        const Float4x3 normal = Cross(unit[0], unit[1]);
        const Float4 sine2 = Dot(normal, normal);
        const Float4 scale = Select(sine2 > kSmallestSine * kSmallestSine, 1.0f / sine2, Float4{});
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t previous = (k + 2) % 3; // the edge that leads to vertex k
            const Float4x3 chord = unit[k] + unit[previous];
            const Float4x3 weighted = normal * Sqrt(Dot(chord, chord) * scale);
            rows[k][0] = weighted.x;
            rows[k][1] = weighted.y;
            rows[k][2] = weighted.z;
            rows[k][3] = length[k] + length[previous];
            Transpose(rows[k][0], rows[k][1], rows[k][2], rows[k][3]);
        }
    }

  public:
    StarSumPass(const MeshView& mesh, StarSum* sums, std::size_t firstVertex, std::size_t lastVertex)
        : reader_(mesh), sums_(sums), firstVertex_(firstVertex), vertices_(lastVertex - firstVertex)
    {
    }

    bool IsMine(std::uint32_t vertex) const { return vertex - firstVertex_ < vertices_; }

    /// \pre faces has four entries; the first \p count are added
    void Add(const std::uint32_t* const* faces, std::size_t count)
    {
        Float4 edge[3][kLanes], rows[3][kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const auto at = [&](std::size_t k) {
                return Marked(reader_.At(faces[i][k]), MarkOf(faces[i][k]));
            };
            const auto a = at(0), b = at(1), c = at(2);
            edge[0][i] = MarkedEdge(a, b);
            edge[1][i] = MarkedEdge(b, c);
            edge[2][i] = MarkedEdge(c, a);
        }
        WeighCorners(edge, rows);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                if (!IsMine(faces[i][k])) continue;
                StarSum& sum = sums_[faces[i][k]];
                sum.AddGeometry(rows[k][i], edge[k][i] - edge[(k + 2) % 3][i]);
                sum.AddNext(faces[i][(k + 1) % 3]);
            }
    }
};

/// LaplacianDescriptor of a mesh of triangles, on exactly so many threads.
template <class Scalar>
std::vector<double> LaplacianDescriptorOf(const MeshView& mesh, int threads)
{
    Buffer<StarSum> sums(mesh.vertexCount);
    std::vector<double> values(mesh.vertexCount);
    std::vector<std::uint8_t> irregular(mesh.vertexCount, 0);
    // Every thread walks over all faces for a range of vertices of its own: nothing is shared, and whatever
    // their number, the faces of a vertex are added in the same order.
    const auto ranges = static_cast<std::size_t>(threads);
    ParallelFor(threads, ranges, [&](std::size_t range, int) {
        const std::size_t first = mesh.vertexCount * range / ranges;
        const std::size_t last = mesh.vertexCount * (range + 1) / ranges;
        std::memset(sums.data() + first, 0, (last - first) * sizeof(StarSum));
        StarSumPass<Scalar> pass(mesh, sums.data(), first, last);
        const auto concerns = [&](const std::uint32_t* v) {
            return !NamesAVertexTwice(v) &&
                   (ranges == 1 || pass.IsMine(v[0]) || pass.IsMine(v[1]) || pass.IsMine(v[2]));
        };
        const std::uint32_t* faces[kLanes];
        std::size_t count = 0;
        for (std::size_t f = 0; f < mesh.faceCount; ++f) {
            faces[count] = mesh.triangles + 3 * f;
            if (concerns(faces[count]) && ++count == kLanes) {
                pass.Add(faces, count);
                count = 0;
            }
        }
        if (count > 0) {
            std::fill(faces + count, faces + kLanes, faces[0]);
            pass.Add(faces, count);
        }
        for (std::size_t v = first; v < last; ++v) {
            values[v] = sums[v].Descriptor();
            irregular[v] = !sums[v].IsRegular();
        }
    });
    if (std::find(irregular.begin(), irregular.end(), 1) == irregular.end()) return values;
    FoldOneRings<LaplacianFold, Scalar>(mesh, OneRings(mesh, threads, irregular.data()), threads, values);
    return values;
}

/// The Laplacian descriptor (Eq. 5) of every vertex, 0 where it has no faces; within float rounding the same
/// as OneRingDescriptor<LaplacianFold>, several times faster: one pass over the faces counts every neighbour
/// twice; the few vertices where that is not so (borders, non-manifold edges) are done again by their rings.
/// \param threads 0: all \pre as OneRings
inline std::vector<double> LaplacianDescriptor(const MeshView& mesh, int threads = 1)
{
    if (mesh.fauxEdges != nullptr) return OneRingDescriptor<LaplacianFold>(mesh, threads);
    threads = ThreadsThatPay(threads, mesh.faceCount);
    return mesh.doublePositions ? LaplacianDescriptorOf<double>(mesh, threads)
                                : LaplacianDescriptorOf<float>(mesh, threads);
}

} // namespace vcg_ext
