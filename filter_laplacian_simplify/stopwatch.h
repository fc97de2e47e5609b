// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace laplacian_simplify
{

/// Wall-clock time since its construction.
class Stopwatch
{
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

  public:
    double Seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
};

} // namespace laplacian_simplify
