// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/bound/segment_proof.h"
#include "vcg_ext/core/bound/trial_faces.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

enum class BoundVerdict {
    Within,
    Beyond, ///< or not to be proven
    Outside ///< the answer needs what another thread may be changing
};

/// The fourth rule of BoundCheck: is every edge of the original at a point of the trial within the limit of
/// the new star, of the faces that cover its ends, or of those around the ring?
class OriginalEdgeCheck
{
    const SweepState& state_;
    const CollapseBound& bound_;
    BoundScratch& scratch_;
    std::uint32_t removed_, survivor_;
    VertexRange range_;

  public:
    /// \pre the scratch has the new faces, the ring, and the points with their owners
    OriginalEdgeCheck(const SweepState& state, const CollapseBound& bound, BoundScratch& scratch,
                      std::uint32_t removed, std::uint32_t survivor, const VertexRange& range)
        : state_(state), bound_(bound), scratch_(scratch), removed_(removed), survivor_(survivor),
          range_(range)
    {
    }

    BoundVerdict Check()
    {
        for (std::size_t i = 0; i < scratch_.points.size(); ++i) {
            const std::uint32_t point = scratch_.points[i];
            if (point >= bound_.edges.VertexCount()) continue; // no vertex, no edges
            const float distance = std::sqrt(scratch_.Distance2(i));
            // The other end is within the limit too.
            if (bound_.edges.longest[point] <= bound_.limit - distance) continue;
            const SegmentEnd end{bound_.covered.Position(point), scratch_.Owner(i), distance};
            const BoundVerdict verdict = EdgesOf(point, end);
            if (verdict != BoundVerdict::Within) return verdict;
        }
        return BoundVerdict::Within;
    }

  private:
    BoundVerdict EdgesOf(std::uint32_t point, const SegmentEnd& end)
    {
        for (const std::uint32_t* q = bound_.edges.Begin(point); q != bound_.edges.End(point); ++q) {
            const std::uint32_t covering = LoadRelaxed(bound_.covered.face[*q]);
            if (!IsStable(covering)) return BoundVerdict::Outside;
            const std::uint32_t place = bound_.covered.place[*q];
            const bool inStar = place < scratch_.points.size() && scratch_.points[place] == *q;
            if (inStar && *q < point) continue; // it is looked at from there
            SegmentEnd other{bound_.covered.Position(*q), 0, 0};
            if (inStar) {
                other.face = scratch_.Owner(place);
                other.distance = std::sqrt(scratch_.Distance2(place));
            } else {
                other.distance = bound_.covered.Distance(*q);
            }
            const float reach = 2 * bound_.limit - end.distance - other.distance;
            if (SquaredNorm(end.position - other.position) <= reach * reach && reach > 0) continue;
            if (!inStar) other.face = AddFace(covering);
            if (!OriginalEdgeIsWithin(end, other)) return BoundVerdict::Beyond;
        }
        return BoundVerdict::Within;
    }
    /// A face with a vertex in the range belongs to no other block, and its vertices stay where they are.
    bool IsStable(std::uint32_t face) const
    {
        const std::uint32_t* v = state_.faces[face].v;
        return range_.Has(LoadRelaxed(v[0])) || range_.Has(LoadRelaxed(v[1])) ||
               range_.Has(LoadRelaxed(v[2]));
    }
    std::uint32_t AddFace(std::uint32_t face)
    {
        const std::uint32_t* v = state_.faces[face].v;
        scratch_.faces.emplace_back(state_.Position(v[0]), state_.Position(v[1]), state_.Position(v[2]));
        return static_cast<std::uint32_t>(scratch_.faces.size() - 1);
    }

    bool OriginalEdgeIsWithin(const SegmentEnd& a, const SegmentEnd& b)
    {
        const auto distance2 = [&](std::uint32_t face, const Vector3<float>& p) {
            return scratch_.faces[face].Distance2(p);
        };
        const auto find = [&](const Vector3<float>& p, std::uint32_t first, std::uint32_t second) {
            return FindNewFace(p, first, second);
        };
        return SegmentIsWithin(a, b, bound_.limit, distance2, find, scratch_.segments);
    }
    /// A face of the new star, or of those around its ring, within the limit of \p point.
    std::optional<SegmentEnd> FindNewFace(const Vector3<float>& point, std::uint32_t a, std::uint32_t b)
    {
        std::optional<SegmentEnd> found;
        const auto isNear = [&](std::size_t i) {
            const TrialFace& face = scratch_.faces[i];
            if (!face.BallReaches(point, bound_.limit)) return false;
            const float distance2 = face.Distance2(point);
            if (!(distance2 <= bound_.limit * bound_.limit)) return false;
            found = SegmentEnd{point, static_cast<std::uint32_t>(i), std::sqrt(distance2)};
            return true;
        };
        if (isNear(a) || isNear(b)) return found;
        for (std::size_t i = 0; i < scratch_.starFaces; ++i)
            if (isNear(i)) return found;
        AddFacesAround();
        for (std::size_t i = scratch_.starFaces; i < scratch_.faces.size(); ++i)
            if (isNear(i)) return found;
        return std::nullopt;
    }
    void AddFacesAround()
    {
        if (std::exchange(scratch_.aroundIsKnown, true)) return;
        for (const std::uint32_t w : scratch_.ring)
            for (std::uint32_t i = 0; i < state_.cornerCount[w]; ++i) {
                const std::uint32_t face = FaceOf(state_.CornersOf(w)[i]);
                const std::uint32_t* v = state_.faces[face].v;
                if (std::any_of(v, v + 3, [&](std::uint32_t u) { return u == removed_ || u == survivor_; }))
                    continue;
                AddFace(face);
            }
    }
};

} // namespace vcg_ext
