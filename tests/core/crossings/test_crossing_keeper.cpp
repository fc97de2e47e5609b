// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"

using namespace test_meshes;
using vcg_ext::CrossingKeeper;
using vcg_ext::CrossingPair;

namespace
{

/// Two sheets that do not cross, and far from them two spheres that do.
IndexedMesh SheetsAndSpheres()
{
    const IndexedMesh sheets = Merged(Grid(8, 8), Moved(Grid(8, 8), 0, 1, {0, 0, 0.3}));
    const IndexedMesh spheres = Merged(Icosphere(2), Moved(Icosphere(2), 0.3, 1, {0.4, 0.1, 0}));
    return Merged(sheets, Moved(spheres, 0, 1, {50, 0, 0}));
}
constexpr std::uint32_t kSheetFaces = 2 * 128;

} // namespace

class TestCrossingKeeper : public QObject
{
    Q_OBJECT

  private slots:
    void knowsWhereTheOriginalCrosses()
    {
        const IndexedMesh mesh = SheetsAndSpheres();
        const vcg_ext::MeshView view = View(mesh);
        const vcg_ext::FaceTree tree(view, vcg_ext::FrameOf(view), 1);
        vcg_ext::DecimatedMesh result;
        result.positions = mesh.points;
        result.positions[4 + 4 * 9][2] += 0.45; // through the other sheet
        result.triangles = mesh.triangles;
        CrossingKeeper keeper(view, 1);
        std::vector<CrossingPair> ofSheets, ofSpheres;
        for (const CrossingPair& pair : keeper.Find(result))
            (pair.second < kSheetFaces ? ofSheets : ofSpheres).push_back(pair);
        QVERIFY(!ofSheets.empty() && !ofSpheres.empty());
        QVERIFY(!keeper.OriginalCrossesNear(ofSheets, result, tree));
        QVERIFY(keeper.OriginalCrossesNear(ofSpheres, result, tree));
        QVERIFY(!keeper.Before()); // that is no count
        QVERIFY(!keeper.Allows(ofSheets.size() + ofSpheres.size(), tree));
        QCOMPARE(*keeper.Before(), ofSpheres.size());
    }
};

QTEST_APPLESS_MAIN(TestCrossingKeeper)
#include "test_crossing_keeper.moc"
