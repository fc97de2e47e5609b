// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

/// One pass of a counting sort: item i goes behind all items of lower buckets and behind the earlier items of
/// its own, so the order does not depend on the number of threads.
/// \param bucketOf bucketOf(item) in [0, buckets), called twice an item
/// \param move move(item, place) puts the item where it belongs
/// \return the first place of every bucket, and the number of items behind them
/// \pre fewer than 2^32 items
template <class BucketOf, class Move>
std::vector<std::uint32_t> StableScatter(int threads, std::size_t items, std::size_t buckets,
                                         const BucketOf& bucketOf, const Move& move)
{
    const std::size_t parts = items < 4096 ? 1 : static_cast<std::size_t>(std::max(1, threads));
    const auto partBegin = [&](std::size_t part) { return items * part / parts; };
    std::vector<std::uint32_t> place(parts * buckets, 0);
    ParallelFor(threads, parts, [&](std::size_t part, int) {
        std::uint32_t* count = place.data() + part * buckets;
        for (std::size_t i = partBegin(part); i < partBegin(part + 1); ++i) ++count[bucketOf(i)];
    });
    std::vector<std::uint32_t> first(buckets + 1);
    std::uint32_t total = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        first[bucket] = total;
        for (std::size_t part = 0; part < parts; ++part) {
            std::uint32_t& here = place[part * buckets + bucket];
            const std::uint32_t count = here;
            here = total;
            total += count;
        }
    }
    first[buckets] = total;
    ParallelFor(threads, parts, [&](std::size_t part, int) {
        std::uint32_t* next = place.data() + part * buckets;
        for (std::size_t i = partBegin(part); i < partBegin(part + 1); ++i) move(i, next[bucketOf(i)]++);
    });
    return first;
}

} // namespace vcg_ext
