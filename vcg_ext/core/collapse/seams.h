// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "vcg_ext/core/attributes/wedge_set.h"
#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

// Seam edges of the state, and the planes perpendicular to both faces of each, through the edge, with half
// the squared length as weight. They belong to the quadrics of both ends of the edge. Without them a curved
// seam between charts that are both affine would straighten for nothing.

/// The corner of \p v in the one other face on the edge from \p corner's vertex v to the next; nothing
/// where the edge does not have exactly two faces.
inline std::optional<Corner> CornerAcross(const SweepState& state, Corner corner)
{
    const std::uint32_t v = state.faces[FaceOf(corner)].v[IndexOf(corner)], w = state.Next(corner);
    const Corner* list = state.CornersOf(v);
    std::optional<Corner> across;
    for (std::uint32_t i = 0; i < state.cornerCount[v]; ++i) {
        const Corner c = list[i];
        if (FaceOf(c) == FaceOf(corner) || (state.Next(c) != w && state.Previous(c) != w)) continue;
        if (across) return std::nullopt;
        across = c;
    }
    return across;
}

/// Is the edge from \p corner's vertex to the next a seam?
inline bool IsSeam(const SweepState& state, const WedgeSet& wedges, Corner corner)
{
    const std::optional<Corner> across = CornerAcross(state, corner);
    if (!across) return false;
    const Corner next = MakeCorner(FaceOf(corner), kNextIndex[IndexOf(corner)]);
    const int index = IndexOf(*across);
    const bool follows = state.Next(*across) == state.Next(corner);
    const Corner nextAcross =
        MakeCorner(FaceOf(*across), follows ? kNextIndex[index] : kPreviousIndex[index]);
    return wedges.Of(corner) != wedges.Of(*across) || wedges.Of(next) != wedges.Of(nextAcross);
}

/// Adds \p sign times the seam planes of the face's edges to the star quadrics of their ends.
inline void AddSeamPlanes(SweepState& state, const WedgeSet& wedges, std::uint32_t face, float sign)
{
    constexpr float kSeamWeight = 0.5f; // of each of two faces; a border has 1 and one face
    const FaceRecord& record = state.faces[face];
    for (int j = 0; j < 3; ++j) {
        const std::uint32_t a = record.v[j], b = record.v[kNextIndex[j]];
        if (!state.Has(a, kSeamVertex) || !state.Has(b, kSeamVertex)) continue;
        if (!IsSeam(state, wedges, MakeCorner(face, j))) continue;
        const Vector3<float> edge = state.Position(b) - state.Position(a);
        const SymmetricMatrix3<float> plane = sign * kSeamWeight * PerpendicularPlane(record.Normal(), edge);
        state.vertices[a].AddToStar(plane);
        state.vertices[b].AddToStar(plane);
    }
}

/// Sum of the seam planes of the edges at \p v.
inline SymmetricMatrix3<float> SeamPlanesAt(const SweepState& state, const WedgeSet& wedges, std::uint32_t v)
{
    constexpr float kSeamWeight = 0.5f;
    SymmetricMatrix3<float> sum{};
    const Corner* list = state.CornersOf(v);
    const auto add = [&](Corner corner, std::uint32_t other) {
        if (!state.Has(other, kSeamVertex) || !IsSeam(state, wedges, corner)) return;
        const Vector3<float> edge = state.Position(other) - state.Position(v);
        sum = sum + kSeamWeight * PerpendicularPlane(state.faces[FaceOf(corner)].Normal(), edge);
    };
    for (std::uint32_t i = 0; i < state.cornerCount[v]; ++i) {
        add(list[i], state.Next(list[i]));
        add(MakeCorner(FaceOf(list[i]), kPreviousIndex[IndexOf(list[i])]), state.Previous(list[i]));
    }
    return sum;
}

/// The marks of \p v: kSeamVertex where a seam edge ends at it, kSeamCorner too unless it is an inner vertex
/// of a single seam, away from all borders.
inline std::uint8_t SeamMarks(const SweepState& state, const WedgeSet& wedges, std::uint32_t v)
{
    const Corner* list = state.CornersOf(v);
    int sides = 0; // every seam edge counts once from each of its faces
    for (std::uint32_t i = 0; i < state.cornerCount[v]; ++i) {
        sides += IsSeam(state, wedges, list[i]);
        sides += IsSeam(state, wedges, MakeCorner(FaceOf(list[i]), kPreviousIndex[IndexOf(list[i])]));
    }
    if (sides == 0) return 0;
    constexpr int kInner = 4;
    const bool corner = sides != kInner || state.Has(v, kBorderVertex);
    return corner ? std::uint8_t{kSeamVertex | kSeamCorner} : std::uint8_t{kSeamVertex};
}

inline void SetSeamMarks(SweepState& state, std::uint32_t v, std::uint8_t marks)
{
    constexpr int kBoth = kSeamVertex | kSeamCorner;
    state.flags[v] = static_cast<std::uint8_t>((state.flags[v] & ~kBoth) | marks);
}

} // namespace vcg_ext
