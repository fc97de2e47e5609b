// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/parallel.h"

using namespace vcg_ext;

class TestParallel : public QObject
{
    Q_OBJECT

  private slots:
    void everyItemIsDoneOnce()
    {
        for (const int threads : {1, 2, 5})
            for (const std::size_t items : {0, 1, 7, 1000}) {
                std::vector<int> done(items, 0);
                ParallelFor(threads, items, [&](std::size_t item, int thread) {
                    ++done[item];
                    if (thread < 0 || thread >= threads) throw std::out_of_range("thread");
                });
                QVERIFY(std::all_of(done.begin(), done.end(), [](int n) { return n == 1; }));
            }
    }

    void rangesCoverTheItemsWhateverTheThreads()
    {
        for (const int threads : {1, 3}) {
            std::vector<std::pair<std::size_t, std::size_t>> ranges(3);
            ParallelRanges(threads, 25, 10, [&](std::size_t begin, std::size_t end, int) {
                ranges[begin / 10] = {begin, end};
            });
            const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 10}, {10, 20}, {20, 25}};
            QVERIFY(ranges == expected);
        }
    }

    void anExceptionOfABodyArrives()
    {
        for (const int threads : {1, 4})
            QVERIFY_EXCEPTION_THROWN(ParallelFor(threads, 100,
                                                 [](std::size_t item, int) {
                                                     if (item == 50) throw std::runtime_error("fifty");
                                                 }),
                                     std::runtime_error);
    }

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
};

QTEST_APPLESS_MAIN(TestParallel)
#include "test_parallel.moc"
