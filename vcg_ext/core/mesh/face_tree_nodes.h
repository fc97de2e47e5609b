// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/base/float4.h"

// The nodes of a FaceTree: four children side by side, so that they are tested at once.

namespace vcg_ext::face_tree
{

constexpr float kFar = std::numeric_limits<float>::max();

/// Of points, or of unit normals.
struct Box {
    std::array<float, 3> low, high;
};
inline bool Overlap(const Box& a, const Box& b)
{
    for (std::size_t k = 0; k < 3; ++k)
        if (!(a.low[k] <= b.high[k] && b.low[k] <= a.high[k])) return false;
    return true;
}

/// Four vectors, one in each column.
struct alignas(16) FourVectors {
    float row[3][kLanes];

    void Put(std::size_t lane, const Vector3<float>& p)
    {
        row[0][lane] = p.x;
        row[1][lane] = p.y;
        row[2][lane] = p.z;
    }
    Vector3<float> At(std::size_t lane) const { return {row[0][lane], row[1][lane], row[2][lane]}; }
    Float4 operator[](std::size_t k) const { return Load(row[k]); }
};

/// Some faces of a leaf.
struct FourTriangles {
    Vector3<Float4> a, b, c; ///< the first corner, and the others seen from it

    Vector3<Float4> Seen(const Vector3<float>& p) const { return {p.x - a.x, p.y - a.y, p.z - a.z}; }
    PreparedTriangle<Float4> Prepared() const { return PrepareTriangle(b.x, b.y, b.z, c.x, c.y, c.z); }
};

struct FourBoxes {
    FourVectors low, high;

    void Put(std::size_t lane, const Box& box)
    {
        low.Put(lane, {box.low[0], box.low[1], box.low[2]});
        high.Put(lane, {box.high[0], box.high[1], box.high[2]});
    }
    Box At(std::size_t lane) const
    {
        const Vector3<float> l = low.At(lane), h = high.At(lane);
        return {{l.x, l.y, l.z}, {h.x, h.y, h.z}};
    }
    Box Around() const
    {
        return {{MinLane(low[0]), MinLane(low[1]), MinLane(low[2])},
                {MaxLane(high[0]), MaxLane(high[1]), MaxLane(high[2])}};
    }
    /// Squared distances from \p p.
    Float4 Distances2(const Vector3<float>& p) const
    {
        const float at[3] = {p.x, p.y, p.z};
        Float4 sum{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Float4 outside = Max(Max(low[k] - at[k], at[k] - high[k]), Splat(0.0F));
            sum += outside * outside;
        }
        return sum;
    }
    /// Of all vectors in each box, the least dot product with \p direction.
    Float4 LeastDots(const Vector3<float>& direction) const
    {
        const float n[3] = {direction.x, direction.y, direction.z};
        Float4 least{};
        for (std::size_t k = 0; k < 3; ++k) least += Min(n[k] * low[k], n[k] * high[k]);
        return least;
    }
    /// The greatest.
    Float4 GreatestDots(const Vector3<float>& direction) const { return -LeastDots(-1.0F * direction); }
};

struct FourNodes {
    FourBoxes points, normals;
};

/// The boxes of the points and of the unit normals of all that is in a node.
struct NodeBoxes {
    Box points{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}}, normals = points;
};
inline NodeBoxes BoxesOf(const FourNodes& nodes)
{
    return {nodes.points.Around(), nodes.normals.Around()};
}

/// NodeBoxes of faces that come four at a time.
class LeafBoxes
{
    struct Bounds {
        Float4 low[3]{Splat(kFar), Splat(kFar), Splat(kFar)};
        Float4 high[3]{Splat(-kFar), Splat(-kFar), Splat(-kFar)};
        void Add(std::size_t k, Float4 least, Float4 greatest)
        {
            low[k] = Min(low[k], least);
            high[k] = Max(high[k], greatest);
        }
        Box AllLanes() const
        {
            return {{MinLane(low[0]), MinLane(low[1]), MinLane(low[2])},
                    {MaxLane(high[0]), MaxLane(high[1]), MaxLane(high[2])}};
        }
    };
    Bounds points_, normals_;

  public:
    void Add(const FourTriangles& faces)
    {
        const PreparedTriangle<Float4> t = faces.Prepared();
        const Float4 normal[3] = {t.nx, t.ny, t.nz};
        const Float4 first[3] = {faces.a.x, faces.a.y, faces.a.z};
        const Float4 second[3] = {faces.b.x, faces.b.y, faces.b.z};
        const Float4 third[3] = {faces.c.x, faces.c.y, faces.c.z};
        for (std::size_t k = 0; k < 3; ++k) {
            const Float4 a = first[k], b = a + second[k], c = a + third[k];
            points_.Add(k, Min(a, Min(b, c)), Max(a, Max(b, c)));
            normals_.Add(k, normal[k], normal[k]);
        }
    }
    NodeBoxes Boxes() const { return {points_.AllLanes(), normals_.AllLanes()}; }
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
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::size_t child = kLanes * i + lane;
                const NodeBoxes boxes = child < children ? boxesOf(child) : NodeBoxes{};
                level[i].points.Put(lane, boxes.points);
                level[i].normals.Put(lane, boxes.normals);
            }
    });
    return level;
}

} // namespace vcg_ext::face_tree
