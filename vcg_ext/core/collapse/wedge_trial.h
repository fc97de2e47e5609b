// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/attributes/wedge_set.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/collapse/workspace.h"

namespace vcg_ext
{

/// Where the new vertex of an edge is, and with it the values of what merges.
enum class WedgePlace {
    AtRemoved,  ///< the values of the end that was to go
    AtSurvivor, ///< those of the other end
    Between,    ///< on a seam along the edge: mixed as the point divides it
    Anywhere    ///< the best values
};

/// What the seams say of an edge as a whole.
enum class WedgeVerdict {
    Allowed,
    Refused,
    Later ///< a chart may vanish, which only one thread at a time may decide
};

/// The attributes around one edge that is tried.
///
/// The wedges of both ends that share a face of the edge are paired and become one; the others of a vertex
/// that moves keep their values and pay for it.
class WedgeTrial
{
    const SweepState& state_;
    const WedgeSet& set_;
    const StarScratch& star_;
    WedgeScratch& scratch_;
    std::uint32_t removed_, survivor_;

  public:
    WedgeTrial(const SweepState& state, Workspace& workspace, std::uint32_t removed, std::uint32_t survivor)
        : state_(state), set_(*state.wedges), star_(workspace.star), scratch_(workspace.wedges),
          removed_(removed), survivor_(survivor)
    {
    }

    /// Collects and pairs the wedges. \pre both stars are gathered
    /// \param alone no other thread works on the state
    WedgeVerdict Gather(bool alone)
    {
        if (set_.keepSeams) {
            const WedgeVerdict verdict = JudgeCharts(alone);
            if (verdict != WedgeVerdict::Allowed) return verdict;
        }
        CollectWedges();
        PairWedges();
        return scratch_.blocked[0] && scratch_.blocked[1] ? WedgeVerdict::Refused : WedgeVerdict::Allowed;
    }

    bool OnSeam(std::uint32_t v) const { return state_.Has(v, kSeamVertex); }

    /// Do both ends lie on a seam, the edge itself being a part of it?
    bool IsAlongSeam() const { return star_.dead == 2 && scratch_.pairs[0] != scratch_.pairs[1]; }

    /// Two wedges of one end that pair with the same one of the other may only merge there.
    bool MayStayAt(WedgePlace end) const { return !scratch_.blocked[end == WedgePlace::AtRemoved ? 0 : 1]; }
    bool MayLeaveBothEnds() const { return !scratch_.blocked[0] && !scratch_.blocked[1]; }

    /// What the attributes leave for a free placement, seen from the edge's midpoint: d^T matrix d + 2
    /// linear.d.
    void ForPlacement(const Vector3<float>& half, SymmetricMatrix3<float>& matrix,
                      Vector3<float>& linear) const
    {
        matrix = {};
        linear = {};
        std::vector<float>& sum = scratch_.quadric;
        for (std::size_t i = 0; i < scratch_.wedge.size(); ++i) {
            if (scratch_.group[i] != i) continue;
            sum.assign(set_.layout.QuadricSize(), 0);
            WedgeQuadric<float> quadric(set_.channels, set_.layout, sum.data());
            const float* base = set_.Values(scratch_.wedge[i]);
            for (std::size_t j = i; j < scratch_.wedge.size(); ++j) {
                if (scratch_.group[j] != i) continue;
                const float* own = set_.Values(scratch_.wedge[j]);
                quadric.AddMoved(set_.Quadric(scratch_.wedge[j]), IsOfRemoved(j) ? half : -1.0f * half,
                                 [&](std::size_t k) { return base[k] - own[k]; });
            }
            SymmetricMatrix3<float> groupMatrix;
            Vector3<float> groupLinear;
            quadric.BestForPlacement(groupMatrix, groupLinear);
            matrix = matrix + groupMatrix;
            linear = linear + groupLinear;
        }
    }

    /// The attribute error with the new vertex at \p x, and its wedges' values into the scratch; nothing
    /// where the texture of a face would turn over. \param along where \p place is Between: the part of the
    /// way from the end that was to go
    std::optional<float> ErrorAt(const Vector3<float>& x, WedgePlace place, float along = 0)
    {
        scratch_.value.resize(scratch_.wedge.size() * set_.layout.channels);
        float sum = 0;
        for (std::size_t i = 0; i < scratch_.wedge.size(); ++i) {
            if (scratch_.group[i] != i) {
                std::copy_n(ValueOf(scratch_.group[i]), set_.layout.channels, ValueOf(i));
                continue;
            }
            ChooseValues(i, x, place, along);
            if (set_.weight > 0) sum += GroupError(i, x);
        }
        if (set_.keepSeams && set_.channels.HasTexture() && TurnsTexture()) return std::nullopt;
        return sum;
    }

    /// Where wedge \p id is among those that were gathered.
    std::size_t Local(std::uint32_t id) const
    {
        const auto at = std::find(scratch_.wedge.begin(), scratch_.wedge.end(), id);
        return static_cast<std::size_t>(at - scratch_.wedge.begin());
    }
    bool IsOfRemoved(std::size_t local) const { return local < scratch_.ofRemoved; }
    const float* ValueOf(std::size_t local) const
    {
        return scratch_.value.data() + local * set_.layout.channels;
    }

  private:
    float* ValueOf(std::size_t local) { return scratch_.value.data() + local * set_.layout.channels; }
    const Vector3<float> PositionOfLocal(std::size_t local) const
    {
        return state_.Position(IsOfRemoved(local) ? removed_ : survivor_);
    }

    /// Would a chart lose its last face?
    WedgeVerdict JudgeCharts(bool alone) const
    {
        for (std::uint32_t i = 0; i < star_.dead; ++i) {
            const std::uint32_t chart = set_.chart[star_.deadFace[i]];
            if (!alone) {
                if (set_.witness[chart] == star_.deadFace[i]) return WedgeVerdict::Later;
                continue;
            }
            std::uint32_t lost = 0;
            for (std::uint32_t j = 0; j < star_.dead; ++j) lost += set_.chart[star_.deadFace[j]] == chart;
            if (set_.chartFaces[chart] <= lost) return WedgeVerdict::Refused;
        }
        return WedgeVerdict::Allowed;
    }

    void Collect(std::uint32_t id)
    {
        auto& wedge = scratch_.wedge;
        if (std::find(wedge.begin(), wedge.end(), id) == wedge.end()) wedge.push_back(id);
    }
    Corner CornerOf(std::uint32_t face, std::uint32_t v) const
    {
        const std::uint32_t* corners = state_.faces[face].v;
        return MakeCorner(face, corners[0] == v ? 0 : corners[1] == v ? 1 : 2);
    }
    void CollectWedges()
    {
        scratch_.wedge.clear();
        scratch_.pairs.clear();
        for (std::uint32_t i = 0; i < star_.keptOfRemoved; ++i) Collect(set_.Of(star_.corner[i]));
        for (std::uint32_t i = 0; i < star_.dead; ++i)
            Collect(set_.Of(CornerOf(star_.deadFace[i], removed_)));
        scratch_.ofRemoved = scratch_.wedge.size();
        for (std::uint32_t i = star_.keptOfRemoved; i < star_.kept; ++i) Collect(set_.Of(star_.corner[i]));
        for (std::uint32_t i = 0; i < star_.dead; ++i) {
            const std::uint32_t ofRemoved = set_.Of(CornerOf(star_.deadFace[i], removed_));
            const std::uint32_t ofSurvivor = set_.Of(CornerOf(star_.deadFace[i], survivor_));
            Collect(ofSurvivor);
            scratch_.pairs.push_back({ofRemoved, ofSurvivor});
        }
    }

    /// A group is named by its first wedge.
    void PairWedges()
    {
        auto& group = scratch_.group;
        group.resize(scratch_.wedge.size());
        for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
        for (const auto& pair : scratch_.pairs) {
            const std::size_t a = group[Local(pair[0])], b = group[Local(pair[1])];
            std::replace(group.begin(), group.end(), std::max(a, b), std::min(a, b));
        }
        // Two of the end that goes in one group: not at that end, and the other way round.
        scratch_.blocked = {false, false};
        for (std::size_t i = 0; i < group.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (group[i] == group[j] && IsOfRemoved(i) == IsOfRemoved(j))
                    scratch_.blocked[IsOfRemoved(i) ? 0 : 1] = true;
    }

    /// The wedges of either end in the group of \p first; the number of wedges where there is none.
    std::array<std::size_t, 2> EndsOf(std::size_t first) const
    {
        const std::size_t none = scratch_.wedge.size();
        std::array<std::size_t, 2> ends{none, none};
        for (std::size_t j = none; j-- > first;)
            if (scratch_.group[j] == first) ends[IsOfRemoved(j) ? 0 : 1] = j;
        return ends;
    }

    void ChooseValues(std::size_t i, const Vector3<float>& x, WedgePlace place, float along)
    {
        const auto [ofRemoved, ofSurvivor] = EndsOf(i);
        const std::size_t none = scratch_.wedge.size();
        float* value = ValueOf(i);
        const auto valuesAt = [&](std::size_t local) { return set_.Values(scratch_.wedge[local]); };
        if (ofRemoved == none || ofSurvivor == none || place == WedgePlace::AtRemoved ||
            place == WedgePlace::AtSurvivor) {
            const bool takeRemoved =
                ofSurvivor == none || (ofRemoved != none && place == WedgePlace::AtRemoved);
            std::copy_n(valuesAt(takeRemoved ? ofRemoved : ofSurvivor), set_.layout.channels, value);
            return;
        }
        const float *a = valuesAt(ofRemoved), *b = valuesAt(ofSurvivor);
        if (place == WedgePlace::Between) {
            for (std::size_t k = 0; k < set_.layout.channels; ++k) value[k] = a[k] + along * (b[k] - a[k]);
            return;
        }
        ChooseBestValues(i, x, a, value);
    }

    /// s = s_a + sum (G.d + D + W (own - s_a)) / sum W over the group; the mean where nothing weighs.
    void ChooseBestValues(std::size_t i, const Vector3<float>& x, const float* base, float* value) const
    {
        for (std::size_t k = 0; k < set_.layout.channels; ++k) {
            float wanted = 0, weight = 0, mean = 0, count = 0;
            for (std::size_t j = i; j < scratch_.wedge.size(); ++j) {
                if (scratch_.group[j] != i) continue;
                const WedgeQuadric<const float> quadric = set_.Quadric(scratch_.wedge[j]);
                const float difference = set_.Values(scratch_.wedge[j])[k] - base[k];
                wanted += quadric.Wanted(k, x - PositionOfLocal(j)) + quadric.Weight(k) * difference;
                weight += quadric.Weight(k);
                mean += difference;
                ++count;
            }
            value[k] = base[k] + (weight > 0 ? wanted / weight : mean / count);
        }
    }

    float GroupError(std::size_t i, const Vector3<float>& x) const
    {
        const float* value = ValueOf(i);
        float sum = 0;
        for (std::size_t j = i; j < scratch_.wedge.size(); ++j) {
            if (scratch_.group[j] != i) continue;
            const float* own = set_.Values(scratch_.wedge[j]);
            sum += set_.Quadric(scratch_.wedge[j])(x - PositionOfLocal(j),
                                                   [&](std::size_t k) { return value[k] - own[k]; });
        }
        return sum;
    }

    bool TurnsTexture() const
    {
        for (std::uint32_t i = 0; i < star_.kept; ++i) {
            const Corner corner = star_.corner[i];
            const std::uint32_t id = set_.Of(corner), face = FaceOf(corner);
            const float* value = ValueOf(Local(id));
            const float* before = set_.Values(id);
            const float* b = set_.Values(set_.Of(MakeCorner(face, kNextIndex[IndexOf(corner)])));
            const float* c = set_.Values(set_.Of(MakeCorner(face, kPreviousIndex[IndexOf(corner)])));
            for (const std::uint32_t first : set_.channels.textures)
                if (TextureTurns(DoubleTextureArea(before, b, c, first),
                                 DoubleTextureArea(value, b, c, first)))
                    return true;
        }
        return false;
    }
};

} // namespace vcg_ext
