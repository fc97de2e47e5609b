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
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// Which samples are drawn: every vertex on a face, every centroidStep-th face and, where these are few,
/// every edge.
struct SamplePlan {
    std::size_t vertices = 0;
    std::size_t centroids = 0;
    std::size_t centroidStep = 1;
    std::size_t halfEdges = 0; ///< 3 face + index; of each edge the first face draws the midpoint

    std::size_t Items() const { return vertices + centroids + halfEdges; }
    bool IsHalfEdge(std::size_t item) const { return item >= vertices + centroids; }
    bool IsVertex(std::size_t item) const { return item < vertices; }
    std::uint32_t FaceOfItem(std::size_t item) const
    {
        return static_cast<std::uint32_t>((item - vertices) * centroidStep);
    }
    /// Vertices and centroids that are thinned count alike: the weight of a sample that stands for many faces
    /// would be noise.
    SampleShares Shares() const
    {
        if (halfEdges > 0) return kSharesWithMidpoints;
        if (centroidStep == 1) return kShares;
        const float part = static_cast<float>(vertices) / static_cast<float>(vertices + centroids);
        return {part, 0, 1 - part};
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
    if (plan.centroidStep == 1 && vertices + centroids < double{kMinSamplesPerFace})
        plan.halfEdges = 3 * original.FaceCount();
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
    SampleShares shares_;
    float importantDescriptor_; ///< the one of kFeatureQuantile; 0: none is important
    float featureShare_;
    std::size_t groups_;
    int threads_;
    Buffer<float> area_;               // of the original's faces
    Buffer<std::uint32_t> items_;      // by group, ascending in each
    std::vector<std::uint32_t> begin_; // of the groups in items_; the last one holds what has no group

  public:
    /// \param root a vertex of \p simplified for every vertex of \p original, kNone where there is none
    /// \param featureShare as kFeatureShare
    SampleDrawer(const SurfaceArrays& original, const SurfaceArrays& simplified,
                 const Buffer<std::uint32_t>& root, int threads, float featureShare = kFeatureShare)
        : original_(original), simplified_(simplified), root_(root), plan_(PlanSamples(original, simplified)),
          shares_(plan_.Shares()), importantDescriptor_(ImportantDescriptor(original)),
          featureShare_(featureShare), groups_(simplified.VertexCount()), threads_(threads)
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
        if (plan_.IsHalfEdge(item)) return MidpointSample(EdgeOfItem(item));
        return plan_.IsVertex(item) ? VertexSample(item) : CentroidSample(plan_.FaceOfItem(item));
    }

  private:
    struct Edge {
        std::uint32_t face, a, b;
    };

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
        if (plan_.IsHalfEdge(item)) return GroupOfEdge(EdgeOfItem(item));
        std::uint32_t group = kNone;
        for (const std::uint32_t v : original_.triangles[plan_.FaceOfItem(item)].v) {
            const std::uint32_t candidate = LiveRoot(v);
            if (candidate == kNone) continue;
            if (simplified_.cornerCount[candidate] <= kMaxSearchedStar) return candidate;
            group = candidate;
        }
        return group;
    }
    Edge EdgeOfItem(std::size_t item) const
    {
        const std::size_t halfEdge = item - plan_.vertices - plan_.centroids;
        const SurfaceTriangle& t = original_.triangles[halfEdge / 3];
        return {static_cast<std::uint32_t>(halfEdge / 3), t.v[halfEdge % 3], t.v[kNextIndex[halfEdge % 3]]};
    }
    template <class Visit>
    void ForEachFaceOf(const Edge& edge, const Visit& visit) const
    {
        for (const Corner* c = BeginCorners(original_, edge.a); c != EndCorners(original_, edge.a); ++c)
            if (HasVertex(original_.triangles[FaceOf(*c)], edge.b)) visit(FaceOf(*c));
    }
    std::uint32_t GroupOfEdge(const Edge& edge) const
    {
        bool isFirst = true;
        ForEachFaceOf(edge, [&](std::uint32_t f) { isFirst &= f >= edge.face; });
        if (!isFirst) return kNone;
        const std::uint32_t root = LiveRoot(edge.a);
        return root != kNone ? root : LiveRoot(edge.b);
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
        return {p.x, p.y,   p.z,   (shares_.vertices + FeatureShare(p.weight)) * area / 3 * p.weight,
                0,   kNone, kNone, v};
    }
    Sample CentroidSample(std::uint32_t f) const
    {
        const Vector3<float> p = Centroid(original_, f);
        float weight = 0;
        for (const std::uint32_t v : original_.triangles[f].v) weight += original_.points[v].weight / 3;
        const float area = static_cast<float>(plan_.centroidStep) * area_[f];
        return {p.x, p.y, p.z, shares_.centroids * area * weight, 0, kNone, kNone, f | kFacePlace};
    }
    Sample MidpointSample(const Edge& edge) const
    {
        float area = 0;
        ForEachFaceOf(edge, [&](std::uint32_t f) { area += area_[f]; });
        const Vector3<float> p = 0.5F * (PositionOf(original_, edge.a) + PositionOf(original_, edge.b));
        const float weight = (original_.points[edge.a].weight + original_.points[edge.b].weight) / 2;
        return {p.x, p.y,   p.z,   shares_.midpoints * area / 3 * weight,
                0,   kNone, kNone, edge.face | kFacePlace};
    }
    /// \param weight of the vertex, e^{2 l}
    float FeatureShare(float weight) const
    {
        if (!(importantDescriptor_ > 0)) return 0;
        const float l = 0.5F * std::log(weight) / importantDescriptor_;
        return featureShare_ * std::min(1.0F, l * l);
    }
    /// The quantile of the descriptors, from an even sample of the vertices.
    static float ImportantDescriptor(const SurfaceArrays& surface)
    {
        constexpr std::size_t kVertices = 8192;
        std::vector<float> weights;
        const std::size_t step = std::max<std::size_t>(1, surface.VertexCount() / kVertices);
        for (std::size_t v = 0; v < surface.VertexCount(); v += step)
            if (surface.cornerCount[v] > 0) weights.push_back(surface.points[v].weight);
        if (weights.empty()) return 0;
        const auto place =
            static_cast<std::ptrdiff_t>(kFeatureQuantile * static_cast<double>(weights.size() - 1));
        std::nth_element(weights.begin(), weights.begin() + place, weights.end());
        return 0.5F * std::log(weights[static_cast<std::size_t>(place)]);
    }
};

} // namespace vcg_ext
