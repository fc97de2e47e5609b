// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "filters.h"

namespace laplacian_simplify
{

enum class ResultType { Boolean, Integer, Real, RealList };

/// Everything that hosts, commands and pages show of a number that filters return.
struct Result {
    const char* id; ///< key of the returned map; never changes after a release
    std::vector<FilterId> filters;
    ResultType type;
    const char* unit; ///< "" where there is none
    const char* help;
    bool optional; ///< may be missing; help says when
};

/// The table of results. No filter has two of the same id.
const std::vector<Result>& Results();

/// The rows of one filter.
std::vector<const Result*> ResultsOf(FilterId filter);

/// What a filter returns: values under the ids of its results, in the order in which they were set.
class Report
{
  public:
    using Value = std::variant<bool, int, double, std::vector<double>>;

    void Set(const char* id, Value value) { entries_.emplace_back(id, std::move(value)); }
    /// A count, which hosts store as an int. \throws std::overflow_error
    void SetCount(const char* id, std::size_t count);

    const std::vector<std::pair<std::string, Value>>& Entries() const { return entries_; }

  private:
    std::vector<std::pair<std::string, Value>> entries_;
};

} // namespace laplacian_simplify
