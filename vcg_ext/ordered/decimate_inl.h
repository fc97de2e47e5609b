// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/decimate.h"
#include "vcg_ext/ordered/guided.h"
#include "vcg_ext/ordered/mesh.h"
#include "vcg_ext/ordered/queue.h"
#include "vcg_ext/ordered/weighted.h"

namespace vcg_ext
{

namespace ordered_detail
{

template <class Method>
OrderedDecimation Decimated(CollapsibleMesh& mesh, Method method, std::size_t targetFaces,
                            const StageProgress& progress)
{
    CollapseRun<OrderedMesh, Method> run(mesh.mesh(), method);
    const StopReason reason = run.Decimate(targetFaces, progress);
    return mesh.Result(method, reason);
}

/// \throws std::invalid_argument where \p values are neither absent nor one a vertex
template <class Value>
void CheckLength(const std::vector<Value>& values, const MeshView& view, const char* name)
{
    if (!values.empty() && values.size() != view.vertexCount)
        throw std::invalid_argument(std::string(name) + " has " + std::to_string(values.size()) +
                                    " values for " + std::to_string(view.vertexCount) + " vertices");
}

} // namespace ordered_detail

VCG_EXT_INLINE OrderedDecimation DecimateOrdered(const MeshView& view, const DecimationParameters& parameters,
                                                 const StageProgress& progress,
                                                 const std::vector<std::uint8_t>* guarded)
{
    CollapsibleMesh mesh(view);
    GuidedParameters guided;
    if (guarded) guided.guarded = *guarded;
    guided.guidance = GuidanceOf(view, parameters.featureWeight);
    guided.boundary = parameters.boundary;
    guided.preserveTopology = parameters.preserveTopology;
    guided.fixedVertices = mesh.FixedVertices(parameters.boundary);
    GuidedCollapse<OrderedMesh> method(mesh.mesh(), std::move(guided));
    std::vector<float> descriptor = method.Descriptor();
    auto decimation = ordered_detail::Decimated(mesh, std::move(method), parameters.targetFaces, progress);
    decimation.descriptor = std::move(descriptor);
    return decimation;
}

VCG_EXT_INLINE OrderedDecimation DecimateWeighted(const MeshView& view, WeightedParameters parameters,
                                                  const StageProgress& progress)
{
    ordered_detail::CheckLength(parameters.descriptor, view, "descriptor");
    ordered_detail::CheckLength(parameters.quadricWeights, view, "quadric weights");
    ordered_detail::CheckLength(parameters.featureClass, view, "feature classes");
    if (!(parameters.featureWeight >= 0))
        throw std::invalid_argument("feature_weight = " + std::to_string(parameters.featureWeight) +
                                    " is less than 0");
    CollapsibleMesh mesh(view);
    if (parameters.fixedVertices.empty()) parameters.fixedVertices = mesh.FixedVertices(Boundary::Preserve);
    return ordered_detail::Decimated(mesh, WeightedCollapse<OrderedMesh>(mesh.mesh(), parameters),
                                     parameters.targetFaces, progress);
}

VCG_EXT_INLINE CollapsedSurface ToSurface(const MeshView& view, OrderedDecimation decimation,
                                          bool keepOriginal, int threads)
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

VCG_EXT_INLINE CollapsedSurface CollapseInOrder(const MeshView& view, const DecimationParameters& parameters,
                                                KeptForLater kept, const StageProgress& progress)
{
    CollapsedSurface surface = ToSurface(view, DecimateOrdered(view, parameters, progress, kept.guarded),
                                         kept.original, ResolveThreads(parameters.threads));
    if (!kept.descriptor || view.guidance != nullptr) surface.descriptor.clear();
    return surface;
}

} // namespace vcg_ext
