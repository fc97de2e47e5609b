// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters.h"

namespace laplacian_simplify
{

/// What a host hands over for a parameter: a number (0 or 1 for a switch, the index of an option for a
/// choice), or text that it could not read as a number.
using GivenValue = std::variant<double, std::string>;

/// Asks the host for the value of a parameter; without one the default is used.
using GivenValues = std::function<std::optional<GivenValue>(const Parameter& parameter)>;

/// The numbers of a text such as "50, 25,10"; none where it is empty.
/// \throws std::invalid_argument that names the word that is no number in the range:
///         "percents = \"50,x\": \"x\" is not a number in (0, 100]"
std::vector<double> NumbersIn(const Parameter& parameter, const std::string& text);

/// Refuses a value that the parameter cannot take; a single number is one for Numbers, too.
/// \throws std::invalid_argument that names id, value and allowed values: "feature_weight = 51 is outside [0,
/// 50]",
///         "effort = 7 is not one of fast (0), balanced (1), best (2)"
void Check(const Parameter& parameter, const GivenValue& value);

/// The parameters of one run, each in its range.
class Values
{
    struct Entry {
        const Parameter* parameter;
        GivenValue value;
    };
    std::vector<Entry> entries_;

    const Entry& Find(std::string_view id) const;

  public:
    /// \param facts called only if a default depends on the mesh and the host has no value
    /// \throws std::invalid_argument as Check, for the first value that is refused
    Values(FilterId filter, const std::function<MeshFacts()>& facts, const GivenValues& given);

    bool Boolean(std::string_view id) const { return Real(id) != 0; }
    int Integer(std::string_view id) const { return static_cast<int>(Real(id)); }
    double Real(std::string_view id) const { return std::get<double>(Find(id).value); }
    std::vector<double> Numbers(std::string_view id) const;
    /// \pre the enumerators of E are the options of the row, in their order
    template <class E>
    E Choice(std::string_view id) const
    {
        return static_cast<E>(Integer(id));
    }
};

} // namespace laplacian_simplify
