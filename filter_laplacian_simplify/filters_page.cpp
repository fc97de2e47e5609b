// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters_page.h"

#include "number_text.h"
#include "results.h"

namespace laplacian_simplify
{
namespace
{

constexpr const char* kHead =
    "<!-- SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors -->\n"
    "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n"
    "# Filters\n\n"
    "Generated from the plugin's tables by `scripts/write-filters-page`; do not edit. MeshLab's menus and "
    "`.mlx` scripts use a filter's name, pymeshlab its Python name. Parameters have the same names everywhere. "
    "A choice is given by its number; pymeshlab also accepts its text, the command line its word.\n\n";

/// The host's simple HTML without line breaks.
std::string OneParagraph(std::string html)
{
    const std::string lineBreak = "<br/>";
    for (auto at = html.find(lineBreak); at != std::string::npos; at = html.find(lineBreak, at))
        html.replace(at, lineBreak.size(), " ");
    return html;
}

std::string TypeText(const Parameter& parameter)
{
    switch (parameter.type) {
    case ParameterType::Boolean:
        return "boolean";
    case ParameterType::Integer:
        return "integer " + RangeText(parameter);
    case ParameterType::Real:
        return "number " + RangeText(parameter);
    case ParameterType::Numbers:
        return "text: numbers " + RangeText(parameter) + ", separated by commas";
    case ParameterType::Choice:
        break;
    }
    std::string text = "choice: ";
    for (std::size_t i = 0; i < parameter.options.size(); ++i)
        text +=
            (i > 0 ? ", " : "") + NumberText(static_cast<double>(i)) + " `" + parameter.options[i].id + "`";
    return text;
}

std::string TypeText(ResultType type)
{
    switch (type) {
    case ResultType::Boolean:
        return "boolean";
    case ResultType::Integer:
        return "integer";
    case ResultType::Real:
        return "number";
    case ResultType::RealList:
        return "numbers";
    }
    return {};
}

std::string FilterSection(const Filter& filter)
{
    std::string page = std::string("## ") + filter.name + "\n\n`" + filter.pythonName + "`\n\n" +
                       filter.summary + (*filter.note ? " " : "") + filter.note + " " +
                       OneParagraph(filter.help) + "\n\n" +
                       "| parameter | values | default | meaning |\n|---|---|---|---|\n";
    for (const Parameter* row : ParametersOf(filter.id))
        page += std::string("| `") + row->id + "` | " + TypeText(*row) + " | " + DefaultText(*row) + " | " +
                row->help + " |\n";
    page += "\n| returned | values | meaning |\n|---|---|---|\n";
    for (const Result* row : ResultsOf(filter.id)) {
        const std::string unit = *row->unit ? std::string(", ") + row->unit : std::string();
        page +=
            std::string("| `") + row->id + "` | " + TypeText(row->type) + unit + " | " + row->help + " |\n";
    }
    return page + "\n" + OneParagraph(References(filter)) + "\n\n";
}

} // namespace

std::string DefaultText(const Parameter& parameter)
{
    if (parameter.defaultValue.onMesh) return parameter.defaultValue.description;
    const double value = parameter.defaultValue.value;
    if (parameter.type == ParameterType::Numbers) return parameter.defaultValue.numbers;
    if (parameter.type == ParameterType::Boolean) return value != 0 ? "true" : "false";
    if (parameter.type != ParameterType::Choice) return NumberText(value);
    return NumberText(value) + " `" + parameter.options[static_cast<std::size_t>(value)].id + "`";
}

std::string FiltersPage()
{
    std::string page = kHead;
    for (const Filter& filter : Filters()) page += FilterSection(filter);
    page.pop_back(); // the last section ends with one line break only
    return page;
}

} // namespace laplacian_simplify
