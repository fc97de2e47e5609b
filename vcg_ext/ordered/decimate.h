// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/descriptors.h"
#include "vcg_ext/ordered/guided.h"
#include "vcg_ext/ordered/measured.h"
#include "vcg_ext/ordered/mesh.h"

namespace vcg_ext
{

namespace strict_detail
{

/// The descriptor in [0, 1] that guides: the view's, or the Laplacian one.
inline void SetDescriptor(const MeshView& view, GuidedParameters& parameters)
{
    if (view.guidance != nullptr) {
        parameters.descriptor.assign(view.guidance, view.guidance + view.vertexCount);
        return;
    }
    const std::vector<double> values = LaplacianDescriptor(view);
    parameters.descriptor = RescaledToUnit(values);
    // The scale, found where nothing was cut off at 1.
    const double low = *std::min_element(values.begin(), values.end());
    for (std::size_t v = 0; v < values.size(); ++v)
        if (values[v] > low)
            parameters.descriptorScale =
                std::max(parameters.descriptorScale, parameters.descriptor[v] / (values[v] - low));
}

template <class Method>
StrictDecimation Run(const MeshView& view, StrictMesh& mesh, const std::vector<std::uint32_t>& faceOrigin,
                     GuidedParameters guided, const DecimationParameters& parameters,
                     const StageProgress& progress)
{
    Method method(mesh, std::move(guided));
    CollapseRun<StrictMesh, Method> run(mesh, method);
    const StopReason reason = run.Decimate(parameters.targetFaces, progress);
    StrictDecimation result = Collect(view, mesh, faceOrigin, method);
    result.mesh.stopReason = reason;
    return result;
}

} // namespace strict_detail

/// Decimates by the guided collapse in strict order of its cost, or of measured error where the effort is
/// Best, run by vcg::LocalOptimization on one thread.
///
/// The result never has a non-manifold edge or vertex, a duplicate or a degenerate face that the input did
/// not have, and no collapse turns a face by more than 78 degrees. A vertex that never moved is returned with
/// the input's coordinates. Vertices without faces are left out.
/// \throws Cancelled \pre finite coordinates, indices below vertexCount, parameters in their ranges
inline StrictDecimation DecimateStrict(const MeshView& view, const DecimationParameters& parameters,
                                       const StageProgress& progress = {})
{
    StrictMesh mesh;
    std::vector<std::uint32_t> faceOrigin;
    strict_detail::FillMesh(view, mesh, faceOrigin);
    GuidedParameters guided;
    guided.featureWeight = parameters.featureWeight;
    guided.boundary = parameters.boundary;
    guided.preserveTopology = parameters.preserveTopology;
    guided.fixedVertices = strict_detail::FixedVertices(view, mesh, parameters.boundary);
    if (view.vertexCount > 0) strict_detail::SetDescriptor(view, guided);

    return parameters.effort == Effort::Best
               ? strict_detail::Run<MeasuredCollapse<StrictMesh>>(view, mesh, faceOrigin, std::move(guided),
                                                                  parameters, progress)
               : strict_detail::Run<GuidedCollapse<StrictMesh>>(view, mesh, faceOrigin, std::move(guided),
                                                                parameters, progress);
}

} // namespace vcg_ext
