// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/repair/local_repair.h"

namespace vcg_ext
{

/// For LocalRepair: faces that are folded.
class FoldFaults
{
    const FaceTree& original_;
    const SurfaceArrays& surface_;

  public:
    static constexpr bool kAreFolds = true;
    static constexpr std::uint32_t kMaxStar = std::numeric_limits<std::uint32_t>::max();

    FoldFaults(const FaceTree& original, const SurfaceArrays& surface)
        : original_(original), surface_(surface)
    {
    }

    int Count(const FacesInPlace& faces, int enough) const { return CountFolded(original_, faces, enough); }

    float Slack2(std::uint32_t) const { return 0; }

    /// Away from the side that is too close, or across the opposite edge.
    void AddPlaces(std::uint32_t face, std::uint32_t v, std::vector<Vector3<float>>& places) const
    {
        const Vector3<float> here = PositionOf(surface_, v);
        AddPlacesAlongNormals(face, v, here, places);
        const SurfaceTriangle& t = surface_.triangles[face];
        int k = 0;
        while (t.v[k] != v) ++k;
        const Vector3<float> p = PositionOf(surface_, t.v[kNextIndex[k]]);
        const Vector3<float> edge = PositionOf(surface_, t.v[kPreviousIndex[k]]) - p;
        const float along = Dot(here - p, edge) / std::max(SquaredNorm(edge), kSmallestSquare);
        const Vector3<float> toEdge = p + along * edge - here;
        for (const float s : {1.2F, 1.5F, 2.0F, 4.0F}) places.push_back(here + s * toEdge);
    }

    void LetChange(const std::vector<std::uint32_t>&) {}
    void Keep(std::uint32_t) {}
    void Put(std::uint32_t) {}
    void PutBack(std::uint32_t) {}
    void MarkChanged(std::uint32_t) {}

  private:
    /// Of the face and of the star, by parts of the distance to where the original faces along the face.
    void AddPlacesAlongNormals(std::uint32_t face, std::uint32_t v, const Vector3<float>& here,
                               std::vector<Vector3<float>>& places) const
    {
        const Vector3<float> normal = NormalOf(Placed(surface_, surface_.triangles[face]).shape);
        const float reach2 = original_.DistanceAlong2(Centroid(surface_, face), normal);
        if (!(reach2 < std::numeric_limits<float>::max())) return;
        const Vector3<float> star = StarNormal(surface_, v);
        for (const float s : {0.1F, 0.2F, 0.4F, 0.7F, 1.0F, 1.5F, 2.0F, 3.0F})
            for (const Vector3<float>& step : {normal, star, -1.0F * star})
                places.push_back(here + (s * std::sqrt(reach2)) * step);
    }
};

} // namespace vcg_ext
