// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <vcg/simplex/face/pos.h>

#include "vcg_ext/core/base/morton.h"
#include "vcg_ext/core/mesh/live_faces.h"
#include "vcg_ext/core/mesh/star_crossings.h"
#include "vcg_ext/ordered/stars.h"

namespace vcg_ext
{

/// Keeps collapses of guarded vertices from making more faces cross, as CrossingCheck does for the sweeps.
/// \tparam Mesh with vertex-face adjacency
template <class Mesh>
class CrossingGuard
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    using Corner = vcg::face::VFIterator<FaceType>;

    using Stars = GuidedStars<Mesh>;

    const Mesh& mesh_;
    std::vector<std::uint8_t> guarded_; ///< one byte a vertex
    LiveFaces live_;
    std::size_t built_ = 0; ///< faces when the boxes were built

  public:
    /// \param guarded not empty \pre the mesh outlives this object
    CrossingGuard(const Mesh& mesh, std::vector<std::uint8_t> guarded)
        : mesh_(mesh), guarded_(std::move(guarded))
    {
    }

    /// Would the merge of both at \p placement, in the frame, make faces cross? \param stars of the mesh
    bool Refuses(const Stars& stars, VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        if (guarded_[IndexOf(removed)] == 0 && guarded_[IndexOf(kept)] == 0) return false;
        if (2 * static_cast<std::size_t>(mesh_.fn) < built_ || built_ == 0) Build(stars);
        ExactStar after, before;
        const auto add = [&](VertexType& center, const VertexType& other, bool addDying) {
            for (Corner corner(&center); !corner.End(); ++corner) {
                const bool dies = corner.V1() == &other || corner.V2() == &other;
                if (!dies || addDying) before.push_back(Face(stars, *corner.F()));
                if (!dies)
                    after.emplace_back(
                        ExactTriangle{placement, At(stars, *corner.V1()), At(stars, *corner.V2())});
            }
        };
        add(removed, kept, true);
        add(kept, removed, false);
        std::optional<BoxedTriangle> other;
        const auto present = [&]() -> const ExactStar& { return before; };
        return MakesCrossings(after, present, live_, [&](std::uint32_t f) {
            const FaceType& face = mesh_.face[f];
            const auto isOf = [&](int k) { return face.cV(k) == &removed || face.cV(k) == &kept; };
            if (face.IsD() || isOf(0) || isOf(1) || isOf(2)) return static_cast<BoxedTriangle*>(nullptr);
            return &other.emplace(Face(stars, face));
        });
    }

    /// The merge will happen.
    void Follow(const Stars& stars, VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        if (guarded_[IndexOf(removed)] != 0) guarded_[IndexOf(kept)] = 1;
        if (built_ == 0) return;
        for (VertexType* center : {&removed, &kept})
            for (Corner corner(center); !corner.End(); ++corner) {
                const BoxedTriangle face(
                    ExactTriangle{placement, At(stars, *corner.V1()), At(stars, *corner.V2())});
                live_.Grow(static_cast<std::uint32_t>(vcg::tri::Index(mesh_, corner.F())), face.box);
            }
    }

  private:
    std::size_t IndexOf(const VertexType& vertex) const { return vcg::tri::Index(mesh_, &vertex); }
    const ExactPoint& At(const Stars& stars, const VertexType& vertex) const
    {
        return stars.end(IndexOf(vertex)).position;
    }
    BoxedTriangle Face(const Stars& stars, const FaceType& face) const
    {
        return BoxedTriangle(
            ExactTriangle{At(stars, *face.cV(0)), At(stars, *face.cV(1)), At(stars, *face.cV(2))});
    }

    void Build(const Stars& stars)
    {
        constexpr double kHalf = kFrameDiagonal / 2;
        const MortonGrid<10> grid({-kHalf, -kHalf, -kHalf}, {kHalf, kHalf, kHalf});
        std::vector<std::pair<std::uint32_t, std::uint32_t>> order; // neighbors in space next to each other
        for (std::uint32_t f = 0; f < mesh_.face.size(); ++f) {
            if (mesh_.face[f].IsD()) continue;
            const ExactPoint& p = At(stars, *mesh_.face[f].cV(0));
            order.emplace_back(grid.Code({p.x, p.y, p.z}), f);
        }
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> alive;
        alive.reserve(order.size());
        for (const auto& [code, face] : order) alive.push_back(face);
        built_ = alive.size();
        live_.Build(std::move(alive), mesh_.face.size(),
                    [&](std::uint32_t f) { return Face(stars, mesh_.face[f]).box; });
    }
};

} // namespace vcg_ext
