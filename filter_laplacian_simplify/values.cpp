// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "values.h"

#include <cmath>
#include <stdexcept>

#include "number_text.h"

namespace laplacian_simplify
{
namespace
{

std::invalid_argument Refusal(const Parameter& parameter, const std::string& value, const char* problem)
{
    const char* relation = !parameter.options.empty()                 ? "not one of"
                           : parameter.type == ParameterType::Boolean ? "not"
                                                                      : problem;
    return std::invalid_argument(std::string(parameter.id) + " = " + value + " is " + relation + " " +
                                 RangeText(parameter));
}

} // namespace

void Check(const Parameter& parameter, const GivenValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value))
        throw Refusal(parameter, "\"" + *text + "\"", "not a number in");
    const double number = std::get<double>(value);
    const Range& range = parameter.range;
    const bool above = range.minimumIncluded ? number >= range.minimum : number > range.minimum;
    if (!(above && number <= range.maximum)) // negated, so NaN is refused too
        throw Refusal(parameter, NumberText(number), "outside");
    if (parameter.type != ParameterType::Real && number != std::floor(number))
        throw Refusal(parameter, NumberText(number), "not a whole number in");
}

Values::Values(FilterId filter, const std::function<MeshFacts()>& facts, const GivenValues& given)
{
    for (const Parameter* parameter : ParametersOf(filter)) {
        std::optional<GivenValue> value = given(*parameter);
        if (!value) value = DefaultOf(*parameter, facts);
        Check(*parameter, *value);
        entries_.push_back({parameter, std::get<double>(*value)});
    }
}

double Values::Find(std::string_view id) const
{
    for (const Entry& entry : entries_)
        if (entry.parameter->id == id) return entry.value;
    throw std::logic_error("this filter has no parameter " + std::string(id));
}

} // namespace laplacian_simplify
