// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/mesh/find_crossings.h"
#include "vcg_ext/core/repair/repair_crossings.h"

using namespace test_meshes;
using vcg_ext::CrossingPair;
using vcg_ext::DecimatedMesh;

namespace
{

constexpr double kGap = 0.3;
constexpr std::uint32_t kPushed = 4 + 4 * 9; ///< the middle of the lower sheet of 8 x 8

/// Two sheets, one above the other.
IndexedMesh Sheets(int n = 8)
{
    return Merged(Grid(n, n), Moved(Grid(n, n), 0, 1, {0, 0, kGap}));
}

/// What a decimation is taken to have made of them: one vertex is pushed through the other sheet.
DecimatedMesh Crossing(int n = 8)
{
    const IndexedMesh sheets = Sheets(n);
    DecimatedMesh result;
    result.positions = sheets.points;
    const auto middle = static_cast<std::size_t>(n) / 2 * (static_cast<std::size_t>(n) + 2);
    result.positions[middle][2] += 1.5 * kGap;
    result.triangles = sheets.triangles;
    for (std::uint32_t v = 0; v < sheets.points.size(); ++v) result.vertexOrigin.push_back(v);
    for (std::uint32_t f = 0; f < sheets.triangles.size(); ++f) result.faceOrigin.push_back(f);
    return result;
}

std::vector<CrossingPair> CrossingsOf(const DecimatedMesh& mesh)
{
    IndexedMesh indexed;
    indexed.points = mesh.positions;
    indexed.triangles = mesh.triangles;
    const vcg_ext::MeshView view = View(indexed);
    return FindCrossings(view, vcg_ext::FaceTree(view, vcg_ext::FrameOf(view), 1), 1);
}

void Repair(const vcg_ext::MeshView& original, DecimatedMesh& mesh, std::size_t allowed, int threads = 1)
{
    const vcg_ext::FaceTree tree(original, vcg_ext::FrameOf(original), threads);
    RepairCrossings(original, tree, mesh, CrossingsOf(mesh), allowed, vcg_ext::Boundary::Lock, threads);
}

} // namespace

class TestRepairCrossings : public QObject
{
    Q_OBJECT

  private slots:
    void vertexPushedThroughASheetIsBroughtBack()
    {
        const IndexedMesh sheets = Sheets();
        DecimatedMesh mesh = Crossing();
        QVERIFY(CrossingsOf(mesh).size() > 5);
        Repair(View(sheets), mesh, 0);
        QCOMPARE(CrossingsOf(mesh).size(), std::size_t{0});
        QCOMPARE(mesh.triangles.size(), sheets.triangles.size());
        const auto edges =
            vcg_ext::CountEdges(mesh.triangles.size(), [&](std::size_t f) { return mesh.triangles[f]; });
        QCOMPARE(edges.nonManifold, std::size_t{0});
        QCOMPARE(edges.boundary, std::size_t{64});
        const std::vector<float> descriptor(sheets.points.size(), 0);
        const auto distances = vcg_ext::MeasureDistances(View(sheets), mesh, descriptor, 20000, 1);
        QCOMPARE(distances.folded, std::size_t{0});
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) // what had no part in it stays
            if (std::hypot(sheets.points[v][0] - 4, sheets.points[v][1] - 4) > 2.5)
                QVERIFY(mesh.positions[v] == sheets.points[v]);
    }

    /// The other sheet may give way, too, but not more than what is pushed through it asks for.
    void fixedVertexStays()
    {
        const IndexedMesh sheets = Sheets();
        std::vector<std::uint8_t> fixed(sheets.points.size(), 0);
        fixed[kPushed] = 1;
        vcg_ext::MeshView view = View(sheets);
        view.fixedVertices = fixed.data();
        DecimatedMesh mesh = Crossing();
        const auto pushed = mesh.positions[kPushed];
        Repair(view, mesh, 0);
        QVERIFY(mesh.positions[kPushed] == pushed);
        QVERIFY(CrossingsOf(mesh).size() < CrossingsOf(Crossing()).size());
    }

    void nothingMovesWhereAllIsFixed()
    {
        const IndexedMesh sheets = Sheets();
        const std::vector<std::uint8_t> fixed(sheets.points.size(), 1);
        vcg_ext::MeshView view = View(sheets);
        view.fixedVertices = fixed.data();
        DecimatedMesh mesh = Crossing();
        Repair(view, mesh, 0);
        QVERIFY(mesh.positions == Crossing().positions && mesh.triangles == Crossing().triangles);
    }

    /// What crosses in the original may cross in the result.
    void soManyAsMayStay()
    {
        const IndexedMesh sheets = Sheets();
        DecimatedMesh mesh = Crossing();
        Repair(View(sheets), mesh, CrossingsOf(mesh).size());
        QVERIFY(mesh.positions == Crossing().positions && mesh.triangles == Crossing().triangles);
    }

    /// A sheet that lies in the other crosses it everywhere.
    void manyAreLeftAlone()
    {
        const IndexedMesh sheets = Sheets();
        DecimatedMesh mesh = Crossing();
        for (std::size_t v = 0; v < 81; v += 2) mesh.positions[v][2] = 1.5 * kGap;
        const auto before = mesh.positions;
        QVERIFY(CrossingsOf(mesh).size() > 100);
        Repair(View(sheets), mesh, 0);
        QVERIFY(mesh.positions == before);
    }

    /// The caller's coordinates are floats, and no two of them cross.
    void floatsAreRoundedBeforeTheyAreCounted()
    {
        const IndexedMesh sheets = Sheets();
        std::vector<std::array<float, 3>> points;
        for (const Point& p : sheets.points)
            points.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
        vcg_ext::MeshView view = View(sheets);
        view.positions = points.data();
        view.positionStride = sizeof points[0];
        view.doublePositions = false;
        DecimatedMesh mesh = Crossing();
        RoundAsInput(view, mesh);
        Repair(view, mesh, 0);
        RoundAsInput(view, mesh);
        QCOMPARE(CrossingsOf(mesh).size(), std::size_t{0});
    }

    void bytesDoNotDependOnThreads()
    {
        constexpr int kMany = 80; // vertices and faces for several threads in every loop
        const IndexedMesh sheets = Sheets(kMany);
        DecimatedMesh one = Crossing(kMany), three = Crossing(kMany);
        Repair(View(sheets), one, 0, 1);
        Repair(View(sheets), three, 0, 3);
        QCOMPARE(CrossingsOf(one).size(), std::size_t{0});
        QVERIFY(one.positions == three.positions && one.triangles == three.triangles);
    }
};

QTEST_APPLESS_MAIN(TestRepairCrossings)
#include "test_repair_crossings.moc"
