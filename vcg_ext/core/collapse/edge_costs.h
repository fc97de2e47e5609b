// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "vcg_ext/core/base/float8.h"
#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/collapse/state.h"
namespace vcg_ext
{

/// Writes the neighbours of \p v. \return false if one of them lies outside \p range
inline bool CollectNeighbours(const SweepState& state, std::uint32_t v, const VertexRange& range,
                              NeighbourScratch& neighbours)
{
    const std::uint32_t count = state.cornerCount[v];
    const Corner* list = state.CornersOf(v);
    neighbours.Reserve(2 * std::size_t{count});
    std::uint32_t* vertex = neighbours.vertex.data();
    bool inside = true;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = state.Next(list[i]), previous = state.Previous(list[i]);
        vertex[i] = next;
        vertex[count + i] = previous;
        inside &= range.Has(next);
        inside &= range.Has(previous);
    }
    neighbours.size = count;
    if (!inside) return false;
    if (state.Has(v, kBorderVertex)) { // otherwise each neighbour is some corner's next
        std::sort(vertex, vertex + 2 * std::size_t{count});
        neighbours.size =
            static_cast<std::uint32_t>(std::unique(vertex, vertex + 2 * std::size_t{count}) - vertex);
    }
    return true;
}

/// One vertex in every lane. \tparam Real Float4 or Float8
template <class Real>
[[gnu::always_inline]] inline EdgeEnd<Real> BroadcastEnd(const EdgeEnd<float>& end)
{
    const SymmetricMatrix3<float>&star = end.star, &history = end.history.matrix;
    const auto lanes = [](float x) __attribute__((always_inline))
    {
        return Broadcast<Real>(x);
    };
    return {{lanes(end.position.x), lanes(end.position.y), lanes(end.position.z)},
            lanes(end.weight),
            {lanes(star.xx), lanes(star.xy), lanes(star.xz), lanes(star.yy), lanes(star.yz), lanes(star.zz)},
            {{lanes(history.xx), lanes(history.xy), lanes(history.xz), lanes(history.yy), lanes(history.yz),
              lanes(history.zz)},
             {lanes(end.history.linear.x), lanes(end.history.linear.y), lanes(end.history.linear.z)},
             lanes(end.history.constant)}};
}

/// Vertices side by side, as many as \p Real has lanes.
template <class Real>
[[gnu::always_inline]] inline EdgeEnd<Real> LoadEnds(const SweepState& state, const std::uint32_t* v)
{
    const float* rows[kLanesOf<Real>];
    for (std::size_t lane = 0; lane < kLanesOf<Real>; ++lane) rows[lane] = state.vertices[v[lane]].value;
    EdgeEnd<Real> ends;
    SymmetricMatrix3<Real>& star = ends.star;
    SymmetricMatrix3<Real>& matrix = ends.history.matrix;
    Vector3<Real>& linear = ends.history.linear;
    LoadRows(rows, 0, ends.position.x, ends.position.y, ends.position.z, ends.weight);
    LoadRows(rows, 4, star.xx, star.xy, star.xz, star.yy);
    LoadRows(rows, 8, star.yz, star.zz, matrix.xx, matrix.xy);
    LoadRows(rows, 12, matrix.xz, matrix.yy, matrix.yz, matrix.zz);
    LoadRows(rows, 16, linear.x, linear.y, linear.z, ends.history.constant);
    return ends;
}

/// With fixed vertices about, the placement is the fixed end, and an edge between two of them has no cost.
/// \return the offset of the placement from the edge's midpoint
inline Vector3<Float4> OffsetToFixedEnd(const SweepState& state, std::uint32_t v, const std::uint32_t* w,
                                        const Vector3<Float4>& half, const Vector3<Float4>& free)
{
    Int4 fixed;
    for (int lane = 0; lane < kLanes; ++lane) fixed[lane] = state.Has(w[lane], kFixedVertex) ? -1 : 0;
    const Float4 towards = state.Has(v, kFixedVertex) ? Splat(-1.0f) : Splat(1.0f);
    if (state.Has(v, kFixedVertex)) fixed = Splat(std::int32_t{-1});
    return {Select(fixed, towards * half.x, free.x), Select(fixed, towards * half.y, free.y),
            Select(fixed, towards * half.z, free.z)};
}

/// Costs of the edges from \p v to all collected neighbours, several at a time. No lane knows of another.
/// \param placementOf offset of the placement from the midpoint: (first of the neighbours, half edges, free)
template <class Real, class Placement>
[[gnu::always_inline]] inline void EvaluateEdgesBy(const SweepState& state, std::uint32_t v,
                                                   NeighbourScratch& neighbours, const Placement& placementOf)
{
    std::uint32_t* w = neighbours.vertex.data();
    const std::uint32_t size = neighbours.size;
    for (std::size_t i = 0; i < kLanesOf<Real>; ++i) w[size + i] = w[size - 1];
    const Real distanceArea = Broadcast<Real>(state.distanceArea);
    const EdgeEnd<Real> a = BroadcastEnd<Real>(state.vertices[v].End());
    for (std::uint32_t i = 0; i < size; i += kLanesOf<Real>) {
        const EdgeEnd<Real> b = LoadEnds<Real>(state, w + i);
        const Vector3<Real> half = HalfEdgeVector(a, b);
        const Vector3<Real> offset = placementOf(w + i, half, OptimalOffset(a, b, half));
        const Real cost = EdgeCost(a, b, half, offset, distanceArea);
        std::memcpy(&neighbours.cost[i], &cost, sizeof cost);
    }
}

#ifdef VCG_EXT_HAS_FLOAT8
VCG_EXT_FOR_AVX2 inline void EvaluateFreeEdgesByEight(const SweepState& state, std::uint32_t v,
                                                      NeighbourScratch& neighbours)
{
    EvaluateEdgesBy<Float8>(
        state, v, neighbours,
        [](auto*, const auto&, const auto& free) __attribute__((always_inline)) { return free; });
}
#else
inline void EvaluateFreeEdgesByEight(const SweepState&, std::uint32_t, NeighbourScratch&) {}
#endif

/// Costs of the edges from \p v to all collected neighbours.
inline void EvaluateEdges(const SweepState& state, std::uint32_t v, NeighbourScratch& neighbours)
{
    if (!state.anyFixed) {
        if (state.eightAtOnce && neighbours.size > kLanes)
            EvaluateFreeEdgesByEight(state, v, neighbours);
        else
            EvaluateEdgesBy<Float4>(state, v, neighbours,
                                    [](auto*, const auto&, const auto& free) { return free; });
        return;
    }
    EvaluateEdgesBy<Float4>(state, v, neighbours,
                            [&](const std::uint32_t* w, const auto& half, const auto& free) {
                                return OffsetToFixedEnd(state, v, w, half, free);
                            });
    if (!state.Has(v, kFixedVertex)) return;
    for (std::uint32_t i = 0; i < neighbours.size; ++i)
        if (state.Has(neighbours.vertex[i], kFixedVertex)) neighbours.cost[i] = kNoKey;
}

} // namespace vcg_ext
