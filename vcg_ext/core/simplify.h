// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"

namespace vcg_ext
{

/// Checks what does not depend on the mesh. \throws std::invalid_argument that names parameter, value and
/// range
inline void CheckParameters(const DecimationParameters& parameters)
{
    const double weight = parameters.featureWeight;
    if (!(weight >= 0 && weight <= 50)) // negated, so NaN is refused too
        throw std::invalid_argument("feature_weight = " + std::to_string(weight) + " is outside [0, 50]");
    const double error = parameters.maxError;
    if (!(error >= 0 && error <= 100))
        throw std::invalid_argument("max_error = " + std::to_string(error) + " is outside [0, 100]");
    const double weld = parameters.weldDistance;
    if (!(weld >= 0 && weld <= 100))
        throw std::invalid_argument("weld_distance = " + std::to_string(weld) + " is outside [0, 100]");
    if (parameters.targetFaces < 1) throw std::invalid_argument("target_faces = 0 is less than 1");
    if (parameters.threads < 0)
        throw std::invalid_argument("threads = " + std::to_string(parameters.threads) + " is less than 0");
    const double attributes = parameters.attributeWeight;
    if (!(attributes >= 0 && attributes <= 100))
        throw std::invalid_argument("attribute_weight = " + std::to_string(attributes) +
                                    " is outside [0, 100]");
    if (!(parameters.costLimit >= 0)) throw std::invalid_argument("cost_limit is less than 0");
    if (!(parameters.descriptorScale >= 0)) throw std::invalid_argument("descriptor_scale is less than 0");
}

/// Checks that the view can be simplified. \throws std::invalid_argument that says what is wrong, with the
/// count
inline void CheckMesh(const MeshView& view)
{
    if (view.faceCount == 0) throw std::invalid_argument("the mesh has no faces");
    if (!HasSoundFace(view))
        throw std::invalid_argument("all " + std::to_string(view.faceCount) +
                                    " faces are degenerate: each has the same vertex at two corners");
    if (const std::size_t bad = CountNonFinite(view))
        throw std::invalid_argument("the coordinates of " + std::to_string(bad) + " of " +
                                    std::to_string(view.vertexCount) + " vertices are not finite");
    if (view.attributes == nullptr) return;
    if (const std::size_t bad = CountNonFinite(*view.attributes, view.faceCount))
        throw std::invalid_argument("the attributes of " + std::to_string(bad) + " of " +
                                    std::to_string(view.faceCount) + " faces are not finite");
}

/// \throws std::invalid_argument as CheckParameters and CheckMesh, and where the order needs VCG's queue,
///         which only vcg_ext/decimate.h has
inline void CheckForSweeps(const MeshView& view, const DecimationParameters& parameters)
{
    CheckParameters(parameters);
    CheckMesh(view);
    if (parameters.order == Order::Strict)
        throw std::invalid_argument("order = strict needs vcg_ext/decimate.h");
}

/// CollapseEngine as the first stage of the pipeline. \pre the parameters outlive it
struct SweepCollapse {
    const DecimationParameters& parameters;
    BoundKeeper* bound = nullptr;

    VCG_EXT_INLINE CollapsedSurface operator()(const MeshView& view, KeptForLater kept,
                                               StageProgress progress) const;

  private:
    VCG_EXT_INLINE CollapsedSurface Run(const MeshView& view, const KeptForLater& kept,
                                        StageProgress progress) const;
};

/// The sweep engine from a mesh to its report. \pre CheckForSweeps passes; the input is taken as it is
VCG_EXT_INLINE Simplification RunSweeps(const MeshView& view, const DecimationParameters& parameters);

/// Simplifies a mesh of plain arrays, which stays as it is. The collapse is that of CollapseEngine.
///
///     vcg_ext::MeshView view;               // points to the caller's arrays
///     vcg_ext::DecimationParameters parameters;
///     parameters.targetFaces = 1000;
///     const auto [mesh, report] = vcg_ext::Simplify(view, parameters);
///
/// \throws std::invalid_argument as CheckForSweeps; std::length_error for 2^29 faces and more;
///         std::bad_alloc
/// \pre indices of the view are below its vertexCount
VCG_EXT_INLINE Simplification Simplify(const MeshView& view, const DecimationParameters& parameters);

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/core/simplify_inl.h"
#endif
