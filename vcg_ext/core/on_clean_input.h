// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/mesh/clean_input.h"
#include "vcg_ext/core/mesh/hard_normals.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"

namespace vcg_ext
{

/// Turns the result of a cleaned input into one of \p view: faces and counts are the input's.
inline void NameAsInput(const MeshView& view, const CleanedInput& clean, Simplification& result)
{
    for (std::uint32_t& face : result.mesh.faceOrigin) face = clean.FaceOrigin(face);
    result.report.facesBefore = view.faceCount;
    if (result.report.stopReason == StopReason::Cancelled)
        result.report.faces = view.faceCount;
    else
        result.report.cleaning = clean.Report();
}
inline void NameAsInput(const MeshView& view, const CleanedInput& clean, std::vector<Simplification>& levels)
{
    for (Simplification& level : levels) NameAsInput(view, clean, level);
}

/// Runs on what is left of a mesh when it has been cleaned, with its hard edges as seams, and names faces as
/// the input does.
/// \param run called as run(view), returns a Simplification or several
/// \throws std::invalid_argument if no face is left
template <class Run>
auto OnCleanInput(const MeshView& view, const DecimationParameters& parameters, const Run& run)
{
    if (!parameters.cleanInput) {
        const SidedInput sided(
            view, view, [](std::uint32_t face) { return face; }, parameters.threads);
        return run(sided.View());
    }
    const CleanedInput clean(view, WeldDistance(view, parameters), parameters.threads);
    if (clean.View().faceCount == 0)
        throw std::invalid_argument("weld_distance = " + std::to_string(parameters.weldDistance) +
                                    " leaves no face: every one has two corners that are welded");
    const SidedInput sided(
        view, clean.View(), [&](std::uint32_t face) { return clean.FaceOrigin(face); }, parameters.threads);
    auto result = run(sided.View());
    NameAsInput(view, clean, result);
    return result;
}

} // namespace vcg_ext
