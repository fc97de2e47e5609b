// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

/// A number that depends on every bit of \p value (the finalizer of MurmurHash3).
inline std::uint64_t Mixed(std::uint64_t value)
{
    value = (value ^ value >> 33U) * 0xff51afd7ed558ccdULL;
    value = (value ^ value >> 33U) * 0xc4ceb9fe1a85ec53ULL;
    return value ^ value >> 33U;
}

/// Finds items that are equal. \param hash hash(item), the same for equal items \param equal equal(a, b)
/// \return the lowest item that is equal to each; empty where no two are
/// \pre fewer than 2^32 items
template <class Hash, class Equal>
std::vector<std::uint32_t> FirstEqual(int threads, std::size_t items, const Hash& hash, const Equal& equal)
{
    constexpr std::size_t kGrain = 1U << 14U, kBuckets = 64;
    constexpr std::uint32_t kNobody = ~0U;
    std::vector<std::uint32_t> hashes(items), order(items), first(items);
    ParallelRanges(threads, items, kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i) hashes[i] = static_cast<std::uint32_t>(hash(i));
    });
    const auto bucketBegin = StableScatter(
        threads, items, kBuckets, [&](std::size_t i) { return hashes[i] % kBuckets; },
        [&](std::size_t i, std::uint32_t place) { order[place] = static_cast<std::uint32_t>(i); });
    std::vector<std::uint8_t> found(kBuckets, 0);
    ParallelFor(threads, kBuckets, [&](std::size_t bucket, int) {
        std::size_t size = 16;
        while (size < 2 * std::size_t{bucketBegin[bucket + 1] - bucketBegin[bucket]}) size *= 2;
        std::vector<std::uint32_t> table(size, kNobody);
        for (std::size_t at = bucketBegin[bucket]; at < bucketBegin[bucket + 1]; ++at) {
            const std::uint32_t item = order[at];
            std::size_t slot = hashes[item] / kBuckets % size;
            while (table[slot] != kNobody &&
                   !(hashes[table[slot]] == hashes[item] && equal(table[slot], item)))
                slot = (slot + 1) % size;
            if (table[slot] == kNobody)
                table[slot] = item;
            else
                found[bucket] = 1;
            first[item] = table[slot];
        }
    });
    for (const std::uint8_t any : found)
        if (any) return first;
    return {};
}

} // namespace vcg_ext
