// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/star.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// Which samples are drawn: every vertex on a face, and every centroidStep-th face.
struct SamplePlan {
    std::size_t vertices = 0;
    std::size_t centroids = 0;
    std::size_t centroidStep = 1;

    std::size_t Items() const { return vertices + centroids; }
    bool IsVertex(std::size_t item) const { return item < vertices; }
    std::uint32_t FaceOfItem(std::size_t item) const
    {
        return static_cast<std::uint32_t>((item - vertices) * centroidStep);
    }
};

inline SamplePlan PlanSamples(const SurfaceArrays& original, const SurfaceArrays& simplified)
{
    const double faces = static_cast<double>(std::max<std::size_t>(1, simplified.FaceCount()));
    const double vertices = static_cast<double>(original.VertexCount()) / faces;
    const double centroids = static_cast<double>(original.FaceCount()) / faces;
    const double wanted = std::max(0.5, double{kSamplesPerFace} - vertices);
    SamplePlan plan;
    plan.vertices = original.VertexCount();
    if (vertices + centroids > double{kSamplesPerFace})
        plan.centroidStep = static_cast<std::size_t>(std::max(1L, std::lround(centroids / wanted)));
    // Subdivided meshes hold their faces in fours: an even step would always meet the same one.
    if (plan.centroidStep > 2) plan.centroidStep |= 1;
    plan.centroids = (original.FaceCount() + plan.centroidStep - 1) / plan.centroidStep;
    return plan;
}

/// Draws the samples, grouped by the simplified vertex that their place on the original was collapsed to.
class SampleDrawer
{
    static constexpr std::size_t kGrain = 8192;
    const SurfaceArrays& original_;
    const SurfaceArrays& simplified_;
    const Buffer<std::uint32_t>& root_;
    SamplePlan plan_;
    std::size_t groups_;
    int threads_;
    Buffer<float> area_;               // of the original's faces
    Buffer<std::uint32_t> items_;      // by group, ascending in each
    std::vector<std::uint32_t> begin_; // of the groups in items_; the last one holds what has no group

  public:
    /// \param root a vertex of \p simplified for every vertex of \p original, kNone where there is none
    SampleDrawer(const SurfaceArrays& original, const SurfaceArrays& simplified,
                 const Buffer<std::uint32_t>& root, int threads)
        : original_(original), simplified_(simplified), root_(root), plan_(PlanSamples(original, simplified)),
          groups_(simplified.VertexCount()), threads_(threads)
    {
        MeasureAreas();
        GroupItems();
    }

    std::size_t Count() const { return begin_[groups_]; }
    std::size_t GroupBegin(std::size_t group) const { return begin_[group]; }
    std::size_t GroupEnd(std::size_t group) const { return begin_[group + 1]; }

    /// The sample of one place in the groups, not yet attached to a face.
    Sample Draw(std::size_t slot) const
    {
        const std::uint32_t item = items_[slot];
        return plan_.IsVertex(item) ? VertexSample(item) : CentroidSample(plan_.FaceOfItem(item));
    }

  private:
    void MeasureAreas()
    {
        area_.Allocate(original_.FaceCount());
        ParallelRanges(threads_, area_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f)
                area_[f] = 0.5F * Norm(AreaVector(original_, static_cast<std::uint32_t>(f)));
        });
    }
    /// The simplified vertex whose star is searched first; kNone where nothing is left.
    std::uint32_t GroupOf(std::size_t item) const
    {
        if (plan_.IsVertex(item)) return original_.cornerCount[item] == 0 ? kNone : LiveRoot(item);
        std::uint32_t group = kNone;
        for (const std::uint32_t v : original_.triangles[plan_.FaceOfItem(item)].v) {
            const std::uint32_t candidate = LiveRoot(v);
            if (candidate == kNone) continue;
            if (simplified_.cornerCount[candidate] <= kMaxSearchedStar) return candidate;
            group = candidate;
        }
        return group;
    }
    std::uint32_t LiveRoot(std::size_t v) const
    {
        const std::uint32_t root = root_[v];
        return root != kNone && simplified_.cornerCount[root] > 0 ? root : kNone;
    }
    void GroupItems()
    {
        items_.Allocate(plan_.Items());
        begin_ = StableScatter(
            threads_, plan_.Items(), groups_ + 1,
            [&](std::size_t item) { return std::min<std::size_t>(GroupOf(item), groups_); },
            [&](std::size_t item, std::size_t place) { items_[place] = static_cast<std::uint32_t>(item); });
    }
    Sample VertexSample(std::uint32_t v) const
    {
        float area = 0;
        for (const Corner* c = BeginCorners(original_, v); c != EndCorners(original_, v); ++c)
            area += area_[FaceOf(*c)];
        const SurfacePoint& p = original_.points[v];
        return {p.x, p.y, p.z, kVertexShare * area / 3 * p.weight, 0, kNone, kNone, v};
    }
    Sample CentroidSample(std::uint32_t f) const
    {
        const Vector3<float> p = Centroid(original_, f);
        float weight = 0;
        for (const std::uint32_t v : original_.triangles[f].v) weight += original_.points[v].weight / 3;
        const float area = static_cast<float>(plan_.centroidStep) * area_[f];
        return {p.x, p.y, p.z, (1 - kVertexShare) * area * weight, 0, kNone, kNone, f | kFacePlace};
    }
};

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

/// Samples of \p original attached to the faces of \p simplified. Lists hop through memory, so the samples of
/// a face are put side by side: that halves the time of every later pass.
inline SampleLists AttachSamples(const SurfaceArrays& original, const SurfaceArrays& simplified,
                                 const Buffer<std::uint32_t>& root, int threads)
{
    const Buffer<Sample> located =
        LocateSamples(simplified, SampleDrawer(original, simplified, root, threads), threads);
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

} // namespace vcg_ext
