// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/vector.h"

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

} // namespace vcg_ext
