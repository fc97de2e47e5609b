// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/crossing_triangles.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/find_crossings.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/star_crossings.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/repair/local_repair.h"

namespace vcg_ext
{

/// For LocalRepair: pairs of faces that cross, exactly as the caller will have them.
class CrossingFaults
{
    const FaceTree& simplified_; ///< the surface before the first change
    const SurfaceArrays& surface_;
    bool floats_;        ///< the caller's coordinates are
    float rounding_ = 0; ///< in the frame, of the caller's coordinates where they are floats
    ExactPoints points_;
    std::vector<std::uint32_t> changed_; ///< faces since the start, sorted
    std::vector<std::uint32_t> changing_;
    ExactPoint kept_{};

  public:
    static constexpr bool kAreFolds = false;
    static constexpr std::uint32_t kMaxStar = 64; ///< as each of them is tested against each

    /// \param mesh the surface \param simplified of its faces, which have not changed yet
    /// \param floats the coordinates of the original are floats
    CrossingFaults(const MeshView& mesh, const FaceTree& simplified, const SurfaceArrays& surface,
                   bool floats)
        : simplified_(simplified), surface_(surface), floats_(floats), points_(mesh)
    {
        if (!floats) return;
        double largest = 0;
        for (std::size_t v = 0; v < mesh.vertexCount; ++v)
            for (const double x : mesh.Position(v)) largest = std::max(largest, std::abs(x));
        constexpr double kUlp = std::numeric_limits<float>::epsilon();
        rounding_ = static_cast<float>(largest * kUlp * simplified.frame().scale);
    }

    /// Pairs of these faces, and of one of them with another of the surface's.
    int Count(const FacesInPlace& faces, int enough) const
    {
        ExactStar star;
        star.reserve(faces.corners.size());
        for (const SurfaceTriangle& t : faces.corners) star.push_back(Boxed(t));
        int count = 0;
        for (std::size_t i = 0; i < star.size(); ++i)
            for (std::size_t k = 0; k < i && count < enough; ++k) count += Cross(star[i], star[k]);
        Box3<float> around = EmptyBox<float>();
        for (const BoxedTriangle& triangle : star) {
            around.Add(triangle.box.low);
            around.Add(triangle.box.high);
        }
        if (count < enough)
            ForEachOther(around, [&](const BoxedTriangle& other, std::uint32_t) {
                for (const BoxedTriangle& triangle : star) count += Cross(triangle, other);
                return count < enough;
            });
        return count;
    }

    /// Of how deep the face and others cross: what a move of one of them away takes.
    /// \pre only the face is about to be replaced
    float Slack2(std::uint32_t face) const
    {
        constexpr float kTwice2 = 4;
        float deepest = 0;
        ForEachCrossing(face, [&](const Crossing& crossing) {
            deepest = std::max(deepest, crossing.depth);
            return true;
        });
        return kTwice2 * deepest * deepest;
    }

    /// Along the normals of the faces that the face crosses, and of the star, by parts of how deep they
    /// cross.
    void AddPlaces(std::uint32_t face, std::uint32_t v, std::vector<Vector3<float>>& places) const
    {
        const Vector3<float> here = PositionOf(surface_, v);
        const Vector3<float> star = StarNormal(surface_, v);
        ForEachCrossing(face, [&](const Crossing& crossing) {
            for (const float s : {1.1F, 1.5F, 2.5F, 5.0F})
                for (const Vector3<float>& step :
                     {crossing.normal, -1.0F * crossing.normal, star, -1.0F * star})
                    places.push_back(here + s * crossing.depth * step);
            return false; // one of them shows the way
        });
    }

    void LetChange(const std::vector<std::uint32_t>& faces) { changing_ = faces; }
    void Keep(std::uint32_t v) { kept_ = points_[v]; }
    void PutBack(std::uint32_t v) { points_[v] = kept_; }
    void Put(std::uint32_t v)
    {
        std::array<double, 3> p = simplified_.frame().OutOf(PositionOf(surface_, v));
        if (floats_)
            for (double& x : p) x = static_cast<double>(static_cast<float>(x));
        points_.Put(v, p);
    }
    void MarkChanged(std::uint32_t face)
    {
        const auto at = std::lower_bound(changed_.begin(), changed_.end(), face);
        if (at == changed_.end() || *at != face) changed_.insert(at, face);
    }

  private:
    BoxedTriangle Boxed(const SurfaceTriangle& t) const
    {
        Box3<float> box = EmptyBox<float>();
        for (const std::uint32_t v : t.v) box.Add(PositionOf(surface_, v));
        box.Grow(kBoxMargin + rounding_);
        return {{points_[t.v[0]], points_[t.v[1]], points_[t.v[2]]}, box};
    }
    static bool Cross(const BoxedTriangle& a, const BoxedTriangle& b)
    {
        return a.box.Meets(b.box) && TrianglesCross(a.corners, b.corners);
    }

    /// Calls visit(BoxedTriangle, face) for the faces near \p box that are not about to change, until one
    /// says false.
    template <class Visit>
    void ForEachOther(const Box3<float>& box, const Visit& visit) const
    {
        bool goesOn = true;
        const auto offer = [&](std::uint32_t f) {
            if (!goesOn || std::find(changing_.begin(), changing_.end(), f) != changing_.end()) return;
            const BoxedTriangle other = Boxed(surface_.triangles[f]);
            if (other.box.Meets(box)) goesOn = visit(other, f);
        };
        for (const std::uint32_t f : changed_) offer(f);
        simplified_.ForEachNear(box, [&](std::uint32_t f, const auto&...) {
            if (!std::binary_search(changed_.begin(), changed_.end(), f)) offer(f);
        });
    }

    /// One face through another, in the frame.
    struct Crossing {
        Vector3<float> normal; ///< of the other
        float depth; ///< how far one of them reaches through the other, the less of both; of faces that
                     ///< touch what is no distance elsewhere
    };
    /// Calls visit(Crossing) for the faces that cross \p face and are not about to change, until one says
    /// false.
    template <class Visit>
    void ForEachCrossing(std::uint32_t face, const Visit& visit) const
    {
        const SurfaceTriangle& t = surface_.triangles[face];
        const BoxedTriangle triangle = Boxed(t);
        ForEachOther(triangle.box, [&](const BoxedTriangle& other, std::uint32_t f) {
            if (!Cross(triangle, other)) return true;
            const SurfaceTriangle& u = surface_.triangles[f];
            const float depth = std::min(Depth(t, u), Depth(u, t));
            return visit(Crossing{UnitNormal(u), std::max(depth, std::sqrt(FaceTree::kOnSurface2))});
        });
    }

    Vector3<float> UnitNormal(const SurfaceTriangle& t) const
    {
        const Vector3<float> normal = NormalOf(Placed(surface_, t).shape);
        const float length = Norm(normal);
        return length > 0 ? (1 / length) * normal : normal;
    }
    /// How far corners of \p a are on the side of \p b on which they are less far.
    float Depth(const SurfaceTriangle& a, const SurfaceTriangle& b) const
    {
        const Vector3<float> normal = UnitNormal(b), origin = PositionOf(surface_, b.v[0]);
        float above = 0, below = 0;
        for (const std::uint32_t v : a.v) {
            const float height = Dot(PositionOf(surface_, v) - origin, normal);
            above = std::max(above, height);
            below = std::max(below, -height);
        }
        return std::min(above, below);
    }
};

} // namespace vcg_ext
