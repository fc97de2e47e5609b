// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "surface_pairs.h"
#include "vcg_ext/core/refine/refine.h"

using namespace test_meshes;
using vcg_ext::RefinementState;
using vcg_ext::SurfaceArrays;
using vcg_ext::SurfaceBefore;

namespace
{

constexpr std::uint32_t kMiddle = 10 * 21 + 10;

SurfacePair Sheets(double spike = 0)
{
    IndexedMesh coarse = Noisy(Grid(20, 20), 0.02, 7);
    coarse.points[kMiddle][2] += spike;
    return MakePair(Noisy(Grid(40, 40, 0.5), 0.02), coarse);
}

/// A roof of slope 1 over y = 2 with the ridge along edges.
IndexedMesh Roof(int columns, int rows, double spacing)
{
    IndexedMesh mesh = Grid(columns, rows, spacing);
    for (Point& p : mesh.points) p[2] = 2 - std::abs(p[1] - 2);
    return mesh;
}

/// As at the end of the passes: places near the faces are known.
RefinementState AfterPasses(SurfacePair& pair)
{
    vcg_ext::MakeRoomForCorners(pair.simplified, vcg_ext::kFlipRoom);
    RefinementState state = vcg_ext::BeginRefinement(pair.original, pair.simplified, pair.root, 1);
    vcg_ext::MoveVertices(state, 1);
    return state;
}

void Lift(SurfaceArrays& surface, std::uint32_t v, double height, const SurfacePair& pair)
{
    const float scale = std::abs(PositionOf(pair.original, 1).x - PositionOf(pair.original, 0).x) / 0.5F;
    surface.points[v].z += static_cast<float>(height) * scale;
    surface.flags[v] |= vcg_ext::kMovedVertex;
}

bool IsSame(const vcg_ext::SurfacePoint& a, const vcg_ext::SurfacePoint& b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

std::set<std::uint32_t> CornersOfFace(const vcg_ext::SurfaceTriangle& t)
{
    return {t.v[0], t.v[1], t.v[2]};
}

} // namespace

class TestCheckStars : public QObject
{
    Q_OBJECT

  private slots:
    void aVertexThatWentTooFarGoesBack()
    {
        SurfacePair pair = Sheets();
        RefinementState state = AfterPasses(pair);
        pair.simplified.flags[kMiddle] = 0; // is where the input had it
        const SurfaceBefore before(pair.simplified);
        Lift(pair.simplified, kMiddle, 0.6, pair);
        Lift(pair.simplified, 5 * 21 + 5, 0.001, pair); // no farther than the noise
        QCOMPARE(vcg_ext::TakeBackWorse(state, before, 1), std::size_t{1});
        QVERIFY(IsSame(pair.simplified.points[kMiddle], before.points[kMiddle]));
        QCOMPARE(pair.simplified.flags[kMiddle], std::uint8_t{0});
        QVERIFY(!IsSame(pair.simplified.points[5 * 21 + 5], before.points[5 * 21 + 5]));
    }

    void whatWasAsFarBeforeStays()
    {
        SurfacePair pair = Sheets(0.6);
        vcg_ext::MakeRoomForCorners(pair.simplified, vcg_ext::kFlipRoom);
        const SurfaceBefore before(pair.simplified);
        RefinementState state = vcg_ext::BeginRefinement(pair.original, pair.simplified, pair.root, 1);
        std::fill(state.centroidHints.begin(), state.centroidHints.end(), kMiddle); // walks go from anywhere
        Lift(pair.simplified, kMiddle, -0.05, pair);
        state.farthest2 /= 4; // the spike is farther than that before and after
        QCOMPARE(vcg_ext::TakeBackWorse(state, before, 1), std::size_t{0});
        QVERIFY(!IsSame(pair.simplified.points[kMiddle], before.points[kMiddle]));
    }

    void aDiagonalThatCutsARidgeGoesBack()
    {
        SurfacePair pair = MakePair(Roof(16, 16, 0.25), Roof(4, 4, 1));
        RefinementState state = AfterPasses(pair);
        state.farthest2 = 1e-3F; // both surfaces are the same
        const SurfaceBefore before(pair.simplified);
        std::fill(state.centroidHints.begin(), state.centroidHints.end(), 8U * 17 + 8);
        const auto edge = vcg_ext::FindFlippableEdge(pair.simplified, 2 * 5 + 1, 2 * 5 + 2); // of the ridge
        QVERIFY(edge.has_value());
        vcg_ext::FlipEdge(pair.simplified, *edge);
        QCOMPARE(vcg_ext::TakeBackWorse(state, before, 1), std::size_t{1});
        for (const std::uint32_t f : {edge->First(), edge->Second()}) {
            const auto now = CornersOfFace(pair.simplified.triangles[f]);
            QVERIFY(now == CornersOfFace(before.triangles[edge->First()]) ||
                    now == CornersOfFace(before.triangles[edge->Second()]));
        }
        QVERIFY(CornersAreConsistent(pair.simplified));
    }

    void facesOfTheOriginalAreAsked()
    {
        // The sheet is two large faces, whose only samples far from the dent are their corners.
        SurfacePair pair = MakePair(Grid(1, 1, 20), Grid(20, 20));
        const SurfaceBefore before(pair.simplified);
        pair.simplified.points[kMiddle].z += 10;
        vcg_ext::StarCheck check(pair.original, pair.simplified, before, 1, 1);
        QCOMPARE(check.Run({{}, {0, 1}}), std::size_t{1});
        QVERIFY(IsSame(pair.simplified.points[kMiddle], before.points[kMiddle]));
    }

    void whatIsAroundIsAskedNext()
    {
        // A block of vertices has sunk together; only one of its faces is suspect.
        SurfacePair pair = Sheets();
        const SurfaceBefore before(pair.simplified);
        for (std::uint32_t row = 8; row <= 12; ++row)
            for (std::uint32_t column = 8; column <= 12; ++column)
                Lift(pair.simplified, row * 21 + column, 0.4, pair);
        const std::uint32_t face = vcg_ext::FaceOf(*BeginCorners(pair.simplified, kMiddle));
        vcg_ext::StarCheck check(pair.original, pair.simplified, before, 1, 1);
        QCOMPARE(check.Run({{face}, {}}), std::size_t{25});
        for (std::uint32_t v = 0; v < pair.simplified.VertexCount(); ++v)
            QVERIFY(IsSame(pair.simplified.points[v], before.points[v]));
    }

    void threadsDoNotChangeAByte()
    {
        std::vector<unsigned char> expected;
        for (const int threads : {1, 2, 5}) {
            SurfacePair pair = Sheets();
            RefinementState state = AfterPasses(pair);
            const SurfaceBefore before(pair.simplified);
            for (std::uint32_t v = 22; v + 22 < pair.simplified.VertexCount(); v += 3)
                Lift(pair.simplified, v, 0.01 * (v % 13), pair);
            const auto lifted = Bytes(pair.simplified);
            QVERIFY(vcg_ext::TakeBackWorse(state, before, threads) > 10);
            if (threads == 1) expected = Bytes(pair.simplified);
            QVERIFY(Bytes(pair.simplified) == expected);
            QVERIFY(expected != lifted);
        }
    }

    void theFarthestPointLiesBetween()
    {
        // A face across a valley: its corners touch the slopes, and its middle is over the bottom.
        IndexedMesh valley = Grid(4, 4, 1);
        for (Point& p : valley.points) p[2] = std::abs(p[0] - 2);
        const SurfaceArrays surface = vcg_ext::BuildSurfaceArrays(View(valley), vcg_ext::Frame{});
        const vcg_ext::FaceTree tree = vcg_ext::TreeOf(surface, 1);
        const vcg_ext::FaceCorners face{{0.63F, 2, 1.37F}, {2.6F, 0, 0}, {0, 0.5F, 0}};
        const float exact = 1.37F / std::sqrt(2.0F); // over the bottom, to either slope
        const vcg_ext::FarthestPoint found = vcg_ext::FindFarthest(tree, face, 0);
        QVERIFY(std::sqrt(found.distance2) <= exact * 1.0001F);
        QVERIFY(std::sqrt(found.distance2) > 0.99F * exact);
        QCOMPARE(vcg_ext::FindFarthest(tree, face, 4).distance2, 4.0F);
    }
};

QTEST_APPLESS_MAIN(TestCheckStars)
#include "test_check_stars.moc"
