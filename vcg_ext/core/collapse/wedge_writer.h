// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/collapse/seams.h"
#include "vcg_ext/core/collapse/wedge_trial.h"

namespace vcg_ext
{

/// Writes what a collapse does to the attributes, before and after CollapseWriter has done its part.
class WedgeWriter
{
    SweepState& state_;
    WedgeSet& set_;
    StarScratch& star_;
    WedgeScratch& scratch_;
    std::uint32_t removed_, survivor_;
    bool nearSeam_;

  public:
    /// \pre the wedges' values at the placement are those of the last WedgeTrial::ErrorAt, of which
    /// \p removed was the first vertex
    WedgeWriter(SweepState& state, Workspace& workspace, std::uint32_t removed, std::uint32_t survivor)
        : state_(state), set_(*state.wedges), star_(workspace.star), scratch_(workspace.wedges),
          removed_(removed), survivor_(survivor), nearSeam_(TouchesSeam())
    {
    }

    void Before(const Vector3<float>& placement)
    {
        scratch_.deadFace.assign(star_.deadFace.begin(), star_.deadFace.begin() + star_.dead);
        if (nearSeam_) {
            for (std::uint32_t i = 0; i < star_.kept; ++i)
                AddSeamPlanes(state_, set_, FaceOf(star_.corner[i]), -1);
            for (const std::uint32_t face : scratch_.deadFace) AddSeamPlanes(state_, set_, face, -1);
        }
        MoveQuadrics(placement);
        if (!set_.side.empty()) JoinSides();
        RenameWedges();
    }

    /// \param alone no other thread works on the state \param stayed which of both ends is left
    void After(bool alone, std::uint32_t stayed)
    {
        for (const std::uint32_t face : scratch_.deadFace) {
            if (alone) --set_.chartFaces[set_.chart[face]];
            set_.chart[face] = kNone;
        }
        if (!nearSeam_) return;
        if (((state_.flags[removed_] | state_.flags[survivor_]) & kSeamVertex) != 0) {
            SetSeamMarks(state_, stayed, SeamMarks(state_, set_, stayed));
            for (std::uint32_t i = 0; i < star_.kept; ++i) {
                MarkAgain(star_.next[i]);
                MarkAgain(star_.previous[i]);
            }
        }
        for (std::uint32_t i = 0; i < star_.kept; ++i)
            AddSeamPlanes(state_, set_, FaceOf(star_.corner[i]), 1);
    }

  private:
    bool TouchesSeam() const
    {
        if (!set_.keepSeams) return false;
        unsigned flags = state_.flags[removed_] | state_.flags[survivor_];
        for (std::uint32_t i = 0; i < star_.kept; ++i)
            flags |= state_.flags[star_.next[i]] | state_.flags[star_.previous[i]];
        for (std::uint32_t i = 0; i < star_.dead; ++i) flags |= state_.flags[star_.wing[i]];
        return (flags & kSeamVertex) != 0;
    }

    /// No vertex gains its first seam edge by a collapse, so only those on seams are looked at.
    void MarkAgain(std::uint32_t v)
    {
        if (state_.Has(v, kSeamVertex)) SetSeamMarks(state_, v, SeamMarks(state_, set_, v));
    }

    /// The first wedge of every group takes what all of them were, at the new place and with the new values.
    void MoveQuadrics(const Vector3<float>& placement)
    {
        const std::size_t channels = set_.layout.channels, quadricSize = set_.layout.QuadricSize();
        const Vector3<float> moved[2] = {placement - state_.Position(removed_),
                                         placement - state_.Position(survivor_)};
        for (std::size_t i = 0; i < scratch_.wedge.size(); ++i) {
            if (scratch_.group[i] != i) continue;
            const float* value = scratch_.value.data() + i * channels;
            scratch_.quadric.assign(quadricSize, 0);
            WedgeQuadric<float> sum(set_.channels, set_.layout, scratch_.quadric.data());
            for (std::size_t j = i; j < scratch_.wedge.size(); ++j) {
                if (scratch_.group[j] != i) continue;
                const std::uint32_t id = scratch_.wedge[j];
                const float* own = set_.Values(id);
                sum.AddMoved(set_.Quadric(id), moved[j < scratch_.ofRemoved ? 0 : 1],
                             [&](std::size_t k) { return value[k] - own[k]; });
            }
            float* record = set_.Values(scratch_.wedge[i]);
            std::copy_n(value, channels, record);
            std::copy_n(scratch_.quadric.data(), quadricSize, record + channels);
        }
    }

    /// Where wedges become one, so do their sides, with all of both vertices that are on them.
    void JoinSides()
    {
        for (std::size_t i = 0; i < scratch_.wedge.size(); ++i) {
            const std::uint32_t own = set_.side[scratch_.wedge[i]];
            const std::uint32_t of = set_.side[scratch_.wedge[scratch_.group[i]]];
            for (const std::uint32_t id : scratch_.wedge)
                if (set_.side[id] == own) set_.side[id] = of;
        }
    }

    void RenameWedges()
    {
        for (std::uint32_t i = 0; i < star_.kept; ++i) {
            std::uint32_t& id = set_.Of(star_.corner[i]);
            const auto at = std::find(scratch_.wedge.begin(), scratch_.wedge.end(), id);
            id = scratch_.wedge[scratch_.group[static_cast<std::size_t>(at - scratch_.wedge.begin())]];
        }
    }
};

} // namespace vcg_ext
