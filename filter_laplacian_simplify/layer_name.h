// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace laplacian_simplify
{

/// The label of a layer that is made from another one: "flange.ply" and "_simplified" are
/// "flange_simplified.ply". Labels are file names to MeshLab, which lists them without what follows the last
/// dot and saves them by it.
inline std::string LayerLabel(const std::string& original, const std::string& suffix)
{
    constexpr std::size_t kLongestExtension = 5;
    const std::size_t dot = original.rfind('.');
    if (dot == std::string::npos || dot == 0 || dot + 1 == original.size()) return original + suffix;
    const std::string extension = original.substr(dot + 1);
    std::string lower; // of the ASCII letters and digits
    for (const char c : extension) {
        if (c >= 'A' && c <= 'Z') lower += static_cast<char>(c - 'A' + 'a');
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) lower += c;
    }
    // The numbers of "error 0.5" and "part 1.5mm" are none.
    const bool isNumber = lower[0] >= '0' && lower[0] <= '9' && lower != "3ds" && lower != "3mf";
    const bool isExtension =
        lower.size() == extension.size() && lower.size() <= kLongestExtension && !isNumber;
    return isExtension ? original.substr(0, dot) + suffix + "." + extension : original + suffix;
}

} // namespace laplacian_simplify
