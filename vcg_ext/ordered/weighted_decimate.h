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

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/ordered/mesh.h"
#include "vcg_ext/ordered/weighted.h"

namespace vcg_ext
{

/// The decimation of Zhang et al., "Laplacian-Based Feature Preserving Mesh Simplification" (2012).
struct WeightedParameters : WeightedCollapseParameters {
    std::size_t targetFaces = 0; ///< at least 1
};

namespace weighted_detail
{

/// \throws std::invalid_argument where \p values are neither absent nor one a vertex
template <class Value>
void CheckLength(const std::vector<Value>& values, const MeshView& view, const char* name)
{
    if (!values.empty() && values.size() != view.vertexCount)
        throw std::invalid_argument(std::string(name) + " has " + std::to_string(values.size()) +
                                    " values for " + std::to_string(view.vertexCount) + " vertices");
}

} // namespace weighted_detail

/// Weight of every vertex's quadric after Li and He (2010), |k1| + |k2|, from mean and Gaussian curvature:
/// k = H ± sqrt(H² - K).
/// \param mean H or |H|, one a vertex \param gaussian K, one a vertex
inline std::vector<double> AbsoluteCurvature(const std::vector<double>& mean,
                                             const std::vector<double>& gaussian)
{
    std::vector<double> sum(mean.size());
    for (std::size_t v = 0; v < mean.size(); ++v) {
        const double h = std::abs(mean[v]);
        const double root = std::sqrt(std::max(h * h - gaussian[v], 0.0));
        sum[v] = h + root + std::abs(h - root);
    }
    return sum;
}

/// Decimates by f = g e^{lambda l} in strict order, run by vcg::LocalOptimization on one thread, without
/// changing the input.
///
/// As DecimateStrict the result has no non-manifold edge, duplicate or degenerate face that the input did not
/// have, and no collapse turns a face by more than 78 degrees. MeshView::fixedVertices stay, its guidance is
/// not read.
/// \pre finite coordinates
/// \throws std::invalid_argument where a vector of the parameters does not fit the view, or lambda is not a
///         number of 0 or more
inline StrictDecimation DecimateWeighted(const MeshView& view, WeightedParameters parameters,
                                         const StageProgress& progress = {})
{
    weighted_detail::CheckLength(parameters.descriptor, view, "descriptor");
    weighted_detail::CheckLength(parameters.quadricWeights, view, "quadric weights");
    weighted_detail::CheckLength(parameters.featureClass, view, "feature classes");
    if (!(parameters.featureWeight >= 0))
        throw std::invalid_argument("feature_weight = " + std::to_string(parameters.featureWeight) +
                                    " is less than 0");
    StrictMesh mesh;
    std::vector<std::uint32_t> faceOrigin;
    strict_detail::FillMesh(view, mesh, faceOrigin);
    if (parameters.fixedVertices.empty())
        parameters.fixedVertices = strict_detail::FixedVertices(view, mesh, Boundary::Preserve);
    WeightedCollapse<StrictMesh> method(mesh, parameters);
    CollapseRun<StrictMesh, WeightedCollapse<StrictMesh>> run(mesh, method);
    const StopReason reason = run.Decimate(parameters.targetFaces, progress);
    StrictDecimation result = strict_detail::Collect(view, mesh, faceOrigin, method);
    result.mesh.stopReason = reason;
    return result;
}

} // namespace vcg_ext
