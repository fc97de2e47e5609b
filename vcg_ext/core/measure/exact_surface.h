// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/decimation_types.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface_builder.h"

namespace vcg_ext
{

/// The faces of a mesh for distances in double precision. Its tree, in single precision, says which faces may
/// be the closest; those are then measured. Everything is in the frame. Queries may run on several threads.
class ExactSurface
{
    /// Faces that are measured before only those that are nearer than the nearest count: where hundreds
    /// coincide the answer is the same within the rounding of single precision, and comes at once.
    static constexpr int kMaxTies = 64;
    /// Squared distances in the frame that are rounding even in double precision: 1e-12 of the diagonal.
    static constexpr double kZero2 = 1e-18;

    const MeshView& view_;
    const FaceTree& tree_;
    const SurfaceFrame& frame_;
    double slack_;

    /// \return the squared distance up to which the tree has to look, if the nearest face measured is at \p
    /// nearest2
    float Limit2(double nearest2, int measured) const
    {
        if (nearest2 <= kZero2) return -1;
        if (measured > kMaxTies) return static_cast<float>(nearest2 * (1 - 1e-6));
        const double reach = std::sqrt(nearest2) + slack_;
        return static_cast<float>(std::min<double>(reach * reach, std::numeric_limits<float>::max()));
    }

    double Distance2ToFace(std::size_t f, const Vector3<double>& p) const
    {
        const Vector3<double> a = Corner(f, 0);
        return ClosestOnTriangle(p - a, Corner(f, 1) - a, Corner(f, 2) - a).distance2;
    }
    static Vector3<float> Rounded(const Vector3<double>& p)
    {
        return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }

  public:
    /// \param tree of the view's faces, in \p frame \param slack RoundingOf the two meshes that are compared
    /// \pre all outlive this object; at least one face
    ExactSurface(const MeshView& view, const FaceTree& tree, const SurfaceFrame& frame, float slack)
        : view_(view), tree_(tree), frame_(frame), slack_(static_cast<double>(slack))
    {
    }

    std::size_t FaceCount() const { return view_.faceCount; }
    Vector3<double> Vertex(std::size_t v) const
    {
        const std::array<double, 3> p = view_.Position(v);
        return {(p[0] - frame_.center[0]) * frame_.scale, (p[1] - frame_.center[1]) * frame_.scale,
                (p[2] - frame_.center[2]) * frame_.scale};
    }
    Vector3<double> Corner(std::size_t f, std::size_t k) const { return Vertex(view_.triangles[3 * f + k]); }
    /// 2 area times the unit normal.
    Vector3<double> AreaVector(std::size_t f) const
    {
        const Vector3<double> a = Corner(f, 0);
        return Cross(Corner(f, 1) - a, Corner(f, 2) - a);
    }

    /// Squared distance of \p p to the surface.
    double Distance2(const Vector3<double>& p) const
    {
        double nearest2 = std::numeric_limits<double>::infinity();
        int measured = 0;
        tree_.ForEachWithin(Rounded(p), std::numeric_limits<float>::max(), [&](std::uint32_t face) {
            nearest2 = std::min(nearest2, Distance2ToFace(face, p));
            return Limit2(nearest2, ++measured);
        });
        return nearest2;
    }

    /// Whether the face closest to \p p is turned by more than 90 degrees against \p direction. Of several
    /// that are equally close, as on both sides of an edge, one that is not is enough.
    bool FacesAwayFrom(const Vector3<double>& p, const Vector3<double>& direction) const
    {
        constexpr double kTie = 1 + 1e-9;
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        double along2 = kInfinity, away2 = kInfinity;
        int measured = 0;
        tree_.ForEachWithin(Rounded(p), std::numeric_limits<float>::max(), [&](std::uint32_t face) {
            double& side2 = Dot(AreaVector(face), direction) < 0 ? away2 : along2;
            side2 = std::min(side2, Distance2ToFace(face, p));
            // a face that looks along ends the search where it cannot be beaten
            if (along2 <= kZero2) return -1.0F;
            return Limit2(std::max(std::min(along2, away2), 2 * kZero2), ++measured);
        });
        return away2 * kTie + kZero2 < along2;
    }
};

/// How much single precision can be wrong, in the frame, about which face is the closest: 16 units in the
/// last place of the largest coordinate of the vertices on faces.
inline float RoundingOf(const MeshView& a, const MeshView& b, const SurfaceFrame& frame)
{
    double largest = 0;
    for (const MeshView* view : {&a, &b})
        for (std::size_t k = 0; k < 3 * view->faceCount; ++k) {
            const std::array<double, 3> p = view->Position(view->triangles[k]);
            for (std::size_t i = 0; i < 3; ++i)
                largest = std::max(largest, std::abs((p[i] - frame.center[i]) * frame.scale));
        }
    return static_cast<float>(16 * largest) * std::numeric_limits<float>::epsilon();
}

} // namespace vcg_ext
