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

/// Faces of a simplified surface as they are or would be.
struct FacesInPlace {
    std::vector<SurfaceTriangle> corners;
    std::vector<PlacedTriangle> placed;

    void Add(const SurfaceArrays& surface, const SurfaceTriangle& triangle)
    {
        corners.push_back(triangle);
        placed.push_back(Placed(surface, triangle));
    }
    void Clear()
    {
        corners.clear();
        placed.clear();
    }
};

/// Of these faces. \param enough where so many are folded, it may stop
inline int CountFolded(const FaceTree& original, const FacesInPlace& faces, int enough)
{
    int folded = 0;
    for (const PlacedTriangle& face : faces.placed)
        if (IsFolded(original, face) && ++folded >= enough) break;
    return folded;
}

/// Repairs what is wrong with faces of a simplified surface, each by the edge flip or the move of one of its
/// vertices that leaves fewer faults, no more folded faces, and changes the distances between the surfaces
/// most favourably.
///
/// Faults says what is wrong: FoldFaults or CrossingFaults. It offers
///
///   kAreFolds                   whether the faults are the folded faces
///   kMaxStar                    faces around a vertex that may move
///   Count(faces, enough)        faults of the FacesInPlace, or some number that is at least enough
///   LetChange(faces)            only these of the surface's faces are about to be replaced
///   Slack2(face)                the square of how far the repair of a face may take what is no error so far
///   AddPlaces(face, v, places)  where vertex v might go to repair the face
///   Keep(v), Put(v), PutBack(v) v is about to be tried elsewhere; it has moved; it is back
///   MarkChanged(face)           the face has changed for good
template <class Faults>
class LocalRepair
{
    /// A flip or a move, and what it does.
    struct Change {
        int repaired = 0; ///< how many fewer faults there are
        float rise = 0;   ///< of the energy
        std::optional<FlippableEdge> flip;
        std::uint32_t vertex = 0; ///< that moves, where nothing is flipped ...
        Vector3<float> place{};   ///< ... to this point
    };
    /// Of the faces that a change replaces, or puts in their place.
    struct Condition {
        int faults = 0, folded = 0;
        float quality = 1; ///< of the worst
    };
    /// What a change starts from.
    struct Start {
        Condition condition;
        float energy = 0;
        float rounding = 0; ///< a rise of the energy by so much says nothing
        float area = 0;
    };

    static constexpr float kMinQuality = 0.02F; ///< a worse triangle only where a worse one was before
    static constexpr float kNoLimit = std::numeric_limits<float>::max();
    static constexpr int kNoEnd = std::numeric_limits<int>::max();

    const FaceTree& original_;
    SurfaceArrays& surface_;
    Faults& faults_;
    LocalEnergy energy_;
    float slack2_ = 0;
    std::vector<std::uint32_t> star_; ///< faces
    FacesInPlace faces_;              ///< that a change replaces, or puts in their place
    std::vector<Vector3<float>> places_;
    std::vector<std::uint32_t> next_, previous_;

  public:
    /// \param simplified of the surface's faces, which have not changed yet
    LocalRepair(const FaceTree& original, const FaceTree& simplified, SurfaceArrays& surface, Faults& faults)
        : original_(original), surface_(surface), faults_(faults), energy_(original, simplified, surface)
    {
    }

    /// All faces that are not as they were at the start, in ascending order.
    const std::vector<std::uint32_t>& Changed() const { return energy_.Changed(); }

    bool IsFaulty(std::uint32_t face)
    {
        faults_.LetChange({face});
        faces_.Clear();
        faces_.Add(surface_, surface_.triangles[face]);
        return faults_.Count(faces_, 1) > 0;
    }

    /// Repairs \p face if that can be done.
    /// \param tolerance the energy of what changes may rise by this factor, and that of the slack counts, too
    /// \param bordersMove vertices on borders may move too
    /// \return how many fewer faults there are
    int Repair(std::uint32_t face, float tolerance, bool bordersMove)
    {
        if (!IsFaulty(face)) return 0;
        slack2_ = faults_.Slack2(face);
        energy_.Center(face);
        std::optional<Change> best;
        if (!TryFlips(face, tolerance, best)) TryMoves(face, tolerance, bordersMove, best);
        if (!best) return 0;
        Apply(*best);
        return best->repaired;
    }

  private:
    void LetChange(const std::vector<std::uint32_t>& faces)
    {
        energy_.LetChange(faces);
        faults_.LetChange(faces);
    }
    /// Of faces_, where it is better than at the start.
    std::optional<Condition> BetterCondition(const Condition& start) const
    {
        Condition condition;
        for (const PlacedTriangle& face : faces_.placed) {
            if (!(face.shape.doubleArea > 0)) return std::nullopt;
            condition.quality = std::min(condition.quality, face.shape.quality);
        }
        if (condition.quality < std::min(start.quality, kMinQuality)) return std::nullopt;
        condition.faults = faults_.Count(faces_, start.faults);
        if (condition.faults >= start.faults) return std::nullopt;
        if constexpr (!Faults::kAreFolds)
            if (CountFolded(original_, faces_, start.folded + 1) > start.folded) return std::nullopt;
        return condition;
    }

    /// \pre faces_ holds the old faces, energy and faults have been told of them
    Start Begin() const
    {
        Start start;
        start.condition.faults = faults_.Count(faces_, kNoEnd);
        if constexpr (!Faults::kAreFolds) start.condition.folded = CountFolded(original_, faces_, kNoEnd);
        for (const PlacedTriangle& face : faces_.placed) {
            start.condition.quality = std::min(start.condition.quality, face.shape.quality);
            start.rounding += face.shape.doubleArea / 2 * FaceTree::kOnSurface2;
            start.area += face.shape.doubleArea / 2;
        }
        start.energy = energy_.Of(faces_.placed, kNoLimit);
        return start;
    }

    /// Makes \p change, of which faces_ holds the new faces, the best one if it is.
    /// \return it is good enough to look no further: no fault is left, and the energy has not risen but for
    /// rounding
    bool Offer(Change change, const Start& start, float tolerance, std::optional<Change>& best) const
    {
        const auto condition = BetterCondition(start.condition);
        if (!condition) return false;
        change.repaired = start.condition.faults - condition->faults;
        if (best && best->repaired > change.repaired) return false;
        const bool tie = best && best->repaired == change.repaired;
        const float allowed =
            tolerance * start.energy + start.rounding + (tolerance - 1) * slack2_ * start.area;
        const float limit = tie ? std::min(allowed, start.energy + best->rise) : allowed;
        const float energy = energy_.Of(faces_.placed, limit);
        if (!(energy <= limit) || (tie && energy - start.energy >= best->rise)) return false;
        change.rise = energy - start.energy;
        best = change;
        return condition->faults == 0 && change.rise <= start.rounding;
    }

    /// Offers every flip, until one cannot be beaten. \return whether one cannot
    bool TryFlips(std::uint32_t face, float tolerance, std::optional<Change>& best)
    {
        const SurfaceTriangle t = surface_.triangles[face];
        for (int k = 0; k < 3; ++k) {
            const auto edge = FindFlippableEdge(surface_, t.v[k], t.v[kNextIndex[k]]);
            if (!edge || AreNeighbours(surface_, edge->c, edge->d)) continue;
            LetChange({edge->First(), edge->Second()});
            faces_.Clear();
            for (const std::uint32_t f : {edge->First(), edge->Second()})
                faces_.Add(surface_, surface_.triangles[f]);
            const Start start = Begin();
            faces_.Clear();
            faces_.Add(surface_, {{edge->a, edge->d, edge->c}});
            faces_.Add(surface_, {{edge->b, edge->c, edge->d}});
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
            if (surface_.cornerCount[v] > Faults::kMaxStar) continue;
            if (!bordersMove && !HasClosedStar(surface_, v, next_, previous_)) continue;
            star_ = {face}; // first, because it decides most often
            ForEachFaceAround(surface_, v, [&](std::uint32_t f) {
                if (f != face) star_.push_back(f);
            });
            LetChange(star_);
            PlaceStar();
            const Start start = Begin();
            const Vector3<float> here = PositionOf(surface_, v);
            FindPlaces(face, v);
            faults_.Keep(v);
            bool unbeaten = false;
            for (std::size_t i = 0; i < places_.size() && !unbeaten; ++i) {
                Put(v, places_[i]);
                faults_.Put(v);
                PlaceStar();
                Change change;
                change.vertex = v;
                change.place = places_[i];
                unbeaten = Offer(change, start, tolerance, best);
            }
            Put(v, here);
            faults_.PutBack(v);
            if (unbeaten) return;
        }
    }
    void PlaceStar()
    {
        faces_.Clear();
        for (const std::uint32_t f : star_) faces_.Add(surface_, surface_.triangles[f]);
    }
    void Put(std::uint32_t v, const Vector3<float>& p)
    {
        SurfacePoint& point = surface_.points[v];
        point = {p.x, p.y, p.z, point.weight};
    }

    /// Where \p v might go to repair \p face: where the faults say, or towards the middle of its neighbours,
    /// there or on the original.
    void FindPlaces(std::uint32_t face, std::uint32_t v)
    {
        const Vector3<float> here = PositionOf(surface_, v);
        places_.clear();
        faults_.AddPlaces(face, v, places_);
        Vector3<float> middle{};
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c)
            middle = middle + PositionOf(surface_, NextVertex(surface_, *c));
        middle = (1 / static_cast<float>(surface_.cornerCount[v])) * middle;
        for (const float s : {0.1F, 0.2F, 0.4F, 0.7F, 1.0F}) {
            places_.push_back(here + s * (middle - here));
            places_.push_back(original_.Closest(places_.back()));
        }
    }

    void MarkChanged(std::uint32_t face)
    {
        energy_.MarkChanged(face);
        faults_.MarkChanged(face);
    }
    void Apply(const Change& change)
    {
        if (change.flip) {
            FlipEdge(surface_, *change.flip);
            MarkChanged(change.flip->First());
            MarkChanged(change.flip->Second());
            return;
        }
        Put(change.vertex, change.place);
        faults_.Put(change.vertex);
        std::uint8_t& flags = surface_.flags[change.vertex];
        flags = static_cast<std::uint8_t>(flags | kMovedVertex);
        ForEachFaceAround(surface_, change.vertex, [&](std::uint32_t f) { MarkChanged(f); });
    }
};

} // namespace vcg_ext
