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
/// \param guidance l in [0, 1] of every input vertex, for the weights of the samples
/// \param kept original: both surfaces' lists are built, for the refinement
inline CollapsedSurface ToSurface(const MeshView& view, StrictDecimation decimation,
                                  const std::vector<float>& guidance, bool keepOriginal, int threads)
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
        for (std::size_t v = 0; v < weights.size(); ++v) weights[v] = std::exp(2 * guidance[v]);
        surface.original = BuildSurfaceArrays(view, surface.frame, weights.data(), threads);
    }
    surface.positions = std::move(mesh.positions);
    return surface;
}

/// The queue-ordered collapse as a stage of RunPipeline.
inline CollapsedSurface CollapseInOrder(const MeshView& view, DecimationParameters parameters,
                                        KeptForLater kept, const StageProgress& progress)
{
    const int threads = ResolveThreads(parameters.threads);
    std::vector<float> guidance, descriptor;
    if (view.guidance != nullptr) {
        guidance.assign(view.guidance, view.guidance + view.vertexCount);
    } else {
        const std::vector<double> values = LaplacianDescriptor(view, threads);
        const std::vector<double> l = RescaledToUnit(values);
        guidance.assign(l.begin(), l.end());
        if (kept.descriptor) descriptor.assign(values.begin(), values.end());
    }
    CollapsedSurface surface =
        ToSurface(view, DecimateStrict(view, parameters, progress), guidance, kept.original, threads);
    surface.descriptor = std::move(descriptor);
    return surface;
}

} // namespace vcg_ext
