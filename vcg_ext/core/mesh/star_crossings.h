// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/crossing_triangles.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/live_faces.h"

namespace vcg_ext
{

/// A triangle of exact coordinates, and a box in the frame, in single precision, that it is surely in.
struct BoxedTriangle {
    ExactTriangle corners;
    Box3<float> box = EmptyBox<float>();

    BoxedTriangle(const ExactTriangle& of, const Box3<float>& around) : corners(of), box(around) {}
    /// \param of a triangle in the frame
    explicit BoxedTriangle(const ExactTriangle& of) : corners(of)
    {
        for (const ExactPoint& p : corners)
            box.Add({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        box.Grow(kBoxMargin);
    }
};

/// The faces around a vertex, or around both ends of an edge.
using ExactStar = std::vector<BoxedTriangle>;

/// Pairs of crossing faces of a star, and of one of them with another face; \p enough where there are so
/// many. \param others holds those \param triangleOf triangleOf(face) of the others, a pointer to a
/// BoxedTriangle; null where the face is gone or in the star
template <class TriangleOf>
std::size_t CountCrossings(const ExactStar& star, const LiveFaces& others, const TriangleOf& triangleOf,
                           std::size_t enough)
{
    std::size_t count = 0;
    Box3<float> around = EmptyBox<float>();
    for (std::size_t i = 0; i < star.size() && count < enough; ++i) {
        around.Add(star[i].box.low);
        around.Add(star[i].box.high);
        for (std::size_t k = 0; k < i; ++k) count += TrianglesCross(star[i].corners, star[k].corners);
    }
    others.ForEachNear(around, [&](std::uint32_t face) {
        if (count >= enough) return;
        const BoxedTriangle* const other = triangleOf(face);
        if (!other) return;
        for (const BoxedTriangle& triangle : star)
            if (triangle.box.Meets(other->box)) count += TrianglesCross(triangle.corners, other->corners);
    });
    return count;
}

/// Do more faces cross with a star as \p after than as it is, before()? \param others as CountCrossings
template <class Before, class TriangleOf>
bool MakesCrossings(const ExactStar& after, const Before& before, const LiveFaces& others,
                    const TriangleOf& triangleOf)
{
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    if (CountCrossings(after, others, triangleOf, 1) == 0) return false;
    const std::size_t present = CountCrossings(before(), others, triangleOf, kAll);
    return present == 0 || CountCrossings(after, others, triangleOf, present + 1) > present;
}

} // namespace vcg_ext
