// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <common/interfaces.h>

#include "filters.h"

/// The tables of filters and parameters behind the plugin interface of MeshLab 2020.09.
class FilterLaplacianSimplify : public QObject, public MeshFilterInterface
{
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
    Q_INTERFACES(MeshFilterInterface)

  public:
    FilterLaplacianSimplify();

    QString pluginName() const override;
    QString filterName(FilterIDType filter) const override;
    QString filterInfo(FilterIDType filter) const override;
    FilterClass getClass(QAction* action) override;
    FILTER_ARITY filterArity(QAction* action) const override;
    int postCondition(QAction* action) const override;

    using MeshFilterInterface::initParameterSet;
    void initParameterSet(QAction* action, MeshDocument& document, RichParameterList& parameters) override;

    /// False on failure, with a sentence for the user in errorMsg() and in the log; the mesh is then
    /// unchanged. Throws nothing.
    bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& parameters,
                     vcg::CallBackPos* callback) override;

  private:
    const laplacian_simplify::Filter& RowOf(QAction* action) const;
};
