// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "surface_pairs.h"
#include "vcg_ext/core/refine/border_samples.h"
#include "vcg_ext/core/refine/refine.h"

using namespace test_meshes;
using vcg_ext::BorderSamples;
using vcg_ext::kNone;
using vcg_ext::SurfaceArrays;
using vcg_ext::Vector3;

namespace
{

constexpr int kFine = 96, kCoarse = 12;

/// The square from -1 to 1 in so many cells, squeezed into the unit disk, lifted to height x (1 - r^2).
IndexedMesh Dome(int cells, double height)
{
    IndexedMesh mesh = Grid(cells, cells, 2. / cells);
    for (Point& p : mesh.points) {
        const double x = p[0] - 1, y = p[1] - 1;
        p = {x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2), 0};
        p[2] = height * (1 - p[0] * p[0] - p[1] * p[1]);
    }
    return mesh;
}

BorderSamples Attach(const SurfacePair& pair)
{
    return vcg_ext::AttachBorderSamples(pair.original, pair.simplified, pair.root, 1);
}

/// Squared, of a point to the border edge of \p surface that is closest.
float SquaredDistanceToBorder(const Vector3<float>& p, const SurfaceArrays& surface,
                              const vcg_ext::BorderLoops& loops)
{
    float nearest = std::numeric_limits<float>::max();
    for (std::uint32_t v = 0; v < surface.VertexCount(); ++v) {
        if (loops.next[v] == kNone) continue;
        const Vector3<float> start = PositionOf(surface, v);
        nearest = std::min(nearest, vcg_ext::SquaredDistanceToSegment(
                                        p - start, PositionOf(surface, loops.next[v]) - start));
    }
    return nearest;
}

double BorderRms(const SurfacePair& pair)
{
    const vcg_ext::BorderLoops loops = vcg_ext::FindBorderLoops(pair.simplified, 1);
    double sum = 0, count = 0;
    for (std::uint32_t v = 0; v < pair.original.VertexCount(); ++v)
        if (pair.original.flags[v] & vcg_ext::kBorderVertex) {
            const Vector3<float> p = PositionOf(pair.original, v);
            sum += static_cast<double>(SquaredDistanceToBorder(p, pair.simplified, loops));
            ++count;
        }
    return std::sqrt(sum / count);
}

} // namespace

class TestBorderSamples : public QObject
{
    Q_OBJECT

  private slots:
    /// Once around a disk, in the direction of its faces.
    void aBorderIsALoop()
    {
        const SurfacePair pair = MakePair(Dome(kCoarse, 0), Dome(kCoarse, 0));
        const vcg_ext::BorderLoops loops = vcg_ext::FindBorderLoops(pair.simplified, 1);
        std::set<std::uint32_t> seen;
        double turn = 0;
        for (std::uint32_t v = 0; seen.insert(v).second; v = loops.next[v]) {
            QVERIFY(loops.next[v] != kNone);
            QCOMPARE(loops.previous[loops.next[v]], v);
            turn += static_cast<double>(
                Cross(PositionOf(pair.simplified, v), PositionOf(pair.simplified, loops.next[v])).z);
        }
        QCOMPARE(seen.size(), std::size_t{4 * kCoarse});
        QVERIFY(turn > 0);
        const auto none = [](std::uint32_t v) { return v == kNone; };
        QCOMPARE(std::count_if(loops.next.begin(), loops.next.end(), none),
                 std::ptrdiff_t{(kCoarse - 1) * (kCoarse - 1)});
    }

    /// Two fans that share vertex 0: two edges begin there, and would have the same number.
    void whereTwoFansMeetNobodyIsNext()
    {
        IndexedMesh mesh;
        mesh.points = {{0, 0, 0}};
        for (const int side : {1, -1}) {
            for (const double angle : {-0.9, -0.3, 0.3, 0.9})
                mesh.points.push_back({side * std::cos(angle), side * std::sin(angle), 0});
            const std::size_t first = mesh.points.size() - 4;
            for (std::size_t i = 0; i < 3; ++i) mesh.AddTriangle(0, first + i, first + i + 1);
        }
        SurfacePair pair = MakePair(mesh, mesh);
        const BorderSamples border = Attach(pair);
        QCOMPARE(border.loops.next[0], kNone);
        QCOMPARE(border.loops.previous[0], kNone);
        std::set<std::uint32_t> mayMove;
        for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
            if (border.MayMove(v)) mayMove.insert(v);
        // of each fan the one that follows vertex 0 stays; the one before it has no edge in common with
        // others
        QCOMPARE(mayMove, (std::set<std::uint32_t>{2, 3, 4, 6, 7, 8}));
    }

    /// Vertex 0 has two faces between 1 and 3, and on the edge between these a face and its back.
    void aVertexOfAnEdgeOfFourFacesIsOnNoLoop()
    {
        IndexedMesh mesh;
        mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 1}};
        for (const auto& [a, b] :
             std::vector<std::pair<std::size_t, std::size_t>>{{1, 2}, {2, 3}, {4, 2}, {2, 4}})
            mesh.AddTriangle(0, a, b);
        const SurfacePair pair = MakePair(mesh, mesh);
        QCOMPARE(vcg_ext::FindBorderLoops(pair.simplified, 1).next[0], kNone);
    }

    /// Every vertex and midpoint of the original's border is on the border edge closest to it, and together
    /// they weigh what a border edge is long, squared, for each of them.
    void samplesAreOnTheClosestEdge()
    {
        const SurfacePair pair = MakePair(Dome(kFine, 0), Dome(kCoarse, 0));
        const BorderSamples border = Attach(pair);
        QCOMPARE(border.lists.samples.size(), std::size_t{2 * 4 * kFine});
        double weight = 0, longest = 0, shortest = std::numeric_limits<double>::max();
        for (const vcg_ext::Sample& sample : border.lists.samples) {
            const float closest = SquaredDistanceToBorder(PositionOf(sample), pair.simplified, border.loops);
            QVERIFY(std::abs(sample.distance2 - closest) <= 1e-3F * closest + 1e-5F); // rounding at 500
            weight += static_cast<double>(sample.weight);
        }
        for (std::uint32_t v = 0; v < pair.simplified.VertexCount(); ++v) {
            if (border.loops.next[v] == kNone) continue;
            const auto length = static_cast<double>(
                Norm(PositionOf(pair.simplified, border.loops.next[v]) - PositionOf(pair.simplified, v)));
            longest = std::max(longest, length);
            shortest = std::min(shortest, length);
        }
        const double around = 2 * kPi * vcg_ext::kFrameDiagonal / std::sqrt(8.); // the box is 2 by 2
        const auto share = static_cast<double>(vcg_ext::kBorderWeight);
        QVERIFY(weight > 0.99 * share * around * shortest && weight < 1.01 * share * around * longest);
    }

    /// The polygon around a dome lies inside the circle. Half inside and half outside it has 2.4 times less
    /// rms (a parabola's standard deviation against its root mean square).
    void aBorderComesNearer()
    {
        SurfacePair pair = MakePair(Dome(kFine, 0.3), Dome(kCoarse, 0.3));
        const double before = BorderRms(pair), surface = ExactRms(pair);
        vcg_ext::RefinementParameters parameters;
        parameters.moveSweeps = 4;
        QVERIFY(Refine(pair, parameters).moves > 4 * kCoarse);
        QVERIFY(BorderRms(pair) < 0.5 * before);
        QVERIFY(ExactRms(pair) < surface);
    }

    /// The rim of the dome is in a plane that is not one of the axes', and stays in it.
    void aFlatBorderStaysFlat()
    {
        const auto tilted = [](IndexedMesh mesh) {
            for (Point& p : mesh.points) p = {p[0], 0.6 * p[1] - 0.8 * p[2], 0.8 * p[1] + 0.6 * p[2]};
            return mesh;
        };
        SurfacePair pair = MakePair(tilted(Dome(kFine, 0.6)), tilted(Dome(kCoarse, 0.6)));
        const auto height = [&](std::uint32_t v) {
            const Vector3<float> p = PositionOf(pair.simplified, v);
            return 0.6F * p.z - 0.8F * p.y;
        };
        const vcg_ext::BorderLoops loops = vcg_ext::FindBorderLoops(pair.simplified, 1);
        const float rim = height(0);
        Refine(pair);
        std::size_t moved = 0;
        for (std::uint32_t v = 0; v < pair.simplified.VertexCount(); ++v) {
            if (loops.next[v] == kNone) continue;
            QVERIFY(std::abs(height(v) - rim) < 1e-3F); // rounding of coordinates up to 500, a few times
            moved += pair.simplified.flags[v] & vcg_ext::kMovedVertex ? 1U : 0U;
        }
        QVERIFY(moved > kCoarse);
    }

    /// Of a wavy sheet over a square every side bends in its own plane only, and the corners stay.
    void straightSidesStayStraight()
    {
        const auto waves = [](int cells) {
            IndexedMesh mesh = Grid(cells, cells, 2. / cells);
            for (Point& p : mesh.points) p[2] = 0.1 * std::sin(5 * p[0]) * std::cos(4 * p[1]);
            return mesh;
        };
        SurfacePair pair = MakePair(waves(96), waves(12));
        const SurfaceArrays before = CopyOf(pair.simplified);
        Refine(pair);
        std::size_t moved = 0;
        for (std::uint32_t v = 0; v < before.VertexCount(); ++v) {
            if (!(before.flags[v] & vcg_ext::kBorderVertex)) continue;
            const Vector3<float> step = PositionOf(pair.simplified, v) - PositionOf(before, v);
            const std::uint32_t column = v % 13, row = v / 13;
            if (column == 0 || column == 12) QVERIFY(std::abs(step.x) < 1e-4F); // rounding
            if (row == 0 || row == 12) QVERIFY(std::abs(step.y) < 1e-4F);
            moved += SquaredNorm(step) > 0 ? 1U : 0U;
        }
        QVERIFY(moved > 12);
    }

    void fixedBordersHaveNoSamples()
    {
        const IndexedMesh coarse = Dome(kCoarse, 0.3);
        const std::vector<std::uint8_t> fixed(coarse.points.size(), 1);
        QVERIFY(Attach(MakePair(Dome(kFine, 0.3), coarse, fixed)).lists.samples.empty());
        QVERIFY(Attach(MakePair(Icosphere(2), Icosphere(1))).lists.samples.empty());
    }

    /// Many blocks with many borders between them.
    void threadsDoNotChangeAByte()
    {
        std::vector<unsigned char> expected;
        for (const int threads : {1, 2, 7}) {
            SurfacePair pair = MakePair(Dome(kFine, 0.3), Dome(kCoarse, 0.3));
            auto state = vcg_ext::BeginRefinement(pair.original, pair.simplified, pair.root, threads);
            state.blockVertices = 8;
            QVERIFY(vcg_ext::MoveVertices(state, threads) > 4 * kCoarse);
            if (threads == 1) expected = Bytes(pair.simplified);
            QVERIFY(Bytes(pair.simplified) == expected);
        }
    }

    /// Where nothing of the original's border was collapsed to it, a border vertex stays: it would drift away
    /// from what it cannot see.
    void aBorderWithoutSamplesStays()
    {
        SurfacePair pair = MakePair(Dome(kFine, 0.3), Dome(kCoarse, 0.3));
        for (std::uint32_t v = 0; v < pair.root.size(); ++v)
            if (pair.simplified.flags[pair.root[v]] & vcg_ext::kBorderVertex) pair.root[v] = kNone;
        const SurfaceArrays before = CopyOf(pair.simplified);
        Refine(pair);
        for (std::uint32_t v = 0; v < before.VertexCount(); ++v)
            if (before.flags[v] & vcg_ext::kBorderVertex)
                QVERIFY(SquaredNorm(PositionOf(pair.simplified, v) - PositionOf(before, v)) == 0);
    }
};

QTEST_APPLESS_MAIN(TestBorderSamples)
#include "test_border_samples.moc"
