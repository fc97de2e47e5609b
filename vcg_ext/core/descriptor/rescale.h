// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace vcg_ext
{

/// The descriptor scaled linearly to [0, 1], as Eq. 6 wants it: the smallest value becomes 0, the percentile
/// \p top and everything above 1, since a single outlier as the top would flatten all others. Where all
/// values are equal there is nothing to tell apart: they become 0.
/// \param top (0, 100] \throws std::invalid_argument where \p top is outside, or a value is not finite
inline std::vector<double> RescaledToUnit(std::vector<double> values, double top = 99.9)
{
    if (!(top > 0 && top <= 100))
        throw std::invalid_argument("top = " + std::to_string(top) + " is outside (0, 100]");
    const auto bad = std::count_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); });
    if (bad > 0)
        throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(values.size()) +
                                    " descriptor values are not finite");
    if (values.empty()) return values;
    std::vector<double> order = values;
    const double low = *std::min_element(values.begin(), values.end());
    const std::ptrdiff_t rank = std::lround(top / 100 * static_cast<double>(values.size() - 1));
    std::nth_element(order.begin(), order.begin() + rank, order.end());
    double high = order[static_cast<std::size_t>(rank)];
    if (!(high > low)) high = *std::max_element(values.begin(), values.end()); // features rarer than the rest
    const double scale = high > low ? 1 / (high - low) : 0;
    for (double& value : values) value = std::min((value - low) * scale, 1.0);
    return values;
}

} // namespace vcg_ext
