// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/geometry/crossing_triangles.h"
#include "vcg_ext/core/mesh/live_faces.h"
#include "vcg_ext/core/mesh/star_crossings.h"

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
                                    [&](std::uint32_t f) { return Face(state, f).box; });
        state.crossings->isOpen = true;
    }

    /// Do more pairs of faces cross with the new vertex at \p placement than do now?
    bool MakesCrossings(const Vector3<float>& placement) const
    {
        ExactStar after;
        for (std::uint32_t i = 0; i < star_.kept; ++i)
            after.push_back(
                Triangle(placement, state_.Position(star_.next[i]), state_.Position(star_.previous[i])));
        const auto before = [&] {
            ExactStar present;
            for (std::uint32_t i = 0; i < star_.kept; ++i)
                present.push_back(Face(state_, FaceOf(star_.corner[i])));
            for (std::uint32_t i = 0; i < star_.dead; ++i) present.push_back(Face(state_, star_.deadFace[i]));
            return present;
        };
        std::optional<BoxedTriangle> other;
        return vcg_ext::MakesCrossings(after, before, state_.crossings->live, [&](std::uint32_t face) {
            if (!state_.faces[face].Alive() || IsInStar(face)) return static_cast<BoxedTriangle*>(nullptr);
            return &other.emplace(Face(state_, face));
        });
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
            crossings.live.Grow(face, Face(state, face).box);
        }
    }

  private:
    static BoxedTriangle Triangle(const Vector3<float>& a, const Vector3<float>& b, const Vector3<float>& c)
    {
        const auto exact = [](const Vector3<float>& p) {
            return ExactPoint{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        };
        return BoxedTriangle({exact(a), exact(b), exact(c)});
    }
    static BoxedTriangle Face(const SweepState& state, std::uint32_t face)
    {
        const std::uint32_t* v = state.faces[face].v;
        return Triangle(state.Position(v[0]), state.Position(v[1]), state.Position(v[2]));
    }

    bool IsInStar(std::uint32_t face) const
    {
        const std::uint32_t* v = state_.faces[face].v;
        return std::any_of(v, v + 3, [&](std::uint32_t w) { return w == removed_ || w == survivor_; });
    }
};

} // namespace vcg_ext
