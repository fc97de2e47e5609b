// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

// Normals that corners are shaded with make an edge hard where its two faces have different ones at an end.
// There it becomes a seam: the normals themselves guide nothing, and are computed anew from the result.

/// Finds the sides of hard edges: corners of a vertex whose normals are joined by a chain of small steps are
/// on the same one.
class SideFinder
{
    static constexpr std::size_t kGrain = 4096;
    /// Cosine of 30 degrees. Programs that shade by angle call more than that hard; and normals that were
    /// computed on either side of a cut through a smooth surface are apart by less.
    static constexpr float kSmooth = 0.8660254F;
    /// Cosine of a degree: normals that are given as one may be apart by rounding, of bytes at most.
    static constexpr float kSame = 0.9998477F;
    /// Above so many corners of a vertex, normals in one of small cells count as one, as every pair is tried.
    static constexpr std::size_t kMany = 64;
    static constexpr float kCellsToOne = 16; ///< some three degrees each

    /// What a range of vertices has.
    struct Counts {
        std::size_t hardEnds = 0; ///< of hard edges
        std::size_t vertices = 0; ///< on a face
        std::size_t uneven = 0;   ///< of them: with normals that differ on one side
    };
    /// Of the corners of one vertex those that are compared.
    struct Compared {
        std::vector<std::uint32_t> corners;
        std::map<std::array<int, 3>, std::uint32_t> ofCells; ///< where there are many
    };

    const MeshView& view_;
    const std::vector<Vector3<float>>& normals_; ///< of every corner
    std::vector<std::uint32_t> begin_, corners_; ///< of every vertex, as 3 face + k, ascending
    std::vector<std::uint32_t> sides_;

  public:
    /// \param normals unit vectors, or zero where there is none \pre both outlive this
    SideFinder(const MeshView& view, const std::vector<Vector3<float>>& normals)
        : view_(view), normals_(normals), begin_(view.vertexCount + 2, 0), corners_(3 * view.faceCount),
          sides_(3 * view.faceCount)
    {
        for (std::size_t i = 0; i < corners_.size(); ++i) ++begin_[view.triangles[i] + 2];
        for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
        for (std::uint32_t i = 0; i < corners_.size(); ++i) corners_[begin_[view.triangles[i] + 1]++] = i;
    }

    /// Of every corner the first one on its side; empty where all are on one side, or where faces are shaded
    /// one by one, which says nothing of the surface: a fifth of all edges would be hard, or normals differ
    /// by a little on one side at more than half of the vertices.
    std::vector<std::uint32_t> Find(int threads)
    {
        constexpr std::size_t kFifth = 5;
        std::vector<Counts> parts(view_.vertexCount / kGrain + 1);
        ParallelRanges(threads, view_.vertexCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            Compared compared;
            for (std::size_t v = begin; v < end; ++v) JoinCorners(v, compared, parts[begin / kGrain]);
        });
        Counts all;
        for (const Counts& part : parts) {
            all.hardEnds += part.hardEnds;
            all.vertices += part.vertices;
            all.uneven += part.uneven;
        }
        if (all.hardEnds == 0 || kFifth * all.hardEnds >= corners_.size()) return {};
        if (2 * all.uneven > all.vertices) return {};
        return std::move(sides_);
    }

  private:
    bool SaysSomething(std::uint32_t corner) const { return SquaredNorm(normals_[corner]) > 0; }
    bool IsSmooth(std::uint32_t a, std::uint32_t b) const { return Dot(normals_[a], normals_[b]) >= kSmooth; }

    void JoinCorners(std::size_t vertex, Compared& compared, Counts& counts)
    {
        const std::uint32_t begin = begin_[vertex], end = begin_[vertex + 1];
        if (begin == end) return;
        compared.corners.clear();
        compared.ofCells.clear();
        for (std::uint32_t i = begin; i < end; ++i)
            if (SaysSomething(corners_[i])) Join(corners_[i], end - begin > kMany, compared);
        // Those without a normal are on the first side.
        const std::uint32_t ofOthers =
            compared.corners.empty() ? corners_[begin] : sides_[compared.corners.front()];
        std::size_t sides = 0;
        bool uneven = false;
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t corner = corners_[i];
            const bool says = SaysSomething(corner);
            std::uint32_t& side = sides_[corner];
            side = says ? sides_[side] : ofOthers; // that of the one in the same cell
            sides += says && side == corner;
            uneven = uneven || (says && Dot(normals_[corner], normals_[side]) < kSame);
        }
        ++counts.vertices;
        counts.uneven += uneven;
        // As many hard edges end at a vertex as it has sides, unless that is one.
        counts.hardEnds += sides > 1 ? sides : 0;
    }

    /// Puts a corner on the side of those before it that it is smooth with, which makes all of theirs one.
    void Join(std::uint32_t corner, bool many, Compared& compared)
    {
        sides_[corner] = corner;
        if (many) {
            const auto [cell, isNew] = compared.ofCells.emplace(CellOf(normals_[corner]), corner);
            if (!isNew) {
                sides_[corner] = cell->second;
                return;
            }
        }
        compared.corners.push_back(corner);
        for (const std::uint32_t other : compared.corners) {
            const std::uint32_t a = sides_[corner], b = sides_[other];
            if (a == b || !IsSmooth(corner, other)) continue;
            for (const std::uint32_t c : compared.corners)
                if (sides_[c] == a || sides_[c] == b) sides_[c] = std::min(a, b);
        }
    }
    static std::array<int, 3> CellOf(const Vector3<float>& n)
    {
        const auto of = [](float x) { return static_cast<int>(std::floor(kCellsToOne * x)); };
        return {of(n.x), of(n.y), of(n.z)};
    }
};

/// A view whose hard edges are seams, where it has normals that make some; otherwise the view as it is.
class SidedInput
{
    MeshView view_;
    CornerAttributes attributes_;
    std::vector<std::uint32_t> sides_;

  public:
    /// \param input as it came: its vertices have the normals \param view what is left of it
    /// \param faceOrigin faceOrigin(f): the input's face that the view's face f is
    template <class FaceOrigin>
    SidedInput(const MeshView& input, const MeshView& view, const FaceOrigin& faceOrigin, int threads)
        : view_(view)
    {
        // Without a weld a vertex has one normal.
        const bool welded = view.triangles != input.triangles;
        if (!input.cornerNormals && !(input.vertexNormals && welded && !IsSoup(input))) return;
        std::vector<Vector3<float>> normals(3 * view.faceCount);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const std::size_t corner = 3 * std::size_t{faceOrigin(static_cast<std::uint32_t>(i / 3))} + i % 3;
            const float* n = input.cornerNormals
                                 ? input.cornerNormals + 3 * corner
                                 : input.vertexNormals + std::size_t{3} * input.triangles[corner];
            normals[i] = Unit({n[0], n[1], n[2]});
        }
        sides_ = SideFinder(view, normals).Find(UsefulThreadCount(threads, view.faceCount));
        if (sides_.empty()) return;
        if (view.attributes) attributes_ = *view.attributes;
        attributes_.sides = sides_.data();
        view_.attributes = &attributes_;
    }
    SidedInput(const SidedInput&) = delete;
    SidedInput& operator=(const SidedInput&) = delete;

    const MeshView& View() const { return view_; }

  private:
    /// Zero where it has no length, or is no number.
    static Vector3<float> Unit(const Vector3<double>& n)
    {
        const double length = Norm(n);
        if (!(length > 0 && std::isfinite(length))) return {0, 0, 0};
        return {static_cast<float>(n.x / length), static_cast<float>(n.y / length),
                static_cast<float>(n.z / length)};
    }

    /// Have more than 80 % of the corners a vertex of their own? Then normals of vertices are those of faces,
    /// and say nothing.
    static bool IsSoup(const MeshView& view)
    {
        std::vector<bool> used(view.vertexCount);
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3 * view.faceCount; ++i) {
            count += !used[view.triangles[i]];
            used[view.triangles[i]] = true;
        }
        return 5 * count > 4 * 3 * view.faceCount;
    }
};

} // namespace vcg_ext
