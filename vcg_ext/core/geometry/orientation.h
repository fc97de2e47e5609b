// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "vcg_ext/core/geometry/vector.h"

// Exact signs of determinants, after Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates" (1997): in double precision where the rounding cannot matter, otherwise by
// expansions. They are written here because the core asks nothing of its users but a compiler: his own code
// is a C file to be compiled and initialized, CGAL and Geogram are far larger than the core, and the ports to
// one header that were found are unfinished or no longer kept.
//
// Exact as long as no product overflows or underflows: for coordinates of 0 and of 1e-70 to 1e100.

namespace vcg_ext
{

/// A sum of doubles as an exact number: ascending, and no two have a bit in common.
/// \tparam kMost terms at most
template <std::size_t kMost>
class Expansion
{
    std::array<double, kMost> terms_;
    std::size_t size_ = 0;

  public:
    Expansion() {} // NOLINT: terms beyond the size are not read

    /// a - b.
    static Expansion Minus(double a, double b)
    {
        Expansion difference;
        difference.Add(a);
        difference.Add(-b);
        return difference;
    }

    std::size_t size() const { return size_; }
    double operator[](std::size_t i) const { return terms_[i]; }
    /// -1, 0 or 1.
    int Sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }

    /// Terms that are zero are left out. \pre there is room
    void Add(double b)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = terms_[i] + b, virtualB = sum - terms_[i];
            const double rest = (terms_[i] - (sum - virtualB)) + (b - virtualB);
            if (rest != 0) terms_[kept++] = rest;
            b = sum;
        }
        if (b != 0) terms_[kept++] = b;
        size_ = kept;
    }

    /// Adds sign a b.
    template <std::size_t kMostA, std::size_t kMostB>
    void AddProduct(double sign, const Expansion<kMostA>& a, const Expansion<kMostB>& b)
    {
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t k = 0; k < b.size(); ++k) {
                const double product = a[i] * b[k];
                Add(sign * std::fma(a[i], b[k], -product));
                Add(sign * product);
            }
    }
};

namespace orientation_detail
{

using Difference = Expansion<2>;

/// a b - c d.
inline Expansion<16> Minor(const Difference& a, const Difference& b, const Difference& c, const Difference& d)
{
    Expansion<16> minor;
    minor.AddProduct(1, a, b);
    minor.AddProduct(-1, c, d);
    return minor;
}

struct ExactVector {
    Difference x, y, z;
    ExactVector(const Vector3<double>& to, const Vector3<double>& from)
        : x(Difference::Minus(to.x, from.x)), y(Difference::Minus(to.y, from.y)),
          z(Difference::Minus(to.z, from.z))
    {
    }
};

inline int SignOf(double value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

inline int ExactOrientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                            const Vector3<double>& d)
{
    const ExactVector u(b, a), v(c, a), w(d, a);
    Expansion<192> determinant;
    determinant.AddProduct(1, Minor(v.y, w.z, v.z, w.y), u.x);
    determinant.AddProduct(1, Minor(v.z, w.x, v.x, w.z), u.y);
    determinant.AddProduct(1, Minor(v.x, w.y, v.y, w.x), u.z);
    return determinant.Sign();
}

} // namespace orientation_detail

/// Half of the distance between 1 and the next larger number.
constexpr double kRoundingUnit = 0x1p-53;

/// The sign of det(b - a, c - a, d - a) where double precision is sure of it, otherwise 0. It is positive
/// where d is on the side of the plane a b c that the normal (b - a) x (c - a) leads to.
inline int CertainOrientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                              const Vector3<double>& d)
{
    constexpr double kErrorBound = (7 + 56 * kRoundingUnit) * kRoundingUnit; // Shewchuk's A for orient3d
    const Vector3<double> u = b - a, v = c - a, w = d - a;
    const double xy = v.x * w.y, yx = v.y * w.x, yz = v.y * w.z, zy = v.z * w.y, zx = v.z * w.x,
                 xz = v.x * w.z;
    const double determinant = u.x * (yz - zy) + u.y * (zx - xz) + u.z * (xy - yx);
    const double permanent = (std::abs(yz) + std::abs(zy)) * std::abs(u.x) +
                             (std::abs(zx) + std::abs(xz)) * std::abs(u.y) +
                             (std::abs(xy) + std::abs(yx)) * std::abs(u.z);
    return std::abs(determinant) > kErrorBound * permanent ? orientation_detail::SignOf(determinant) : 0;
}

/// The exact sign of det(b - a, c - a, d - a): 0 where the four points are in one plane.
inline int Orientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                       const Vector3<double>& d)
{
    const int certain = CertainOrientation(a, b, c, d);
    return certain != 0 ? certain : orientation_detail::ExactOrientation(a, b, c, d);
}

/// A point of a plane.
struct PlanePoint {
    double x, y;
};

/// The exact sign of det(b - a, c - a): positive where a, b and c turn left, 0 where they are in one line.
inline int Orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
    using namespace orientation_detail;
    constexpr double kErrorBound = (3 + 16 * kRoundingUnit) * kRoundingUnit; // Shewchuk's A for orient2d
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
    if (std::abs(left - right) > kErrorBound * (std::abs(left) + std::abs(right)))
        return SignOf(left - right);
    return Minor(Difference::Minus(b.x, a.x), Difference::Minus(c.y, a.y), Difference::Minus(b.y, a.y),
                 Difference::Minus(c.x, a.x))
        .Sign();
}

} // namespace vcg_ext
