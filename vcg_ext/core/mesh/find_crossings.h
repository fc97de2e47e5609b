// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/crossing_triangles.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// Two faces that cross, the smaller index first.
using CrossingPair = std::pair<std::uint32_t, std::uint32_t>;

/// The vertices of a mesh for exact tests, in a unit in which all numbers are about 1: that only shifts their
/// exponents.
class ExactPoints
{
    std::vector<ExactPoint> points_;
    int exponent_ = 0; ///< of the unit

  public:
    explicit ExactPoints(const MeshView& view) : points_(view.vertexCount)
    {
        double largest = 0;
        for (std::size_t v = 0; v < view.vertexCount; ++v)
            for (const double x : view.Position(v))
                if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        if (largest > 0) exponent_ = std::ilogb(largest);
        for (std::size_t v = 0; v < view.vertexCount; ++v) Put(v, view.Position(v));
    }

    const ExactPoint& operator[](std::size_t v) const { return points_[v]; }
    ExactPoint& operator[](std::size_t v) { return points_[v]; }
    /// \param p in the mesh's own unit
    void Put(std::size_t v, const std::array<double, 3>& p)
    {
        points_[v] = {std::ldexp(p[0], -exponent_), std::ldexp(p[1], -exponent_),
                      std::ldexp(p[2], -exponent_)};
    }
};

/// The corners of a mesh's faces for exact tests.
class ExactFaces
{
    ExactPoints points_;
    const std::uint32_t* triangles_;

  public:
    /// \pre the view's triangles outlive this object
    explicit ExactFaces(const MeshView& view) : points_(view), triangles_(view.triangles) {}

    ExactTriangle operator[](std::uint32_t face) const
    {
        const std::uint32_t* v = triangles_ + 3 * std::size_t{face};
        return {points_[v[0]], points_[v[1]], points_[v[2]]};
    }
};

namespace find_crossings_detail
{

/// A leaf with the boxes of its faces, and the box around them.
struct Leaf {
    LeafFaces faces;
    Box3<float> around = EmptyBox<float>();

    explicit Leaf(const LeafFaces& of) : faces(of)
    {
        for (std::size_t i = 0; i < faces.count; ++i) {
            around.Add(faces.BoxOf(i).low);
            around.Add(faces.BoxOf(i).high);
        }
    }
};

/// Adds the pairs of a face of \p leaf with one of \p other; of each pair once where both are the same.
inline void AddCrossingsOf(const Leaf& leaf, const Leaf& other, const ExactFaces& exact,
                           std::vector<CrossingPair>& found)
{
    const bool isSame = &leaf == &other;
    for (std::size_t i = 0; i < leaf.faces.count; ++i) {
        Box3<float> box = leaf.faces.BoxOf(i);
        box.Grow(kBoxMargin);
        if (!box.Meets(other.around)) continue;
        unsigned met = 0;
        for (std::size_t four = 0; four < other.faces.fours; ++four)
            met |= static_cast<unsigned>(LaneBits(other.faces.boxes[four].Meet(box))) << (kLanes * four);
        met &= (1U << other.faces.count) - 1;
        if (isSame) met &= ~((2U << i) - 1);
        for (std::size_t k = 0; met != 0; ++k, met >>= 1) {
            if ((met & 1) == 0) continue;
            const std::uint32_t f = leaf.faces.faces[i], g = other.faces.faces[k];
            if (TrianglesCross(exact[f], exact[g])) found.emplace_back(std::min(f, g), std::max(f, g));
        }
    }
}

} // namespace find_crossings_detail

/// All pairs of faces that cross, in ascending order: the same for any number of threads.
/// \param tree of the view's faces \param threads used as they are \pre finite coordinates
inline std::vector<CrossingPair> FindCrossings(const MeshView& view, const FaceTree& tree, int threads)
{
    using namespace find_crossings_detail;
    constexpr std::size_t kGrain = 64;
    const ExactFaces exact(view);
    std::vector<Leaf> leaves;
    leaves.reserve(tree.LeafCount());
    for (std::size_t leaf = 0; leaf < tree.LeafCount(); ++leaf) leaves.emplace_back(tree.FacesOfLeaf(leaf));
    std::vector<std::vector<CrossingPair>> parts(leaves.size() / kGrain + 1);
    ParallelRanges(threads, leaves.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t leaf = begin; leaf < end; ++leaf) {
            Box3<float> box = leaves[leaf].around;
            box.Grow(kBoxMargin);
            tree.ForEachLeafNear(box, leaf, [&](std::size_t other) {
                AddCrossingsOf(leaves[leaf], leaves[other], exact, parts[begin / kGrain]);
            });
        }
    });
    std::vector<CrossingPair> found;
    for (const auto& part : parts) found.insert(found.end(), part.begin(), part.end());
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace vcg_ext
