// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/point_triangle.h"

// The nodes of a FaceTree: four children side by side, so that they are tested at once.

namespace vcg_ext
{

/// Boxes of points, or of unit normals.
struct FourBoxes {
    Box3<Float4> boxes;

    void Put(int lane, const Box3<float>& box)
    {
        SetLane(boxes.low, lane, box.low);
        SetLane(boxes.high, lane, box.high);
    }
    Box3<float> At(int lane) const { return {Lane(boxes.low, lane), Lane(boxes.high, lane)}; }
    /// Which of them have a point in common with \p box.
    Int4 Meet(const Box3<float>& box) const
    {
        return (boxes.low.x <= Splat(box.high.x)) & (boxes.low.y <= Splat(box.high.y)) &
               (boxes.low.z <= Splat(box.high.z)) & (Splat(box.low.x) <= boxes.high.x) &
               (Splat(box.low.y) <= boxes.high.y) & (Splat(box.low.z) <= boxes.high.z);
    }
    /// Squared distances from \p p.
    Float4 Distances2(const Vector3<float>& p) const
    {
        const Vector3<Float4> point = Splat(p), below = boxes.low - point, above = point - boxes.high;
        const auto outside = [](Float4 a, Float4 b) { return Max(Max(a, b), Splat(0.0F)); };
        return SquaredNorm(
            Vector3<Float4>{outside(below.x, above.x), outside(below.y, above.y), outside(below.z, above.z)});
    }
    /// Of all vectors in each box, the least dot product with \p direction.
    Float4 LeastDots(const Vector3<float>& direction) const
    {
        const Vector3<float>& n = direction;
        return Min(n.x * boxes.low.x, n.x * boxes.high.x) + Min(n.y * boxes.low.y, n.y * boxes.high.y) +
               Min(n.z * boxes.low.z, n.z * boxes.high.z);
    }
    /// The greatest.
    Float4 GreatestDots(const Vector3<float>& direction) const { return -LeastDots(-1.0F * direction); }
};

/// The faces of a leaf of a FaceTree.
struct LeafFaces {
    static constexpr std::size_t kMost = 4;
    std::array<FourBoxes, kMost / kLanes> boxes;
    std::array<std::uint32_t, kMost> faces; ///< those behind the last repeat it
    std::size_t fours = 0, count = 0;

    Box3<float> BoxOf(std::size_t i) const { return boxes[i / kLanes].At(static_cast<int>(i % kLanes)); }
};

struct FourNodes {
    FourBoxes points, normals;
};

/// The boxes of the points and of the unit normals of all that is in a node.
struct NodeBoxes {
    Box3<float> points = EmptyBox<float>(), normals = EmptyBox<float>();
};
inline NodeBoxes BoxesOf(const FourNodes& nodes)
{
    return {Around(nodes.points.boxes), Around(nodes.normals.boxes)};
}

/// The boxes of four faces.
inline Box3<Float4> BoxesOf(const FourTriangles& faces)
{
    Box3<Float4> boxes{faces.a, faces.a};
    boxes.Add(faces.a + faces.b);
    boxes.Add(faces.a + faces.c);
    return boxes;
}

/// Which of four faces are so thin that rounding of their corners turns their normals by more than a
/// thousandth.
inline Int4 AreThin(const PreparedTriangle<Float4>& t)
{
    constexpr float kThin2 = 1e-2F; // squared height: a tenth, where coordinates round by 3e-5
    const Float4 longest2 = Max(t.bb, Max(t.cc, t.bb + t.cc - 2.0F * t.bc));
    return t.doubleArea * t.doubleArea < kThin2 * longest2;
}

/// NodeBoxes of faces that come four at a time. Normals of thin faces may be any.
class LeafBoxes
{
    Box3<Float4> points_ = EmptyBox<Float4>(), normals_ = EmptyBox<Float4>();

  public:
    void Add(const FourTriangles& faces)
    {
        const PreparedTriangle<Float4> t = faces.Prepared();
        points_.Add(faces.a);
        points_.Add(faces.a + faces.b);
        points_.Add(faces.a + faces.c);
        const Int4 thin = AreThin(t);
        const Float4 one = Splat(1.0F);
        normals_.Add({Select(thin, one, t.nx), Select(thin, one, t.ny), Select(thin, one, t.nz)});
        normals_.Add({Select(thin, -one, t.nx), Select(thin, -one, t.ny), Select(thin, -one, t.nz)});
    }
    NodeBoxes Boxes() const { return {Around(points_), Around(normals_)}; }
};

/// The level above \p children of them: four that follow each other are the children of one node.
/// \param boxesOf NodeBoxes of a child
template <class BoxesOfChild>
Buffer<FourNodes> LevelAbove(std::size_t children, int threads, const BoxesOfChild& boxesOf)
{
    constexpr std::size_t kGrain = 1024;
    Buffer<FourNodes> level((children + kLanes - 1) / kLanes);
    ParallelRanges(threads, level.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i)
            for (int lane = 0; lane < kLanes; ++lane) {
                const std::size_t child = kLanes * i + static_cast<std::size_t>(lane);
                const NodeBoxes boxes = child < children ? boxesOf(child) : NodeBoxes{};
                level[i].points.Put(lane, boxes.points);
                level[i].normals.Put(lane, boxes.normals);
            }
    });
    return level;
}

} // namespace vcg_ext
