// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2020/filter_laplacian_simplify.h"

#include "filter_functions.h"
#include "host_shared/failure.h"
#include "host_shared/meshlab_host.h"
#include "host_shared/meshlab_parameters.h"

using namespace laplacian_simplify;

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
    AddParameters(parameters, RowOf(action).id, document);
}

bool FilterLaplacianSimplify::applyFilter(QAction* action, MeshDocument& document,
                                          const RichParameterList& parameters, vcg::CallBackPos* callback)
{
    const auto failure = FailureOf([&] {
        MeshLabHost host(document, callback, [this](const std::string& line) { Log(line); });
        ApplyFilter(RowOf(action).id, host, ValuesIn(parameters));
    });
    errorMessage = QString::fromStdString(failure.value_or(""));
    if (failure) Log(*failure); // meshlabserver prints the log, but not errorMessage
    return !failure;
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianSimplify)
