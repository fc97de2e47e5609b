// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/collapse/placement.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/crossing_guard.h"
#include "vcg_ext/ordered/legality.h"
#include "vcg_ext/ordered/mesh.h"
#include "vcg_ext/ordered/queue.h"
#include "vcg_ext/ordered/stars.h"

namespace vcg_ext
{

/// What the guided collapse needs to know beside the mesh.
struct GuidedParameters {
    Guidance guidance;
    Boundary boundary = Boundary::Preserve;  ///< Lock is up to fixedVertices
    bool preserveTopology = false;           ///< full link condition
    std::vector<std::uint8_t> fixedVertices; ///< not 0: neither moves nor goes; empty: none
    std::vector<std::uint8_t> guarded;       ///< not 0: faces may not cross where it goes; empty: they may
};

/// The view's guidance; without it, the descriptor of polygons, which their triangles do not tell.
inline Guidance GuidanceOf(const MeshView& view, double featureWeight)
{
    Guidance guidance;
    guidance.featureWeight = featureWeight;
    if (view.guidance != nullptr)
        guidance.given.assign(view.guidance, view.guidance + view.vertexCount);
    else if (view.fauxEdges != nullptr)
        guidance.descriptor = LaplacianDescriptor(view);
    return guidance;
}

/// The feature-guided quadric edge collapse, as a Method of CollapseRun.
///
/// Every vertex has a descriptor l, a weight w = e^{lambda l}, the quadric C of its present faces and the
/// accumulated quadric A of all planes that were ever merged into it, times w. An edge is judged by
///
///     Q(x)  = w_u C_u(x) + w_v C_v(x)                                       no memory
///     x     = argmin Q(x) + volume plane + 1e-6 trace(Q) / 3 |x - midpoint|²
///     g     = max(Q(x), .25 A(x)) + .3 F w A(x) / trace(A) + 1e-12 |uv|² trace(A)
///     cost  = g max(1, .03 / worst quality)
///
/// with A = A_u + A_v, w the larger weight and F twice the area of the mean face that is left.
///
/// Where an end of the edge costs no more than rounding x is that end: flat parts and straight creases keep
/// places of the input, and the vertex that was there survives. Where a face would turn by more than acos(.2)
/// the midpoint and the ends are tried for x, and the edge is refused if they do the same. The weight never
/// falls: the survivor takes the larger l and w, and where its own descriptor has risen above them A and w
/// rise with it. These are the formulas of the engine (core/collapse), in double precision.
template <class Mesh>
class GuidedCollapse
{
  protected:
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using CoordType = typename Mesh::CoordType;
    using Ring = std::vector<RingEdge<Mesh>>;
    using End = EdgeEnd<double>;
    using Placed = PlacedEdge<double>;

    Mesh& mesh_;
    GuidedParameters parameters_;
    GuidedStars<Mesh> stars_;
    CollapseLegality<Mesh> legality_;
    std::optional<CrossingGuard<Mesh>> guard_;
    std::vector<std::uint32_t> parent_; ///< where a vertex went; itself where it is still there
    std::vector<std::uint8_t> moved_;
    std::vector<StarFace> starFaces_; ///< scratch of Assess
    double doubleArea_ = 0;           ///< of the faces at the start

    std::size_t IndexOf(const VertexType& vertex) const { return vcg::tri::Index(mesh_, &vertex); }
    const End& EndOf(const VertexType& vertex) const { return stars_.end(IndexOf(vertex)); }

    /// As of EdgeCost; it rises with every collapse, so prices in the queue are lower bounds.
    double DistanceAreaNow() const
    {
        return DistanceArea(doubleArea_, static_cast<std::size_t>(std::max(0, mesh_.fn)));
    }

    /// The factor of a cost with the new vertex at \p x. \pre starFaces_ are gathered
    std::optional<double> PenaltyAt(const Vector3d& x) const
    {
        const std::optional<double> worst2 = WorstQuality2(starFaces_, x);
        if (!worst2) return std::nullopt;
        return QualityPenalty(*worst2);
    }

    /// The new vertex as the engine would place it; gathers starFaces_.
    std::optional<Placed> BestPlace(VertexType& removed, VertexType& kept)
    {
        const StarAreas<double> areas = stars_.Gather(removed, kept, starFaces_);
        return PlaceEdge(
            EndOf(removed), EndOf(kept), IsFixed(kept), GuidedCollapse::Estimate(removed, kept),
            DistanceAreaNow(), DBL_MAX, [&] { return areas; },
            [this](const Vector3d& x) { return PenaltyAt(x); });
    }

    bool MakesCrossings(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        return guard_ && guard_->Refuses(stars_, removed, kept, placement);
    }

    /// Where the best place is refused one of these may do, so that targets stay within reach.
    std::optional<Placed> CheapestOther(VertexType& removed, VertexType& kept)
    {
        const End &a = EndOf(removed), &b = EndOf(kept);
        std::optional<Placed> cheapest;
        const Vector3d half = HalfEdgeVector(a, b);
        for (const Vector3d& offset : OtherOffsets(half)) {
            Placed placed = PlaceAt(a, b, half, offset, DistanceAreaNow());
            const std::optional<double> penalty = PenaltyAt(placed.position);
            if (!penalty || MakesCrossings(removed, kept, placed.position)) continue;
            placed.cost *= *penalty;
            if (!cheapest || placed.cost < cheapest->cost) cheapest = placed;
        }
        return cheapest;
    }

  public:
    /// \pre vertex-face adjacency is up to date; \p mesh outlives the method
    GuidedCollapse(Mesh& mesh, GuidedParameters parameters)
        : mesh_(mesh), parameters_(std::move(parameters)),
          stars_(mesh, parameters_.guidance, parameters_.boundary), legality_(mesh),
          parent_(mesh.vert.size()), moved_(mesh.vert.size(), 0)
    {
        if (!parameters_.guarded.empty()) guard_.emplace(mesh_, std::move(parameters_.guarded));
        std::iota(parent_.begin(), parent_.end(), 0U);
        for (const FaceType& face : mesh.face)
            if (!face.IsD()) doubleArea_ += stars_.DoubleArea(face);
    }

    /// l of every vertex.
    std::vector<float> Descriptor() const
    {
        std::vector<float> l(parent_.size());
        for (std::size_t v = 0; v < l.size(); ++v) l[v] = static_cast<float>(stars_.descriptor(v));
        return l;
    }

    static constexpr bool IsDirected() { return false; }

    bool IsFixed(const VertexType& vertex) const
    {
        return !parameters_.fixedVertices.empty() && parameters_.fixedVertices[IndexOf(vertex)] != 0;
    }

    bool MayGo(const VertexType& removed, const VertexType&) const { return !IsFixed(removed); }

    /// The cost without the faces around the edge, which can but raise it.
    double Estimate(const VertexType& removed, const VertexType& kept) const
    {
        const End &a = EndOf(removed), &b = EndOf(kept);
        const Vector3d half = HalfEdgeVector(a, b);
        return EdgeCost(a, b, half, IsFixed(kept) ? half : OptimalOffset(a, b, half), DistanceAreaNow());
    }

    std::optional<CollapseAssessment> Assess(VertexType& removed, VertexType& kept)
    {
        std::optional<Placed> placed = BestPlace(removed, kept);
        if (placed && MakesCrossings(removed, kept, placed->position)) placed.reset();
        if (!placed && !IsFixed(kept)) placed = CheapestOther(removed, kept);
        if (!placed) return std::nullopt;
        return CollapseAssessment{placed->cost, placed->position, placed->atA};
    }

    bool IsLegal(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        return legality_.StaysManifold(removed, kept) &&
               (!parameters_.preserveTopology || legality_.MeetsLinkCondition(kept)) &&
               !MakesCrossings(removed, kept, placement);
    }

    /// Where nothing else is left, holes with three sides may close.
    bool BeginLastResort() { return !parameters_.preserveTopology && legality_.LetHolesClose(); }

    CoordType Merge(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        const std::size_t from = IndexOf(removed), into = IndexOf(kept);
        parent_[from] = static_cast<std::uint32_t>(into);
        const Vector3d moved = placement - EndOf(kept).position;
        if (guard_) guard_->Follow(stars_, removed, kept, placement);
        stars_.Merge(from, into, placement);
        if (!(Dot(moved, moved) > 0)) return kept.cP();
        moved_[into] = 1;
        return PointOf<CoordType>(Position(into));
    }

    void Refresh(VertexType& kept, const Ring& ring) { stars_.Refresh(kept, ring); }

    /// The vertex that \p vertex has become part of; compresses the path to it.
    std::size_t Root(std::size_t vertex)
    {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }
    /// Whether a survivor is no longer where it was.
    bool HasMoved(std::size_t vertex) const { return moved_[vertex] != 0; }
    /// Where a vertex is, in coordinates of the mesh in double precision.
    std::array<double, 3> Position(std::size_t vertex) const
    {
        return stars_.frame().OutOf(stars_.end(vertex).position);
    }
};

} // namespace vcg_ext
