// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "number_text.h"
#include "results.h"
#include "vcg_ext/core/attributes/attribute_report.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/mesh_attribute.h"

namespace laplacian_simplify
{

/// Of every attribute the rms difference in its own unit; of colors, 0 to 255, the mean over their parts.
/// Empty where it was not measured.
inline std::vector<double> AttributeErrors(const vcg_ext::AttributeReport& report,
                                           const vcg_ext::AttributeLayout& layout)
{
    std::vector<double> errors;
    if (report.rms.empty()) return errors;
    for (const vcg_ext::MeshAttribute& attribute : layout.attributes) {
        const bool color = attribute.Row().kind == vcg_ext::ChannelKind::Color;
        double sum = 0;
        int parts = 0;
        for (const vcg_ext::AttributeComponent& component : attribute.components) {
            if (!component.HasChannel()) continue;
            const double error = report.rms[component.channel] * component.scale * (color ? 255 : 1);
            sum += error * error;
            ++parts;
        }
        errors.push_back(std::sqrt(color ? sum / parts : sum));
    }
    return errors;
}

/// The results of a decimation about its attributes.
inline void AddAttributes(const vcg_ext::AttributeReport& attributes, const vcg_ext::AttributeLayout& layout,
                          Report& report)
{
    const std::vector<double> errors = AttributeErrors(attributes, layout);
    if (!errors.empty()) report.Set("attribute_rms", errors);
    if (!attributes.textures.empty()) {
        report.Set("texture_deviation", attributes.textures.front().rms);
        report.Set("largest_texture_deviation", attributes.textures.front().largest);
    }
    if (vcg_ext::HasTexture(layout)) report.SetCount("turned_texture_faces", attributes.turnedFaces);
    report.SetCount("faces_held_by_seams", attributes.heldFaces);
}

/// The numbers of a decimation under the ids of the table of results.
/// \param layout of its attributes
inline Report ToReport(const vcg_ext::DecimationReport& decimation,
                       const vcg_ext::AttributeLayout& layout = {})
{
    Report report;
    report.SetCount("faces_before", decimation.facesBefore);
    report.SetCount("faces", decimation.faces);
    report.SetCount("vertices", decimation.vertices);
    report.Set("target_reached", decimation.targetReached);
    report.Set("stop_reason", static_cast<int>(decimation.stopReason));
    if (decimation.distances) {
        report.Set("hausdorff", decimation.distances->hausdorff);
        report.Set("rms", decimation.distances->rms);
        report.Set("feature_rms", decimation.distances->featureRms);
        report.SetCount("folded", decimation.distances->folded);
    }
    if (decimation.stopReason != vcg_ext::StopReason::Cancelled) {
        report.SetCount("non_manifold_edges", decimation.edges.nonManifold);
        report.SetCount("boundary_edges", decimation.edges.boundary);
    }
    if (decimation.selfIntersections) report.SetCount("self_intersections", *decimation.selfIntersections);
    if (decimation.selfIntersectionsBefore)
        report.SetCount("self_intersections_before", *decimation.selfIntersectionsBefore);
    if (decimation.cleaning) {
        report.SetCount("welded_vertices", decimation.cleaning->weldedVertices);
        report.SetCount("dropped_faces", decimation.cleaning->DroppedFaces());
    }
    if (decimation.certifiedError) report.Set("certified_error", *decimation.certifiedError);
    if (decimation.attributes) AddAttributes(*decimation.attributes, layout, report);
    report.Set("seconds", decimation.seconds);
    return report;
}

/// The numbers of levels of detail: under every id a list, one number a level, NaN where a level has none.
/// \param layout of their attributes
inline Report ToReport(const std::vector<vcg_ext::DecimationReport>& levels,
                       const vcg_ext::AttributeLayout& layout = {})
{
    std::vector<Report> reports;
    reports.reserve(levels.size());
    for (const auto& level : levels) reports.push_back(ToReport(level, layout));
    const auto asReal = [](const auto& value) -> double {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>)
            return static_cast<double>(value);
        else
            throw std::logic_error("a decimation reports no lists");
    };
    Report all;
    for (const Result* row : ResultsOf(FilterId::LevelsOfDetail)) {
        std::vector<double> list(levels.size(), std::numeric_limits<double>::quiet_NaN());
        bool any = false;
        for (std::size_t i = 0; i < levels.size(); ++i)
            for (const auto& [id, value] : reports[i].Entries()) {
                if (id != row->id) continue;
                list[i] = std::visit(asReal, value);
                any = true;
            }
        if (any) all.Set(row->id, std::move(list));
    }
    return all;
}

/// Whether a target of \p target faces was reached, and if not, why.
inline std::string StopDescription(const vcg_ext::DecimationReport& decimation, std::size_t target)
{
    const std::string missed = "target of " + CountText(target) + " faces not reached: ";
    switch (decimation.stopReason) {
    case vcg_ext::StopReason::Target:
        return "target reached";
    case vcg_ext::StopReason::ErrorBound:
        return "error bound reached: every further collapse would exceed it";
    case vcg_ext::StopReason::NoLegalCollapse:
        if (decimation.edges.boundary >
            2 * decimation.faces) // an STL file: every face has vertices of its own
            return missed +
                   "most faces are not connected; turn on \"Clean the input\", or set a \"Weld distance\"";
        return missed + "no further collapse is possible without damage "
                        "(flipped faces, non-manifold edges, changes to locked parts)";
    case vcg_ext::StopReason::Seams:
        return missed +
               "seams hold the last faces of their charts; set \"Seams\" to ignore, or make a texture of "
               "fewer parts";
    case vcg_ext::StopReason::Cancelled:
        return "canceled; the mesh is unchanged";
    }
    return {};
}

/// How many faces cross, and whether that is more than before.
inline std::string CrossingsText(const vcg_ext::DecimationReport& decimation)
{
    const std::size_t before = decimation.selfIntersectionsBefore.value_or(0);
    std::string text = "Pairs of faces that cross: " + CountText(*decimation.selfIntersections);
    if (decimation.selfIntersectionsBefore) text += " (before: " + CountText(before) + ")";
    if (*decimation.selfIntersections > before) text += "; not all of them could be avoided";
    return text;
}

/// What became of the attributes, one line each for all of them and for the texture.
inline std::vector<std::string> AttributeLines(const vcg_ext::AttributeReport& report,
                                               const vcg_ext::AttributeLayout& layout)
{
    std::vector<std::string> lines;
    const std::vector<double> errors = AttributeErrors(report, layout);
    std::string named;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const vcg_ext::MeshAttribute& attribute = layout.attributes[i];
        const bool color = attribute.Row().kind == vcg_ext::ChannelKind::Color;
        constexpr std::size_t kLongestName = 40; // custom ones have any
        named += (i > 0 ? ", " : "") + attribute.name.substr(0, kLongestName) + " " +
                 RoundedText(errors[i], 3) + (color ? " of 255" : "");
    }
    constexpr std::size_t kLongestLine = 360;
    if (named.size() > kLongestLine) named = named.substr(0, kLongestLine) + "...";
    if (!named.empty()) lines.push_back("Attributes, rms difference: " + named);
    if (!report.textures.empty())
        lines.push_back("Texture deviation in percent of the bounding box diagonal: rms " +
                        RoundedText(report.textures.front().rms, 4) + ", largest " +
                        RoundedText(report.textures.front().largest, 4) +
                        "; faces whose texture is turned over: " + CountText(report.turnedFaces));
    return lines;
}

/// The numbers of a decimation as a few short lines for the log. They are plain ASCII, because hosts print
/// them in the encoding of the locale.
/// \param errorBound one was asked for \param layout of the attributes
inline std::vector<std::string> LogLines(const vcg_ext::DecimationReport& decimation, std::size_t target,
                                         bool errorBound = false, const vcg_ext::AttributeLayout& layout = {})
{
    if (decimation.stopReason == vcg_ext::StopReason::Cancelled) return {StopDescription(decimation, target)};
    const double percent =
        100 * static_cast<double>(decimation.faces) / static_cast<double>(decimation.facesBefore);
    std::vector<std::string> lines;
    lines.push_back(CountText(decimation.facesBefore) + " -> " + CountText(decimation.faces) + " faces (" +
                    RoundedText(percent, 3) + " %), " + CountText(decimation.vertices) + " vertices, " +
                    FixedText(decimation.seconds, 2) + " s; " + StopDescription(decimation, target));
    if (decimation.cleaning && decimation.cleaning->weldedVertices + decimation.cleaning->DroppedFaces() > 0)
        lines.push_back("Cleaned: " + CountText(decimation.cleaning->weldedVertices) + " vertices welded, " +
                        CountText(decimation.cleaning->degenerateFaces) + " degenerate and " +
                        CountText(decimation.cleaning->duplicateFaces) + " duplicate faces left out");
    if (decimation.certifiedError)
        lines.push_back("No point of either surface is farther from the other than " +
                        RoundedText(*decimation.certifiedError, 4) +
                        " percent of the bounding box diagonal (proven)");
    else if (errorBound)
        lines.push_back("The error bound could not be proven: the result may be farther from the original");
    if (const auto& distances = decimation.distances)
        lines.push_back("Distances in percent of the bounding box diagonal: largest (Hausdorff) " +
                        RoundedText(distances->hausdorff, 4) + ", rms " + RoundedText(distances->rms, 4) +
                        ", rms at features " + RoundedText(distances->featureRms, 4) +
                        "; folded faces: " + CountText(distances->folded));
    lines.push_back("Non-manifold edges: " + CountText(decimation.edges.nonManifold) +
                    ", boundary edges: " + CountText(decimation.edges.boundary));
    if (decimation.selfIntersections) lines.push_back(CrossingsText(decimation));
    if (decimation.attributes)
        for (std::string& line : AttributeLines(*decimation.attributes, layout))
            lines.push_back(std::move(line));
    return lines;
}

} // namespace laplacian_simplify
