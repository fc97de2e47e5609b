// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/build_surface.h"
#include "vcg_ext/ordered/decimate.h"
#include "vcg_ext/ordered/mesh.h"

namespace vcg_ext
{

/// The outcome of a queue-ordered collapse as the stages behind it expect it.
/// \param keepOriginal both surfaces' lists are built, for the refinement \pre then it has a descriptor
inline CollapsedSurface ToSurface(const MeshView& view, OrderedDecimation decimation, bool keepOriginal,
                                  int threads)
{
    CollapsedSurface surface;
    DecimatedMesh& mesh = decimation.mesh;
    surface.stopReason = mesh.stopReason;
    surface.frame = FrameOf(view);
    const auto copy = [](const std::vector<std::uint32_t>& from, Buffer<std::uint32_t>& to) {
        to.Allocate(from.size());
        std::copy(from.begin(), from.end(), to.begin());
    };
    copy(mesh.vertexOrigin, surface.vertexOrigin);
    copy(mesh.faceOrigin, surface.faceOrigin);
    copy(decimation.root, surface.root);
    if (!mesh.triangles.empty()) {
        std::vector<std::uint8_t> fixed;
        const MeshView collapsed = ViewOf(mesh, view, fixed);
        surface.simplified = BuildSurfaceArrays(collapsed, surface.frame, nullptr, threads);
    }
    if (keepOriginal) {
        std::vector<float> weights(view.vertexCount);
        for (std::size_t v = 0; v < weights.size(); ++v) weights[v] = std::exp(2 * decimation.descriptor[v]);
        surface.original = BuildSurfaceArrays(view, surface.frame, weights.data(), threads);
    }
    surface.positions = std::move(mesh.positions);
    surface.descriptor = std::move(decimation.descriptor);
    return surface;
}

/// The queue-ordered collapse as a stage of RunPipeline.
inline CollapsedSurface CollapseInOrder(const MeshView& view, const DecimationParameters& parameters,
                                        KeptForLater kept, const StageProgress& progress)
{
    CollapsedSurface surface = ToSurface(view, DecimateOrdered(view, parameters, progress), kept.original,
                                         ResolveThreads(parameters.threads));
    if (!kept.descriptor || view.guidance != nullptr) surface.descriptor.clear();
    return surface;
}

} // namespace vcg_ext
