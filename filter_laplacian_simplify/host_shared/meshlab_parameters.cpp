// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_shared/meshlab_parameters.h"

#include <optional>
#include <type_traits>

#include "host.h"
#include "number_text.h"

namespace laplacian_simplify
{
namespace
{

/// Hosts break the lines of tooltips only in HTML.
QString Tooltip(const char* help)
{
    return "<span>" + QString(help).toHtmlEscaped() + "</span>";
}

void AddParameter(RichParameterList& list, const Parameter& row, double value)
{
    const QString id = row.id, label = row.label, help = Tooltip(row.help);
    const bool advanced = (row.shown & kAdvanced) != 0;
    switch (row.type) {
    case ParameterType::Boolean:
        AddShown<RichBool>(list, advanced, id, value != 0, label, help);
        break;
    case ParameterType::Integer:
        AddShown<RichInt>(list, advanced, id, static_cast<int>(value), label, help);
        break;
    case ParameterType::Real:
        // pymeshlab, which alone is of double precision and has no dialogs, would cut the number to a float.
        if ((row.shown & kSlider) != 0 && std::is_same_v<Scalarm, float>)
            AddShown<RichDynamicFloat>(list, advanced, id, static_cast<Scalarm>(value),
                                       static_cast<Scalarm>(row.range.minimum),
                                       static_cast<Scalarm>(row.range.maximum), label, help);
        else
            AddShown<RichFloat>(list, advanced, id, static_cast<Scalarm>(value), label, help);
        break;
    case ParameterType::Numbers:
        AddShown<RichString>(list, advanced, id, QString(row.defaultValue.numbers), label, help);
        break;
    case ParameterType::Choice: {
        QStringList texts;
        for (const Option& option : row.options) texts << QString::fromStdString(option.text);
        AddShown<RichEnum>(list, advanced, id, static_cast<int>(value), texts, label, help);
        break;
    }
    }
}

} // namespace

void AddParameters(RichParameterList& list, FilterId filter, const MeshDocument& document)
{
    const auto facts = [&] { return document.mm() ? FactsOf(document.mm()->cm) : MeshFacts{}; };
    for (const Parameter* row : ParametersOf(filter)) AddParameter(list, *row, DefaultOf(*row, facts));
}

GivenValues ValuesIn(const RichParameterList& list)
{
    return [&list](const Parameter& row) -> std::optional<GivenValue> {
        if (!list.hasParameter(row.id)) return std::nullopt;
        const Value& value = list.getParameterByName(row.id).value();
        if (value.isBool()) return value.getBool() ? 1.0 : 0.0;
        if (value.isInt()) return static_cast<double>(value.getInt()); // choices too
        if (value.isFloat()) return ExactDecimal(value.getFloat());
        if (value.isString()) return value.getString().toStdString();
        return value.typeName().toStdString();
    };
}

} // namespace laplacian_simplify
