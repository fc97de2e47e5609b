// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "vcg_ext/core/geometry/orientation.h"
#include "vcg_ext/core/geometry/vector.h"

// Do two triangles cross? They do where they have a point in common that is not on what they share: nothing,
// a corner, an edge, or all of it. Corners are shared where their coordinates are equal. So the faces of a
// mesh of which no two cross meet as those of a simplicial complex do; and the faces of triangle soup, those
// on both sides of a seam, and duplicates do not cross for that alone. Triangles without area, of three
// points in one line, cross nothing.

namespace vcg_ext
{

using ExactPoint = Vector3<double>;
using ExactTriangle = std::array<ExactPoint, 3>;

namespace crossing_detail
{

inline bool IsSame(const ExactPoint& a, const ExactPoint& b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Along one of the axes.
inline PlanePoint Projected(const ExactPoint& p, int axis)
{
    return axis == 0 ? PlanePoint{p.y, p.z} : axis == 1 ? PlanePoint{p.z, p.x} : PlanePoint{p.x, p.y};
}

/// An axis along which the triangle is seen with an area; nothing where it has none.
inline std::optional<int> AxisAcross(const ExactTriangle& t)
{
    for (const int axis : {0, 1, 2})
        if (Orientation(Projected(t[0], axis), Projected(t[1], axis), Projected(t[2], axis)) != 0)
            return axis;
    return std::nullopt;
}

/// Have the segments a b and c d of one plane a point in common?
inline bool SegmentsMeet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
    const int ofC = Orientation(a, b, c), ofD = Orientation(a, b, d);
    const int ofA = Orientation(c, d, a), ofB = Orientation(c, d, b);
    if (ofC * ofD > 0 || ofA * ofB > 0) return false;
    if (ofC != 0 || ofD != 0 || ofA != 0 || ofB != 0) return true;
    return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
           std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

/// \pre s, e and the triangle are in one plane
inline bool SegmentMeetsInPlane(const ExactPoint& s, const ExactPoint& e, const ExactTriangle& t, int axis)
{
    const PlanePoint a = Projected(s, axis), b = Projected(e, axis);
    const std::array<PlanePoint, 3> p = {Projected(t[0], axis), Projected(t[1], axis), Projected(t[2], axis)};
    int left = 0, right = 0; // of the edges, where a lies
    for (std::size_t k = 0; k < 3; ++k) {
        const int side = Orientation(p[k], p[(k + 1) % 3], a);
        left += side > 0;
        right += side < 0;
    }
    if (left == 0 || right == 0) return true;
    return SegmentsMeet(a, b, p[0], p[1]) || SegmentsMeet(a, b, p[1], p[2]) || SegmentsMeet(a, b, p[2], p[0]);
}

/// Have the segment s e and the triangle a point in common? \pre the triangle has an area
inline bool SegmentMeets(const ExactPoint& s, const ExactPoint& e, const ExactTriangle& t)
{
    const int ofS = Orientation(t[0], t[1], t[2], s), ofE = Orientation(t[0], t[1], t[2], e);
    if (ofS * ofE > 0) return false;
    if (ofS == 0 && ofE == 0) return SegmentMeetsInPlane(s, e, t, *AxisAcross(t));
    int left = 0, right = 0; // of the line through s and e, where the edges pass
    for (std::size_t k = 0; k < 3; ++k) {
        const int side = Orientation(s, e, t[k], t[(k + 1) % 3]);
        left += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

/// Two triangles whose shared corners come first.
struct Pair {
    ExactTriangle s, t;
    std::size_t shared = 0;
};
inline Pair Matched(const ExactTriangle& s, const ExactTriangle& t)
{
    Pair pair{s, t};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = pair.shared; k < 3; ++k)
            if (IsSame(s[i], pair.t[k])) {
                std::swap(pair.s[pair.shared], pair.s[i]);
                std::swap(pair.t[pair.shared++], pair.t[k]);
                break;
            }
    return pair;
}

/// The least and the greatest of some numbers.
struct Interval {
    double low, high;
};
inline Interval Extent(const ExactPoint& axis, const ExactTriangle& t, const ExactPoint& origin,
                       std::size_t first)
{
    Interval extent{};
    for (std::size_t k = first; k < 3; ++k) {
        const double at = Dot(axis, t[k] - origin);
        extent =
            k == first ? Interval{at, at} : Interval{std::min(extent.low, at), std::max(extent.high, at)};
    }
    return extent;
}

/// Is there a plane across \p axis between the triangles, but for a corner that they share? The plane then
/// goes through that. \return false where the rounding might matter
inline bool IsBetween(const Pair& pair, const ExactPoint& axis)
{
    constexpr double kErrorBound = 20 * kRoundingUnit; // of two dot products of differences
    const ExactPoint& origin = pair.s[0];
    double reach = 0;
    for (const ExactTriangle* t : {&pair.s, &pair.t})
        for (const ExactPoint& p : *t)
            reach = std::max(
                {reach, std::abs(p.x - origin.x), std::abs(p.y - origin.y), std::abs(p.z - origin.z)});
    const double error = kErrorBound * reach * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
    const Interval s = Extent(axis, pair.s, origin, pair.shared),
                   t = Extent(axis, pair.t, origin, pair.shared);
    if (pair.shared == 0) return s.low > t.high + error || t.low > s.high + error;
    return (s.low > error && t.high < -error) || (t.low > error && s.high < -error);
}

/// Looks for a plane between triangles that lie beside each other, as most neighbours on a smooth surface do:
/// one across the plane of \p s along one of its edges, tilted a little about a shared corner.
inline bool LiesBeside(const Pair& pair, const ExactTriangle& s)
{
    constexpr double kTilt = 0.05;
    const ExactPoint normal = Cross(s[1] - s[0], s[2] - s[0]);
    if (pair.shared == 0) {
        for (std::size_t k = 0; k < 3; ++k)
            if (IsBetween(pair, Cross(normal, s[(k + 1) % 3] - s[k]))) return true;
        return false;
    }
    const double size = std::sqrt(SquaredNorm(normal));
    const ExactPoint u = s[1] - s[0], v = s[2] - s[0];
    return IsBetween(pair, Cross(normal, u) + (kTilt * size) * u) ||
           IsBetween(pair, (kTilt * size) * v - Cross(normal, v));
}

/// Are all corners of \p t but the first \p shared on one side of the plane of \p s, for sure?
inline bool IsOnOneSide(const ExactTriangle& s, const ExactTriangle& t, std::size_t shared)
{
    const int side = CertainOrientation(s[0], s[1], s[2], t[2]);
    if (side == 0) return false;
    for (std::size_t k = shared; k < 2; ++k)
        if (CertainOrientation(s[0], s[1], s[2], t[k]) != side) return false;
    return true;
}

inline bool CrossApart(const Pair& pair)
{
    for (std::size_t k = 0; k < 3; ++k)
        if (SegmentMeets(pair.s[k], pair.s[(k + 1) % 3], pair.t) ||
            SegmentMeets(pair.t[k], pair.t[(k + 1) % 3], pair.s))
            return true;
    return false;
}
/// The common points of both end on the edge across from the corner, of one or the other.
inline bool CrossAtCorner(const Pair& pair)
{
    return SegmentMeets(pair.s[1], pair.s[2], pair.t) || SegmentMeets(pair.t[1], pair.t[2], pair.s);
}
/// In one plane, and on the same side of the edge.
inline bool CrossAtEdge(const Pair& pair)
{
    if (Orientation(pair.s[0], pair.s[1], pair.s[2], pair.t[2]) != 0) return false;
    const int axis = *AxisAcross(pair.s);
    const PlanePoint a = Projected(pair.s[0], axis), b = Projected(pair.s[1], axis);
    return Orientation(a, b, Projected(pair.s[2], axis)) == Orientation(a, b, Projected(pair.t[2], axis));
}

/// Do the faces at an edge clearly not lie on each other?
inline bool IsOpen(const Pair& pair)
{
    constexpr double kClear2 = 1e-3;   // of the squared cosine of the angle between the normals
    constexpr double kNeedle2 = 1e-24; // of the squared sine of a corner: below, the normal is rounding
    const ExactPoint edge = pair.s[1] - pair.s[0], u = pair.s[2] - pair.s[0], v = pair.t[2] - pair.s[0];
    const ExactPoint m = Cross(edge, u), n = Cross(v, edge);
    const double m2 = SquaredNorm(m), n2 = SquaredNorm(n), edge2 = SquaredNorm(edge), product = Dot(m, n);
    return product > 0 && product * product > kClear2 * m2 * n2 && m2 > kNeedle2 * edge2 * SquaredNorm(u) &&
           n2 > kNeedle2 * edge2 * SquaredNorm(v);
}

} // namespace crossing_detail

/// Have the triangles a point in common that is not on what they share? The answer is exact.
/// \pre coordinates as orientation.h says
inline bool TrianglesCross(const ExactTriangle& s, const ExactTriangle& t)
{
    using namespace crossing_detail;
    const Pair pair = Matched(s, t);
    if (pair.shared == 3) return false;
    // What double precision is sure of comes first: it is nearly everything.
    if (pair.shared == 2 && IsOpen(pair)) return false;
    if (IsOnOneSide(pair.s, pair.t, pair.shared) || IsOnOneSide(pair.t, pair.s, pair.shared)) return false;
    if (pair.shared < 2 && (LiesBeside(pair, pair.s) || LiesBeside(pair, pair.t))) return false;
    if (!AxisAcross(s) || !AxisAcross(t)) return false;
    return pair.shared == 0 ? CrossApart(pair) : pair.shared == 1 ? CrossAtCorner(pair) : CrossAtEdge(pair);
}

} // namespace vcg_ext
