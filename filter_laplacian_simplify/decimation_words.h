// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "parameters.h"
#include "number_text.h"
#include "results.h"
#include "vcg_ext/core/measure/report.h"

namespace laplacian_simplify
{

/// The numbers of a decimation under the ids of the table.
inline Report NumbersOf(const vcg_ext::DecimationReport& decimation)
{
    Report report;
    report.SetCount("faces_before", decimation.facesBefore);
    report.SetCount("faces", decimation.faces);
    report.SetCount("vertices", decimation.vertices);
    report.Set("target_reached", decimation.targetReached);
    report.Set("stop_reason", static_cast<int>(decimation.stopReason));
    if (decimation.distances) {
        report.Set("hausdorff", decimation.distances->hausdorff);
        report.Set("rms", decimation.distances->rms);
        report.Set("feature_rms", decimation.distances->featureRms);
        report.SetCount("folded", decimation.distances->folded);
    }
    if (decimation.stopReason != vcg_ext::StopReason::Cancelled) {
        report.SetCount("non_manifold_edges", decimation.edges.nonManifold);
        report.SetCount("boundary_edges", decimation.edges.boundary);
    }
    report.Set("seconds", decimation.seconds);
    return report;
}

/// Why a target of \p target faces was not reached, or that it was.
inline std::string StopWords(const vcg_ext::DecimationReport& decimation, std::size_t target)
{
    const std::string faces = std::to_string(target) + " faces";
    switch (decimation.stopReason) {
    case vcg_ext::StopReason::Target:
        return "target of " + faces + " reached";
    case vcg_ext::StopReason::ErrorBound:
        return "target of " + faces + " not reached: every further collapse would exceed the error bound";
    case vcg_ext::StopReason::NoLegalCollapse:
        return "target of " + faces +
               " not reached: every further collapse would turn a face over, make a non-manifold edge or "
               "touch "
               "what must stay";
    case vcg_ext::StopReason::Cancelled:
        return "cancelled; the mesh is unchanged";
    }
    return {};
}

/// The same for people, a few short lines.
inline std::vector<std::string> WordsOf(const vcg_ext::DecimationReport& decimation, std::size_t target)
{
    std::vector<std::string> lines;
    if (decimation.stopReason == vcg_ext::StopReason::Cancelled) return {StopWords(decimation, target)};
    lines.push_back(std::to_string(decimation.facesBefore) + " faces before, " +
                    std::to_string(decimation.faces) + " faces and " + std::to_string(decimation.vertices) +
                    " vertices now, " + RoundedText(decimation.seconds, 3) + " s; " +
                    StopWords(decimation, target));
    if (const auto& distances = decimation.distances)
        lines.push_back("Distance in percent of the bounding box's diagonal: largest (Hausdorff) " +
                        RoundedText(distances->hausdorff, 4) + ", rms " + RoundedText(distances->rms, 4) +
                        ", rms at features " + RoundedText(distances->featureRms, 4) +
                        "; folded faces: " + std::to_string(distances->folded));
    lines.push_back("Non-manifold edges: " + std::to_string(decimation.edges.nonManifold) +
                    ", boundary edges: " + std::to_string(decimation.edges.boundary));
    return lines;
}

} // namespace laplacian_simplify
