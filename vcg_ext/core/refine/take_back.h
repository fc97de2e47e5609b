// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/edge_flip.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/attach_samples.h"
#include "vcg_ext/core/refine/held_out.h"
#include "vcg_ext/core/refine/parameters.h"

// The check behind the passes: where points that they have not looked at are farther from the other surface
// than any sample was before the first change, and than points around them were, vertices and diagonals go
// back.

namespace vcg_ext
{

/// What changes in the simplified surface, as it was before the first change.
struct SurfaceBefore {
    Buffer<SurfacePoint> points;
    Buffer<SurfaceTriangle> triangles;
    Buffer<std::uint8_t> flags;

    explicit SurfaceBefore(const SurfaceArrays& surface)
        : points(surface.points.Copy()), triangles(surface.triangles.Copy()), flags(surface.flags.Copy())
    {
    }
    bool HasVertexAt(const SurfaceArrays& surface, std::uint32_t v) const
    {
        const SurfacePoint &now = surface.points[v], &before = points[v];
        return now.x == before.x && now.y == before.y && now.z == before.z;
    }
    bool HasFace(std::uint32_t face, std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        const SurfaceTriangle& t = triangles[face];
        return HasVertex(t, a) && HasVertex(t, b) && HasVertex(t, c);
    }
};

/// Puts vertices and diagonals of a simplified surface back to where they were, where the faces around stay
/// sound.
class Undoer
{
    SurfaceArrays& surface_;
    const SurfaceBefore& before_;

  public:
    Undoer(SurfaceArrays& surface, const SurfaceBefore& before) : surface_(surface), before_(before) {}

    /// True if \p v is back.
    bool PutBack(std::uint32_t v)
    {
        if (before_.HasVertexAt(surface_, v)) return false;
        const SurfacePoint& old = before_.points[v];
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c) {
            const auto seenFrom = [&](const Vector3<float>& p) {
                return PrepareTriangle(PositionOf(surface_, NextVertex(surface_, *c)) - p,
                                       PositionOf(surface_, PreviousVertex(surface_, *c)) - p);
            };
            const PreparedTriangle<float> now = seenFrom(PositionOf(surface_, v));
            const PreparedTriangle<float> back = seenFrom({old.x, old.y, old.z});
            if (!(back.doubleArea > 0) || Dot(NormalOf(back), NormalOf(now)) < kMinTurnCosine ||
                back.quality < std::min(kMinMoveQuality, now.quality / 2))
                return false;
        }
        surface_.points[v] = old;
        surface_.flags[v] = before_.flags[v];
        return true;
    }
    /// True if an edge of \p face has its diagonal back: one of its faces is then as it was.
    bool FlipBack(std::uint32_t face)
    {
        const SurfaceTriangle t = surface_.triangles[face];
        if (before_.HasFace(face, t.v[0], t.v[1], t.v[2])) return false;
        for (std::size_t k = 0; k < 3; ++k)
            if (FlipBack(t.v[k], t.v[kNextIndex[k]])) return true;
        return false;
    }

  private:
    bool FlipBack(std::uint32_t v, std::uint32_t w)
    {
        const auto edge = FindFlippableEdge(surface_, v, w);
        if (!edge || AreNeighbours(surface_, edge->c, edge->d)) return false;
        if (!before_.HasFace(edge->First(), edge->a, edge->d, edge->c) &&
            !before_.HasFace(edge->Second(), edge->a, edge->d, edge->c) &&
            !before_.HasFace(edge->First(), edge->b, edge->c, edge->d) &&
            !before_.HasFace(edge->Second(), edge->b, edge->c, edge->d))
            return false;
        const Vector3<float> a = PositionOf(surface_, edge->a), b = PositionOf(surface_, edge->b);
        const Vector3<float> c = PositionOf(surface_, edge->c), d = PositionOf(surface_, edge->d);
        const Vector3<float> mean = Cross(b - a, c - a) + Cross(d - a, b - a);
        for (const Vector3<float>& n : {Cross(d - a, c - a), Cross(c - b, d - b)})
            if (!(Dot(n, mean) > kMinTurnCosine * Norm(n) * Norm(mean))) return false;
        FlipEdge(surface_, *edge);
        return true;
    }
};

struct TakenBack {
    std::size_t suspects = 0, near = 0, moves = 0, flips = 0, worse = 0;
    int rounds = 0;
};

/// Cells of space in which something is asked for.
class AskedCells
{
    static constexpr int kCells = 64; ///< along an axis
    std::vector<bool> asked_ = std::vector<bool>(std::size_t{kCells} * kCells * kCells);

    static int CellOf(float x)
    {
        constexpr auto kHalf = static_cast<float>(kFrameDiagonal / 2);
        const float cell = (x + kHalf) * (kCells / (2 * kHalf));
        return static_cast<int>(std::clamp(cell, 0.0F, static_cast<float>(kCells - 1)));
    }
    template <class Visit>
    static bool AnyCell(const Box3<float>& box, const Visit& visit)
    {
        for (int x = CellOf(box.low.x); x <= CellOf(box.high.x); ++x)
            for (int y = CellOf(box.low.y); y <= CellOf(box.high.y); ++y)
                for (int z = CellOf(box.low.z); z <= CellOf(box.high.z); ++z)
                    if (visit(static_cast<std::size_t>((x * kCells + y) * kCells + z))) return true;
        return false;
    }

  public:
    void Ask(const Box3<float>& box)
    {
        AnyCell(box, [&](std::size_t cell) {
            asked_[cell] = true;
            return false;
        });
    }
    bool Meets(const Box3<float>& box) const
    {
        return AnyCell(box, [&](std::size_t cell) { return asked_[cell]; });
    }
};

inline Box3<float> BoxOf(const FaceCorners& face)
{
    Box3<float> box = EmptyBox<float>();
    for (const Vector3<float>& p : {face.a, face.a + face.toB, face.a + face.toC}) box.Add(p);
    return box;
}

/// Compares both surfaces with the original at places that a pass may have made worse.
class StarCheck
{
    const SurfaceArrays& original_;
    SurfaceArrays& simplified_;
    const SurfaceBefore& before_;
    float limit2_;
    int threads_;
    std::optional<FaceTree> ofOriginal_, ofBefore_;

  public:
    TakenBack taken;

    /// \param limit2 squared distances up to it are good enough
    StarCheck(const SurfaceArrays& original, SurfaceArrays& simplified, const SurfaceBefore& before,
              float limit2, int threads)
        : original_(original), simplified_(simplified), before_(before), limit2_(limit2), threads_(threads)
    {
    }

    void Run(Suspects suspects)
    {
        if (!suspects.ofOriginal.empty()) ofBefore_.emplace(TreeOf(before_.points, before_.triangles, threads_));
        for (int round = 0; round < kTakeBackRounds && !suspects.empty(); ++round) {
            const std::vector<std::uint32_t> worse = WorseFaces(suspects);
            taken.worse += worse.size();
            if (!TakeBack(worse, suspects)) break;
            ++taken.rounds;
        }
    }

  private:
    /// A tree of the original's faces that are near those faces or what they were before: most of the
    /// original is not, and a tree of all would set the peak of memory.
    void BuildTreeNear(const std::vector<std::uint32_t>& faces)
    {
        constexpr float kReach = 4;
        const float reach = kReach * std::sqrt(limit2_);
        AskedCells cells;
        const auto ask = [&](const FaceCorners& corners) {
            Box3<float> box = BoxOf(corners);
            box.Grow(reach);
            cells.Ask(box);
        };
        for (const std::uint32_t f : faces) {
            ask(CornersOf(simplified_, f));
            for (const std::uint32_t v : simplified_.triangles[f].v)
                for (const Corner* c = BeginCorners(simplified_, v); c != EndCorners(simplified_, v); ++c)
                    ask(CornersOf(before_.points, before_.triangles[FaceOf(*c)]));
        }
        std::vector<std::uint32_t> near;
        for (std::uint32_t f = 0; f < original_.FaceCount(); ++f)
            if (cells.Meets(BoxOf(CornersOf(original_, f)))) near.push_back(f);
        ofOriginal_.reset();
        if (!near.empty()) ofOriginal_.emplace(TreeOf(original_.points, original_.triangles, threads_, near));
        taken.near += near.size();
    }
    /// The faces of the simplified surface where it got worse; ascending.
    std::vector<std::uint32_t> WorseFaces(const Suspects& suspects)
    {
        std::vector<std::uint32_t> worse(suspects.ofSimplified.size() + suspects.ofOriginal.size(), kNone);
        if (!suspects.ofSimplified.empty()) BuildTreeNear(suspects.ofSimplified);
        if (ofOriginal_) ParallelFor(threads_, suspects.ofSimplified.size(), [&](std::size_t i, int) {
            if (GotWorse(suspects.ofSimplified[i])) worse[i] = suspects.ofSimplified[i];
        });
        if (!suspects.ofOriginal.empty()) {
            const FaceTree now = TreeOf(simplified_, threads_);
            ParallelFor(threads_, suspects.ofOriginal.size(), [&](std::size_t i, int) {
                worse[suspects.ofSimplified.size() + i] = CauseOf(suspects.ofOriginal[i], now);
            });
        }
        std::sort(worse.begin(), worse.end());
        worse.erase(std::unique(worse.begin(), worse.end()), worse.end());
        if (!worse.empty() && worse.back() == kNone) worse.pop_back();
        return worse;
    }
    /// Is a point of the face farther from the original than any around it was before?
    bool GotWorse(std::uint32_t face) const
    {
        const float now2 = FindFarthest(*ofOriginal_, CornersOf(simplified_, face), limit2_).distance2;
        if (!(now2 > limit2_)) return false;
        for (const std::uint32_t v : simplified_.triangles[face].v)
            for (const Corner* c = BeginCorners(simplified_, v); c != EndCorners(simplified_, v); ++c) {
                const FaceCorners old = CornersOf(before_.points, before_.triangles[FaceOf(*c)]);
                if (!(FindFarthest(*ofOriginal_, old, limit2_).distance2 < now2)) return false;
            }
        return true;
    }
    /// The face that is closest to a point of a face of the original that is farther than any of that was
    /// before; kNone where there is no such point.
    std::uint32_t CauseOf(std::uint32_t face, const FaceTree& now) const
    {
        const FaceCorners corners = CornersOf(original_, face);
        const FarthestPoint farthest = FindFarthest(now, corners, limit2_);
        if (!(farthest.distance2 > limit2_)) return kNone;
        if (!(FindFarthest(*ofBefore_, corners, limit2_).distance2 < farthest.distance2)) return kNone;
        std::vector<FaceTree::Candidate> closest;
        now.FindClosest(corners.At(farthest.place), 0, std::numeric_limits<float>::max(), closest);
        return closest.empty() ? kNone : closest.front().face;
    }
    /// Puts back what it can of those faces; what is around them is suspect next. False where nothing is left.
    bool TakeBack(const std::vector<std::uint32_t>& worse, Suspects& suspects)
    {
        Undoer undoer(simplified_, before_);
        std::vector<std::uint32_t> changed;
        for (const std::uint32_t f : worse) {
            const SurfaceTriangle t = simplified_.triangles[f];
            bool any = undoer.FlipBack(f);
            taken.flips += any;
            for (const std::uint32_t v : t.v)
                if (undoer.PutBack(v)) { any = true; ++taken.moves; }
            if (any) changed.insert(changed.end(), t.v, t.v + 3);
        }
        suspects.ofSimplified.clear();
        for (const std::uint32_t v : changed)
            for (const Corner* c = BeginCorners(simplified_, v); c != EndCorners(simplified_, v); ++c)
                suspects.ofSimplified.push_back(FaceOf(*c));
        std::sort(suspects.ofSimplified.begin(), suspects.ofSimplified.end());
        suspects.ofSimplified.erase(std::unique(suspects.ofSimplified.begin(), suspects.ofSimplified.end()), suspects.ofSimplified.end());
        return !changed.empty();
    }
};

} // namespace vcg_ext
