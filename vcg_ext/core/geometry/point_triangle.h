// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The point of a triangle closest to a query point. The first corner of the triangle is always the origin:
// differences of near points are exact in single precision, absolute coordinates would lose them.

#include <algorithm>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/vector.h"

namespace vcg_ext
{

template <class Real>
struct ClosestPointOf {
    Real distance2;  ///< square of the distance
    Real weights[3]; ///< barycentric coordinates of the closest point
};
using ClosestPoint = ClosestPointOf<float>;

/// A triangle whose angle at the first corner has a squared sine below this is taken for its edges: its
/// computed normal would be rounding, and a height over it no distance.
constexpr float kFlattestSine2 = 1e-12F;

/// The point (1 - wb - wc) 0 + wb b + wc c as an answer.
template <class Real>
ClosestPointOf<Real> PointAtWeights(const Vector3<Real>& p, const Vector3<Real>& b, const Vector3<Real>& c,
                                    Real wb, Real wc)
{
    const Vector3<Real> difference = p - wb * b - wc * c;
    return {SquaredNorm(difference), {1 - wb - wc, wb, wc}};
}

/// Of a triangle without area: the best of its three edges.
template <class Real>
ClosestPointOf<Real> ClosestOnEdges(const Vector3<Real>& p, const Vector3<Real>& b, const Vector3<Real>& c)
{
    const auto along = [](const Vector3<Real>& q, const Vector3<Real>& edge) {
        return std::clamp(Dot(q, edge) / std::max(Dot(edge, edge), Real{kSmallestSquare}), Real{0}, Real{1});
    };
    const Real t = along(p - b, c - b);
    ClosestPointOf<Real> best = PointAtWeights<Real>(p, b, c, 1 - t, t);
    for (const ClosestPointOf<Real>& other :
         {PointAtWeights<Real>(p, b, c, along(p, b), 0), PointAtWeights<Real>(p, b, c, 0, along(p, c))})
        if (other.distance2 < best.distance2) best = other;
    return best;
}

/// Plain form, the reference for the one below: the seven regions of the plane, corners and edges first
/// (Ericson, Real-Time Collision Detection, 2005, 5.1.5). Degenerate triangles are segments or points.
template <class Real>
ClosestPointOf<Real> ClosestOnTriangle(const Vector3<Real>& p, const Vector3<Real>& b, const Vector3<Real>& c)
{
    const Real pb = Dot(p, b), pc = Dot(p, c);
    if (pb <= 0 && pc <= 0) return PointAtWeights<Real>(p, b, c, 0, 0);
    const Real bb = Dot(b, b), bc = Dot(b, c), cc = Dot(c, c);
    const Real fromB = pb - bb, fromBAlongC = pc - bc;
    if (fromB >= 0 && fromBAlongC <= fromB) return PointAtWeights<Real>(p, b, c, 1, 0);
    const Real besideB = pb * fromBAlongC - fromB * pc;
    if (besideB <= 0 && pb >= 0 && fromB <= 0 && bb > 0) return PointAtWeights<Real>(p, b, c, pb / bb, 0);
    const Real fromCAlongB = pb - bc, fromC = pc - cc;
    if (fromC >= 0 && fromCAlongB <= fromC) return PointAtWeights<Real>(p, b, c, 0, 1);
    const Real besideC = fromCAlongB * pc - pb * fromC;
    if (besideC <= 0 && pc >= 0 && fromC <= 0 && cc > 0) return PointAtWeights<Real>(p, b, c, 0, pc / cc);
    const Real besideFar = fromB * fromC - fromCAlongB * fromBAlongC;
    const Real alongFar = fromBAlongC - fromB, beforeC = fromCAlongB - fromC;
    const Real length = alongFar + beforeC;
    if (besideFar <= 0 && alongFar >= 0 && beforeC >= 0 && length > 0)
        return PointAtWeights<Real>(p, b, c, beforeC / length, alongFar / length);
    const Vector3<Real> normal = Cross(b, c);
    const Real normal2 = SquaredNorm(normal), height = Dot(normal, p);
    if (!(normal2 > Real{kFlattestSine2} * bb * cc)) return ClosestOnEdges(p, b, c);
    const Real determinant = std::max(bb * cc - bc * bc, Real{kSmallestSquare});
    const Real wb = (cc * pb - bc * pc) / determinant, wc = (bb * pc - bc * pb) / determinant;
    return {height * height / normal2, {1 - wb - wc, wb, wc}};
}

/// A triangle (0, b, c) with everything that does not depend on the query point.
/// \tparam Real float: one triangle for four points; Float4: four triangles, each for its own point
template <class Real>
struct PreparedTriangle {
    Real bx, by, bz, cx, cy, cz;
    Real nx, ny, nz; ///< unit normal, 0 where the triangle is degenerate
    Real bb, bc, cc; ///< dot products
    Real inverseBB, inverseCC, inverseFar, inverseDeterminant;
    Real doubleArea;
    Real quality; ///< double area / square of the longest edge: .866 if equilateral, 0 if degenerate
};

inline float OrZero(bool keep, float a)
{
    return keep ? a : 0;
}
inline Float4 OrZero(Int4 keep, Float4 a)
{
    return Floats(keep & Bits(a));
}

/// \p bx.. \p cz: the second and third corner seen from the first one
template <class Real>
[[gnu::always_inline]] inline PreparedTriangle<Real> PrepareTriangle(Real bx, Real by, Real bz, Real cx,
                                                                     Real cy, Real cz)
{
    PreparedTriangle<Real> t;
    t.bx = bx, t.by = by, t.bz = bz, t.cx = cx, t.cy = cy, t.cz = cz;
    const Real nx = by * cz - bz * cy, ny = bz * cx - bx * cz, nz = bx * cy - by * cx;
    const Real fx = cx - bx, fy = cy - by, fz = cz - bz;
    const Real one = Real{} + 1.0F, smallest = Real{} + kSmallestSquare;
    const Real normal2 = nx * nx + ny * ny + nz * nz;
    const Real far2 = fx * fx + fy * fy + fz * fz;
    t.bb = bx * bx + by * by + bz * bz;
    t.bc = bx * cx + by * cy + bz * cz;
    t.cc = cx * cx + cy * cy + cz * cz;
    t.inverseBB = one / Max(t.bb, smallest);
    t.inverseCC = one / Max(t.cc, smallest);
    t.inverseFar = one / Max(far2, smallest);
    const auto proper = normal2 > Max(kFlattestSine2 * t.bb * t.cc, smallest);
    t.inverseDeterminant = OrZero(proper, one / Max(normal2, smallest));
    t.doubleArea = OrZero(proper, Sqrt(normal2));
    const Real inverseNormal = t.doubleArea * t.inverseDeterminant;
    t.nx = nx * inverseNormal, t.ny = ny * inverseNormal, t.nz = nz * inverseNormal;
    t.quality = t.doubleArea / Max(Max(t.bb, t.cc), Max(far2, smallest));
    return t;
}
inline PreparedTriangle<float> PrepareTriangle(const Vector3<float>& b, const Vector3<float>& c)
{
    return PrepareTriangle(b.x, b.y, b.z, c.x, c.y, c.z);
}
inline Vector3<float> NormalOf(const PreparedTriangle<float>& t)
{
    return {t.nx, t.ny, t.nz};
}

/// Four triangles anywhere.
struct FourTriangles {
    Vector3<Float4> a, b, c; ///< the first corner, and the others seen from it

    Vector3<Float4> Seen(const Vector3<float>& p) const { return Splat(p) - a; }
    PreparedTriangle<Float4> Prepared() const { return PrepareTriangle(b.x, b.y, b.z, c.x, c.y, c.z); }
};

struct FourClosestPoints {
    Float4 distance2;
    Int4 inside;                ///< the closest point is the projection on the plane
    Int4 onFarEdge;             ///< it lies on the edge between the second and third corner
    Float4 originWeight;        ///< its barycentric coordinate at the first corner
    Vector3<Float4> difference; ///< from it to the query point
};

inline Float4 ClampToUnit(Float4 t)
{
    return Min(Max(t, Splat(0.0F)), Splat(1.0F));
}

/// ClosestOnTriangle four times at once. Always inlined: answers that the caller does not read cost nothing.
template <class Real>
[[gnu::always_inline]] inline FourClosestPoints ClosestOnTriangle(const Vector3<Float4>& p,
                                                                  const PreparedTriangle<Real>& t)
{
    const Float4 pb = p.x * t.bx + p.y * t.by + p.z * t.bz, pc = p.x * t.cx + p.y * t.cy + p.z * t.cz;
    const Float4 wb = (t.cc * pb - t.bc * pc) * t.inverseDeterminant;
    const Float4 wc = (t.bb * pc - t.bc * pb) * t.inverseDeterminant;
    const Float4 height = p.x * t.nx + p.y * t.ny + p.z * t.nz;
    const Float4 zero = Splat(0.0F);
    const Float4 determinant = zero + t.inverseDeterminant;
    FourClosestPoints r;
    r.inside = (wb >= zero) & (wc >= zero) & (wb + wc <= Splat(1.0F)) & (determinant > zero);
    r.onFarEdge = Splat(0);
    r.originWeight = 1.0F - wb - wc;
    r.difference = {height * t.nx, height * t.ny, height * t.nz};
    r.distance2 = height * height;
    if (AllLanes(r.inside)) return r;

    const Float4 tb = ClampToUnit(pb * t.inverseBB), tc = ClampToUnit(pc * t.inverseCC);
    const Float4 tf = ClampToUnit((pc - pb + (t.bb - t.bc)) * t.inverseFar);
    const Vector3<Float4> toB{p.x - tb * t.bx, p.y - tb * t.by, p.z - tb * t.bz};
    const Vector3<Float4> toC{p.x - tc * t.cx, p.y - tc * t.cy, p.z - tc * t.cz};
    const Vector3<Float4> toFar{p.x - t.bx - tf * (t.cx - t.bx), p.y - t.by - tf * (t.cy - t.by),
                                p.z - t.bz - tf * (t.cz - t.bz)};
    const Float4 dB = SquaredNorm(toB), dC = SquaredNorm(toC), dFar = SquaredNorm(toFar);
    const Float4 near = Min(dB, dC), edge = Min(near, dFar);
    const Int4 cNearer = dC < dB, farNearest = dFar < near;
    const Float4 edgeWeight = Select(farNearest, zero, 1.0F - Select(cNearer, tc, tb));
    const Vector3<Float4> toEdge = Select(farNearest, toFar, Select(cNearer, toC, toB));
    constexpr float kTie = 1.0001F; // a corner belongs to both of its edges, whatever the rounding
    r.onFarEdge = ~r.inside & (dFar <= near * kTie);
    r.originWeight = Select(r.inside, r.originWeight, edgeWeight);
    r.difference = Select(r.inside, r.difference, toEdge);
    r.distance2 = Select(r.inside, r.distance2, edge);
    return r;
}

} // namespace vcg_ext
