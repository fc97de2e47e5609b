// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
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
    static constexpr std::uint16_t kMarks = 7;

    float normalAndLength[4];    ///< sum of chord-weighted normals; sum of edge lengths
    float edges[3];              ///< sum of edges
    std::uint32_t balance;       ///< 0 where every next vertex of a face is the previous one of another
    std::uint16_t marks[kMarks]; ///< of the next vertices, to see one come twice
    std::uint16_t faces;

    void AddGeometry(Float4 weightedNormalAndLength, Float4 twoEdges)
    {
        Store(normalAndLength, Load(normalAndLength) + weightedNormalAndLength);
        for (int i = 0; i < 3; ++i) edges[i] += twoEdges[i];
    }
    void AddLink(std::uint32_t next, std::uint32_t previous)
    {
        marks[std::min<std::uint16_t>(faces, kMarks - 1)] = static_cast<std::uint16_t>(next >> 16);
        balance += next - previous;
        faces = static_cast<std::uint16_t>(std::min(faces + 1, kMarks + 1));
    }

    /// Whether the faces close up around the vertex with two of them at every edge, so that both sums counted
    /// every neighbour twice. Sometimes false without reason (many faces), never true without.
    bool IsRegular() const { return balance == 0 && faces <= kMarks && !HasEqual(marks, faces); }

    /// |sum e.n| / sum |e|; that both sums count every neighbour twice cancels.
    double Descriptor() const
    {
        const float* n = normalAndLength;
        const float normalLength = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        const float divisor = normalLength * normalAndLength[3];
        const float height = n[0] * edges[0] + n[1] * edges[1] + n[2] * edges[2];
        if (!(normalLength > kCancelledNormal * static_cast<float>(faces))) return 0;
        return divisor > 0 ? static_cast<double>(std::fabs(height) / divisor) : 0;
    }
};
static_assert(sizeof(StarSum) == 48);

/// Adds faces, four at a time, to the sums of their vertices in [firstVertex, lastVertex).
template <class Scalar>
class StarSumPass
{
    const EdgeReader<Scalar> reader_;
    StarSum* sums_;
    std::size_t firstVertex_, vertices_;

    void AddLinks(const std::uint32_t* face)
    {
        const std::uint32_t mixed[3] = {MixedBits(face[0]), MixedBits(face[1]), MixedBits(face[2])};
        for (std::size_t k = 0; k < 3; ++k) {
            if (face[k] - firstVertex_ >= vertices_) continue;
            sums_[face[k]].AddLink(mixed[(k + 1) % 3], mixed[(k + 2) % 3]);
        }
    }

  public:
    StarSumPass(const MeshView& mesh, StarSum* sums, std::size_t firstVertex, std::size_t lastVertex)
        : reader_(mesh), sums_(sums), firstVertex_(firstVertex), vertices_(lastVertex - firstVertex)
    {
    }

    bool Concerns(const std::uint32_t* face) const
    {
        return (face[0] - firstVertex_ < vertices_ || face[1] - firstVertex_ < vertices_ ||
                face[2] - firstVertex_ < vertices_) &&
               !NamesAVertexTwice(face);
    }

    /// \pre faces has four entries; the first \p count are added
    void Add(const std::uint32_t* const* faces, std::size_t count)
    {
        Float4 edge[3][kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const auto a = reader_.At(faces[i][0]), b = reader_.At(faces[i][1]), c = reader_.At(faces[i][2]);
            edge[0][i] = Edge(a, b);
            edge[1][i] = Edge(b, c);
            edge[2][i] = Edge(c, a);
        }
        Float4x3 unit[3];
        Float4 length[3];
        for (std::size_t k = 0; k < 3; ++k) {
            unit[k] = ByCoordinate(edge[k][0], edge[k][1], edge[k][2], edge[k][3]);
            const Float4 length2 = Dot(unit[k], unit[k]);
            length[k] = Sqrt(length2);
            unit[k] = unit[k] * InverseLength(length2);
        }
        const Float4x3 normal = Cross(unit[0], unit[1]);
        const Float4 normalLength2 = Dot(normal, normal);
        Float4 rows[3][kLanes]; // of every corner: its weighted normal, the length of its two edges
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t previous = (k + 2) % 3; // the edge that leads to vertex k
            const Float4x3 weighted = normal * ChordWeight(normalLength2, unit[k] + unit[previous]);
            rows[k][0] = weighted.x;
            rows[k][1] = weighted.y;
            rows[k][2] = weighted.z;
            rows[k][3] = length[k] + length[previous];
            Transpose(rows[k][0], rows[k][1], rows[k][2], rows[k][3]);
        }
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                if (faces[i][k] - firstVertex_ >= vertices_) continue;
                sums_[faces[i][k]].AddGeometry(rows[k][i], edge[k][i] - edge[(k + 2) % 3][i]);
            }
        for (std::size_t i = 0; i < count; ++i) AddLinks(faces[i]);
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
        const std::uint32_t* faces[kLanes];
        std::size_t count = 0;
        for (std::size_t f = 0; f < mesh.faceCount; ++f) {
            faces[count] = mesh.triangles + 3 * f;
            if (pass.Concerns(faces[count]) && ++count == kLanes) {
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
