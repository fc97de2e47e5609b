// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/mesh/edge_counts.h"

namespace vcg_ext
{

/// What was done. "Target not reached" is a report, not an error.
struct DecimationReport {
    std::size_t facesBefore = 0;
    std::size_t faces = 0;
    std::size_t vertices = 0;
    bool targetReached = false;
    StopReason stopReason = StopReason::Target;
    std::optional<DistanceReport> distances;
    EdgeCounts edges;
    double seconds = 0; ///< wall time of collapse, refinement and fold repair, without the measurement
};

/// The counts of a result; distances and seconds are left open. \p result has as many faces as \p original
/// where the run was cancelled
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
