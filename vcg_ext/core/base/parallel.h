// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <vector>

#include "vcg_ext/core/base/loop_poll.h"

#ifdef _OPENMP
#include <omp.h>
#else
#include <functional>
#include <system_error>
#include <thread>
#endif

namespace vcg_ext
{

// Threads are OpenMP's where the compiler was asked for it (-fopenmp), because it keeps them between two
// loops of a run; otherwise they are std::thread's, started anew for every loop. Nothing else depends on
// which.
#ifdef _OPENMP

/// Threads that a run uses: \p requested, or where it is 0 or less as many as OpenMP would: the environment's
/// OMP_NUM_THREADS, or every available core. Without OpenMP every available core.
inline int ResolveThreads(int requested)
{
    return requested > 0 ? requested : std::max(1, omp_get_max_threads());
}

/// Ends the worker threads when a run ends. They would wait for the next run otherwise, and a process that
/// forks in between, as Python's multiprocessing does, would wait in its child for threads that only its
/// parent has.
class ThreadsOfRun
{
  public:
    ThreadsOfRun() = default;
    ThreadsOfRun(const ThreadsOfRun&) = delete;
    ThreadsOfRun& operator=(const ThreadsOfRun&) = delete;
    ~ThreadsOfRun() { omp_pause_resource_all(omp_pause_hard); }
};

/// Calls work(thread) once on each of \p threads threads, or of fewer where the system refuses more, and
/// returns when all are done. \pre work does not throw
template <class Work>
void RunOnThreads(int threads, const Work& work)
{
#pragma omp parallel num_threads(threads)
    work(omp_get_thread_num());
}

#else

inline int ResolveThreads(int requested)
{
    return requested > 0 ? requested : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

class ThreadsOfRun
{
  public:
    ThreadsOfRun() = default;
    ThreadsOfRun(const ThreadsOfRun&) = delete;
    ThreadsOfRun& operator=(const ThreadsOfRun&) = delete;
    ~ThreadsOfRun() {} // no thread outlives its loop
};

template <class Work>
void RunOnThreads(int threads, const Work& work)
{
    std::vector<std::thread> others;
    others.reserve(static_cast<std::size_t>(threads));
    try {
        for (int thread = 1; thread < threads; ++thread) others.emplace_back(std::cref(work), thread);
    } catch (const std::system_error&) { // those that did start do the work of all
    }
    work(0);
    for (std::thread& other : others) other.join();
}

#endif

/// As ResolveThreads, but not more threads than pay for a few passes over so many faces: on a busy machine a
/// second one starts and ends no sooner than tens of milliseconds.
inline int UsefulThreadCount(int requested, std::size_t faces)
{
    constexpr std::size_t kFacesPerThread = 250000;
    return static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(ResolveThreads(requested)),
                                                  1 + faces / kFacesPerThread));
}

/// Calls body(item, thread) once for every item in [0, items), on \p threads threads, the next free thread
/// taking the next item. Returns when all are done; the first exception of a body is thrown on, and no more
/// items are begun then. Asks LoopPoll between items. \pre bodies of different items share no data that one
/// of them writes, so the outcome cannot depend on
///      the number of threads
template <class Body>
void ParallelFor(int threads, std::size_t items, const Body& body)
{
    if (threads <= 1 || items <= 1) {
        for (std::size_t item = 0; item < items; ++item) {
            body(item, 0);
            LoopPoll::PartDone(item + 1, items);
        }
        LoopPoll::LoopDone(items);
        return;
    }
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failureMutex;
    RunOnThreads(threads, [&](int thread) {
        // Relaxed: a number is claimed, no data is handed over. Anything stronger would hide from a race
        // detector that two bodies share data.
        for (std::size_t item; (item = next.fetch_add(1, std::memory_order_relaxed)) < items;) {
            try {
                body(item, thread);
                if (thread == 0) LoopPoll::PartDone(item + 1, items); // on the thread that called
            } catch (...) {
                next.store(items, std::memory_order_relaxed);
                const std::lock_guard<std::mutex> lock(failureMutex);
                if (!failure) failure = std::current_exception();
            }
        }
    });
    if (failure) std::rethrow_exception(failure);
    LoopPoll::LoopDone(items);
}

/// Calls body(begin, end, thread) for consecutive ranges that cover [0, items), about \p grain long each.
/// The ranges depend on \p items and \p grain only. \pre as for ParallelFor, of different ranges; grain > 0
template <class Body>
void ParallelRanges(int threads, std::size_t items, std::size_t grain, const Body& body)
{
    ParallelFor(threads, (items + grain - 1) / grain, [&](std::size_t range, int thread) {
        body(range * grain, std::min(items, (range + 1) * grain), thread);
    });
}

/// The vertices begin .. end - 1, which one thread works on.
struct VertexRange {
    std::uint32_t begin, end;

    bool Has(std::uint32_t v) const { return v - begin < end - begin; }
};

/// Adds \p amount to \p counter, which other threads add to at the same time, and returns what it held
/// before. What is claimed this way arrives in no fixed order: sort it before a result can depend on it.
inline std::uint32_t FetchAdd(std::uint32_t& counter, std::uint32_t amount)
{
    return __atomic_fetch_add(&counter, amount, __ATOMIC_RELAXED); // std::atomic_ref comes with C++20
}

/// Reads or writes a number that another thread may write or read at the same time: old or new, never torn.
inline std::uint32_t LoadRelaxed(const std::uint32_t& value)
{
    return __atomic_load_n(&value, __ATOMIC_RELAXED);
}
inline void StoreRelaxed(std::uint32_t& value, std::uint32_t to)
{
    __atomic_store_n(&value, to, __ATOMIC_RELAXED);
}

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
    const auto forEachOf = [&](std::size_t part, int thread, const auto& visit) {
        constexpr std::size_t kBetweenQuestions = std::size_t{1} << 16;
        for (std::size_t i = partBegin(part); i < partBegin(part + 1);) {
            const std::size_t end = std::min(partBegin(part + 1), i + kBetweenQuestions);
            for (; i < end; ++i) visit(i);
            if (thread == 0) LoopPoll::Ask(); // parts are long
        }
    };
    std::vector<std::uint32_t> place(parts * buckets, 0);
    ParallelFor(threads, parts, [&](std::size_t part, int thread) {
        std::uint32_t* count = place.data() + part * buckets;
        forEachOf(part, thread, [&](std::size_t i) { ++count[bucketOf(i)]; });
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
    ParallelFor(threads, parts, [&](std::size_t part, int thread) {
        std::uint32_t* next = place.data() + part * buckets;
        forEachOf(part, thread, [&](std::size_t i) { move(i, next[bucketOf(i)]++); });
    });
    return first;
}

} // namespace vcg_ext
