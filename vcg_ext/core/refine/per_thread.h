// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "vcg_ext/core/refine/energy.h"

namespace vcg_ext
{

/// One object of scratch per thread, and what each of them counted.
template <class Tool>
class PerThread
{
    struct alignas(64) Slot {
        Tool tool;
        std::size_t count = 0;
        explicit Slot(RefinementState& state) : tool(state) {}
    };
    std::vector<Slot> slots_;

  public:
    PerThread(RefinementState& state, int threads)
    {
        slots_.reserve(static_cast<std::size_t>(threads));
        for (int i = 0; i < threads; ++i) slots_.emplace_back(state);
    }
    Slot& operator[](int thread) { return slots_[static_cast<std::size_t>(thread)]; }
    std::size_t Count() const
    {
        std::size_t sum = 0;
        for (const Slot& slot : slots_) sum += slot.count;
        return sum;
    }
};

} // namespace vcg_ext
