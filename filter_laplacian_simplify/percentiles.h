// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace laplacian_simplify
{

/// Exact percentiles of many numbers, several times faster than by sorting: only the numbers in one bin of a
/// histogram are ordered.
class Percentiles
{
    static constexpr std::size_t kBins = 4096;

    const std::vector<double>& values_;
    double minimum_, maximum_;
    std::array<std::size_t, kBins> counts_{};

    std::size_t BinOf(double value) const
    {
        const double place = (value - minimum_) / (maximum_ - minimum_) * kBins;
        return std::min(static_cast<std::size_t>(place), kBins - 1);
    }

  public:
    /// \pre not empty, all finite; \p values outlives this object
    explicit Percentiles(const std::vector<double>& values) : values_(values)
    {
        const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
        minimum_ = *smallest;
        maximum_ = *largest;
        if (!(maximum_ > minimum_)) return;
        for (const double value : values) ++counts_[BinOf(value)];
    }

    double Minimum() const { return minimum_; }
    double Maximum() const { return maximum_; }

    /// The value at rank \p fraction of the sorted values, rounded down: 0.999 for the 99.9th percentile.
    /// \pre fraction in [0, 1]
    double operator()(double fraction) const
    {
        if (!(maximum_ > minimum_)) return minimum_;
        auto rank = static_cast<std::size_t>(fraction * static_cast<double>(values_.size() - 1));
        std::size_t bin = 0;
        while (rank >= counts_[bin]) rank -= counts_[bin++];
        std::vector<double> inBin;
        inBin.reserve(counts_[bin]);
        for (const double value : values_)
            if (BinOf(value) == bin) inBin.push_back(value);
        const auto place = inBin.begin() + static_cast<std::ptrdiff_t>(rank);
        std::nth_element(inBin.begin(), place, inBin.end());
        return *place;
    }
};

} // namespace laplacian_simplify
