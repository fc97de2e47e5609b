// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters.h"

#include <algorithm>
#include <limits>

#include "number_text.h"
#include "vcg_ext/descriptors.h"
#include "vcg_ext/ordered/error_functions.h"
#include "vcg_ext/smoothing.h"

namespace laplacian_simplify
{
namespace
{

constexpr Range kSwitch{0, 1};
constexpr Range kSomeFaces{1, std::numeric_limits<int>::max()};

Range Choices(const std::vector<Option>& options)
{
    return {0, static_cast<double>(options.size()) - 1};
}

double HalfTheFaces(const MeshFacts& facts)
{
    const std::size_t faces = facts.selectedFaces > 0 ? facts.selectedFaces : facts.faces;
    return static_cast<double>(std::max<std::size_t>(1, faces / 2));
}

double WhereFacesAreSelected(const MeshFacts& facts)
{
    return facts.selectedFaces > 0 ? 1 : 0;
}

constexpr DefaultValue kHalf{1, HalfTheFaces, "half the faces, or half the selected ones"};
constexpr DefaultValue kBySelection{0, WhereFacesAreSelected, "true where faces are selected"};

/// The descriptors that can be computed, and behind them the quality that the vertices have.
std::vector<Option> Descriptors(bool withVertexQuality)
{
    std::vector<Option> options;
    for (const auto& row : vcg_ext::kDescriptors) options.push_back({row.id, row.name});
    if (withVertexQuality) options.push_back({"vertex_quality", "Vertex quality"});
    return options;
}

/// Of the paper's filter: what weights the collapses, at last the quadrics after Li and He.
std::vector<Option> CurvatureWeighting()
{
    std::vector<Option> options = Descriptors(true);
    options.push_back({"curvature_weighted_quadric", "Curvature-weighted quadric (Li and He 2010)"});
    return options;
}

std::vector<Option> UmbrellaOperators()
{
    std::vector<Option> options;
    for (const auto& row : vcg_ext::kUmbrellaOperators) options.push_back({row.id, row.name});
    return options;
}

std::vector<Option> ErrorFunctions()
{
    std::vector<Option> options;
    for (const auto& row : vcg_ext::kErrorFunctions) options.push_back({row.id, row.name});
    return options;
}

} // namespace

const std::vector<Parameter>& Parameters()
{
    using Type = ParameterType;
    constexpr auto kDescriptor = FilterId::ShapeDescriptor;
    constexpr auto kSelection = FilterId::FeatureSelection;
    constexpr auto kGuided = FilterId::GuidedDecimation;
    constexpr auto kWeighted = FilterId::WeightedDecimation;
    constexpr auto kSmooth = FilterId::UmbrellaSmooth;
    static const std::vector<Option> computed = Descriptors(false);
    static const std::vector<Option> computedOrStored = Descriptors(true);
    static const std::vector<Option> weights = CurvatureWeighting();
    static const std::vector<Option> errors = ErrorFunctions();
    static const std::vector<Option> efforts = {{"fast", "fast: collapse only"},
                                                {"balanced", "balanced: collapse and refinement"},
                                                {"best", "best: measured order and refinement"}};
    static const std::vector<Option> boundaries = {{"free", "free: as any other edge"},
                                                   {"preserve", "preserve: borders keep their course"},
                                                   {"lock", "lock: border vertices stay where they are"}};
    static const std::vector<Option> orders = {{"sweeps", "sweeps: parallel engine"},
                                               {"strict", "strict: VCG's LocalOptimization, one thread"}};
    static const std::vector<Option> operators = UmbrellaOperators();
    static const std::vector<Option> borders = {
        {"free", "free: as any other vertex"}, {"along", "along the border"}, {"fixed", "fixed"}};

    // clang-format off
    static const std::vector<Parameter> parameters = {
        {"operator", {kSmooth}, Type::Choice, {0}, Choices(operators), "", "Operator",
         "Which umbrella operator moves the vertices.", operators},
        {"steps", {kSmooth}, Type::Integer, {10}, {1, 10000}, "", "Steps",
         "How often every vertex is moved.", {}},
        {"step_size", {kSmooth}, Type::Real, {0.5}, {0, 1, false}, "", "Step size",
         "Part of the operator's vector that a vertex moves in a step.", {}},
        {"boundary", {kSmooth}, Type::Choice, {0}, Choices(borders), "", "Boundary",
         "What vertices on open borders do: move as any other, move with their neighbours on the border "
         "only, or stay.", borders},
        {"error_function", {kWeighted}, Type::Choice, {0}, Choices(errors), "", "Error function",
         "The g of Eq. 6, multiplied by e to the power of feature_weight times the descriptor.", errors},
        {"target_faces", {kGuided, kWeighted}, Type::Integer, kHalf, kSomeFaces, "faces", "Target faces",
         "The number of faces to keep, of the selection where only the selection is decimated. Used when "
         "the target percentage is 0.", {}},
        {"target_percent", {kGuided, kWeighted}, Type::Real, {0}, {0, 100}, "percent", "Target percentage",
         "Percent of the faces to keep, of the selection where only the selection is decimated. 0: the "
         "target number of faces is used.", {}},
        {"feature_weight", {kGuided}, Type::Real, {2}, {0, 50}, "", "Feature weight",
         "Lambda of the Laplacian weighting. 0: features are not preferred; 2: more exact than plain "
         "decimation everywhere; 4 to 8: features first; 50 is past usefulness.", {}},
        {"feature_weight", {kWeighted}, Type::Real, {10}, {0, 50}, "", "Feature weight",
         "Lambda of Eq. 6. 0: the plain error function.", {}},
        {"effort", {kGuided}, Type::Choice, {1}, Choices(efforts), "", "Effort",
         "Geometry against time, by docs/benchmark.md: fast only collapses. Balanced also refines: 1.7 times as "
         "long as fast, for 10 % less rms and 17 % less feature rms. Best collapses in the order of the "
         "measured error, on one thread whatever the order, and refines: about as long as CGAL's "
         "Lindstrom-Turk, for 11 % less rms and 37 % less feature rms than fast.", efforts},
        {"descriptor", {kDescriptor}, Type::Choice, {0}, Choices(computed), "", "Descriptor",
         "What is computed.", computed},
        {"descriptor", {kSelection}, Type::Choice, {0}, Choices(computedOrStored), "", "Descriptor",
         "What is divided into classes.", computedOrStored},
        {"descriptor", {kGuided}, Type::Choice, {0}, Choices(computedOrStored), "", "Descriptor",
         "What tells features from the rest.", computedOrStored},
        {"descriptor", {kWeighted}, Type::Choice, {0}, Choices(weights), "", "Descriptor",
         "l of Eq. 6, rescaled to [0, 1]; or no l, but quadrics scaled by absolute curvature.", weights},
        {"rescale", {kDescriptor}, Type::Boolean, {0}, kSwitch, "", "Rescale to [0, 1]",
         "Rescale the values linearly so that the 99.9 percentile becomes 1; what is above is cut.", {}},
        {"colorize", {kDescriptor}, Type::Boolean, {1}, kSwitch, "", "Colorize",
         "Paint the vertices by their value, red for small and blue for large ones.", {}},
        {"class_aware", {kWeighted}, Type::Boolean, {0}, kSwitch, "", "Class-aware",
         "Section 4.4: a feature vertex, one of the highest class, goes into feature neighbours only.", {}},
        {"classes", {kSelection, kWeighted}, Type::Integer, {2}, {2, 16}, "", "Classes",
         "The number of classes.", {}},
        {"selected_classes", {kSelection}, Type::Integer, {1}, {1, 15}, "", "Selected classes",
         "How many of the highest classes are selected; fewer than there are.", {}},
        {"refine", {kSelection, kWeighted}, Type::Boolean, {0}, kSwitch, "", "Refine",
         "Close gaps: as long as a selected vertex has fewer selected neighbours than asked for, its best"
         " neighbour is added. Helps on mechanical parts, not on natural shapes.", {}},
        {"minimum_feature_neighbours", {kSelection}, Type::Integer, {2}, {1, 8}, "", "Selected neighbours",
         "For the refinement: how many selected neighbours are enough.", {}},
        {"refinement_floor", {kSelection}, Type::Real, {0.5}, {0, 1}, "of the threshold", "Refinement floor",
         "For the refinement: part of the threshold below which no vertex is added.", {}},
        {"class_as_quality", {kSelection}, Type::Boolean, {0}, kSwitch, "", "Class as quality",
         "Store the number of every vertex's class, from 0, in its quality.", {}},
        {"boundary", {kGuided}, Type::Choice, {1}, Choices(boundaries), "", "Boundary",
         "How open borders are treated.", boundaries},
        {"preserve_topology", {kGuided}, Type::Boolean, {0}, kSwitch, "", "Preserve topology",
         "Keep every handle, hole and component, at the cost of collapses that are refused.", {}},
        {"selected_only", {kGuided, kWeighted}, Type::Boolean, kBySelection, kSwitch, "", "Selection only",
         "Only the selected faces are decimated; the rest is untouched.", {}},
        {"selected_only", {kDescriptor, kSmooth}, Type::Boolean, kBySelection, kSwitch, "", "Selection only",
         "Only vertices of selected faces change, or the selected vertices where no face is selected.", {}},
        {"new_layer", {kGuided}, Type::Boolean, {0}, kSwitch, "", "New layer",
         "Keep the original and put the result into a new layer.", {}},
        {"measure_error", {kGuided}, Type::Boolean, {1}, kSwitch, "", "Measure error",
         "Measure the distances between original and result for the report; takes about as long as the "
         "decimation.", {}},
        {"order", {kGuided}, Type::Choice, {0}, Choices(orders), "", "Order",
         "Who runs the collapses: the fast engine, or the reference on VCG's framework; effort best always "
         "takes the latter.", orders},
        {"threads", {kGuided}, Type::Integer, {0}, {0, 1024}, "", "Threads",
         "Threads to use, 0 for all, or as many as OMP_NUM_THREADS says. The result does not depend on it.", {}},
    };
    // clang-format on
    return parameters;
}

std::vector<const Parameter*> ParametersOf(FilterId filter)
{
    std::vector<const Parameter*> rows;
    for (const Parameter& row : Parameters())
        if (std::find(row.filters.begin(), row.filters.end(), filter) != row.filters.end())
            rows.push_back(&row);
    return rows;
}

std::string RangeText(const Parameter& parameter)
{
    if (parameter.type == ParameterType::Boolean) return "true or false";
    const Range& range = parameter.range;
    std::string text = (range.minimumIncluded ? "[" : "(") + NumberText(range.minimum) + ", " +
                       NumberText(range.maximum) + "]";
    std::string explanation = parameter.unit;
    for (std::size_t i = 0; i < parameter.options.size(); ++i)
        explanation +=
            (i > 0 ? ", " : "") + NumberText(static_cast<double>(i)) + " " + parameter.options[i].id;
    return explanation.empty() ? text : text + " (" + explanation + ")";
}

} // namespace laplacian_simplify
