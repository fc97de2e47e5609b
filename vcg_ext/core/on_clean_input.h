// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/progress.h"
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
/// \param run called as run(view, parameters), returns a Simplification or several
/// \param cancelled called as cancelled(view), returns what is said of a run that was cancelled
/// \throws std::invalid_argument if no face is left
template <class Run, class OfCancelled>
auto OnCleanInput(const MeshView& view, const DecimationParameters& parameters, const Run& run,
                  const OfCancelled& cancelled)
{
    if (!parameters.cleanInput) {
        const SidedInput sided(
            view, view, [](std::uint32_t face) { return face; }, parameters.threads);
        return run(sided.View(), parameters);
    }
    const bool isSoup = view.vertexCount > 2 * view.faceCount; // most corners have a vertex of their own
    const int cleaningEnds = isSoup ? 24 : 6;                  // percent of the time, roughly
    std::optional<CleanedInput> cleaned;
    try {
        RunProgress progress(parameters.progress);
        const LoopPoll poll([&](int percent) { progress.GoOn(percent); });
        StageProgress(std::ref(progress))(0, "Reading the mesh", cleaningEnds, isSoup ? 6 : 4);
        cleaned.emplace(view, WeldDistance(view, parameters), parameters.threads);
    } catch (const Cancelled&) {
        return cancelled(view);
    }
    const CleanedInput& clean = *cleaned;
    if (clean.View().faceCount == 0)
        throw std::invalid_argument("weld_distance = " + std::to_string(parameters.weldDistance) +
                                    " leaves no face: every one has two corners that are welded");
    DecimationParameters own = parameters;
    if (parameters.progress)
        own.progress = [&](int percent, const char* stage) {
            return parameters.progress(cleaningEnds + percent * (100 - cleaningEnds) / 100, stage);
        };
    const SidedInput sided(
        view, clean.View(), [&](std::uint32_t face) { return clean.FaceOrigin(face); }, parameters.threads);
    auto result = run(sided.View(), own);
    NameAsInput(view, clean, result);
    return result;
}

} // namespace vcg_ext
