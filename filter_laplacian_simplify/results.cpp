// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace laplacian_simplify
{

namespace
{

/// The rows, and for the levels of detail those of the guided decimation: of each a list.
std::vector<Result> WithLevels(std::vector<Result> rows)
{
    const std::size_t count = rows.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto& filters = rows[i].filters;
        if (std::find(filters.begin(), filters.end(), FilterId::GuidedDecimation) == filters.end()) continue;
        if (rows[i].type == ResultType::RealList) continue; // the log has them for every level
        Result row = rows[i];
        row.filters = {FilterId::LevelsOfDetail};
        row.type = ResultType::RealList;
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

const std::vector<Result>& Results()
{
    using Type = ResultType;
    constexpr auto kDescriptor = FilterId::ShapeDescriptor;
    constexpr auto kSelection = FilterId::FeatureSelection;
    constexpr auto kGuided = FilterId::GuidedDecimation;
    constexpr auto kWeighted = FilterId::WeightedDecimation;
    constexpr auto kSmooth = FilterId::UmbrellaSmooth;
    constexpr const char* kPercent = "percent of the bounding box diagonal";
    // clang-format off
    static const std::vector<Result> results = WithLevels({
        {"minimum", {kDescriptor}, Type::Real, "",
         "Smallest value of the changed vertices.", false},
        {"maximum", {kDescriptor}, Type::Real, "",
         "Largest value of the changed vertices.", false},
        {"mean", {kDescriptor}, Type::Real, "",
         "Mean value of the changed vertices.", false},
        {"percentile_99_9", {kDescriptor}, Type::Real, "",
         "99.9th percentile of the values.", false},
        {"thresholds", {kSelection}, Type::RealList, "",
         "Thresholds between the classes, ascending.", false},
        {"centers", {kSelection}, Type::RealList, "",
         "Mean value of each class, ascending.", false},
        {"class_sizes", {kSelection}, Type::RealList, "vertices",
         "Number of vertices in each class, lowest class first.", false},
        {"promoted", {kSelection}, Type::Integer, "vertices",
         "Number of vertices added by the refinement.", false},
        {"selected", {kSelection}, Type::Integer, "vertices",
         "Number of selected vertices.", false},
        {"faces_before", {kGuided, kWeighted}, Type::Integer, "faces",
         "Number of faces before.", false},
        {"faces", {kGuided, kWeighted}, Type::Integer, "faces",
         "Number of faces afterward.", false},
        {"vertices", {kGuided, kWeighted}, Type::Integer, "vertices",
         "Number of vertices afterward.", false},
        {"target_reached", {kGuided, kWeighted}, Type::Boolean, "",
         "Whether the mesh has at most as many faces as requested.", false},
        {"stop_reason", {kGuided, kWeighted}, Type::Integer, "",
         "Why the decimation stopped: 0 target reached, 1 error bound reached, 2 no further collapse "
         "possible without damage, 3 canceled, 4 seams hold the last faces of their charts.", false},
        {"hausdorff", {kGuided, kWeighted}, Type::Real, kPercent,
         "Largest measured distance between original and result; missing if the error was not measured.", true},
        {"rms", {kGuided, kWeighted}, Type::Real, kPercent,
         "Root mean square distance between original and result; missing if the error was not measured.", true},
        {"feature_rms", {kGuided, kWeighted}, Type::Real, kPercent,
         "Root mean square distance at the 10 percent of the original vertices with the largest descriptor; "
         "missing if the error was not measured.", true},
        {"folded", {kGuided, kWeighted}, Type::Integer, "faces",
         "Number of faces whose normal differs by more than 90 degrees from the original's at the point "
         "closest to their centroid; missing if the error was not measured.", true},
        {"non_manifold_edges", {kGuided, kWeighted}, Type::Integer, "edges",
         "Number of edges of the result with three or more faces; missing after a canceled run.", true},
        {"boundary_edges", {kGuided, kWeighted}, Type::Integer, "edges",
         "Number of edges of the result with one face; missing after a canceled run.", true},
        {"self_intersections", {kGuided, kWeighted}, Type::Integer, "pairs of faces",
         "Number of pairs of faces of the result that cross: that have a point in common beyond the corners and "
         "edges that they share; missing without \"avoid_self_intersections\", after a canceled run, and if there "
         "was nothing to decimate.", true},
        {"self_intersections_before", {kGuided, kWeighted}, Type::Integer, "pairs of faces",
         "The same number of the original; it is counted only if faces crossed that could not be repaired, or "
         "the original has crossings there.", true},
        {"welded_vertices", {kGuided}, Type::Integer, "vertices",
         "Number of vertices that became one with another; missing without \"clean_input\", after a canceled run, "
         "and if there was nothing to decimate.", true},
        {"dropped_faces", {kGuided}, Type::Integer, "faces",
         "Number of degenerate and duplicate faces that were left out; missing as \"welded_vertices\".", true},
        {"certified_error", {kGuided}, Type::Real, kPercent,
         "No point of either surface is farther than this from the other, which is proven; missing without "
         "\"max_error\", or if it could not be proven.", true},
        {"attribute_rms", {kGuided}, Type::RealList, "",
         "Of every attribute that was kept, in the order in which the log names them, the root mean square difference "
         "between original and result, in its own unit (colors 0 to 255); missing if there is none, if the error was "
         "not measured, and if there was nothing to decimate.", true},
        {"texture_deviation", {kGuided}, Type::Real, kPercent,
         "Root mean square distance between where a point of the texture is and where it was; missing as "
         "\"attribute_rms\", and without texture coordinates.", true},
        {"largest_texture_deviation", {kGuided}, Type::Real, kPercent,
         "The largest such distance that was found; missing as \"texture_deviation\".", true},
        {"turned_texture_faces", {kGuided}, Type::Integer, "faces",
         "Number of faces whose texture is turned over against most of its chart; missing without texture "
         "coordinates, and if there was nothing to decimate.", true},
        {"faces_held_by_seams", {kGuided}, Type::Integer, "faces",
         "Number of faces above the target because seams allow no further collapse; missing without attributes, and "
         "if there was nothing to decimate.", true},
        {"moved", {kSmooth}, Type::Integer, "vertices",
         "Number of moved vertices.", false},
        {"largest_movement", {kSmooth}, Type::Real, kPercent,
         "Distance by which the farthest-moving vertex moved.", false},
        {"seconds", {kDescriptor, kSelection, kGuided, kWeighted, kSmooth}, Type::Real, "s",
         "Elapsed time.", false},
    });
    // clang-format on
    return results;
}

std::vector<const Result*> ResultsOf(FilterId filter)
{
    std::vector<const Result*> rows;
    for (const Result& row : Results())
        if (std::find(row.filters.begin(), row.filters.end(), filter) != row.filters.end())
            rows.push_back(&row);
    return rows;
}

void Report::SetCount(const char* id, std::size_t count)
{
    if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw std::overflow_error(std::string(id) + " does not fit into an int");
    Set(id, static_cast<int>(count));
}

} // namespace laplacian_simplify
