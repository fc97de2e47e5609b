// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/core/collapse/cost.h"
#include "vcg_ext/core/geometry/frame.h"

namespace vcg_ext
{

using Vector3d = Vector3<double>;

/// An edge at a vertex and the faces on it.
template <class Mesh>
struct RingEdge {
    using FaceType = typename Mesh::FaceType;
    typename Mesh::VertexType* neighbour;
    FaceType* face = nullptr; ///< one of them
    FaceType* incoming =
        nullptr;       ///< the first in the mesh that runs along the edge towards the vertex, or null
    int faceCount = 0; ///< 1 on the border, 2 inside, more where the mesh is not a manifold
    int balance = 0;   ///< faces that run along it away from the vertex, less those towards it
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

    RingEdge<Mesh>& EdgeTo(VertexType* neighbour)
    {
        if (const RingEdge<Mesh>* known = Find(*neighbour))
            return edges_[static_cast<std::size_t>(known - edges_.data())];
        slot_[vcg::tri::Index(mesh_, neighbour)] = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back({neighbour});
        return edges_.back();
    }
    RingEdge<Mesh>& Add(VertexType* neighbour, FaceType* face, int direction)
    {
        RingEdge<Mesh>& edge = EdgeTo(neighbour);
        edge.face = face;
        edge.balance += direction;
        ++edge.faceCount;
        return edge;
    }

  public:
    explicit RingEdges(const Mesh& mesh) : mesh_(mesh), slot_(mesh.vert.size(), 0) {}

    /// The edges at \p vertex; valid until the next call. \pre vertex-face adjacency is up to date
    const std::vector<RingEdge<Mesh>>& Collect(VertexType& vertex)
    {
        edges_.clear();
        for (vcg::face::VFIterator<FaceType> corner(&vertex); !corner.End(); ++corner) {
            Add(corner.V1(), corner.F(), 1);
            RingEdge<Mesh>& edge = Add(corner.V2(), corner.F(), -1);
            if (edge.incoming == nullptr || corner.F() < edge.incoming) edge.incoming = corner.F();
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

/// A face that outlives a collapse, seen from the corner that moves.
struct StarFace {
    Vector3d next, previous; ///< the other corners
    Vector3d scaledNormal;   ///< of ScaledNormal, before the collapse
    std::uint32_t face;      ///< its index in the mesh
};

/// The height over its longest side below which a face has no area, in the engine's frame: a corner that is
/// put onto that side misses it by some 1e-13, by rounding.
constexpr double kNoHeight = 1e-10;

/// Whether a face that had an area, its m = \p before, has none any more.
inline bool LosesArea(const MovedFace<double>& moved, const Vector3d& before)
{
    const double height2 = std::sqrt(moved.normal2 * moved.quality2);
    return height2 <= kNoHeight * kNoHeight && Dot(before, before) > kNoHeight * kFrameDiagonal;
}

/// The squared quality of the worst of \p faces when their moving corner is at \p x, DBL_MAX where there is
/// none; nothing where one of them turns too far or loses its area.
inline std::optional<double> WorstQuality2(const std::vector<StarFace>& faces, const Vector3d& x)
{
    double worst2 = DBL_MAX;
    for (const StarFace& face : faces) {
        const auto moved = MoveFace(face.next - x, face.previous - x);
        if (TurnedTooFar(moved, face.scaledNormal) || LosesArea(moved, face.scaledNormal))
            return std::nullopt;
        worst2 = std::min(worst2, moved.quality2);
    }
    return worst2;
}

/// Whether the faces at a vertex close up around it: as many run along every edge one way as the other.
template <class Mesh>
bool IsClosed(const std::vector<RingEdge<Mesh>>& edges)
{
    for (const RingEdge<Mesh>& edge : edges)
        if (edge.balance != 0) return false;
    return true;
}

/// Whether a list of edges at a vertex has one with a single face.
template <class Mesh>
bool TouchesBorder(const std::vector<RingEdge<Mesh>>& edges)
{
    for (const RingEdge<Mesh>& edge : edges)
        if (edge.faceCount == 1) return true;
    return false;
}

} // namespace vcg_ext
