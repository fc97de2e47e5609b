// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/apply_decimation.h"
#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/levels.h"
#include "vcg_ext/core/mesh/clean_input.h"
#include "vcg_ext/core/pipeline.h"
#include "vcg_ext/core/simplify.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/mesh_attributes.h"
#include "vcg_ext/ordered/decimate.h"
#include "vcg_ext/wedge_normals.h"

namespace vcg_ext
{

/// What the simplification of a VCG mesh needs beside the parameters of Simplify.
struct MeshDecimationParameters : DecimationParameters {
    bool selectedOnly = false;         ///< faces that are not selected keep their vertices and stay
    bool lockSelectedVertices = false; ///< selected vertices neither move nor disappear
    std::vector<float> guidance; ///< descriptor in [0, 1], one a mesh.vert element; empty: the Laplacian one
    bool keepAttributes = true;  ///< what the mesh carries guides and is transferred: MeshAttributes
    bool keepQuality = true;     ///< the vertex quality, too
    /// The normals of vertices are their author's, so that vertices doubled along a hard edge make it a seam.
    /// Those that were computed from the faces differ along every crack, and say nothing.
    bool vertexNormalsAreShading = false;
};

/// A simplification of a VCG mesh.
struct MeshSimplification : Simplification {
    AttributeLayout attributes; ///< of the corner values
};

/// Simplify, for both orders. An error bound is kept by the sweeps alone.
/// \throws as Simplify
VCG_EXT_INLINE Simplification Decimate(const MeshView& view, const DecimationParameters& parameters);

/// SimplifyLevels, for both orders: in order strict every level is a run of its own.
/// \throws as Decimate and CheckLevels
VCG_EXT_INLINE std::vector<Simplification> DecimateLevels(const MeshView& view,
                                                          const DecimationParameters& parameters,
                                                          const std::vector<Level>& levels);

/// Runs on the arrays of a mesh, with all that the parameters say of it. \param run called as run(view),
/// returns a Simplification of each of its results
template <class Mesh, class Run>
std::vector<MeshSimplification> OnArraysOf(const Mesh& mesh, const MeshDecimationParameters& parameters,
                                           const Run& run)
{
    const MeshArrays<Mesh> arrays(mesh);
    MeshView view = arrays.View();
    std::vector<std::uint8_t> fixed;
    if (parameters.selectedOnly) fixed = arrays.OutsideSelection(mesh);
    if (parameters.lockSelectedVertices) AddSelectedVertices(mesh, fixed);
    if (!fixed.empty()) view.fixedVertices = fixed.data();
    if (!parameters.guidance.empty()) view.guidance = parameters.guidance.data();
    std::optional<MeshAttributes<Mesh>> attributes;
    if (parameters.keepAttributes)
        attributes.emplace(mesh, arrays, view,
                           AttributeReading{parameters.keepQuality, parameters.cleanInput,
                                            WeldDistance(view, parameters), parameters.threads});
    const CornerAttributes* const corners = attributes ? attributes->Corners() : nullptr;
    view.attributes = corners;
    std::optional<MeshNormals<Mesh>> normals;
    if (parameters.keepAttributes)
        normals.emplace(mesh, parameters.cleanInput && parameters.vertexNormalsAreShading).AddTo(view);
    std::vector<std::uint32_t> keys;
    if (parameters.cleanInput && !parameters.keepAttributes) keys = AttributeKeys(mesh);
    if (!keys.empty()) view.vertexKeys = keys.data();
    std::vector<Simplification> ofArrays = run(view);
    std::vector<MeshSimplification> results;
    results.reserve(ofArrays.size());
    for (Simplification& result : ofArrays) {
        const auto& cleaning = result.report.cleaning;
        const bool doubled = cleaning && cleaning->weldedVertices > 0;
        results.push_back({std::move(result), {}});
        if (!view.attributes && results.back().mesh.cornerSides.empty()) continue;
        results.back().attributes = attributes->Layout();
        results.back().attributes.doubledVertices = doubled;
    }
    return results;
}

/// Simplifies a VCG mesh without changing it: the result is a value, applied by ApplyDecimation.
///
/// \param mesh any VCG triangle mesh, float or double; deleted elements, unreferenced vertices, several
///        components, borders and non-manifold edges are welcome
/// \throws as Simplify
template <class Mesh>
MeshSimplification Decimate(const Mesh& mesh, const MeshDecimationParameters& parameters)
{
    CheckParameters(parameters);
    const DecimationParameters& ofArrays = parameters;
    auto results = OnArraysOf(mesh, parameters, [&](const MeshView& view) {
        std::vector<Simplification> one;
        one.push_back(Decimate(view, ofArrays));
        return one;
    });
    return std::move(results.front());
}

/// Levels of detail of a VCG mesh, each applied by ApplyDecimation to a copy. \throws as Decimate
template <class Mesh>
std::vector<MeshSimplification> DecimateLevels(const Mesh& mesh, const MeshDecimationParameters& parameters,
                                               const std::vector<Level>& levels)
{
    CheckLevels(levels);
    CheckParameters(ParametersOf(parameters, levels.front()));
    const DecimationParameters& ofArrays = parameters;
    return OnArraysOf(mesh, parameters,
                      [&](const MeshView& view) { return DecimateLevels(view, ofArrays, levels); });
}

/// Puts the result of a mesh into it, as ApplyDecimation of vcg_ext/apply_decimation.h.
/// \pre mesh has not changed since Decimate
template <class Mesh>
void ApplyDecimation(Mesh& mesh, const MeshSimplification& result, bool dropUnreferenced = false)
{
    ApplyDecimation(mesh, result.mesh, dropUnreferenced, result.attributes);
}

/// The simplification of Zhang et al. (2012): their collapse alone in the pipeline of Simplify, without
/// refinement and fold repair. \param progress may be empty
/// \throws std::invalid_argument as CheckMesh and DecimateWeighted
VCG_EXT_INLINE Simplification SimplifyWeighted(const MeshView& view, const WeightedParameters& weighted,
                                               Progress progress = {});

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/decimate_inl.h"
#endif
