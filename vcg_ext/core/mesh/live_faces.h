// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/mesh/face_tree_nodes.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// Boxes of faces that change: a tree in which boxes only grow, to be built anew when much has changed. It
/// finds every face that may touch a box; which faces are still there is left to the caller.
class LiveFaces
{
    static constexpr std::size_t kFacesPerLeaf = 8;

    std::vector<std::uint32_t> faces_;           ///< of leaf 0, leaf 1, ...
    std::vector<std::uint32_t> leafOf_;          ///< of every face
    std::vector<std::vector<FourBoxes>> levels_; ///< as those of FaceTree

  public:
    /// \param faces that are there, neighbors in space close to each other \param count all faces
    /// \param boxOf boxOf(face)
    template <class BoxOf>
    void Build(std::vector<std::uint32_t> faces, std::size_t count, const BoxOf& boxOf)
    {
        faces_ = std::move(faces);
        leafOf_.assign(count, kNone);
        levels_.clear();
        for (std::size_t i = 0; i < faces_.size(); ++i)
            leafOf_[faces_[i]] = static_cast<std::uint32_t>(i / kFacesPerLeaf);
        const auto parents = [](std::size_t nodes) { return (nodes + kLanes - 1) / kLanes; };
        for (std::size_t nodes = (faces_.size() + kFacesPerLeaf - 1) / kFacesPerLeaf; nodes > 0;) {
            levels_.emplace_back(parents(nodes), FourBoxes{EmptyBox<Float4>()});
            nodes = nodes > kLanes ? parents(nodes) : 0;
        }
        for (const std::uint32_t face : faces_) Grow(face, boxOf(face));
    }

    /// \p face lies in \p box now. \pre it was among the faces of Build
    void Grow(std::uint32_t face, const Box3<float>& box)
    {
        std::size_t node = leafOf_[face];
        for (auto& level : levels_) {
            FourBoxes& boxes = level[node / kLanes];
            const int lane = static_cast<int>(node % kLanes);
            Box3<float> grown = boxes.At(lane);
            if (grown.Has(box.low) && grown.Has(box.high)) return;
            grown.Add(box.low);
            grown.Add(box.high);
            boxes.Put(lane, grown);
            node /= kLanes;
        }
    }

    /// Calls visit(face) for every face that may touch \p box.
    template <class Visit>
    void ForEachNear(const Box3<float>& box, const Visit& visit) const
    {
        if (!levels_.empty()) ForEachNear(levels_.size(), 0, box, visit);
    }

  private:
    template <class Visit>
    void ForEachNear(std::size_t level, std::size_t node, const Box3<float>& box, const Visit& visit) const
    {
        if (level == 0) {
            const std::size_t end = std::min(faces_.size(), (node + 1) * kFacesPerLeaf);
            for (std::size_t i = node * kFacesPerLeaf; i < end; ++i) visit(faces_[i]);
            return;
        }
        const int met = LaneBits(levels_[level - 1][node].Meet(box));
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            if ((met >> lane & 1) != 0) ForEachNear(level - 1, kLanes * node + lane, box, visit);
    }
};

} // namespace vcg_ext
