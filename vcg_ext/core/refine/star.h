// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// A face around a vertex, seen from that vertex.
struct StarTriangle {
    std::uint32_t face;
    Corner corner;                ///< of the star's vertex
    std::uint32_t next, previous; ///< the other two vertices
    Vector3<float> toNext, toPrevious;
    PreparedTriangle<float> triangle;
};
using Star = Scratch<StarTriangle>;

inline void GatherStar(const SurfaceArrays& surface, std::uint32_t v, Star& star)
{
    const Corner* corners = BeginCorners(surface, v);
    const Vector3<float> origin = PositionOf(surface, v);
    star.Resize(surface.cornerCount[v]);
    for (std::size_t i = 0; i < star.size(); ++i) {
        StarTriangle& s = star[i];
        s.corner = corners[i];
        s.face = FaceOf(corners[i]);
        s.next = NextVertex(surface, corners[i]);
        s.previous = PreviousVertex(surface, corners[i]);
        s.toNext = PositionOf(surface, s.next) - origin;
        s.toPrevious = PositionOf(surface, s.previous) - origin;
        s.triangle = PrepareTriangle(s.toNext, s.toPrevious);
    }
}

/// Four samples of one face, seen from a common origin. Lanes behind the last sample have weight 0.
struct SampleGroup {
    Vector3<Float4> point;
    Float4 weight;
    Float4 distance2;
    Float4 newDistance2;
    Int4 newOwner;           ///< which of the collected faces is closest in the trial
    std::uint32_t sample[4]; ///< kNone behind the last
    std::uint32_t owner;     ///< which of the collected faces holds them
};
using SampleGroups = Scratch<SampleGroup>;

/// Appends the samples of one face in fours.
inline void CollectSamples(const SampleLists& lists, std::uint32_t face, std::uint32_t owner,
                           const Vector3<float>& origin, SampleGroups& groups)
{
    std::uint32_t next = lists.faces[face].first;
    while (next != kNone) {
        SampleGroup& group = groups.Append();
        group.owner = owner;
        const float* lane[4];
        Float4 distance2 = Splat(0.0F);
        int count = 0;
        for (; count < kLanes && next != kNone; ++count) {
            const Sample& sample = lists.samples[next];
            group.sample[count] = next;
            lane[count] = &sample.x;
            distance2[count] = sample.distance2;
            next = sample.next;
        }
        const Int4 used = FirstLanes(count);
        for (; count < kLanes; ++count) {
            group.sample[count] = kNone;
            lane[count] = lane[count - 1];
        }
        LoadTransposed(lane[0], lane[1], lane[2], lane[3], group.point.x, group.point.y, group.point.z,
                       group.weight);
        group.point = group.point - Splat(origin);
        group.weight = OrZero(used, group.weight);
        group.distance2 = distance2;
    }
}

/// Consecutive groups.
struct GroupRange {
    std::size_t begin, end;
};

/// Where the sample of \p range nearest to \p p comes from. \pre the range is not empty; p is seen from the
/// groups' origin
inline SurfacePlace NearestOrigin(const SampleLists& lists, const SampleGroups& groups,
                                  const GroupRange& range, const Vector3<float>& p)
{
    Float4 best = Splat(std::numeric_limits<float>::max());
    Int4 bestGroup = Splat(0);
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const Float4 distance2 = SquaredNorm(groups[i].point - Splat(p));
        bestGroup = Select(distance2 < best, Splat(static_cast<std::int32_t>(i)), bestGroup);
        best = Min(distance2, best);
    }
    int lane = 0;
    for (int i = 1; i < kLanes; ++i)
        if (best[i] < best[lane]) lane = i;
    const SampleGroup& group = groups[static_cast<std::size_t>(bestGroup[lane])];
    while (group.sample[lane] == kNone) --lane; // lanes behind the last sample repeat it
    return lists.samples[group.sample[lane]].origin;
}

/// Writes an accepted trial back: distances, owners and the lists of the collected faces.
/// \param faceOf faceOf(owner) is the face of the simplified surface
template <class FaceOfOwner>
void StoreSamples(SampleLists& lists, SampleGroups& groups, std::size_t owners, const FaceOfOwner& faceOf)
{
    for (std::size_t owner = 0; owner < owners; ++owner) lists.Clear(faceOf(owner));
    for (std::size_t i = groups.size(); i-- > 0;) {
        const SampleGroup& group = groups[i];
        for (int lane = kLanes; lane-- > 0;) {
            if (group.sample[lane] == kNone) continue;
            lists.samples[group.sample[lane]].distance2 = group.newDistance2[lane];
            lists.Attach(group.sample[lane], faceOf(static_cast<std::size_t>(group.newOwner[lane])));
        }
    }
}

} // namespace vcg_ext
