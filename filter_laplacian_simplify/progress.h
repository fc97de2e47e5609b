// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "vcg_ext/core/base/progress.h"

namespace laplacian_simplify
{

/// Passes progress on at most ten times a second, because hosts redraw themselves at every call.
class ThrottledProgress
{
  public:
    using Clock = std::chrono::steady_clock;
    using Now = std::function<Clock::time_point()>;

  private:
    static constexpr std::chrono::milliseconds kInterval{100};

    vcg_ext::Progress host_;
    Now now_;
    Clock::time_point last_; // long ago, so the first call is passed on
    bool continue_ = true;

  public:
    /// \param now returns the current time
    explicit ThrottledProgress(vcg_ext::Progress host, Now now = Clock::now)
        : host_(std::move(host)), now_(std::move(now))
    {
    }

    /// False once the host has asked to stop.
    bool operator()(int percent, const char* stage)
    {
        if (!continue_ || !host_) return continue_;
        const auto now = now_();
        if (now - last_ < kInterval) return true;
        last_ = now;
        continue_ = host_(percent, stage);
        return continue_;
    }
};

} // namespace laplacian_simplify
