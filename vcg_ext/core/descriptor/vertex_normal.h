// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/one_ring.h"

// The vertex normal of the descriptors: every face's unit normal counts with the chord sqrt(2 - 2 cos) of its
// angle at the vertex. Angle weights are what makes the descriptor tell creases from noise; the chord follows
// the angle closely (2 at pi) without trigonometry.

namespace vcg_ext
{

/// Three coordinates of four vectors.
using Float4x3 = Vector3<Float4>;

/// A position as it is stored.
struct Double3 {
    Double2 xy, z; ///< z[1] is 0
};
/// {x, y, z, 0}
inline Float4 Edge(Float4 from, Float4 to)
{
    return to - from;
}
inline Float4 Edge(const Double3& from, const Double3& to)
{
    return Narrow(to.xy - from.xy, to.z - from.z);
}

/// Reads edges of a mesh. The difference is taken in the precision of the coordinates and then rounded to
/// float: the error is relative to the edge, wherever the mesh lies.
/// \tparam Scalar of the coordinates
template <class Scalar>
class EdgeReader
{
    const unsigned char* positions_;
    std::size_t stride_;
    std::uint32_t last_;

  public:
    using Position = std::conditional_t<std::is_same_v<Scalar, double>, Double3, Float4>;

    explicit EdgeReader(const MeshView& mesh)
        : positions_(static_cast<const unsigned char*>(mesh.positions)), stride_(mesh.positionStride),
          last_(static_cast<std::uint32_t>(mesh.vertexCount - 1))
    {
    }

    const unsigned char* Address(std::size_t v) const { return positions_ + v * stride_; }

    std::uint32_t Last() const { return last_; }

    /// {x, y, z, any} with one load. \pre coordinates are float, and \p v is not the last vertex
    Float4 FourAt(std::size_t v) const
    {
        Float4 four;
        std::memcpy(&four, Address(v), sizeof four);
        return four;
    }
    Position At(std::size_t v) const
    {
        if constexpr (std::is_same_v<Scalar, double>) {
            Double2 xy;
            double z;
            std::memcpy(&xy, Address(v), sizeof xy);
            std::memcpy(&z, Address(v) + sizeof xy, sizeof z);
            return {xy, Double2{z, 0}};
        } else {
            return LoadThree(Address(v));
        }
    }

    /// The edges from \p from to the four vertices end(0) .. end(3).
    template <class End>
    Float4x3 Edges(std::size_t from, const End& end) const
    {
        const Position p = At(from);
        const Float4 edges[kLanes]{Edge(p, At(end(0))), Edge(p, At(end(1))), Edge(p, At(end(2))),
                                   Edge(p, At(end(3)))};
        Float4x3 columns;
        ToColumns(edges, columns.x, columns.y, columns.z);
        return columns;
    }
};

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
