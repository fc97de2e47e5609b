// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "vcg_ext/core/descriptor/edge_reader.h"
#include "vcg_ext/core/mesh/one_ring.h"
#include "vcg_ext/core/base/simd.h"

// The vertex normal of the descriptors: every face's unit normal counts with the chord sqrt(2 - 2 cos) of its
// angle at the vertex. Angle weights are what makes the descriptor tell creases from noise; the chord follows
// the angle closely (2 at pi) without trigonometry.

namespace vcg_ext
{

/// Below this sine of a corner the direction of the face's normal is rounding: the face is left out.
constexpr float kSmallestSine = 1e-6f;
/// A sum of weighted unit normals shorter than this for each of them is rounding: opposite ones cancel.
constexpr float kCancelledNormal = 1e-6f;
/// Squared lengths below it are those of coincident points.
constexpr float kSmallestLength2 = 1e-36f;

/// 1 / length of four vectors, 0 for those of coincident points.
inline Float4 InverseLength(Float4 length2)
{
    return Select(length2 > kSmallestLength2, 1.0f / Sqrt(length2), Float4{});
}

/// The chord over the length of \p normal, where that is not below kSmallestSine, otherwise 0.
/// \param normal cross product of two unit edges of the face \param chord between the unit edges of the
/// corner
inline Float4 ChordWeight(Float4 normalLength2, const Float4x3& chord)
{
    return Select(normalLength2 > kSmallestSine * kSmallestSine, Sqrt(Dot(chord, chord) / normalLength2),
                  Float4{});
}

/// The unit normal at \p v; zero where it has no direction (no faces, opposite ones).
template <class Scalar>
std::array<float, 3> VertexNormal(const EdgeReader<Scalar>& reader, std::size_t v,
                                  ArrayView<RingCorner> corners)
{
    Float4x3 sum{};
    for (std::size_t i = 0; i < corners.size(); i += kLanes) {
        const std::size_t last = corners.size() - 1;
        const auto corner = [&](std::size_t lane) { return corners[std::min(i + lane, last)]; };
        Float4x3 a = reader.Edges(v, [&](std::size_t lane) { return corner(lane).next; });
        Float4x3 b = reader.Edges(v, [&](std::size_t lane) { return corner(lane).previous; });
        a = InverseLength(Dot(a, a)) * a;
        b = InverseLength(Dot(b, b)) * b;
        const Float4x3 normal = Cross(a, b);
        const Int4 lanes = FirstLanes(static_cast<int>(std::min<std::size_t>(last + 1 - i, kLanes)));
        sum = sum + Select(lanes, ChordWeight(Dot(normal, normal), a - b), Float4{}) * normal;
    }
    std::array<float, 3> n{SumLanes(sum.x), SumLanes(sum.y), SumLanes(sum.z)};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const bool cancelled = !(length > kCancelledNormal * static_cast<float>(corners.size()));
    for (float& x : n) x = cancelled ? 0 : x / length;
    return n;
}

} // namespace vcg_ext
