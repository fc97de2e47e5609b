// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/vector.h"

namespace vcg_ext
{

/// Length of the bounding box's diagonal in the frame.
constexpr double kFrameDiagonal = 1024;

/// In the frame: by how much boxes are taken for larger, so that rounding to single precision hides nothing.
constexpr float kBoxMargin = 1e-3F;

/// The similarity between a mesh's own coordinates and the frame in which surfaces are collapsed and
/// compared: the box of the mesh lies about its origin. Single precision is enough there.
struct Frame {
    std::array<double, 3> center{0, 0, 0};
    double scale = 1; ///< frame units per unit of the mesh, > 0
    double unit = 1;  ///< 1 / scale: the length in the mesh of one frame unit

    /// From coordinates of the mesh.
    template <class Real = float>
    Vector3<Real> Into(const std::array<double, 3>& p) const
    {
        return {static_cast<Real>((p[0] - center[0]) * scale), static_cast<Real>((p[1] - center[1]) * scale),
                static_cast<Real>((p[2] - center[2]) * scale)};
    }
    /// To coordinates of the mesh.
    template <class Real>
    std::array<double, 3> OutOf(const Vector3<Real>& p) const
    {
        return {static_cast<double>(p.x) * unit + center[0], static_cast<double>(p.y) * unit + center[1],
                static_cast<double>(p.z) * unit + center[2]};
    }
};

/// The frame in which \p box lies about the origin and has that diagonal. Where the diagonal is 0, or its
/// inverse no number, the scale is 1. \pre a point has been added to the box
inline Frame FrameOf(const Box3<double>& box)
{
    const Vector3<double> size = box.high - box.low;
    double diagonal = Norm(size);
    if (!std::isnormal(diagonal)) diagonal = std::hypot(size.x, size.y, size.z); // its square is no number
    const double unit = diagonal / kFrameDiagonal;
    Frame frame;
    frame.center = {0.5 * box.low.x + 0.5 * box.high.x, 0.5 * box.low.y + 0.5 * box.high.y,
                    0.5 * box.low.z + 0.5 * box.high.z};
    if (!std::isnormal(unit) || !std::isnormal(1 / unit)) return frame;
    frame.unit = unit;
    frame.scale = 1 / unit;
    return frame;
}

} // namespace vcg_ext
