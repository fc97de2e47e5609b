// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"

// The face of a surface that is closest to a point, found by walks from star to star: from where a sample was
// collapsed to, or from where the point was found last. A walk may end at a face that is closest among its
// neighbours only.

namespace vcg_ext
{

/// A place on a surface: one of its vertices, or one of its faces with the highest bit set.
using SurfacePlace = std::uint32_t;
constexpr SurfacePlace kFacePlace = 0x80000000;
inline bool IsFace(SurfacePlace place)
{
    return (place & kFacePlace) != 0;
}

/// Walks go around vertices with more faces than this: searching such a star for every point near it would
/// cost the square of its size.
constexpr std::uint32_t kMaxSearchedStar = 256;
/// Stars that a walk searches.
constexpr std::size_t kMaxWalk = 12;
/// Another face must be closer by this factor of the squared distance.
constexpr float kMinProgress = 1 - 1e-6F;

inline ClosestPoint ClosestOnFace(const SurfaceArrays& surface, const Vector3<float>& p, std::uint32_t face)
{
    const SurfaceTriangle& t = surface.triangles[face];
    const Vector3<float> a = PositionOf(surface, t.v[0]);
    return ClosestOnTriangle(p - a, PositionOf(surface, t.v[1]) - a, PositionOf(surface, t.v[2]) - a);
}

/// The closest face found so far.
struct FaceHit {
    std::uint32_t face = kNone;
    float distance2 = std::numeric_limits<float>::max();
    ClosestPoint closest{};
};

/// From star to star, each around the corner nearest to the closest point so far, none twice.
/// \param start the vertex whose star has been searched: \p hit is its closest face, with its distance
inline FaceHit WalkFromStar(const SurfaceArrays& surface, const Vector3<float>& p, std::uint32_t start,
                            FaceHit hit)
{
    constexpr float kMinWeight = 1e-4F; // a walk goes on at a corner with more than this
    std::array<std::uint32_t, kMaxWalk> seen{start};
    hit.closest = ClosestOnFace(surface, p, hit.face);
    for (std::size_t stars = 1; stars < kMaxWalk; ++stars) {
        std::uint32_t next = kNone;
        float maxWeight = kMinWeight;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = surface.triangles[hit.face].v[k];
            if (hit.closest.weights[k] <= maxWeight || surface.cornerCount[v] > kMaxSearchedStar) continue;
            if (std::find(seen.begin(), seen.begin() + stars, v) != seen.begin() + stars) continue;
            maxWeight = hit.closest.weights[k];
            next = v;
        }
        if (next == kNone) break;
        seen[stars] = next;
        for (const Corner* c = BeginCorners(surface, next); c != EndCorners(surface, next); ++c) {
            const ClosestPoint other = ClosestOnFace(surface, p, FaceOf(*c));
            if (other.distance2 < hit.distance2 * kMinProgress) hit = {FaceOf(*c), other.distance2, other};
        }
    }
    return hit;
}

/// The triangles of four faces of a surface.
inline FourTriangles LoadFaces(const SurfaceArrays& surface, const std::uint32_t* faces)
{
    const auto corner = [&](int k) {
        const auto at = [&](int lane) { return &surface.points[surface.triangles[faces[lane]].v[k]].x; };
        Vector3<Float4> q;
        Float4 weight;
        LoadTransposed(at(0), at(1), at(2), at(3), q.x, q.y, q.z, weight);
        return q;
    };
    const Vector3<Float4> a = corner(0);
    return {a, corner(1) - a, corner(2) - a};
}

/// Closest points by walks from remembered places, four at a time where these are still right.
class PlaceSearch
{
    static constexpr float kInside = 1e-3F; ///< with larger barycentric coordinates the walk is over

    const SurfaceArrays& surface_;

  public:
    /// Of four points: squared distance, vector to the closest point, and whether there is one.
    struct FourHits {
        Float4 distance2;
        Vector3<Float4> residual;
        Int4 found;
    };

    explicit PlaceSearch(const SurfaceArrays& surface) : surface_(surface) {}

    /// The closest places that walks from the hints find; the hints become their faces.
    FourHits Find(const Vector3<Float4>& points, SurfacePlace* const* hints) const
    {
        FourHits hits = TestHints(points, hints);
        const int done = LaneBits(hits.found);
        for (int lane = 0; lane < kLanes; ++lane) {
            if (done >> lane & 1) continue;
            const Vector3<float> p = Lane(points, lane);
            const FaceHit hit = Walk(p, *hints[lane]);
            if (hit.face == kNone) continue;
            *hints[lane] = hit.face | kFacePlace;
            hits.distance2[lane] = hit.distance2;
            SetLane(hits.residual, lane, Residual(p, hit));
            hits.found[lane] = -1;
        }
        return hits;
    }

  private:
    static bool IsInside(const ClosestPoint& closest)
    {
        return closest.weights[0] > kInside && closest.weights[1] > kInside && closest.weights[2] > kInside;
    }
    /// Most points are still over the face found last: found where that is so.
    FourHits TestHints(const Vector3<Float4>& points, SurfacePlace* const* hints) const
    {
        std::uint32_t faces[kLanes];
        Int4 known;
        for (int lane = 0; lane < kLanes; ++lane) {
            const SurfacePlace hint = *hints[lane];
            known[lane] = IsFace(hint) ? -1 : 0;
            faces[lane] = IsFace(hint) ? hint & ~kFacePlace : 0;
        }
        const auto [a, b, c] = LoadFaces(surface_, faces);
        const Vector3<Float4> p = points - a;
        const Vector3<Float4> n = Cross(b, c);
        const Float4 bb = SquaredNorm(b), cc = SquaredNorm(c), n2 = SquaredNorm(n);
        const Float4 bc = Dot(b, c), pb = Dot(p, b), pc = Dot(p, c);
        const Float4 wb = cc * pb - bc * pc, wc = bb * pc - bc * pb, least = kInside * n2; // x determinant
        const Int4 proper = n2 > Max(kFlattestSine2 * bb * cc, Splat(kSmallestSquare));
        const Float4 height = Dot(p, n) / Max(n2, Splat(kSmallestSquare));
        FourHits hits;
        hits.found = known & proper & (wb > least) & (wc > least) & (n2 - wb - wc > least);
        hits.distance2 = height * height * n2;
        hits.residual = -height * n;
        return hits;
    }
    FaceHit Walk(const Vector3<float>& p, SurfacePlace hint) const
    {
        FaceHit hit;
        std::uint32_t around = hint;
        if (IsFace(hint)) {
            hit.face = hint & ~kFacePlace;
            hit.closest = ClosestOnFace(surface_, p, hit.face);
            hit.distance2 = hit.closest.distance2;
            around = NearestCorner(hit);
        }
        for (std::size_t star = 0; star < kMaxWalk && around != kNone; ++star) {
            if (!SearchStar(p, around, hit)) break;
            hit.closest = ClosestOnFace(surface_, p, hit.face);
            hit.distance2 = hit.closest.distance2; // not by the other form: the same face, the same answer
            if (IsInside(hit.closest)) break;
            const std::uint32_t next = NearestCorner(hit);
            if (next == around) break;
            around = next;
        }
        return hit;
    }
    /// From \p p to the closest point; along the normal of the face where it lies inside.
    Vector3<float> Residual(const Vector3<float>& p, const FaceHit& hit) const
    {
        const SurfaceTriangle& t = surface_.triangles[hit.face];
        const Vector3<float> a = PositionOf(surface_, t.v[0]);
        const Vector3<float> b = PositionOf(surface_, t.v[1]) - a, c = PositionOf(surface_, t.v[2]) - a;
        const Vector3<float> query = p - a;
        if (!IsInside(hit.closest)) return hit.closest.weights[1] * b + hit.closest.weights[2] * c - query;
        const Vector3<float> normal = Cross(b, c);
        const float normal2 = SquaredNorm(normal);
        return normal2 > 0 ? (-Dot(query, normal) / normal2) * normal : Vector3<float>{};
    }
    /// The corner nearest to the closest point, or kNone where its star is too large to be searched.
    std::uint32_t NearestCorner(const FaceHit& hit) const
    {
        const float* w = hit.closest.weights;
        const std::size_t k = w[1] > w[0] ? (w[2] > w[1] ? 2 : 1) : (w[2] > w[0] ? 2 : 0);
        const std::uint32_t v = surface_.triangles[hit.face].v[k];
        return surface_.cornerCount[v] <= kMaxSearchedStar ? v : kNone;
    }
    /// Four faces at once; true where one is closer than \p hit, which it then is.
    bool SearchStar(const Vector3<float>& p, std::uint32_t v, FaceHit& hit) const
    {
        const Corner* corners = BeginCorners(surface_, v);
        const std::size_t count = surface_.cornerCount[v];
        bool found = false;
        for (std::size_t i = 0; i < count; i += kLanes) {
            std::uint32_t faces[kLanes];
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                faces[lane] = FaceOf(corners[std::min(i + lane, count - 1)]);
            const FourTriangles four = LoadFaces(surface_, faces);
            const Float4 distance2 = ClosestOnTriangle(four.Seen(p), four.Prepared()).distance2;
            if (!AnyLane(distance2 < Splat(hit.distance2 * kMinProgress))) continue;
            for (int lane = 0; lane < kLanes; ++lane) {
                if (!(distance2[lane] < hit.distance2 * kMinProgress)) continue;
                hit.distance2 = distance2[lane];
                hit.face = faces[lane];
                found = true;
            }
        }
        return found;
    }
};

/// Does a face with that normal face away from the face of \p original that was found below it?
inline bool FacesAwayFrom(const SurfaceArrays& original, SurfacePlace below, const Vector3<float>& normal)
{
    return below != kNone && IsFace(below) && Dot(AreaVector(original, below & ~kFacePlace), normal) < 0;
}

} // namespace vcg_ext
