// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/base/stable_scatter.h"
#include "vcg_ext/core/mesh/surface_arrays.h"
#include "vcg_ext/core/mesh/surface_corners.h"

namespace vcg_ext::refinement
{

/// End of a list, no face, no vertex.
constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Walks go around vertices with more faces than this: searching such a star for every sample near it would
/// cost the square of its size.
constexpr std::uint32_t kLargestSearchedStar = 256;

/// A place on the original surface: one of its vertices, or one of its faces with the highest bit set.
using Place = std::uint32_t;
constexpr Place kFacePlace = 0x80000000;
inline bool IsFace(Place place)
{
    return (place & kFacePlace) != 0;
}

/// A point of the original with its share of the area, attached to the face of the simplified surface that
/// is closest to it. Samples of one face form a list.
struct alignas(32) Sample {
    float x, y, z;
    float weight;
    float distance2;    ///< square of the distance to \c face
    std::uint32_t face; ///< of the simplified surface
    std::uint32_t next; ///< sample of the same face, or kNone
    Place origin;
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

/// The sums of several faces; the lists stay apart.
inline void Add(const SampleSummary& face, SampleSummary& sum)
{
    sum.count += face.count;
    sum.weight += face.weight;
    sum.energy += face.energy;
}

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

inline SamplePlan PlanSamples(const SurfaceArrays& original, const SurfaceArrays& simplified,
                              const RefinementParameters& parameters)
{
    const double faces = static_cast<double>(std::max<std::size_t>(1, simplified.FaceCount()));
    const double vertices = static_cast<double>(original.VertexCount()) / faces;
    const double centroids = static_cast<double>(original.FaceCount()) / faces;
    const double wanted = std::max(0.5, static_cast<double>(parameters.samplesPerFace) - vertices);
    SamplePlan plan;
    plan.vertices = original.VertexCount();
    if (vertices + centroids > static_cast<double>(parameters.samplesPerFace))
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
    const RefinementParameters& parameters_;
    SamplePlan plan_;
    std::size_t groups_;
    int threads_;
    Buffer<float> area_;               // of the original's faces
    Buffer<std::uint32_t> items_;      // by group, ascending in each
    std::vector<std::uint32_t> begin_; // of the groups in items_; the last one holds what has no group

  public:
    /// \param root a vertex of \p simplified for every vertex of \p original, kNone where there is none
    SampleDrawer(const SurfaceArrays& original, const SurfaceArrays& simplified,
                 const Buffer<std::uint32_t>& root, const RefinementParameters& parameters)
        : original_(original), simplified_(simplified), root_(root), parameters_(parameters),
          plan_(PlanSamples(original, simplified, parameters)), groups_(simplified.VertexCount()),
          threads_(ResolveThreads(parameters.threads))
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
            if (simplified_.cornerCount[candidate] <= kLargestSearchedStar) return candidate;
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
        return {p.x, p.y, p.z, parameters_.vertexShare * area / 3 * p.weight, 0, kNone, kNone, v};
    }
    Sample CentroidSample(std::uint32_t f) const
    {
        const Vector3<float> p = Centroid(original_, f);
        float weight = 0;
        for (const std::uint32_t v : original_.triangles[f].v) weight += original_.points[v].weight / 3;
        const float area = static_cast<float>(plan_.centroidStep) * area_[f];
        return {p.x, p.y,   p.z,   (1 - parameters_.vertexShare) * area * weight,
                0,   kNone, kNone, f | kFacePlace};
    }
};

/// Weighted mean of the squared distances, 0 without samples.
inline double MeanSquare(const SampleLists& lists)
{
    double energy = 0, weight = 0;
    for (const Sample& sample : lists.samples) {
        energy += static_cast<double>(sample.weight) * static_cast<double>(sample.distance2);
        weight += static_cast<double>(sample.weight);
    }
    return weight > 0 ? energy / weight : 0;
}

} // namespace vcg_ext::refinement
