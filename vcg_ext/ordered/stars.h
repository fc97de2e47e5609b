// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

/// Where l comes from.
struct Guidance {
    double featureWeight = 2;       ///< lambda >= 0, dimensionless
    std::vector<double> given;      ///< l in [0, 1], one a vertex; empty: of the Laplacian descriptor
    std::vector<double> descriptor; ///< that descriptor, where the triangles do not tell it; empty: they do
};

/// What the guided collapse knows of all vertices and faces, in the engine's frame, kept up to date over
/// collapses: the engine's records and the formulas that fill them, in double precision.
template <class Mesh>
class GuidedStars
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using Ring = std::vector<RingEdge<Mesh>>;
    using Corner = vcg::face::VFIterator<FaceType>;
    using End = EdgeEnd<double>;
    using Matrix = SymmetricMatrix3<double>;
    using Weight = Importance<double>;

    Mesh& mesh_;
    Frame frame_;
    bool bordersCount_;
    double lambda_ = 0;
    double descriptorScale_ = 0; ///< 1 / the descriptor that counts as 1; 0: the descriptor does not count
    std::vector<End> ends_;
    std::vector<double> descriptor_;      ///< l
    std::vector<Vector3d> scaledNormals_; ///< of the faces
    std::vector<std::uint8_t> atBorder_;  ///< has or had an edge with one face
    RingEdges<Mesh> ring_;

    std::size_t IndexOf(const VertexType* vertex) const { return vcg::tri::Index(mesh_, vertex); }
    const Vector3d& PositionOf(const VertexType* vertex) const { return ends_[IndexOf(vertex)].position; }
    const Vector3d& NormalOf(const FaceType* face) const
    {
        return scaledNormals_[vcg::tri::Index(mesh_, face)];
    }
    Weight ImportanceAt(std::size_t v) const { return {descriptor_[v], ends_[v].weight}; }

    void UpdateNormal(const FaceType& face)
    {
        scaledNormals_[vcg::tri::Index(mesh_, &face)] =
            ScaledNormal(PositionOf(face.cV(0)), PositionOf(face.cV(1)), PositionOf(face.cV(2)));
    }

    StarSums<double> SumStar(VertexType& vertex) const
    {
        StarSums<double> sums;
        const Vector3d& p = PositionOf(&vertex);
        for (Corner corner(&vertex); !corner.End(); ++corner)
            sums.Add(PositionOf(corner.V1()) - p, PositionOf(corner.V2()) - p, NormalOf(corner.F()));
        return sums;
    }

    /// Planes across the border's edges at \p vertex.
    Matrix BorderPlanes(const VertexType& vertex, const Ring& ring) const
    {
        Matrix planes{};
        for (const RingEdge<Mesh>& edge : ring)
            if (edge.faceCount == 1)
                planes = planes + PerpendicularPlane(NormalOf(edge.face),
                                                     PositionOf(edge.neighbour) - PositionOf(&vertex));
        return planes;
    }

    /// Of every face at \p vertex and the first of those that share its outgoing edge. \pre ring_ is
    /// collected
    Matrix CreasesOf(VertexType& vertex) const
    {
        CreasePlanes<double> creases;
        for (Corner corner(&vertex); !corner.End(); ++corner)
            if (const FaceType* other = ring_.Find(*corner.V1())->incoming)
                creases.Add(PositionOf(corner.V1()) - PositionOf(&vertex), NormalOf(corner.F()),
                            NormalOf(other));
        return creases.Sum();
    }

    /// C: planes of the faces and, on the border, across its edges.
    void RebuildStar(VertexType& vertex)
    {
        Matrix star{};
        for (Corner corner(&vertex); !corner.End(); ++corner)
            star = star + OuterProduct(NormalOf(corner.F()));
        const std::size_t v = IndexOf(&vertex);
        if (bordersCount_ && atBorder_[v] != 0) star = star + BorderPlanes(vertex, ring_.Collect(vertex));
        ends_[v].star = star;
    }

    /// Quadrics without weight, and the descriptor itself in place of l.
    void InitialiseVertex(VertexType& vertex)
    {
        const std::size_t v = IndexOf(&vertex);
        const Ring& ring = ring_.Collect(vertex);
        StarSums<double> sums = SumStar(vertex);
        if (!IsClosed(ring)) {
            sums.edges = {};
            sums.length = 0;
            for (const RingEdge<Mesh>& edge : ring)
                sums.AddEdge(PositionOf(edge.neighbour) - PositionOf(&vertex), 1.0);
        }
        atBorder_[v] = TouchesBorder(ring);
        ends_[v].weight = 1;
        ends_[v].star = sums.star;
        if (bordersCount_) ends_[v].star = ends_[v].star + BorderPlanes(vertex, ring);
        ends_[v].history = {ends_[v].star + CreasesOf(vertex), {}, 0};
        descriptor_[v] = StarDescriptor(sums);
    }

    void SetImportance(std::size_t v, const Weight& importance)
    {
        ends_[v].history = importance.weight / ends_[v].weight * ends_[v].history;
        ends_[v].weight = importance.weight;
        descriptor_[v] = importance.descriptor;
    }

    double ScaleOfDescriptor() const
    {
        std::vector<double> sample;
        for (std::size_t v = 0; v < descriptor_.size(); ++v)
            if (mesh_.vert[v].cVFp() != nullptr) sample.push_back(descriptor_[v]);
        return DescriptorScale(std::move(sample));
    }

    void Weigh(const Guidance& guidance)
    {
        lambda_ = guidance.featureWeight;
        if (!guidance.descriptor.empty()) descriptor_ = guidance.descriptor;
        if (guidance.given.empty()) descriptorScale_ = ScaleOfDescriptor();
        for (std::size_t v = 0; v < descriptor_.size(); ++v) {
            const double l = guidance.given.empty() ? descriptor_[v] * descriptorScale_ : guidance.given[v];
            SetImportance(v, ImportanceOf(std::clamp(l, 0.0, 1.0), lambda_));
        }
    }

  public:
    /// \pre vertex-face adjacency is up to date; \p mesh outlives the stars
    GuidedStars(Mesh& mesh, const Guidance& guidance, Boundary boundary)
        : mesh_(mesh), bordersCount_(boundary != Boundary::Free), ends_(mesh.vert.size()),
          descriptor_(mesh.vert.size(), 0), scaledNormals_(mesh.face.size()), atBorder_(mesh.vert.size(), 0),
          ring_(mesh)
    {
        const MeshArrays<Mesh> arrays(mesh);
        frame_ = FrameOf(arrays.View());
        for (std::size_t v = 0; v < ends_.size(); ++v)
            ends_[v].position = frame_.Into<double>(arrays.View().Position(v));
        for (const FaceType& face : mesh.face)
            if (!face.IsD()) UpdateNormal(face);
        for (VertexType& vertex : mesh.vert)
            if (!vertex.IsD()) InitialiseVertex(vertex);
        Weigh(guidance);
    }

    const Frame& frame() const { return frame_; }
    const End& end(std::size_t v) const { return ends_[v]; }
    double descriptor(std::size_t v) const { return descriptor_[v]; }
    double DoubleArea(const FaceType& face) const { return Dot(NormalOf(&face), NormalOf(&face)); }

    /// The faces that the collapse of the edge leaves, into \p faces, and what all of them span.
    StarAreas<double> Gather(VertexType& removed, VertexType& kept, std::vector<StarFace>& faces) const
    {
        StarAreas<double> areas;
        faces.clear();
        const auto add = [&](VertexType& end, const VertexType* other, Vector3d& area, bool countShared) {
            for (Corner corner(&end); !corner.End(); ++corner) {
                const Vector3d& normal = NormalOf(corner.F());
                if (corner.V1() == other || corner.V2() == other) {
                    if (countShared) areas.Add(normal, areas.edge);
                    continue;
                }
                areas.Add(normal, area);
                faces.push_back({PositionOf(corner.V1()), PositionOf(corner.V2()), normal,
                                 static_cast<std::uint32_t>(vcg::tri::Index(mesh_, corner.F()))});
            }
        };
        add(removed, &kept, areas.a, true);
        add(kept, &removed, areas.b, false);
        return areas;
    }

    /// Moves what is known of \p removed into \p kept, which goes to \p placement.
    void Merge(std::size_t removed, std::size_t kept, const Vector3d& placement)
    {
        End& into = ends_[kept];
        const Weight merged = MergedImportance(ImportanceAt(removed), ImportanceAt(kept), 0.0, lambda_);
        into.history = MergedHistory(ends_[removed], into, placement);
        into.weight = merged.weight;
        into.position = placement;
        descriptor_[kept] = merged.descriptor;
        atBorder_[kept] |= atBorder_[removed];
    }

    /// Brings normals, stars and importance around the survivor of a collapse up to date.
    void Refresh(VertexType& kept, const Ring& ring)
    {
        for (Corner corner(&kept); !corner.End(); ++corner) UpdateNormal(*corner.F());
        RebuildStar(kept);
        for (const RingEdge<Mesh>& edge : ring) RebuildStar(*edge.neighbour);
        if (!(descriptorScale_ > 0)) return;
        const double measured = std::min(1.0, StarDescriptor(SumStar(kept)) * descriptorScale_);
        const Weight own = ImportanceAt(IndexOf(&kept));
        SetImportance(IndexOf(&kept), MergedImportance(own, own, measured, lambda_));
    }
};

} // namespace vcg_ext
