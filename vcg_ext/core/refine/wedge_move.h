// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/attributes/wedge_quadric.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/surface_wedges.h"
#include "vcg_ext/core/refine/star.h"

namespace vcg_ext
{

/// The part of \p step along the normal of the star.
inline Vector3<float> AlongNormal(const Star& star, const Vector3<float>& step)
{
    Vector3<float> normal{0, 0, 0};
    for (std::size_t i = 0; i < star.size(); ++i)
        normal = normal + star[i].triangle.doubleArea * NormalOf(star[i].triangle);
    const float square = Dot(normal, normal);
    return square > 0 ? (Dot(step, normal) / square) * normal : Vector3<float>{0, 0, 0};
}

/// The attribute error of \p wedge at \p x with the values that are best there.
inline float BestError(const SurfaceWedges& wedges, std::uint32_t wedge, const Vector3<float>& x)
{
    const WedgeLayout layout{wedges.channels.size(), wedges.channels.groups};
    const WedgeQuadric<const float> quadric(wedges.channels, layout,
                                            wedges.quadrics.data() + wedge * layout.QuadricSize());
    const Vector3<float> d = x - wedges.centers[wedge];
    return quadric(d, [&](std::size_t k) {
        const float weight = quadric.Weight(k);
        return weight > 0 ? quadric.Wanted(k, d) / weight : 0.0f;
    });
}

/// May \p v leave its normal by \p step? Vertices on seams may not. Where colors or scalars guide, others may
/// not either if that raises the error of these: they would slide off the border of a color.
/// \pre \p surface has wedges
inline bool MaySlide(const SurfaceArrays& surface, const Star& star, std::uint32_t v,
                     const Vector3<float>& step)
{
    constexpr float kTolerable = 1.1f;
    if (surface.flags[v] & kSeamVertex) return false;
    const SurfaceWedges& wedges = *surface.wedges;
    if (wedges.quadrics.empty()) return true;
    const Corner corner = star[0].corner;
    const std::uint32_t wedge = wedges.ofFace[FaceOf(corner)][static_cast<std::size_t>(IndexOf(corner))];
    const Vector3<float> here = PositionOf(surface, v);
    const float along = BestError(wedges, wedge, here + AlongNormal(star, step));
    const float before = BestError(wedges, wedge, here);
    return BestError(wedges, wedge, here + step) <= kTolerable * std::max(along, before);
}

} // namespace vcg_ext
