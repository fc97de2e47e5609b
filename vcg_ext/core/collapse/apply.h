// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/border_planes.h"
#include "vcg_ext/core/collapse/ring_trial.h"
#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

/// Carries out a collapse that was found good: the stars are gathered and the ring is evaluated at the
/// placement, so that most of what is written lies ready in the scratch.
class CollapseWriter
{
    SweepState& state_;
    Workspace& workspace_;
    std::uint32_t& poolEnd_;

  public:
    CollapseWriter(SweepState& state, Workspace& workspace, std::uint32_t& poolEnd)
        : state_(state), workspace_(workspace), poolEnd_(poolEnd)
    {
    }

    /// Merges \p removed into \p survivor at \p placement. \return the number of faces that died
    std::uint32_t Collapse(std::uint32_t removed, std::uint32_t survivor, const Vector3<float>& placement)
    {
        const bool border = state_.bordersCount && TouchesBorder(removed, survivor);
        if (border) ChangeBorderPlanes(-1);
        const std::uint32_t died = DropDeadFaces(survivor);
        RenameKeptFaces(survivor);
        ReplaceCornerList(removed, survivor);
        MergeRecords(removed, survivor, placement);
        if (border) {
            workspace_.star.dead = 0;
            ChangeBorderPlanes(1);
        }
        return died;
    }

  private:
    bool TouchesBorder(std::uint32_t removed, std::uint32_t survivor) const
    {
        const StarScratch& star = workspace_.star;
        unsigned flags = state_.flags[removed] | state_.flags[survivor];
        for (std::uint32_t i = 0; i < star.kept; ++i) flags |= state_.flags[star.next[i]];
        return (flags & kBorderVertex) != 0;
    }

    /// Adds the border planes of every face of both stars to its vertices, or takes them away.
    void ChangeBorderPlanes(float sign)
    {
        const StarScratch& star = workspace_.star;
        for (std::uint32_t i = 0; i < star.kept; ++i) AddBorderPlanes(state_, FaceOf(star.corner[i]), sign);
        for (std::uint32_t i = 0; i < star.dead; ++i) AddBorderPlanes(state_, star.deadFace[i], sign);
    }

    std::uint32_t DropDeadFaces(std::uint32_t survivor)
    {
        const StarScratch& star = workspace_.star;
        for (std::uint32_t i = 0; i < star.dead; ++i) {
            FaceRecord& face = state_.faces[star.deadFace[i]];
            face.origin |= FaceRecord::kDead;
            const std::uint32_t wing = star.wing[i];
            if (wing == survivor) continue;
            state_.vertices[wing].AddToStar(-1.0f * OuterProduct(face.Normal()));
            DropCorner(wing, star.deadFace[i]);
        }
        return star.dead;
    }

    /// The dropped corner goes behind the list's end, where the original's lists still hold it.
    void DropCorner(std::uint32_t v, std::uint32_t face)
    {
        Corner* list = state_.corners.data() + state_.cornerOffset[v];
        const std::uint32_t last = state_.cornerCount[v] - 1;
        std::uint32_t i = 0;
        while (i < last && FaceOf(list[i]) != face) ++i;
        std::swap(list[i], list[last]);
        state_.cornerCount[v] = last;
        if (last == 0) state_.key[v] = kNoKey;
    }

    void RenameKeptFaces(std::uint32_t survivor)
    {
        const StarScratch& star = workspace_.star;
        for (std::uint32_t i = 0; i < star.kept; ++i) {
            FaceRecord& face = state_.faces[FaceOf(star.corner[i])];
            StoreRelaxed(face.v[IndexOf(star.corner[i])], survivor); // see OriginalEdgeCheck::IsStable
            Store(face.scaledNormal, Load(star.normal[i].value));
            const Float4 low = Load(star.change[i].value), high = Load(star.change[i].value + 4);
            AddChange(star.next[i], low, high);
            AddChange(star.previous[i], low, high);
        }
    }
    void AddChange(std::uint32_t v, Float4 low, Float4 high)
    {
        float* slot = state_.vertices[v].value + VertexRecord::kStar;
        Store(slot, Load(slot) + low);
        Store(slot + 4, Load(slot + 4) + high); // two slots belong to the history and gain zero
    }

    void ReplaceCornerList(std::uint32_t removed, std::uint32_t survivor)
    {
        const StarScratch& star = workspace_.star;
        const std::uint32_t offset = workspace_.arena.Claim(star.kept, poolEnd_);
        std::copy(star.corner.begin(), star.corner.begin() + star.kept, state_.corners.begin() + offset);
        state_.cornerOffset[survivor] = offset;
        state_.cornerCount[survivor] = star.kept;
        state_.cornerCount[removed] = 0;
        state_.key[removed] = kNoKey;
        if (!state_.mergedInto.empty()) state_.mergedInto[removed] = survivor;
    }

    void MergeRecords(std::uint32_t removed, std::uint32_t survivor, const Vector3<float>& placement)
    {
        const VertexRecord& gone = state_.vertices[removed];
        VertexRecord& here = state_.vertices[survivor];
        const CentredQuadric<float> history = MergedHistory(gone.End(), here.End(), placement);
        here.SetHistory(MergeImportance(removed, survivor) * history);
        here.SetMatrix(VertexRecord::kStar, workspace_.star.sums.star);
        const Vector3<float> moved = placement - here.Position();
        unsigned flags = state_.flags[survivor] | (state_.flags[removed] & kBorderVertex);
        if (Dot(moved, moved) > 0) flags |= kMovedVertex;
        state_.flags[survivor] = static_cast<std::uint8_t>(flags);
        here.SetPosition(placement);
    }

    /// Gives the survivor what both ends and its new star deserve. \return the factor by which its weight is
    /// above those of both
    float MergeImportance(std::uint32_t removed, std::uint32_t survivor)
    {
        const auto importance = [&](std::uint32_t v) {
            return Importance<float>{state_.descriptor[v], state_.vertices[v].value[VertexRecord::kWeight]};
        };
        const Importance<float> a = importance(removed), b = importance(survivor);
        const float measured =
            state_.ratchetRecomputes
                ? std::min(1.0f, StarDescriptor(workspace_.star.sums) * state_.descriptorScale)
                : 0.0f;
        const Importance<float> merged = MergedImportance(a, b, measured, state_.featureWeight);
        state_.descriptor[survivor] = merged.descriptor;
        state_.vertices[survivor].value[VertexRecord::kWeight] = merged.weight;
        return merged.weight / std::max(a.weight, b.weight);
    }
};

} // namespace vcg_ext
