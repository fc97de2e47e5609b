// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include <vcg/complex/complex.h>

#include "guidance.h"
#include "host.h"
#include "number_text.h"
#include "vcg_ext/core/base/progress.h"
#include "results.h"
#include "stopwatch.h"
#include "values.h"
#include "vcg_ext/core/descriptor/feature_classes.h"
#include "vcg_ext/mesh_arrays.h"

namespace laplacian_simplify
{

/// "0.1, 0.35"
inline std::string ListText(const std::vector<double>& values)
{
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ", ") + RoundedText(value, 4);
    return text;
}

/// Selects the features and nothing else; with \p classAsQuality the quality of every vertex becomes its
/// class. \returns the number of selected vertices
template <class Mesh>
std::size_t StoreClasses(Mesh& mesh, const vcg_ext::FeatureClasses& classes, bool classAsQuality)
{
    std::size_t selected = 0;
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        auto& vertex = mesh.vert[v];
        if (vertex.IsD()) continue;
        if (classes.isFeature[v]) {
            vertex.SetS();
            ++selected;
        } else {
            vertex.ClearS();
        }
        if (classAsQuality) vertex.Q() = static_cast<std::decay_t<decltype(vertex.Q())>>(classes.classOf[v]);
    }
    return selected;
}

/// Filter "Select Feature Vertices by Laplacian Descriptor".
template <class Host>
Report ApplyFeatureSelection(Host& host, const Values& values)
{
    const Stopwatch stopwatch;
    auto& mesh = host.Mesh();
    vcg_ext::FeatureParameters parameters;
    parameters.classes = values.Integer("classes");
    parameters.selectedClasses = values.Integer("selected_classes");
    parameters.refine = values.Boolean("refine");
    parameters.minimumFeatureNeighbours = values.Integer("minimum_feature_neighbours");
    parameters.refinementFloor = values.Real("refinement_floor");
    const std::vector<double> descriptor = DescriptorValues(mesh, values.Integer("descriptor"), 0);
    const vcg_ext::MeshArrays arrays(mesh);
    const auto classes = vcg_ext::ClassifyFeatures(arrays.View(), descriptor, parameters);
    if (!host.Progress(90, "Feature vertices")) throw vcg_ext::Cancelled();

    const bool classAsQuality = values.Boolean("class_as_quality");
    host.Require(classAsQuality ? kVertexSelection | kVertexQuality : kVertexSelection);
    const std::size_t selected = StoreClasses(mesh, classes, classAsQuality);

    const vcg_ext::Clusters& clusters = classes.clusters;
    Report report;
    report.Set("thresholds", clusters.thresholds);
    report.Set("centers", clusters.centers);
    report.Set("class_sizes", std::vector<double>(clusters.sizes.begin(), clusters.sizes.end()));
    report.SetCount("promoted", classes.promoted.size());
    report.SetCount("selected", selected);
    report.Set("seconds", stopwatch.Seconds());
    host.Log(CountText(selected) + " of " + CountText(static_cast<std::size_t>(mesh.vn)) +
             " vertices are features (" + CountText(classes.promoted.size()) +
             " added by the refinement); thresholds: " + ListText(clusters.thresholds) +
             "; class centers: " + ListText(clusters.centers));
    return report;
}

} // namespace laplacian_simplify
