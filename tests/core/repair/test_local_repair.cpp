// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/repair/fold_faults.h"

using namespace test_meshes;

namespace
{

/// What one repair has done to a mesh.
struct Outcome {
    std::size_t movedVertices = 0, changedFaces = 0, foldsBefore = 0, foldsAfter = 0;
};

/// Repairs the first folded face of a plane whose middle vertex is at \p place.
Outcome RepairPlane(const Point& place, float tolerance)
{
    const IndexedMesh plane = Grid(8, 8);
    IndexedMesh mesh = plane;
    mesh.points[4 + 4 * 9] = place;
    const vcg_ext::Frame frame = vcg_ext::FrameOf(View(mesh));
    const vcg_ext::FaceTree original(View(plane), frame, 1), simplified(View(mesh), frame, 1);
    vcg_ext::SurfaceArrays surface = vcg_ext::BuildSurfaceArrays(View(mesh), frame);
    vcg_ext::MakeRoomForCorners(surface, vcg_ext::kFlipRoom);
    vcg_ext::FoldFaults faults(original, surface);
    vcg_ext::LocalRepair repair(original, simplified, surface, faults);
    const auto folds = [&] {
        std::vector<std::uint32_t> folded;
        for (std::uint32_t f = 0; f < surface.FaceCount(); ++f)
            if (repair.IsFaulty(f)) folded.push_back(f);
        return folded;
    };
    Outcome outcome;
    outcome.foldsBefore = folds().size();
    repair.Repair(folds().front(), tolerance, false);
    outcome.foldsAfter = folds().size();
    for (const std::uint8_t flags : surface.flags)
        outcome.movedVertices += (flags & vcg_ext::kMovedVertex) != 0;
    for (std::size_t f = 0; f < surface.FaceCount(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            if (surface.triangles[f].v[k] != mesh.triangles[f][k]) {
                ++outcome.changedFaces;
                break;
            }
    return outcome;
}

} // namespace

/// Flips are tried before moves, so whether the search goes on after a flip shows in what is changed.
class TestLocalRepair : public QObject
{
    Q_OBJECT

  private slots:
    /// 1e-5 of a face away from the plane is rounding: no move can be worth more.
    void aRepairThatCostsNothingEndsTheSearch()
    {
        const Outcome outcome = RepairPlane({5.1, 4.5, 1e-5}, 1);
        QCOMPARE(outcome.foldsBefore, std::size_t{1});
        QCOMPARE(outcome.foldsAfter, std::size_t{0});
        QCOMPARE(outcome.changedFaces, std::size_t{2});
        QCOMPARE(outcome.movedVertices, std::size_t{0});
    }

    /// The flip would double the energy at most; the move back towards the plane lowers it.
    void aRepairThatCostsSomethingDoesNotEndIt()
    {
        const Outcome outcome = RepairPlane({5.1, 4.5, 0.1}, 2);
        QCOMPARE(outcome.foldsBefore, std::size_t{1});
        QCOMPARE(outcome.foldsAfter, std::size_t{0});
        QCOMPARE(outcome.changedFaces, std::size_t{0});
        QCOMPARE(outcome.movedVertices, std::size_t{1});
    }

    /// A flip repairs one of the two folds for nothing, a move both.
    void aRepairThatLeavesAFoldDoesNotEndIt()
    {
        const Outcome outcome = RepairPlane({5.3, 4.2, 0}, 1);
        QCOMPARE(outcome.foldsBefore, std::size_t{2});
        QCOMPARE(outcome.foldsAfter, std::size_t{0});
        QCOMPARE(outcome.changedFaces, std::size_t{0});
        QCOMPARE(outcome.movedVertices, std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(TestLocalRepair)
#include "test_local_repair.moc"
