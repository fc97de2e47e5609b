// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/one_ring.h"
#include "vcg_ext/core/descriptor/one_ring_descriptors.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/float8.h"
#include "vcg_ext/core/descriptor/vertex_normal.h"
#include "vcg_ext/core/descriptor/vertex_sums.h"

namespace vcg_ext
{

/// A vertex with more edges that it may have twice than this is done by its ring.
constexpr std::ptrdiff_t kMaxRepeated = 8;

/// The descriptors |sum e.n| / sum |e| of four vertices.
/// \param regular the faces close up around the vertex, and all of them could be weighed. Sometimes false
/// without reason.
inline Float4 FourDescriptors(const VertexSums* sums, Int4& regular)
{
    constexpr float kLongest = 1e9f; // its fourth power is a float
    // of a regular vertex: each of them adds a bit to `seen`, or may be there twice
    constexpr float kMaxNeighbours = 64 + kMaxRepeated;
    constexpr float kCancelled2 = kCancelledNormal * kMaxNeighbours * (kCancelledNormal * kMaxNeighbours);
    Float4 left[kLanes], right[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
        left[i] = LoadUnaligned(sums[i].value);
        right[i] = LoadUnaligned(sums[i].value + kLanes);
    }
    Transpose(left[0], left[1], left[2], left[3]);
    Transpose(right[0], right[1], right[2], right[3]);
    const Float4 balance = left[0], length = right[0];
    const Float4x3 edges{left[1], left[2], left[3]}, normal{right[1], right[2], right[3]};
    const Float4 normal2 = Dot(normal, normal), height = Dot(normal, edges);
    regular = (balance == Float4{}) & (normal2 > kCancelled2) & (length < kLongest);
    return Max(height, -height) / (Sqrt(normal2) * length);
}

/// Takes the descriptors of the vertices [begin, end) from their sums.
/// \param irregular is set for those to which the sums do not apply
inline void ReadSums(const VertexSums* sums, std::size_t begin, std::size_t end, double* values,
                     std::uint8_t* irregular)
{
    for (std::size_t v = begin; v < end; v += kLanes) {
        Int4 regular;
        const Float4 four = FourDescriptors(sums + v, regular);
        const std::size_t count = std::min<std::size_t>(kLanes, end - v);
        for (std::size_t i = 0; i < count; ++i) values[v + i] = static_cast<double>(four[i]);
        if (AllLanes(regular)) continue;
        for (std::size_t i = 0; i < count; ++i) {
            if (regular[i]) continue;
            values[v + i] = 0;
            const std::uint64_t seen = sums[v + i].seen; // 0 or a single face: flat
            if (seen != 0 && !HasOneNext(seen)) irregular[v + i] = 1;
        }
    }
}

/// Marks the vertices that really have a neighbour twice, and those with so many that it is not worth a look.
/// Where the faces close up around both of its ends, an edge with four faces starts twice at either.
inline void MarkRepeated(std::vector<DirectedEdge> edges, std::uint8_t* irregular)
{
    std::sort(edges.begin(), edges.end());
    for (auto edge = edges.begin(); edge != edges.end();) {
        const std::uint32_t v = edge->from;
        const auto end = std::find_if(edge, edges.end(), [&](const DirectedEdge& e) { return e.from != v; });
        if (end - edge > kMaxRepeated || std::any_of(edge, end, [&](const DirectedEdge& e) {
                return std::binary_search(edges.begin(), edges.end(), DirectedEdge{e.to, v});
            }))
            irregular[v] = 1;
        edge = end;
    }
}

/// What the threads found, for the whole mesh.
inline void MarkRepeated(const std::vector<RepeatedEdges>& found, std::uint8_t* irregular)
{
    std::vector<DirectedEdge> all;
    for (const RepeatedEdges& part : found) all.insert(all.end(), part.edges.begin(), part.edges.end());
    if (all.size() < found.front().most) return MarkRepeated(std::move(all), irregular);
    for (const DirectedEdge& edge : all) irregular[edge.from] = 1; // whatever the number of threads
}

/// LaplacianDescriptor of a mesh of triangles, on exactly so many threads.
/// \param eightAtOnce \pre HasAvx2() where true; the values are the same
template <class Scalar>
std::vector<double> LaplacianDescriptorOf(const MeshView& mesh, int threads, bool eightAtOnce)
{
    std::vector<double> values(mesh.vertexCount);
    Buffer<VertexSums> sums;
    sums.AllocateZeros(mesh.vertexCount);
    Buffer<std::uint8_t> irregular; // one byte a vertex
    irregular.AllocateZeros(mesh.vertexCount);
    // Every thread walks over all faces for a range of vertices of its own: nothing is shared, and whatever
    // their number, the faces of a vertex are added in the same order.
    const auto ranges = static_cast<std::size_t>(threads);
    const auto bound = [&](std::size_t range) { // four sums are read at once
        return range == ranges ? mesh.vertexCount : mesh.vertexCount * range / ranges / kLanes * kLanes;
    };
    const std::size_t most = mesh.faceCount / 8; // to sort more costs as much as the rings
    std::vector<RepeatedEdges> repeated(ranges, {{}, most, irregular.data()});
    ParallelFor(threads, ranges, [&](std::size_t range, int) {
        const std::size_t begin = bound(range), end = bound(range + 1);
        const VertexRange vertices{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        SumFaces<Scalar>(mesh, vertices, sums.data(), eightAtOnce, repeated[range]);
        ReadSums(sums.data(), begin, end, values.data(), irregular.data());
    });
    sums.Release();
    MarkRepeated(repeated, irregular.data());
    if (std::find(irregular.begin(), irregular.end(), 1) == irregular.end()) return values;
    FoldOneRings<LaplacianFold, Scalar>(mesh, OneRings(mesh, irregular.data(), threads), threads, values);
    return values;
}

} // namespace vcg_ext
