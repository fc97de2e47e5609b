// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "buffer.h"
#include "parallel.h"
#include "point_triangle.h"
#include "simd.h"

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

    void Put(std::size_t lane, const Vector3& p)
    {
        row[0][lane] = p.x;
        row[1][lane] = p.y;
        row[2][lane] = p.z;
    }
    Vector3 At(std::size_t lane) const { return {row[0][lane], row[1][lane], row[2][lane]}; }
    Float4 operator[](std::size_t k) const { return Load(row[k]); }
};

/// A leaf.
struct FourTriangles {
    FourVectors a, b, c; ///< the first corner, and the others seen from it

    FourPoints Seen(const Vector3& p) const { return {p.x - a[0], p.y - a[1], p.z - a[2]}; }
    PreparedTriangle<Float4> Prepared() const { return PrepareTriangle(b[0], b[1], b[2], c[0], c[1], c[2]); }
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
        const Vector3 l = low.At(lane), h = high.At(lane);
        return {{l.x, l.y, l.z}, {h.x, h.y, h.z}};
    }
    Box Around() const
    {
        return {{MinLane(low[0]), MinLane(low[1]), MinLane(low[2])},
                {MaxLane(high[0]), MaxLane(high[1]), MaxLane(high[2])}};
    }
    /// Squared distances from \p p.
    Float4 Distances2(const Vector3& p) const
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
    Float4 LeastDots(const Vector3& direction) const
    {
        const float n[3] = {direction.x, direction.y, direction.z};
        Float4 least{};
        for (std::size_t k = 0; k < 3; ++k) least += Min(n[k] * low[k], n[k] * high[k]);
        return least;
    }
    /// The greatest.
    Float4 GreatestDots(const Vector3& direction) const { return -LeastDots(-1.0F * direction); }
};

struct FourNodes {
    FourBoxes points, normals;
};

/// The boxes of the points and of the unit normals of all that is in a node.
inline std::pair<Box, Box> BoxesOf(const FourTriangles& leaf)
{
    const PreparedTriangle<Float4> t = leaf.Prepared();
    const Float4 normal[3] = {t.nx, t.ny, t.nz};
    Box points{}, normals{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Float4 a = leaf.a[k], b = a + leaf.b[k], c = a + leaf.c[k];
        points.low[k] = MinLane(Min(a, Min(b, c)));
        points.high[k] = MaxLane(Max(a, Max(b, c)));
        normals.low[k] = MinLane(normal[k]);
        normals.high[k] = MaxLane(normal[k]);
    }
    return {points, normals};
}
inline std::pair<Box, Box> BoxesOf(const FourNodes& nodes)
{
    return {nodes.points.Around(), nodes.normals.Around()};
}

/// The level above: four consecutive nodes are the children of one.
template <class Nodes>
Buffer<FourNodes> LevelAbove(const Nodes& nodes, int threads)
{
    constexpr std::size_t kGrain = 4096;
    constexpr Box kEmpty{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    Buffer<FourNodes> level((nodes.size() + kLanes - 1) / kLanes);
    ParallelRanges(threads, level.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::size_t child = kLanes * i + lane;
                const auto [points, normals] =
                    child < nodes.size() ? BoxesOf(nodes[child]) : std::pair{kEmpty, kEmpty};
                level[i].points.Put(lane, points);
                level[i].normals.Put(lane, normals);
            }
    });
    return level;
}

} // namespace vcg_ext::face_tree
