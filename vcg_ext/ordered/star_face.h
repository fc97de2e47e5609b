// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <vcg/space/point3.h>

namespace vcg_ext
{

/// A face that outlives a collapse, seen from the corner that moves.
struct StarFace {
    vcg::Point3d next, previous; ///< the other corners
    vcg::Point3d normal;         ///< before the collapse, 2 area long
    double doubleArea;
    std::uint32_t face; ///< its index in the mesh
};

/// Smallest cosine between a face's normal before and after one collapse: 78 degrees.
constexpr double kSmallestTurnCosine = .2;

/// The worst quality, 2 area / longest edge², of \p faces when their moving corner is at \p x; nothing where
/// one of them turns too far or loses its area.
/// \param clamp better ones are not told apart
inline std::optional<double> WorstQuality(const std::vector<StarFace>& faces, const vcg::Point3d& x,
                                          double clamp)
{
    constexpr double kWorstQuality = 1e-9;
    double worst = clamp;
    for (const StarFace& face : faces) {
        const vcg::Point3d next = face.next - x, previous = face.previous - x;
        const vcg::Point3d normal = next ^ previous;
        const double area = normal.Norm();
        const bool turnsTooFar =
            !(area > 0) || normal.dot(face.normal) < kSmallestTurnCosine * area * face.doubleArea;
        if (face.doubleArea > 0 && turnsTooFar) return std::nullopt;
        const double longest =
            std::max({next.SquaredNorm(), previous.SquaredNorm(), (face.next - face.previous).SquaredNorm()});
        worst = longest > 0 ? std::min(worst, area / longest) : 0;
    }
    return std::max(worst, kWorstQuality);
}

} // namespace vcg_ext
