// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/topology.h>

#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

namespace ordered_detail
{

class MeshVertex;
class MeshFace;
struct MeshTypes : vcg::UsedTypes<vcg::Use<MeshVertex>::AsVertexType, vcg::Use<MeshFace>::AsFaceType> {
};
class MeshVertex : public vcg::Vertex<MeshTypes, vcg::vertex::Coord3d, vcg::vertex::VFAdj, vcg::vertex::Mark,
                                      vcg::vertex::BitFlags>
{
};
class MeshFace : public vcg::Face<MeshTypes, vcg::face::VertexRef, vcg::face::VFAdj, vcg::face::BitFlags>
{
};

} // namespace ordered_detail

/// The mesh that the queue-ordered collapses work on: double precision and nothing but what they need.
class OrderedMesh
    : public vcg::tri::TriMesh<std::vector<ordered_detail::MeshVertex>, std::vector<ordered_detail::MeshFace>>
{
};

/// The outcome of DecimateOrdered and DecimateWeighted.
struct OrderedDecimation {
    DecimatedMesh mesh;
    /// For every input vertex the vertex of the result that it became part of; kNoVertex where it has no
    /// face.
    std::vector<std::uint32_t> root;
    /// l in [0, 1] of every input vertex, which has guided the collapse; empty after DecimateWeighted.
    std::vector<float> descriptor;
    static constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;
};

/// \p p as a point of VCG.
template <class CoordType>
CoordType PointOf(const std::array<double, 3>& p)
{
    using Scalar = typename CoordType::ScalarType;
    return CoordType(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2]));
}

/// A view as a mesh that can be collapsed, and the way back. \pre the view outlives it
class CollapsibleMesh
{
    const MeshView& view_;
    OrderedMesh mesh_;
    std::vector<std::uint32_t> faceOrigin_; ///< the view's face of every face

  public:
    /// All vertices of \p view; its faces that name a vertex twice are left out.
    explicit CollapsibleMesh(const MeshView& view) : view_(view)
    {
        auto vertex = vcg::tri::Allocator<OrderedMesh>::AddVertices(mesh_, view.vertexCount);
        for (std::size_t v = 0; v < view.vertexCount; ++v, ++vertex)
            vertex->P() = PointOf<vcg::Point3d>(view.Position(v));
        for (std::size_t f = 0; f < view.faceCount; ++f) {
            const std::uint32_t* v = view.triangles + 3 * f;
            if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
                faceOrigin_.push_back(static_cast<std::uint32_t>(f));
        }
        auto face = vcg::tri::Allocator<OrderedMesh>::AddFaces(mesh_, faceOrigin_.size());
        for (const std::uint32_t f : faceOrigin_) {
            for (int k = 0; k < 3; ++k)
                face->V(k) = &mesh_.vert[view.triangles[3 * f + static_cast<std::size_t>(k)]];
            ++face;
        }
        vcg::tri::UpdateTopology<OrderedMesh>::VertexFace(mesh_);
    }

    OrderedMesh& mesh() { return mesh_; }

    /// Vertices that must not move: those of the view and, where the border is locked, all on it or on other
    /// edges at which the faces do not close up.
    std::vector<std::uint8_t> FixedVertices(Boundary boundary)
    {
        std::vector<std::uint8_t> fixed;
        if (view_.fixedVertices != nullptr)
            fixed.assign(view_.fixedVertices, view_.fixedVertices + view_.vertexCount);
        if (boundary != Boundary::Lock) return fixed;
        fixed.resize(view_.vertexCount, 0);
        RingEdges<OrderedMesh> ring(mesh_);
        for (std::size_t v = 0; v < view_.vertexCount; ++v)
            if (!IsClosed(ring.Collect(mesh_.vert[v]))) fixed[v] = 1;
        return fixed;
    }

    /// What \p method has left, in input order.
    template <class Method>
    OrderedDecimation Result(Method& method, StopReason reason) const
    {
        OrderedDecimation result;
        result.mesh.stopReason = reason;
        const std::vector<std::uint32_t> place = CollectVertices(method, result.mesh);
        for (std::size_t f = 0; f < mesh_.face.size(); ++f) {
            if (mesh_.face[f].IsD()) continue;
            const auto corner = [&](int k) { return place[vcg::tri::Index(mesh_, mesh_.face[f].cV(k))]; };
            result.mesh.triangles.push_back({corner(0), corner(1), corner(2)});
            result.mesh.faceOrigin.push_back(faceOrigin_[f]);
        }
        result.root.resize(view_.vertexCount);
        for (std::size_t v = 0; v < view_.vertexCount; ++v) result.root[v] = place[method.Root(v)];
        return result;
    }

  private:
    /// \return where every vertex is in \p result
    template <class Method>
    std::vector<std::uint32_t> CollectVertices(const Method& method, DecimatedMesh& result) const
    {
        std::vector<std::uint32_t> place(view_.vertexCount, OrderedDecimation::kNoVertex);
        for (const auto& face : mesh_.face)
            for (int k = 0; k < 3 && !face.IsD(); ++k) place[vcg::tri::Index(mesh_, face.cV(k))] = 0;
        for (std::size_t v = 0; v < view_.vertexCount; ++v) {
            const bool fixed = view_.fixedVertices != nullptr && view_.fixedVertices[v] != 0;
            if (place[v] == OrderedDecimation::kNoVertex && !fixed) continue;
            place[v] = static_cast<std::uint32_t>(result.positions.size());
            result.positions.push_back(method.HasMoved(v) ? method.Position(v) : view_.Position(v));
            result.vertexOrigin.push_back(static_cast<std::uint32_t>(v));
        }
        return place;
    }
};

} // namespace vcg_ext
