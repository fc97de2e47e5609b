// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "sweep_scratch.h"
#include "sweep_state.h"

namespace vcg_ext::sweeps
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
        inside &= range.Contains(next) & range.Contains(previous);
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

inline EdgeEnd<Float4> SplatEnd(const EdgeEnd<float>& end)
{
    const auto vector = [](const Vector3<float>& a) {
        return Vector3<Float4>{Splat(a.x), Splat(a.y), Splat(a.z)};
    };
    const auto matrix = [](const SymmetricMatrix3<float>& m) {
        return SymmetricMatrix3<Float4>{Splat(m.xx), Splat(m.xy), Splat(m.xz),
                                        Splat(m.yy), Splat(m.yz), Splat(m.zz)};
    };
    return {vector(end.position),
            Splat(end.weight),
            matrix(end.star),
            {matrix(end.history.matrix), vector(end.history.linear), Splat(end.history.constant)}};
}

/// Four vertices side by side.
inline EdgeEnd<Float4> LoadEnds(const SweepState& state, const std::uint32_t* v)
{
    const float* rows[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) rows[lane] = state.vertices[v[lane]].value;
    EdgeEnd<Float4> ends;
    const auto load = [&](int slot, Float4& a, Float4& b, Float4& c, Float4& d) {
        LoadTransposed(rows[0] + slot, rows[1] + slot, rows[2] + slot, rows[3] + slot, a, b, c, d);
    };
    SymmetricMatrix3<Float4>& star = ends.star;
    SymmetricMatrix3<Float4>& matrix = ends.history.matrix;
    Vector3<Float4>& linear = ends.history.linear;
    load(0, ends.position.x, ends.position.y, ends.position.z, ends.weight);
    load(4, star.xx, star.xy, star.xz, star.yy);
    load(8, star.yz, star.zz, matrix.xx, matrix.xy);
    load(12, matrix.xz, matrix.yy, matrix.yz, matrix.zz);
    load(16, linear.x, linear.y, linear.z, ends.history.constant);
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

/// Costs of the edges from \p v to all collected neighbours, four at a time.
inline void EvaluateEdges(const SweepState& state, std::uint32_t v, NeighbourScratch& neighbours)
{
    std::uint32_t* w = neighbours.vertex.data();
    const std::uint32_t size = neighbours.size;
    for (int i = 0; i < kLanes; ++i) w[size + static_cast<std::uint32_t>(i)] = w[size - 1];
    const EdgeEnd<Float4> a = SplatEnd(state.vertices[v].End());
    for (std::uint32_t i = 0; i < size; i += kLanes) {
        const EdgeEnd<Float4> b = LoadEnds(state, w + i);
        const Vector3<Float4> half = HalfEdgeVector(a, b);
        Vector3<Float4> offset = OptimalOffset(a, b, half);
        if (state.anyFixed) offset = OffsetToFixedEnd(state, v, w + i, half, offset);
        Store(&neighbours.cost[i], EdgeCost(a, b, half, offset));
    }
    if (!state.anyFixed || !state.Has(v, kFixedVertex)) return;
    for (std::uint32_t i = 0; i < size; ++i)
        if (state.Has(w[i], kFixedVertex)) neighbours.cost[i] = kNoKey;
}

} // namespace vcg_ext::sweeps
