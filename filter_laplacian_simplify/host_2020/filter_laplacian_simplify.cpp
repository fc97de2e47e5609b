// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2020/filter_laplacian_simplify.h"

#include <new>
#include <optional>
#include <stdexcept>

#include "filter_functions.h"
#include "host_2020/meshlab_host.h"
#include "number_text.h"
#include "values.h"

using namespace laplacian_simplify;

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
        list.addParam(RichFloat(id, static_cast<float>(value), label, help));
        break;
    case ParameterType::Choice: {
        QStringList texts;
        for (const Option& option : row.options) texts << QString::fromStdString(option.text);
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
    if (value.isEnum()) return static_cast<double>(value.getEnum());
    if (value.isFloat()) return ExactDecimal(value.getFloat());
    if (value.isString()) return value.getString().toStdString();
    return value.typeName().toStdString();
}

} // namespace

FilterLaplacianSimplify::FilterLaplacianSimplify()
{
    for (const Filter& filter : Filters()) {
        typeList << static_cast<FilterIDType>(filter.id);
        actionList << new QAction(filter.name, this);
    }
}

QString FilterLaplacianSimplify::pluginName() const
{
    return "FilterLaplacianSimplify";
}

QString FilterLaplacianSimplify::filterName(FilterIDType filter) const
{
    return Row(static_cast<FilterId>(filter)).name;
}

QString FilterLaplacianSimplify::filterInfo(FilterIDType filter) const
{
    return QString::fromStdString(Description(Row(static_cast<FilterId>(filter))));
}

const Filter& FilterLaplacianSimplify::RowOf(QAction* action) const
{
    return Row(static_cast<FilterId>(ID(action)));
}

MeshFilterInterface::FilterClass FilterLaplacianSimplify::getClass(QAction* action)
{
    return HostClass<MeshFilterInterface>(RowOf(action));
}

MeshFilterInterface::FILTER_ARITY FilterLaplacianSimplify::filterArity(QAction*) const
{
    return SINGLE_MESH;
}

int FilterLaplacianSimplify::postCondition(QAction* action) const
{
    return HostMask<MeshModel>(RowOf(action).changes);
}

void FilterLaplacianSimplify::initParameterSet(QAction* action, MeshDocument& document,
                                               RichParameterList& parameters)
{
    const auto facts = [&] { return document.mm() ? FactsOf(document.mm()->cm) : MeshFacts{}; };
    for (const Parameter* row : ParametersOf(RowOf(action).id))
        AddParameter(parameters, *row, DefaultOf(*row, facts));
}

bool FilterLaplacianSimplify::applyFilter(QAction* action, MeshDocument& document,
                                          const RichParameterList& parameters, vcg::CallBackPos* callback)
{
    errorMessage.clear();
    try {
        MeshLabHost host(document, callback, [this](const std::string& line) { Log(line); });
        ApplyFilter(RowOf(action).id, host, [&](const Parameter& row) { return Given(parameters, row); });
        return true;
    } catch (const std::bad_alloc&) {
        return Fail("not enough memory; the mesh is unchanged");
    } catch (const std::exception& error) {
        return Fail(QString::fromUtf8(error.what()));
    } catch (...) {
        return Fail("unknown failure");
    }
}

bool FilterLaplacianSimplify::Fail(const QString& sentence)
{
    errorMessage = sentence;
    Log(sentence.toStdString()); // meshlabserver prints the log, but not errorMessage
    return false;
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianSimplify)
