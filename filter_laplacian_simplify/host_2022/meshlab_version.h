// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>

namespace laplacian_simplify
{

// What host_shared needs of MeshLab 2022.02 and later: the headers above and these functions, which every
// version writes differently.

void UpdateBoxAndNormals(MeshModel& model);

/// Adds a layer with a copy of \p original, which becomes the current one.
MeshModel& AddCopy(MeshDocument& document, MeshModel& original, const QString& label);

/// Adds a parameter; those that are advanced appear when they are asked for.
template <class Rich, class... Arguments>
void AddShown(RichParameterList& list, bool advanced, const Arguments&... arguments)
{
    list.addParam(Rich(arguments..., advanced));
}

} // namespace laplacian_simplify
