// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/mesh/one_ring.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/descriptor/vertex_normal.h"

// Descriptors that a vertex, its normal n and the edges e to its neighbours define. All of them fold four
// edges at a time: Add(edges, heights e.n, which lanes count), then Value(number of neighbours).

namespace vcg_ext
{

/// l = |sum e.n| / sum |e|, Eq. 4 in Eq. 5: the |N| of both cancel. In [0, 1], dimensionless.
class LaplacianFold
{
    Float4 height_{}, length_{};

  public:
    void Add(const Float4x3& edges, Float4 heights, Int4 lanes)
    {
        height_ += Select(lanes, heights, Float4{});
        length_ += Select(lanes, Sqrt(Dot(edges, edges)), Float4{});
    }
    double Value(std::size_t) const
    {
        const float length = SumLanes(length_);
        return length > 0 ? static_cast<double>(std::fabs(SumLanes(height_)) / length) : 0;
    }
};

/// |sum (e / |e|).n| / |N|: the same with every edge brought to length 1. In [0, 1], dimensionless.
class NormalizedUmbrellaFold
{
    Float4 sine_{};

  public:
    void Add(const Float4x3& edges, Float4 heights, Int4 lanes)
    {
        sine_ += Select(lanes, heights * InverseLength(Dot(edges, edges)), Float4{});
    }
    double Value(std::size_t neighbours) const
    {
        return static_cast<double>(std::fabs(SumLanes(sine_))) / static_cast<double>(neighbours);
    }
};

/// The mean over the one-ring of the normal curvatures |2 n.e| / |e|^2, in 1 / length; after Wang et al.,
/// "A feature preserved mesh simplification algorithm" (2011). That paper was not at hand: this is the mean
/// curvature of the circles through v and each neighbour that are tangent to the surface at v.
class CurvatureEstimationFold
{
    Float4 curvature_{};

  public:
    void Add(const Float4x3& edges, Float4 heights, Int4 lanes)
    {
        const Float4 inverse = InverseLength(Dot(edges, edges));
        const Float4 sine = heights * inverse;
        curvature_ += Select(lanes, 2.0f * Max(sine, -sine) * inverse, Float4{});
    }
    double Value(std::size_t neighbours) const
    {
        return static_cast<double>(SumLanes(curvature_)) / static_cast<double>(neighbours);
    }
};

template <class Fold, class Scalar>
double FoldOneRing(const EdgeReader<Scalar>& reader, std::size_t v, const std::array<float, 3>& normal,
                   ArrayView<std::uint32_t> neighbours)
{
    Fold fold;
    const Float4x3 n{Splat(normal[0]), Splat(normal[1]), Splat(normal[2])};
    for (std::size_t i = 0; i < neighbours.size(); i += kLanes) {
        const std::size_t last = neighbours.size() - 1;
        const Float4x3 edges =
            reader.Edges(v, [&](std::size_t lane) { return neighbours[std::min(i + lane, last)]; });
        fold.Add(edges, Dot(edges, n),
                 FirstLanes(static_cast<int>(std::min<std::size_t>(last + 1 - i, kLanes))));
    }
    return fold.Value(neighbours.size());
}

/// Writes the descriptor of every vertex that has a ring to \p values, 0 where it has no neighbours.
/// \tparam Fold one of the above \tparam Scalar of the coordinates
template <class Fold, class Scalar>
void FoldOneRings(const MeshView& mesh, const OneRings& rings, int threads, std::vector<double>& values)
{
    constexpr std::size_t kGrain = 4096;
    const EdgeReader<Scalar> reader(mesh);
    ParallelRanges(
        ResolveThreads(threads), rings.Count(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            std::vector<std::uint32_t> room;
            for (std::size_t ring = begin; ring < end; ++ring) {
                const std::size_t v = rings.Vertex(ring);
                const auto neighbours = rings.Neighbours(ring, room);
                values[v] = neighbours.size() == 0
                                ? 0
                                : FoldOneRing<Fold>(reader, v, VertexNormal(reader, v, rings.Corners(ring)),
                                                    neighbours);
            }
        });
}

/// The descriptor of every vertex, 0 where it has no faces.
/// \param threads 0: all \pre as OneRings \tparam Fold one of the above
template <class Fold>
std::vector<double> OneRingDescriptor(const MeshView& mesh, int threads = 1)
{
    std::vector<double> values(mesh.vertexCount, 0);
    threads = UsefulThreadCount(threads, mesh.faceCount);
    const OneRings rings(mesh, threads);
    if (mesh.doublePositions)
        FoldOneRings<Fold, double>(mesh, rings, threads, values);
    else
        FoldOneRings<Fold, float>(mesh, rings, threads, values);
    return values;
}

} // namespace vcg_ext
