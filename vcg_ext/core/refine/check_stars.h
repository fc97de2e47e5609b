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

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/attach_samples.h"
#include "vcg_ext/core/refine/held_out.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/suspects.h"
#include "vcg_ext/core/refine/take_back.h"

// The check behind the passes: where points that they have not looked at are farther from the other surface
// than any sample was before the first change, and than the points around were, vertices and diagonals go
// back.

namespace vcg_ext
{

/// Cells of space in which something is asked for.
class AskedCells
{
    static constexpr std::size_t kCells = 64; ///< along an axis
    std::vector<bool> asked_ = std::vector<bool>(kCells * kCells * kCells);

    static std::size_t CellOf(float x)
    {
        constexpr auto kHalf = static_cast<float>(kFrameDiagonal / 2);
        const float cell = (x + kHalf) * (static_cast<float>(kCells) / (2 * kHalf));
        return static_cast<std::size_t>(std::clamp(cell, 0.0F, static_cast<float>(kCells - 1)));
    }
    template <class Visit>
    static bool AnyCell(const Box3<float>& box, const Visit& visit)
    {
        for (std::size_t x = CellOf(box.low.x); x <= CellOf(box.high.x); ++x)
            for (std::size_t y = CellOf(box.low.y); y <= CellOf(box.high.y); ++y)
                for (std::size_t z = CellOf(box.low.z); z <= CellOf(box.high.z); ++z)
                    if (visit((x * kCells + y) * kCells + z)) return true;
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
    bool Has(const Box3<float>& box) const
    {
        return !AnyCell(box, [&](std::size_t cell) { return !asked_[cell]; });
    }
};

/// A tree of those faces of a surface that are near places asked for: most are not, and a tree of all would
/// set the peak of memory.
class TreeOfNearFaces
{
    const SurfaceArrays& surface_;
    int threads_;
    AskedCells cells_;
    bool isComplete_ = true;
    std::optional<FaceTree> tree_;

  public:
    TreeOfNearFaces(const SurfaceArrays& surface, int threads) : surface_(surface), threads_(threads) {}

    /// All faces within \p reach of \p box are asked for; those within \p more come with them.
    void Ask(Box3<float> box, float reach, float more)
    {
        box.Grow(reach);
        if (cells_.Has(box)) return;
        box.Grow(more);
        cells_.Ask(box);
        isComplete_ = false;
    }
    /// Null where no face is near.
    const FaceTree* Tree()
    {
        if (isComplete_) return tree_ ? &*tree_ : nullptr;
        std::vector<std::uint32_t> near;
        for (std::uint32_t f = 0; f < surface_.FaceCount(); ++f)
            if (cells_.Meets(CornersOf(surface_, f).Box())) near.push_back(f);
        tree_.reset();
        if (!near.empty()) tree_.emplace(TreeOf(surface_.points, surface_.triangles, threads_, near));
        isComplete_ = true;
        return Tree();
    }
};

/// Compares the simplified surface with the original, now and before, and puts back what has got worse.
class StarCheck
{
    const SurfaceArrays& original_;
    SurfaceArrays& simplified_;
    const SurfaceBefore& before_;
    float limit2_;
    int threads_;
    TreeOfNearFaces nearOriginal_;
    std::optional<FaceTree> treeBefore_;

  public:
    /// \param limit2 squared distances up to it are good enough
    StarCheck(const SurfaceArrays& original, SurfaceArrays& simplified, const SurfaceBefore& before,
              float limit2, int threads)
        : original_(original), simplified_(simplified), before_(before), limit2_(limit2), threads_(threads),
          nearOriginal_(original, threads)
    {
    }

    /// Returns how many vertices and diagonals went back.
    std::size_t Run(Suspects suspects)
    {
        if (!suspects.ofOriginal.empty())
            treeBefore_.emplace(TreeOf(before_.points, before_.triangles, threads_));
        std::size_t taken = 0;
        for (int round = 0; round < kTakeBackRounds && !suspects.empty(); ++round) {
            const std::size_t before = taken;
            suspects.ofSimplified = TakeBack(WorseFaces(suspects), taken);
            if (taken == before) break;
        }
        return taken;
    }

  private:
    /// The faces of the simplified surface where it got worse; ascending.
    std::vector<std::uint32_t> WorseFaces(const Suspects& suspects)
    {
        const std::size_t count = suspects.ofSimplified.size();
        std::vector<std::uint32_t> worse(count + suspects.ofOriginal.size(), kNone);
        if (const FaceTree* tree = TreeNear(suspects.ofSimplified))
            ParallelFor(threads_, count, [&](std::size_t i, int) {
                if (GotWorse(suspects.ofSimplified[i], *tree)) worse[i] = suspects.ofSimplified[i];
            });
        if (!suspects.ofOriginal.empty()) {
            const FaceTree now = TreeOf(simplified_, threads_);
            ParallelFor(threads_, suspects.ofOriginal.size(),
                        [&](std::size_t i, int) { worse[count + i] = CauseOf(suspects.ofOriginal[i], now); });
        }
        SortAndUnite(worse);
        if (!worse.empty() && worse.back() == kNone) worse.pop_back();
        return worse;
    }
    /// Has all faces of the original that may be closest to those faces, or to what was there before.
    const FaceTree* TreeNear(const std::vector<std::uint32_t>& faces)
    {
        constexpr float kReach = 4; // x the limit; what is farther is worse anyway
        const float reach = kReach * std::sqrt(limit2_);
        for (const std::uint32_t f : faces) {
            const Box3<float> box = CornersOf(simplified_, f).Box();
            const float size = Norm(box.high - box.low); // its neighbours may be asked for next
            nearOriginal_.Ask(box, reach, size);
            for (const std::uint32_t other : FacesAround(f))
                nearOriginal_.Ask(CornersOf(before_.points, before_.triangles[other]).Box(), reach, size);
        }
        return nearOriginal_.Tree();
    }
    /// Is a point of the face farther from the original than any around it was before?
    bool GotWorse(std::uint32_t face, const FaceTree& original) const
    {
        const float now2 = FindFarthest(original, CornersOf(simplified_, face), limit2_).distance2;
        if (!(now2 > limit2_)) return false;
        const float less2 = now2 * kMinProgress;
        const std::vector<std::uint32_t> around = FacesAround(face);
        return std::none_of(around.begin(), around.end(), [&](std::uint32_t other) {
            const FaceCorners old = CornersOf(before_.points, before_.triangles[other]);
            return FindFarthest(original, old, less2).distance2 > less2;
        });
    }
    /// The face that is closest to a point of a face of the original that is farther than any of that was
    /// before; kNone where there is no such point.
    std::uint32_t CauseOf(std::uint32_t face, const FaceTree& now) const
    {
        const FaceCorners corners = CornersOf(original_, face);
        const FarthestPoint farthest = FindFarthest(now, corners, limit2_);
        if (!(farthest.distance2 > limit2_)) return kNone;
        const float less2 = farthest.distance2 * kMinProgress;
        if (FindFarthest(*treeBefore_, corners, less2).distance2 > less2) return kNone;
        std::vector<FaceTree::Candidate> closest;
        now.FindClosest(corners.At(farthest.place), 0, std::numeric_limits<float>::max(), closest);
        return closest.empty() ? kNone : closest.front().face;
    }

    /// Puts back what can go of those faces. Returns the faces around: what goes back may make them worse.
    std::vector<std::uint32_t> TakeBack(const std::vector<std::uint32_t>& worse, std::size_t& taken)
    {
        Undoer undoer(simplified_, before_);
        std::vector<std::uint32_t> around;
        for (const std::uint32_t f : worse) {
            const std::size_t before = taken;
            taken += undoer.FlipBack(f) ? 1 : 0;
            for (const std::uint32_t v : simplified_.triangles[f].v) taken += undoer.PutBack(v) ? 1 : 0;
            if (taken == before) continue;
            const std::vector<std::uint32_t> faces = FacesAround(f);
            around.insert(around.end(), faces.begin(), faces.end());
        }
        SortAndUnite(around);
        return around;
    }

    /// All faces that share a corner with \p face, itself among them, ascending. Not those around a vertex
    /// with very many: comparing each with each would cost the square of their number.
    std::vector<std::uint32_t> FacesAround(std::uint32_t face) const
    {
        std::vector<std::uint32_t> faces{face};
        for (const std::uint32_t v : simplified_.triangles[face].v)
            if (simplified_.cornerCount[v] <= kMaxSearchedStar)
                for (const Corner* c = BeginCorners(simplified_, v); c != EndCorners(simplified_, v); ++c)
                    faces.push_back(FaceOf(*c));
        SortAndUnite(faces);
        return faces;
    }
    static void SortAndUnite(std::vector<std::uint32_t>& faces)
    {
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
};

/// Puts vertices and diagonals back where a point that the passes have not looked at is farther than before.
/// Uses the samples up. Returns how many.
inline std::size_t TakeBackWorse(RefinementState& state, const SurfaceBefore& before, int threads)
{
    const float limit2 = state.farthest2;
    const Suspects suspects = SuspectFinder(state, limit2, threads).Find();
    state.samples = {};
    state.border = {};
    if (suspects.empty()) return 0;
    return StarCheck(state.original, state.simplified, before, limit2, threads).Run(suspects);
}

} // namespace vcg_ext
