// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/core/base/float4.h"
namespace vcg_ext
{

/// Squares of lengths, and sums of such, that are smaller than this are taken for it where something is
/// divided by them; in the frame of kFrameDiagonal.
constexpr float kSmallestSquare = 1e-30F;

/// A point or direction, left uninitialised unless braces follow.
/// \tparam Real float or double; Float4 or Float8: as many vectors as it has lanes
template <class Real>
struct Vector3 {
    Real x, y, z;
};

template <class Real>
[[gnu::always_inline]] inline Vector3<Real> operator+(const Vector3<Real>& a, const Vector3<Real>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> operator-(const Vector3<Real>& a, const Vector3<Real>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> operator*(const Real& s, const Vector3<Real>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
template <class Real>
[[gnu::always_inline]] inline Real Dot(const Vector3<Real>& a, const Vector3<Real>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> Cross(const Vector3<Real>& a, const Vector3<Real>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
[[gnu::always_inline]] inline Real SquaredNorm(const Vector3<Real>& a)
{
    return Dot(a, a);
}
template <class Real>
[[gnu::always_inline]] inline Real Norm(const Vector3<Real>& a)
{
    return Sqrt(SquaredNorm(a));
}

/// The same vector four times.
inline Vector3<Float4> Splat(const Vector3<float>& a)
{
    return {Splat(a.x), Splat(a.y), Splat(a.z)};
}
inline Vector3<Float4> Select(Int4 mask, const Vector3<Float4>& yes, const Vector3<Float4>& no)
{
    return {Select(mask, yes.x, no.x), Select(mask, yes.y, no.y), Select(mask, yes.z, no.z)};
}
/// One of four vectors.
inline Vector3<float> Lane(const Vector3<Float4>& a, int lane)
{
    return {a.x[lane], a.y[lane], a.z[lane]};
}
/// The sum of the four.
inline Vector3<float> SumLanes(const Vector3<Float4>& a)
{
    return {SumLanes(a.x), SumLanes(a.y), SumLanes(a.z)};
}
inline void SetLane(Vector3<Float4>& a, int lane, const Vector3<float>& value)
{
    a.x[lane] = value.x;
    a.y[lane] = value.y;
    a.z[lane] = value.z;
}

} // namespace vcg_ext
