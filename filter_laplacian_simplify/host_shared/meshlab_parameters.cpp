// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_shared/meshlab_parameters.h"

#include <optional>

#include "host.h"
#include "number_text.h"

namespace laplacian_simplify
{
namespace
{

void AddParameter(RichParameterList& list, const Parameter& row, double value)
{
    const QString id = row.id, label = row.label, help = row.help;
    switch (row.type) {
    case ParameterType::Boolean:
        list.addParam(RichBool(id, value != 0, label, help));
        break;
    case ParameterType::Integer:
        list.addParam(RichInt(id, static_cast<int>(value), label, help));
        break;
    case ParameterType::Real:
        list.addParam(RichFloat(id, static_cast<Scalarm>(value), label, help));
        break;
    case ParameterType::Numbers:
        list.addParam(RichString(id, row.defaultValue.numbers, label, help));
        break;
    case ParameterType::Choice: {
        QStringList texts;
        for (const Option& option : row.options) texts << QString::fromStdString(option.text);
        list.addParam(RichEnum(id, static_cast<int>(value), texts, label, help));
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
