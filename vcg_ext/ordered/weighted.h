// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/ordered/error_functions.h"
#include "vcg_ext/ordered/legality.h"
#include "vcg_ext/ordered/mesh.h"
#include "vcg_ext/ordered/queue.h"

namespace vcg_ext
{

/// What the collapse of Zhang et al. (2012) needs beside the mesh. All vectors hold one value a vertex.
struct WeightedCollapseParameters {
    ErrorFunction errorFunction = ErrorFunction::Quadric;
    double featureWeight = 10;               ///< lambda of Eq. 6, >= 0, dimensionless; 0 is the plain form
    std::vector<double> descriptor;          ///< l in [0, 1]; empty: 0
    std::vector<double> quadricWeights;      ///< factor of the vertex's quadric; empty: 1
    std::vector<std::uint8_t> featureClass;  ///< not 0: a feature vertex of Section 4.4; empty: no classes
    std::vector<std::uint8_t> fixedVertices; ///< not 0: neither moves nor goes; empty: none
};

/// f(v) = g(v) e^{lambda l(v)} of Eq. 6, as a Method of CollapseRun, for every row of kErrorFunctions.
///
/// l is that of the removed vertex; where the survivor goes to a new place both ends are removed, in effect,
/// and the larger l counts. With classes a feature vertex goes into feature neighbours only (Section 4.4),
/// and a survivor that may move stays where it is when it takes in a vertex that is no feature.
/// Collapses that turn a face by more than 78 degrees or spoil the topology are refused.
template <class Mesh>
class WeightedCollapse
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using CoordType = typename Mesh::CoordType;
    using Corner = vcg::face::VFIterator<FaceType>;
    using Quadric = CentredQuadric<double>;

    Mesh& mesh_;
    WeightedCollapseParameters parameters_;
    const ErrorFunctionRow& function_;
    Frame frame_;
    CollapseLegality<Mesh> legality_;
    std::vector<Vector3d> positions_;
    std::vector<Quadric> quadrics_; ///< about the vertex; empty where the error function does without
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> moved_;
    CollapseSurroundings edge_; ///< scratch of Assess

    std::size_t IndexOf(const VertexType* vertex) const { return vcg::tri::Index(mesh_, vertex); }
    const Vector3d& PositionOf(const VertexType* vertex) const { return positions_[IndexOf(vertex)]; }
    double DescriptorOf(std::size_t v) const
    {
        return parameters_.descriptor.empty() ? 0 : parameters_.descriptor[v];
    }
    bool IsFeature(const VertexType& vertex) const
    {
        return !parameters_.featureClass.empty() && parameters_.featureClass[IndexOf(&vertex)] != 0;
    }
    bool KeptStays(const VertexType& removed, const VertexType& kept) const
    {
        return function_.isDirected || IsFixed(kept) || (IsFeature(kept) && !IsFeature(removed));
    }

    Vector3d NormalOf(const FaceType& face) const
    {
        return ScaledNormal(PositionOf(face.cV(0)), PositionOf(face.cV(1)), PositionOf(face.cV(2)));
    }

    void InitialiseQuadric(VertexType& vertex, RingEdges<Mesh>& ring)
    {
        Quadric& quadric = quadrics_[IndexOf(&vertex)];
        for (Corner corner(&vertex); !corner.End(); ++corner)
            quadric.matrix = quadric.matrix + OuterProduct(NormalOf(*corner.F()));
        for (const RingEdge<Mesh>& edge : ring.Collect(vertex))
            if (edge.faceCount == 1)
                quadric.matrix =
                    quadric.matrix + PerpendicularPlane(NormalOf(*edge.face),
                                                        PositionOf(edge.neighbour) - PositionOf(&vertex));
        if (!parameters_.quadricWeights.empty())
            quadric = parameters_.quadricWeights[IndexOf(&vertex)] * quadric;
    }

    void AddStayingFaces(VertexType& vertex, const VertexType& other, const Vector3d& origin)
    {
        for (Corner corner(&vertex); !corner.End(); ++corner)
            if (corner.V1() != &other && corner.V2() != &other)
                edge_.stayingFaces.push_back(
                    {PositionOf(corner.V1()) - origin, PositionOf(corner.V2()) - origin,
                     NormalOf(*corner.F()), static_cast<std::uint32_t>(vcg::tri::Index(mesh_, corner.F()))});
    }

    void AddRemovedFaces(VertexType& removed, const VertexType& kept)
    {
        for (Corner corner(&removed); !corner.End(); ++corner) {
            const Vector3d normal = NormalOf(*corner.F());
            const double length = std::sqrt(Dot(normal, normal));
            edge_.removedFaces.push_back({length > 0 ? 1 / length * normal : Vector3d{},
                                          corner.V1() == &kept || corner.V2() == &kept});
        }
    }

    void Surround(VertexType& removed, VertexType& kept)
    {
        const std::size_t from = IndexOf(&removed), into = IndexOf(&kept);
        const Vector3d origin = positions_[from];
        edge_.kept = positions_[into] - origin;
        edge_.keptStays = KeptStays(removed, kept);
        edge_.removedFaces.clear();
        edge_.stayingFaces.clear();
        AddStayingFaces(removed, kept, origin);
        if (!edge_.keptStays) AddStayingFaces(kept, removed, origin);
        if (!function_.usesQuadric) {
            AddRemovedFaces(removed, kept);
            return;
        }
        edge_.quadric = Recentred(quadrics_[into], -1.0 * edge_.kept) + quadrics_[from];
    }

  public:
    /// \pre vertex-face adjacency is up to date; \p mesh outlives the method
    WeightedCollapse(Mesh& mesh, WeightedCollapseParameters parameters)
        : mesh_(mesh), parameters_(std::move(parameters)), function_(RowOf(parameters_.errorFunction)),
          legality_(mesh), positions_(mesh.vert.size()), parent_(mesh.vert.size()),
          moved_(mesh.vert.size(), 0)
    {
        std::iota(parent_.begin(), parent_.end(), 0U);
        const MeshArrays<Mesh> arrays(mesh);
        frame_ = FrameOf(arrays.View());
        for (std::size_t v = 0; v < positions_.size(); ++v)
            positions_[v] = frame_.Into<double>(arrays.View().Position(v));
        if (!function_.usesQuadric) return;
        quadrics_.resize(mesh.vert.size());
        RingEdges<Mesh> ring(mesh);
        for (VertexType& vertex : mesh.vert)
            if (!vertex.IsD()) InitialiseQuadric(vertex, ring);
    }

    bool IsDirected() const { return function_.isDirected; }

    bool IsFixed(const VertexType& vertex) const
    {
        return !parameters_.fixedVertices.empty() && parameters_.fixedVertices[IndexOf(&vertex)] != 0;
    }

    bool MayGo(const VertexType& removed, const VertexType& kept) const
    {
        return !IsFixed(removed) && (IsFeature(kept) || !IsFeature(removed));
    }

    /// Prices are computed when an entry comes up.
    static double Estimate(const VertexType&, const VertexType&) { return 0; }

    std::optional<CollapseAssessment> Assess(VertexType& removed, VertexType& kept)
    {
        Surround(removed, kept);
        const std::optional<CollapseError> error = function_.body(edge_);
        if (!error) return std::nullopt;
        const std::size_t from = IndexOf(&removed), into = IndexOf(&kept);
        const double l =
            edge_.keptStays ? DescriptorOf(from) : std::max(DescriptorOf(from), DescriptorOf(into));
        return CollapseAssessment{error->value * std::exp(parameters_.featureWeight * l),
                                  error->placement + positions_[from]};
    }

    bool IsLegal(VertexType& removed, VertexType& kept, const Vector3d&)
    {
        return legality_.StaysManifold(removed, kept);
    }
    static constexpr bool BeginLastResort() { return false; }

    CoordType Merge(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        const std::size_t from = IndexOf(&removed), into = IndexOf(&kept);
        const bool stays = KeptStays(removed, kept);
        const Vector3d position = stays ? positions_[into] : placement;
        parent_[from] = static_cast<std::uint32_t>(into);
        if (function_.usesQuadric)
            quadrics_[into] = Recentred(quadrics_[into], position - positions_[into]) +
                              Recentred(quadrics_[from], position - positions_[from]);
        if (stays) return kept.cP();
        if (!parameters_.descriptor.empty())
            parameters_.descriptor[into] = std::max(DescriptorOf(from), DescriptorOf(into));
        positions_[into] = position;
        moved_[into] = 1;
        return PointOf<CoordType>(Position(into));
    }

    void Refresh(VertexType&, const std::vector<RingEdge<Mesh>>&) {}

    /// As GuidedCollapse.
    std::size_t Root(std::size_t vertex)
    {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }
    bool HasMoved(std::size_t vertex) const { return moved_[vertex] != 0; }
    std::array<double, 3> Position(std::size_t vertex) const { return frame_.OutOf(positions_[vertex]); }
};

} // namespace vcg_ext
