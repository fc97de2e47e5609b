// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// Points of the original, its vertices first, each on the list of the live face that covers it: the one that
/// was found closest. A collapse moves the points of its star from list to list and touches no others, so
/// stars that share no face can do so at the same time.
struct CoveredPoints {
    Buffer<SurfacePoint> points; ///< weight: the distance to the face, or a little more
    Buffer<std::uint32_t> face;  ///< kNone: of a vertex without faces
    Buffer<std::uint32_t> next;  ///< on the same list
    Buffer<std::uint32_t> place; ///< where a trial has the point in its own list; stale elsewhere
    Buffer<std::uint8_t> strict; ///< not 0: whole faces are proven wherever this point is
    Buffer<std::uint32_t> first; ///< of every face

    void Allocate(std::size_t pointCount, std::size_t faceCount)
    {
        points.Allocate(pointCount);
        face.Allocate(pointCount);
        next.Allocate(pointCount);
        place.Allocate(pointCount);
        strict.Allocate(pointCount);
        first.Allocate(faceCount);
        std::fill(face.begin(), face.end(), kNone);
        std::fill(place.begin(), place.end(), 0u);
        std::fill(strict.begin(), strict.end(), std::uint8_t{0});
        std::fill(first.begin(), first.end(), kNone);
    }
    Vector3<float> Position(std::uint32_t point) const
    {
        return {points[point].x, points[point].y, points[point].z};
    }
    float Distance(std::uint32_t point) const { return points[point].weight; }

    /// Puts \p point, which is on no list, on that of \p onto.
    void Attach(std::uint32_t point, std::uint32_t onto, float distance)
    {
        points[point].weight = distance;
        StoreRelaxed(face[point], onto); // a trial in another block may ask where it is
        next[point] = first[onto];
        first[onto] = point;
    }
};

} // namespace vcg_ext
