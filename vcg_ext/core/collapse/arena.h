// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// One thread's room for new corner lists behind those of the pool. Room is claimed in chunks; where a list
/// comes to lie depends on the threads, what is in it does not.
class CornerArena
{
    static constexpr std::uint32_t kChunk = 4096;
    static constexpr std::uint32_t kLongList = kChunk / 8; ///< from here on a list claims room of its own

    std::uint32_t next_ = 0, end_ = 0;

  public:
    /// Entries of a pool that holds \p corners corners in compact lists and all lists that one sweep makes.
    /// No vertex takes part in two collapses of a sweep, so the new lists together are not longer than the
    /// old ones; an eighth of each chunk at most is left unused.
    static std::size_t PoolSize(std::size_t corners, int threads)
    {
        return corners + corners + corners / 7 + (static_cast<std::size_t>(threads) + 1) * kChunk;
    }

    /// Forgets what was claimed; a new sweep has compact lists again.
    void Reset() { next_ = end_ = 0; }

    /// Room for \p size corners. \param poolEnd end of what all threads have claimed
    std::uint32_t Claim(std::uint32_t size, std::uint32_t& poolEnd)
    {
        if (size > kLongList) return FetchAdd(poolEnd, size);
        if (end_ - next_ < size) {
            next_ = FetchAdd(poolEnd, kChunk);
            end_ = next_ + kChunk;
        }
        const std::uint32_t begin = next_;
        next_ += size;
        return begin;
    }
};

} // namespace vcg_ext
