// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "filter_classify.h"
#include "filter_descriptor.h"
#include "filter_decimate.h"
#include "filter_levels.h"
#include "filter_smooth.h"
#include "filter_weighted.h"
#include "filters.h"
#include "host.h"
#include "results.h"
#include "values.h"
#include "vcg_ext/core/base/parallel.h"

namespace laplacian_simplify
{

/// Runs a filter on the host's current mesh. A new filter needs a case here; the compiler warns if it is
/// missing. \throws std::exception with a sentence for the user; the mesh is then unchanged
template <class Host>
Report ApplyFilter(FilterId filter, Host& host, const GivenValues& given)
{
    const vcg_ext::ThreadsOfRun threads; // they end with the run
    const Values values(
        filter, [&] { return FactsOf(host.Mesh()); }, given);
    RequireUsable(host.Mesh());
    switch (filter) {
    case FilterId::ShapeDescriptor:
        return ApplyShapeDescriptor(host, values);
    case FilterId::FeatureSelection:
        return ApplyFeatureSelection(host, values);
    case FilterId::GuidedDecimation:
        return ApplyGuidedDecimation(host, values);
    case FilterId::WeightedDecimation:
        return ApplyWeightedDecimation(host, values);
    case FilterId::LevelsOfDetail:
        return ApplyLevelsOfDetail(host, values);
    case FilterId::UmbrellaSmooth:
        return ApplyUmbrellaSmooth(host, values);
    }
    throw std::logic_error("this filter has no function");
}

} // namespace laplacian_simplify
