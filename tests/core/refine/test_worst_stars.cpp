// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "surface_pairs.h"
#include "vcg_ext/core/refine/refine.h"

using namespace test_meshes;
using vcg_ext::RefinementState;

namespace
{

/// One vertex of a fine sheet sticks out: the coarse one has it nowhere near.
SurfacePair SheetWithASpike(const std::vector<std::uint8_t>& fixed = {})
{
    IndexedMesh fine = Noisy(Grid(40, 40, 0.5), 0.02);
    fine.points[20 * 41 + 21][2] += 0.6; // between the vertices of the coarse one
    return MakePair(fine, Noisy(Grid(20, 20), 0.02, 7), fixed);
}

RefinementState Begin(SurfacePair& pair)
{
    RefinementState state = vcg_ext::BeginRefinement(pair.original, pair.simplified, pair.root, 1);
    state.changed = vcg_ext::NoMarks(pair.simplified.VertexCount());
    state.backward2.Allocate(pair.simplified.VertexCount());
    std::fill(state.backward2.begin(), state.backward2.end(), 0.0F);
    return state;
}

float Farthest2(const RefinementState& state)
{
    float largest2 = 0;
    for (const auto& sample : state.samples.samples) largest2 = std::max(largest2, sample.distance2);
    return largest2;
}

} // namespace

class TestWorstStars : public QObject
{
    Q_OBJECT

  private slots:
    void theFarthestSampleComesNearer()
    {
        SurfacePair pair = SheetWithASpike();
        RefinementState state = Begin(pair);
        const float before2 = Farthest2(state);
        const double rmsBefore = MeanSquare(state.samples);
        const auto tree = vcg_ext::TreeOf(pair.original, 1);
        QVERIFY(vcg_ext::ImproveWorstStars(state, tree, 1) > 0);
        QVERIFY2(Farthest2(state) < 0.64F * before2, // a fifth of the distance
                 qPrintable(QString("%1 of it").arg(static_cast<double>(Farthest2(state) / before2))));
        QVERIFY(MeanSquare(state.samples) < 1.03 * rmsBefore);
        QVERIFY(CornersAreConsistent(pair.simplified));
    }

    void onlyTheWorstStarsMove()
    {
        SurfacePair pair = SheetWithASpike();
        const SurfacePair before = SheetWithASpike();
        RefinementState state = Begin(pair);
        vcg_ext::ImproveWorstStars(state, vcg_ext::TreeOf(pair.original, 1), 1);
        std::size_t moved = 0;
        for (std::uint32_t v = 0; v < pair.simplified.VertexCount(); ++v)
            moved += pair.simplified.points[v].z != before.simplified.points[v].z ? 1 : 0;
        QVERIFY(moved > 0);
        QVERIFY(moved <= 9); // 2 % of 441 vertices
    }

    void pointsBackwardCountToo()
    {
        // A vertex of the coarse sheet is far out where no sample sees how far.
        IndexedMesh coarse = Noisy(Grid(20, 20), 0.02, 7);
        const std::uint32_t spike = 10 * 21 + 10;
        coarse.points[spike][2] += 2;
        SurfacePair pair = MakePair(Noisy(Grid(40, 40, 0.5), 0.02), coarse);
        RefinementState state = Begin(pair);
        state.backward2[spike] = 1e6F; // as a pass of moves would have found
        vcg_ext::WorstStarMover mover(state);
        const auto outcome = mover.Move(spike, vcg_ext::TreeOf(pair.original, 1));
        QVERIFY(outcome.after2 < 0.5F * outcome.before2);
    }

    void fixedVerticesAndBordersStay()
    {
        SurfacePair all = SheetWithASpike();
        const std::vector<std::uint8_t> fixed(all.simplified.VertexCount(), 1);
        SurfacePair pair = SheetWithASpike(fixed);
        const auto before = Bytes(pair.simplified);
        RefinementState state = Begin(pair);
        QCOMPARE(vcg_ext::ImproveWorstStars(state, vcg_ext::TreeOf(pair.original, 1), 1), std::size_t{0});
        QVERIFY(Bytes(pair.simplified) == before);
    }

    void starsOfOneTurnShareNoFace()
    {
        SurfacePair pair = SheetWithASpike();
        std::vector<std::uint32_t> all;
        for (std::uint32_t v = 0; v < pair.simplified.VertexCount(); ++v) all.push_back(v);
        const auto key = [](std::uint32_t v) { return static_cast<float>(v % 17); };
        const auto chosen = vcg_ext::WorstOf(pair.simplified, all, 40, key);
        QCOMPARE(chosen.size(), std::size_t{40});
        QCOMPARE(chosen.front() % 17, 16U);
        for (const std::uint32_t v : chosen)
            for (const std::uint32_t w : chosen)
                QVERIFY(v == w || !vcg_ext::AreNeighbours(pair.simplified, v, w));
    }
};

QTEST_APPLESS_MAIN(TestWorstStars)
#include "test_worst_stars.moc"
