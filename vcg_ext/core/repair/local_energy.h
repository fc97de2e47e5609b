// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/repair/local_samples.h"

namespace vcg_ext
{

/// Calls visit(f) for every face f around \p v.
template <class Visit>
void ForEachFaceAround(const SurfaceArrays& surface, std::uint32_t v, const Visit& visit)
{
    for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c) visit(FaceOf(*c));
}

/// Of the faces around \p v, by their areas; of length 1 unless they have next to none.
inline Vector3<float> StarNormal(const SurfaceArrays& surface, std::uint32_t v)
{
    Vector3<float> sum{};
    ForEachFaceAround(surface, v, [&](std::uint32_t f) { sum = sum + AreaVector(surface, f); });
    return (1 / std::max(Norm(sum), std::sqrt(kSmallestSquare))) * sum;
}

inline void SortUnique(std::vector<std::uint32_t>& values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The distances between both surfaces near one face of the simplified one: area times squared distance, from
/// samples of the original nearby, and back from the faces that change.
class LocalEnergy
{
    static constexpr std::size_t kMaxSamples = 100;

    const FaceTree& original_;
    const FaceTree& simplified_; ///< the surface before the first change
    const SurfaceArrays& surface_;
    std::vector<std::uint32_t> changed_; ///< faces since then, sorted
    LocalSamples samples_;
    std::vector<std::uint32_t> region_,
        others_; ///< faces around the one, and those that samples may be closer to

  public:
    LocalEnergy(const FaceTree& original, const FaceTree& simplified, const SurfaceArrays& surface)
        : original_(original), simplified_(simplified), surface_(surface)
    {
    }

    /// All faces that are not as they were at the start, in ascending order.
    const std::vector<std::uint32_t>& Changed() const { return changed_; }
    void MarkChanged(std::uint32_t face)
    {
        const auto at = std::lower_bound(changed_.begin(), changed_.end(), face);
        if (at == changed_.end() || *at != face) changed_.insert(at, face);
    }

    /// From now on around \p face: the faces around it may change, the original's samples near them count.
    void Center(std::uint32_t face)
    {
        region_.clear();
        for (const std::uint32_t v : surface_.triangles[face].v)
            ForEachFaceAround(surface_, v, [&](std::uint32_t f) { region_.push_back(f); });
        SortUnique(region_);
        Box3<float> box = EmptyBox<float>();
        float distance2 = 0;
        for (const std::uint32_t f : region_) {
            distance2 = std::max(distance2, original_.Distance2(Centroid(surface_, f)));
            for (const std::uint32_t v : surface_.triangles[f].v) box.Add(PositionOf(surface_, v));
        }
        const float margin = 2 * std::sqrt(distance2);
        box.Grow(margin);
        TakeSamples(box);
        box.Grow(margin);
        AddFarFaces(box);
    }

    /// Of the faces around, only \p faces change from now on.
    void LetChange(const std::vector<std::uint32_t>& faces)
    {
        samples_.ForgetElsewhere();
        for (const std::uint32_t f : region_)
            if (std::find(faces.begin(), faces.end(), f) == faces.end())
                samples_.AddElsewhere(Placed(surface_, surface_.triangles[f]));
    }

    /// The energy with \p faces in the place of those that change; any number above \p limit where it is
    /// above that.
    float Of(const std::vector<PlacedTriangle>& faces, float limit) const
    {
        // of a face's area, on its centroid, the midpoints of its edges and its corners: exact for cubics
        constexpr float kCentroid = 9.0F / 20, kMidpoint = 2.0F / 15, kCorner = 1.0F / 20;
        float energy = samples_.Energy(faces, limit);
        for (const PlacedTriangle& face : faces) {
            if (energy > limit) break;
            const Vector3<float> b = face.ToSecond(), c = face.ToThird();
            const auto at = [&](const Vector3<float>& p) { return original_.Distance2(face.origin + p); };
            energy += face.shape.doubleArea / 2 *
                      (kCentroid * at((1.0F / 3) * (b + c)) +
                       kMidpoint * (at(0.5F * b) + at(0.5F * c) + at(0.5F * (b + c))) +
                       kCorner * (at(Vector3<float>{}) + at(b) + at(c)));
        }
        return energy;
    }

  private:
    Box3<float> BoxOf(std::uint32_t face) const
    {
        Box3<float> box = EmptyBox<float>();
        for (const std::uint32_t v : surface_.triangles[face].v) box.Add(PositionOf(surface_, v));
        return box;
    }
    void TakeSamples(const Box3<float>& box)
    {
        constexpr float kCentroidShare = 0.4F, kCornerShare = 0.2F; // as the samples of the refinement
        samples_.Clear();
        original_.ForEachNear(box, [&](std::uint32_t, const Vector3<float>& a, const Vector3<float>& ab,
                                       const Vector3<float>& ac) {
            const float area = Norm(Cross(ab, ac)) / 2;
            const auto add = [&](const Vector3<float>& p, float share) {
                if (box.Has(p)) samples_.Add(p, share * area);
            };
            add(a + (1.0F / 3) * (ab + ac), kCentroidShare);
            for (const Vector3<float>& corner : {a, a + ab, a + ac}) add(corner, kCornerShare);
        });
        samples_.Begin(kMaxSamples);
    }
    /// The faces beyond the region that samples may be closer to.
    void AddFarFaces(const Box3<float>& box)
    {
        others_.clear();
        for (const std::uint32_t f : changed_)
            if (box.Meets(BoxOf(f))) others_.push_back(f);
        simplified_.ForEachNear(box, [&](std::uint32_t f, const auto&...) { others_.push_back(f); });
        SortUnique(others_);
        for (const std::uint32_t f : others_)
            if (!std::binary_search(region_.begin(), region_.end(), f) && box.Meets(BoxOf(f)))
                samples_.AddFar(Placed(surface_, surface_.triangles[f]));
    }
};

} // namespace vcg_ext
