// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"

// Samples of the original's open borders, attached to the border edges of the simplified surface. A border
// edge has the number of the vertex where it begins, in the direction of its face: flips and moves leave it.

namespace vcg_ext
{

/// Who follows whom along the open borders of a surface; kNone elsewhere, and where a vertex is on another
/// number of open edges than two. Several vertices may follow such a one.
struct BorderLoops {
    Buffer<std::uint32_t> next, previous;
};

/// The only element of the first sorted list that the second one lacks, kNone where there are several.
inline std::uint32_t OnlyOneWithout(const std::vector<std::uint32_t>& list,
                                    const std::vector<std::uint32_t>& other)
{
    std::array<std::uint32_t, 2> found{};
    std::size_t count = 0;
    for (const std::uint32_t v : list)
        if (!std::binary_search(other.begin(), other.end(), v) && count < 2) found[count++] = v;
    return count == 1 ? found[0] : kNone;
}

/// \pre flags mark the border vertices
inline BorderLoops FindBorderLoops(const SurfaceArrays& surface, int threads)
{
    BorderLoops loops;
    loops.next.Allocate(surface.VertexCount());
    loops.previous.Allocate(surface.VertexCount());
    ParallelRanges(threads, surface.VertexCount(), 4096, [&](std::size_t begin, std::size_t end, int) {
        std::vector<std::uint32_t> next, previous;
        for (std::size_t i = begin; i < end; ++i) {
            const auto v = static_cast<std::uint32_t>(i);
            loops.next[v] = loops.previous[v] = kNone;
            if (!(surface.flags[v] & kBorderVertex) || HasClosedStar(surface, v, next, previous)) continue;
            const bool isTwice = std::adjacent_find(next.begin(), next.end()) != next.end() ||
                                 std::adjacent_find(previous.begin(), previous.end()) != previous.end();
            const std::uint32_t to = OnlyOneWithout(next, previous), from = OnlyOneWithout(previous, next);
            if (isTwice || to == kNone || from == kNone) continue;
            loops.next[v] = to;
            loops.previous[v] = from;
        }
    });
    return loops;
}

/// The samples of the borders. Empty where no border vertex may move.
struct BorderSamples {
    BorderLoops loops; ///< of the simplified surface
    SampleLists lists; ///< of border edges instead of faces; an origin is a vertex of the original

    /// Is the border vertex \p v on two open edges that nobody else has the numbers of?
    bool MayMove(std::uint32_t v) const
    {
        return !loops.next.empty() && loops.next[v] != kNone && loops.next[loops.previous[v]] != kNone;
    }
};

/// The squared distance of a point to the segment from 0 to \p edge.
inline float SquaredDistanceToSegment(const Vector3<float>& p, const Vector3<float>& edge)
{
    const float t = Dot(p, edge) / std::max(SquaredNorm(edge), kSmallestSquare);
    return SquaredNorm(p - std::clamp(t, 0.0F, 1.0F) * edge);
}

/// Attaches samples to the border edge that a walk along the border finds.
class BorderAttacher
{
    const SurfaceArrays& original_;
    const SurfaceArrays& simplified_;
    const Buffer<std::uint32_t>& root_;
    const BorderLoops& loops_; // of the simplified surface
    std::vector<Sample> samples_;

  public:
    BorderAttacher(const SurfaceArrays& original, const SurfaceArrays& simplified,
                   const Buffer<std::uint32_t>& root, const BorderLoops& loops)
        : original_(original), simplified_(simplified), root_(root), loops_(loops)
    {
    }

    /// Every vertex and every midpoint of the original's border, with shares that integrate the squared
    /// distance exactly where it is that to a line (Simpson's rule). \param border of the original
    SampleLists Attach(const BorderLoops& border)
    {
        const auto isNone = [](std::uint32_t v) { return v == kNone; };
        const auto none = std::count_if(border.next.begin(), border.next.end(), isNone);
        samples_.reserve(2 * (border.next.size() - static_cast<std::size_t>(none)));
        for (std::uint32_t v = 0; v < original_.VertexCount(); ++v) {
            const std::uint32_t to = border.next[v];
            if (to == kNone) continue;
            const Vector3<float> here = PositionOf(original_, v);
            const Vector3<float> along = PositionOf(original_, to) - here;
            const float length = Norm(along), back = Norm(here - PositionOf(original_, border.previous[v]));
            Add(here, v, (length + back) / 6);
            Add(here + 0.5F * along, v, length * (2.0F / 3));
        }
        return Lists();
    }

  private:
    void Add(const Vector3<float>& p, std::uint32_t v, float length)
    {
        const std::uint32_t root = root_[v];
        if (root == kNone || loops_.next[root] == kNone) return;
        const auto [edge, distance2] = Walk(p, root);
        const Vector3<float> along = AlongEdge(edge);
        const float weight = kBorderWeight * length * Norm(along) * original_.points[v].weight;
        samples_.push_back({p.x, p.y, p.z, weight, distance2, edge, kNone, v});
    }
    Vector3<float> AlongEdge(std::uint32_t edge) const
    {
        return PositionOf(simplified_, loops_.next[edge]) - PositionOf(simplified_, edge);
    }
    std::pair<std::uint32_t, float> Walk(const Vector3<float>& p, std::uint32_t vertex) const
    {
        const auto distance2 = [&](std::uint32_t edge) {
            return SquaredDistanceToSegment(p - PositionOf(simplified_, edge), AlongEdge(edge));
        };
        std::pair<std::uint32_t, float> best{vertex, distance2(vertex)};
        for (const Buffer<std::uint32_t>* towards : {&loops_.next, &loops_.previous})
            for (std::size_t step = 0, edge = vertex; step < kMaxBorderWalk; ++step) {
                edge = (*towards)[edge];
                if (edge == kNone || loops_.next[edge] == kNone) break;
                const float other = distance2(static_cast<std::uint32_t>(edge));
                if (other < best.second)
                    best = {static_cast<std::uint32_t>(edge), other};
                else if (step > 0)
                    break;
            }
        return best;
    }
    SampleLists Lists()
    {
        SampleLists lists;
        lists.faces.Allocate(simplified_.VertexCount());
        for (std::uint32_t v = 0; v < lists.faces.size(); ++v) lists.Clear(v);
        lists.samples.Allocate(samples_.size());
        StableScatter(
            1, samples_.size(), simplified_.VertexCount(), [&](std::size_t i) { return samples_[i].face; },
            [&](std::size_t i, std::size_t to) { lists.samples[to] = samples_[i]; });
        for (auto i = static_cast<std::uint32_t>(samples_.size()); i-- > 0;)
            lists.Attach(i, lists.samples[i].face);
        return lists;
    }
};

/// \param root as of Refine
inline BorderSamples AttachBorderSamples(const SurfaceArrays& original, const SurfaceArrays& simplified,
                                         const Buffer<std::uint32_t>& root, int threads)
{
    const auto mayMove = [](std::uint8_t flags) {
        return (flags & (kBorderVertex | kFixedVertex)) == kBorderVertex;
    };
    BorderSamples border;
    if (std::none_of(simplified.flags.begin(), simplified.flags.end(), mayMove)) return border;
    border.loops = FindBorderLoops(simplified, threads);
    border.lists =
        BorderAttacher(original, simplified, root, border.loops).Attach(FindBorderLoops(original, threads));
    return border;
}

} // namespace vcg_ext
