// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "decimation_summary.h"
#include "error_as_quality.h"
#include "filter_decimate.h"
#include "guidance.h"
#include "host.h"
#include "number_text.h"
#include "progress.h"
#include "values.h"
#include "vcg_ext/decimate.h"

namespace laplacian_simplify
{

/// The levels that are asked for, and their names: "25%", "error 0.05%".
struct NamedLevels {
    std::vector<vcg_ext::Level> levels;
    std::vector<std::string> names;
};

/// \throws std::invalid_argument unless there are numbers, in the order of \p isCoarser from fine to coarse
template <class IsCoarser>
void CheckNumbers(const char* id, const std::vector<double>& numbers, const IsCoarser& isCoarser)
{
    if (numbers.empty()) throw std::invalid_argument(std::string(id) + " = \"\" has no level");
    for (std::size_t i = 1; i < numbers.size(); ++i)
        if (isCoarser(numbers[i - 1], numbers[i]))
            throw std::invalid_argument(std::string(id) + " = " + NumberText(numbers[i]) + " comes after " +
                                        NumberText(numbers[i - 1]) + ": the finest level is the first");
}

/// \throws std::invalid_argument if the values do not fit each other or the mesh
inline NamedLevels LevelsIn(const Values& values, const MeshFacts& facts)
{
    const std::size_t decimated = DecimatedFaces(values, facts), others = facts.faces - decimated;
    const double maxError = values.Real("max_error");
    const std::vector<double> errors = values.Numbers("max_errors"), percents = values.Numbers("percents");
    NamedLevels result;
    if (errors.empty()) {
        CheckNumbers("percents", percents, std::less<>());
        for (const double percent : percents) {
            const std::size_t target = std::max<std::size_t>(PercentOf(decimated, percent), 1);
            result.levels.push_back({others + target, maxError});
            result.names.push_back(NumberText(percent) + "%");
        }
        return result;
    }
    CheckNumbers("max_errors", errors, std::greater<>());
    if (maxError > 0)
        throw std::invalid_argument("max_error = " + NumberText(maxError) +
                                    " and max_errors are two bounds: give one of them");
    if (values.Choice<vcg_ext::Order>("order") == vcg_ext::Order::Strict)
        throw std::invalid_argument("max_errors = " + NumberText(errors.front()) + " needs order sweeps");
    for (const double error : errors) {
        result.levels.push_back({others + 1, error});
        result.names.push_back("error " + NumberText(error) + "%");
    }
    return result;
}

/// One outcome a level: of the finest levels nothing may be left to do, as in a single run.
/// \throws vcg_ext::Cancelled
template <class Mesh>
std::vector<Outcome> OutcomesOf(const Mesh& mesh, std::vector<vcg_ext::MeshSimplification> results,
                                const std::vector<vcg_ext::Level>& levels,
                                const vcg_ext::MeshDecimationParameters& parameters, bool errorAsQuality)
{
    std::optional<VertexErrors<Mesh>> errors;
    if (errorAsQuality) errors.emplace(mesh, parameters.threads);
    std::vector<Outcome> outcomes(results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].report.stopReason == vcg_ext::StopReason::Cancelled) throw vcg_ext::Cancelled();
        if (levels[i].targetFaces >= static_cast<std::size_t>(mesh.fn)) {
            outcomes[i].report = ReportUnchanged(mesh, parameters.measureError);
            if (levels[i].maxError > 0) outcomes[i].report.certifiedError = 0;
        } else {
            outcomes[i].report = results[i].report;
            outcomes[i].result = std::move(results[i]);
        }
        if (errors)
            outcomes[i].error =
                errors->Of(outcomes[i].result ? &outcomes[i].result->mesh : nullptr, parameters.progress);
    }
    return outcomes;
}

/// Filter "Simplification: Laplacian-Guided Levels of Detail".
template <class Host>
Report ApplyLevelsOfDetail(Host& host, const Values& values)
{
    vcg_ext::MeshDecimationParameters parameters = GuidedParameters(host, values);
    const NamedLevels named = LevelsIn(values, FactsOf(host.Mesh()));
    ThrottledProgress progress([&](int percent, const char* stage) { return host.Progress(percent, stage); });
    parameters.progress = std::ref(progress);
    parameters.guidance = Guidance(host.Mesh(), values.Integer("descriptor"), parameters.threads);
    auto results = vcg_ext::DecimateLevels(host.Mesh(), parameters, named.levels);
    const vcg_ext::AttributeLayout layout = results.front().attributes; // of all of them
    std::vector<Outcome> outcomes = OutcomesOf(host.Mesh(), std::move(results), named.levels, parameters,
                                               values.Boolean("error_as_quality"));
    std::vector<vcg_ext::DecimationReport> reports;
    reports.reserve(outcomes.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        Outcome outcome = std::move(outcomes[i]);
        host.ReturnToOriginal();
        const std::string errorLine = Commit(host, outcome, " " + named.names[i], parameters.cleanInput);
        const vcg_ext::Level& level = named.levels[i];
        for (const std::string& line :
             LogLines(outcome.report, level.targetFaces, level.maxError > 0, layout))
            host.Log(named.names[i] + ": " + line);
        if (!errorLine.empty()) host.Log(named.names[i] + ": " + errorLine);
        reports.push_back(std::move(outcome.report));
    }
    return ToReport(reports, layout);
}

} // namespace laplacian_simplify
