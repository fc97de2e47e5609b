// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "vcg_ext/core/collapse/cost.h"

namespace vcg_ext
{

/// The new vertex of the edge from a to b.
template <class Real>
struct PlacedEdge {
    Vector3<Real> position;
    Real cost;        ///< of the edge with it
    bool atA = false; ///< it is where a is: that one survives and keeps its identity
};

/// The new vertex at \p offset from the midpoint, before anybody looks at the ring.
template <class Real>
PlacedEdge<Real> PlaceAt(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b, const Vector3<Real>& half,
                         const Vector3<Real>& offset, Real distanceArea)
{
    return {offset + half + a.position, EdgeCost(a, b, half, offset, distanceArea)};
}

/// Where the surface around the edge is flat, or a straight crease, the end that costs less is the place, if
/// the ring allows it. That keeps its coordinates to the last bit: a computed place lies in no plane of the
/// ring but for rounding, which tilts all faces around it, and again in every collapse that follows.
/// \param cost of the edge by OptimalOffset \param distanceArea as of EdgeCost
/// \param penaltyAt penaltyAt(position): QualityPenalty of the ring, nothing where a face turns too far
template <class Real, class PenaltyAt>
std::optional<PlacedEdge<Real>> PlaceAtAnEnd(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b, Real cost,
                                             Real distanceArea, const PenaltyAt& penaltyAt)
{
    const Real rounding = RoundingCost(a, b, distanceArea);
    if (cost > rounding) return std::nullopt;
    const Vector3<Real> half = HalfEdgeVector(a, b);
    const Real costA = EdgeCost(a, b, half, Real{-1} * half, distanceArea);
    const Real costB = EdgeCost(a, b, half, half, distanceArea);
    const Real atEnd = std::min(costA, costB);
    if (atEnd > rounding) return std::nullopt;
    const bool atA = costA < costB;
    const Vector3<Real> position = atA ? a.position : b.position;
    const std::optional<Real> penalty = penaltyAt(position);
    if (!penalty || atEnd * *penalty > rounding) return std::nullopt;
    return PlacedEdge<Real>{position, atEnd * *penalty, atA};
}

/// The new vertex of an edge with everything that is known; nothing where the ring does not allow it.
/// \param cost of the edge by OptimalOffset, or by the offset to b where that is fixed
/// \param distanceArea as of EdgeCost
/// \param affordable where the edge costs more without the ring, the ring is not looked at
/// \param areasOf areasOf(): the StarAreas of both ends
/// \param penaltyAt as of PlaceAtAnEnd. Where the result is a place, it was asked about that place last
template <class Real, class AreasOf, class PenaltyAt>
std::optional<PlacedEdge<Real>> PlaceEdge(const EdgeEnd<Real>& a, const EdgeEnd<Real>& b, bool bIsFixed,
                                          Real cost, Real distanceArea, Real affordable,
                                          const AreasOf& areasOf, const PenaltyAt& penaltyAt)
{
    PlacedEdge<Real> placed{b.position, cost};
    if (!bIsFixed) {
        if (const auto atAnEnd = PlaceAtAnEnd(a, b, cost, distanceArea, penaltyAt)) return atAnEnd;
        const Vector3<Real> half = HalfEdgeVector(a, b);
        placed = PlaceAt(a, b, half, VolumeAwareOffset(a, b, half, areasOf()), distanceArea);
    }
    if (placed.cost > affordable) return placed;
    const std::optional<Real> penalty = penaltyAt(placed.position);
    if (!penalty) return std::nullopt;
    placed.cost = placed.cost * *penalty;
    return placed;
}

/// Offsets of what may do where the ring does not allow the best place: the midpoint and both ends.
template <class Real>
std::array<Vector3<Real>, 3> OtherOffsets(const Vector3<Real>& half)
{
    return {{{0, 0, 0}, half, Real{-1} * half}};
}

} // namespace vcg_ext
