// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace laplacian_simplify
{

const std::vector<Result>& Results()
{
    using Type = ResultType;
    constexpr auto kDescriptor = FilterId::ShapeDescriptor;
    constexpr auto kSelection = FilterId::FeatureSelection;
    constexpr auto kGuided = FilterId::GuidedDecimation;
    constexpr auto kWeighted = FilterId::WeightedDecimation;
    constexpr auto kSmooth = FilterId::UmbrellaSmooth;
    constexpr const char* kPercent = "percent of the bounding box's diagonal";
    static const std::vector<Result> results = {
        {"minimum",
         {kDescriptor},
         Type::Real,
         "",
         "Smallest value of the vertices that were changed.",
         false},
        {"maximum", {kDescriptor}, Type::Real, "", "Largest value.", false},
        {"mean", {kDescriptor}, Type::Real, "", "Mean value.", false},
        {"percentile_99_9",
         {kDescriptor},
         Type::Real,
         "",
         "99.9 percent of the values are not above it.",
         false},
        {"thresholds", {kSelection}, Type::RealList, "", "Borders between the classes, ascending.", false},
        {"centers", {kSelection}, Type::RealList, "", "Mean value of every class, ascending.", false},
        {"class_sizes",
         {kSelection},
         Type::RealList,
         "vertices",
         "Vertices of every class, from the lowest.",
         false},
        {"promoted", {kSelection}, Type::Integer, "vertices", "Vertices that the refinement added.", false},
        {"selected", {kSelection}, Type::Integer, "vertices", "Selected vertices.", false},
        {"faces_before", {kGuided, kWeighted}, Type::Integer, "faces", "Faces of the mesh before.", false},
        {"faces", {kGuided, kWeighted}, Type::Integer, "faces", "Faces of the mesh afterwards.", false},
        {"vertices",
         {kGuided, kWeighted},
         Type::Integer,
         "vertices",
         "Vertices of the mesh afterwards.",
         false},
        {"target_reached",
         {kGuided, kWeighted},
         Type::Boolean,
         "",
         "Whether no more faces are left than were asked for.",
         false},
        {"stop_reason",
         {kGuided, kWeighted},
         Type::Integer,
         "",
         "Why the collapse ended: 0 target, 1 error bound, 2 no legal collapse left, 3 cancelled.",
         false},
        {"hausdorff",
         {kGuided, kWeighted},
         Type::Real,
         kPercent,
         "Largest distance found between original and result; missing where the error was not measured.",
         true},
        {"rms",
         {kGuided, kWeighted},
         Type::Real,
         kPercent,
         "Root of the mean squared distance between original and result; missing where the error was not "
         "measured.",
         true},
        {"feature_rms",
         {kGuided, kWeighted},
         Type::Real,
         kPercent,
         "The same at the tenth of the original vertices with the largest descriptor; only with "
         "measure_error.",
         true},
        {"folded",
         {kGuided, kWeighted},
         Type::Integer,
         "faces",
         "Faces whose normal is more than 90 degrees from the original's at the point closest to their "
         "centroid; missing where the error was not measured.",
         true},
        {"non_manifold_edges",
         {kGuided, kWeighted},
         Type::Integer,
         "edges",
         "Edges of the result with three or more faces; missing after a cancelled run.",
         true},
        {"boundary_edges",
         {kGuided, kWeighted},
         Type::Integer,
         "edges",
         "Edges of the result with one face; missing after a cancelled run.",
         true},
        {"moved", {kSmooth}, Type::Integer, "vertices", "Vertices that are not where they were.", false},
        {"largest_movement", {kSmooth}, Type::Real, kPercent, "How far the farthest vertex moved.", false},
        {"seconds",
         {kDescriptor, kSelection, kGuided, kWeighted, kSmooth},
         Type::Real,
         "s",
         "Time that it took.",
         false},
    };
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
