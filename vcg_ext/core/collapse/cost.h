// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The formulas of one edge collapse, each written once. They are templates on the number: the engine runs
// them on Float4, four edges or faces at once, and on float; the tests compare both with double.
//
// Quadrics are centred at their vertex: q(d) = d^T M d + 2 b.d + c with d = x - p_v. The quadric of the
// current star then has neither b nor c, and float loses nothing.

#include <algorithm>
#include <cmath>

#include "vcg_ext/core/geometry/symmetric_matrix.h"
namespace vcg_ext
{

/// Relative weight that pulls a placement to the edge's midpoint: 1e-6 of the mean eigenvalue.
constexpr float kMidpointPull = 1e-6f / 3.0f;
/// Part of the accumulated quadrics below which a cost never falls.
constexpr float kHistoryFloor = 0.35f;
/// Cost of length alone, which decides between edges that are equally flat.
constexpr float kLengthCost = 1e-12f;
/// Weight of the volume plane against the planes of the stars.
constexpr float kVolumeWeight = 3.0f;
/// Triangle quality (twice the area over the longest edge squared) below which a cost rises.
constexpr float kPoorQuality = 0.03f;
/// A surviving face must not turn farther than this cosine: 78 degrees.
constexpr float kTurnCosine = 0.2f;

/// Two millionths of the diagonal, in the frame of 1024 a diagonal: errors below this are rounding. An input
/// in float has a thirtieth of it already, and every placement that is computed adds as much.
constexpr float kNoDistance = 2e-3f;

/// A quadric about the place of its vertex: q(d) = d^T M d + 2 linear.d + constant.
template <class Real>
struct CentredQuadric {
    SymmetricMatrix3<Real> matrix;
    Vector3<Real> linear;
    Real constant;

    Real operator()(const Vector3<Real>& d) const
    {
        return QuadraticForm(matrix, d) + 2.0f * Dot(linear, d) + constant;
    }
};

/// The same quadric about the point that lies \p d away; a constant that rounding made negative becomes 0.
template <class Real>
[[gnu::always_inline]] inline CentredQuadric<Real> Recentred(const CentredQuadric<Real>& q,
                                                             const Vector3<Real>& d)
{
    const Vector3<Real> slope = q.matrix * d;
    const Real constant = q.constant + 2.0f * Dot(q.linear, d) + Dot(slope, d);
    return {q.matrix, q.linear + slope, Max(constant, Real{})};
}

/// What the cost of an edge must know of one end.
template <class Real>
struct EdgeEnd {
    Vector3<Real> position;
    Real weight;                  ///< w = e^{lambda l}
    SymmetricMatrix3<Real> star;  ///< C: 2 area n n^T over the star as it is now, and the border's planes
    CentredQuadric<Real> history; ///< A: the weighted planes of every original face that ended up here
};

/// What keeps a minimiser of \p m near the edge's midpoint.
template <class Real>
[[gnu::always_inline]] inline Real MidpointPull(const SymmetricMatrix3<Real>& m)
{
    return Max(m.Trace() * kMidpointPull, Broadcast<Real>(kSmallestSquare));
}

/// Half the way from a to b.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> HalfEdgeVector(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b)
{
    return Broadcast<Real>(0.5f) * (b.position - a.position);
}

/// Where the edge's new vertex belongs, as offset from its midpoint: the minimum of w_a C_a + w_b C_b.
/// \param half HalfEdgeVector(a, b)
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> OptimalOffset(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                                          const Vector3<Real>& half)
{
    const SymmetricMatrix3<Real> ca = a.weight * a.star;
    const SymmetricMatrix3<Real> cb = b.weight * b.star;
    const SymmetricMatrix3<Real> both = ca + cb;
    return SolveRegularized(both, (cb - ca) * half, MidpointPull(both));
}

/// g: the memoryless quadric at the placement, at least a part of the accumulated ones, and a little length.
/// \param offset of the placement from the midpoint
template <class Real>
[[gnu::always_inline]] inline Real EdgeCost(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                            const Vector3<Real>& half, const Vector3<Real>& offset)
{
    const Vector3<Real> fromA = offset + half;
    const Vector3<Real> fromB = offset - half;
    const Real star = QuadraticForm(a.weight * a.star, fromA) + QuadraticForm(b.weight * b.star, fromB);
    const Real history = a.history(fromA) + b.history(fromB);
    const Real length2 = 4.0f * Dot(half, half);
    return Max(Max(star, history * kHistoryFloor), Real{}) +
           (kLengthCost * length2) * (a.history.matrix.Trace() + b.history.matrix.Trace());
}

/// What an edge costs, at most, whose placement misses the planes of its ends by kNoDistance: below it one
/// placement is as good as another.
template <class Real>
[[gnu::always_inline]] inline Real RoundingCost(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b)
{
    return kNoDistance * kNoDistance * (a.history.matrix.Trace() + b.history.matrix.Trace());
}

/// The stars of both ends as areas with direction.
template <class Real>
struct StarAreas {
    Vector3<Real> a;    ///< sum of 2 area n over the star of a
    Vector3<Real> b;    ///< the same of b; the faces on the edge may be missing in both
    Vector3<Real> both; ///< the same over the union of the stars
    Real area;          ///< sum of 2 area over the union
};

/// OptimalOffset with the soft volume plane: of the union of the stars, with G the sum of 2 area n, the plane
/// that keeps the volume, with weight 3 max(w) |G|^2 / area.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> VolumeAwareOffset(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                                              const Vector3<Real>& half,
                                                              const StarAreas<Real>& areas)
{
    const SymmetricMatrix3<Real> ca = a.weight * a.star;
    const SymmetricMatrix3<Real> cb = b.weight * b.star;
    const Real weight = areas.area > 0 ? kVolumeWeight * Max(a.weight, b.weight) / areas.area : Real{};
    // Both planes contain the middle of their own star's boundary; seen from the midpoint, their sum asks for
    // G.t = (G_b - G_a).half.
    const Real height = weight * Dot(areas.b - areas.a, half);
    const SymmetricMatrix3<Real> matrix = ca + cb + weight * OuterProduct(areas.both);
    return SolveRegularized(matrix, (cb - ca) * half + height * areas.both, MidpointPull(matrix));
}

/// m = n / sqrt|n| of a face with n = 2 area x unit normal: m m^T is 2 area times its plane's quadric. 0
/// where the face has no area.
inline Vector3<float> ScaledNormal(const Vector3<float>& p, const Vector3<float>& q, const Vector3<float>& r)
{
    const Vector3<float> n = Cross(q - p, r - p);
    const float length = std::sqrt(Dot(n, n));
    const float scale = length > 0 ? 1.0f / std::sqrt(length) : 0.0f;
    return scale * n;
}

/// The quadric of the plane through the edge \p edge, perpendicular to the face of normal \p normal, times
/// the squared length of the edge. 0 where there is no such plane.
inline SymmetricMatrix3<float> PerpendicularPlane(const Vector3<float>& normal, const Vector3<float>& edge)
{
    const Vector3<float> d = Cross(normal, edge);
    const float length2 = Dot(d, d);
    const float scale = length2 > 0 ? Dot(edge, edge) / length2 : 0.0f;
    return scale * OuterProduct(d);
}

/// Sums over the faces around a vertex for the descriptor of Eq. 5 and the star's quadric C.
template <class Real>
struct StarSums {
    Vector3<Real> edges{};         ///< sum of v_j - v
    Vector3<Real> normal{};        ///< sum of unit normals, weighted by the chord of the corner's angle
    Real length{};                 ///< sum of |v_j - v|
    SymmetricMatrix3<Real> star{}; ///< sum of m m^T

    /// Adds a face with the edges \p a and \p b from the vertex and m = \p scaledNormal.
    /// \param inverseRoot 1 / |m|; the direction of the normal is m / |m|
    void Add(const Vector3<Real>& a, const Vector3<Real>& b, const Real& lengthA, const Real& lengthB,
             const Vector3<Real>& scaledNormal, const Real& inverseRoot)
    {
        const Real cosine = Dot(a, b) / Max(lengthA * lengthB, Broadcast<Real>(kSmallestSquare));
        const Real chord = Sqrt(Max(Real{}, 2.0f - 2.0f * cosine)) * inverseRoot;
        edges = edges + (a + b);
        normal = normal + chord * scaledNormal;
        length = length + (lengthA + lengthB);
        star = star + OuterProduct(scaledNormal);
    }
};

/// The lanes of all sums added up.
inline StarSums<float> Summed(const StarSums<Float4>& sums)
{
    return {SumLanes(sums.edges), SumLanes(sums.normal), SumLanes(sums.length), SumLanes(sums.star)};
}

/// Eq. 5: |sum of (v_j - v).n| / sum of |v_j - v|, in [0, 1]; 0 where there is no normal.
inline float LaplacianDescriptor(const Vector3<float>& edges, const Vector3<float>& normal, float length)
{
    const float size = std::sqrt(Dot(normal, normal)) * length;
    return size > 0 ? std::fabs(Dot(normal, edges)) / size : 0.0f;
}

/// A face of the ring with the new vertex in it.
template <class Real>
struct MovedFace {
    Vector3<Real> normal;  ///< 2 area n
    Real normal2;          ///< its squared length
    Real quality2;         ///< (2 area / longest edge squared) squared
    Real lengthA, lengthB; ///< of the two edges at the new vertex
};

/// The face that has the edges \p a and \p b at the new vertex.
template <class Real>
[[gnu::always_inline]] inline MovedFace<Real> MoveFace(const Vector3<Real>& a, const Vector3<Real>& b)
{
    constexpr float kTinyLength2 = 1e-18f; // of the frame of 1024 a diagonal: far below the last digit
    const Vector3<Real> opposite = b - a;
    const Vector3<Real> normal = Cross(a, opposite);
    const Real normal2 = Dot(normal, normal);
    const Real a2 = Dot(a, a);
    const Real b2 = Dot(b, b);
    const Real longest2 = Max(Max(a2, b2), Max(Dot(opposite, opposite), Broadcast<Real>(kTinyLength2)));
    return {normal, normal2, normal2 / (longest2 * longest2), Sqrt(a2), Sqrt(b2)};
}

/// Whether the face turned by more than acos(kTurnCosine) against m = \p before, or lost its area. A face
/// that had no area may turn as it likes.
template <class Real>
[[gnu::always_inline]] inline auto TurnedTooFar(const MovedFace<Real>& face, const Vector3<Real>& before)
{
    const Real before2 = Dot(before, before);
    const Real product = Dot(face.normal, before);
    return (before2 > Real{}) &
           ((product <= Real{}) | (product * product < (kTurnCosine * kTurnCosine) * face.normal2 * before2));
}

/// The factor of a cost whose worst triangle has the squared quality \p worst2.
inline float QualityPenalty(float worst2)
{
    constexpr float kPoor2 = kPoorQuality * kPoorQuality;
    constexpr float kNoQuality2 = 1e-18f;
    return worst2 >= kPoor2 ? 1.0f : std::sqrt(kPoor2 / std::max(worst2, kNoQuality2));
}

} // namespace vcg_ext
