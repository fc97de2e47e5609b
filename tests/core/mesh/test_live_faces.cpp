// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/mesh/live_faces.h"

class TestLiveFaces : public QObject
{
    Q_OBJECT

  private slots:
    /// A hundred boxes in a row, more than one level of leaves; then the first moves behind the last.
    void whatHasMovedIsFoundWhereItIs()
    {
        const auto at = [](float x) { return vcg_ext::Box3<float>{{x, 0, 0}, {x + 0.5F, 1, 1}}; };
        std::vector<std::uint32_t> faces;
        for (std::uint32_t f = 0; f < 100; ++f) faces.push_back(f);
        vcg_ext::LiveFaces live;
        live.Build(faces, 100, [&](std::uint32_t f) { return at(static_cast<float>(f)); });
        const auto finds = [&](std::uint32_t face, float x) {
            std::vector<std::uint32_t> found;
            live.ForEachNear(at(x), [&](std::uint32_t f) { found.push_back(f); });
            return std::count(found.begin(), found.end(), face) == 1;
        };
        for (std::uint32_t f = 0; f < 100; ++f) QVERIFY(finds(f, static_cast<float>(f)));
        QVERIFY(!finds(0, 200));
        live.Grow(0, at(200));
        QVERIFY(finds(0, 200));
        QVERIFY(finds(0, 0)); // boxes only grow
        QVERIFY(!finds(99, 200));
    }
};

QTEST_APPLESS_MAIN(TestLiveFaces)
#include "test_live_faces.moc"
