// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "vcg_ext/core/descriptor/vertex_normal.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/one_ring.h"
#include "vcg_ext/core/base/float8.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/vector.h"

// One pass over the faces that adds up, at every vertex, what the Laplacian descriptor is made of. Every
// neighbour is counted by the face in which it is the next vertex; where that does not count every neighbour
// once the sums tell so.
namespace vcg_ext
{

/// What the faces around a vertex add up to. Small, since waiting for memory is what costs most.
struct VertexSums {
    /// Of the previous minus the next vertices' marks; edges to the next; their lengths; normals, weighted by
    /// the chord.
    float value[8];
    std::uint64_t seen; ///< bits of the next vertices; 0: the vertex has no faces
};

/// A whole number below 2^21 that stands for a vertex. Where the faces close up around a vertex, every next
/// vertex of one is the previous of another: the sum of their marks' differences is 0, and exactly so, since
/// the partial sums of a few such numbers fit a float's 24 bits. Where they do not close up it is 0 only if
/// the marks of the ends agree, by one chance in two million.
template <class Real>
[[gnu::always_inline]] inline Real MarksOf(const UnsignedLike<Real>& mixed)
{
    return ToFloats(mixed >> 11);
}

/// Of 64 bits, one in every byte, that stand for a vertex among the neighbours of another: one vertex of
/// valence 6 in 250 seems to have a neighbour twice.
template <class Real>
[[gnu::always_inline]] inline void StoreBits(const UnsignedLike<Real>& mixed, std::uint64_t* bits)
{
    constexpr std::uint32_t kBelow8 = 0x07070707;
    StoreInterleaved(reinterpret_cast<std::uint32_t*>(bits), PowersOfTwo(mixed & kBelow8),
                     PowersOfTwo(mixed >> 3 & kBelow8));
}

/// The edge from one vertex to the next of a face.
struct DirectedEdge {
    std::uint32_t from, to;

    friend bool operator<(const DirectedEdge& a, const DirectedEdge& b)
    {
        return a.from != b.from ? a.from < b.from : a.to < b.to;
    }
    friend bool operator==(const DirectedEdge& a, const DirectedEdge& b)
    {
        return a.from == b.from && a.to == b.to;
    }
};

/// Whether the faces around a vertex have one next vertex. \param seen as in VertexSums, not 0
inline bool HasOneNext(std::uint64_t seen)
{
    return (seen & (seen - 0x0101010101010101u)) == 0; // no byte has two bits
}

/// Edges that a vertex may have twice, as one thread finds them.
struct RepeatedEdges {
    std::vector<DirectedEdge> edges;
    std::size_t most;        ///< of the edges
    std::uint8_t* irregular; ///< one byte a vertex, set where an edge starts that finds no room

    /// \param seen by the vertex where the edge starts
    [[gnu::noinline, gnu::cold]] void Add(DirectedEdge edge, std::uint64_t seen)
    {
        if (edges.size() < most) edges.push_back(edge);
        if (edges.size() == most || HasOneNext(seen)) irregular[edge.from] = 1;
    }
};

/// Takes the faces in batches of as many as a Real has lanes.
/// \tparam Real Float4 or Float8; the sums are the same \tparam Scalar of the coordinates
template <class Real, class Scalar>
class FaceBatch
{
    using Vectors = Vector3<Real>;
    static constexpr std::size_t kFaces = kLanesOf<Real>;

    Vectors edge_[3]; ///< from vertex k to the next
    Real mark_[3];
    std::uint64_t bits_[3][kFaces];
    alignas(32) float rows_[3][kFaces][8]; ///< what the faces add at their vertices

    /// With b and c the edges at a corner, N = b x c and p = |b||c|, the chord over |N| is the square root of
    /// 2 / (p (p + b.c)); at blunt angles, where p + b.c is rounding, it is |N|^2 / (p - b.c).
    [[gnu::always_inline]] void WeighCorners(const Real* length, const Vectors& normal, Real* weight) const
    {
        const Real normal2 = Dot(normal, normal);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t previous = (k + 2) % 3; // the edge that leads to vertex k
            const Real product = length[k] * length[previous], minusDot = Dot(edge_[k], edge_[previous]);
            const Real sum = Select(minusDot < 0.0f, product - minusDot, normal2 / (product + minusDot));
            weight[k] = Sqrt(2.0f / (product * sum));
        }
    }

    /// \param vertex the corners once more, by their place in the face
    [[gnu::always_inline]] void ReadEdges(const EdgeReader<Scalar>& reader, const std::uint32_t* corners,
                                          const UnsignedLike<Real>* vertex)
    {
        if constexpr (std::is_same_v<Scalar, float>) {
            const UnsignedLike<Real> last = UnsignedLike<Real>{} + reader.Last();
            if (__builtin_expect(!AnyLane((vertex[0] == last) | (vertex[1] == last) | (vertex[2] == last)),
                                 1)) {
                Vectors point[3];
                for (std::size_t k = 0; k < 3; ++k) {
                    Float4 rows[kFaces];
                    for (std::size_t i = 0; i < kFaces; ++i) rows[i] = reader.FourAt(corners[3 * i + k]);
                    ToColumns(rows, point[k].x, point[k].y, point[k].z);
                }
                for (std::size_t k = 0; k < 3; ++k) edge_[k] = point[(k + 1) % 3] - point[k];
                return;
            }
        }
        Float4 edges[3][kFaces];
        for (std::size_t i = 0; i < kFaces; ++i) {
            const auto a = reader.At(corners[3 * i]), b = reader.At(corners[3 * i + 1]),
                       c = reader.At(corners[3 * i + 2]);
            edges[0][i] = Edge(a, b);
            edges[1][i] = Edge(b, c);
            edges[2][i] = Edge(c, a);
        }
        for (std::size_t k = 0; k < 3; ++k) ToColumns(edges[k], edge_[k].x, edge_[k].y, edge_[k].z);
    }

  public:
    /// \param corners vertices of kFaces faces
    [[gnu::always_inline]] void Read(const EdgeReader<Scalar>& reader, const std::uint32_t* corners)
    {
        UnsignedLike<Real> vertex[3];
        LoadTriples(corners, vertex[0], vertex[1], vertex[2]);
        ReadEdges(reader, corners, vertex);
        for (std::size_t k = 0; k < 3; ++k) {
            MixBits(vertex[k]);
            mark_[k] = MarksOf<Real>(vertex[k]);
            StoreBits<Real>(vertex[k], bits_[k]);
        }
    }

    /// Where a normal is rounding, or the numbers leave the range of float, it becomes NaN.
    [[gnu::always_inline]] void Weigh()
    {
        constexpr float kSharp2 = 1e-5f, kTiny = 1e-30f; // sin^2; a length^4
        Real length[3], weight[3];
        for (std::size_t k = 0; k < 3; ++k) length[k] = Sqrt(Dot(edge_[k], edge_[k]));
        Vectors normal = Cross(edge_[0], edge_[1]);
        WeighCorners(length, normal, weight);
        const Real product = length[0] * length[1];
        const auto usual = Dot(normal, normal) > kSharp2 * (product * product) + kTiny;
        MakeNan(normal.x, ~usual);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vectors weighted = weight[k] * normal;
            const Real columns[8]{mark_[(k + 2) % 3] - mark_[(k + 1) % 3],
                                  edge_[k].x,
                                  edge_[k].y,
                                  edge_[k].z,
                                  length[k],
                                  weighted.x,
                                  weighted.y,
                                  weighted.z};
            StoreRows(rows_[k], columns);
        }
    }

    /// Adds the first \p faces of them to the sums of the vertices that \p range has, in their order.
    /// \param repeated gets edges that a vertex may have had before
    template <bool kAll>
    [[gnu::always_inline]] void AddTo(VertexSums* sums, const std::uint32_t* corners, std::size_t faces,
                                      const VertexRange& range, RepeatedEdges& repeated) const
    {
#pragma GCC unroll 8
        for (std::size_t i = 0; i < kFaces; ++i) {
            if (!kAll && i == faces) break;
#pragma GCC unroll 3
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = corners[3 * i + k];
                if (!kAll && !range.Has(v)) continue;
                VertexSums& sum = sums[v];
                AddRow<Real>(sum.value, rows_[k][i]);
                const std::uint64_t before = sum.seen;
                sum.seen |= bits_[(k + 1) % 3][i];
                if (__builtin_expect(sum.seen == before, 0))
                    repeated.Add({v, corners[3 * i + (k + 1) % 3]}, before);
            }
        }
    }
};

/// The work of one thread. \tparam Real, Scalar as of FaceBatch
template <class Real, class Scalar>
[[gnu::always_inline]] inline void SumFacesBy(const MeshView& mesh, const VertexRange& range,
                                              VertexSums* sums, RepeatedEdges& repeated)
{
    constexpr std::size_t kFaces = kLanesOf<Real>, kAhead = 32; // about what memory takes to answer
    const EdgeReader<Scalar> reader(mesh);
    FaceBatch<Real, Scalar> batch;
    const auto readAhead = [&](const std::uint32_t* corners, std::size_t faces) __attribute__((always_inline))
    {
#pragma GCC unroll 24
        for (std::size_t i = 0; i < 3 * faces; ++i) {
            const std::uint32_t v = corners[3 * kAhead + i];
            Prefetch(sums + v);
            Prefetch(reader.Address(v));
        }
    };
    std::size_t f = 0;
    const std::size_t last = mesh.faceCount > kAhead ? mesh.faceCount - kAhead : 0; // to read ahead from
    if (range.end - range.begin == mesh.vertexCount) {
        for (; f + kFaces <= last; f += kFaces) {
            const std::uint32_t* corners = mesh.triangles + 3 * f;
            readAhead(corners, kFaces);
            batch.Read(reader, corners);
            batch.Weigh();
            batch.template AddTo<true>(sums, corners, kFaces, range, repeated);
        }
    }
    std::uint32_t mine[3 * kFaces];
    std::size_t count = 0;
    for (; f < mesh.faceCount; ++f) {
        const std::uint32_t* corners = mesh.triangles + 3 * f;
        if (f < last) readAhead(corners, 1);
        if (range.Has(corners[0]) || range.Has(corners[1]) || range.Has(corners[2]))
            std::copy_n(corners, 3, mine + 3 * count++);
        if (count == 0 || (count < kFaces && f + 1 < mesh.faceCount)) continue;
        for (std::size_t i = count; i < kFaces; ++i) std::copy_n(mine, 3, mine + 3 * i);
        batch.Read(reader, mine);
        batch.Weigh();
        batch.template AddTo<false>(sums, mine, count, range, repeated);
        count = 0;
    }
}

#ifdef VCG_EXT_HAS_FLOAT8
template <class Scalar>
VCG_EXT_FOR_AVX2 void SumFacesByEight(const MeshView& mesh, const VertexRange& range, VertexSums* sums,
                                      RepeatedEdges& repeated)
{
    SumFacesBy<Float8, Scalar>(mesh, range, sums, repeated);
}
#else
template <class Scalar>
void SumFacesByEight(const MeshView&, const VertexRange&, VertexSums*, RepeatedEdges&)
{
}
#endif

/// Adds all faces at the vertices of \p range to their sums, which start from zero.
/// \param eightAtOnce \pre HasAvx2() where true; the sums are the same
/// \param repeated gets the edges that may start at such a vertex twice; others do not
template <class Scalar>
void SumFaces(const MeshView& mesh, const VertexRange& range, VertexSums* sums, bool eightAtOnce,
              RepeatedEdges& repeated)
{
    if (eightAtOnce)
        SumFacesByEight<Scalar>(mesh, range, sums, repeated);
    else
        SumFacesBy<Float4, Scalar>(mesh, range, sums, repeated);
}

} // namespace vcg_ext
