// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// A point of the original with its share of the area, attached to the face of the simplified surface that
/// is closest to it. Samples of one face form a list.
struct alignas(32) Sample {
    float x, y, z;
    float weight;
    float distance2;    ///< square of the distance to \c face
    std::uint32_t face; ///< of the simplified surface
    std::uint32_t next; ///< sample of the same face, or kNone
    SurfacePlace origin;
};
static_assert(sizeof(Sample) == 32, "half a cache line");

inline Vector3<float> PositionOf(const Sample& sample)
{
    return {sample.x, sample.y, sample.z};
}

/// The samples of a face, summed up.
struct SampleSummary {
    std::uint32_t first = kNone; ///< of the list
    std::uint32_t count = 0;
    float weight = 0;
    float energy = 0; ///< sum of weight x squared distance

    /// Adds the sums of another face; the lists stay apart.
    void Add(const SampleSummary& face)
    {
        count += face.count;
        weight += face.weight;
        energy += face.energy;
    }
};

/// Samples and their lists. Samples lie in memory in the order of the faces that they were first attached to.
struct SampleLists {
    Buffer<Sample> samples;
    Buffer<SampleSummary> faces; ///< of the simplified surface

    void Clear(std::uint32_t face) { faces[face] = SampleSummary{}; }
    /// Puts sample \p i, whose distance is known, at the front of the list of \p face.
    void Attach(std::uint32_t i, std::uint32_t face)
    {
        Sample& sample = samples[i];
        SampleSummary& summary = faces[face];
        sample.face = face;
        sample.next = summary.first;
        summary.first = i;
        ++summary.count;
        summary.weight += sample.weight;
        summary.energy += sample.weight * sample.distance2;
    }
};

/// Weighted mean of the squared distances, 0 without samples.
inline double MeanSquare(const Buffer<Sample>& samples)
{
    double energy = 0, weight = 0;
    for (const Sample& sample : samples) {
        energy += static_cast<double>(sample.weight) * static_cast<double>(sample.distance2);
        weight += static_cast<double>(sample.weight);
    }
    return weight > 0 ? energy / weight : 0;
}
inline double MeanSquare(const SampleLists& lists)
{
    return MeanSquare(lists.samples);
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
