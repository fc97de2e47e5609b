// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// A face around a vertex, seen from that vertex.
struct StarTriangle {
    std::uint32_t face;
    Corner corner;                ///< of the star's vertex
    std::uint32_t next, previous; ///< the other two vertices
    Vector3<float> toNext, toPrevious;
    PreparedTriangle<float> triangle;
};
using Star = Scratch<StarTriangle>;

inline void GatherStar(const SurfaceArrays& surface, std::uint32_t v, Star& star)
{
    const Corner* corners = BeginCorners(surface, v);
    const Vector3<float> origin = PositionOf(surface, v);
    star.Resize(surface.cornerCount[v]);
    for (std::size_t i = 0; i < star.size(); ++i) {
        StarTriangle& s = star[i];
        s.corner = corners[i];
        s.face = FaceOf(corners[i]);
        s.next = NextVertex(surface, corners[i]);
        s.previous = PreviousVertex(surface, corners[i]);
        s.toNext = PositionOf(surface, s.next) - origin;
        s.toPrevious = PositionOf(surface, s.previous) - origin;
        s.triangle = PrepareTriangle(s.toNext, s.toPrevious);
    }
}

} // namespace vcg_ext
