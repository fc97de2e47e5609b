// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <QObject>

#include <common/plugins/interfaces/filter_plugin.h>

#include "filters.h"

/// The tables of filters and parameters behind the plugin interface of MeshLab 2022.02 and later.
class FilterLaplacianSimplify : public QObject, public FilterPlugin
{
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
    Q_INTERFACES(FilterPlugin)

  public:
    FilterLaplacianSimplify();

    QString pluginName() const override;
    QString vendor() const override;
    QString filterName(ActionIDType filter) const override;
    QString pythonFilterName(ActionIDType filter) const override;
    QString filterInfo(ActionIDType filter) const override;
    FilterClass getClass(const QAction* action) const override;
    FilterArity filterArity(const QAction* action) const override;
    int postCondition(const QAction* action) const override;

    using FilterPlugin::initParameterList;
    RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override;

    /// \throws MLException with a sentence for the user, nothing else; the mesh is then unchanged
    std::map<std::string, QVariant> applyFilter(const QAction* action, const RichParameterList& parameters,
                                                MeshDocument& document, unsigned int& postConditionMask,
                                                vcg::CallBackPos* callback) override;

  private:
    const laplacian_simplify::Filter& RowOf(const QAction* action) const;
};
