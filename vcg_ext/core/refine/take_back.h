// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/edge_flip.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/parameters.h"

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

} // namespace vcg_ext
