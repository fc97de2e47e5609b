// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/edge_flip.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/repair/local_energy.h"
#include "vcg_ext/core/repair/local_samples.h"

namespace vcg_ext
{

/// A face is folded where the original faces the other way at the point that is closest to the face's
/// centroid. Faces without area have no side.
/// \param onSurface a point of the original where it does not face away from the face, if one is known
inline bool IsFolded(const FaceTree& original, const PlacedTriangle& face,
                     const std::optional<Vector3<float>>& onSurface = {})
{
    if (!(face.shape.doubleArea > 0)) return false;
    const Vector3<float> centroid = face.origin + (1.0F / 3) * (face.ToSecond() + face.ToThird());
    if (!onSurface) return original.FacesAwayFrom(centroid, NormalOf(face.shape));
    return original.FacesAwayFrom(centroid, NormalOf(face.shape), SquaredNorm(*onSurface - centroid));
}

/// Repairs folded faces of a simplified surface, each by the edge flip or the move of one of its vertices
/// that leaves fewer of them and changes the distances between the surfaces most favourably.
class FoldRepair
{
    /// A flip or a move, and what it does.
    struct Change {
        int repaired = 0; ///< how many fewer faces are folded
        float rise = 0;   ///< of the energy
        std::optional<FlippableEdge> flip;
        std::uint32_t vertex = 0; ///< that moves, where nothing is flipped ...
        Vector3<float> place{};   ///< ... to this point
    };
    /// Of the faces that a change replaces, or puts in their place.
    struct Condition {
        int folded = 0;
        float quality = 1; ///< of the worst
    };
    /// What a change starts from.
    struct Start {
        Condition condition;
        float energy = 0;
        float rounding = 0; ///< a rise of the energy by so much says nothing
    };

    static constexpr float kMinQuality = 0.02F; ///< a worse triangle only where a worse one was before
    static constexpr float kNoLimit = std::numeric_limits<float>::max();

    const FaceTree& original_;
    SurfaceArrays& surface_;
    LocalEnergy energy_;
    std::vector<std::uint32_t> star_;    ///< faces
    std::vector<PlacedTriangle> placed_; ///< the faces that a change replaces, or puts in their place
    std::vector<Vector3<float>> places_;
    std::vector<std::uint32_t> next_, previous_;

  public:
    /// \param simplified of the surface's faces, which have not changed yet
    FoldRepair(const FaceTree& original, const FaceTree& simplified, SurfaceArrays& surface)
        : original_(original), surface_(surface), energy_(original, simplified, surface)
    {
    }

    /// All faces that are not as they were at the start, in ascending order.
    const std::vector<std::uint32_t>& Changed() const { return energy_.Changed(); }

    bool IsFoldedNow(std::uint32_t face) const
    {
        return IsFolded(original_, Placed(surface_, surface_.triangles[face]));
    }

    /// Repairs \p face if that can be done.
    /// \param tolerance the energy of what changes may rise by this factor
    /// \param bordersMove vertices on borders may move too
    void Repair(std::uint32_t face, float tolerance, bool bordersMove)
    {
        if (!IsFoldedNow(face)) return;
        energy_.Center(face);
        std::optional<Change> best;
        if (!TryFlips(face, tolerance, best)) TryMoves(face, tolerance, bordersMove, best);
        if (best) Apply(*best);
    }

  private:
    /// Of placed_. \param enough where so many faces are folded, there is no need to look further
    /// \return nothing where a face has no area
    std::optional<Condition> ConditionOfPlaced(int enough) const
    {
        Condition condition;
        for (const PlacedTriangle& face : placed_) {
            if (!(face.shape.doubleArea > 0)) return std::nullopt;
            condition.quality = std::min(condition.quality, face.shape.quality);
        }
        for (const PlacedTriangle& face : placed_)
            if (IsFolded(original_, face) && ++condition.folded >= enough) break;
        return condition;
    }

    /// \pre placed_ holds the old faces, the energy has been told of them
    Start Begin() const
    {
        Start start;
        for (const PlacedTriangle& face : placed_) {
            start.condition.folded += IsFolded(original_, face);
            start.condition.quality = std::min(start.condition.quality, face.shape.quality);
            start.rounding += face.shape.doubleArea / 2 * FaceTree::kOnSurface2;
        }
        start.energy = energy_.Of(placed_, kNoLimit);
        return start;
    }

    /// Makes \p change, of which placed_ holds the new faces, the best one if it is.
    /// \return it is good enough to look no further: no face that it puts in place is folded, and the energy
    /// has not risen but for rounding
    bool Offer(Change change, const Start& start, float tolerance, std::optional<Change>& best) const
    {
        const auto condition = ConditionOfPlaced(start.condition.folded);
        if (!condition || condition->folded >= start.condition.folded ||
            condition->quality < std::min(start.condition.quality, kMinQuality))
            return false;
        change.repaired = start.condition.folded - condition->folded;
        if (best && best->repaired > change.repaired) return false;
        const bool tie = best && best->repaired == change.repaired;
        const float allowed = tolerance * start.energy + start.rounding;
        const float limit = tie ? std::min(allowed, start.energy + best->rise) : allowed;
        const float energy = energy_.Of(placed_, limit);
        if (!(energy <= limit) || (tie && energy - start.energy >= best->rise)) return false;
        change.rise = energy - start.energy;
        best = change;
        return condition->folded == 0 && change.rise <= start.rounding;
    }

    /// Offers every flip, until one cannot be beaten. \return whether one cannot
    bool TryFlips(std::uint32_t face, float tolerance, std::optional<Change>& best)
    {
        const SurfaceTriangle t = surface_.triangles[face];
        for (int k = 0; k < 3; ++k) {
            const auto edge = FindFlippableEdge(surface_, t.v[k], t.v[kNextIndex[k]]);
            if (!edge || AreNeighbours(surface_, edge->c, edge->d)) continue;
            energy_.LetChange({edge->First(), edge->Second()});
            placed_ = {Placed(surface_, surface_.triangles[edge->First()]),
                       Placed(surface_, surface_.triangles[edge->Second()])};
            const Start start = Begin();
            placed_ = {Placed(surface_, {{edge->a, edge->d, edge->c}}),
                       Placed(surface_, {{edge->b, edge->c, edge->d}})};
            Change change;
            change.flip = edge;
            if (Offer(change, start, tolerance, best)) return true;
        }
        return false;
    }

    /// Offers moves of the face's vertices, until one cannot be beaten.
    void TryMoves(std::uint32_t face, float tolerance, bool bordersMove, std::optional<Change>& best)
    {
        const SurfaceTriangle t = surface_.triangles[face];
        for (const std::uint32_t v : t.v) {
            if (surface_.flags[v] & (kFixedVertex | kSeamCorner)) continue;
            if (!bordersMove && !HasClosedStar(surface_, v, next_, previous_)) continue;
            star_ = {face}; // first, because it decides most often
            ForEachFaceAround(surface_, v, [&](std::uint32_t f) {
                if (f != face) star_.push_back(f);
            });
            energy_.LetChange(star_);
            PlaceStar();
            const Start start = Begin();
            const Vector3<float> here = PositionOf(surface_, v);
            FindPlaces(face, v);
            bool unbeaten = false;
            for (std::size_t i = 0; i < places_.size() && !unbeaten; ++i) {
                Put(v, places_[i]);
                PlaceStar();
                Change change;
                change.vertex = v;
                change.place = places_[i];
                unbeaten = Offer(change, start, tolerance, best);
            }
            Put(v, here);
            if (unbeaten) return;
        }
    }
    void PlaceStar()
    {
        placed_.clear();
        for (const std::uint32_t f : star_) placed_.push_back(Placed(surface_, surface_.triangles[f]));
    }
    void Put(std::uint32_t v, const Vector3<float>& p)
    {
        SurfacePoint& point = surface_.points[v];
        point = {p.x, p.y, p.z, point.weight};
    }

    /// Where \p v might go to repair \p face: away from the side that is too close, across the opposite edge,
    /// or towards the middle of its neighbours, there or on the original.
    void FindPlaces(std::uint32_t face, std::uint32_t v)
    {
        const Vector3<float> here = PositionOf(surface_, v);
        places_.clear();
        AddPlacesAlongNormals(face, v, here);

        const SurfaceTriangle& t = surface_.triangles[face];
        int k = 0;
        while (t.v[k] != v) ++k;
        const Vector3<float> p = PositionOf(surface_, t.v[kNextIndex[k]]);
        const Vector3<float> edge = PositionOf(surface_, t.v[kPreviousIndex[k]]) - p;
        const float along = Dot(here - p, edge) / std::max(SquaredNorm(edge), kSmallestSquare);
        const Vector3<float> toEdge = p + along * edge - here;
        for (const float s : {1.2F, 1.5F, 2.0F, 4.0F}) places_.push_back(here + s * toEdge);

        Vector3<float> middle{};
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c)
            middle = middle + PositionOf(surface_, NextVertex(surface_, *c));
        middle = (1 / static_cast<float>(surface_.cornerCount[v])) * middle;
        for (const float s : {0.1F, 0.2F, 0.4F, 0.7F, 1.0F}) {
            places_.push_back(here + s * (middle - here));
            places_.push_back(original_.Closest(places_.back()));
        }
    }
    /// Of the face and of the star, by parts of the distance to where the original faces along the face.
    void AddPlacesAlongNormals(std::uint32_t face, std::uint32_t v, const Vector3<float>& here)
    {
        const Vector3<float> normal = NormalOf(Placed(surface_, surface_.triangles[face]).shape);
        const float reach2 = original_.DistanceAlong2(Centroid(surface_, face), normal);
        if (!(reach2 < kNoLimit)) return;
        Vector3<float> star{};
        ForEachFaceAround(surface_, v, [&](std::uint32_t f) { star = star + AreaVector(surface_, f); });
        star = (1 / std::max(Norm(star), std::sqrt(kSmallestSquare))) * star;
        for (const float s : {0.1F, 0.2F, 0.4F, 0.7F, 1.0F, 1.5F, 2.0F, 3.0F})
            for (const Vector3<float>& step : {normal, star, -1.0F * star})
                places_.push_back(here + (s * std::sqrt(reach2)) * step);
    }

    void Apply(const Change& change)
    {
        if (change.flip) {
            FlipEdge(surface_, *change.flip);
            energy_.MarkChanged(change.flip->First());
            energy_.MarkChanged(change.flip->Second());
            return;
        }
        Put(change.vertex, change.place);
        std::uint8_t& flags = surface_.flags[change.vertex];
        flags = static_cast<std::uint8_t>(flags | kMovedVertex);
        ForEachFaceAround(surface_, change.vertex, [&](std::uint32_t f) { energy_.MarkChanged(f); });
    }
};

} // namespace vcg_ext
