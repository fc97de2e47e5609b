// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/first_equal.h"
#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

namespace weld_detail
{

inline std::uint64_t HashOf(const std::array<double, 3>& p)
{
    std::uint64_t hash = 0;
    for (const double x : p) {
        const double unsignedZero = x + 0.0;
        std::uint64_t bits = 0;
        std::memcpy(&bits, &unsignedZero, sizeof bits);
        hash = Mixed(hash + bits);
    }
    return hash;
}

inline std::uint32_t KeyOf(const MeshView& view, std::size_t vertex)
{
    return view.vertexKeys ? view.vertexKeys[vertex] : 0;
}

/// Of every vertex whether it is an end of an edge that is there once. \param edges with the lower end first
inline std::vector<bool> EndsOfSingles(std::vector<std::uint64_t> edges, std::size_t vertices)
{
    constexpr std::size_t kVertices = std::size_t{1} << 14; // whose edges are sorted between two questions
    std::vector<std::uint64_t> sorted(edges.size());
    const auto first = StableScatter(
        1, edges.size(), vertices / kVertices + 1,
        [&](std::size_t i) { return (edges[i] >> 32U) / kVertices; },
        [&](std::size_t i, std::uint32_t place) { sorted[place] = edges[i]; });
    std::vector<bool> found(vertices);
    ParallelFor(1, first.size() - 1, [&](std::size_t bucket, int) {
        const auto end = sorted.begin() + first[bucket + 1];
        auto at = sorted.begin() + first[bucket];
        std::sort(at, end);
        while (at != end) {
            const auto next = std::upper_bound(at, end, *at);
            if (next - at == 1) found[*at >> 32U] = found[*at & 0xffffffffU] = true;
            at = next;
        }
    });
    return found;
}

/// Of every vertex whether it is an end of an edge of one face. \param among only edges with such an end
/// count; empty: all
inline std::vector<bool> OnBorder(const MeshView& view, const std::vector<bool>& among)
{
    constexpr std::size_t kFaces = std::size_t{1} << 14; // between two questions
    std::vector<std::uint64_t> edges;
    ParallelRanges(1, view.faceCount, kFaces, [&](std::size_t begin, std::size_t last, int) {
        for (std::size_t f = begin; f < last; ++f) {
            const std::uint32_t* v = view.triangles + 3 * f;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = std::min(v[k], v[(k + 1) % 3]), b = std::max(v[k], v[(k + 1) % 3]);
                if (among.empty() || among[a] || among[b]) edges.push_back(std::uint64_t{a} << 32U | b);
            }
        }
    });
    return EndsOfSingles(std::move(edges), view.vertexCount);
}

/// Vertices by cells of a grid, for those within a distance that is the side of a cell.
class VertexGrid
{
    using Cell = std::array<std::int64_t, 3>;
    struct HashOfCell {
        std::size_t operator()(const Cell& cell) const
        {
            std::uint64_t hash = 0;
            for (const std::int64_t c : cell) hash = Mixed(hash + static_cast<std::uint64_t>(c));
            return hash;
        }
    };
    double side_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, HashOfCell> cells_;

    Cell CellOf(const std::array<double, 3>& p) const
    {
        constexpr double kLargest = 9e15; // beyond it neighboring cells cannot be told apart
        Cell cell{};
        for (std::size_t k = 0; k < 3; ++k)
            cell[k] = static_cast<std::int64_t>(std::clamp(std::floor(p[k] / side_), -kLargest, kLargest));
        return cell;
    }

  public:
    explicit VertexGrid(double side) : side_(side) {}

    void Insert(std::uint32_t vertex, const std::array<double, 3>& p) { cells_[CellOf(p)].push_back(vertex); }

    /// The lowest vertex of the grid within the distance of a vertex; itself where there is none.
    std::uint32_t LowestNear(const MeshView& view, std::uint32_t vertex) const
    {
        const auto p = view.Position(vertex);
        const std::uint32_t key = KeyOf(view, vertex);
        const Cell center = CellOf(p);
        std::uint32_t lowest = ~0U;
        for (int n = 0; n < 27; ++n) {
            const auto cell =
                cells_.find({center[0] + n % 3 - 1, center[1] + n / 3 % 3 - 1, center[2] + n / 9 - 1});
            if (cell == cells_.end()) continue;
            for (const std::uint32_t v : cell->second) {
                const auto q = view.Position(v);
                if (KeyOf(view, v) == key && std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]) <= side_)
                    lowest = std::min(lowest, v);
            }
        }
        return lowest == ~0U ? vertex : lowest;
    }
};

} // namespace weld_detail

/// Joins open borders where they meet: of every vertex the one that takes its place, which is on a border and
/// in its place itself. Only vertices on open edges are welded, so two closed surfaces that touch stay apart.
/// A fixed vertex is welded to nothing, but others are to it. \param distance in the mesh's unit of length
/// \return empty where nothing is to be done
inline std::vector<std::uint32_t> WeldedVertices(const MeshView& view, double distance, int threads)
{
    using namespace weld_detail;
    const int useful = UsefulThreadCount(threads, view.faceCount);
    const auto first = FirstEqual(
        useful, view.vertexCount, [&](std::size_t v) { return HashOf(view.Position(v)); },
        [&](std::size_t a, std::size_t b) {
            return view.Position(a) == view.Position(b) && KeyOf(view, a) == KeyOf(view, b);
        });
    if (first.empty() && !(distance > 0)) return {};
    std::vector<bool> doubled;
    if (!(distance > 0)) {
        doubled.resize(view.vertexCount);
        for (std::uint32_t v = 0; v < first.size(); ++v)
            if (first[v] != v) doubled[v] = doubled[first[v]] = true;
    }
    const std::vector<bool> border = OnBorder(view, doubled);
    const auto isFixed = [&](std::uint32_t v) { return view.fixedVertices && view.fixedVertices[v]; };
    std::vector<std::uint32_t> weld(view.vertexCount), takes(view.vertexCount, ~0U);
    constexpr std::uint32_t kVertices = 4096; // between two questions
    VertexGrid grid(distance);
    bool any = false;
    for (const bool fixed : {true, false}) { // fixed vertices are there first
        for (std::uint32_t v = 0; v < view.vertexCount; ++v) {
            if (isFixed(v) != fixed) continue;
            weld[v] = v;
            if (v % kVertices == 0) LoopPoll::Ask();
            if (!border[v] || !(distance > 0 || doubled[v])) continue;
            if (distance > 0) {
                if (!fixed) weld[v] = grid.LowestNear(view, v);
                if (weld[v] == v) grid.Insert(v, view.Position(v));
            } else {
                std::uint32_t& taken = takes[first[v]]; // by the first of the group that may be welded to
                if (taken == ~0U) taken = v;
                if (!fixed) weld[v] = taken;
            }
            any = any || weld[v] != v;
        }
    }
    return any ? weld : std::vector<std::uint32_t>{};
}

} // namespace vcg_ext
