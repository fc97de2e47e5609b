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
#include "vcg_ext/core/geometry/box.h"
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
    static constexpr std::size_t kFours = kMost / kLanes;
    static constexpr float kFar = std::numeric_limits<float>::max();
    static constexpr unsigned kAllPoints = (1U << kMost) - 1;

    const ExactSurface& surface_;
    ExactSurface::Search single_;

    std::size_t count_ = 0;
    std::array<Vector3<double>, kMost> exact_;
    std::array<Vector3<Float4>, kFours> points_;

  public:
    /// \pre \p surface outlives this object
    explicit GroupSearch(const ExactSurface& surface) : surface_(surface) {}

    /// The points of the next questions: pointAt(i) for i = 0 .. count - 1. \pre 0 < count <= kMost
    template <class PointAt>
    void Take(std::size_t count, const PointAt& pointAt)
    {
        count_ = count;
        for (std::size_t i = 0; i < kMost; ++i) { // the last one is repeated
            exact_[i] = i < count ? pointAt(i) : exact_[i - 1];
            SetLane(points_[i / kLanes], static_cast<int>(i % kLanes), ExactSurface::Rounded(exact_[i]));
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

    /// For how many points the closest face is turned by more than 90 degrees against directions[i]
    /// (ExactSurface::FacesAwayFrom). \param nearFaces for each point a face that is near it
    std::size_t CountFacingAway(const std::array<Vector3<double>, kMost>& directions,
                                const std::array<std::uint32_t, kMost>& nearFaces)
    {
        const unsigned suspects = MayFaceAway(directions, nearFaces);
        std::size_t away = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if ((suspects >> i & 1) == 0) continue;
            single_.last = nearFaces[i];
            away += surface_.FacesAwayFrom(exact_[i], directions[i], single_);
        }
        return away;
    }

  private:
    Vector3<float> Point(std::size_t i) const
    {
        return Lane(points_[i / kLanes], static_cast<int>(i % kLanes));
    }
    /// Squared distances of the points of one four to a face. \param a its first corner
    Float4 Distances2(std::size_t four, const Vector3<float>& a, const PreparedTriangle<float>& face) const
    {
        return ClosestOnTriangle(points_[four] - Splat(a), face).distance2;
    }

    /// Takes points out of \p open that are surely not farther than the root of \p near2.
    void CloseNear(float near2, unsigned& open) const
    {
        for (std::size_t i = 0; open >> i != 0; ++i) {
            if ((open >> i & 1) == 0) continue;
            surface_.Tree().ForEachFourNear(
                Point(i), FaceTree::AllNodes, near2, [&](const FourTriangles& faces, const auto&) {
                    CloseBeside(faces, near2, open);
                    return (open >> i & 1) != 0 ? near2 : -1.0F;
                });
        }
    }
    void CloseBeside(const FourTriangles& faces, float near2, unsigned& open) const
    {
        const PreparedTriangle<Float4> prepared = faces.Prepared();
        const int planes = LaneBits(HavePlanes(prepared));
        for (int lane = 0; lane < kLanes; ++lane) {
            if ((planes >> lane & 1) == 0) continue;
            const PreparedTriangle<float> face = Lane(prepared, lane);
            for (std::size_t four = 0; four < kFours; ++four) {
                if ((open >> (kLanes * four) & 15U) == 0) continue;
                const Float4 distance2 = Distances2(four, Lane(faces.a, lane), face);
                open &= ~(static_cast<unsigned>(LaneBits(distance2 <= Splat(near2))) << (kLanes * four));
            }
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

    /// Bits of the points for which it has to be looked at closely which side they are on.
    unsigned MayFaceAway(const std::array<Vector3<double>, kMost>& directions,
                         const std::array<std::uint32_t, kMost>& nearFaces) const
    {
        constexpr float kSafe = 2e-3F; // rounding of normals of faces that are not thin, and of the direction
        std::array<Vector3<Float4>, kFours> along;
        std::array<Float4, kFours> reach2{};
        Box3<float> box = EmptyBox<float>(), cone = EmptyBox<float>();
        float largest2 = 0;
        unsigned suspects = 0;
        for (std::size_t i = 0; i < kMost; ++i) {
            const std::size_t point = std::min(i, count_ - 1); // the last one is repeated
            const double length = Norm(directions[point]);
            const bool isAlong = Dot(surface_.AreaVector(nearFaces[point]), directions[point]) > 0;
            if (!(length > 0) || !isAlong) {
                suspects |= 1U << i;
                SetLane(along[i / kLanes], static_cast<int>(i % kLanes), {0, 0, 0});
                continue;
            }
            const Vector3<float> unit = ExactSurface::Rounded((1 / length) * directions[point]);
            const float here2 =
                surface_.Reach2(surface_.Distance2ToFace(nearFaces[point], exact_[point]));
            SetLane(along[i / kLanes], static_cast<int>(i % kLanes), unit);
            reach2[i / kLanes][i % kLanes] = here2;
            largest2 = std::max(largest2, here2);
            box.Add(Point(i));
            cone.Add(unit);
        }
        if (suspects == kAllPoints) return suspects;
        const auto someFaceAway = [&](const FourNodes& nodes) {
            return nodes.normals.LeastDots(cone) < Splat(kSafe);
        };
        surface_.Tree().ForEachFourNear(
            box, someFaceAway, largest2, [&](const FourTriangles& faces, const auto&) {
                const PreparedTriangle<Float4> prepared = faces.Prepared();
                const int thin = LaneBits(AreThin(prepared));
                for (int lane = 0; lane < kLanes; ++lane) {
                    const PreparedTriangle<float> face = Lane(prepared, lane);
                    for (std::size_t four = 0; four < kFours; ++four) {
                        const Vector3<Float4>& n = along[four];
                        const Float4 dot = face.nx * n.x + face.ny * n.y + face.nz * n.z;
                        const Int4 away = (dot < Splat(kSafe)) | Splat(-(thin >> lane & 1));
                        if (!AnyLane(away)) continue;
                        const Int4 near = Distances2(four, Lane(faces.a, lane), face) <= reach2[four];
                        suspects |= static_cast<unsigned>(LaneBits(away & near)) << (kLanes * four);
                    }
                }
                return suspects == kAllPoints ? -1.0F : largest2;
            });
        return suspects;
    }
};

} // namespace vcg_ext
