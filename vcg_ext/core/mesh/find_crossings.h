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
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// Two faces that cross, the smaller index first.
using CrossingPair = std::pair<std::uint32_t, std::uint32_t>;

/// In the frame: by how much boxes are taken for larger, so that rounding to single precision hides nothing.
constexpr float kBoxMargin = 1e-3F;

/// The corners of a mesh's faces for exact tests, in a unit in which all numbers are about 1: that only
/// shifts their exponents.
class ExactFaces
{
    std::vector<ExactPoint> points_;
    const std::uint32_t* triangles_;

  public:
    /// \pre the view's triangles outlive this object
    explicit ExactFaces(const MeshView& view) : points_(view.vertexCount), triangles_(view.triangles)
    {
        double largest = 0;
        for (std::size_t v = 0; v < view.vertexCount; ++v) {
            const std::array<double, 3> p = view.Position(v);
            points_[v] = {p[0], p[1], p[2]};
            for (const double x : p)
                if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        }
        if (largest == 0) return;
        const int exponent = std::ilogb(largest);
        for (ExactPoint& p : points_)
            p = {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
    }

    ExactTriangle operator[](std::uint32_t face) const
    {
        const std::uint32_t* v = triangles_ + 3 * std::size_t{face};
        return {points_[v[0]], points_[v[1]], points_[v[2]]};
    }
};

namespace find_crossings_detail
{

/// Adds the pairs of a face of \p leaf with one of the same leaf or a later one.
inline void AddCrossingsOfLeaf(const FaceTree& tree, const ExactFaces& exact, std::size_t leaf,
                               std::vector<CrossingPair>& found)
{
    const LeafFaces faces = tree.FacesOfLeaf(leaf);
    Box3<float> around = EmptyBox<float>();
    for (std::size_t i = 0; i < faces.count; ++i) {
        around.Add(faces.BoxOf(i).low);
        around.Add(faces.BoxOf(i).high);
    }
    around.Grow(kBoxMargin);
    tree.ForEachLeafNear(around, leaf, [&](std::size_t other) {
        const LeafFaces others = other == leaf ? faces : tree.FacesOfLeaf(other);
        for (std::size_t i = 0; i < faces.count; ++i) {
            Box3<float> box = faces.BoxOf(i);
            box.Grow(kBoxMargin);
            int met = 0;
            for (std::size_t four = 0; four < others.fours; ++four)
                met |= LaneBits(others.boxes[four].Meet(box)) << (kLanes * four);
            for (std::size_t k = other == leaf ? i + 1 : 0; k < others.count; ++k) {
                if ((met >> k & 1) == 0) continue;
                const std::uint32_t f = faces.faces[i], g = others.faces[k];
                if (TrianglesCross(exact[f], exact[g])) found.emplace_back(std::min(f, g), std::max(f, g));
            }
        }
    });
}

} // namespace find_crossings_detail

/// All pairs of faces that cross, in ascending order: the same for any number of threads.
/// \param tree of the view's faces \param threads used as they are \pre finite coordinates
inline std::vector<CrossingPair> FindCrossings(const MeshView& view, const FaceTree& tree, int threads)
{
    constexpr std::size_t kGrain = 64;
    const ExactFaces exact(view);
    std::vector<std::vector<CrossingPair>> parts(tree.LeafCount() / kGrain + 1);
    ParallelRanges(threads, tree.LeafCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t leaf = begin; leaf < end; ++leaf)
            find_crossings_detail::AddCrossingsOfLeaf(tree, exact, leaf, parts[begin / kGrain]);
    });
    std::vector<CrossingPair> found;
    for (const auto& part : parts) found.insert(found.end(), part.begin(), part.end());
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace vcg_ext
