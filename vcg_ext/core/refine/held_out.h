// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/surface_walk.h"

// Points of a face that the passes have not looked at: how far they are from the other surface, by a tree of
// that or, more quickly and from above, by walks.

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
    Box3<float> Box() const
    {
        Box3<float> box = EmptyBox<float>();
        for (const Vector3<float>& p : {a, a + toB, a + toC}) box.Add(p);
        return box;
    }
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

    /// Begins with points near a place of the surface; each walk begins where one before it ended.
    void Begin(SurfacePlace start)
    {
        places_.fill(start);
        count_ = 0;
        largest2_ = 0;
    }
    /// \param near where to look for it and for those behind it
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

} // namespace vcg_ext
