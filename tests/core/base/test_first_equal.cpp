// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "vcg_ext/core/base/first_equal.h"

using namespace vcg_ext;

class TestFirstEqual : public QObject
{
    Q_OBJECT

  private slots:
    void findsTheLowestForAnyNumberOfThreads_data()
    {
        QTest::addColumn<int>("values");
        QTest::addColumn<bool>("sameHash"); // then only equal() tells items apart
        QTest::newRow("all equal") << 1 << false;
        QTest::newRow("many equal") << 300 << false;
        QTest::newRow("few equal") << 1000000 << false;
        QTest::newRow("one hash") << 30 << true;
    }
    void findsTheLowestForAnyNumberOfThreads()
    {
        QFETCH(int, values);
        QFETCH(bool, sameHash);
        std::vector<int> items(50000);
        std::mt19937 random(1);
        for (int& item : items) item = static_cast<int>(random() % static_cast<unsigned>(values));
        std::map<int, std::uint32_t> first;
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < items.size(); ++i)
            expected.push_back(first.emplace(items[i], i).first->second);
        for (const int threads : {1, 2, 3, 7})
            QCOMPARE(
                FirstEqual(
                    threads, items.size(),
                    [&](std::size_t i) { return sameHash ? 5 : Mixed(static_cast<std::uint64_t>(items[i])); },
                    [&](std::size_t a, std::size_t b) { return items[a] == items[b]; }),
                expected);
    }

    void saysNothingWhereAllDiffer()
    {
        for (const std::size_t items : {0, 1, 20000})
            QVERIFY(FirstEqual(
                        2, items, [](std::size_t i) { return Mixed(i); },
                        [](std::size_t a, std::size_t b) { return a == b; })
                        .empty());
    }
};

QTEST_APPLESS_MAIN(TestFirstEqual)

#include "test_first_equal.moc"
