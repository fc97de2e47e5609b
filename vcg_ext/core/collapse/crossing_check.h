// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/crossing_triangles.h"
#include "vcg_ext/core/mesh/live_faces.h"

namespace vcg_ext
{

/// What the collapses must know so that no faces cross each other where it is asked for.
///
/// A collapse is tested against whatever lies nearby, so those of guarded vertices wait for the end of a
/// sweep, when there is one thread and the boxes of all faces are known.
struct CollapseCrossings {
    Buffer<std::uint8_t> guarded; ///< one byte a vertex
    bool isOpen = false;          ///< guarded vertices may be merged now
    LiveFaces live;               ///< up to date while that is so

    bool Guards(std::uint32_t v, std::uint32_t w) const { return guarded[v] != 0 || guarded[w] != 0; }
};

/// Would the gathered collapse make faces cross?
class CrossingCheck
{
    using Faces = std::vector<std::pair<ExactTriangle, Box3<float>>>;

    SweepState& state_;
    const StarScratch& star_;
    std::uint32_t removed_, survivor_;

  public:
    CrossingCheck(SweepState& state, const StarScratch& star, std::uint32_t removed, std::uint32_t survivor)
        : state_(state), star_(star), removed_(removed), survivor_(survivor)
    {
    }

    /// Opens the state's guarded vertices to merges. \pre no other thread works on the state from here on
    static void Open(SweepState& state)
    {
        std::vector<std::uint32_t> alive;
        for (std::uint32_t f = 0; f < state.faces.size(); ++f)
            if (state.faces[f].Alive()) alive.push_back(f);
        state.crossings->live.Build(std::move(alive), state.faces.size(),
                                    [&](std::uint32_t f) { return BoxOf(state, f); });
        state.crossings->isOpen = true;
    }

    /// Do more pairs of faces cross with the new vertex at \p placement than do now?
    bool MakesCrossings(const Vector3<float>& placement) const
    {
        constexpr std::size_t kAll = ~std::size_t{0};
        Faces after, before;
        for (std::uint32_t i = 0; i < star_.kept; ++i)
            Add(after, placement, state_.Position(star_.next[i]), state_.Position(star_.previous[i]));
        if (CountCrossings(after, 1) == 0) return false;
        for (std::uint32_t i = 0; i < star_.kept; ++i) AddPresent(before, FaceOf(star_.corner[i]));
        for (std::uint32_t i = 0; i < star_.dead; ++i) AddPresent(before, star_.deadFace[i]);
        const std::size_t present = CountCrossings(before, kAll);
        return present == 0 || CountCrossings(after, present + 1) > present;
    }

    /// The collapse has happened: the boxes follow. \param survivor the vertex that is left
    static void Follow(SweepState& state, const StarScratch& star, std::uint32_t removed,
                       std::uint32_t survivor)
    {
        CollapseCrossings& crossings = *state.crossings;
        if (crossings.guarded[removed] != 0) crossings.guarded[survivor] = 1;
        if (!crossings.isOpen) return;
        for (std::uint32_t i = 0; i < star.kept; ++i) {
            const std::uint32_t face = FaceOf(star.corner[i]);
            crossings.live.Grow(face, BoxOf(state, face));
        }
    }

  private:
    static Box3<float> BoxOf(const SweepState& state, std::uint32_t face)
    {
        Box3<float> box = EmptyBox<float>();
        for (const std::uint32_t v : state.faces[face].v) box.Add(state.Position(v));
        return box;
    }
    static ExactPoint Exact(const Vector3<float>& p)
    {
        return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    }
    static void Add(Faces& faces, const Vector3<float>& a, const Vector3<float>& b, const Vector3<float>& c)
    {
        Box3<float> box = EmptyBox<float>();
        for (const Vector3<float>& p : {a, b, c}) box.Add(p);
        faces.push_back({{Exact(a), Exact(b), Exact(c)}, box});
    }
    void AddPresent(Faces& faces, std::uint32_t face) const
    {
        const std::uint32_t* v = state_.faces[face].v;
        Add(faces, state_.Position(v[0]), state_.Position(v[1]), state_.Position(v[2]));
    }

    bool IsInStar(std::uint32_t face) const
    {
        for (const std::uint32_t v : state_.faces[face].v)
            if (v == removed_ || v == survivor_) return true;
        return false;
    }

    /// Pairs of faces of the star, and of one with one that stays as it is; \p enough where there are so
    /// many.
    std::size_t CountCrossings(const Faces& star, std::size_t enough) const
    {
        std::size_t count = 0;
        Box3<float> around = EmptyBox<float>();
        for (std::size_t i = 0; i < star.size() && count < enough; ++i) {
            around.Add(star[i].second.low);
            around.Add(star[i].second.high);
            for (std::size_t k = 0; k < i; ++k) count += TrianglesCross(star[i].first, star[k].first);
        }
        Faces other;
        state_.crossings->live.ForEachNear(around, [&](std::uint32_t face) {
            if (count >= enough || !state_.faces[face].Alive() || IsInStar(face)) return;
            other.clear();
            AddPresent(other, face);
            for (const auto& [triangle, box] : star)
                if (box.Meets(other[0].second)) count += TrianglesCross(triangle, other[0].first);
        });
        return count;
    }
};

} // namespace vcg_ext
