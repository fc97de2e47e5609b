// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <common/interfaces.h>

namespace laplacian_simplify
{

// What host_shared needs of MeshLab 2020.09: the headers above and these functions, which every version
// writes differently.

void UpdateBoxAndNormals(MeshModel& model);

/// Adds a layer with a copy of \p original, which becomes the current one.
MeshModel& AddCopy(MeshDocument& document, MeshModel& original, const QString& label);

/// Adds a parameter. This version shows all of them at once, in their order.
template <class Rich, class... Arguments>
void AddShown(RichParameterList& list, bool /*advanced*/, const Arguments&... arguments)
{
    list.addParam(Rich(arguments...));
}

} // namespace laplacian_simplify
