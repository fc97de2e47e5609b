// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const std::size_t dot = original.rfind('.');
    if (dot == std::string::npos || dot == 0) return original + suffix;
    const std::string extension = original.substr(dot + 1);
    // ".ply" and ".3mf", but not that of "error 0.5"
    const bool isExtension =
        extension.size() <= kLongestExtension &&
        std::all_of(extension.begin(), extension.end(), [&](char c) { return isDigit(c) || isLetter(c); }) &&
        std::any_of(extension.begin(), extension.end(), isLetter);
    return isExtension ? original.substr(0, dot) + suffix + "." + extension : original + suffix;
}

} // namespace laplacian_simplify
