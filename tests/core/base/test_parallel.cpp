// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <thread>
#include <vector>

#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"

using namespace vcg_ext;

class TestParallel : public QObject
{
    Q_OBJECT

  private slots:
    void everyItemIsDoneOnce()
    {
        for (const int threads : {1, 2, 7})
            for (const std::size_t items : {0, 1, 2, 1000}) {
                std::vector<int> done(items);
                ParallelFor(threads, items, [&](std::size_t item, int) { ++done[item]; });
                QCOMPARE(done, std::vector<int>(items, 1));
            }
    }

    /// Each thread may have a workspace of its own.
    void threadsAreNumberedFromZero()
    {
        std::atomic<bool> inRange{true};
        ParallelFor(3, 1000, [&](std::size_t, int thread) {
            if (thread < 0 || thread >= 3) inRange = false;
        });
        QVERIFY(inRange);
    }

    /// Where one thread did the work of both, the first item would wait for ever, and the test's time limit
    /// would end it. No limit of its own: on a busy machine the second thread may begin seconds later.
    void itemsAreDoneAtTheSameTime()
    {
        std::atomic<int> arrived{0};
        ParallelFor(2, 2, [&](std::size_t, int) {
            ++arrived;
            while (arrived < 2) std::this_thread::yield();
        });
        QCOMPARE(arrived.load(), 2);
    }

    void rangesCoverAllItemsInOrder()
    {
        for (const int threads : {1, 3}) {
            std::vector<std::pair<std::size_t, std::size_t>> ranges(4);
            ParallelRanges(threads, 31, 10, [&](std::size_t begin, std::size_t end, int) {
                ranges[begin / 10] = {begin, end};
            });
            const std::vector<std::pair<std::size_t, std::size_t>> expected{
                {0, 10}, {10, 20}, {20, 30}, {30, 31}};
            QVERIFY(ranges == expected);
        }
    }

    /// One that fails begins no other item.
    void noItemIsBegunAfterAnException()
    {
        for (const int threads : {2, 7}) {
            std::atomic<int> begun{0};
            QVERIFY_EXCEPTION_THROWN(ParallelFor(threads, 100,
                                                 [&](std::size_t, int) {
                                                     ++begun;
                                                     throw std::runtime_error("each");
                                                 }),
                                     std::runtime_error);
            QVERIFY(begun <= threads);
        }
    }

    void anExceptionArrivesAfterWhatWasBegunIsDone()
    {
        for (const int threads : {2, 7}) {
            std::vector<int> begun(100), done(100);
            std::string message;
            try {
                ParallelFor(threads, done.size(), [&](std::size_t item, int) {
                    begun[item] = 1;
                    if (item == 50) throw std::runtime_error("item 50");
                    done[item] = 1;
                });
            } catch (const std::runtime_error& error) {
                message = error.what();
            }
            QCOMPARE(message, std::string("item 50"));
            QCOMPARE(done[50], 0);
            done[50] = 1;
            QCOMPARE(done, begun); // how many those are depends on when the others began
        }
    }

    void everyThreadClaimsPlacesOfItsOwn()
    {
        std::uint32_t counter = 5;
        std::vector<int> claimed(2005);
        ParallelFor(4, 1000, [&](std::size_t, int) {
            const std::uint32_t first = FetchAdd(counter, 2);
            ++claimed[first];
            ++claimed[first + 1];
        });
        QCOMPARE(counter, 2005u);
        QCOMPARE(std::accumulate(claimed.begin() + 5, claimed.end(), 0), 2000);
        QVERIFY(std::all_of(claimed.begin() + 5, claimed.end(), [](int times) { return times == 1; }));
    }

#ifdef _OPENMP
    /// So the environment's OMP_NUM_THREADS counts, too.
    void zeroThreadsAreAsManyAsOpenMpUses()
    {
        const int before = omp_get_max_threads();
        omp_set_num_threads(3);
        QCOMPARE(ResolveThreads(0), 3);
        QCOMPARE(ResolveThreads(2), 2);
        omp_set_num_threads(before);
    }
#endif

    /// Above 4096 items several threads share the work.
    void aScatterIsStable()
    {
        constexpr std::size_t kBuckets = 7;
        for (const std::size_t items : {0, 10, 10000})
            for (const int threads : {1, 2, 5}) {
                const auto bucketOf = [](std::size_t i) { return i * i % kBuckets; };
                std::vector<std::size_t> expected(items), scattered(items);
                for (std::size_t i = 0; i < items; ++i) expected[i] = i;
                std::stable_sort(expected.begin(), expected.end(),
                                 [&](std::size_t a, std::size_t b) { return bucketOf(a) < bucketOf(b); });
                const std::vector<std::uint32_t> first =
                    StableScatter(threads, items, kBuckets, bucketOf,
                                  [&](std::size_t i, std::uint32_t place) { scattered[place] = i; });
                QVERIFY(scattered == expected);
                QCOMPARE(first.size(), kBuckets + 1);
                QCOMPARE(first.back(), static_cast<std::uint32_t>(items));
                for (std::size_t bucket = 0; bucket < kBuckets; ++bucket)
                    for (std::uint32_t i = first[bucket]; i < first[bucket + 1]; ++i)
                        QCOMPARE(bucketOf(scattered[i]), bucket);
            }
    }

    void aRangeHasItsVerticesOnly()
    {
        const VertexRange range{3, 5};
        QVERIFY(!range.Has(2) && range.Has(3) && range.Has(4) && !range.Has(5));
        QVERIFY(!(VertexRange{4, 4}.Has(4)));
    }

    /// A quarter of a million faces for each, but at least one and at most those asked for.
    void moreThreadsThanPayAreNotUsed()
    {
        QCOMPARE(UsefulThreadCount(8, 0), 1);
        QCOMPARE(UsefulThreadCount(8, 249999), 1);
        QCOMPARE(UsefulThreadCount(8, 250000), 2);
        QCOMPARE(UsefulThreadCount(2, 100000000), 2);
    }

    /// Two loops lead from 0 to 50, the next one no farther than 60: each part brings its share.
    void loopsLeadOn()
    {
        for (const int threads : {1, 3}) {
            std::vector<int> told;
            RunProgress run([&](int percent, const char*) {
                told.push_back(percent);
                return true;
            });
            const LoopPoll poll([&](int percent) { run.GoOn(percent); });
            const StageProgress progress(std::ref(run));
            const auto loop = [&](std::size_t parts) {
                ParallelRanges(threads, parts, 1, [](std::size_t, std::size_t, int) {});
            };
            progress(0, "first", 50, 2);
            loop(100);
            QVERIFY(told.back() <= 25);
            loop(3); // too short to count
            loop(100);
            progress(50, "second", 60);
            loop(1000);
            loop(1000);
            QVERIFY(std::is_sorted(told.begin(), told.end()));
            QVERIFY(told.back() < 60);
            progress(40, "third"); // it does not go back
            QCOMPARE(told.back(), std::max(50, told[told.size() - 2]));
            if (threads > 1) continue; // whether the first thread gets a part is a matter of chance
            for (std::size_t i = 1; i < told.size(); ++i) QVERIFY(told[i] - told[i - 1] <= 5);
            QVERIFY(told.size() > 500);
        }
    }

    /// One part of a scatter may be all of it.
    void aScatterAsks()
    {
        int questions = 0;
        const LoopPoll poll([&](int) {
            if (++questions == 3) throw Cancelled();
        });
        std::vector<std::uint32_t> places(1 << 20);
        const auto scatter = [&] {
            StableScatter(
                1, places.size(), 2, [](std::size_t i) { return i & 1; },
                [&](std::size_t i, std::uint32_t place) { places[i] = place; });
        };
        QVERIFY_EXCEPTION_THROWN(scatter(), Cancelled);
        QCOMPARE(questions, 3);
    }
};

QTEST_APPLESS_MAIN(TestParallel)
#include "test_parallel.moc"
