// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "decimation_types.h"
#include "simd.h"

namespace vcg_ext
{

/// Three coordinates of four vectors.
struct Float4x3 {
    Float4 x, y, z;
};
inline Float4 Dot(const Float4x3& a, const Float4x3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Float4x3 Cross(const Float4x3& a, const Float4x3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Float4x3 operator*(const Float4x3& a, Float4 s)
{
    return {a.x * s, a.y * s, a.z * s};
}
inline Float4x3 operator+(const Float4x3& a, const Float4x3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Float4x3 operator-(const Float4x3& a, const Float4x3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Four vectors {x, y, z, any} by coordinate.
inline Float4x3 ByCoordinate(Float4 a, Float4 b, Float4 c, Float4 d)
{
    Transpose(a, b, c, d);
    return {a, b, c};
}

/// A position as it is stored; {x, y, z, 0} in single precision, so that four lanes subtract at once.
struct Double3 {
    double x, y, z;
};
inline Float4 Edge(Float4 from, Float4 to)
{
    return to - from;
}
inline Float4 Edge(const Double3& from, const Double3& to)
{
    return Float4{static_cast<float>(to.x - from.x), static_cast<float>(to.y - from.y),
                  static_cast<float>(to.z - from.z), 0};
}

/// Reads edges of a mesh. The difference is taken in the precision of the coordinates and then rounded to
/// float: the error is relative to the edge, wherever the mesh lies.
/// \tparam Scalar of the coordinates
template <class Scalar>
class EdgeReader
{
    const unsigned char* positions_;
    std::size_t stride_;

  public:
    using Position = std::conditional_t<std::is_same_v<Scalar, double>, Double3, Float4>;

    explicit EdgeReader(const MeshView& mesh)
        : positions_(static_cast<const unsigned char*>(mesh.positions)), stride_(mesh.positionStride)
    {
    }

    Position At(std::size_t v) const
    {
        Scalar x, y, z;
        const unsigned char* p = positions_ + v * stride_;
        std::memcpy(&x, p, sizeof x);
        std::memcpy(&y, p + sizeof x, sizeof y);
        std::memcpy(&z, p + 2 * sizeof x, sizeof z);
        return Position{x, y, z};
    }

    /// The edges from \p from to the four vertices end(0) .. end(3).
    template <class End>
    Float4x3 Edges(std::size_t from, const End& end) const
    {
        const Position p = At(from);
        return ByCoordinate(Edge(p, At(end(0))), Edge(p, At(end(1))), Edge(p, At(end(2))),
                            Edge(p, At(end(3))));
    }
};

} // namespace vcg_ext
