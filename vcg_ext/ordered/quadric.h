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

/// The decomposition LDLᵀ of a positive definite symmetric matrix, in closed form.
class Decomposition
{
    double d0_, d1_, d2_, l10_, l20_, l21_;

  public:
    /// \param smallestPivot is what smaller pivots, which only rounding makes, are lifted to; above 0
    Decomposition(const SymmetricMatrix& matrix, double smallestPivot)
    {
        d0_ = std::max(matrix.xx, smallestPivot);
        l10_ = matrix.xy / d0_;
        l20_ = matrix.xz / d0_;
        d1_ = std::max(matrix.yy - l10_ * matrix.xy, smallestPivot);
        l21_ = (matrix.yz - l20_ * matrix.xy) / d1_;
        d2_ = std::max(matrix.zz - l20_ * matrix.xz - l21_ * l21_ * d1_, smallestPivot);
    }

    vcg::Point3d Solve(const vcg::Point3d& r) const
    {
        const double y1 = r[1] - l10_ * r[0];
        const double y2 = r[2] - l20_ * r[0] - l21_ * y1;
        const double x2 = y2 / d2_;
        const double x1 = y1 / d1_ - l21_ * x2;
        return {r[0] / d0_ - l10_ * x1 - l20_ * x2, x1, x2};
    }
};

/// Solves M x = r for a positive semi-definite \p matrix as Tikhonov does: x stays at the origin in the
/// directions that the matrix leaves open, so that no solution runs away.
///
/// Where M's eigenvalues are far above \p regularisation the pull to the origin is taken back by one step of
/// refinement: what is left of it is its square.
/// \pre regularisation > 0
inline vcg::Point3d SolveRegularised(const SymmetricMatrix& matrix, double regularisation,
                                     const vcg::Point3d& r)
{
    SymmetricMatrix regular = matrix;
    regular.AddDiagonal(regularisation);
    const Decomposition decomposition(regular, regularisation / 2);
    const vcg::Point3d x = decomposition.Solve(r);
    return x + decomposition.Solve(r - matrix * x);
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
