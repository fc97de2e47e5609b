// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/mesh.h"
#include "vcg_ext/ordered/weighted.h"

// Decimations that take one collapse at a time, the cheapest first, from the queue of vcg::LocalOptimization,
// on the calling thread. The results never have a non-manifold edge or vertex, a duplicate or a degenerate
// face that the input did not have, and no collapse turns a face by more than 78 degrees. A vertex that never
// moved is returned with the input's coordinates. Vertices without faces are left out unless they are fixed.
//
// Several threads may decimate at the same time, each its own view; queue.h says why VCG allows that.

namespace vcg_ext
{

/// The decimation of Zhang et al., "Laplacian-Based Feature Preserving Mesh Simplification" (2012).
struct WeightedParameters : WeightedCollapseParameters {
    std::size_t targetFaces = 0; ///< at least 1
};

/// Decimates by the guided collapse in the order of its cost.
/// \param guarded as KeptForLater's
/// \throws Cancelled \pre finite coordinates, indices below vertexCount, parameters in their ranges
VCG_EXT_INLINE OrderedDecimation DecimateOrdered(const MeshView& view, const DecimationParameters& parameters,
                                                 const StageProgress& progress = {},
                                                 const std::vector<std::uint8_t>* guarded = nullptr);

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

/// Decimates in the order of f = g e^{lambda l}. MeshView::fixedVertices stay, its guidance is not read.
/// \pre finite coordinates
/// \throws std::invalid_argument where a vector of the parameters does not fit the view, or lambda is not a
///         number of 0 or more; Cancelled
VCG_EXT_INLINE OrderedDecimation DecimateWeighted(const MeshView& view, WeightedParameters parameters,
                                                  const StageProgress& progress = {});

/// The outcome of a queue-ordered collapse as the stages behind it expect it.
/// \param keepOriginal both surfaces' lists are built, for the refinement \pre then it has a descriptor
VCG_EXT_INLINE CollapsedSurface ToSurface(const MeshView& view, OrderedDecimation decimation,
                                          bool keepOriginal, int threads);

/// The queue-ordered collapse as a stage of RunPipeline.
VCG_EXT_INLINE CollapsedSurface CollapseInOrder(const MeshView& view, const DecimationParameters& parameters,
                                                KeptForLater kept, const StageProgress& progress);

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/ordered/decimate_inl.h"
#endif
