// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/geometry/vector.h"

namespace vcg_ext
{

/// A point, and a face of the other surface that is not farther from it than the limit.
struct SegmentEnd {
    Vector3<float> position;
    std::uint32_t face;
    float distance;
};

/// Pieces of a segment that are still to be proven.
using SegmentStack = std::vector<std::pair<SegmentEnd, SegmentEnd>>;

/// Is every point between \p a and \p b within \p limit of the other surface?
///
/// A piece is if both ends are within the limit of the same face: the distance to a convex set is convex
/// along a segment. It also is if its length is at most 2 limit - d_a - d_b: each of its points is then close
/// enough to one of the ends. Other pieces are halved; those of .02 limit are taken for proven, and so are
/// those whose middle is one of the ends, as single precision has no point between.
///
/// \param distance2 distance2(face, point), squared
/// \param find find(point, faceA, faceB): a SegmentEnd at the point, nothing where no face is close enough
/// \param stack room
template <class Distance2, class Find>
bool SegmentIsWithin(const SegmentEnd& a, const SegmentEnd& b, float limit, const Distance2& distance2,
                     const Find& find, SegmentStack& stack)
{
    constexpr float kShortest = 0.02F; // of the limit
    const float limit2 = limit * limit, shortest2 = kShortest * kShortest * limit2;
    stack.clear();
    stack.emplace_back(a, b);
    while (!stack.empty()) {
        const auto [p, q] = stack.back();
        stack.pop_back();
        if (p.face == q.face) continue;
        const float length2 = SquaredNorm(q.position - p.position);
        const float reach = 2 * limit - p.distance - q.distance;
        if (length2 <= shortest2 || (reach > 0 && length2 <= reach * reach)) continue;
        if (distance2(p.face, q.position) <= limit2 || distance2(q.face, p.position) <= limit2) continue;
        const Vector3<float> center = 0.5F * (p.position + q.position);
        if (SquaredNorm(center - p.position) == 0 || SquaredNorm(q.position - center) == 0) continue;
        const std::optional<SegmentEnd> middle = find(center, p.face, q.face);
        if (!middle) return false;
        stack.emplace_back(p, *middle);
        stack.emplace_back(*middle, q);
    }
    return true;
}

} // namespace vcg_ext
