// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/find_crossings.h"

namespace vcg_ext
{

/// Sees to it that no more faces of a result cross than of its original: finds them, says whether the
/// original has any there and where the next run has to be guarded, and takes back moves that a later stage
/// has made.
class CrossingKeeper
{
    const MeshView& original_;
    int threads_;
    std::optional<std::size_t> before_;
    std::vector<std::uint8_t> guarded_;

  public:
    /// \pre the view outlives this object
    CrossingKeeper(const MeshView& original, int threads) : original_(original), threads_(threads) {}

    std::vector<CrossingPair> Find(const DecimatedMesh& mesh) const
    {
        if (mesh.triangles.empty()) return {};
        std::vector<std::uint8_t> fixed;
        const MeshView view = ViewOf(mesh, original_, fixed);
        return Find(view, FaceTree(view, FrameOf(view), threads_));
    }
    /// The same of a mesh that has a tree of its faces.
    std::vector<CrossingPair> Find(const MeshView& view, const FaceTree& tree) const
    {
        return FindCrossings(view, tree, threads_);
    }

    /// Are \p crossings no more than the original has? Those are counted where there are any.
    /// \param tree of the original's faces
    bool Allows(std::size_t crossings, const FaceTree& tree)
    {
        if (crossings == 0) return true;
        if (!before_) before_ = FindCrossings(original_, tree, threads_).size();
        return crossings <= *before_;
    }

    /// Pairs of the original, if they had to be counted.
    std::optional<std::size_t> Before() const { return before_; }

    /// One byte an input vertex, for KeptForLater; null before the first run that crossed.
    const std::vector<std::uint8_t>* Guarded() const { return guarded_.empty() ? nullptr : &guarded_; }

    /// Do faces of the original cross where \p crossings of \p mesh are? \param tree of the original's faces
    bool OriginalCrossesNear(const std::vector<CrossingPair>& crossings, const DecimatedMesh& mesh,
                             const FaceTree& tree) const
    {
        std::vector<bool> isNear(original_.faceCount);
        ForEachFaceNear(crossings, mesh, tree, [&](std::uint32_t face) { isNear[face] = true; });
        std::vector<std::uint32_t> triangles;
        for (std::size_t face = 0; face < isNear.size(); ++face) {
            const std::uint32_t* v = original_.triangles + 3 * face;
            if (isNear[face]) triangles.insert(triangles.end(), v, v + 3);
        }
        if (triangles.empty()) return false;
        MeshView part = original_;
        part.triangles = triangles.data();
        part.faceCount = triangles.size() / 3;
        return !FindCrossings(part, FaceTree(part, tree.frame(), threads_), threads_).empty();
    }

    /// The next run is guarded where faces of \p mesh cross: everywhere where that is a large part or \p
    /// everywhere is set. \param tree of the original's faces
    void Guard(const std::vector<CrossingPair>& crossings, const DecimatedMesh& mesh, const FaceTree& tree,
               bool everywhere)
    {
        constexpr std::ptrdiff_t kLargePart = 4; // one vertex in so many
        guarded_.resize(original_.vertexCount, 0);
        ForEachFaceNear(crossings, mesh, tree, [&](std::uint32_t face) {
            for (std::size_t k = 0; k < 3; ++k) guarded_[original_.triangles[3 * std::size_t{face} + k]] = 1;
        });
        const auto marked = std::count(guarded_.begin(), guarded_.end(), std::uint8_t{1});
        if (everywhere || kLargePart * marked > static_cast<std::ptrdiff_t>(guarded_.size()))
            std::fill(guarded_.begin(), guarded_.end(), std::uint8_t{1});
    }

    /// Takes vertices of \p moved back to where \p before had them until no faces cross that did not cross
    /// there. \pre both have the same faces
    void TakeBack(DecimatedMesh& moved, const DecimatedMesh& before) const
    {
        constexpr int kTakeBackRounds = 12;
        const std::vector<CrossingPair> present = Find(before);
        for (int round = 0;; ++round) {
            const std::vector<CrossingPair> all = Find(moved);
            std::vector<CrossingPair> added;
            std::set_difference(all.begin(), all.end(), present.begin(), present.end(),
                                std::back_inserter(added));
            if (added.empty()) return;
            if (round == kTakeBackRounds) moved = before;
            for (const CrossingPair& pair : added)
                for (const std::uint32_t f : {pair.first, pair.second})
                    for (const std::uint32_t v : moved.triangles[f]) moved.positions[v] = before.positions[v];
        }
    }

    /// Takes everything back where more faces cross than before.
    void TakeBackAll(DecimatedMesh& changed, const DecimatedMesh& before) const
    {
        const bool isSame = changed.positions == before.positions && changed.triangles == before.triangles;
        if (!isSame && Find(changed).size() > Find(before).size()) changed = before;
    }

  private:
    /// Calls visit(face) for the original's faces near those of \p mesh that cross, again where several are.
    template <class Visit>
    static void ForEachFaceNear(const std::vector<CrossingPair>& crossings, const DecimatedMesh& mesh,
                                const FaceTree& tree, const Visit& visit)
    {
        constexpr float kAround = 0.25F; // of the face's box, on every side
        for (const CrossingPair& pair : crossings)
            for (const std::uint32_t f : {pair.first, pair.second}) {
                Box3<float> box = EmptyBox<float>();
                for (const std::uint32_t v : mesh.triangles[f]) box.Add(tree.frame().Into(mesh.positions[v]));
                box.Grow(kAround * Norm(box.high - box.low));
                tree.ForEachNear(box, [&](std::uint32_t face, const auto&...) { visit(face); });
            }
    }
};

} // namespace vcg_ext
