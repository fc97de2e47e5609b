// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "decimation_types.h"
#include "guided_collapse.h"
#include "laplacian_descriptor.h"
#include "measured_collapse.h"
#include "strict_mesh.h"

namespace vcg_ext
{

namespace strict_detail
{

/// The part of \p values that is told apart: without the lowest and the highest tenth of a percent, so that
/// single outliers do not flatten everything else.
inline std::pair<double, double> RangeWithoutOutliers(std::vector<double> values)
{
    constexpr double kOutliers = .001;
    const auto quantile = [&](double q) {
        const auto position =
            values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1) + .5);
        std::nth_element(values.begin(), position, values.end());
        return *position;
    };
    return {quantile(kOutliers), quantile(1 - kOutliers)};
}

/// The descriptor in [0, 1] that guides: the view's, or the Laplacian one.
inline void SetDescriptor(const MeshView& view, GuidedParameters& parameters)
{
    if (view.guidance != nullptr) {
        parameters.descriptor.assign(view.guidance, view.guidance + view.vertexCount);
        return;
    }
    parameters.descriptor = LaplacianDescriptor(view);
    const auto [low, high] = RangeWithoutOutliers(parameters.descriptor);
    const double scale = high > low ? 1 / (high - low) : 0;
    for (double& l : parameters.descriptor) l = std::clamp((l - low) * scale, 0.0, 1.0);
    parameters.descriptorScale = scale;
}

template <class Method>
StrictDecimation Run(const MeshView& view, StrictMesh& mesh, const std::vector<std::uint32_t>& faceOrigin,
                     GuidedParameters guided, const DecimationParameters& parameters)
{
    Method method(mesh, std::move(guided));
    CollapseRun<StrictMesh, Method> run(mesh, method);
    const StopReason reason = run.Decimate(parameters.targetFaces, parameters.progress);
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
/// \pre finite coordinates, indices below vertexCount, parameters in their ranges
inline StrictDecimation DecimateStrict(const MeshView& view, const DecimationParameters& parameters)
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
                                                                  parameters)
               : strict_detail::Run<GuidedCollapse<StrictMesh>>(view, mesh, faceOrigin, std::move(guided),
                                                                parameters);
}

} // namespace vcg_ext
