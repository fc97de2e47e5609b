// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

// Planes perpendicular to the open border, through each of its edges, with the squared length as weight. They
// belong to the quadrics of both ends of the edge.

/// The border plane of the edge between \p a and \p b of \p face. \pre the edge has one face
inline SymmetricMatrix3<float> BorderPlane(const SweepState& state, const FaceRecord& face, std::uint32_t a,
                                           std::uint32_t b)
{
    return PerpendicularPlane(face.Normal(), state.Position(b) - state.Position(a));
}

/// Sum of the border planes of the edges at \p v.
inline SymmetricMatrix3<float> BorderPlanesAt(const SweepState& state, std::uint32_t v)
{
    SymmetricMatrix3<float> sum{};
    const Corner* list = state.CornersOf(v);
    for (std::uint32_t i = 0; i < state.cornerCount[v]; ++i) {
        const std::uint32_t ends[2] = {state.Next(list[i]), state.Previous(list[i])};
        for (const std::uint32_t w : ends)
            if (w != v && FacesOnEdge(state, v, w) == 1)
                sum = sum + BorderPlane(state, state.faces[FaceOf(list[i])], v, w);
    }
    return sum;
}

/// Adds \p sign times the border planes of the face's edges to the star quadrics of their ends.
inline void AddBorderPlanes(SweepState& state, std::uint32_t face, float sign)
{
    const FaceRecord& record = state.faces[face];
    for (int j = 0; j < 3; ++j) {
        const std::uint32_t a = record.v[j], b = record.v[kNextIndex[j]];
        if (!state.Has(a, kBorderVertex) || !state.Has(b, kBorderVertex)) continue;
        if (FacesOnEdge(state, a, b) != 1) continue;
        const SymmetricMatrix3<float> plane = sign * BorderPlane(state, record, a, b);
        state.vertices[a].AddToStar(plane);
        state.vertices[b].AddToStar(plane);
    }
}

} // namespace vcg_ext
