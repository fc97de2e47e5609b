// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/measure/group_search.h"

using namespace vcg_ext;

namespace
{

/// Two opposite sides of a box: its center is as far from both as any point between them can be.
test_meshes::IndexedMesh TwoSides()
{
    const test_meshes::IndexedMesh side = test_meshes::Grid(6, 6, 0.25);
    return test_meshes::Merged(side, test_meshes::Moved(side, 0, 1, {0, 0, 1}));
}

} // namespace

class TestGroupSearch : public QObject
{
    Q_OBJECT

  private slots:
    /// Also of the first points, before any face is known, and around the origin of the frame.
    void findsWhatIsFarther()
    {
        const test_meshes::IndexedMesh mesh = TwoSides();
        const MeshView view = test_meshes::View(mesh);
        const FaceTree tree(view, FrameOf(view), 1);
        const ExactSurface surface(view, tree, RoundingOf(view, view, tree.frame()));
        const auto pointAt = [](std::size_t i) {
            const double t = static_cast<double>(i);
            return Vector3<double>{150 * std::sin(t), 150 * std::sin(1.7 * t), 200 * std::sin(2.3 * t)};
        };
        ExactSurface::Search single;
        for (const std::size_t count : {1U, 3U, 8U})
            for (std::size_t first = 0; first < 200; first += count)
                for (const double known : {20.0, 100.0, 180.0}) {
                    GroupSearch search(surface);
                    search.Take(count, [&](std::size_t i) { return pointAt(first + i); });
                    double expected2 = known * known;
                    for (std::size_t i = 0; i < count; ++i)
                        expected2 = std::max(expected2, surface.Distance2(pointAt(first + i), single));
                    QCOMPARE(search.LargerDistance2(known * known), expected2);
                }
    }
};

QTEST_APPLESS_MAIN(TestGroupSearch)
#include "test_group_search.moc"
