// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <utility>

#include "vcg_ext/core/base/progress.h"

namespace laplacian_simplify
{

/// Passes progress on at most ten times a second, as hosts redraw themselves on every call.
class CalmProgress
{
  public:
    using Clock = std::chrono::steady_clock;
    using Now = std::function<Clock::time_point()>;

  private:
    static constexpr std::chrono::milliseconds kPause{100};

    vcg_ext::Progress host_;
    Now now_;
    Clock::time_point last_{}; // long ago, so the first call is passed on
    bool goOn_ = true;

  public:
    /// \param now tells the time
    explicit CalmProgress(vcg_ext::Progress host, Now now = Clock::now)
        : host_(std::move(host)), now_(std::move(now))
    {
    }

    /// False from the call on in which the host asked to stop.
    bool operator()(int percent, const char* stage)
    {
        if (!goOn_ || !host_) return goOn_;
        const auto now = now_();
        if (now - last_ < kPause) return true;
        last_ = now;
        goOn_ = host_(percent, stage);
        return goOn_;
    }
};

/// What a filter that has nothing to report throws when the host asks it to stop.
inline std::runtime_error Cancelled()
{
    return std::runtime_error("cancelled; the mesh is unchanged");
}

} // namespace laplacian_simplify
