// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/star.h"

namespace vcg_ext::refinement
{

/// Attaches samples to the closest face of the simplified surface, as far as a walk over stars finds it.
class SampleLocator
{
    static constexpr std::size_t kLongestWalk = 12;    ///< stars searched for one sample
    static constexpr float kLeastWeight = 1e-4F;       ///< a walk goes on at a corner with more than this
    static constexpr float kLeastProgress = 1 - 1e-6F; ///< another face must be closer by this factor

    const SurfaceArrays& surface_;

  public:
    explicit SampleLocator(const SurfaceArrays& surface) : surface_(surface) {}

    /// Four samples at once against the star of \p v; those closest to its rim walk on.
    /// \pre star is that of v; 1 to 4 samples
    void LocateFour(std::uint32_t v, const Star& star, Sample* samples, std::size_t count) const
    {
        const auto at = [&](std::size_t i) { return &samples[std::min(i, count - 1)].x; };
        Vector3<Float4> p;
        Float4 weight;
        LoadTransposed(at(0), at(1), at(2), at(3), p.x, p.y, p.z, weight);
        p = p - Splat(PositionOf(surface_, v));
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
            if (onRim[lane]) WalkOn(samples[i], v);
        }
    }

  private:
    ClosestPoint ClosestOnFace(const Vector3<float>& p, std::uint32_t face) const
    {
        const SurfaceTriangle& t = surface_.triangles[face];
        const Vector3<float> a = PositionOf(surface_, t.v[0]);
        return ClosestOnTriangle(p - a, PositionOf(surface_, t.v[1]) - a, PositionOf(surface_, t.v[2]) - a);
    }
    /// From star to star, each around the corner nearest to the closest point so far, none twice.
    void WalkOn(Sample& sample, std::uint32_t start) const
    {
        const Vector3<float> p = PositionOf(sample);
        std::array<std::uint32_t, kLongestWalk> seen{start};
        ClosestPoint closest = ClosestOnFace(p, sample.face);
        for (std::size_t stars = 1; stars < kLongestWalk; ++stars) {
            std::uint32_t next = kNone;
            float mostWeight = kLeastWeight;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = surface_.triangles[sample.face].v[k];
                if (closest.weights[k] <= mostWeight || surface_.cornerCount[v] > kLargestSearchedStar)
                    continue;
                if (std::find(seen.begin(), seen.begin() + stars, v) != seen.begin() + stars) continue;
                mostWeight = closest.weights[k];
                next = v;
            }
            if (next == kNone) return;
            seen[stars] = next;
            for (const Corner* c = BeginCorners(surface_, next); c != EndCorners(surface_, next); ++c) {
                const ClosestPoint other = ClosestOnFace(p, FaceOf(*c));
                if (!(other.distance2 < sample.distance2 * kLeastProgress)) continue;
                closest = other;
                sample.distance2 = other.distance2;
                sample.face = FaceOf(*c);
            }
        }
    }
};

/// Samples as \p drawer has them, each located from the vertex of its group.
inline Buffer<Sample> LocateSamples(const SurfaceArrays& simplified, const SampleDrawer& drawer, int threads)
{
    constexpr std::size_t kGroups = 512;
    Buffer<Sample> located(drawer.Count());
    const SampleLocator locator(simplified);
    ParallelRanges(threads, simplified.VertexCount(), kGroups, [&](std::size_t begin, std::size_t end, int) {
        Star star;
        for (std::size_t v = begin; v < end; ++v) {
            const std::size_t first = drawer.GroupBegin(v), last = drawer.GroupEnd(v);
            if (first == last) continue;
            GatherStar(simplified, static_cast<std::uint32_t>(v), star);
            for (std::size_t slot = first; slot < last; slot += kLanes) {
                const std::size_t count = std::min<std::size_t>(kLanes, last - slot);
                for (std::size_t i = slot; i < slot + count; ++i) located[i] = drawer.Draw(i);
                locator.LocateFour(static_cast<std::uint32_t>(v), star, &located[slot], count);
            }
        }
    });
    return located;
}

/// Samples of \p original attached to the faces of \p simplified. Lists hop through memory, so the samples of
/// a face are put side by side: that halves the time of every later pass.
inline SampleLists AttachSamples(const SurfaceArrays& original, const SurfaceArrays& simplified,
                                 const Buffer<std::uint32_t>& root, const RefinementParameters& parameters)
{
    const int threads = ResolveThreads(parameters.threads);
    const Buffer<Sample> located =
        LocateSamples(simplified, SampleDrawer(original, simplified, root, parameters), threads);
    SampleLists lists;
    lists.samples.Allocate(located.size());
    lists.faces.Allocate(simplified.FaceCount());
    const std::vector<std::uint32_t> begin = StableScatter(
        threads, located.size(), simplified.FaceCount(), [&](std::size_t i) { return located[i].face; },
        [&](std::size_t i, std::uint32_t place) { lists.samples[place] = located[i]; });
    ParallelRanges(threads, simplified.FaceCount(), 4096, [&](std::size_t from, std::size_t to, int) {
        for (std::size_t f = from; f < to; ++f) {
            const auto face = static_cast<std::uint32_t>(f);
            lists.Clear(face);
            for (std::uint32_t i = begin[f + 1]; i-- > begin[f];) lists.Attach(i, face);
        }
    });
    return lists;
}

} // namespace vcg_ext::refinement
