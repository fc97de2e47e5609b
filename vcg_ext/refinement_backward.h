// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "point_triangle.h"
#include "refinement_samples.h"
#include "refinement_star.h"
#include "simd.h"
#include "surface_arrays.h"
#include "surface_corners.h"

namespace vcg_ext::refinement
{

/// The sums of a least-squares step: (sum w b^2 n n^T) x = sum w b d, with b the part of the step that the
/// point makes, d its residual and n the direction of it.
struct NormalEquations {
    float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    Vector3 right;

    void Add(float weight, float leverage, const Vector3& residual)
    {
        const float length2 = SquaredNorm(residual);
        if (!(length2 > kSmallestResidual2)) return;
        const float s = weight * leverage * leverage / length2;
        xx += s * residual.x * residual.x;
        xy += s * residual.x * residual.y;
        xz += s * residual.x * residual.z;
        yy += s * residual.y * residual.y;
        yz += s * residual.y * residual.z;
        zz += s * residual.z * residual.z;
        right = right + (weight * leverage) * residual;
    }

    /// Residuals below this say nothing about their direction.
    static constexpr float kSmallestResidual2 = 1e-14F;
};

/// A point of the simplified surface whose distance to the original counts.
struct BackwardPoint {
    Vector3 position; ///< in the frame of the arrays
    float weight;     ///< area, times the weight of the backward term
    float leverage;   ///< part of the vertex's step that the point makes
    Place* hint;      ///< face of the original found last, or where to look first
};
using BackwardPoints = Scratch<BackwardPoint>;

/// Squared distances to the original surface by walks over its stars from a remembered place.
class BackwardSearch
{
    static constexpr int kLongestWalk = 12;
    static constexpr float kInside = 1e-3F; ///< with larger barycentric coordinates the walk is over
    static constexpr float kLeastProgress = 1 - 1e-6F;

    const SurfaceArrays& original_;

  public:
    struct Hit {
        float distance2 = std::numeric_limits<float>::max(); ///< unchanged where nothing was found
        ClosestPoint closest{};
        std::uint32_t face = kNone;
    };

    explicit BackwardSearch(const SurfaceArrays& original) : original_(original) {}

    /// The closest place that the walk from \p hint finds; \p hint becomes its face. \pre hint is a place
    Hit Find(const Vector3& p, Place& hint) const
    {
        Hit hit;
        std::uint32_t around = hint;
        if (IsFace(hint)) {
            hit.face = hint & ~kFacePlace;
            hit.closest = ClosestOnFace(p, hit.face);
            hit.distance2 = hit.closest.distance2;
            if (IsInside(hit.closest)) return hit;
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
        if (hit.face != kNone) hint = hit.face | kFacePlace;
        return hit;
    }

    /// From \p p to the closest point of \p hit; along the normal of the face where it lies inside.
    Vector3 Residual(const Vector3& p, const Hit& hit) const
    {
        const SurfaceTriangle& t = original_.triangles[hit.face];
        const Vector3 a = PositionOf(original_, t.v[0]);
        const Vector3 b = PositionOf(original_, t.v[1]) - a, c = PositionOf(original_, t.v[2]) - a;
        const Vector3 query = p - a;
        if (!IsInside(hit.closest)) return hit.closest.weights[1] * b + hit.closest.weights[2] * c - query;
        const Vector3 normal = Cross(b, c);
        const float normal2 = SquaredNorm(normal);
        return normal2 > 0 ? (-Dot(query, normal) / normal2) * normal : Vector3{};
    }

  private:
    static bool IsInside(const ClosestPoint& closest)
    {
        return closest.weights[0] > kInside && closest.weights[1] > kInside && closest.weights[2] > kInside;
    }
    ClosestPoint ClosestOnFace(const Vector3& p, std::uint32_t face) const
    {
        const SurfaceTriangle& t = original_.triangles[face];
        const Vector3 a = PositionOf(original_, t.v[0]);
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
    bool SearchStar(const Vector3& p, std::uint32_t v, Hit& hit) const
    {
        const Corner* corners = BeginCorners(original_, v);
        const std::size_t count = original_.cornerCount[v];
        bool found = false;
        for (std::size_t i = 0; i < count; i += kLanes) {
            std::uint32_t faces[kLanes];
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                faces[lane] = FaceOf(corners[std::min(i + lane, count - 1)]);
            const Float4 distance2 = DistancesToFaces(p, faces);
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
    FourPoints LoadCorners(const std::uint32_t* faces, int k) const
    {
        const auto at = [&](int lane) { return &original_.points[original_.triangles[faces[lane]].v[k]].x; };
        FourPoints p;
        Float4 weight;
        LoadTransposed(at(0), at(1), at(2), at(3), p.x, p.y, p.z, weight);
        return p;
    }
    Float4 DistancesToFaces(const Vector3& p, const std::uint32_t* faces) const
    {
        const FourPoints a = LoadCorners(faces, 0), b = LoadCorners(faces, 1), c = LoadCorners(faces, 2);
        const auto triangle =
            PrepareTriangle(b.x - a.x, b.y - a.y, b.z - a.z, c.x - a.x, c.y - a.y, c.z - a.z);
        return ClosestOnTriangle(FourPoints{p.x - a.x, p.y - a.y, p.z - a.z}, triangle).distance2;
    }
};

/// The energy of some backward points, their largest squared distance.
struct BackwardEnergy {
    double energy = 0;
    float largest2 = 0;
};

/// Sum of weight x squared distance.
/// \param limit2 squared distances count at most this much, and such points do not enter \p equations
/// \param stop the sum ends where it is larger
/// \param equations may be null
inline BackwardEnergy MeasureBackward(const BackwardSearch& search, BackwardPoints& points, float limit2,
                                      double stop, NormalEquations* equations)
{
    BackwardEnergy sum;
    for (const BackwardPoint& point : points) {
        const BackwardSearch::Hit hit = search.Find(point.position, *point.hint);
        if (hit.face == kNone) continue;
        const float distance2 = std::min(hit.distance2, limit2);
        sum.largest2 = std::max(sum.largest2, distance2);
        sum.energy += static_cast<double>(point.weight * distance2);
        if (equations && hit.distance2 <= limit2)
            equations->Add(point.weight, point.leverage, search.Residual(point.position, hit));
        if (sum.energy > stop) break;
    }
    return sum;
}

} // namespace vcg_ext::refinement
