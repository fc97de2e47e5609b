// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "vcg_ext/core/geometry/vector.h"

namespace vcg_ext
{

/// A box along the axes, its sides included. \tparam Real as of Vector3
template <class Real>
struct Box3 {
    Vector3<Real> low, high;

    void Add(const Vector3<Real>& p)
    {
        low = {Min(low.x, p.x), Min(low.y, p.y), Min(low.z, p.z)};
        high = {Max(high.x, p.x), Max(high.y, p.y), Max(high.z, p.z)};
    }
    /// By \p by on every side.
    void Grow(Real by)
    {
        low = low - Vector3<Real>{by, by, by};
        high = high + Vector3<Real>{by, by, by};
    }
    bool IsEmpty() const { return !(low.x <= high.x); }
    bool Has(const Vector3<Real>& p) const { return Meets({p, p}); }
    bool Meets(const Box3& b) const
    {
        return low.x <= b.high.x && low.y <= b.high.y && low.z <= b.high.z && b.low.x <= high.x &&
               b.low.y <= high.y && b.low.z <= high.z;
    }
};

/// A box that has no point: the first one that is added becomes its corners.
template <class Real>
Box3<Real> EmptyBox()
{
    const Real far = std::numeric_limits<Real>::max();
    return {{far, far, far}, {-far, -far, -far}};
}
/// Four empty boxes.
template <>
inline Box3<Float4> EmptyBox<Float4>()
{
    const Box3<float> empty = EmptyBox<float>();
    return {Splat(empty.low), Splat(empty.high)};
}
/// The box around four.
inline Box3<float> Around(const Box3<Float4>& boxes)
{
    return {{MinLane(boxes.low.x), MinLane(boxes.low.y), MinLane(boxes.low.z)},
            {MaxLane(boxes.high.x), MaxLane(boxes.high.y), MaxLane(boxes.high.z)}};
}

} // namespace vcg_ext
