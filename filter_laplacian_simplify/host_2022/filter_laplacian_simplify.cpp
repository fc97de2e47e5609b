// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2022/filter_laplacian_simplify.h"

#include <new>
#include <optional>
#include <stdexcept>

#include "filter_functions.h"
#include "host_2022/meshlab_host.h"
#include "number_text.h"
#include "values.h"

using namespace laplacian_simplify;

namespace
{

QString ToQt(const std::string& text)
{
    return QString::fromStdString(text);
}

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
    case ParameterType::Choice: {
        QStringList texts;
        for (const Option& option : row.options) texts << ToQt(option.text);
        list.addParam(RichEnum(id, static_cast<int>(value), texts, label, help));
        break;
    }
    }
}

std::optional<GivenValue> Given(const RichParameterList& list, const Parameter& row)
{
    if (!list.hasParameter(row.id)) return std::nullopt;
    const Value& value = list.getParameterByName(row.id).value();
    if (value.isBool()) return value.getBool() ? 1.0 : 0.0;
    if (value.isInt()) return static_cast<double>(value.getInt());
    if (value.isFloat()) return ExactDecimal(value.getFloat());
    if (value.isString()) return value.getString().toStdString();
    return value.typeName().toStdString();
}

QVariant ToQt(const Report::Value& value)
{
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
        Eigen::VectorXd vector(static_cast<Eigen::Index>(list->size()));
        for (std::size_t i = 0; i < list->size(); ++i) vector[static_cast<Eigen::Index>(i)] = (*list)[i];
        return QVariant::fromValue(vector);
    }
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    if (const auto* count = std::get_if<int>(&value)) return *count;
    return std::get<double>(value);
}

} // namespace

FilterLaplacianSimplify::FilterLaplacianSimplify()
{
    for (const Filter& filter : Filters()) {
        typeList.push_back(static_cast<ActionIDType>(filter.id));
        actionList.push_back(new QAction(filter.name, this));
    }
}

QString FilterLaplacianSimplify::pluginName() const
{
    return "FilterLaplacianSimplify";
}

QString FilterLaplacianSimplify::vendor() const
{
    return "The Laplacian Simplify authors";
}

QString FilterLaplacianSimplify::filterName(ActionIDType filter) const
{
    return Row(static_cast<FilterId>(filter)).name;
}

QString FilterLaplacianSimplify::pythonFilterName(ActionIDType filter) const
{
    return Row(static_cast<FilterId>(filter)).pythonName;
}

QString FilterLaplacianSimplify::filterInfo(ActionIDType filter) const
{
    return ToQt(Description(Row(static_cast<FilterId>(filter))));
}

const Filter& FilterLaplacianSimplify::RowOf(const QAction* action) const
{
    return Row(static_cast<FilterId>(ID(action)));
}

FilterPlugin::FilterClass FilterLaplacianSimplify::getClass(const QAction* action) const
{
    return HostClass<FilterPlugin>(RowOf(action));
}

FilterPlugin::FilterArity FilterLaplacianSimplify::filterArity(const QAction*) const
{
    return SINGLE_MESH;
}

int FilterLaplacianSimplify::postCondition(const QAction* action) const
{
    return HostMask<MeshModel>(RowOf(action).changes);
}

RichParameterList FilterLaplacianSimplify::initParameterList(const QAction* action,
                                                             const MeshDocument& document)
{
    const auto facts = [&] { return document.mm() ? FactsOf(document.mm()->cm) : MeshFacts{}; };
    RichParameterList list;
    for (const Parameter* row : ParametersOf(RowOf(action).id))
        AddParameter(list, *row, DefaultOf(*row, facts));
    return list;
}

std::map<std::string, QVariant> FilterLaplacianSimplify::applyFilter(const QAction* action,
                                                                     const RichParameterList& parameters,
                                                                     MeshDocument& document,
                                                                     unsigned int& postConditionMask,
                                                                     vcg::CallBackPos* callback)
{
    try {
        MeshLabHost host(document, callback, [this](const std::string& line) { log(line); });
        const Report report =
            ApplyFilter(RowOf(action).id, host, [&](const Parameter& row) { return Given(parameters, row); });
        postConditionMask = static_cast<unsigned int>(postCondition(action));
        std::map<std::string, QVariant> results;
        for (const auto& [id, value] : report.Entries()) results[id] = ToQt(value);
        return results;
    } catch (const std::bad_alloc&) {
        throw MLException("not enough memory; the mesh is unchanged");
    } catch (const std::exception& error) {
        throw MLException(QString::fromUtf8(error.what()));
    } catch (...) {
        throw MLException("unknown failure");
    }
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianSimplify)
