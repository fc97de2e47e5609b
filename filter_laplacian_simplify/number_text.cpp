// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace laplacian_simplify
{

std::string NumberText(double value)
{
    std::array<char, 64> buffer;
    const bool whole =
        value >= -1e15 && value <= 1e15 && value == static_cast<double>(static_cast<long long>(value));
    const auto end =
        whole ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), static_cast<long long>(value)).ptr
              : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string RoundedText(double value, int digits)
{
    std::array<char, 64> buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits)
            .ptr;
    return {buffer.data(), end};
}

std::string FixedText(double value, int decimals)
{
    std::array<char, 64> buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    return {buffer.data(), end};
}

std::string CountText(std::size_t count)
{
    std::string text = std::to_string(count);
    for (std::size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, ",");
    return text;
}

double ExactDecimal(float value)
{
    std::array<char, 64> text;
    double exact = static_cast<double>(value);
    if (!std::isfinite(value)) return exact;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    std::from_chars(text.data(), end, exact);
    return exact;
}

} // namespace laplacian_simplify
