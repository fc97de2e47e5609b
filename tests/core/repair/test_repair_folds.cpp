// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/repair/repair_folds.h"
#include "vcg_ext/core/simplify.h"

using namespace test_meshes;
using vcg_ext::DecimatedMesh;

namespace
{

/// An original and what a decimation is taken to have made of it, face by face in the same order.
DecimatedMesh AsDecimated(const IndexedMesh& mesh)
{
    DecimatedMesh result;
    result.positions = mesh.points;
    result.triangles = mesh.triangles;
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) result.vertexOrigin.push_back(v);
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) result.faceOrigin.push_back(f);
    return result;
}

/// A plane with one inner vertex pushed over the far side of a face around it.
IndexedMesh PlaneWithFold()
{
    IndexedMesh mesh = Grid(8, 8);
    for (auto& p : mesh.points)
        if (std::abs(p[0] - 4) < 0.1 && std::abs(p[1] - 4) < 0.1) p = {5.3, 4.2, 0};
    return mesh;
}

vcg_ext::FoldRepairReport Repair(const vcg_ext::MeshView& original, DecimatedMesh& mesh,
                                 vcg_ext::Boundary boundary, int threads, vcg_ext::Progress progress = {})
{
    const auto tree = vcg_ext::TreeOf(original, mesh, {}, threads);
    if (!tree) return {};
    return vcg_ext::RepairFolds(original, *tree, mesh, boundary, threads,
                                vcg_ext::StageProgress(std::move(progress)));
}

/// What the collapse and, unless the effort is fast, the refinement leave.
DecimatedMesh Collapsed(const vcg_ext::MeshView& view, const vcg_ext::DecimationParameters& parameters)
{
    vcg_ext::PipelineStages stages;
    stages.refine = parameters.effort != vcg_ext::Effort::Fast;
    stages.repairFolds = false;
    return vcg_ext::RunPipeline(view, parameters, stages, vcg_ext::SweepCollapse{parameters}).mesh;
}

std::size_t Folded(const IndexedMesh& original, DecimatedMesh mesh)
{
    return Repair(View(original), mesh, vcg_ext::Boundary::Lock, 1).before;
}

/// By the measurement of the report, in double precision. \pre the original has faces
vcg_ext::DistanceReport Distances(const IndexedMesh& original, const DecimatedMesh& mesh)
{
    const std::vector<float> descriptor(original.points.size(), 0);
    return vcg_ext::MeasureDistances(View(original), mesh, descriptor, 20000, 1);
}
std::size_t MeasuredFolds(const IndexedMesh& original, const DecimatedMesh& mesh)
{
    return Distances(original, mesh).folded;
}
double Rms(const IndexedMesh& original, const DecimatedMesh& mesh)
{
    return Distances(original, mesh).rms;
}

} // namespace

class TestRepairFolds : public QObject
{
    Q_OBJECT

  private slots:
    void vertexPushedAcrossAnEdgeIsBroughtBack()
    {
        const IndexedMesh plane = Grid(8, 8);
        DecimatedMesh mesh = AsDecimated(PlaneWithFold());
        const auto report = Repair(View(plane), mesh, vcg_ext::Boundary::Lock, 1);
        QVERIFY(report.before > 0);
        QCOMPARE(report.after, std::size_t{0});
        QCOMPARE(MeasuredFolds(plane, mesh), std::size_t{0});
        QCOMPARE(mesh.triangles.size(), plane.triangles.size());
        const auto edges =
            vcg_ext::CountEdges(mesh.triangles.size(), [&](std::size_t f) { return mesh.triangles[f]; });
        QCOMPARE(edges.nonManifold, std::size_t{0});
        QCOMPARE(edges.boundary, std::size_t{32});
        for (std::size_t v = 0; v < plane.points.size(); ++v) { // the border is where it was
            const bool border = plane.points[v][0] < 0.1 || plane.points[v][0] > 7.9 ||
                                plane.points[v][1] < 0.1 || plane.points[v][1] > 7.9;
            if (border) QVERIFY(mesh.positions[v] == plane.points[v]);
        }
    }

    /// The smallest fold: a corner just over the far edge of one face, all others sound.
    void singleFoldIsRepaired()
    {
        const IndexedMesh plane = Grid(8, 8);
        IndexedMesh folded = plane;
        folded.points[4 + 4 * 9] = {5.1, 4.5, 0};
        DecimatedMesh mesh = AsDecimated(folded);
        const auto report = Repair(View(plane), mesh, vcg_ext::Boundary::Lock, 1);
        QCOMPARE(report.before, std::size_t{1});
        QCOMPARE(report.after, std::size_t{0});
        QCOMPARE(MeasuredFolds(plane, mesh), std::size_t{0});
    }

    /// Of a mesh whose left half is fixed, the fold on the seam is repaired by what is free.
    void onlyTheFreeHalfChanges()
    {
        const IndexedMesh plane = Grid(8, 8);
        const DecimatedMesh folded = AsDecimated(PlaneWithFold());
        std::vector<std::uint8_t> fixed;
        for (const Point& p : plane.points) fixed.push_back(p[0] < 3.5);
        auto view = View(plane);
        view.fixedVertices = fixed.data();
        DecimatedMesh mesh = folded;
        const auto report = Repair(view, mesh, vcg_ext::Boundary::Lock, 1);
        QVERIFY(report.before > 0);
        QCOMPARE(report.after, std::size_t{0});
        for (std::size_t v = 0; v < fixed.size(); ++v)
            if (fixed[v]) QVERIFY(mesh.positions[v] == folded.positions[v]);
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            const auto& t = folded.triangles[f];
            if (fixed[t[0]] && fixed[t[1]] && fixed[t[2]]) QVERIFY(mesh.triangles[f] == t);
        }
    }

    void fixedVerticesAndTheirEdgesStay()
    {
        const IndexedMesh plane = Grid(8, 8);
        const DecimatedMesh folded = AsDecimated(PlaneWithFold());
        const std::vector<std::uint8_t> fixed(plane.points.size(), 1);
        auto view = View(plane);
        view.fixedVertices = fixed.data();
        DecimatedMesh mesh = folded;
        const auto report = Repair(view, mesh, vcg_ext::Boundary::Free, 1);
        QVERIFY(report.before > 0);
        QCOMPARE(report.after, report.before);
        QVERIFY(mesh.positions == folded.positions);
        QVERIFY(mesh.triangles == folded.triangles);
    }

    /// In the facets of a polyhedron the distance from itself is rounding. A change may add to it, so that
    /// folds there are repaired by the first and strictest pass, while the progress stands at 0.
    void roundingIsNoReasonToLeaveAFold()
    {
        std::size_t repaired = 0;
        for (const unsigned seed : {1u, 3u, 5u}) {
            IndexedMesh facets = Noisy(Icosphere(2), 0.05, seed);
            for (int level = 0; level < 4; ++level) facets = SubdividedAtMidpoints(facets);
            vcg_ext::DecimationParameters parameters;
            parameters.targetFaces = facets.triangles.size() / 10;
            parameters.threads = 2;
            DecimatedMesh mesh = Collapsed(View(facets), parameters);
            int furthest = 0;
            const auto report =
                Repair(View(facets), mesh, vcg_ext::Boundary::Lock, 2, [&](int percent, const char*) {
                    furthest = std::max(furthest, percent);
                    return true;
                });
            QCOMPARE(report.after, std::size_t{0});
            QCOMPARE(furthest, 0);
            repaired += report.before;
        }
        QVERIFY(repaired > 0);
    }

    /// Two sheets that coincide and face apart: whichever the other one is found first, nothing is folded.
    void bothSidesOfASheetAreSound()
    {
        IndexedMesh back = Grid(12, 12);
        const IndexedMesh front = back;
        for (auto& t : back.triangles) std::swap(t[1], t[2]);
        const IndexedMesh sheet = Merged(front, back);
        QCOMPARE(Folded(sheet, AsDecimated(sheet)), std::size_t{0});
        IndexedMesh lifted = sheet;
        for (auto& p : lifted.points) p[2] += 0.3;
        QCOMPARE(Folded(sheet, AsDecimated(lifted)), std::size_t{0});
    }

    /// Where the original's own faces face this way and that, nothing is repaired.
    void mixedOrientationIsLeftAlone()
    {
        const IndexedMesh plane = Noisy(Grid(20, 20), 0.05);
        IndexedMesh mixed = plane;
        for (std::size_t f = 0; f < mixed.triangles.size(); f += 2)
            std::swap(mixed.triangles[f][1], mixed.triangles[f][2]);
        IndexedMesh above = plane;
        for (auto& p : above.points) p[2] += 0.2;
        DecimatedMesh mesh = AsDecimated(above);
        const auto report = Repair(View(mixed), mesh, vcg_ext::Boundary::Free, 1);
        QVERIFY(report.before > 100);
        QVERIFY(mesh.positions == above.points);
    }

    /// A corner pushed over its face's far edge: there is nothing to flip and no inner vertex.
    void borderMovesWhereItIsNotLocked()
    {
        IndexedMesh triangle;
        triangle.points = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
        triangle.AddTriangle(0, 1, 2);
        IndexedMesh turned = triangle;
        turned.points[0] = {2.4, 1.8, 0};
        for (const auto boundary : {vcg_ext::Boundary::Lock, vcg_ext::Boundary::Preserve}) {
            DecimatedMesh mesh = AsDecimated(turned);
            const auto report = Repair(View(triangle), mesh, boundary, 1);
            QCOMPARE(report.before, std::size_t{1});
            QCOMPARE(report.after, std::size_t{boundary == vcg_ext::Boundary::Lock ? 1U : 0U});
        }
    }

    void meshWithoutFoldsKeepsItsBytes()
    {
        const IndexedMesh sphere = Noisy(Icosphere(3), 0.002);
        const DecimatedMesh before = AsDecimated(sphere);
        DecimatedMesh mesh = before;
        const auto report = Repair(View(sphere), mesh, vcg_ext::Boundary::Free, 1);
        QCOMPARE(report.before, std::size_t{0});
        QVERIFY(mesh.positions == before.positions && mesh.triangles == before.triangles);
    }

    /// The faces of a coarse sphere dip by more than half the wall's thickness: they are closer to the
    /// inside.
    void wallThinnerThanTheErrorIsRepaired()
    {
        const IndexedMesh shell = Shell(4, 0.02);
        vcg_ext::DecimationParameters parameters;
        parameters.targetFaces = 300;
        parameters.effort = vcg_ext::Effort::Fast;
        parameters.threads = 1;
        parameters.avoidSelfIntersections = false; // its walls cannot cross: that costs more than the repair
        parameters.measureError = false;
        const DecimatedMesh collapsed = Collapsed(View(shell), parameters);
        const std::size_t before = MeasuredFolds(shell, collapsed);
        QVERIFY(before > 20);
        for (const auto effort : {vcg_ext::Effort::Fast, vcg_ext::Effort::Balanced}) {
            parameters.effort = effort;
            const DecimatedMesh mesh = vcg_ext::Simplify(View(shell), parameters).mesh;
            QVERIFY(10 * MeasuredFolds(shell, mesh) <= before);
            QCOMPARE(mesh.triangles.size(), collapsed.triangles.size());
            // a quarter of the faces is repaired, most of them for less than a tenth of the local error
            const double rise = Rms(shell, mesh) / Rms(shell, collapsed);
            QVERIFY2(rise < 1.15, qPrintable(QString::number(rise)));
        }
    }

    void bytesDoNotDependOnThreads()
    {
        const IndexedMesh shell = Shell(4, 0.02);
        vcg_ext::DecimationParameters parameters;
        parameters.targetFaces = 300;
        parameters.effort = vcg_ext::Effort::Fast;
        parameters.avoidSelfIntersections = false; // test_crossings has the threads of that
        parameters.measureError = false;           // test_distances those of that
        std::optional<DecimatedMesh> first;
        parameters.threads = 1;
        const DecimatedMesh folded = Collapsed(View(shell), parameters);
        for (const int threads : {1, 2, 3, 7}) {
            parameters.threads = threads;
            const DecimatedMesh mesh = vcg_ext::Simplify(View(shell), parameters).mesh;
            if (!first) first = mesh;
            QVERIFY(mesh.positions != folded.positions);
            QVERIFY(mesh.positions == first->positions);
            QVERIFY(mesh.triangles == first->triangles);
        }
    }

    void stopsWhereItIsAskedTo()
    {
        const IndexedMesh plane = Grid(8, 8);
        const DecimatedMesh before = AsDecimated(PlaneWithFold());
        DecimatedMesh mesh = before;
        int calls = 0;
        QVERIFY_EXCEPTION_THROWN(Repair(View(plane), mesh, vcg_ext::Boundary::Free, 1,
                                        [&](int, const char*) { return ++calls < 2; }),
                                 vcg_ext::Cancelled);
        QCOMPARE(calls, 2);
        QVERIFY(mesh.positions == before.positions && mesh.triangles == before.triangles);
    }
};

QTEST_APPLESS_MAIN(TestRepairFolds)
#include "test_repair_folds.moc"
