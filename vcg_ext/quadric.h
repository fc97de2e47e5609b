// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <vcg/space/point3.h>

namespace vcg_ext
{

/// A symmetric 3 x 3 matrix in double precision, zero at first.
struct SymmetricMatrix {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    double Trace() const { return xx + yy + zz; }

    /// Adds \p weight times the outer product of \p n with itself.
    void AddOuter(const vcg::Point3d& n, double weight)
    {
        const vcg::Point3d m = n * weight;
        xx += m[0] * n[0];
        xy += m[0] * n[1];
        xz += m[0] * n[2];
        yy += m[1] * n[1];
        yz += m[1] * n[2];
        zz += m[2] * n[2];
    }

    void AddDiagonal(double value)
    {
        xx += value;
        yy += value;
        zz += value;
    }

    /// Adds \p weight times \p other.
    void Add(const SymmetricMatrix& other, double weight)
    {
        xx += weight * other.xx;
        xy += weight * other.xy;
        xz += weight * other.xz;
        yy += weight * other.yy;
        yz += weight * other.yz;
        zz += weight * other.zz;
    }

    vcg::Point3d operator*(const vcg::Point3d& x) const
    {
        return {xx * x[0] + xy * x[1] + xz * x[2], xy * x[0] + yy * x[1] + yz * x[2],
                xz * x[0] + yz * x[1] + zz * x[2]};
    }

    /// xᵀ M x
    double Form(const vcg::Point3d& x) const { return x.dot(*this * x); }
};

/// Solves M x = r for a positive semi-definite \p matrix by its LDLᵀ decomposition in closed form.
///
/// The smallest eigenvalue must be \p regularisation or more but for rounding: pivots below half of it are
/// lifted to that, so that no solution runs away along a direction that nothing determines. That is what
/// happens to normal equations of planes after AddDiagonal(regularisation).
/// \pre regularisation > 0
inline vcg::Point3d SolveRegularised(const SymmetricMatrix& matrix, double regularisation,
                                     const vcg::Point3d& r)
{
    const double smallestPivot = regularisation / 2;
    const double d0 = std::max(matrix.xx, smallestPivot);
    const double l10 = matrix.xy / d0;
    const double l20 = matrix.xz / d0;
    const double d1 = std::max(matrix.yy - l10 * matrix.xy, smallestPivot);
    const double l21 = (matrix.yz - l20 * matrix.xy) / d1;
    const double d2 = std::max(matrix.zz - l20 * matrix.xz - l21 * l21 * d1, smallestPivot);
    const double y1 = r[1] - l10 * r[0];
    const double y2 = r[2] - l20 * r[0] - l21 * y1;
    const double x2 = y2 / d2;
    const double x1 = y1 / d1 - l21 * x2;
    return {r[0] / d0 - l10 * x1 - l20 * x2, x1, x2};
}

/// A sum of weighted squared distances to planes, Q(x) = xᵀ A x + 2 b·x + c (Garland and Heckbert 1997).
///
/// x counts from an origin that the owner keeps: a vertex's quadric counts from the vertex, so that b and c
/// stay as small as the error they stand for. About a common origin they would cancel each other, and what
/// is left of the digits would decide in flat regions.
struct Quadric {
    SymmetricMatrix a;
    vcg::Point3d b{0, 0, 0};
    double c = 0;

    /// Adds \p weight times the squared distance to the plane n·x + d = 0. \pre |n| = 1
    void AddPlane(const vcg::Point3d& n, double d, double weight)
    {
        a.AddOuter(n, weight);
        b += n * (d * weight);
        c += d * d * weight;
    }

    void Add(const Quadric& other)
    {
        a.Add(other.a, 1);
        b += other.b;
        c += other.c;
    }

    void Scale(double factor)
    {
        SymmetricMatrix scaled;
        scaled.Add(a, factor);
        a = scaled;
        b *= factor;
        c *= factor;
    }

    double operator()(const vcg::Point3d& x) const { return x.dot(a * x + b * 2) + c; }

    /// The same function counted from the point that was at \p origin.
    Quadric CountedFrom(const vcg::Point3d& origin) const
    {
        Quadric shifted;
        shifted.a = a;
        shifted.b = a * origin + b;
        shifted.c = (*this)(origin);
        return shifted;
    }
};

} // namespace vcg_ext
