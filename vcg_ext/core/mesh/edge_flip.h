// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/wedge_flip.h"

namespace vcg_ext
{

/// Faces that a vertex may gain by flips: the room to make for them.
constexpr std::uint32_t kFlipRoom = 3;

/// An edge a b with the faces (a, b, c) and (b, a, d); the flip makes them (a, d, c) and (b, c, d).
struct FlippableEdge {
    Corner atA, atB; ///< of a in the first face, of b in the second
    std::uint32_t a, b, c, d;

    std::uint32_t First() const { return FaceOf(atA); }
    std::uint32_t Second() const { return FaceOf(atB); }
};

inline bool AreNeighbours(const SurfaceArrays& surface, std::uint32_t v, std::uint32_t w)
{
    if (surface.cornerCount[v] > surface.cornerCount[w]) std::swap(v, w);
    return std::any_of(BeginCorners(surface, v), EndCorners(surface, v),
                       [&](Corner c) { return HasVertex(surface.triangles[FaceOf(c)], w); });
}

/// The edge between \p v and \p w, if it has exactly two faces of opposite direction.
inline std::optional<FlippableEdge> FindInnerEdge(const SurfaceArrays& surface, std::uint32_t v,
                                                  std::uint32_t w)
{
    if (surface.cornerCount[v] > surface.cornerCount[w]) std::swap(v, w);
    int leaving = 0, arriving = 0;
    Corner out = 0, in = 0;
    for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c) {
        if (NextVertex(surface, *c) == w) {
            out = *c;
            ++leaving;
        }
        if (PreviousVertex(surface, *c) == w) {
            in = *c;
            ++arriving;
        }
    }
    if (leaving != 1 || arriving != 1) return std::nullopt;
    return FlippableEdge{out,
                         MakeCorner(FaceOf(in), kPreviousIndex[IndexOf(in)]),
                         v,
                         w,
                         PreviousVertex(surface, out),
                         NextVertex(surface, in)};
}

/// The same, if its faces have different third corners and it may go: an edge between fixed vertices stays,
/// and with it every face that has no other corners. None is made between fixed vertices that other meshes
/// share. Seams stay. That c and d are not neighbours is left to the caller.
inline std::optional<FlippableEdge> FindFlippableEdge(const SurfaceArrays& surface, std::uint32_t v,
                                                      std::uint32_t w)
{
    constexpr std::uint32_t kMinFaces = 3; // around a vertex that has lost one
    if (surface.flags[v] & surface.flags[w] & kFixedVertex) return std::nullopt;
    const std::optional<FlippableEdge> edge = FindInnerEdge(surface, v, w);
    if (!edge) return std::nullopt;
    if (surface.sharedSeams && (surface.flags[edge->c] & surface.flags[edge->d] & kFixedVertex))
        return std::nullopt;
    const auto full = [&](std::uint32_t u) { return surface.cornerCount[u] >= CornerCapacity(surface, u); };
    const bool may = edge->c != edge->d && surface.cornerCount[v] > kMinFaces &&
                     surface.cornerCount[w] > kMinFaces && !full(edge->c) && !full(edge->d);
    if (!may || (surface.wedges && !WedgeFlip(surface, edge->atA, edge->atB).IsAllowed()))
        return std::nullopt;
    return edge;
}

/// \pre the edge is as FindFlippableEdge found it, and c and d are not neighbours
inline void FlipEdge(SurfaceArrays& surface, const FlippableEdge& edge)
{
    if (surface.wedges) WedgeFlip(surface, edge.atA, edge.atB).Flip();
    const Corner atB = MakeCorner(edge.First(), kNextIndex[IndexOf(edge.atA)]);
    const Corner atA = MakeCorner(edge.Second(), kNextIndex[IndexOf(edge.atB)]);
    RemoveCorner(surface, edge.b, atB);
    RemoveCorner(surface, edge.a, atA);
    surface.triangles[edge.First()].v[IndexOf(atB)] = edge.d;
    surface.triangles[edge.Second()].v[IndexOf(atA)] = edge.c;
    AddCorner(surface, edge.d, atB);
    AddCorner(surface, edge.c, atA);
}

} // namespace vcg_ext
