// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/refine/equations.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/star.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/mesh/surface_arrays.h"
#include "vcg_ext/core/mesh/surface_corners.h"

namespace vcg_ext::refinement
{

/// Four points of the simplified surface whose distances to the original count. Lanes behind the last repeat
/// it with weight 0.
struct BackwardGroup {
    Vector3<Float4> position; ///< in the frame of the arrays
    Float4 weight;            ///< area, times the weight of the backward term
    Float4 leverage;          ///< part of the vertex's step that the point makes
    Place* hint[4];           ///< face of the original found last, or where to look first
};

class BackwardPoints
{
    Scratch<BackwardGroup> groups_;
    std::size_t count_ = 0;

  public:
    void Clear()
    {
        groups_.Clear();
        count_ = 0;
    }
    void Add(const Vector3<float>& position, float weight, float leverage, Place* hint)
    {
        const int lane = static_cast<int>(count_++ % kLanes);
        BackwardGroup& group = lane == 0 ? groups_.Append() : groups_[groups_.size() - 1];
        for (int i = lane; i < kLanes; ++i) {
            group.position.x[i] = position.x;
            group.position.y[i] = position.y;
            group.position.z[i] = position.z;
            group.weight[i] = i == lane ? weight : 0;
            group.leverage[i] = leverage;
            group.hint[i] = hint;
        }
    }
    const BackwardGroup* begin() { return groups_.begin(); }
    const BackwardGroup* end() { return groups_.end(); }
};

/// The triangles of four faces of a surface, each seen from its first corner, and a point of each.
struct FourFaces {
    Vector3<Float4> point, b, c;
};
inline FourFaces LoadFaces(const SurfaceArrays& surface, const std::uint32_t* faces, const Vector3<Float4>& p)
{
    const auto corner = [&](int k) {
        const auto at = [&](int lane) { return &surface.points[surface.triangles[faces[lane]].v[k]].x; };
        Vector3<Float4> q;
        Float4 weight;
        LoadTransposed(at(0), at(1), at(2), at(3), q.x, q.y, q.z, weight);
        return q;
    };
    const Vector3<Float4> a = corner(0), b = corner(1), c = corner(2);
    return {{p.x - a.x, p.y - a.y, p.z - a.z},
            {b.x - a.x, b.y - a.y, b.z - a.z},
            {c.x - a.x, c.y - a.y, c.z - a.z}};
}

/// Squared distances to the original surface by walks over its stars from a remembered place.
class BackwardSearch
{
    static constexpr int kLongestWalk = 12;
    static constexpr float kInside = 1e-3F; ///< with larger barycentric coordinates the walk is over
    static constexpr float kLeastProgress = 1 - 1e-6F;

    const SurfaceArrays& original_;

    struct Hit {
        float distance2 = std::numeric_limits<float>::max();
        ClosestPoint closest{};
        std::uint32_t face = kNone;
    };

  public:
    /// Of four points: squared distance, vector to the closest point, and whether there is one.
    struct FourHits {
        Float4 distance2;
        Vector3<Float4> residual;
        Int4 found;
    };

    explicit BackwardSearch(const SurfaceArrays& original) : original_(original) {}

    /// The closest places that walks from the hints find; the hints become their faces.
    FourHits Find(const Vector3<Float4>& points, Place* const* hints) const
    {
        FourHits hits = TestHints(points, hints);
        const int done = LaneBits(hits.found);
        for (int lane = 0; lane < kLanes; ++lane) {
            if (done >> lane & 1) continue;
            const Vector3<float> p{points.x[lane], points.y[lane], points.z[lane]};
            const Hit hit = Walk(p, *hints[lane]);
            if (hit.face == kNone) continue;
            *hints[lane] = hit.face | kFacePlace;
            const Vector3<float> residual = Residual(p, hit);
            hits.distance2[lane] = hit.distance2;
            hits.residual.x[lane] = residual.x;
            hits.residual.y[lane] = residual.y;
            hits.residual.z[lane] = residual.z;
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
    FourHits TestHints(const Vector3<Float4>& points, Place* const* hints) const
    {
        std::uint32_t faces[kLanes];
        Int4 known;
        for (int lane = 0; lane < kLanes; ++lane) {
            const Place hint = *hints[lane];
            known[lane] = IsFace(hint) ? -1 : 0;
            faces[lane] = IsFace(hint) ? hint & ~kFacePlace : 0;
        }
        const auto [p, b, c] = LoadFaces(original_, faces, points);
        const Vector3<Float4> n{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
        const Float4 bb = SquaredNorm(b), cc = SquaredNorm(c), n2 = SquaredNorm(n);
        const Float4 bc = b.x * c.x + b.y * c.y + b.z * c.z;
        const Float4 pb = p.x * b.x + p.y * b.y + p.z * b.z, pc = p.x * c.x + p.y * c.y + p.z * c.z;
        const Float4 wb = cc * pb - bc * pc, wc = bb * pc - bc * pb, least = kInside * n2; // x determinant
        const Int4 proper = n2 > Max(kFlattestSine2 * bb * cc, Splat(kSmallestSquare));
        const Float4 height = (p.x * n.x + p.y * n.y + p.z * n.z) / Max(n2, Splat(kSmallestSquare));
        FourHits hits;
        hits.found = known & proper & (wb > least) & (wc > least) & (n2 - wb - wc > least);
        hits.distance2 = height * height * n2;
        hits.residual = {-height * n.x, -height * n.y, -height * n.z};
        return hits;
    }
    Hit Walk(const Vector3<float>& p, Place hint) const
    {
        Hit hit;
        std::uint32_t around = hint;
        if (IsFace(hint)) {
            hit.face = hint & ~kFacePlace;
            hit.closest = ClosestOnFace(p, hit.face);
            hit.distance2 = hit.closest.distance2;
            around = NearestCorner(hit);
        }
        for (int star = 0; star < kLongestWalk && around != kNone; ++star) {
            if (!SearchStar(p, around, hit)) break;
            hit.closest = ClosestOnFace(p, hit.face);
            hit.distance2 = hit.closest.distance2; // not by the other form: the same face, the same answer
            if (IsInside(hit.closest)) break;
            const std::uint32_t next = NearestCorner(hit);
            if (next == around) break;
            around = next;
        }
        return hit;
    }
    /// From \p p to the closest point; along the normal of the face where it lies inside.
    Vector3<float> Residual(const Vector3<float>& p, const Hit& hit) const
    {
        const SurfaceTriangle& t = original_.triangles[hit.face];
        const Vector3<float> a = PositionOf(original_, t.v[0]);
        const Vector3<float> b = PositionOf(original_, t.v[1]) - a, c = PositionOf(original_, t.v[2]) - a;
        const Vector3<float> query = p - a;
        if (!IsInside(hit.closest)) return hit.closest.weights[1] * b + hit.closest.weights[2] * c - query;
        const Vector3<float> normal = Cross(b, c);
        const float normal2 = SquaredNorm(normal);
        return normal2 > 0 ? (-Dot(query, normal) / normal2) * normal : Vector3<float>{};
    }
    ClosestPoint ClosestOnFace(const Vector3<float>& p, std::uint32_t face) const
    {
        const SurfaceTriangle& t = original_.triangles[face];
        const Vector3<float> a = PositionOf(original_, t.v[0]);
        return ClosestOnTriangle(p - a, PositionOf(original_, t.v[1]) - a, PositionOf(original_, t.v[2]) - a);
    }
    /// The corner nearest to the closest point, or kNone where its star is too large to be searched.
    std::uint32_t NearestCorner(const Hit& hit) const
    {
        const float* w = hit.closest.weights;
        const std::size_t k = w[1] > w[0] ? (w[2] > w[1] ? 2 : 1) : (w[2] > w[0] ? 2 : 0);
        const std::uint32_t v = original_.triangles[hit.face].v[k];
        return original_.cornerCount[v] <= kLargestSearchedStar ? v : kNone;
    }
    /// Four faces at once; true where one is closer than \p hit, which it then is.
    bool SearchStar(const Vector3<float>& p, std::uint32_t v, Hit& hit) const
    {
        const Corner* corners = BeginCorners(original_, v);
        const std::size_t count = original_.cornerCount[v];
        const Vector3<Float4> query{Splat(p.x), Splat(p.y), Splat(p.z)};
        bool found = false;
        for (std::size_t i = 0; i < count; i += kLanes) {
            std::uint32_t faces[kLanes];
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                faces[lane] = FaceOf(corners[std::min(i + lane, count - 1)]);
            const FourFaces four = LoadFaces(original_, faces, query);
            const auto triangles =
                PrepareTriangle(four.b.x, four.b.y, four.b.z, four.c.x, four.c.y, four.c.z);
            const Float4 distance2 = ClosestOnTriangle(four.point, triangles).distance2;
            if (!AnyLane(distance2 < Splat(hit.distance2 * kLeastProgress))) continue;
            for (int lane = 0; lane < kLanes; ++lane) {
                if (!(distance2[lane] < hit.distance2 * kLeastProgress)) continue;
                hit.distance2 = distance2[lane];
                hit.face = faces[lane];
                found = true;
            }
        }
        return found;
    }
};

/// Does a face with that normal look away from the face of \p original that was found below it?
inline bool LooksAway(const SurfaceArrays& original, Place below, const Vector3<float>& normal)
{
    return below != kNone && IsFace(below) && Dot(AreaVector(original, below & ~kFacePlace), normal) < 0;
}

/// The energy of some backward points and their largest squared distance.
struct BackwardEnergy {
    double energy = 0;
    float largest2 = 0;
};

/// Sum of weight x squared distance, the points moved by their part of \p step.
/// \param limit2 squared distances count at most this much, and such points do not enter \p equations
/// \param stop the sum ends where it is larger
/// \param equations may be null
inline BackwardEnergy MeasureBackward(const BackwardSearch& search, BackwardPoints& points,
                                      const Vector3<float>& step, float limit2, double stop,
                                      EquationSums* equations)
{
    constexpr float kSmallestResidual2 = 1e-14F; // below, a residual has no direction
    BackwardEnergy sum;
    Float4 largest = Splat(0.0F);
    for (const BackwardGroup& group : points) {
        const Vector3<Float4> position{group.position.x + group.leverage * step.x,
                                       group.position.y + group.leverage * step.y,
                                       group.position.z + group.leverage * step.z};
        const BackwardSearch::FourHits hits = search.Find(position, group.hint);
        const Float4 distance2 = OrZero(hits.found, Min(hits.distance2, Splat(limit2)));
        largest = Max(largest, distance2);
        sum.energy += static_cast<double>(SumLanes(group.weight * distance2));
        if (equations) {
            const Float4 length2 = SquaredNorm(hits.residual);
            const Int4 counts =
                hits.found & (hits.distance2 <= Splat(limit2)) & (length2 > Splat(kSmallestResidual2));
            const Float4 inverse = 1.0F / Sqrt(Max(length2, Splat(kSmallestResidual2)));
            const Vector3<Float4> r{OrZero(counts, hits.residual.x), OrZero(counts, hits.residual.y),
                                    OrZero(counts, hits.residual.z)};
            equations->Add(OrZero(counts, group.weight * group.leverage), group.leverage,
                           {inverse * r.x, inverse * r.y, inverse * r.z}, r);
        }
        if (sum.energy > stop) break;
    }
    sum.largest2 = MaxLane(largest);
    return sum;
}

} // namespace vcg_ext::refinement
