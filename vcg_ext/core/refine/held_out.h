// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>
#include <ctime>
#include <cstdio>
#include <cstdlib>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/surface_walk.h"

// Points of both surfaces that the passes have not looked at: where they may be far from the other surface,
// by walks, and how far they are, by a tree.

namespace vcg_ext
{

/// Where a point of a face is: the parts of the second and of the third corner; the first has the rest.
struct PlaceInFace {
    float second, third;
};

/// A face by its coordinates.
struct FaceCorners {
    Vector3<float> a, toB, toC;

    Vector3<float> At(const PlaceInFace& place) const { return a + place.second * toB + place.third * toC; }
};

inline FaceCorners CornersOf(const Buffer<SurfacePoint>& points, const SurfaceTriangle& triangle)
{
    const auto at = [&](std::size_t k) {
        const SurfacePoint& p = points[triangle.v[k]];
        return Vector3<float>{p.x, p.y, p.z};
    };
    const Vector3<float> a = at(0);
    return {a, at(1) - a, at(2) - a};
}
inline FaceCorners CornersOf(const SurfaceArrays& surface, std::uint32_t face)
{
    return CornersOf(surface.points, surface.triangles[face]);
}

constexpr float kHeldOutStep = 1.0F / kHeldOutGrid;

/// Calls visit(place) for the points of a grid over a face, corners included, each near the one before.
template <class Visit>
void ForEachGridPoint(const Visit& visit)
{
    for (int i = 0; i <= kHeldOutGrid; ++i)
        for (int j = 0; i + j <= kHeldOutGrid; ++j)
            visit(PlaceInFace{kHeldOutStep * static_cast<float>(i),
                              kHeldOutStep * static_cast<float>(i % 2 == 0 ? j : kHeldOutGrid - i - j)});
}

/// The largest squared distance of a face's points to a surface, and where it is.
struct FarthestPoint {
    float distance2;
    PlaceInFace place;
};

/// Of the points of the grid the farthest, and then of ever smaller steps around it.
/// \param floor2 what is nearer is not looked for: the answer is then this
inline FarthestPoint FindFarthest(const FaceTree& surface, const FaceCorners& face, float floor2)
{
    constexpr int kHalvings = 4;
    FarthestPoint best{floor2, {}};
    const auto measure = [&](const PlaceInFace& place) {
        const Vector3<float> p = face.At(place);
        if (surface.FaceWithin(p, best.distance2)) return;
        const float distance2 = surface.Distance2(p);
        if (distance2 > best.distance2) best = {distance2, place};
    };
    ForEachGridPoint(measure);
    if (!(best.distance2 > floor2)) return best;
    float step = kHeldOutStep;
    for (int i = 0; i < kHalvings; ++i) {
        step /= 2;
        const PlaceInFace center = best.place;
        for (const PlaceInFace& d :
             {PlaceInFace{step, 0}, {-step, 0}, {0, step}, {0, -step}, {step, -step}, {-step, step}}) {
            const PlaceInFace place{center.second + d.second, center.third + d.third};
            if (place.second >= 0 && place.third >= 0 && place.second + place.third <= 1) measure(place);
        }
    }
    return best;
}

/// The largest squared distance of points to a surface, by walks: never too small, and too large where a
/// walk ends too early. One object per thread.
class WalkedDistances
{
    PlaceSearch search_;
    Vector3<Float4> points_{};
    std::array<SurfacePlace, kLanes> places_{};
    std::array<SurfacePlace*, kLanes> hints_{};
    int count_ = 0;
    float largest2_ = 0;

  public:
    explicit WalkedDistances(const SurfaceArrays& surface) : search_(surface)
    {
        for (std::size_t lane = 0; lane < kLanes; ++lane) hints_[lane] = &places_[lane];
    }

    /// Begins with points near a place of the surface; each walk begins where the ones before ended.
    void Begin(SurfacePlace start)
    {
        places_.fill(start);
        count_ = 0;
        largest2_ = 0;
    }
    void Add(const Vector3<float>& point, SurfacePlace near)
    {
        for (std::size_t lane = static_cast<std::size_t>(count_); lane < kLanes; ++lane) places_[lane] = near;
        Add(point);
    }
    void Add(const Vector3<float>& point)
    {
        for (int lane = count_; lane < kLanes; ++lane) SetLane(points_, lane, point);
        if (++count_ == kLanes) Measure();
    }
    void AddCentroidAndMidpoints(const FaceCorners& face)
    {
        constexpr float kThird = 1.0F / 3;
        for (const PlaceInFace& place : {PlaceInFace{kThird, kThird}, {0.5F, 0}, {0, 0.5F}, {0.5F, 0.5F}})
            Add(face.At(place));
    }
    void AddGrid(const FaceCorners& face)
    {
        ForEachGridPoint([&](const PlaceInFace& place) { Add(face.At(place)); });
    }
    /// Of all points since Begin.
    float Largest2()
    {
        if (count_ > 0) Measure();
        return largest2_;
    }

  private:
    void Measure()
    {
        const PlaceSearch::FourHits hits = search_.Find(points_, hints_.data());
        largest2_ = std::max(largest2_, MaxLane(OrZero(hits.found, hits.distance2)));
        count_ = 0;
    }
};

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

/// Finds them: a few points of every face, and of the original's faces around samples that are not near; and
/// where one of those is not near either, all points of the grid.
class SuspectFinder
{
    static constexpr std::size_t kGrain = 1024;
    const RefinementState& state_;
    float limit2_;
    int threads_;

  public:
    SuspectFinder(const RefinementState& state, float limit2, int threads)
        : state_(state), limit2_(limit2), threads_(threads)
    {
    }

    Suspects Find() const
    {
        Suspects suspects; auto t0=clock();
        suspects.ofSimplified = Chosen<std::uint32_t>(
            state_.simplified.FaceCount(), state_.original, [&](std::size_t f, auto& walked, auto& chosen) {
                if (IsSuspect(static_cast<std::uint32_t>(f), walked)) chosen.push_back(static_cast<std::uint32_t>(f));
            });
        auto t1=clock(); const std::vector<PlacedFace> placed = FacesAroundSamples(); auto t2=clock();
        suspects.ofOriginal = Chosen<std::uint32_t>(
            placed.size(), state_.simplified, [&](std::size_t i, auto& walked, auto& chosen) {
                walked.Begin(placed[i].near);
                if (MayBeFar(CornersOf(state_.original, placed[i].face), walked)) chosen.push_back(placed[i].face);
            });
        if(getenv("TB")) fprintf(stderr,"{bwd %ld collect %ld (%zu) fwd %ld}",t1-t0,t2-t1,placed.size(),clock()-t2);
        return suspects;
    }

  private:
    /// What choose(item, walked, chosen) appends for each item, in the order of the items.
    template <class Item, class Choose>
    std::vector<Item> Chosen(std::size_t items, const SurfaceArrays& walkedSurface, const Choose& choose) const
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
        if (!(walked.Largest2() > kSuspect * kSuspect * limit2_)) return false;
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
        if (!(walked.Largest2() > kSuspect * kSuspect * limit2_)) return false;
        walked.AddGrid(corners);
        return walked.Largest2() > limit2_;
    }
    /// The original's faces around samples that are not near, each once.
    std::vector<PlacedFace> FacesAroundSamples() const
    {
        const Buffer<Sample>& samples = state_.samples.samples;
        const SurfaceArrays& original = state_.original;
        const float near2 = kSuspectSample * kSuspectSample * limit2_;
        std::vector<PlacedFace> faces = Chosen<PlacedFace>(samples.size(), original, [&](std::size_t i, auto&, auto& chosen) {
            const Sample& sample = samples[i];
            if (!(sample.distance2 > near2)) return;
            const SurfacePlace near = sample.face | kFacePlace;
            if (IsFace(sample.origin)) return chosen.push_back({sample.origin & ~kFacePlace, near});
            if (original.cornerCount[sample.origin] > kMaxSearchedStar) return;
            for (const Corner* c = BeginCorners(original, sample.origin); c != EndCorners(original, sample.origin); ++c)
                chosen.push_back({FaceOf(*c), near});
        });
        std::sort(faces.begin(), faces.end());
        const auto same = [](const PlacedFace& l, const PlacedFace& r) { return l.face == r.face; };
        faces.erase(std::unique(faces.begin(), faces.end(), same), faces.end());
        return faces;
    }
};

} // namespace vcg_ext
