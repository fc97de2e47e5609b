// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <vcg/complex/complex.h>

namespace vcg_ext
{

/// An edge at a vertex and the faces on it.
template <class Mesh>
struct RingEdge {
    typename Mesh::VertexType* neighbour;
    typename Mesh::FaceType* faces[2]; ///< the first two of them; null where there are fewer
    int faceCount;                     ///< 1 on the border, 2 inside, more where the mesh is not a manifold
};

/// Lists the edges at one vertex after the other by vertex-face adjacency, each neighbour once.
///
/// Holds one number for every vertex of the mesh, so that a list takes time in proportion to its length
/// however many faces meet at the vertex.
template <class Mesh>
class RingEdges
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;

    const Mesh& mesh_;
    std::vector<std::uint32_t> slot_; ///< where the vertex would be in edges_
    std::vector<RingEdge<Mesh>> edges_;

    void Add(VertexType* neighbour, FaceType* face)
    {
        if (const RingEdge<Mesh>* known = Find(*neighbour)) {
            RingEdge<Mesh>& edge = edges_[static_cast<std::size_t>(known - edges_.data())];
            if (edge.faceCount == 1) edge.faces[1] = face;
            ++edge.faceCount;
            return;
        }
        slot_[vcg::tri::Index(mesh_, neighbour)] = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back({neighbour, {face, nullptr}, 1});
    }

  public:
    explicit RingEdges(const Mesh& mesh) : mesh_(mesh), slot_(mesh.vert.size(), 0) {}

    /// The edges at \p vertex; valid until the next call. \pre vertex-face adjacency is up to date
    const std::vector<RingEdge<Mesh>>& Collect(VertexType& vertex)
    {
        edges_.clear();
        for (vcg::face::VFIterator<FaceType> corner(&vertex); !corner.End(); ++corner) {
            Add(corner.V1(), corner.F());
            Add(corner.V2(), corner.F());
        }
        return edges_;
    }

    /// The edge from the vertex collected last to \p neighbour; null where there is none.
    const RingEdge<Mesh>* Find(const VertexType& neighbour) const
    {
        const std::uint32_t slot = slot_[vcg::tri::Index(mesh_, &neighbour)];
        return slot < edges_.size() && edges_[slot].neighbour == &neighbour ? &edges_[slot] : nullptr;
    }

    const std::vector<RingEdge<Mesh>>& edges() const { return edges_; }
};

/// Whether a list of edges at a vertex has one with a single face.
template <class Mesh>
bool TouchesBorder(const std::vector<RingEdge<Mesh>>& edges)
{
    for (const RingEdge<Mesh>& edge : edges)
        if (edge.faceCount == 1) return true;
    return false;
}

} // namespace vcg_ext
