// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

/// Says which edges may be collapsed without spoiling the topology.
///
/// Reads vertex-face adjacency only; the input may be of any kind, non-manifold edges and all.
template <class Mesh>
class CollapseLegality
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using Edge = RingEdge<Mesh>;
    using OppositeEdge = std::pair<VertexType*, VertexType*>;

    RingEdges<Mesh> removedRing_, keptRing_;
    std::vector<VertexType*> apexes_; ///< third vertices of the faces on the edge
    std::vector<OppositeEdge> removedLink_;
    bool closesHoles_ = false;
    const VertexType* hole_ = nullptr; ///< the third corner of the hole that the collapse would close

    /// Collects both rings and the apexes. \return the edge that joins the two, null where none does
    const Edge* Collect(VertexType& removed, VertexType& kept)
    {
        removedRing_.Collect(removed);
        keptRing_.Collect(kept);
        apexes_.clear();
        for (vcg::face::VFIterator<FaceType> corner(&removed); !corner.End(); ++corner) {
            if (corner.V1() == &kept) apexes_.push_back(corner.V2());
            if (corner.V2() == &kept) apexes_.push_back(corner.V1());
        }
        return removedRing_.Find(kept);
    }

    static bool HasOneFace(VertexType& vertex)
    {
        vcg::face::VFIterator<FaceType> corner(&vertex);
        ++corner;
        return corner.End();
    }

    /// Is \p edge, of the ring of the one that stays, a side of a hole with three sides that a collapse of
    /// the side \p joining would close?
    bool ClosesHole(const Edge& joining, const Edge& edge) const
    {
        const Edge* other = removedRing_.Find(*edge.neighbour);
        return joining.faceCount == 1 && edge.faceCount == 1 && other != nullptr && other->faceCount == 1 &&
               BoundaryDegree(keptRing_.edges()) == 2 && BoundaryDegree(removedRing_.edges()) == 2;
    }

    /// Both ends see no vertex but the third ones of the faces between them, and each of those once; and,
    /// where holes may be closed, the third corner of a hole.
    bool CommonNeighboursAreApexes(const Edge& joining)
    {
        std::size_t common = 0;
        hole_ = nullptr;
        for (const Edge& edge : keptRing_.edges()) {
            if (closesHoles_ && ClosesHole(joining, edge))
                hole_ = edge.neighbour;
            else if (removedRing_.Find(*edge.neighbour))
                ++common;
        }
        if (common != apexes_.size()) return false;
        for (std::size_t i = 0; i < apexes_.size(); ++i)
            if (std::find(apexes_.begin(), apexes_.begin() + static_cast<std::ptrdiff_t>(i), apexes_[i]) !=
                apexes_.begin() + static_cast<std::ptrdiff_t>(i))
                return false;
        return true;
    }

    /// The edge opposite to a corner where both its vertices will be joined to the survivor from both sides,
    /// in an order of its own.
    template <class Corner>
    bool LinksApexes(const Corner& corner, OppositeEdge& opposite) const
    {
        const auto isShared = [&](VertexType* v) {
            return v == hole_ || std::find(apexes_.begin(), apexes_.end(), v) != apexes_.end();
        };
        if (!isShared(corner.V1()) || !isShared(corner.V2())) return false;
        opposite = std::minmax(corner.V1(), corner.V2());
        return true;
    }

    /// A face of either end has the same two other vertices, so both would become the same face.
    bool MakesDuplicateFace(VertexType& removed, VertexType& kept)
    {
        if (apexes_.size() + (hole_ != nullptr ? 1 : 0) < 2) return false;
        removedLink_.clear();
        OppositeEdge opposite;
        for (vcg::face::VFIterator<FaceType> corner(&removed); !corner.End(); ++corner)
            if (LinksApexes(corner, opposite)) removedLink_.push_back(opposite);
        if (removedLink_.empty()) return false;
        for (vcg::face::VFIterator<FaceType> corner(&kept); !corner.End(); ++corner)
            if (LinksApexes(corner, opposite) &&
                std::find(removedLink_.begin(), removedLink_.end(), opposite) != removedLink_.end())
                return true;
        return false;
    }

    /// A vertex of the ring, or the survivor, would be left without a face.
    bool LeavesIsolatedVertex(VertexType& removed, VertexType& kept) const
    {
        if (FaceCount(removed) == apexes_.size() && FaceCount(kept) == apexes_.size()) return true;
        for (VertexType* apex : apexes_)
            if (HasOneFace(*apex)) return true;
        return false;
    }

    static std::size_t FaceCount(VertexType& vertex)
    {
        std::size_t count = 0;
        for (vcg::face::VFIterator<FaceType> corner(&vertex); !corner.End(); ++corner) ++count;
        return count;
    }

    static int BoundaryDegree(const std::vector<Edge>& ring)
    {
        return static_cast<int>(
            std::count_if(ring.begin(), ring.end(), [](const Edge& edge) { return edge.faceCount != 2; }));
    }

  public:
    explicit CollapseLegality(const Mesh& mesh) : removedRing_(mesh), keptRing_(mesh) {}

    /// From now on holes with three sides may be closed. \return false if they might before
    bool LetHolesClose() { return !std::exchange(closesHoles_, true); }

    /// Whether the collapse of \p removed into \p kept makes no non-manifold edge or vertex, no duplicate
    /// face and no vertex without faces that was not there before.
    bool StaysManifold(VertexType& removed, VertexType& kept)
    {
        const Edge* edge = Collect(removed, kept);
        if (edge == nullptr || !CommonNeighboursAreApexes(*edge)) return false;
        if (edge->faceCount != 1 && TouchesBorder(removedRing_.edges()) && TouchesBorder(keptRing_.edges()))
            return false;
        return !MakesDuplicateFace(removed, kept) && !LeavesIsolatedVertex(removed, kept);
    }

    /// The link condition of Dey, Edelsbrunner, Guha and Nekhayev (1999) for two-dimensional complexes,
    /// borders and non-manifold edges included: the result is homeomorphic to the mesh before.
    /// \pre StaysManifold was true for the same pair just before
    bool MeetsLinkCondition(VertexType& kept) const
    {
        const Edge& edge = *removedRing_.Find(kept);
        const int removedDegree = BoundaryDegree(removedRing_.edges());
        const int keptDegree = BoundaryDegree(keptRing_.edges());
        // The cone vertex over all boundary edges is in both links, so it has to be in that of the edge.
        if (removedDegree > 0 && keptDegree > 0 && edge.faceCount == 2) return false;
        // The cone vertex over all ends and crossings of boundary curves must not be in both links.
        const bool bothEndCurves =
            removedDegree > 0 && removedDegree != 2 && keptDegree > 0 && keptDegree != 2;
        if (bothEndCurves) return false;
        // Boundary edges from both ends must not meet.
        for (const Edge& other : keptRing_.edges()) {
            const Edge* opposite = removedRing_.Find(*other.neighbour);
            if (other.faceCount != 2 && opposite != nullptr && opposite->faceCount != 2) return false;
        }
        return true;
    }
};

} // namespace vcg_ext
