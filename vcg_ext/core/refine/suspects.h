// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/draw_samples.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/held_out.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// A face, and a place of the other surface near it.
struct PlacedFace {
    std::uint32_t face;
    SurfacePlace near;
};
inline bool operator<(const PlacedFace& l, const PlacedFace& r)
{
    return l.face != r.face ? l.face < r.face : l.near < r.near;
}

/// Faces of both surfaces, ascending, that may have points farther from the other surface than a limit.
struct Suspects {
    std::vector<std::uint32_t> ofSimplified, ofOriginal;

    bool empty() const { return ofSimplified.empty() && ofOriginal.empty(); }
};

/// Finds them: by a few points of every face, and of the original's faces around samples that are not near;
/// where one of those is not near either, by all points of the grid.
class SuspectFinder
{
    static constexpr std::size_t kGrain = 1024;
    const RefinementState& state_;
    float limit2_, notNear2_, sampleNotNear2_;
    int threads_;

  public:
    /// \param limit2 squared
    SuspectFinder(const RefinementState& state, float limit2, int threads)
        : state_(state), limit2_(limit2), notNear2_(kSuspect * kSuspect * limit2),
          sampleNotNear2_(kSuspectSample * kSuspectSample * limit2), threads_(threads)
    {
        // Then the few points are samples themselves.
        if (PlanSamples(state.original, state.simplified).halfEdges > 0) sampleNotNear2_ = notNear2_;
    }

    Suspects Find() const
    {
        Suspects suspects;
        suspects.ofSimplified = Chosen<std::uint32_t>(
            state_.simplified.FaceCount(), state_.original, [&](std::size_t f, auto& walked, auto& chosen) {
                if (IsSuspect(static_cast<std::uint32_t>(f), walked))
                    chosen.push_back(static_cast<std::uint32_t>(f));
            });
        const std::vector<PlacedFace> placed = FacesAroundSamples();
        suspects.ofOriginal = Chosen<std::uint32_t>(
            placed.size(), state_.simplified, [&](std::size_t i, auto& walked, auto& chosen) {
                walked.Begin(placed[i].near);
                if (MayBeFar(CornersOf(state_.original, placed[i].face), walked))
                    chosen.push_back(placed[i].face);
            });
        return suspects;
    }

  private:
    /// What choose(item, walked, chosen) appends for each item, in the order of the items.
    template <class Item, class Choose>
    std::vector<Item> Chosen(std::size_t items, const SurfaceArrays& walkedSurface,
                             const Choose& choose) const
    {
        std::vector<std::vector<Item>> parts((items + kGrain - 1) / kGrain);
        ParallelRanges(threads_, items, kGrain, [&](std::size_t begin, std::size_t end, int) {
            WalkedDistances walked(walkedSurface);
            for (std::size_t i = begin; i < end; ++i) choose(i, walked, parts[begin / kGrain]);
        });
        std::vector<Item> all;
        for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
        return all;
    }
    /// The points of the face as well as those that \p walked has already.
    bool MayBeFar(const FaceCorners& face, WalkedDistances& walked) const
    {
        walked.AddCentroidAndMidpoints(face);
        if (!(walked.Largest2() > notNear2_)) return false;
        walked.AddGrid(face);
        return walked.Largest2() > limit2_;
    }
    /// What no move has measured has not changed; where it has, it is known what was closest.
    bool IsSuspect(std::uint32_t face, WalkedDistances& walked) const
    {
        constexpr float kThird = 1.0F / 3;
        const SurfaceArrays& surface = state_.simplified;
        const FaceCorners corners = CornersOf(surface, face);
        const SurfacePlace below = state_.centroidHints[face];
        if (below == kNone) return false;
        walked.Begin(below);
        walked.Add(corners.At({kThird, kThird}));
        for (int k = 0; k < 3; ++k) {
            const Corner corner = MakeCorner(face, k);
            const std::uint32_t v = surface.triangles[face].v[k], w = NextVertex(surface, corner);
            if (const SurfacePlace hint = state_.edgeHints[EdgeHint(corner)]; hint != kNone)
                walked.Add(0.5F * (PositionOf(surface, v) + PositionOf(surface, w)), hint);
            if (state_.vertexHints[v] != kNone && *BeginCorners(surface, v) == corner) // each corner once
                walked.Add(PositionOf(surface, v), state_.vertexHints[v]);
        }
        if (!(walked.Largest2() > notNear2_)) return false;
        walked.AddGrid(corners);
        return walked.Largest2() > limit2_;
    }
    /// The original's faces around samples that are not near, each once.
    std::vector<PlacedFace> FacesAroundSamples() const
    {
        const Buffer<Sample>& samples = state_.samples.samples;
        const SurfaceArrays& original = state_.original;
        std::vector<PlacedFace> faces =
            Chosen<PlacedFace>(samples.size(), original, [&](std::size_t i, auto&, auto& chosen) {
                const Sample& sample = samples[i];
                if (!(sample.distance2 > sampleNotNear2_)) return;
                const SurfacePlace near = sample.face | kFacePlace;
                if (IsFace(sample.origin)) return chosen.push_back({sample.origin & ~kFacePlace, near});
                if (original.cornerCount[sample.origin] > kMaxSearchedStar) return;
                for (const Corner* c = BeginCorners(original, sample.origin);
                     c != EndCorners(original, sample.origin); ++c)
                    chosen.push_back({FaceOf(*c), near});
            });
        std::sort(faces.begin(), faces.end());
        const auto same = [](const PlacedFace& l, const PlacedFace& r) { return l.face == r.face; };
        faces.erase(std::unique(faces.begin(), faces.end(), same), faces.end());
        return faces;
    }
};

} // namespace vcg_ext
