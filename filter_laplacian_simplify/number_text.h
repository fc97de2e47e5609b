// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace laplacian_simplify
{

/// A number as short as it can be written without loss, with a point whatever the locale says.
std::string NumberText(double value);

/// A number with \p digits significant digits at the most, for reports.
std::string RoundedText(double value, int digits);

/// A host's number as the decimal that the user typed: the float 0.1f becomes 0.1, so that parameters and
/// messages are the same in single and double precision.
double ExactDecimal(float value);
inline double ExactDecimal(double value)
{
    return value;
}

} // namespace laplacian_simplify
