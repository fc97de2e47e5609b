// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2022/filter_laplacian_simplify.h"

#include "filter_functions.h"
#include "host_shared/failure.h"
#include "host_shared/meshlab_host.h"
#include "host_shared/meshlab_parameters.h"

using namespace laplacian_simplify;

namespace
{

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
    return QString::fromStdString(Description(Row(static_cast<FilterId>(filter))));
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
    RichParameterList list;
    AddParameters(list, RowOf(action).id, document);
    return list;
}

std::map<std::string, QVariant> FilterLaplacianSimplify::applyFilter(const QAction* action,
                                                                     const RichParameterList& parameters,
                                                                     MeshDocument& document,
                                                                     unsigned int& postConditionMask,
                                                                     vcg::CallBackPos* callback)
{
    std::map<std::string, QVariant> results;
    int written = 0;
    const auto failure = FailureOf([&] {
        MeshLabHost host(document, callback, [this](const std::string& line) { log(line); });
        const Report report = ApplyFilter(RowOf(action).id, host, ValuesIn(parameters));
        for (const auto& [id, value] : report.Entries()) results[id] = ToQt(value);
        written = host.Written();
    });
    if (failure) throw MLException(QString::fromStdString(*failure));
    postConditionMask = static_cast<unsigned int>(postCondition(action) | written);
    return results;
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianSimplify)
