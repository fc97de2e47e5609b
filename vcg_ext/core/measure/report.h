// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/attributes/attribute_report.h"
#include "vcg_ext/core/collapse/trace.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/mesh/clean_input.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// Edges by the number of faces on them.
struct EdgeCounts {
    std::size_t boundary = 0;    ///< one face
    std::size_t nonManifold = 0; ///< three or more
};

/// \param triangle triangle(f) is something with three vertex indices
template <class TriangleOf>
EdgeCounts CountEdges(std::size_t faces, const TriangleOf& triangle)
{
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * faces);
    for (std::size_t f = 0; f < faces; ++f) {
        const auto corner = triangle(f);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = corner[k], b = corner[(k + 1) % 3];
            edges.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    EdgeCounts counts;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        counts.boundary += end - i == 1;
        counts.nonManifold += end - i > 2;
        i = end;
    }
    return counts;
}

/// What was done. "Target not reached" is a report, not an error.
struct DecimationReport {
    std::size_t facesBefore = 0;
    std::size_t faces = 0;
    std::size_t vertices = 0;
    bool targetReached = false;
    StopReason stopReason = StopReason::Target;
    std::optional<DistanceReport> distances;
    EdgeCounts edges;
    std::optional<CleaningReport> cleaning; ///< nothing where the input was taken as it is
    /// Percent of the original's diagonal: no point of either surface is farther from the other, which is
    /// proven. Nothing where no bound was asked for, or none could be proven.
    std::optional<double> certifiedError;
    /// Pairs of faces that cross (crossing_triangles.h). Nothing where nobody asked to avoid them; those of
    /// the original are counted only where the result had any.
    std::optional<std::size_t> selfIntersections, selfIntersectionsBefore;
    std::optional<AttributeReport> attributes; ///< where the original has some
    CollapseTrace trace;                       ///< of the sweeps
    double seconds = 0; ///< wall time of collapse, refinement and fold repair, without the measurement
};

/// The counts of a result; distances, trace and seconds are left open. \p result has as many faces as \p
/// original where the run was cancelled
inline DecimationReport CountsOf(const MeshView& original, const DecimatedMesh& result,
                                 std::size_t targetFaces)
{
    DecimationReport report;
    report.facesBefore = original.faceCount;
    report.faces = result.triangles.size();
    report.vertices = result.positions.size();
    report.stopReason = result.stopReason;
    report.targetReached = report.faces <= targetFaces;
    report.edges = CountEdges(report.faces, [&](std::size_t f) { return result.triangles[f]; });
    return report;
}

} // namespace vcg_ext
