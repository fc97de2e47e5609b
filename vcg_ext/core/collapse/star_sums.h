// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the faces around one vertex come to: quadrics, creases, the descriptor and the weight that it gives.
// Templates on the number, as the formulas of cost.h.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/collapse/cost.h"

namespace vcg_ext
{

/// m = n / sqrt|n| of a face with n = 2 area x unit normal: m m^T is 2 area times its plane's quadric. 0
/// where the face has no area.
template <class Real>
Vector3<Real> ScaledNormal(const Vector3<Real>& p, const Vector3<Real>& q, const Vector3<Real>& r)
{
    const Vector3<Real> n = Cross(q - p, r - p);
    const Real length = Sqrt(Dot(n, n));
    const Real scale = length > 0 ? 1.0f / Sqrt(length) : Real{};
    return scale * n;
}

/// The quadric of the plane through the edge \p edge, perpendicular to the face of normal \p normal, times
/// the squared length of the edge. 0 where there is no such plane.
template <class Real>
SymmetricMatrix3<Real> PerpendicularPlane(const Vector3<Real>& normal, const Vector3<Real>& edge)
{
    const Vector3<Real> d = Cross(normal, edge);
    const Real length2 = Dot(d, d);
    const Real scale = length2 > 0 ? Dot(edge, edge) / length2 : Real{};
    return scale * OuterProduct(d);
}

/// Planes perpendicular to both faces of every edge at a vertex with more than 30 degrees between them. Where
/// faces fold back on each other, at the tip of a thin part, these planes alone know the outline, as at a
/// border: the faces' own planes are all nearly the same.
template <class Real>
struct CreasePlanes {
    SymmetricMatrix3<Real> creases{}, folded{};
    int folds = 0;

    /// Adds the edge \p edge between faces of the normals \p m and \p n if it is a crease.
    void Add(const Vector3<Real>& edge, const Vector3<Real>& m, const Vector3<Real>& n)
    {
        const Real product = Dot(m, n);
        if (product >= 0 && product * product >= kCreaseCosine2 * Dot(m, m) * Dot(n, n)) return;
        const bool fold = product < 0 && product * product > kFoldCosine2 * Dot(m, m) * Dot(n, n);
        SymmetricMatrix3<Real>& sum = fold ? folded : creases;
        sum = sum + (PerpendicularPlane(m, edge) + PerpendicularPlane(n, edge));
        folds += fold;
    }
    SymmetricMatrix3<Real> Sum() const
    {
        const float foldWeight = folds < kFoldsAtATip ? kCreaseWeight : kTipWeight;
        return Broadcast<Real>(kCreaseWeight) * creases + Broadcast<Real>(foldWeight) * folded;
    }
};

/// Sums over the faces around a vertex for the descriptor of Eq. 5 and the star's quadric C.
template <class Real>
struct StarSums {
    Vector3<Real> edges{};         ///< sum of v_j - v
    Vector3<Real> normal{};        ///< sum of unit normals, weighted by the chord of the corner's angle
    Real length{};                 ///< sum of |v_j - v|
    SymmetricMatrix3<Real> star{}; ///< sum of m m^T

    /// Adds a face with the edges \p a and \p b from the vertex and m = \p scaledNormal.
    /// \param inverseRoot 1 / |m|; the direction of the normal is m / |m|
    void Add(const Vector3<Real>& a, const Vector3<Real>& b, const Real& lengthA, const Real& lengthB,
             const Vector3<Real>& scaledNormal, const Real& inverseRoot)
    {
        const Real cosine = Dot(a, b) / Max(lengthA * lengthB, Broadcast<Real>(kSmallestSquare));
        const Real chord = Sqrt(Max(Real{}, 2.0f - 2.0f * cosine)) * inverseRoot;
        edges = edges + (a + b);
        normal = normal + chord * scaledNormal;
        length = length + (lengthA + lengthB);
        star = star + OuterProduct(scaledNormal);
    }
    void Add(const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& scaledNormal)
    {
        const Real root2 = Max(Dot(scaledNormal, scaledNormal), Broadcast<Real>(kSmallestSquare));
        Add(a, b, Sqrt(Dot(a, a)), Sqrt(Dot(b, b)), scaledNormal, 1.0f / Sqrt(root2));
    }
    /// Adds \p share of an edge by itself: where the faces do not close up around the vertex, its edges count
    /// once each instead of once a face.
    void AddEdge(const Vector3<Real>& edge, const Real& share)
    {
        edges = edges + share * edge;
        length = length + share * Sqrt(Dot(edge, edge));
    }
};

/// The lanes of all sums added up.
inline StarSums<float> Summed(const StarSums<Float4>& sums)
{
    return {SumLanes(sums.edges), SumLanes(sums.normal), SumLanes(sums.length), SumLanes(sums.star)};
}

/// Eq. 5: |sum of (v_j - v).n| / sum of |v_j - v|, in [0, 1]; 0 where there is no normal.
template <class Real>
Real StarDescriptor(const StarSums<Real>& sums)
{
    const Real size = Sqrt(Dot(sums.normal, sums.normal)) * sums.length;
    return size > 0 ? std::fabs(Dot(sums.normal, sums.edges)) / size : Real{};
}

/// 1 / the descriptor that counts as 1, from the descriptors of an even sample of vertices.
template <class Real>
Real DescriptorScale(std::vector<Real> sample)
{
    if (sample.empty()) return 1;
    const std::ptrdiff_t place = std::lround(kDescriptorPercentile * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), sample.begin() + place, sample.end());
    const Real top = sample[static_cast<std::size_t>(place)];
    return top > 0 ? 1 / top : 1;
}

/// What the descriptor makes of a vertex.
template <class Real>
struct Importance {
    Real descriptor; ///< l, in [0, 1]
    Real weight;     ///< w = e^{lambda l}
};

/// \param lambda the feature weight
template <class Real>
Importance<Real> ImportanceOf(Real descriptor, Real lambda)
{
    return {descriptor, std::exp(lambda * descriptor)};
}

/// The ratchet: what two vertices merge into is as important as either of them, and more so where its new
/// star shows more. \param measured l of that star; 0 where it is not measured
template <class Real>
Importance<Real> MergedImportance(const Importance<Real>& a, const Importance<Real>& b, Real measured,
                                  Real lambda)
{
    const Real descriptor = Max(a.descriptor, b.descriptor);
    if (measured > descriptor) return ImportanceOf(measured, lambda);
    return {descriptor, Max(a.weight, b.weight)};
}

} // namespace vcg_ext
