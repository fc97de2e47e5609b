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
constexpr Range kFaceCount{1, std::numeric_limits<int>::max()};

Range Choices(const std::vector<Option>& options)
{
    return {0, static_cast<double>(options.size()) - 1};
}

double HalfTheFaces(const MeshFacts& facts)
{
    const std::size_t faces = facts.selectedFaces > 0 ? facts.selectedFaces : facts.faces;
    return static_cast<double>(std::max<std::size_t>(1, faces / 2));
}

double IfFacesAreSelected(const MeshFacts& facts)
{
    return facts.selectedFaces > 0 ? 1 : 0;
}

constexpr DefaultValue kHalfTheFaces{1, HalfTheFaces, "half of the faces, or of the selected faces"};
constexpr DefaultValue kIfFacesAreSelected{0, IfFacesAreSelected, "true if faces are selected"};

/// The descriptors that can be computed, optionally followed by the vertex quality as it is.
std::vector<Option> Descriptors(bool withVertexQuality)
{
    std::vector<Option> options;
    for (const auto& row : vcg_ext::kDescriptors) options.push_back({row.id, row.name});
    if (withVertexQuality) options.push_back({"vertex_quality", "Vertex quality"});
    return options;
}

/// The weightings of the paper's filter: all descriptors, followed by the quadrics of Li et al.
std::vector<Option> Weightings()
{
    std::vector<Option> options = Descriptors(true);
    options.push_back({"curvature_weighted_quadric", "Curvature-weighted quadric (Li et al. 2010)"});
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
    constexpr auto kLevels = FilterId::LevelsOfDetail;
    constexpr auto kSmooth = FilterId::UmbrellaSmooth;
    static const std::vector<Option> computed = Descriptors(false);
    static const std::vector<Option> computedOrStored = Descriptors(true);
    static const std::vector<Option> weights = Weightings();
    static const std::vector<Option> errors = ErrorFunctions();
    static const std::vector<Option> efforts = {{"fast", "fast: collapse only"},
                                                {"balanced", "balanced: collapse, then refine"},
                                                {"best", "best: collapse, refine, exchange vertices"}};
    static const std::vector<Option> boundaries = {{"free", "free: like any other edge"},
                                                   {"preserve", "preserve: borders keep their shape"},
                                                   {"lock", "lock: border vertices do not move"}};
    static const std::vector<Option> seams = {{"keep", "keep: every part of a texture stays"},
                                              {"ignore", "ignore: parts of a texture may vanish"}};
    static const std::vector<Option> orders = {{"sweeps", "sweeps: fast parallel engine"},
                                               {"strict", "strict: VCG's queue (reference, one thread)"}};
    static const std::vector<Option> operators = UmbrellaOperators();
    static const std::vector<Option> borders = {
        {"free", "free: like any other vertex"}, {"along", "along the border"}, {"fixed", "fixed"}};

    // clang-format off
    static const std::vector<Parameter> parameters = {
        {"operator", {kSmooth}, Type::Choice, {0}, Choices(operators), "", "Operator",
         "The umbrella operator that moves the vertices (Desbrun et al., SIGGRAPH 1999; Zhang et al., PCM 2012).",
         operators},
        {"steps", {kSmooth}, Type::Integer, {10}, {1, 10000}, "", "Steps (1-10000)",
         "Number of iterations.", {}},
        {"step_size", {kSmooth}, Type::Real, {0.5}, {0, 1, false}, "", "Step size (0-1)",
         "Fraction of the operator's displacement that is applied in each iteration.", {}, kSlider},
        {"boundary", {kSmooth}, Type::Choice, {0}, Choices(borders), "", "Boundary",
         "How vertices on open borders move: like any other vertex, toward their neighbors on the border "
         "only, or not at all.", borders},
        {"error_function", {kWeighted}, Type::Choice, {0}, Choices(errors), "", "Error function",
         "The g of Eq. 6, which is multiplied by exp(feature weight * descriptor). Quadric: Garland and Heckbert, "
         "SIGGRAPH 1997. Melax: Game Developer, November 1998.", errors},
        {"percents", {kLevels}, Type::Numbers, {0, nullptr, "", "50,25,10"}, {0, 100, false}, "percent of the faces",
         "Percentages of faces to keep (0-100)",
         "Percentage of faces of each level (of the selected faces if \"Selection only\" is on), from the finest to the "
         "coarsest. Not used if \"Largest errors\" is given.", {}},
        {"max_errors", {kLevels}, Type::Numbers, {0}, {0, 100, false}, "percent of the bounding box diagonal",
         "Largest errors (% of diagonal)",
         "In place of percentages, from the finest to the coarsest: each level is as small as it can be if no point of "
         "either surface is farther than this from the other, in percent of the diagonal of the bounding box; proven at "
         "the end. Each is a run of its own. Needs order \"sweeps\".", {}},
        {"target_faces", {kGuided, kWeighted}, Type::Integer, kHalfTheFaces, kFaceCount, "faces",
         "Number of faces to keep",
         "Of the selected faces if \"Selection only\" is on. Used if the percentage is 0.", {}},
        {"target_percent", {kGuided, kWeighted}, Type::Real, {0}, {0, 100}, "percent of the faces",
         "Percentage of faces to keep (0-100)",
         "Not a fraction; of the selected faces if \"Selection only\" is on. 0 = use \"Number of faces to keep\".", {},
         kSlider},
        {"max_error", {kGuided, kLevels}, Type::Real, {0}, {0, 100}, "percent of the bounding box diagonal",
         "Largest error (% of diagonal, 0 = any)",
         "No point of either surface is farther than this from the other, in percent of the diagonal of the "
         "bounding box (0-100); proven at the end. The target is then the lower end: the decimation stops at whichever "
         "comes first. 0: no bound. Needs order \"sweeps\".", {}},
        {"feature_weight", {kGuided, kLevels}, Type::Real, {2}, {0, 50}, "", "Feature weight (0-50)",
         "How much more collapses near features cost (lambda of Zhang et al., PCM 2012). 0: plain decimation. 2: a fifth "
         "less error at features, for a few percent more rms error overall. 4: less at features, more elsewhere. Larger "
         "values gain little.", {}, kSlider},
        {"feature_weight", {kWeighted}, Type::Real, {10}, {0, 50}, "", "Feature weight (0-50)",
         "Lambda of Eq. 6 (Zhang et al., PCM 2012). 0: the plain error function.", {}, kSlider},
        {"effort", {kGuided, kLevels}, Type::Choice, {1}, Choices(efforts), "", "Effort",
         "Quality/speed trade-off. Fast: collapses only (quadrics of Garland and Heckbert, SIGGRAPH 1997; Lindstrom and "
         "Turk, IEEE Visualization 1998). Balanced: also refines the result. Best: also takes vertices from where they "
         "are needed least to where they gain most, and lowers the largest distances; two to three times the time of "
         "balanced.", efforts},
        {"descriptor", {kDescriptor}, Type::Choice, {0}, Choices(computed), "", "Descriptor",
         "Shape descriptor to compute. The Laplacian one is Eq. 5 of Zhang et al. (PCM 2012).", computed},
        {"descriptor", {kSelection}, Type::Choice, {0}, Choices(computedOrStored), "", "Descriptor",
         "Shape descriptor to divide into classes (Zhang et al., PCM 2012).", computedOrStored},
        {"descriptor", {kWeighted}, Type::Choice, {0}, Choices(weights), "", "Descriptor",
         "The l of Eq. 6, rescaled to [0, 1]. The curvature-weighted quadric (Li et al., ICIEA 2010) uses no l: it "
         "scales the quadrics by the absolute curvature.", weights},
        {"rescale", {kDescriptor}, Type::Boolean, {0}, kSwitch, "", "Rescale to [0, 1]",
         "Rescale the values linearly so that the minimum becomes 0 and the 99.9th percentile becomes 1; "
         "larger values are clipped to 1.", {}},
        {"colorize", {kDescriptor}, Type::Boolean, {1}, kSwitch, "", "Colorize",
         "Color the vertices by their value, from red (small) to blue (large).", {}},
        {"class_aware", {kWeighted}, Type::Boolean, {0}, kSwitch, "", "Class-aware",
         "Section 4.4: a feature vertex (of the highest class) collapses into feature neighbors only.", {}},
        {"classes", {kSelection, kWeighted}, Type::Integer, {2}, {2, 16}, "", "Classes (2-16)",
         "Number of classes.", {}},
        {"selected_classes", {kSelection}, Type::Integer, {1}, {1, 15}, "", "Selected classes (1-15)",
         "How many of the highest classes to select; fewer than the number of classes.", {}},
        {"refine", {kSelection, kWeighted}, Type::Boolean, {0}, kSwitch, "", "Refine",
         "Close gaps: while a feature vertex has fewer than the minimum number of feature neighbors, its "
         "best neighbor is added. Helps on mechanical parts, not on natural shapes.", {}},
        {"minimum_feature_neighbours", {kSelection}, Type::Integer, {2}, {1, 8}, "",
         "Minimum feature neighbors (1-8)",
         "For the refinement: the number of feature neighbors that each feature vertex should have.", {}},
        {"refinement_floor", {kSelection}, Type::Real, {0.5}, {0, 1}, "of the threshold",
         "Refinement floor (0-1)",
         "For the refinement: no vertex is added whose descriptor is below this part of the threshold.", {}, kSlider},
        {"class_as_quality", {kSelection}, Type::Boolean, {0}, kSwitch, "", "Class as quality",
         "Store the class number of each vertex, counted from 0, in its quality.", {}},
        {"boundary", {kGuided, kLevels}, Type::Choice, {1}, Choices(boundaries), "", "Boundary",
         "How open borders are treated.", boundaries},
        {"keep_attributes", {kGuided, kLevels}, Type::Boolean, {1}, kSwitch, "", "Keep attributes",
         "Texture coordinates, materials, colors, quality and custom attributes guide the decimation, their seams "
         "stay, and their values are fitted to the result. Off: the remaining vertices and faces keep their values. "
         "Needs order \"sweeps\".", {}},
        {"selected_only", {kGuided, kWeighted, kLevels}, Type::Boolean, kIfFacesAreSelected, kSwitch, "",
         "Selection only",
         "Decimate only the selected faces; the rest is untouched.", {}},
        {"selected_only", {kDescriptor, kSmooth}, Type::Boolean, kIfFacesAreSelected, kSwitch, "",
         "Selection only",
         "Change only the vertices of selected faces or, if no face is selected, the selected vertices.", {}},
        {"new_layer", {kGuided}, Type::Boolean, {0}, kSwitch, "", "New layer",
         "Keep the original, hidden, and put the result in a new layer.", {}},
        {"error_as_quality", {kGuided, kLevels}, Type::Boolean, {0}, kSwitch, "", "Error as quality",
         "Store the distance of each vertex of the result to the original in its quality, in the unit of the mesh, and "
         "color it, from red (small) to blue (large). Quality and color of the original are replaced, also with \"Keep "
         "attributes\".", {}},
        {"measure_error", {kGuided, kLevels}, Type::Boolean, {1}, kSwitch, "", "Measure error",
         "Measure the distances between original and result for the report. Takes a quarter of the time of the "
         "decimation for large meshes, about as long for small ones.", {}},
        {"descriptor", {kGuided, kLevels}, Type::Choice, {0}, Choices(computedOrStored), "", "Descriptor",
         "Measure that decides what counts as a feature.", computedOrStored, kAdvanced},
        {"attribute_weight", {kGuided, kLevels}, Type::Real, {1}, {0, 100}, "", "Attribute weight (0-100)",
         "How much attributes count against the shape. 0: they are fitted to the result, but guide nothing. 10 keeps "
         "hard borders of colors.", {}, kAdvanced | kSlider},
        {"seams", {kGuided, kLevels}, Type::Choice, {0}, Choices(seams), "", "Seams",
         "Edges at which texture, material or color change. Keep: no part between seams vanishes, and the decimation "
         "stops where only such collapses are left. Ignore: it goes on; the texture is then wrong there.", seams,
         kAdvanced},
        {"preserve_topology", {kGuided, kLevels}, Type::Boolean, {0}, kSwitch, "", "Preserve topology",
         "Keep every handle, hole and component; the filter may stop above the target.", {}, kAdvanced},
        {"lock_selected_vertices", {kGuided, kLevels}, Type::Boolean, {0}, kSwitch, "", "Lock selected vertices",
         "Selected vertices neither move nor disappear, to the bit.", {}, kAdvanced},
        {"avoid_self_intersections", {kGuided, kLevels}, Type::Boolean, {1}, kSwitch, "", "Avoid self-intersections",
         "No more faces cross each other than before. Where some would, the mesh is decimated again with more "
         "care, which takes several times as long. What could not be kept is reported.", {}, kAdvanced},
        {"clean_input", {kGuided, kLevels}, Type::Boolean, {1}, kSwitch, "", "Clean the input",
         "First joins open borders where they meet at equal coordinates, as all faces of an STL file do, and "
         "removes faces with the same vertex twice, faces that are there twice, and vertices of no face. Vertices "
         "of different color or texture coordinates become a seam, and two again at the end; without \"Keep "
         "attributes\" they stay apart.", {}, kAdvanced},
        {"weld_distance", {kGuided, kLevels}, Type::Real, {0}, {0, 100}, "percent of the bounding box diagonal",
         "Weld distance (% of diagonal)",
         "\"Clean the input\" also joins border vertices that are at most this far apart, in percent of the diagonal "
         "of the bounding box (0-100). 0: only those at equal coordinates.", {}, kAdvanced},
        {"order", {kGuided, kLevels}, Type::Choice, {0}, Choices(orders), "", "Order",
         "Collapse algorithm: fast parallel engine, or VCG's queue (reference).", orders, kAdvanced},
        {"threads", {kGuided, kLevels}, Type::Integer, {0}, {0, 1024}, "", "Threads (0-1024, 0 = all)",
         "Number of threads. 0: all cores, or OMP_NUM_THREADS if it is set. The result is bit-identical for "
         "any number of threads.", {}, kAdvanced},
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
    std::string text;
    for (std::size_t i = 0; i < parameter.options.size(); ++i)
        text += (i > 0 ? ", " : "") + parameter.options[i].id + " (" + std::to_string(i) + ")";
    if (!text.empty()) return text;
    const Range& range = parameter.range;
    text = (range.minimumIncluded ? "[" : "(") + NumberText(range.minimum) + ", " +
           NumberText(range.maximum) + "]";
    if (*parameter.unit) text += std::string(" (") + parameter.unit + ")";
    return text;
}

} // namespace laplacian_simplify
