// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

/// May the gathered edge be merged without a new non-manifold edge, a duplicate face or a pinched border? The
/// link condition, in the form that the two gathered stars answer.
class CollapseGuard
{
    const SweepState& state_;
    StarScratch& star_;
    std::uint32_t removed_, survivor_;
    std::optional<std::uint32_t> hole_; ///< the third vertex of a triangular hole that may be closed

  public:
    /// \param closeHoles the edge may close a hole of three edges
    CollapseGuard(const SweepState& state, StarScratch& star, std::uint32_t removed, std::uint32_t survivor,
                  bool closeHoles = false)
        : state_(state), star_(star), removed_(removed), survivor_(survivor)
    {
        if (closeHoles && star.dead == 1 && !state.preserveTopology) hole_ = TriangularHole();
    }

    bool Allows() const
    {
        if (state_.sharedSeams && JoinsFixedVertices()) return false;
        const bool closed = !state_.Has(removed_, kBorderVertex) && !state_.Has(survivor_, kBorderVertex);
        if (closed && star_.dead == 2 && star_.wing[0] != star_.wing[1] && KeptNeighboursDiffer())
            return true;
        return AllowsInGeneral();
    }

  private:
    /// A new edge between two fixed vertices: a mesh that shares them may make the same one.
    bool JoinsFixedVertices() const
    {
        if (!state_.Has(survivor_, kFixedVertex)) return false;
        const auto joins = [&](std::uint32_t w) {
            return w != survivor_ && w != removed_ && state_.Has(w, kFixedVertex) && !IsWing(w);
        };
        for (std::uint32_t i = 0; i < star_.keptOfRemoved; ++i)
            if (joins(star_.next[i]) || joins(star_.previous[i])) return true;
        return false;
    }

    bool IsWing(std::uint32_t v) const
    {
        return std::find(star_.wing.begin(), star_.wing.begin() + star_.dead, v) !=
               star_.wing.begin() + star_.dead;
    }

    /// The common case. Around a closed star every neighbour is some corner's next vertex, and of the wings
    /// one is among the kept next vertices of each end. So the ends have only the wings in common if no kept
    /// next vertex is shared. Faces between the wings are left to the general test.
    bool KeptNeighboursDiffer() const
    {
        Int4 shared{};
        for (std::uint32_t i = 0; i < star_.keptOfRemoved; ++i) {
            if (IsWing(star_.next[i]) && IsWing(star_.previous[i])) return false;
            const Int4 next = Splat(static_cast<std::int32_t>(star_.next[i]));
            for (std::uint32_t k = star_.keptOfRemoved; k < star_.kept; k += kLanes)
                shared |= next == LoadIntegers(&star_.next[k]);
        }
        return star_.keptOfRemoved > 0 && star_.kept > star_.keptOfRemoved && !AnyLane(shared);
    }

    bool AllowsInGeneral() const
    {
        if (star_.kept == 0) return false; // the whole component would vanish
        if (HasSharedNeighbour() || HasDuplicateFace()) return false;
        if (state_.preserveTopology) return KeepsSingularEdges();
        // Two border vertices joined across the inside would pinch the surface to a point.
        return star_.dead < 2 || !HasBorderEdge(0, star_.keptOfRemoved) ||
               !HasBorderEdge(star_.keptOfRemoved, star_.kept);
    }

    /// If both ends are on one border only and these lead to the same vertex, that vertex.
    std::optional<std::uint32_t> TriangularHole() const
    {
        const auto otherEnd = [&](std::uint32_t begin, std::uint32_t end) {
            std::optional<std::uint32_t> found;
            const bool several = AnyEdge(begin, end, [&](std::uint32_t v, std::ptrdiff_t faces) {
                if (faces != 1) return false;
                return std::exchange(found, v).has_value();
            });
            return several ? std::nullopt : found;
        };
        const auto ofRemoved = otherEnd(0, star_.keptOfRemoved);
        const auto ofSurvivor = otherEnd(star_.keptOfRemoved, star_.kept);
        return ofRemoved == ofSurvivor && ofRemoved && !IsWing(*ofRemoved) ? ofRemoved : std::nullopt;
    }

    /// A common neighbour that is not a wing: its two edges would become one with too many faces.
    bool HasSharedNeighbour() const
    {
        std::uint32_t* const begin = star_.sorted.data();
        std::uint32_t* const end = WriteNeighbours(0, star_.keptOfRemoved, begin);
        std::sort(begin, end);
        const auto shared = [&](std::uint32_t v) {
            return std::binary_search(begin, end, v) && !IsWing(v) && v != hole_;
        };
        for (std::uint32_t i = star_.keptOfRemoved; i < star_.kept; ++i)
            if (shared(star_.next[i]) || shared(star_.previous[i])) return true;
        return false;
    }

    /// A face of each end on the same other two vertices. \pre only wings and the corner of the hole are
    /// shared
    bool HasDuplicateFace() const
    {
        const auto shared = [&](std::uint32_t v) { return IsWing(v) || v == hole_; };
        for (std::uint32_t i = 0; i < star_.keptOfRemoved; ++i) {
            const std::uint32_t a = star_.next[i], b = star_.previous[i];
            if (!shared(a) || !shared(b)) continue;
            for (std::uint32_t k = star_.keptOfRemoved; k < star_.kept; ++k)
                if ((star_.next[k] == a && star_.previous[k] == b) ||
                    (star_.next[k] == b && star_.previous[k] == a))
                    return true;
        }
        return false;
    }

    std::uint32_t* WriteNeighbours(std::uint32_t begin, std::uint32_t end, std::uint32_t* out) const
    {
        out = std::copy(star_.next.begin() + begin, star_.next.begin() + end, out);
        return std::copy(star_.previous.begin() + begin, star_.previous.begin() + end, out);
    }

    /// Calls visit(neighbour, faces) for every edge of one end but the common one. The end's kept faces are
    /// [begin, end). \return true as soon as a call does
    template <class Visit>
    bool AnyEdge(std::uint32_t begin, std::uint32_t end, const Visit& visit) const
    {
        std::uint32_t* const list = star_.sorted.data();
        std::uint32_t* stop = WriteNeighbours(begin, end, list);
        stop = std::copy(star_.wing.begin(), star_.wing.begin() + star_.dead, stop);
        std::sort(list, stop);
        for (const std::uint32_t* run = list; run != stop;) {
            const std::uint32_t* next = std::find_if(run, static_cast<const std::uint32_t*>(stop),
                                                     [&](std::uint32_t v) { return v != *run; });
            if (visit(*run, next - run)) return true;
            run = next;
        }
        return false;
    }
    bool HasBorderEdge(std::uint32_t begin, std::uint32_t end) const
    {
        return AnyEdge(begin, end, [](std::uint32_t, std::ptrdiff_t faces) { return faces == 1; });
    }
    std::ptrdiff_t SingularEdges(std::uint32_t begin, std::uint32_t end) const
    {
        std::ptrdiff_t count = 0;
        AnyEdge(begin, end, [&](std::uint32_t, std::ptrdiff_t faces) {
            count += faces != 2;
            return false;
        });
        return count;
    }

    /// The rest of the link condition, for edges that do not have exactly two faces (border and non-manifold
    /// ones; the border counts as joined to a point at infinity): both ends may lie on such edges only if
    /// their own edge is one; a wing must not be joined to both by such edges; and of two ends where other
    /// than two of them meet, corners of the border, none may go.
    bool KeepsSingularEdges() const
    {
        const std::ptrdiff_t common = star_.dead != 2;
        const std::ptrdiff_t ofRemoved = SingularEdges(0, star_.keptOfRemoved);
        const std::ptrdiff_t ofSurvivor = SingularEdges(star_.keptOfRemoved, star_.kept);
        if (ofRemoved > 0 && ofSurvivor > 0 && common == 0) return false;
        if (common == 1 && ofRemoved != 1 && ofSurvivor != 1) return false;
        for (std::uint32_t i = 0; i < star_.dead; ++i)
            if (FacesOnEdge(state_, removed_, star_.wing[i]) != 2 &&
                FacesOnEdge(state_, survivor_, star_.wing[i]) != 2)
                return false;
        return true;
    }
};

} // namespace vcg_ext
