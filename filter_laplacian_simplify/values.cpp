// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

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

bool IsIn(const Range& range, double number)
{
    const bool above = range.minimumIncluded ? number >= range.minimum : number > range.minimum;
    return above && number <= range.maximum; // written so that NaN is outside
}

/// \p text without the blanks around it.
std::string_view Trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

} // namespace

std::vector<double> NumbersIn(const Parameter& parameter, const std::string& text)
{
    std::vector<double> numbers;
    std::string_view rest = text;
    if (Trimmed(rest).empty()) return numbers;
    for (bool more = true; more;) {
        const std::size_t comma = rest.find(',');
        const std::string_view word = Trimmed(rest.substr(0, comma));
        more = comma != std::string_view::npos;
        if (more) rest.remove_prefix(comma + 1);
        double number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc() || end != word.data() + word.size() || !IsIn(parameter.range, number))
            throw std::invalid_argument(std::string(parameter.id) + " = \"" + text + "\": \"" +
                                        std::string(word) + "\" is not a number in " + RangeText(parameter));
        numbers.push_back(number);
    }
    return numbers;
}

void Check(const Parameter& parameter, const GivenValue& value)
{
    const auto* text = std::get_if<std::string>(&value);
    if (text && parameter.type == ParameterType::Numbers) {
        NumbersIn(parameter, *text);
        return;
    }
    if (text) throw Refusal(parameter, "\"" + *text + "\"", "not a number in");
    const double number = std::get<double>(value);
    if (!IsIn(parameter.range, number)) throw Refusal(parameter, NumberText(number), "outside");
    const bool whole = parameter.type != ParameterType::Real && parameter.type != ParameterType::Numbers;
    if (whole && number != std::floor(number))
        throw Refusal(parameter, NumberText(number), "not a whole number in");
}

Values::Values(FilterId filter, const std::function<MeshFacts()>& facts, const GivenValues& given)
{
    for (const Parameter* parameter : ParametersOf(filter)) {
        std::optional<GivenValue> value = given(*parameter);
        if (!value && parameter->type == ParameterType::Numbers)
            value = std::string(parameter->defaultValue.numbers);
        else if (!value)
            value = DefaultOf(*parameter, facts);
        Check(*parameter, *value);
        entries_.push_back({parameter, std::move(*value)});
    }
}

std::vector<double> Values::Numbers(std::string_view id) const
{
    const Entry& entry = Find(id);
    if (const auto* number = std::get_if<double>(&entry.value)) return {*number};
    return NumbersIn(*entry.parameter, std::get<std::string>(entry.value));
}

const Values::Entry& Values::Find(std::string_view id) const
{
    const auto isIt = [&](const Entry& entry) { return entry.parameter->id == id; };
    const auto found = std::find_if(entries_.begin(), entries_.end(), isIt);
    if (found == entries_.end()) throw std::logic_error("this filter has no parameter " + std::string(id));
    return *found;
}

} // namespace laplacian_simplify
