// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>

namespace vcg_ext
{

/// While it lives, the parallel loops that its thread starts ask, between two parts of their work, whether to
/// go on: so a run can be stopped wherever it is, without every function knowing of it. What asking throws
/// ends the loop. Threads that help with a loop do not ask.
class LoopPoll
{
    std::function<void()> ask_;
    LoopPoll* outer_;
    unsigned parts_ = 0;

    static LoopPoll*& OfThisThread()
    {
        static thread_local LoopPoll* poll = nullptr;
        return poll;
    }

  public:
    explicit LoopPoll(std::function<void()> ask)
        : ask_(std::move(ask)), outer_(std::exchange(OfThisThread(), this))
    {
    }
    LoopPoll(const LoopPoll&) = delete;
    LoopPoll& operator=(const LoopPoll&) = delete;
    ~LoopPoll() { OfThisThread() = outer_; }

    /// A part of a loop is done.
    static void PartDone()
    {
        constexpr unsigned kParts =
            4; // a part takes a millisecond or so, an answer may take some microseconds
        LoopPoll* const poll = OfThisThread();
        if (poll != nullptr && ++poll->parts_ % kParts == 0) poll->ask_();
    }
};

} // namespace vcg_ext
