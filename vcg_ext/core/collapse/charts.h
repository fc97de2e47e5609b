// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/seams.h"

namespace vcg_ext
{

/// Finds the charts of a state whose wedges are known, and marks the vertices on seams.
class ChartFinder
{
    static constexpr std::size_t kGrain = 4096;

    SweepState& state_;
    WedgeSet& set_;
    int threads_;
    Buffer<std::uint32_t> joined_; ///< of corner k of face f at 3 f + k: the face across the edge to the next
                                   ///< corner, if that is no seam and has the lower index
    std::vector<std::uint32_t> parent_;

  public:
    ChartFinder(SweepState& state, WedgeSet& set, int threads) : state_(state), set_(set), threads_(threads)
    {
    }

    void Find()
    {
        LookAcrossEdges();
        JoinFaces();
        if (set_.keepSeams) MarkSeams();
    }

  private:
    void LookAcrossEdges()
    {
        const std::size_t faces = state_.faces.size();
        joined_.Allocate(3 * faces);
        ParallelRanges(threads_, faces, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f)
                for (int k = 0; k < 3; ++k) {
                    const Corner corner = MakeCorner(static_cast<std::uint32_t>(f), k);
                    const auto across = CornerAcross(state_, corner);
                    const bool joins = across && FaceOf(*across) < f && !IsSeam(state_, set_, corner);
                    joined_[3 * f + static_cast<std::size_t>(k)] = joins ? FaceOf(*across) : kNone;
                }
        });
    }

    std::uint32_t Root(std::uint32_t f)
    {
        while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
        return f;
    }

    void JoinFaces()
    {
        const auto faces = static_cast<std::uint32_t>(state_.faces.size());
        parent_.resize(faces);
        for (std::uint32_t f = 0; f < faces; ++f) {
            parent_[f] = f;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t other = joined_[3 * std::size_t{f} + k];
                if (other == kNone) continue;
                const std::uint32_t a = Root(other), b = Root(f);
                parent_[a < b ? b : a] = a < b ? a : b; // a chart is named by its first face
            }
        }
        set_.chart.Allocate(faces);
        std::uint32_t charts = 0;
        for (std::uint32_t f = 0; f < faces; ++f) {
            const std::uint32_t root = Root(f);
            set_.chart[f] = root == f ? charts++ : set_.chart[root];
        }
        set_.chartFaces.resize(charts);
        set_.witness.resize(charts);
        joined_.Release();
        parent_ = {};
    }

    void MarkSeams()
    {
        ParallelRanges(threads_, state_.VertexCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                const auto vertex = static_cast<std::uint32_t>(v);
                if (state_.cornerCount[v] > 0) SetSeamMarks(state_, vertex, SeamMarks(state_, set_, vertex));
            }
        });
    }
};

} // namespace vcg_ext
