// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "vcg_ext/core/base/loop_poll.h"

namespace vcg_ext
{

/// Called on the calling thread with 0..100 and what is being done; false asks the run to stop.
using Progress = std::function<bool(int percent, const char* stage)>;

/// What a stage throws when the caller's progress has asked to stop. Nobody's mesh has changed by then.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("canceled; the mesh is unchanged") {}
};

/// What a run tells its caller, who may be asked again at any time.
class RunProgress
{
    Progress caller_; ///< may be empty
    int percent_ = 0;
    const char* stage_ = "Reading the mesh";

  public:
    explicit RunProgress(Progress caller) : caller_(std::move(caller)) {}
    RunProgress(const RunProgress&) = delete;
    RunProgress& operator=(const RunProgress&) = delete;

    /// It never goes back.
    bool operator()(int percent, const char* stage)
    {
        percent_ = std::max(percent_, percent);
        stage_ = stage;
        return !caller_ || caller_(percent_, stage);
    }
    /// The same stage goes on. \throws Cancelled where the caller asks to stop
    void GoOn(int percent)
    {
        percent_ = std::max(percent_, percent);
        if (caller_ && !caller_(percent_, stage_)) throw Cancelled();
    }
};

/// The progress of one stage: its 0..100 are a part of the caller's.
class StageProgress
{
    Progress caller_; ///< may be empty
    int from_ = 0, to_ = 100;

    StageProgress(Progress caller, int from, int to) : caller_(std::move(caller)), from_(from), to_(to) {}

  public:
    StageProgress() = default;
    explicit StageProgress(Progress caller) : caller_(std::move(caller)) {}

    /// The stage from \p from to \p to percent of this one.
    StageProgress Part(int from, int to) const
    {
        const int length = to_ - from_;
        return {caller_, from_ + from * length / 100, from_ + to * length / 100};
    }

    /// \throws Cancelled where the caller asks to stop
    void operator()(int percent, const char* stage) const { operator()(percent, stage, percent, 1); }
    /// The same where the next \p loops parallel loops lead to \p until.
    void operator()(int percent, const char* stage, int until, int loops = 1) const
    {
        const auto ofAll = [&](int of) { return from_ + of * (to_ - from_) / 100; };
        LoopPoll::LoopsLead(ofAll(percent), ofAll(until), loops);
        if (caller_ && !caller_(ofAll(percent), stage)) throw Cancelled();
    }
};

} // namespace vcg_ext
