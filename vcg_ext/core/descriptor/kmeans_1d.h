// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

namespace vcg_ext
{

/// Classes of numbers, in ascending order. A value belongs to class c where c thresholds are below it.
struct Clusters {
    std::vector<double> centers;    ///< mean of every class
    std::vector<double> thresholds; ///< one fewer than classes, between neighbouring classes
    std::vector<std::size_t> sizes; ///< values of every class, at least one

    std::size_t ClassOf(double value) const
    {
        const auto above = std::lower_bound(thresholds.begin(), thresholds.end(), value);
        return static_cast<std::size_t>(above - thresholds.begin());
    }
};

namespace kmeans_detail
{

/// More distinct values than these share bins.
constexpr std::size_t kBins = 1024;

/// Values that stay together.
struct Bin {
    double lowest = 0, highest = 0, sum = 0;
    std::size_t count = 0;
};

inline bool HasMoreDistinctThan(const std::vector<double>& values, std::size_t limit)
{
    std::unordered_set<double> distinct;
    return std::any_of(values.begin(), values.end(), [&](double value) {
        distinct.insert(value);
        return distinct.size() > limit;
    });
}

inline void AddTo(Bin& bin, double value)
{
    bin.lowest = bin.count == 0 ? value : std::min(bin.lowest, value);
    bin.highest = bin.count == 0 ? value : std::max(bin.highest, value);
    bin.sum += value;
    ++bin.count;
}

/// Ascending, none empty: one of every distinct value where there are few, otherwise equal intervals.
inline std::vector<Bin> MakeBins(std::vector<double> values)
{
    std::vector<Bin> bins;
    if (!HasMoreDistinctThan(values, kBins)) {
        std::sort(values.begin(), values.end());
        for (const double value : values) {
            if (bins.empty() || value != bins.back().lowest) bins.emplace_back();
            AddTo(bins.back(), value);
        }
        return bins;
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double lowest = *low / kBins, width = *high / kBins - lowest; // divided first: no overflow
    bins.resize(kBins);
    for (const double value : values) {
        const double place = (value / kBins - lowest) / width * kBins;
        AddTo(bins[std::min(static_cast<std::size_t>(place), kBins - 1)], value);
    }
    bins.erase(std::remove_if(bins.begin(), bins.end(), [](const Bin& bin) { return bin.count == 0; }),
               bins.end());
    return bins;
}

/// Splits bins into classes with the least sum of squared distances to the class means, by dynamic
/// programming over the number of classes. Since an optimal cut never moves left as the last bin moves right,
/// divide and conquer finds a row of it in n log n.
class OptimalCuts
{
    std::vector<double> count_, sum_,
        squares_;                      // of the bins before i, values relative to the first, in [0, 1]
    std::vector<double> before_, now_; // least cost of the bins before i in one class fewer, in this many
    std::vector<std::vector<std::size_t>> cuts_; // first bin of the last class, for every number of classes

    double Cost(std::size_t begin, std::size_t end) const
    {
        const double sum = sum_[end] - sum_[begin];
        return squares_[end] - squares_[begin] - sum * sum / (count_[end] - count_[begin]);
    }

    /// Fills now_ for ends in [firstEnd, lastEnd], whose cuts are in [firstCut, lastCut].
    void Solve(std::size_t firstEnd, std::size_t lastEnd, std::size_t firstCut, std::size_t lastCut)
    {
        if (firstEnd > lastEnd) return;
        const std::size_t end = firstEnd + (lastEnd - firstEnd) / 2;
        now_[end] = std::numeric_limits<double>::infinity();
        for (std::size_t cut = firstCut; cut <= std::min(lastCut, end - 1); ++cut) {
            const double cost = before_[cut] + Cost(cut, end);
            if (!(cost < now_[end])) continue;
            now_[end] = cost;
            cuts_.back()[end] = cut;
        }
        Solve(firstEnd, end - 1, firstCut, cuts_.back()[end]);
        Solve(end + 1, lastEnd, cuts_.back()[end], lastCut);
    }

  public:
    explicit OptimalCuts(const std::vector<Bin>& bins) : count_(1, 0), sum_(1, 0), squares_(1, 0)
    {
        const double origin = bins.front().lowest;
        const double range = bins.back().highest - origin;
        for (const Bin& bin : bins) {
            const auto count = static_cast<double>(bin.count);
            const double mean = range > 0 ? (bin.sum / count - origin) / range : 0;
            count_.push_back(count_.back() + count);
            sum_.push_back(sum_.back() + count * mean);
            squares_.push_back(squares_.back() + count * mean * mean);
        }
    }

    /// The first bin of every class, and behind them the number of bins. \pre 1 <= classes <= bins
    std::vector<std::size_t> Find(std::size_t classes)
    {
        const std::size_t bins = count_.size() - 1;
        now_.assign(bins + 1, std::numeric_limits<double>::infinity());
        for (std::size_t end = 1; end <= bins; ++end) now_[end] = Cost(0, end);
        for (std::size_t k = 2; k <= classes; ++k) {
            before_ = now_;
            cuts_.emplace_back(bins + 1, 0);
            Solve(k, bins, k - 1, bins - 1);
        }
        std::vector<std::size_t> starts{bins};
        for (std::size_t k = classes; k >= 2; --k) starts.push_back(cuts_[k - 2][starts.back()]);
        starts.push_back(0);
        std::reverse(starts.begin(), starts.end());
        return starts;
    }
};

inline void Check(const std::vector<double>& values, int classes)
{
    const auto bad = std::count_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); });
    if (bad > 0)
        throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(values.size()) +
                                    " values to classify are not finite");
    if (classes < 1) throw std::invalid_argument("classes = " + std::to_string(classes) + " is less than 1");
}

} // namespace kmeans_detail

/// The classes with the least sum of squared distances to their means (Eq. 8, whose centres are means): the
/// optimum, not the local one that Lloyd's iteration falls into. With more than 1024 distinct values those in
/// one of 1024 equal intervals stay together, so a threshold may be off by a thousandth of the range.
/// \throws std::invalid_argument where a value is not finite, or \p classes is below 1 or above the number of
///         distinct values
inline Clusters KMeans1D(const std::vector<double>& values, int classes)
{
    kmeans_detail::Check(values, classes);
    const std::vector<kmeans_detail::Bin> bins = kmeans_detail::MakeBins(values);
    if (static_cast<std::size_t>(classes) > bins.size())
        throw std::invalid_argument("classes = " + std::to_string(classes) +
                                    " exceeds the number of distinct values, " + std::to_string(bins.size()));
    const std::vector<std::size_t> starts =
        kmeans_detail::OptimalCuts(bins).Find(static_cast<std::size_t>(classes));
    Clusters clusters;
    for (std::size_t c = 0; c + 1 < starts.size(); ++c) {
        double sum = 0;
        std::size_t size = 0;
        for (std::size_t b = starts[c]; b < starts[c + 1]; ++b) {
            sum += bins[b].sum;
            size += bins[b].count;
        }
        clusters.centers.push_back(sum / static_cast<double>(size));
        clusters.sizes.push_back(size);
        if (c == 0) continue;
        const double below = bins[starts[c] - 1].highest, above = bins[starts[c]].lowest;
        const double middle = below / 2 + above / 2;
        clusters.thresholds.push_back(middle >= below && middle < above ? middle : below);
    }
    return clusters;
}

} // namespace vcg_ext
