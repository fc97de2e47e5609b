// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "host.h"
#include "number_text.h"
#include "percentiles.h"
#include "vcg_ext/core/base/progress.h"
#include "results.h"
#include "stopwatch.h"
#include "values.h"
#include "vcg_ext/descriptors.h"
#include "vertex_quality.h"

namespace laplacian_simplify
{

/// What the report and the log say about a set of values.
struct Statistics {
    std::size_t count;
    double minimum, maximum, mean, percentile99_9;
    double lowestTenth, highestTenth; ///< a tenth of the values lies below the one, above the other
};

/// \param withTenths also fills the last two \pre not empty
inline Statistics Describe(const std::vector<double>& values, bool withTenths)
{
    const Percentiles percentile(values);
    Statistics statistics{};
    statistics.count = values.size();
    statistics.minimum = percentile.Minimum();
    statistics.maximum = percentile.Maximum();
    statistics.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    statistics.percentile99_9 = percentile(0.999);
    if (withTenths) {
        statistics.lowestTenth = percentile(0.1);
        statistics.highestTenth = percentile(0.9);
    }
    return statistics;
}

/// Filter "Laplacian Shape Descriptor": vertex quality and optionally color.
template <class Host>
Report ApplyShapeDescriptor(Host& host, const Values& values)
{
    const Stopwatch stopwatch;
    const auto kind = values.Choice<vcg_ext::Descriptor>("descriptor");
    const bool colorize = values.Boolean("colorize");
    auto& mesh = host.Mesh();
    const std::vector<bool> inScope = VerticesInScope(mesh, values.Boolean("selected_only"));
    std::vector<double> descriptor = vcg_ext::ComputeDescriptor(mesh, kind, 0);
    if (values.Boolean("rescale")) descriptor = vcg_ext::RescaledToUnit(std::move(descriptor));
    std::vector<double> changed;
    changed.reserve(descriptor.size());
    for (std::size_t v = 0; v < descriptor.size(); ++v)
        if (inScope[v]) changed.push_back(descriptor[v]);
    const Statistics statistics = Describe(changed, colorize);
    if (!host.Progress(90, "Laplacian shape descriptor")) throw vcg_ext::Cancelled();

    host.Require(colorize ? kVertexQuality | kVertexColor : kVertexQuality);
    // Like the ramp of the host's own curvature filter, it excludes a tenth of the values at either end.
    std::optional<ColorRange> colors;
    if (colorize) colors = ColorRange{statistics.lowestTenth, statistics.highestTenth};
    StoreAsQuality(mesh, descriptor, inScope, colors);

    Report report;
    report.Set("minimum", statistics.minimum);
    report.Set("maximum", statistics.maximum);
    report.Set("mean", statistics.mean);
    report.Set("percentile_99_9", statistics.percentile99_9);
    report.Set("seconds", stopwatch.Seconds());
    host.Log(std::string(vcg_ext::kDescriptors[static_cast<std::size_t>(kind)].name) + " of " +
             CountText(statistics.count) + " vertices: from " + RoundedText(statistics.minimum, 4) + " to " +
             RoundedText(statistics.maximum, 4) + ", mean " + RoundedText(statistics.mean, 4) +
             ", 99.9th percentile " + RoundedText(statistics.percentile99_9, 4));
    return report;
}

} // namespace laplacian_simplify
