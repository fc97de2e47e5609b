// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vectors and symmetric matrices of three dimensions, on one number (float, double) or on several (Float4,
// Float8).

#include <cmath>

#include "vcg_ext/core/base/simd.h"

namespace vcg_ext::sweeps
{

inline float Max(float a, float b)
{
    return a > b ? a : b;
}
inline double Max(double a, double b)
{
    return a > b ? a : b;
}
using vcg_ext::Max;
inline float Sqrt(float a)
{
    return std::sqrt(a);
}
inline double Sqrt(double a)
{
    return std::sqrt(a);
}
using vcg_ext::Sqrt;

/// \p x in every lane, for numbers with one lane or four.
template <class Real>
[[gnu::always_inline]] inline Real Fill(float x)
{
    return Real{} + x;
}

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

/// A symmetric 3 x 3 matrix by its upper triangle.
template <class Real>
struct SymmetricMatrix3 {
    Real xx, xy, xz, yy, yz, zz;

    Real Trace() const { return xx + yy + zz; }
};

template <class Real>
[[gnu::always_inline]] inline SymmetricMatrix3<Real> operator+(const SymmetricMatrix3<Real>& a,
                                                               const SymmetricMatrix3<Real>& b)
{
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
template <class Real>
[[gnu::always_inline]] inline SymmetricMatrix3<Real> operator-(const SymmetricMatrix3<Real>& a,
                                                               const SymmetricMatrix3<Real>& b)
{
    return {a.xx - b.xx, a.xy - b.xy, a.xz - b.xz, a.yy - b.yy, a.yz - b.yz, a.zz - b.zz};
}
template <class Real>
[[gnu::always_inline]] inline SymmetricMatrix3<Real> operator*(const Real& s, const SymmetricMatrix3<Real>& a)
{
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
}
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> operator*(const SymmetricMatrix3<Real>& m, const Vector3<Real>& d)
{
    return {m.xx * d.x + m.xy * d.y + m.xz * d.z, m.xy * d.x + m.yy * d.y + m.yz * d.z,
            m.xz * d.x + m.yz * d.y + m.zz * d.z};
}
/// n n^T
template <class Real>
[[gnu::always_inline]] inline SymmetricMatrix3<Real> OuterProduct(const Vector3<Real>& n)
{
    return {n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z};
}
/// d^T M d
template <class Real>
[[gnu::always_inline]] inline Real QuadraticForm(const SymmetricMatrix3<Real>& m, const Vector3<Real>& d)
{
    return d.x * (m.xx * d.x + 2.0f * (m.xy * d.y + m.xz * d.z)) + d.y * (m.yy * d.y + 2.0f * (m.yz * d.z)) +
           d.z * (m.zz * d.z);
}

} // namespace vcg_ext::sweeps
