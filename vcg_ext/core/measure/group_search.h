// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/mesh/face_tree.h"

namespace vcg_ext
{

/// Questions to an ExactSurface that are asked for up to eight points at once, which should be near each
/// other: what comes near one of them is tried for all. The answers are those for single points. For one
/// thread.
class GroupSearch
{
  public:
    static constexpr std::size_t kMost = 8; ///< points

  private:
    struct RecentFour {
        FourTriangles faces;
        PreparedTriangle<Float4> prepared;
    };
    static constexpr std::size_t kRecent = 2;

    const ExactSurface& surface_;
    ExactSurface::Search single_;
    std::array<RecentFour, kRecent> recent_{}; ///< faces that points were near, most of all the last ones
    std::size_t next_ = 0;

    std::size_t count_ = 0;
    std::array<Vector3<double>, kMost> exact_;
    std::array<Vector3<float>, kMost> points_;

  public:
    /// \pre \p surface outlives this object
    explicit GroupSearch(const ExactSurface& surface) : surface_(surface) {}

    /// The points of the next questions: pointAt(i) for i = 0 .. count - 1. \pre 0 < count <= kMost
    template <class PointAt>
    void Take(std::size_t count, const PointAt& pointAt)
    {
        count_ = count;
        for (std::size_t i = 0; i < count; ++i) {
            exact_[i] = pointAt(i);
            points_[i] = ExactSurface::Rounded(exact_[i]);
        }
    }

    /// The larger of \p known2 and the largest squared distance of the points: those are not looked for that
    /// are not larger.
    double LargerDistance2(double known2)
    {
        unsigned open = (1U << count_) - 1;
        const double sure = std::sqrt(known2) - surface_.Slack();
        if (sure > 0) CloseNear(static_cast<float>(sure * sure), open);
        for (std::size_t i = 0; open >> i != 0; ++i)
            if (open >> i & 1) known2 = surface_.LargerDistance2(exact_[i], known2, single_);
        return known2;
    }

  private:
    /// Takes points out of \p open that are surely not farther than the root of \p near2.
    void CloseNear(float near2, unsigned& open)
    {
        for (std::size_t r = 0; r < std::min(next_, kRecent) && open != 0; ++r)
            CloseBeside(recent_[r].faces, recent_[r].prepared, near2, open);
        for (std::size_t i = 0; open >> i != 0; ++i) {
            if ((open >> i & 1) == 0) continue;
            surface_.Tree().ForEachFourNear(points_[i], near2, [&](const FourTriangles& faces) {
                const PreparedTriangle<Float4> prepared = faces.Prepared();
                const unsigned before = open;
                CloseBeside(faces, prepared, near2, open);
                if (open != before) recent_[next_++ % kRecent] = {faces, prepared};
                return (open >> i & 1) != 0 ? near2 : -1.0F;
            });
        }
    }
    void CloseBeside(const FourTriangles& faces, const PreparedTriangle<Float4>& prepared, float near2,
                     unsigned& open) const
    {
        const Int4 planes = HavePlanes(prepared);
        if (!AnyLane(planes)) return;
        for (unsigned left = open; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(__builtin_ctz(left));
            const Float4 distance2 = ClosestOnTriangle(faces.Seen(points_[i]), prepared).distance2;
            if (AnyLane((distance2 <= Splat(near2)) & planes)) open &= ~(1U << i);
        }
    }
    /// Are the distances over faces what they seem to be in single precision, but for the slack? Not over
    /// needles, whose normals are rounding.
    Int4 HavePlanes(const PreparedTriangle<Float4>& faces) const
    {
        constexpr float kRounding = 4 * std::numeric_limits<float>::epsilon();
        const auto slack = static_cast<float>(surface_.Slack());
        return faces.quality * slack >= kRounding * Sqrt(Max(faces.bb, faces.cc));
    }
};

} // namespace vcg_ext
