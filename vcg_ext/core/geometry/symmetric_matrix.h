// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/core/geometry/vector.h"
namespace vcg_ext
{

/// A symmetric 3 x 3 matrix by its upper triangle. \tparam Real as of Vector3
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

/// The sum of four matrices.
inline SymmetricMatrix3<float> SumLanes(const SymmetricMatrix3<Float4>& m)
{
    return {SumLanes(m.xx), SumLanes(m.xy), SumLanes(m.xz), SumLanes(m.yy), SumLanes(m.yz), SumLanes(m.zz)};
}

/// The x that is least for x^T (M + e I) x - 2 rhs.x, by LDL^T: e pulls it to the origin in the directions
/// that \p m leaves open. Pivots are held at e / 2 or above, so that rounding cannot make the solution wild.
/// \param e > 0 \pre \p m is positive semi-definite but for rounding
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> SolveRegularized(const SymmetricMatrix3<Real>& m,
                                                             const Vector3<Real>& rhs, const Real& e)
{
    const Real floor = 0.5f * e;
    const Real inverse0 = 1.0f / (m.xx + e);
    const Real l10 = m.xy * inverse0;
    const Real l20 = m.xz * inverse0;
    const Real inverse1 = 1.0f / Max(m.yy + e - l10 * m.xy, floor);
    const Real t = m.yz - l20 * m.xy;
    const Real l21 = t * inverse1;
    const Real pivot2 = Max(m.zz + e - l20 * m.xz - l21 * t, floor);
    const Real y1 = rhs.y - l10 * rhs.x;
    const Real y2 = rhs.z - l20 * rhs.x - l21 * y1;
    const Real z = y2 / pivot2;
    const Real y = y1 * inverse1 - l21 * z;
    return {rhs.x * inverse0 - l10 * y - l20 * z, y, z};
}

} // namespace vcg_ext
