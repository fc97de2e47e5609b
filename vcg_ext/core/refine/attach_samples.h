// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/draw_samples.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/star.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// Attaches samples to the closest face of the surface, as far as a walk finds it: four at once to one of the
/// star of \p v; those closest to its rim walk on.
/// \pre star is that of v; 1 to 4 samples
inline void LocateFour(const SurfaceArrays& surface, std::uint32_t v, const Star& star, Sample* samples,
                       std::size_t count)
{
    const auto at = [&](std::size_t i) { return &samples[std::min(i, count - 1)].x; };
    Vector3<Float4> p;
    Float4 weight;
    LoadTransposed(at(0), at(1), at(2), at(3), p.x, p.y, p.z, weight);
    p = p - Splat(PositionOf(surface, v));
    Float4 best = Splat(std::numeric_limits<float>::max());
    Int4 owner = Splat(0), onRim = Splat(0);
    for (std::size_t i = 0; i < star.size(); ++i) {
        const FourClosestPoints closest = ClosestOnTriangle(p, star[i].triangle);
        const Int4 closer = closest.distance2 < best;
        best = Select(closer, closest.distance2, best);
        onRim = Select(closer, closest.onFarEdge, onRim);
        owner = Select(closer, Splat(static_cast<std::int32_t>(i)), owner);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const int lane = static_cast<int>(i);
        samples[i].distance2 = best[lane];
        samples[i].face = star[static_cast<std::size_t>(owner[lane])].face;
        if (!onRim[lane]) continue;
        const FaceHit hit =
            WalkFromStar(surface, PositionOf(samples[i]), v, {samples[i].face, best[lane], {}});
        samples[i].distance2 = hit.distance2;
        samples[i].face = hit.face;
    }
}

/// Samples as \p drawer has them, each located from the vertex of its group.
inline Buffer<Sample> LocateSamples(const SurfaceArrays& simplified, const SampleDrawer& drawer, int threads)
{
    constexpr std::size_t kGroups = 512;
    Buffer<Sample> located(drawer.Count());
    ParallelRanges(threads, simplified.VertexCount(), kGroups, [&](std::size_t begin, std::size_t end, int) {
        Star star;
        for (std::size_t v = begin; v < end; ++v) {
            const std::size_t first = drawer.GroupBegin(v), last = drawer.GroupEnd(v);
            if (first == last) continue;
            GatherStar(simplified, static_cast<std::uint32_t>(v), star);
            for (std::size_t slot = first; slot < last; slot += kLanes) {
                const std::size_t count = std::min<std::size_t>(kLanes, last - slot);
                for (std::size_t i = slot; i < slot + count; ++i) located[i] = drawer.Draw(i);
                LocateFour(simplified, static_cast<std::uint32_t>(v), star, &located[slot], count);
            }
        }
    });
    return located;
}

/// Faces of a surface in a tree, for questions in its own frame.
/// \param faces which; neighbours in space should follow each other
inline FaceTree TreeOf(const Buffer<SurfacePoint>& points, const Buffer<SurfaceTriangle>& triangles,
                       int threads, const std::vector<std::uint32_t>& faces)
{
    MeshView view;
    view.positions = points.data();
    view.positionStride = sizeof(SurfacePoint);
    view.vertexCount = points.size();
    view.triangles = triangles.data()->v;
    view.faceCount = triangles.size();
    return {view, Frame{}, threads, faces};
}
/// All of them.
inline FaceTree TreeOf(const Buffer<SurfacePoint>& points, const Buffer<SurfaceTriangle>& triangles,
                       int threads)
{
    std::vector<std::uint32_t> order(triangles.size()); // neighbours in space follow each other already
    std::iota(order.begin(), order.end(), 0U);
    return TreeOf(points, triangles, threads, order);
}
inline FaceTree TreeOf(const SurfaceArrays& surface, int threads)
{
    return TreeOf(surface.points, surface.triangles, threads);
}

/// Attaches those of \p samples that are far from the face that a walk found to the closest of all faces.
inline void SearchFarSamples(const SurfaceArrays& simplified, Buffer<Sample>& samples, int threads)
{
    constexpr std::size_t kGrain = 4096;
    const auto far2 = static_cast<float>(double{kFarSample * kFarSample} * MeanSquare(samples));
    const auto isFar = [&](const Sample& sample) { return sample.distance2 > far2; };
    if (std::none_of(samples.begin(), samples.end(), isFar)) return;
    const FaceTree tree = TreeOf(simplified, threads);
    ParallelRanges(threads, samples.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        std::vector<FaceTree::Candidate> found;
        for (std::size_t i = begin; i < end; ++i) {
            Sample& sample = samples[i];
            if (!isFar(sample)) continue;
            tree.FindClosest(PositionOf(sample), 0, sample.distance2, found);
            for (const FaceTree::Candidate& face : found) {
                if (!(face.distance2 < sample.distance2 * kMinProgress)) continue;
                sample.distance2 = face.distance2;
                sample.face = face.face;
            }
        }
    });
}

/// Puts each sample at its place, without a second copy of all: together they set the peak of memory where
/// little is removed. \p place is a permutation, and used up.
inline void PutInPlace(Buffer<Sample>& samples, Buffer<std::uint32_t>& place)
{
    constexpr std::size_t kBetweenQuestions = std::size_t{1} << 16; // swaps: one cycle may be all of them
    std::size_t swaps = 0;
    for (std::uint32_t i = 0; i < place.size(); ++i)
        while (place[i] != i) {
            const std::uint32_t to = place[i];
            std::swap(samples[i], samples[to]);
            std::swap(place[i], place[to]);
            if (++swaps % kBetweenQuestions == 0) LoopPoll::Ask();
        }
}

/// Samples of \p original attached to the faces of \p simplified. Lists hop through memory, so the samples of
/// a face are put side by side: that halves the time of every later pass.
inline SampleLists AttachSamples(const SurfaceArrays& original, const SurfaceArrays& simplified,
                                 const Buffer<std::uint32_t>& root, int threads,
                                 float featureShare = kFeatureShare)
{
    Buffer<Sample> located =
        LocateSamples(simplified, SampleDrawer(original, simplified, root, threads, featureShare), threads);
    SearchFarSamples(simplified, located, threads);
    SampleLists lists;
    lists.faces.Allocate(simplified.FaceCount());
    Buffer<std::uint32_t> place(located.size());
    const std::vector<std::uint32_t> begin = StableScatter(
        threads, located.size(), simplified.FaceCount(), [&](std::size_t i) { return located[i].face; },
        [&](std::size_t i, std::uint32_t to) { place[i] = to; });
    PutInPlace(located, place);
    lists.samples = std::move(located);
    ParallelRanges(threads, simplified.FaceCount(), 4096, [&](std::size_t from, std::size_t to, int) {
        for (std::size_t f = from; f < to; ++f) {
            const auto face = static_cast<std::uint32_t>(f);
            lists.Clear(face);
            for (std::uint32_t i = begin[f + 1]; i-- > begin[f];) lists.Attach(i, face);
        }
    });
    return lists;
}

} // namespace vcg_ext
