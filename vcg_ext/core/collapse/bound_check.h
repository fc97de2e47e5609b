// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/bound/piece_proof.h"
#include "vcg_ext/core/bound/trial_faces.h"
#include "vcg_ext/core/collapse/original_edge_check.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/collapse/workspace.h"

namespace vcg_ext
{

/// Would a gathered collapse keep both surfaces within the limit of each other, as far as points and edges
/// tell? Four rules, the cheapest first:
///
/// 1. the new vertex is within the limit of the original;
/// 2. every original point on the star's lists is within the limit of a new face;
/// 3. every new edge is within the limit of the original (SegmentIsWithin), and so are the centroids;
/// 4. every original edge whose ends lie on different faces is within the limit of the new star or of the
///    faces around it. That is what holds long edges, whose ends alone are covered by anything.
///
/// What points and edges cannot see is left to the certificate of the result.
class BoundCheck
{
    const SweepState& state_;
    CollapseBound& bound_;
    BoundScratch& scratch_;
    const StarScratch& star_;
    std::uint32_t removed_, survivor_;
    VertexRange range_;

  public:
    /// \pre both stars are gathered
    BoundCheck(const SweepState& state, Workspace& workspace, std::uint32_t removed, std::uint32_t survivor,
               const VertexRange& range)
        : state_(state), bound_(*state.bound), scratch_(workspace.bound), star_(workspace.star),
          removed_(removed), survivor_(survivor), range_(range)
    {
    }

    /// Was the edge refused, and has nothing changed around it since?
    bool IsRefusedStill() const
    {
        const std::uint32_t changed = std::max(bound_.ringChanged[removed_], bound_.ringChanged[survivor_]);
        return bound_.edgeRefused[HalfEdge(0)] > changed;
    }
    void Refuse()
    {
        for (std::uint32_t i = 0; i < star_.dead; ++i) bound_.edgeRefused[HalfEdge(i)] = bound_.sweep;
    }

    /// The verdict on the new vertex at \p placement; Commit may follow where it is Within.
    BoundVerdict Check(const Vector3<float>& placement)
    {
        scratch_.Clear();
        if (!PlaceVertex(placement)) return BoundVerdict::Beyond;
        PlaceFaces();
        if (!CoversPoints() || !NewEdgesAreWithin() || !CentroidsAreWithin()) return BoundVerdict::Beyond;
        const BoundVerdict verdict =
            OriginalEdgeCheck(state_, bound_, scratch_, removed_, survivor_, range_).Check();
        if (verdict != BoundVerdict::Within || !IsStrict() || WholeFacesAreWithin()) return verdict;
        return BoundVerdict::Beyond;
    }

    /// The collapse that was checked last happens: its points go to the new faces. \p survivor is the vertex
    /// that stays. \pre the star's faces are as they were
    void Commit(std::uint32_t survivor)
    {
        CoveredPoints& covered = bound_.covered;
        for (std::uint32_t i = 0; i < star_.kept; ++i) covered.first[FaceOf(star_.corner[i])] = kNone;
        for (std::uint32_t i = 0; i < star_.dead; ++i) covered.first[star_.deadFace[i]] = kNone;
        for (std::size_t i = 0; i < scratch_.points.size(); ++i)
            covered.Attach(scratch_.points[i], FaceOf(star_.corner[scratch_.Owner(i)]),
                           std::sqrt(scratch_.Distance2(i)));
        bound_.nearby[survivor] = {scratch_.vertex.face, scratch_.vertex.distance};
        bound_.ringChanged[removed_] = bound_.ringChanged[survivor_] = bound_.sweep;
        for (std::uint32_t i = 0; i < star_.kept; ++i) {
            bound_.ringChanged[star_.next[i]] = bound_.sweep;
            bound_.ringChanged[star_.previous[i]] = bound_.sweep;
        }
        for (std::uint32_t i = 0; i < star_.dead; ++i) bound_.ringChanged[star_.wing[i]] = bound_.sweep;
    }

  private:
    /// Of the edge that would go, in the i-th of its faces.
    std::size_t HalfEdge(std::uint32_t i) const
    {
        const std::uint32_t face = star_.deadFace[i];
        const std::uint32_t* v = state_.faces[face].v;
        std::size_t k = 0;
        while (v[kPreviousIndex[k]] != star_.wing[i]) ++k;
        return 3 * std::size_t{face} + k;
    }

    bool PlaceVertex(const Vector3<float>& placement)
    {
        const auto found =
            bound_.FindNearby(placement, bound_.nearby[survivor_].face, bound_.nearby[removed_].face);
        if (found) scratch_.vertex = *found;
        return found.has_value();
    }

    void PlaceFaces()
    {
        const Vector3<float>& x = scratch_.vertex.position;
        for (std::uint32_t i = 0; i < star_.kept; ++i)
            scratch_.faces.emplace_back(x, state_.Position(star_.next[i]),
                                        state_.Position(star_.previous[i]));
        scratch_.starFaces = star_.kept;
    }

    bool CoversPoints()
    {
        for (std::uint32_t i = 0; i < star_.kept; ++i) CollectPoints(FaceOf(star_.corner[i]));
        for (std::uint32_t i = 0; i < star_.dead; ++i) CollectPoints(star_.deadFace[i]);
        const Float4 limit2 = Splat(bound_.limit * bound_.limit);
        std::size_t likely = 0; // points that follow each other are close to each other
        for (std::size_t first = 0; first < scratch_.points.size(); first += kLanes) {
            PointGroup& group = scratch_.AddGroup(bound_.covered, first);
            group.Try(scratch_.faces[likely], static_cast<int>(likely));
            for (std::size_t i = 0; i < scratch_.starFaces; ++i)
                if (i != likely) group.Try(scratch_.faces[i], static_cast<int>(i));
            if (AnyLane(group.distance2 > limit2)) return false;
            likely = scratch_.Owner(first);
        }
        return true;
    }
    void CollectPoints(std::uint32_t face)
    {
        CoveredPoints& covered = bound_.covered;
        for (std::uint32_t point = covered.first[face]; point != kNone; point = covered.next[point]) {
            covered.place[point] = static_cast<std::uint32_t>(scratch_.points.size());
            scratch_.points.push_back(point);
        }
    }

    bool NewEdgesAreWithin()
    {
        CollectRing();
        const float limit2 = bound_.limit * bound_.limit;
        const auto distance2 = [&](std::uint32_t face, const Vector3<float>& p) {
            return bound_.original.Distance2ToFace(face, p);
        };
        const auto find = [&](const Vector3<float>& p, std::uint32_t a, std::uint32_t b) {
            return bound_.FindNearby(p, a, b);
        };
        for (const std::uint32_t w : scratch_.ring) {
            const NearbyFace& nearby = bound_.nearby[w];
            // A vertex that strayed is not this collapse's fault.
            if (!(nearby.distance * nearby.distance <= limit2)) continue;
            const SegmentEnd end{state_.Position(w), nearby.face, nearby.distance};
            if (!SegmentIsWithin(scratch_.vertex, end, bound_.limit, distance2, find, scratch_.segments))
                return false;
        }
        return true;
    }
    /// Around a closed star every neighbor is some corner's next vertex.
    void CollectRing()
    {
        std::vector<std::uint32_t>& ring = scratch_.ring;
        ring.assign(star_.next.begin(), star_.next.begin() + star_.kept);
        if (!state_.Has(removed_, kBorderVertex) && !state_.Has(survivor_, kBorderVertex)) return;
        ring.insert(ring.end(), star_.previous.begin(), star_.previous.begin() + star_.kept);
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    }

    bool CentroidsAreWithin() const
    {
        const auto isClose = [&](const Vector3<float>& center, const Vector3<float>& corner, float distance) {
            const float reach = bound_.limit - distance;
            return reach > 0 && SquaredNorm(center - corner) <= reach * reach;
        };
        for (std::uint32_t i = 0; i < star_.kept; ++i) {
            const Vector3<float>& center = scratch_.faces[i].center;
            const NearbyFace &next = bound_.nearby[star_.next[i]], &last = bound_.nearby[star_.previous[i]];
            if (isClose(center, scratch_.vertex.position, scratch_.vertex.distance) ||
                isClose(center, state_.Position(star_.next[i]), next.distance) ||
                isClose(center, state_.Position(star_.previous[i]), last.distance))
                continue;
            const float limit2 = bound_.limit * bound_.limit;
            if (bound_.original.Distance2ToFace(scratch_.vertex.face, center) <= limit2) continue;
            if (!bound_.FindNearby(center, next.face, last.face)) return false;
        }
        return true;
    }

    /// Did the certificate of an earlier run fail here?
    bool IsStrict() const
    {
        const Buffer<std::uint8_t>& strict = bound_.covered.strict;
        return strict[removed_] != 0 || strict[survivor_] != 0 ||
               std::any_of(scratch_.points.begin(), scratch_.points.end(),
                           [&](std::uint32_t point) { return strict[point] != 0; });
    }
    bool WholeFacesAreWithin() const
    {
        const auto exact = [](const Vector3<float>& p) {
            return Vector3<double>{static_cast<double>(p.x), static_cast<double>(p.y),
                                   static_cast<double>(p.z)};
        };
        PieceProof proof(bound_.exact, static_cast<double>(bound_.limit));
        for (std::uint32_t i = 0; i < star_.kept; ++i)
            if (proof.Prove({exact(scratch_.vertex.position), exact(state_.Position(star_.next[i])),
                             exact(state_.Position(star_.previous[i]))}) != PieceProof::Result::Proven)
                return false;
        return true;
    }
};

} // namespace vcg_ext
