// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>

namespace vcg_ext
{

/// Called on the calling thread with 0..100 and what is being done; false asks the run to stop.
using Progress = std::function<bool(int percent, const char* stage)>;

/// \p progress with its 0..100 mapped to from..to; empty where it is.
inline Progress ProgressPart(Progress progress, int from, int to)
{
    if (!progress) return {};
    return [progress = std::move(progress), from, to](int percent, const char* stage) {
        return progress(from + percent * (to - from) / 100, stage);
    };
}

} // namespace vcg_ext
