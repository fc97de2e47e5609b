// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "parameters.h"

namespace laplacian_simplify
{

/// The default of a parameter: "2", "true", "1 `balanced`", "half of the faces, or of the selected faces".
std::string DefaultText(const Parameter& parameter);

/// The page docs/filters.md: every filter with its parameters and results, from the tables.
std::string FiltersPage();

} // namespace laplacian_simplify
