// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/vector.h"

namespace vcg_ext::refinement
{

/// The least-squares step of a vertex: (sum w b^2 n n^T) x = sum w b d. A point of weight w makes the part b
/// of the step, is away from its target by d, and resists along the direction n of d only.
struct NormalEquations {
    float xx, xy, xz, yy, yz, zz;
    Vector3<float> right;
};

/// The sums of the equations, four points at a time.
class EquationSums
{
    Float4 xx_ = Splat(0.0F), xy_ = xx_, xz_ = xx_, yy_ = xx_, yz_ = xx_, zz_ = xx_;
    Vector3<Float4> right_{xx_, xx_, xx_};

  public:
    /// \param weighted w b
    void Add(Float4 weighted, Float4 leverage, const Vector3<Float4>& direction,
             const Vector3<Float4>& residual)
    {
        right_.x += weighted * residual.x;
        right_.y += weighted * residual.y;
        right_.z += weighted * residual.z;
        const Float4 s = weighted * leverage, sx = s * direction.x, sy = s * direction.y;
        xx_ += sx * direction.x;
        xy_ += sx * direction.y;
        xz_ += sx * direction.z;
        yy_ += sy * direction.y;
        yz_ += sy * direction.z;
        zz_ += s * direction.z * direction.z;
    }
    NormalEquations Total() const
    {
        return {SumLanes(xx_),
                SumLanes(xy_),
                SumLanes(xz_),
                SumLanes(yy_),
                SumLanes(yz_),
                SumLanes(zz_),
                {SumLanes(right_.x), SumLanes(right_.y), SumLanes(right_.z)}};
    }
};

/// A squared step from here on comes from equations that have no solution.
constexpr float kLargestSquaredStep = 1e30F;

/// The step that solves \p e with \p regularisation x the mean diagonal entry added, by a Cholesky
/// decomposition whose pivots stay positive; nothing where the equations are empty.
inline std::optional<Vector3<float>> SolveStep(const NormalEquations& e, float regularisation)
{
    const float trace = e.xx + e.yy + e.zz, added = trace * (regularisation / 3);
    if (!(added > 0)) return std::nullopt;
    const float inverse0 = 1 / (e.xx + added);
    const float l1 = e.xy * inverse0, l2 = e.xz * inverse0;
    const float pivot1 = std::max(e.yy + added - l1 * e.xy, added / 2);
    const float mixed = e.yz - l2 * e.xy, l21 = mixed / pivot1;
    const float pivot2 = std::max(e.zz + added - l2 * e.xz - l21 * mixed, added / 2);
    const float z1 = e.right.y - l1 * e.right.x;
    const float z2 = e.right.z - l2 * e.right.x - l21 * z1;
    Vector3<float> step{};
    step.z = z2 / pivot2;
    step.y = z1 / pivot1 - l21 * step.z;
    step.x = e.right.x * inverse0 - l1 * step.y - l2 * step.z;
    if (!(SquaredNorm(step) < kLargestSquaredStep)) return std::nullopt;
    return step;
}

} // namespace vcg_ext::refinement
