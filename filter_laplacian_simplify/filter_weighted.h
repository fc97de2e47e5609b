// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "decimation_summary.h"
#include "filter_decimate.h"
#include "guidance.h"
#include "host.h"
#include "progress.h"
#include "stopwatch.h"
#include "values.h"
#include "vcg_ext/decimate.h"
#include "vcg_ext/curvature.h"
#include "vcg_ext/core/descriptor/feature_classes.h"
#include "vcg_ext/mesh_arrays.h"

namespace laplacian_simplify
{

/// The option of "descriptor" after the vertex quality: no l, but quadrics scaled by the absolute curvature.
constexpr int kCurvatureWeightedQuadric = static_cast<int>(std::size(vcg_ext::kDescriptors)) + 1;

/// Sets the l of Eq. 6, or the weights of the quadrics.
template <class Mesh>
void SetWeights(const Mesh& mesh, const vcg_ext::MeshView& view, const Values& values,
                vcg_ext::WeightedParameters& parameters)
{
    const int option = values.Integer("descriptor");
    if (option == kCurvatureWeightedQuadric) {
        if (parameters.errorFunction != vcg_ext::ErrorFunction::Quadric)
            throw std::invalid_argument(
                "descriptor = " + std::to_string(option) +
                " (curvature_weighted_quadric) requires error_function = 0 (quadric)");
        const auto curvatures = vcg_ext::ComputeDiscreteCurvatures(view);
        parameters.quadricWeights = vcg_ext::AbsoluteCurvature(curvatures.mean, curvatures.gaussian);
        return;
    }
    parameters.descriptor = vcg_ext::RescaledToUnit(DescriptorValues(mesh, option, 0));
}

/// The feature vertices of Section 4.4; empty if the filter does not distinguish them.
inline std::vector<std::uint8_t> FeatureClass(const vcg_ext::MeshView& view, const std::vector<double>& l,
                                              const Values& values)
{
    if (!values.Boolean("class_aware")) return {};
    if (l.empty())
        throw std::invalid_argument(
            "class_aware = true requires a descriptor that can be divided into classes, not "
            "curvature_weighted_quadric");
    vcg_ext::FeatureParameters parameters;
    parameters.classes = values.Integer("classes");
    parameters.refine = values.Boolean("refine");
    return vcg_ext::ClassifyFeatures(view, l, parameters).isFeature;
}

/// Filter "Simplification: Laplacian-Weighted Edge Collapse (Zhang et al. 2012)".
template <class Host>
Report ApplyWeightedDecimation(Host& host, const Values& values)
{
    return DecimateCurrentMesh(
        host, values, DecimationWishes{true}, [&](std::size_t target, vcg_ext::Progress progress) {
            const auto& mesh = host.Mesh();
            const vcg_ext::MeshArrays arrays(mesh);
            vcg_ext::MeshView view = arrays.View();
            vcg_ext::WeightedParameters parameters;
            parameters.targetFaces = target;
            parameters.errorFunction = values.Choice<vcg_ext::ErrorFunction>("error_function");
            parameters.featureWeight = values.Real("feature_weight");
            SetWeights(mesh, view, values, parameters);
            parameters.featureClass = FeatureClass(view, parameters.descriptor, values);
            std::vector<std::uint8_t> outside;
            if (values.Boolean("selected_only")) {
                outside = arrays.OutsideSelection(mesh);
                view.fixedVertices = outside.data();
            }
            return vcg_ext::MeshSimplification{
                vcg_ext::SimplifyWeighted(view, parameters, std::move(progress)), {}};
        });
}

} // namespace laplacian_simplify
