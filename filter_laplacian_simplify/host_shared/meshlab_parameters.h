// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_version.h"
#include "parameters.h"
#include "values.h"

namespace laplacian_simplify
{

/// Adds the parameters of a filter, with their defaults on the current mesh of the document.
void AddParameters(RichParameterList& list, FilterId filter, const MeshDocument& document);

/// The values in a list, which must outlive the result.
GivenValues ValuesIn(const RichParameterList& list);

} // namespace laplacian_simplify
