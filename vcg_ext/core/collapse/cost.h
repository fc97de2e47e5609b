// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The formulas of one edge collapse and the table of their constants, each written once. They are templates
// on the number: the engine runs them on Float4 and Float8, several edges or faces at once, and on float; the
// queue-ordered collapse (vcg_ext/ordered) on double.
//
// Quadrics are centred at their vertex: q(d) = d^T M d + 2 b.d + c with d = x - p_v. The quadric of the
// current star then has neither b nor c, and float loses nothing.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vcg_ext/core/geometry/symmetric_matrix.h"

namespace vcg_ext
{

/// Relative weight that pulls a placement to the edge's midpoint: 1e-6 of the mean eigenvalue.
constexpr float kMidpointPull = 1e-6f / 3.0f;
/// Part of the accumulated quadrics below which a cost never falls. Beside kDistanceWeight, .15 gives the
/// same errors and leaves more folded faces.
constexpr float kHistoryFloor = 0.25f;
/// Of the mean double area of a face that is left: what a distance counts for, whatever the size of its star.
/// .5 lowers the rms at features of effort fast by 2 % more and raises the rms by 1 %.
constexpr float kDistanceWeight = 0.3f;
/// Cost of length alone, which decides between edges that are equally flat.
constexpr float kLengthCost = 1e-12f;
/// Weight of the volume plane against the planes of the stars.
constexpr float kVolumeWeight = 3.0f;
/// Of the planes perpendicular to creases, against those of the border.
constexpr float kCreaseWeight = 0.1f;
/// cos^2 of 30 degrees: edges that turn farther are creases.
constexpr float kCreaseCosine2 = 0.75f;
/// cos^2 of 120 degrees: edges that turn farther are folds.
constexpr float kFoldCosine2 = 0.25f;
/// Folds that make their vertex the tip of a thin part.
constexpr int kFoldsAtATip = 2;
/// Of the planes perpendicular to a tip's folds.
constexpr float kTipWeight = 0.7f;
/// The descriptor that this part of the vertices stays below counts as 1.
constexpr double kDescriptorPercentile = 0.999;
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

template <class Real>
[[gnu::always_inline]] inline CentredQuadric<Real> operator+(const CentredQuadric<Real>& p,
                                                             const CentredQuadric<Real>& q)
{
    return {p.matrix + q.matrix, p.linear + q.linear, p.constant + q.constant};
}
template <class Real>
[[gnu::always_inline]] inline CentredQuadric<Real> operator*(const Real& s, const CentredQuadric<Real>& q)
{
    return {s * q.matrix, s * q.linear, s * q.constant};
}

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

/// What keeps a minimizer of \p m near the edge's midpoint.
template <class Real>
[[gnu::always_inline]] inline Real MidpointPull(const SymmetricMatrix3<Real>& m)
{
    return Max(m.Trace() * kMidpointPull, Broadcast<Real>(kSmallestSquare));
}

/// A of the vertex at \p placement that both ends merge into.
template <class Real>
CentredQuadric<Real> MergedHistory(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                   const Vector3<Real>& placement)
{
    return Recentred(a.history, placement - a.position) + Recentred(b.history, placement - b.position);
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

/// The area for which a distance counts in a cost, in the unit of the quadrics.
/// \param doubleArea twice the area of the surface \param faces that are left of it
inline double DistanceArea(double doubleArea, std::size_t faces)
{
    return double{kDistanceWeight} * doubleArea / static_cast<double>(std::max<std::size_t>(1, faces));
}

/// The weight with which a distance counts beside the planes of the stars: what the new vertex will have.
template <class Real>
[[gnu::always_inline]] inline Real WeightedArea(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                                const Real& distanceArea)
{
    return Max(a.weight, b.weight) * distanceArea;
}

/// g: the memoryless quadric at the placement, at least a part of the accumulated ones; the mean squared
/// distance to the accumulated planes over an area that is the same for all edges, as otherwise small stars
/// could go far astray at no cost; and a little length.
/// \param offset of the placement from the midpoint
/// \param distanceArea DistanceArea of the surface
template <class Real>
[[gnu::always_inline]] inline Real EdgeCost(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                            const Vector3<Real>& half, const Vector3<Real>& offset,
                                            const Real& distanceArea)
{
    const Vector3<Real> fromA = offset + half;
    const Vector3<Real> fromB = offset - half;
    const Real star = QuadraticForm(a.weight * a.star, fromA) + QuadraticForm(b.weight * b.star, fromB);
    const Real history = a.history(fromA) + b.history(fromB);
    const Real length2 = 4.0f * Dot(half, half);
    const Real historyTrace = a.history.matrix.Trace() + b.history.matrix.Trace();
    const Real distance2 = Max(history, Real{}) / Max(historyTrace, Broadcast<Real>(kSmallestSquare));
    return Max(Max(star, history * kHistoryFloor), Real{}) + WeightedArea(a, b, distanceArea) * distance2 +
           (kLengthCost * length2) * historyTrace;
}

/// What an edge costs, at most, whose placement misses the planes of its ends by kNoDistance: below it one
/// placement is as good as another.
template <class Real>
[[gnu::always_inline]] inline Real RoundingCost(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                                const Real& distanceArea)
{
    return kNoDistance * kNoDistance *
           (a.history.matrix.Trace() + b.history.matrix.Trace() + WeightedArea(a, b, distanceArea));
}

/// The stars of both ends as areas with direction.
template <class Real>
struct StarAreas {
    Vector3<Real> a{};    ///< sum of 2 area n over the star of a, without the faces on the edge
    Vector3<Real> b{};    ///< the same of b
    Vector3<Real> edge{}; ///< the same over the faces on the edge
    Real area{};          ///< sum of 2 area over all of them

    /// Adds a face with m = \p scaledNormal. \param to a, b or edge
    void Add(const Vector3<Real>& scaledNormal, Vector3<Real>& to)
    {
        const Real m2 = Dot(scaledNormal, scaledNormal);
        to = to + Sqrt(m2) * scaledNormal;
        area = area + m2;
    }
};

/// What the minimum of a cost solves, seen from the edge's midpoint: matrix x offset = right.
template <class Real>
struct PlacementEquations {
    SymmetricMatrix3<Real> matrix;
    Vector3<Real> right;
};

/// OptimalOffset with the soft volume plane: of the union of the stars, with G the sum of 2 area n, the plane
/// that keeps the volume, with weight 3 max(w) |G|^2 / area.
template <class Real>
[[gnu::always_inline]] inline PlacementEquations<Real>
VolumeAwareEquations(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b, const Vector3<Real>& half,
                     const StarAreas<Real>& areas)
{
    const SymmetricMatrix3<Real> ca = a.weight * a.star;
    const SymmetricMatrix3<Real> cb = b.weight * b.star;
    const Real weight = areas.area > 0 ? kVolumeWeight * Max(a.weight, b.weight) / areas.area : Real{};
    // Both planes contain the middle of their own star's boundary; seen from the midpoint, their sum asks for
    // G.t = (G_b - G_a).half.
    const Real height = weight * Dot(areas.b - areas.a, half);
    const Vector3<Real> both = areas.a + areas.b + areas.edge;
    return {ca + cb + weight * OuterProduct(both), (cb - ca) * half + height * both};
}

template <class Real>
[[gnu::always_inline]] inline Vector3<Real> SolvePlacement(const PlacementEquations<Real>& equations)
{
    return SolveRegularized(equations.matrix, equations.right, MidpointPull(equations.matrix));
}

template <class Real>
[[gnu::always_inline]] inline Vector3<Real> VolumeAwareOffset(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b,
                                                              const Vector3<Real>& half,
                                                              const StarAreas<Real>& areas)
{
    return SolvePlacement(VolumeAwareEquations(a, b, half, areas));
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
template <class Real>
Real QualityPenalty(Real worst2)
{
    constexpr Real kPoor2 = kPoorQuality * kPoorQuality;
    constexpr Real kNoQuality2 = 1e-18f;
    return worst2 >= kPoor2 ? Real{1} : Sqrt(kPoor2 / std::max(worst2, kNoQuality2));
}

} // namespace vcg_ext
