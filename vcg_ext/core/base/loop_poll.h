// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace vcg_ext
{

/// While it lives, the parallel loops that its thread starts ask, between two parts of their work, whether to
/// go on: so a run can be stopped wherever it is, without every function knowing of it. What asking throws
/// ends the loop. Threads that help with a loop do not ask.
///
/// They also tell how far the run has come, where it is known what they lead to: of the way that is left to
/// there every loop has the same share, and its parts have the same share of that.
class LoopPoll
{
    std::function<void(int)> ask_;
    LoopPoll* outer_;
    unsigned parts_ = 0;
    double percent_ = 0, until_ = 0; ///< of the whole run: at the start of the next loop, and of all
    int loops_ = 1;                  ///< that lead there; the last one, and those beyond it, never arrive

    static LoopPoll*& OfThisThread()
    {
        static thread_local LoopPoll* poll = nullptr;
        return poll;
    }
    double ShareOfLoop() const
    {
        constexpr double kOfLast = 0.9;
        return (until_ - percent_) * (loops_ > 1 ? 1.0 / loops_ : kOfLast);
    }

  public:
    /// A loop of fewer parts takes no time that anybody would notice.
    static constexpr std::size_t kShortLoop = 8;

    /// \param ask called as ask(percent)
    explicit LoopPoll(std::function<void(int)> ask)
        : ask_(std::move(ask)), outer_(std::exchange(OfThisThread(), this))
    {
    }
    LoopPoll(const LoopPoll&) = delete;
    LoopPoll& operator=(const LoopPoll&) = delete;
    ~LoopPoll() { OfThisThread() = outer_; }

    /// The run is at \p percent; the next \p loops loops lead it to \p until.
    static void LoopsLead(double percent, double until, int loops)
    {
        LoopPoll* const poll = OfThisThread();
        if (poll == nullptr) return;
        poll->percent_ = percent;
        poll->until_ = std::max(percent, until);
        poll->loops_ = loops;
    }
    /// Between two parts of work that is no parallel loop.
    static void Ask()
    {
        LoopPoll* const poll = OfThisThread();
        if (poll != nullptr) poll->ask_(static_cast<int>(poll->percent_));
    }
    /// A part of a loop is done, and with it \p done of its \p parts.
    static void PartDone(std::size_t done, std::size_t parts)
    {
        constexpr unsigned kParts =
            4; // a part takes a millisecond or so, an answer may take some microseconds
        LoopPoll* const poll = OfThisThread();
        if (poll == nullptr || ++poll->parts_ % kParts != 0) return;
        const double way = parts < kShortLoop ? 0 : static_cast<double>(done) / static_cast<double>(parts);
        poll->ask_(static_cast<int>(poll->percent_ + way * poll->ShareOfLoop()));
    }
    /// A loop of so many parts is done.
    static void LoopDone(std::size_t parts)
    {
        LoopPoll* const poll = OfThisThread();
        if (poll == nullptr || parts < kShortLoop) return;
        poll->percent_ += poll->ShareOfLoop();
        poll->loops_ = std::max(1, poll->loops_ - 1);
    }
};

} // namespace vcg_ext
