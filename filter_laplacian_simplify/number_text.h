// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace laplacian_simplify
{

/// The shortest text that reads back as the same number; with a decimal point in every locale.
std::string NumberText(double value);

/// A number with at most \p digits significant digits, for reports.
std::string RoundedText(double value, int digits);

/// A number with \p decimals digits after the decimal point: "0.55". \pre below 1e50 in magnitude
std::string FixedText(double value, int decimals);

/// A count with thousands separators: "23,680".
std::string CountText(std::size_t count);

/// A host's number as the decimal that the user typed: the float 0.1f becomes 0.1. Parameters and messages
/// are thereby the same in single and double precision.
double ExactDecimal(float value);
inline double ExactDecimal(double value)
{
    return value;
}

} // namespace laplacian_simplify
