// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the tables of filters, parameters and results for everything outside MeshLab:
//   print_tables             JSON, for the Python package
//   print_tables --markdown  the page docs/filters.md

#include <cstdio>
#include <cstring>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "filters.h"
#include "filters_page.h"
#include "parameters.h"
#include "results.h"

using namespace laplacian_simplify;

namespace
{

QString ToQt(const std::string& text)
{
    return QString::fromStdString(text);
}

const char* Name(ParameterType type)
{
    switch (type) {
    case ParameterType::Boolean:
        return "boolean";
    case ParameterType::Integer:
        return "integer";
    case ParameterType::Real:
        return "real";
    case ParameterType::Choice:
        return "choice";
    case ParameterType::Numbers:
        return "numbers";
    }
    return "";
}

const char* Name(ResultType type)
{
    switch (type) {
    case ResultType::Boolean:
        return "boolean";
    case ResultType::Integer:
        return "integer";
    case ResultType::Real:
        return "real";
    case ResultType::RealList:
        return "real_list";
    }
    return "";
}

QJsonObject ToJson(const Parameter& row)
{
    QJsonObject json{{"id", row.id},
                     {"type", Name(row.type)},
                     {"default_text", ToQt(DefaultText(row))},
                     {"range_text", ToQt(RangeText(row))},
                     {"unit", row.unit},
                     {"label", row.label},
                     {"help", row.help},
                     {"advanced", (row.shown & kAdvanced) != 0},
                     {"slider", (row.shown & kSlider) != 0}};
    // null: the default depends on the mesh
    if (row.defaultValue.onMesh)
        json["default"] = QJsonValue::Null;
    else if (row.type == ParameterType::Boolean)
        json["default"] = row.defaultValue.value != 0;
    else if (row.type == ParameterType::Numbers)
        json["default"] = row.defaultValue.numbers;
    else
        json["default"] = row.defaultValue.value;
    if (row.type != ParameterType::Boolean && row.type != ParameterType::Choice) {
        json["minimum"] = row.range.minimum;
        json["maximum"] = row.range.maximum;
        json["minimum_included"] = row.range.minimumIncluded;
    }
    if (row.type == ParameterType::Choice) {
        QJsonArray options;
        for (const Option& option : row.options)
            options.append(QJsonObject{{"id", ToQt(option.id)}, {"text", ToQt(option.text)}});
        json["options"] = options;
    }
    return json;
}

QJsonObject ToJson(const Result& row)
{
    return {{"id", row.id},
            {"type", Name(row.type)},
            {"unit", row.unit},
            {"help", row.help},
            {"optional", row.optional}};
}

QJsonObject ToJson(const Filter& row)
{
    QJsonArray parameters, results;
    for (const Parameter* parameter : ParametersOf(row.id)) parameters.append(ToJson(*parameter));
    for (const Result* result : ResultsOf(row.id)) results.append(ToJson(*result));
    return {{"id", row.key},
            {"name", row.name},
            {"python_name", row.pythonName},
            {"summary", row.summary},
            {"help", row.help},
            {"references", ToQt(References(row))},
            {"parameters", parameters},
            {"results", results}};
}

QByteArray AllAsJson()
{
    QJsonArray filters;
    for (const Filter& filter : Filters()) filters.append(ToJson(filter));
    return QJsonDocument(QJsonObject{{"filters", filters}}).toJson();
}

} // namespace

int main(int argumentCount, char** arguments)
{
    const bool markdown = argumentCount == 2 && std::strcmp(arguments[1], "--markdown") == 0;
    if (argumentCount > 1 && !markdown) {
        std::fputs("usage: print_tables [--markdown]\n", stderr);
        return 2;
    }
    const QByteArray text = markdown ? QByteArray::fromStdString(FiltersPage()) : AllAsJson();
    const auto size = static_cast<std::size_t>(text.size());
    return std::fwrite(text.constData(), 1, size, stdout) == size && std::fflush(stdout) == 0 ? 0 : 1;
}
