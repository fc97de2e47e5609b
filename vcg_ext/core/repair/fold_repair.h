// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/repair/local_samples.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/build_surface.h"
#include "vcg_ext/core/mesh/edge_flip.h"

namespace vcg_ext
{

inline PlacedTriangle Placed(const SurfaceArrays& surface, const SurfaceTriangle& triangle)
{
    const Vector3<float> a = PositionOf(surface, triangle.v[0]);
    return {a,
            PrepareTriangle(PositionOf(surface, triangle.v[1]) - a, PositionOf(surface, triangle.v[2]) - a)};
}

/// A face is folded where the original looks the other way at the point that is closest to the face's
/// centroid. Faces without area have no side.
/// \param onSurface a point of the original where it does not look against the face, if one is known
inline bool IsFolded(const FaceTree& original, const PlacedTriangle& face,
                     const std::optional<Vector3<float>>& onSurface = {})
{
    if (!(face.shape.doubleArea > 0)) return false;
    const Vector3<float> centroid = face.origin + (1.0F / 3) * (face.ToSecond() + face.ToThird());
    if (!onSurface) return original.FacesAwayFrom(centroid, NormalOf(face.shape));
    return original.FacesAwayFrom(centroid, NormalOf(face.shape), SquaredNorm(*onSurface - centroid));
}

/// Mends folded faces of a simplified surface, each by the edge flip or the move of one of its vertices that
/// leaves fewer of them and changes the distances between the surfaces most favourably.
class Unfolder
{
    /// A flip or a move, and what it does.
    struct Change {
        int folded = 0; ///< how many fewer faces are folded
        float rise = 0; ///< of the energy
        std::optional<FlippableEdge> flip;
        std::uint32_t vertex = 0; ///< that moves, where nothing is flipped ...
        Vector3<float> place{};   ///< ... to this point
    };
    /// The faces that a change replaces, or puts in their place.
    struct Look {
        int folded = 0;
        float quality = 1; ///< of the worst
    };

    static constexpr std::size_t kMostSamples = 100;
    static constexpr float kPoorQuality = 0.02F; ///< a worse triangle only where a worse one was before
    static constexpr float kNoLimit = std::numeric_limits<float>::max();

    const FaceTree& original_;
    const FaceTree& simplified_; ///< the surface before the first change
    SurfaceArrays& surface_;
    std::vector<std::uint32_t> changed_; ///< faces since then, sorted
    NearbySamples samples_;
    std::vector<std::uint32_t> region_, star_, others_; // faces
    std::vector<PlacedTriangle> placed_;
    std::vector<Vector3<float>> places_;
    std::vector<std::uint32_t> next_, previous_;

  public:
    Unfolder(const FaceTree& original, const FaceTree& simplified, SurfaceArrays& surface)
        : original_(original), simplified_(simplified), surface_(surface)
    {
    }

    /// All faces that are not as they were at the start, in ascending order.
    const std::vector<std::uint32_t>& Changed() const { return changed_; }

    bool IsFoldedNow(std::uint32_t face) const
    {
        return IsFolded(original_, Placed(surface_, surface_.triangles[face]));
    }

    /// Mends \p face if that can be done.
    /// \param tolerance the energy of what changes may rise by this factor
    /// \param bordersMove vertices on borders may move too
    void Mend(std::uint32_t face, float tolerance, bool bordersMove)
    {
        if (!IsFoldedNow(face)) return;
        FindRegion(face);
        std::optional<Change> best;
        if (!TryFlips(face, tolerance, best)) TryMoves(face, tolerance, bordersMove, best);
        if (best) Carry(*best);
    }

  private:
    bool IsFixed(std::uint32_t v) const { return (surface_.flags[v] & kFixedVertex) != 0; }
    template <class Visit>
    void ForEachFaceAround(std::uint32_t v, const Visit& visit) const
    {
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c)
            visit(FaceOf(*c));
    }
    static void SortUnique(std::vector<std::uint32_t>& values)
    {
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
    }

    /// A box that grows.
    struct Bounds {
        Vector3<float> low{kNoLimit, kNoLimit, kNoLimit}, high{-kNoLimit, -kNoLimit, -kNoLimit};
        void Add(const Vector3<float>& p)
        {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
        void Grow(float by)
        {
            low = low - Vector3<float>{by, by, by};
            high = high + Vector3<float>{by, by, by};
        }
        bool Has(const Vector3<float>& p) const { return Meets({p, p}); }
        bool Meets(const Bounds& b) const
        {
            return low.x <= b.high.x && low.y <= b.high.y && low.z <= b.high.z && b.low.x <= high.x &&
                   b.low.y <= high.y && b.low.z <= high.z;
        }
    };
    Bounds BoundsOf(std::uint32_t face) const
    {
        Bounds bounds;
        for (const std::uint32_t v : surface_.triangles[face].v) bounds.Add(PositionOf(surface_, v));
        return bounds;
    }

    /// The faces around \p face, the original's samples near them, and the faces beyond that those may be
    /// closer to.
    void FindRegion(std::uint32_t face)
    {
        region_.clear();
        for (const std::uint32_t v : surface_.triangles[face].v)
            ForEachFaceAround(v, [&](std::uint32_t f) { region_.push_back(f); });
        SortUnique(region_);
        Bounds bounds;
        float distance2 = 0;
        for (const std::uint32_t f : region_) {
            distance2 = std::max(distance2, original_.Distance2(Centroid(surface_, f)));
            for (const std::uint32_t v : surface_.triangles[f].v) bounds.Add(PositionOf(surface_, v));
        }
        const float margin = 2 * std::sqrt(distance2);
        bounds.Grow(margin);
        TakeSamples(bounds);
        bounds.Grow(margin);
        others_.clear();
        for (const std::uint32_t f : changed_)
            if (bounds.Meets(BoundsOf(f))) others_.push_back(f);
        simplified_.ForEachNear(bounds.low, bounds.high,
                                [&](std::uint32_t f, const auto&...) { others_.push_back(f); });
        SortUnique(others_);
        for (const std::uint32_t f : others_)
            if (!std::binary_search(region_.begin(), region_.end(), f) && bounds.Meets(BoundsOf(f)))
                samples_.AddFar(Placed(surface_, surface_.triangles[f]));
    }
    void TakeSamples(const Bounds& bounds)
    {
        constexpr float kCentroidShare = 0.4F, kCornerShare = 0.2F;
        samples_.Clear();
        original_.ForEachNear(
            bounds.low, bounds.high,
            [&](std::uint32_t, const Vector3<float>& a, const Vector3<float>& ab, const Vector3<float>& ac) {
                const float area = Norm(Cross(ab, ac)) / 2;
                const auto add = [&](const Vector3<float>& p, float share) {
                    if (bounds.Has(p)) samples_.Add(p, share * area);
                };
                add(a + (1.0F / 3) * (ab + ac), kCentroidShare);
                for (const Vector3<float>& corner : {a, a + ab, a + ac}) add(corner, kCornerShare);
            });
        samples_.Begin(kMostSamples);
    }
    /// Only \p faces change from now on.
    void LetChange(const std::vector<std::uint32_t>& faces)
    {
        samples_.ForgetElsewhere();
        for (const std::uint32_t f : region_)
            if (std::find(faces.begin(), faces.end(), f) == faces.end())
                samples_.AddElsewhere(Placed(surface_, surface_.triangles[f]));
    }

    /// Looks at placed_. \param enough where so many faces are folded, there is no need to look further
    /// \return nothing where a face has no area
    std::optional<Look> LookAtPlaced(int enough) const
    {
        Look look;
        for (const PlacedTriangle& face : placed_) {
            if (!(face.shape.doubleArea > 0)) return std::nullopt;
            look.quality = std::min(look.quality, face.shape.quality);
        }
        for (const PlacedTriangle& face : placed_)
            if (IsFolded(original_, face) && ++look.folded >= enough) break;
        return look;
    }
    /// Area times squared distance of placed_, from the samples and back; any number above \p limit where it
    /// is above that.
    float Energy(float limit) const
    {
        // of a face's area, on its centroid, the midpoints of its edges and its corners: exact for cubics
        constexpr float kCentroid = 9.0F / 20, kMidpoint = 2.0F / 15, kCorner = 1.0F / 20;
        float energy = samples_.Energy(placed_, limit);
        for (const PlacedTriangle& face : placed_) {
            if (energy > limit) break;
            const Vector3<float> b = face.ToSecond(), c = face.ToThird();
            const auto at = [&](const Vector3<float>& p) { return original_.Distance2(face.origin + p); };
            energy += face.shape.doubleArea / 2 *
                      (kCentroid * at((1.0F / 3) * (b + c)) +
                       kMidpoint * (at(0.5F * b) + at(0.5F * c) + at(0.5F * (b + c))) +
                       kCorner * (at(Vector3<float>{}) + at(b) + at(c)));
        }
        return energy;
    }

    /// What a change starts from: placed_ holds the old faces, LetChange has been told of them.
    struct Start {
        Look look;
        float energy = 0;
        float rounding = 0; ///< a rise of the energy by so much says nothing
    };
    Start Begin() const
    {
        Start start;
        for (const PlacedTriangle& face : placed_) {
            start.look.folded += IsFolded(original_, face);
            start.look.quality = std::min(start.look.quality, face.shape.quality);
            start.rounding += face.shape.doubleArea / 2 * FaceTree::kOnSurface2;
        }
        start.energy = Energy(kNoLimit);
        return start;
    }
    /// Makes \p change, of which placed_ holds the new faces, the best one if it is.
    /// \return it is good enough to look no further: no face that it puts in place is folded, and the energy
    /// has not risen but for rounding
    bool Offer(Change change, const Start& start, float tolerance, std::optional<Change>& best) const
    {
        const auto look = LookAtPlaced(start.look.folded);
        if (!look || look->folded >= start.look.folded ||
            look->quality < std::min(start.look.quality, kPoorQuality))
            return false;
        change.folded = start.look.folded - look->folded;
        if (best && best->folded > change.folded) return false;
        const bool tie = best && best->folded == change.folded;
        const float allowed = tolerance * start.energy + start.rounding;
        const float limit = tie ? std::min(allowed, start.energy + best->rise) : allowed;
        const float energy = Energy(limit);
        if (!(energy <= limit) || (tie && energy - start.energy >= best->rise)) return false;
        change.rise = energy - start.energy;
        best = change;
        return look->folded == 0 && change.rise <= start.rounding;
    }

    /// Offers every flip, until one cannot be beaten. \return whether one cannot
    bool TryFlips(std::uint32_t face, float tolerance, std::optional<Change>& best)
    {
        const SurfaceTriangle t = surface_.triangles[face];
        for (int k = 0; k < 3; ++k) {
            const auto edge = FindFlippableEdge(surface_, t.v[k], t.v[(k + 1) % 3]);
            if (!edge || AreNeighbours(surface_, edge->c, edge->d)) continue;
            LetChange({edge->First(), edge->Second()});
            placed_ = {Placed(surface_, surface_.triangles[edge->First()]),
                       Placed(surface_, surface_.triangles[edge->Second()])};
            const auto start = Begin();
            placed_ = {Placed(surface_, {{edge->a, edge->d, edge->c}}),
                       Placed(surface_, {{edge->b, edge->c, edge->d}})};
            Change change;
            change.flip = edge;
            if (Offer(change, start, tolerance, best)) return true;
        }
        return false;
    }

    void TryMoves(std::uint32_t face, float tolerance, bool bordersMove, std::optional<Change>& best)
    {
        const SurfaceTriangle t = surface_.triangles[face];
        for (const std::uint32_t v : t.v) {
            if (IsFixed(v) || (!bordersMove && !HasClosedStar(surface_, v, next_, previous_))) continue;
            star_ = {face}; // first, because it decides most often
            ForEachFaceAround(v, [&](std::uint32_t f) {
                if (f != face) star_.push_back(f);
            });
            LetChange(star_);
            PlaceStar();
            const auto start = Begin();
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

    /// Where \p v might go to mend \p face: away from the side that is too close, across the opposite edge,
    /// or towards the middle of its neighbours, there or on the original.
    void FindPlaces(std::uint32_t face, std::uint32_t v)
    {
        const Vector3<float> here = PositionOf(surface_, v);
        const SurfaceTriangle& t = surface_.triangles[face];
        places_.clear();
        const Vector3<float> normal = NormalOf(Placed(surface_, t).shape);
        const float reach2 = original_.DistanceAlong2(Centroid(surface_, face), normal);
        Vector3<float> star{}, middle{};
        ForEachFaceAround(v, [&](std::uint32_t f) { star = star + AreaVector(surface_, f); });
        star = (1 / std::max(Norm(star), std::sqrt(kSmallestSquare))) * star;
        if (reach2 < kNoLimit)
            for (const float s : {0.1F, 0.2F, 0.4F, 0.7F, 1.0F, 1.5F, 2.0F, 3.0F})
                for (const Vector3<float>& step : {normal, star, -1.0F * star})
                    places_.push_back(here + (s * std::sqrt(reach2)) * step);

        int k = 0;
        while (t.v[k] != v) ++k;
        const Vector3<float> p = PositionOf(surface_, t.v[(k + 1) % 3]),
                             q = PositionOf(surface_, t.v[(k + 2) % 3]);
        const float along = Dot(here - p, q - p) / std::max(SquaredNorm(q - p), kSmallestSquare);
        const Vector3<float> toEdge = p + along * (q - p) - here;
        for (const float s : {1.2F, 1.5F, 2.0F, 4.0F}) places_.push_back(here + s * toEdge);

        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c)
            middle = middle + PositionOf(surface_, NextVertex(surface_, *c));
        middle = (1 / static_cast<float>(surface_.cornerCount[v])) * middle;
        for (const float s : {0.1F, 0.2F, 0.4F, 0.7F, 1.0F}) {
            places_.push_back(here + s * (middle - here));
            places_.push_back(original_.Closest(places_.back()));
        }
    }

    void Carry(const Change& change)
    {
        if (change.flip) {
            FlipEdge(surface_, *change.flip);
            MarkChanged(change.flip->First());
            MarkChanged(change.flip->Second());
        } else {
            Put(change.vertex, change.place);
            std::uint8_t& flags = surface_.flags[change.vertex];
            flags = static_cast<std::uint8_t>(flags | kMovedVertex);
            ForEachFaceAround(change.vertex, [&](std::uint32_t f) { MarkChanged(f); });
        }
    }
    void MarkChanged(std::uint32_t face)
    {
        const auto at = std::lower_bound(changed_.begin(), changed_.end(), face);
        if (at == changed_.end() || *at != face) changed_.insert(at, face);
    }
};

} // namespace vcg_ext
