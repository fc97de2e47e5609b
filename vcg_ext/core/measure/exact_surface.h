// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// The faces of a mesh for distances in double precision. Its tree, in single precision, says which faces may
/// be the closest; those are then measured. Everything is in the frame of the tree. Queries may run on
/// several threads.
class ExactSurface
{
    const MeshView& view_;
    const FaceTree& tree_;
    double slack_;

  public:
    /// To single precision.
    static Vector3<float> Rounded(const Vector3<double>& p)
    {
        return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }

    /// \param tree of the view's faces \param slack RoundingOf the two meshes that are compared
    /// \pre all outlive this object; at least one face
    ExactSurface(const MeshView& view, const FaceTree& tree, float slack)
        : view_(view), tree_(tree), slack_(static_cast<double>(slack))
    {
    }

    const FaceTree& Tree() const { return tree_; }
    double Slack() const { return slack_; }
    std::size_t FaceCount() const { return view_.faceCount; }
    Vector3<double> Vertex(std::size_t v) const
    {
        const std::array<double, 3> p = view_.Position(v);
        const Frame& frame = tree_.frame();
        return {(p[0] - frame.center[0]) * frame.scale, (p[1] - frame.center[1]) * frame.scale,
                (p[2] - frame.center[2]) * frame.scale};
    }
    Vector3<double> Corner(std::size_t f, std::size_t k) const { return Vertex(view_.triangles[3 * f + k]); }
    double Distance2ToFace(std::size_t f, const Vector3<double>& p) const
    {
        const Vector3<double> a = Corner(f, 0);
        return ClosestOnTriangle(p - a, Corner(f, 1) - a, Corner(f, 2) - a).distance2;
    }
    /// 2 area times the unit normal.
    Vector3<double> AreaVector(std::size_t f) const
    {
        const Vector3<double> a = Corner(f, 0);
        return Cross(Corner(f, 1) - a, Corner(f, 2) - a);
    }

    /// Squared distance up to which a face may still be the closest, if one is at \p nearest2.
    float Reach2(double nearest2) const
    {
        const double reach = std::sqrt(nearest2) + slack_;
        return static_cast<float>(std::min<double>(reach * reach, std::numeric_limits<float>::max()));
    }

    /// What one thread needs for its queries. Queries that follow each other should be close to each other.
    struct Search {
        std::vector<FaceTree::Candidate> found;
        std::optional<std::uint32_t> last; ///< the closest face of the last query
        double nearest2 = 0;               ///< its squared distance
    };

    /// Squared distance of \p p to the surface.
    double Distance2(const Vector3<double>& p, Search& search) const
    {
        FindClosest(p, search);
        return search.nearest2;
    }

    /// The same where it is at most \p limit2, with the closest face in search.last; nothing where it is
    /// more.
    std::optional<double> Distance2Within(const Vector3<double>& p, double limit2, Search& search) const
    {
        const std::optional<std::uint32_t> before = search.last;
        FindClosest(p, search, std::nextafter(limit2, std::numeric_limits<double>::infinity()));
        if (search.nearest2 <= limit2) return search.nearest2;
        search.last = before;
        return std::nullopt;
    }

    /// The larger of \p known2 and the squared distance of \p p: where some face is closer than that, most
    /// often the last one, the closest is not looked for.
    double LargerDistance2(const Vector3<double>& p, double known2, Search& search) const
    {
        if (search.last && Distance2ToFace(*search.last, p) <= known2) return known2;
        if (const auto near = tree_.FaceWithin(Rounded(p), static_cast<float>(known2));
            near && Distance2ToFace(near->face, p) <= known2) {
            search.last = near->face;
            return known2;
        }
        return std::max(known2, Distance2(p, search));
    }

    /// Whether the face closest to \p p is turned by more than 90 degrees against \p direction. Of several
    /// that are equally close, as on both sides of an edge, one that is not is enough.
    bool FacesAwayFrom(const Vector3<double>& p, const Vector3<double>& direction, Search& search) const
    {
        constexpr double kTie = 1 + 1e-9; // of squared distances in double precision
        constexpr double kZero2 = 1e-18;  // 1e-12 of the diagonal, squared
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        double along2 = kInfinity, away2 = kInfinity;
        if (NoneNearFacesAway(p, direction, search)) return false;
        FindClosest(p, search);
        search.found.push_back({0, *search.last});
        for (const FaceTree::Candidate& candidate : search.found) {
            double& side2 = Dot(AreaVector(candidate.face), direction) < 0 ? away2 : along2;
            side2 = std::min(side2, Distance2ToFace(candidate.face, p));
        }
        return away2 * kTie + kZero2 < along2;
    }

  private:
    /// Does no face turn away that is as close as the last one, which does not? Most often that is so, and is
    /// seen sooner than the closest face is found.
    bool NoneNearFacesAway(const Vector3<double>& p, const Vector3<double>& direction,
                           const Search& search) const
    {
        const double length = Norm(direction);
        if (!search.last || !(length > 0) || Dot(AreaVector(*search.last), direction) < 0) return false;
        const double reach2 = Distance2ToFace(*search.last, p);
        return !tree_.MayFaceAway(Rounded(p), Rounded((1 / length) * direction), Reach2(reach2));
    }

    /// Finds the closest face, search.last, its distance and what may be as close.
    /// \param limit2 farther faces are of no interest
    void FindClosest(const Vector3<double>& p, Search& search,
                     double limit2 = std::numeric_limits<double>::infinity()) const
    {
        search.nearest2 = limit2;
        if (search.last) Consider(*search.last, p, search);
        const float seen2 =
            tree_.FindClosest(Rounded(p), static_cast<float>(slack_), Reach2(search.nearest2), search.found);
        for (const FaceTree::Candidate& candidate : search.found) Consider(candidate.face, p, search);
        // A needle's plane is rounding in single precision: it may have seemed closer than it is.
        if (static_cast<double>(Reach2(static_cast<double>(seen2))) < search.nearest2)
            tree_.ForEachInReach(Rounded(p), Reach2(search.nearest2), [&](std::uint32_t face) {
                Consider(face, p, search);
                return Reach2(search.nearest2);
            });
    }
    void Consider(std::uint32_t face, const Vector3<double>& p, Search& search) const
    {
        const double distance2 = Distance2ToFace(face, p);
        if (!(distance2 < search.nearest2)) return;
        search.nearest2 = distance2;
        search.last = face;
    }
};

/// How much single precision can be wrong, in the frame, about which face is the closest: 16 units in the
/// last place of the largest coordinate.
inline float RoundingOf(double largest)
{
    return static_cast<float>(16 * largest) * std::numeric_limits<float>::epsilon();
}

/// The same for the vertices on faces of both meshes.
inline float RoundingOf(const MeshView& a, const MeshView& b, const Frame& frame)
{
    double largest = 0;
    for (const MeshView* view : {&a, &b})
        for (std::size_t k = 0; k < 3 * view->faceCount; ++k) {
            const std::array<double, 3> p = view->Position(view->triangles[k]);
            for (std::size_t i = 0; i < 3; ++i)
                largest = std::max(largest, std::abs((p[i] - frame.center[i]) * frame.scale));
        }
    return RoundingOf(largest);
}

} // namespace vcg_ext
