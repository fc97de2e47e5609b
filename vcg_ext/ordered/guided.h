// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "vcg_ext/ordered/frame.h"
#include "vcg_ext/ordered/legality.h"
#include "vcg_ext/ordered/queue.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/stars.h"

namespace vcg_ext
{

/// What the guided collapse needs to know beside the mesh.
struct GuidedParameters {
    double featureWeight = 2;       ///< lambda >= 0, dimensionless
    std::vector<double> descriptor; ///< l in [0, 1], one a vertex
    double descriptorScale = 0;     ///< l a unit of the Laplacian descriptor; 0: l is not computed anew
    Boundary boundary = Boundary::Preserve;  ///< Lock is up to fixedVertices
    bool preserveTopology = false;           ///< full link condition
    std::vector<std::uint8_t> fixedVertices; ///< not 0: neither moves nor goes; empty: none
};

/// The feature-guided quadric edge collapse, as a Method of CollapseRun.
///
/// Every vertex has a descriptor l, a weight w = e^{lambda l}, the quadric C of its present faces and the
/// accumulated quadric A of all planes that were ever merged into it, times w. An edge is judged by
///
///     Q(x)  = w_u C_u(x) + w_v C_v(x)                                       no memory
///     x     = argmin Q(x) + volume plane + 1e-6 trace(Q) / 3 |x - midpoint|²
///     cost  = (max(Q(x), .35 (A_u + A_v)(x)) + 1e-12 |uv|² trace(Q)) / min(worst quality, .03)
///
/// Where an end of the edge costs no more than rounding x is that end: flat parts and straight creases keep
/// places of the input. Where a face would turn by more than acos(.2) the midpoint and the ends are tried for
/// x, and the edge is refused if they do the same. The weight never falls: the survivor takes the larger l
/// and w, and where its own descriptor has risen above them A and w rise with it. All of that is computed in
/// double precision in the frame of CollapseFrame, whatever the mesh's scalar.
template <class Mesh>
class GuidedCollapse
{
  protected:
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using CoordType = typename Mesh::CoordType;
    using Ring = std::vector<RingEdge<Mesh>>;
    using Point = vcg::Point3d;

    /// Part of the accumulated error that counts, where the present star has forgotten it.
    static constexpr double kMemoryFloor = .35;
    /// Triangles better than this, 2 area / longest edge², are not told apart.
    static constexpr double kQualityClamp = .03;
    /// Decides between edges that cost nothing: the shorter first.
    static constexpr double kLengthTerm = 1e-12;
    /// Planes that are missed by less, as a part of the diagonal, are met but for rounding.
    static constexpr double kNoDistance = 2e-6;
    /// Pull to the midpoint where the quadric determines nothing.
    static constexpr double kTikhonov = 1e-6;
    static constexpr double kVolumeWeight = 3;

    Mesh& mesh_;
    GuidedParameters parameters_;
    GuidedStars<Mesh> stars_;
    CollapseLegality<Mesh> legality_;
    std::vector<std::uint32_t> parent_; ///< where a vertex went; itself where it is still there
    std::vector<std::uint8_t> moved_;
    std::vector<StarFace> starFaces_; ///< scratch of Assess

    std::size_t IndexOf(const VertexType& vertex) const { return vcg::tri::Index(mesh_, &vertex); }

    /// An edge seen from its midpoint: the two ends are at -half and half.
    struct EdgeQuadric {
        const GuidedVertex* removed;
        const GuidedVertex* kept;
        Point midpoint, half;
        SymmetricMatrix a; ///< of Q
        Point pull;        ///< a x = pull at the minimum of Q
        double trace;
    };

    EdgeQuadric QuadricOf(VertexType& removed, VertexType& kept) const
    {
        EdgeQuadric edge;
        edge.removed = &stars_.vertex(IndexOf(removed));
        edge.kept = &stars_.vertex(IndexOf(kept));
        edge.midpoint = (edge.removed->position + edge.kept->position) / 2;
        edge.half = (edge.kept->position - edge.removed->position) / 2;
        edge.a.Add(edge.kept->star, edge.kept->weight);
        const Point toKept = edge.a * edge.half;
        SymmetricMatrix ofRemoved;
        ofRemoved.Add(edge.removed->star, edge.removed->weight);
        edge.pull = toKept - ofRemoved * edge.half;
        edge.a.Add(ofRemoved, 1);
        edge.trace = edge.a.Trace();
        return edge;
    }

    /// Minimum of Q plus \p volume, seen from the midpoint; the survivor's place where that is fixed.
    Point Placement(const EdgeQuadric& edge, bool keptIsFixed, const VolumePlane& volume) const
    {
        if (keptIsFixed) return edge.half;
        const double regularisation = kTikhonov * edge.trace / 3;
        if (!(regularisation > 0)) return Point(0, 0, 0);
        SymmetricMatrix matrix = edge.a;
        matrix.AddOuter(volume.normal, volume.weight);
        return SolveRegularised(matrix, regularisation,
                                edge.pull + volume.normal * (volume.weight * volume.offset));
    }

    double QuadricCost(const EdgeQuadric& edge, const Point& x) const
    {
        const Point fromRemoved = x + edge.half, fromKept = x - edge.half;
        const double now = edge.removed->weight * edge.removed->star.Form(fromRemoved) +
                           edge.kept->weight * edge.kept->star.Form(fromKept);
        const double ever = edge.removed->accumulated(fromRemoved) + edge.kept->accumulated(fromKept);
        return std::max({now, kMemoryFloor * ever, 0.0}) +
               kLengthTerm * 4 * edge.half.SquaredNorm() * edge.trace;
    }

    /// The cost of a collapse to \p x; nothing where a face would turn too far. \pre starFaces_ are gathered
    std::optional<double> CostAt(const EdgeQuadric& edge, const Point& x) const
    {
        const std::optional<double> quality = WorstQuality(starFaces_, x, kQualityClamp);
        if (!quality) return std::nullopt;
        return QuadricCost(edge, x) / *quality;
    }

    /// Where the surface around the edge is flat, or a straight crease, the end that costs less, if no face
    /// turns too far: a computed place lies in no plane of the star but for rounding. The survivor may get
    /// the place of the removed vertex; it stays itself.
    std::optional<CollapseAssessment> AtAnEnd(const EdgeQuadric& edge) const
    {
        const double rounding = kNoDistance * kNoDistance * edge.trace;
        const double costRemoved = QuadricCost(edge, -edge.half), costKept = QuadricCost(edge, edge.half);
        const bool atKept = costKept <= costRemoved;
        if (!(std::min(costKept, costRemoved) <= rounding)) return std::nullopt;
        const std::optional<double> cost = CostAt(edge, atKept ? edge.half : -edge.half);
        if (!cost || *cost > rounding) return std::nullopt;
        return CollapseAssessment{*cost, atKept ? edge.kept->position : edge.removed->position, true};
    }

    /// Where the best place is refused one of these may do, so that targets stay within reach.
    std::optional<double> CheapestOfEndsAndMidpoint(const EdgeQuadric& edge, Point& x) const
    {
        std::optional<double> cheapest;
        for (const Point& place : {Point(0, 0, 0), edge.half, -edge.half}) {
            const std::optional<double> cost = CostAt(edge, place);
            if (!cost || (cheapest && *cheapest <= *cost)) continue;
            cheapest = cost;
            x = place;
        }
        return cheapest;
    }

    VolumePlane VolumePlaneOf(const EdgeQuadric& edge, const StarMoments& moments) const
    {
        if (!(moments.area > 0)) return VolumePlane();
        const double weight = std::max(edge.removed->weight, edge.kept->weight);
        return {moments.normal, moments.offset, kVolumeWeight * weight / moments.area};
    }

  public:
    /// \pre vertex-face adjacency is up to date; \p mesh outlives the method
    GuidedCollapse(Mesh& mesh, GuidedParameters parameters)
        : mesh_(mesh), parameters_(std::move(parameters)), stars_(mesh, parameters_.boundary),
          legality_(mesh), parent_(mesh.vert.size()), moved_(mesh.vert.size(), 0)
    {
        std::iota(parent_.begin(), parent_.end(), 0U);
        stars_.Weigh(parameters_.descriptor, parameters_.featureWeight);
    }

    static constexpr bool IsDirected() { return false; }

    bool IsFixed(const VertexType& vertex) const
    {
        return !parameters_.fixedVertices.empty() && parameters_.fixedVertices[IndexOf(vertex)] != 0;
    }

    bool MayGo(const VertexType& removed, const VertexType&) const { return !IsFixed(removed); }

    double Estimate(VertexType& removed, VertexType& kept) const
    {
        const EdgeQuadric edge = QuadricOf(removed, kept);
        return QuadricCost(edge, Placement(edge, IsFixed(kept), VolumePlane())) / kQualityClamp;
    }

    std::optional<CollapseAssessment> Assess(VertexType& removed, VertexType& kept, double)
    {
        const EdgeQuadric edge = QuadricOf(removed, kept);
        const StarMoments moments = stars_.Gather(removed, kept, edge.midpoint, starFaces_);
        if (!IsFixed(kept))
            if (auto atAnEnd = AtAnEnd(edge)) return atAnEnd;
        Point x = Placement(edge, IsFixed(kept), VolumePlaneOf(edge, moments));
        std::optional<double> cost = CostAt(edge, x);
        if (!cost && !IsFixed(kept)) cost = CheapestOfEndsAndMidpoint(edge, x);
        if (!cost) return std::nullopt;
        return CollapseAssessment{*cost, x + edge.midpoint, true};
    }

    bool IsLegal(VertexType& removed, VertexType& kept)
    {
        return legality_.StaysManifold(removed, kept) &&
               (!parameters_.preserveTopology || legality_.MeetsLinkCondition(kept));
    }

    /// Where nothing else is left, holes with three sides may close.
    bool BeginLastResort() { return !parameters_.preserveTopology && legality_.LetHolesClose(); }

    CoordType Merge(VertexType& removed, VertexType& kept, const Point& placement)
    {
        const std::size_t from = IndexOf(removed), into = IndexOf(kept);
        parent_[from] = static_cast<std::uint32_t>(into);
        const Point here = stars_.vertex(into).position;
        if (IsFixed(kept) || placement == here) {
            stars_.Merge(from, into, here);
            return kept.cP();
        }
        moved_[into] = 1;
        stars_.Merge(from, into, placement);
        return CoordType::Construct(stars_.frame().OutOf(placement));
    }

    void Refresh(VertexType& kept, const Ring& ring)
    {
        stars_.Refresh(kept, ring);
        if (parameters_.descriptorScale > 0 && parameters_.featureWeight > 0)
            stars_.RaiseDescriptor(
                IndexOf(kept),
                std::min(1.0, stars_.LaplacianDescriptor(kept, ring) * parameters_.descriptorScale),
                parameters_.featureWeight);
    }

    /// The vertex that \p vertex has become part of; compresses the path to it.
    std::size_t Root(std::size_t vertex)
    {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }
    /// Whether a survivor is no longer where it was.
    bool HasMoved(std::size_t vertex) const { return moved_[vertex] != 0; }
    /// Where a vertex is, in coordinates of the mesh in double precision.
    Point Position(std::size_t vertex) const { return stars_.frame().OutOf(stars_.vertex(vertex).position); }
};

} // namespace vcg_ext
