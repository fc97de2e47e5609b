// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/symmetric_matrix.h"
#include "vcg_ext/core/mesh/one_ring.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/parameters.h"

// Which edges are worth measuring for an exchange.

namespace vcg_ext
{

/// An edge and what it promises, without measuring samples.
struct EdgeGuess {
    float value;
    std::uint32_t a, b;
};

/// The quadric of the planes around every vertex, by area, without what the collapses have accumulated.
class PlaneQuadrics
{
    const SurfaceArrays& surface_;
    Buffer<SymmetricMatrix3<float>> quadrics_;

  public:
    PlaneQuadrics(const SurfaceArrays& surface, int threads)
        : surface_(surface), quadrics_(surface.VertexCount())
    {
        ParallelRanges(threads, surface.VertexCount(), 4096, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) quadrics_[v] = Around(static_cast<std::uint32_t>(v));
        });
    }

    /// What is left of both ends' quadrics where their sum is least.
    float CostOf(std::uint32_t a, std::uint32_t b) const
    {
        const SymmetricMatrix3<float>&qa = quadrics_[a], &qb = quadrics_[b], sum = qa + qb;
        const float added = kPlaneRegularization / 3 * sum.Trace();
        if (!(added > 0)) return 0;
        const Vector3<float> toB = PositionOf(surface_, b) - PositionOf(surface_, a);
        const Vector3<float> x = SolveRegularized(sum, qb * toB, added);
        return std::max(0.0F, QuadraticForm(qa, x) + QuadraticForm(qb, x - toB));
    }

  private:
    SymmetricMatrix3<float> Around(std::uint32_t v) const
    {
        SymmetricMatrix3<float> sum{};
        for (const Corner* c = BeginCorners(surface_, v); c != EndCorners(surface_, v); ++c) {
            const Vector3<float> n = AreaVector(surface_, FaceOf(*c));
            if (const float length = Norm(n); length > 0) sum = sum + 1 / length * OuterProduct(n);
        }
        return sum;
    }
};

/// The edges with two faces that promise most, as collapses and as places for a vertex.
class EdgeGuesses
{
    struct Lists {
        std::vector<EdgeGuess> collapses, divisions;
        std::size_t edges = 0;
    };

  public:
    std::vector<EdgeGuess> collapses; ///< what they cost
    std::vector<EdgeGuess> divisions; ///< minus the energy of the faces beside the edge

    EdgeGuesses(const RefinementState& state, int threads)
    {
        constexpr std::size_t kGrain = 2048;
        const PlaneQuadrics quadrics(state.simplified, threads);
        const std::size_t vertices = state.simplified.VertexCount();
        std::vector<Lists> parts((vertices + kGrain - 1) / kGrain);
        ParallelRanges(threads, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
            Lists& part = parts[begin / kGrain];
            for (std::size_t v = begin; v < end; ++v)
                AddEdgesAt(state, quadrics, static_cast<std::uint32_t>(v), part);
            part.collapses.shrink_to_fit(); // where little is removed they are the peak of memory
            part.divisions.shrink_to_fit();
        });
        std::size_t edges = 0;
        for (const Lists& part : parts) edges += part.edges;
        collapses.reserve(edges);
        divisions.reserve(edges);
        for (Lists& part : parts) {
            const Lists here = std::move(part); // and gone afterward
            collapses.insert(collapses.end(), here.collapses.begin(), here.collapses.end());
            divisions.insert(divisions.end(), here.divisions.begin(), here.divisions.end());
        }
        const auto count = static_cast<std::size_t>(kMeasuredEdges * static_cast<double>(edges)) + 1;
        KeepLeast(collapses, count);
        KeepLeast(divisions, count);
    }

  private:
    static void AddEdgesAt(const RefinementState& state, const PlaneQuadrics& quadrics, std::uint32_t v,
                           Lists& lists)
    {
        const SurfaceArrays& s = state.simplified;
        if (s.cornerCount[v] > kMaxSearchedStar) return;
        constexpr std::uint8_t kStays = kBorderVertex | kFixedVertex;
        const Corner *begin = BeginCorners(s, v), *end = EndCorners(s, v);
        for (const Corner* c = begin; c != end; ++c) {
            const std::uint32_t w = NextVertex(s, *c);
            if (w < v) continue; // the other face beside the edge leads to it
            ++lists.edges;
            const Corner* across =
                std::find_if(begin, end, [&](Corner k) { return PreviousVertex(s, k) == w; });
            if (across == end) continue;
            lists.divisions.push_back(
                {-state.samples.faces[FaceOf(*c)].energy - state.samples.faces[FaceOf(*across)].energy, v,
                 w});
            if (!((s.flags[v] | s.flags[w]) & kStays))
                lists.collapses.push_back({quadrics.CostOf(v, w), v, w});
        }
    }
    static void KeepLeast(std::vector<EdgeGuess>& guesses, std::size_t count)
    {
        if (guesses.size() <= count) return;
        // Many are equal where it is flat: neighbours, of which only one can collapse, should not be
        // preferred.
        const auto mixed = [](const EdgeGuess& guess) {
            return std::uint64_t{MixedBits(guess.a + MixedBits(guess.b))} << 32 | guess.a;
        };
        std::nth_element(guesses.begin(), guesses.begin() + static_cast<std::ptrdiff_t>(count), guesses.end(),
                         [&](const EdgeGuess& l, const EdgeGuess& r) {
                             if (l.value < r.value || r.value < l.value) return l.value < r.value;
                             return mixed(l) != mixed(r) ? mixed(l) < mixed(r) : l.b < r.b;
                         });
        guesses.resize(count);
    }
};

} // namespace vcg_ext
