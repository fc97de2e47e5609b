// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "vcg_ext/ordered/frame.h"
#include "vcg_ext/ordered/ring.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/quadric.h"
#include "vcg_ext/ordered/star_face.h"

namespace vcg_ext
{

/// What the guided collapse keeps of a vertex.
struct GuidedVertex {
    vcg::Point3d position{0, 0, 0}; ///< in the frame
    double descriptor = 0;          ///< l
    double weight = 1;              ///< w
    SymmetricMatrix star; ///< C, about the vertex itself: every plane of it passes through the vertex
    Quadric accumulated;  ///< A, about the vertex, times w
};

/// Sums over the faces around an edge, of n·p and of n, 2 area long each: where the volume stays the same.
struct StarMoments {
    vcg::Point3d normal{0, 0, 0};
    double offset = 0;
    double area = 0;
};

/// weight (normal·x - offset)²
struct VolumePlane {
    vcg::Point3d normal{0, 0, 0};
    double offset = 0;
    double weight = 0;
};

/// Positions, quadrics and face normals of all vertices, in the frame of the mesh, kept up to date over
/// collapses.
template <class Mesh>
class GuidedStars
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using Point = vcg::Point3d;
    using Ring = std::vector<RingEdge<Mesh>>;
    using Corner = vcg::face::VFIterator<FaceType>;

    struct FaceNormal {
        Point normal; ///< 2 area long
        double doubleArea;
    };

    /// Weight of planes across edges that turn by more than 30 degrees, against those of the border.
    static constexpr double kSharpEdgeWeight = .1;
    static constexpr double kSharpCosine = .86602540378443865;
    /// The same of edges that turn by more than 120 degrees, where a vertex has two: the tip of a thin part.
    /// The planes of its faces are all nearly the same there and do not know the outline.
    static constexpr double kTipWeight = .7;
    static constexpr double kFoldCosine = -.5;
    static constexpr int kFoldsAtATip = 2;

    Mesh& mesh_;
    CollapseFrame frame_;
    bool keepBorder_;
    std::vector<GuidedVertex> vertices_;
    std::vector<FaceNormal> faces_;
    std::vector<std::uint8_t> atBorder_; ///< has or had an edge with one face
    RingEdges<Mesh> ring_;

    std::size_t IndexOf(const VertexType* vertex) const { return vcg::tri::Index(mesh_, vertex); }
    const Point& PositionOf(const VertexType* vertex) const { return vertices_[IndexOf(vertex)].position; }
    const FaceNormal& NormalOf(const FaceType* face) const { return faces_[vcg::tri::Index(mesh_, face)]; }

    void UpdateNormal(FaceType& face)
    {
        const Point& p = PositionOf(face.cV(0));
        FaceNormal& stored = faces_[vcg::tri::Index(mesh_, &face)];
        stored.normal = (PositionOf(face.cV(1)) - p) ^ (PositionOf(face.cV(2)) - p);
        stored.doubleArea = stored.normal.Norm();
    }

    /// Adds the plane through the edge, perpendicular to \p face, weighted by the squared edge length.
    void AddPlaneAcross(SymmetricMatrix& quadric, const VertexType* a, const VertexType* b,
                        const FaceType* face, double weight) const
    {
        const FaceNormal& normal = NormalOf(face);
        const Point edge = PositionOf(b) - PositionOf(a);
        if (normal.doubleArea > 0) quadric.AddOuter((normal.normal ^ edge) / normal.doubleArea, weight);
    }

    /// Do the two faces of the edge turn by more than the angle of that cosine?
    bool IsSharp(const RingEdge<Mesh>& edge, double cosine) const
    {
        if (edge.faceCount != 2) return false;
        const FaceNormal& a = NormalOf(edge.faces[0]);
        const FaceNormal& b = NormalOf(edge.faces[1]);
        return a.normal.dot(b.normal) < cosine * a.doubleArea * b.doubleArea;
    }

    /// Planes across both faces of all sharp edges at \p vertex.
    SymmetricMatrix SharpPlanes(const VertexType& vertex, const Ring& ring) const
    {
        SymmetricMatrix creases, folded;
        int folds = 0;
        for (const RingEdge<Mesh>& edge : ring) {
            if (!IsSharp(edge, kSharpCosine)) continue;
            const bool fold = IsSharp(edge, kFoldCosine);
            folds += fold;
            for (const FaceType* face : edge.faces)
                AddPlaneAcross(fold ? folded : creases, &vertex, edge.neighbour, face, 1);
        }
        SymmetricMatrix planes;
        planes.Add(creases, kSharpEdgeWeight);
        planes.Add(folded, folds < kFoldsAtATip ? kSharpEdgeWeight : kTipWeight);
        return planes;
    }

    /// C: planes of the faces and, on the border, across its edges.
    void RebuildStar(VertexType& vertex)
    {
        SymmetricMatrix star;
        for (Corner corner(&vertex); !corner.End(); ++corner) {
            const FaceNormal& face = NormalOf(corner.F());
            if (face.doubleArea > 0) star.AddOuter(face.normal, 1 / face.doubleArea);
        }
        const std::size_t v = IndexOf(&vertex);
        if (keepBorder_ && atBorder_[v] != 0)
            for (const RingEdge<Mesh>& edge : ring_.Collect(vertex))
                if (edge.faceCount == 1) AddPlaneAcross(star, &vertex, edge.neighbour, edge.faces[0], 1);
        vertices_[v].star = star;
    }

    void InitialiseVertex(VertexType& vertex)
    {
        const std::size_t v = IndexOf(&vertex);
        const Ring& ring = ring_.Collect(vertex);
        atBorder_[v] = TouchesBorder<Mesh>(ring);
        const SymmetricMatrix sharp = SharpPlanes(vertex, ring);
        RebuildStar(vertex);
        vertices_[v].accumulated.a = vertices_[v].star;
        vertices_[v].accumulated.a.Add(sharp, 1);
    }

  public:
    /// \pre vertex-face adjacency is up to date; \p mesh outlives the stars
    GuidedStars(Mesh& mesh, Boundary boundary)
        : mesh_(mesh), frame_(mesh), keepBorder_(boundary != Boundary::Free), vertices_(mesh.vert.size()),
          faces_(mesh.face.size()), atBorder_(mesh.vert.size(), 0), ring_(mesh)
    {
        for (std::size_t v = 0; v < vertices_.size(); ++v)
            if (!mesh.vert[v].IsD()) vertices_[v].position = frame_.Into(Point::Construct(mesh.vert[v].cP()));
        for (FaceType& face : mesh.face)
            if (!face.IsD()) UpdateNormal(face);
        for (VertexType& vertex : mesh.vert)
            if (!vertex.IsD()) InitialiseVertex(vertex);
    }

    const CollapseFrame& frame() const { return frame_; }
    const GuidedVertex& vertex(std::size_t v) const { return vertices_[v]; }

    double DoubleArea(const FaceType& face) const { return NormalOf(&face).doubleArea; }

    /// Sets l, w = e^{lambda l} and multiplies A by w. \param descriptor one a vertex, empty: 0
    void Weigh(const std::vector<double>& descriptor, double lambda)
    {
        for (std::size_t v = 0; v < descriptor.size(); ++v) {
            vertices_[v].descriptor = descriptor[v];
            vertices_[v].weight = std::exp(lambda * descriptor[v]);
            vertices_[v].accumulated.Scale(vertices_[v].weight);
        }
    }

    /// The faces that the collapse of the edge leaves, into \p faces, and the sums over all faces around it;
    /// points count from \p origin.
    StarMoments Gather(VertexType& removed, VertexType& kept, const Point& origin,
                       std::vector<StarFace>& faces) const
    {
        StarMoments moments;
        faces.clear();
        const auto Add = [&](const Corner& corner, const VertexType* other, bool countShared) {
            const bool shared = corner.V1() == other || corner.V2() == other;
            if (shared && !countShared) return;
            const FaceNormal& face = NormalOf(corner.f);
            const Point next = PositionOf(corner.V1()) - origin;
            moments.normal += face.normal;
            moments.offset += face.normal.dot(next);
            moments.area += face.doubleArea;
            if (!shared)
                faces.push_back({next, PositionOf(corner.V2()) - origin, face.normal, face.doubleArea,
                                 static_cast<std::uint32_t>(vcg::tri::Index(mesh_, corner.f))});
        };
        for (Corner corner(&removed); !corner.End(); ++corner) Add(corner, &kept, true);
        for (Corner corner(&kept); !corner.End(); ++corner) Add(corner, &removed, false);
        return moments;
    }

    /// Moves what is known of \p removed into \p kept, which goes to \p placement.
    void Merge(std::size_t removed, std::size_t kept, const Point& placement)
    {
        const GuidedVertex& from = vertices_[removed];
        GuidedVertex& into = vertices_[kept];
        into.accumulated = into.accumulated.CountedFrom(placement - into.position);
        into.accumulated.Add(from.accumulated.CountedFrom(placement - from.position));
        into.descriptor = std::max(into.descriptor, from.descriptor);
        into.weight = std::max(into.weight, from.weight);
        into.position = placement;
        atBorder_[kept] |= atBorder_[removed];
    }

    /// Brings normals and stars around the survivor of a collapse up to date.
    void Refresh(VertexType& kept, const Ring& ring)
    {
        for (Corner corner(&kept); !corner.End(); ++corner) UpdateNormal(*corner.F());
        RebuildStar(kept);
        for (const RingEdge<Mesh>& edge : ring) RebuildStar(*edge.neighbour);
    }

    /// The ratchet: where \p descriptor is above the vertex's own, w and A rise with it.
    void RaiseDescriptor(std::size_t v, double descriptor, double lambda)
    {
        GuidedVertex& vertex = vertices_[v];
        if (!(descriptor > vertex.descriptor)) return;
        const double rise = std::exp(lambda * (descriptor - vertex.descriptor));
        vertex.descriptor = descriptor;
        vertex.weight *= rise;
        vertex.accumulated.Scale(rise);
    }

    /// Eq. 5 at one vertex: |sum of the edges·normal| / sum of their lengths, the normal weighted by angles.
    double LaplacianDescriptor(VertexType& vertex, const Ring& ring) const
    {
        const Point& p = PositionOf(&vertex);
        Point sum(0, 0, 0), normal(0, 0, 0);
        double length = 0;
        for (const RingEdge<Mesh>& edge : ring) {
            const Point e = PositionOf(edge.neighbour) - p;
            sum += e;
            length += e.Norm();
        }
        for (Corner corner(&vertex); !corner.End(); ++corner) {
            const FaceNormal& face = NormalOf(corner.F());
            if (!(face.doubleArea > 0)) continue;
            const double cosine = (PositionOf(corner.V1()) - p).dot(PositionOf(corner.V2()) - p);
            normal += face.normal * (std::atan2(face.doubleArea, cosine) / face.doubleArea);
        }
        const double norm = normal.Norm();
        return norm > 0 && length > 0 ? std::abs(sum.dot(normal)) / (norm * length) : 0;
    }
};

} // namespace vcg_ext
