// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

    const MeshView& view_;
    const std::vector<Vector3<float>>& normals_; ///< of every corner
    std::vector<std::uint32_t> begin_, corners_; ///< of every vertex, as 3 face + k, ascending
    std::vector<std::uint32_t> sides_;

  public:
    /// \pre both outlive this
    SideFinder(const MeshView& view, const std::vector<Vector3<float>>& normals)
        : view_(view), normals_(normals), begin_(view.vertexCount + 2, 0), corners_(3 * view.faceCount),
          sides_(3 * view.faceCount)
    {
        for (std::size_t i = 0; i < corners_.size(); ++i) ++begin_[view.triangles[i] + 2];
        for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
        for (std::uint32_t i = 0; i < corners_.size(); ++i) corners_[begin_[view.triangles[i] + 1]++] = i;
    }

    /// Of every corner the first one on its side; empty where all are on one side. So it is, too, where a
    /// fifth of all edges would be hard: then faces are shaded one by one, which says nothing of the surface.
    std::vector<std::uint32_t> Find(int threads)
    {
        constexpr std::size_t kFifth = 5;
        std::vector<std::size_t> hardEnds(view_.vertexCount / kGrain + 1, 0);
        ParallelRanges(threads, view_.vertexCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                // As many hard edges end at a vertex as it has sides, unless that is one.
                const std::size_t sides = JoinCorners(begin_[v], begin_[v + 1]);
                hardEnds[begin / kGrain] += sides > 1 ? sides : 0;
            }
        });
        std::size_t hard = 0;
        for (const std::size_t part : hardEnds) hard += part;
        if (hard == 0 || kFifth * hard >= corners_.size()) return {};
        return std::move(sides_);
    }

  private:
    bool SaysSomething(std::uint32_t corner) const
    {
        const float squared = Dot(normals_[corner], normals_[corner]);
        return squared > 0 && std::isfinite(squared);
    }
    bool IsSmooth(std::uint32_t a, std::uint32_t b) const
    {
        const float lengths = Norm(normals_[a]) * Norm(normals_[b]);
        return Dot(normals_[a], normals_[b]) >= kSmooth * lengths;
    }

    /// Of the corners from \p begin to \p end of one vertex. Those without a normal are on the first side.
    /// \return how many sides there are
    std::size_t JoinCorners(std::uint32_t begin, std::uint32_t end)
    {
        const auto side = [&](std::uint32_t i) -> std::uint32_t& { return sides_[corners_[i]]; };
        for (std::uint32_t i = begin; i < end; ++i) {
            side(i) = corners_[i];
            if (!SaysSomething(corners_[i])) continue;
            for (std::uint32_t j = begin; j < i; ++j) {
                if (side(i) == side(j) || !SaysSomething(corners_[j])) continue;
                if (IsSmooth(corners_[i], corners_[j])) Join(begin, i, side(i), side(j));
            }
        }
        std::size_t count = 0;
        std::uint32_t first = begin; // that has a normal
        while (first < end && !SaysSomething(corners_[first])) ++first;
        const std::uint32_t ofOthers =
            first < end ? side(first) : static_cast<std::uint32_t>(corners_.size());
        for (std::uint32_t i = begin; i < end; ++i) {
            if (!SaysSomething(corners_[i])) side(i) = ofOthers;
            count += side(i) == corners_[i];
        }
        return count;
    }
    void Join(std::uint32_t begin, std::uint32_t last, std::uint32_t a, std::uint32_t b)
    {
        for (std::uint32_t i = begin; i <= last; ++i) {
            std::uint32_t& side = sides_[corners_[i]];
            if (side == a || side == b) side = std::min(a, b);
        }
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
            normals[i] = {n[0], n[1], n[2]};
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
    /// Is nearly every corner a vertex of its own? Then normals of vertices are those of faces, and say
    /// nothing.
    static bool IsSoup(const MeshView& view)
    {
        constexpr std::size_t kOfTwenty = 16; // of 3 vertices a face: 2.4
        std::vector<bool> used(view.vertexCount);
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3 * view.faceCount; ++i) {
            count += !used[view.triangles[i]];
            used[view.triangles[i]] = true;
        }
        return 20 * count > kOfTwenty * 3 * view.faceCount;
    }
};

} // namespace vcg_ext
