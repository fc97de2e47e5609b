// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

/// Makes strict what the certificates of earlier runs ask for.
inline void MarkStrict(const SweepState& state, const BoundTask& task, CollapseBound& bound)
{
    if (task.strictVertices.empty()) return;
    const auto vertices = static_cast<std::uint32_t>(state.vertices.size());
    for (std::uint32_t v = 0; v < vertices; ++v)
        bound.covered.strict[v] = task.strictVertices[state.origin[v]];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> faceOf; // of every input face on which points lie
    faceOf.reserve(state.faces.size());
    for (std::uint32_t f = 0; f < state.faces.size(); ++f) faceOf.emplace_back(state.faces[f].origin, f);
    std::sort(faceOf.begin(), faceOf.end());
    for (std::uint32_t i = 0; i < task.strictPoints.size(); ++i) {
        const BoundTask::Point& point = task.strictPoints[i];
        const auto at = std::lower_bound(faceOf.begin(), faceOf.end(), std::make_pair(point.face, 0U));
        if (at == faceOf.end() || at->first != point.face) continue;
        const Vector3<double>& p = point.position;
        bound.covered.points[vertices + i] = {static_cast<float>(p.x), static_cast<float>(p.y),
                                              static_cast<float>(p.z), 0};
        bound.covered.strict[vertices + i] = 1;
        bound.covered.Attach(vertices + i, at->second, 0);
    }
}

/// Fills \p bound for a surface that is still the original: every vertex is covered by a face of its own, at
/// no distance. \pre the state is loaded, and nothing has collapsed
inline void StartBound(const SweepState& state, CollapseBound& bound, const BoundTask& task, int threads)
{
    constexpr std::size_t kGrain = 1 << 14;
    const std::size_t vertices = state.vertices.size(), faces = state.faces.size();
    bound.covered.Allocate(vertices + task.strictPoints.size(), faces);
    bound.nearby.Allocate(vertices);
    bound.ringChanged.AllocateZeros(vertices);
    bound.edgeRefused.AllocateZeros(3 * faces);
    ParallelRanges(threads, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto v = static_cast<std::uint32_t>(i);
            const Vector3<float> p = state.Position(v);
            bound.covered.points[v] = {p.x, p.y, p.z, 0};
            bound.nearby[v] = {0, 0};
            if (state.cornerCount[v] > 0)
                bound.nearby[v].face = state.faces[FaceOf(*state.CornersOf(v))].origin;
        }
    });
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (state.cornerCount[v] > 0) bound.covered.Attach(v, FaceOf(*state.CornersOf(v)), 0);
    const auto neighboursOf = [&](std::uint32_t v, std::vector<std::uint32_t>& list) {
        for (std::uint32_t i = 0; i < state.cornerCount[v]; ++i) {
            list.push_back(state.Next(state.CornersOf(v)[i]));
            list.push_back(state.Previous(state.CornersOf(v)[i]));
        }
    };
    const auto length = [&](std::uint32_t v, std::uint32_t w) {
        return Norm(state.Position(w) - state.Position(v));
    };
    MarkStrict(state, task, bound);
    bound.edges.Build(vertices, threads, neighboursOf, length);
}

} // namespace vcg_ext
