// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "surface_pairs.h"
#include "vcg_ext/core/refine/refine.h"

using namespace test_meshes;
using vcg_ext::ExchangeRounds;
using vcg_ext::RefinementParameters;
using vcg_ext::RefinementReport;
using vcg_ext::RefinementState;
using vcg_ext::SurfaceArrays;

namespace
{

/// A sheet that is flat but for waves in one quarter of it.
IndexedMesh Waves(int columns, double spacing)
{
    IndexedMesh sheet = Grid(columns, columns, spacing);
    for (Point& p : sheet.points) {
        const double x = p[0] - 5, y = p[1] - 5;
        if (x > 0 && y > 0) p[2] = .4 * std::sin(2 * x) * std::sin(2 * y);
    }
    return sheet;
}
/// Vertices are as many where it is flat as where it is not.
SurfacePair WavesAndFewVertices(const std::vector<std::uint8_t>& fixed = {})
{
    return MakePair(Waves(80, 10. / 80), Waves(16, 10. / 16), fixed);
}

RefinementState Begin(SurfacePair& pair, int threads)
{
    vcg_ext::MakeRoomForCorners(pair.simplified, vcg_ext::kExchangeRoom);
    RefinementState state = vcg_ext::BeginRefinement(pair.original, pair.simplified, pair.root, threads);
    state.changed = vcg_ext::NoMarks(pair.simplified.VertexCount());
    state.renewed = {vcg_ext::NoMarks(pair.simplified.VertexCount()),
                     vcg_ext::NoMarks(pair.simplified.FaceCount())};
    return state;
}

std::size_t Exchange(RefinementState& state, int threads, int rounds = 3)
{
    ExchangeRounds exchanges(state, threads);
    std::size_t count = 0;
    for (int round = 0; round < rounds; ++round) count += exchanges.Run(vcg_ext::AllVertices{});
    return count;
}

std::ptrdiff_t VerticesOnFaces(const SurfaceArrays& surface)
{
    return std::count_if(surface.cornerCount.begin(), surface.cornerCount.end(),
                         [](std::uint32_t faces) { return faces > 0; });
}

bool SamplesAreConsistent(const RefinementState& state)
{
    std::size_t listed = 0;
    for (std::uint32_t f = 0; f < state.simplified.FaceCount(); ++f)
        for (std::uint32_t i = state.samples.faces[f].first; i != vcg_ext::kNone;
             i = state.samples.samples[i].next, ++listed)
            if (state.samples.samples[i].face != f) return false;
    return listed == state.samples.samples.size();
}

} // namespace

class TestExchangeVertices : public QObject
{
    Q_OBJECT

  private slots:
    void verticesGoWhereTheErrorIs();
    void roundsFitBetterThanMovesAlone();
    void topologyAndSamplesStayConsistent();
    void fixedVerticesStay();
    void facesBetweenFixedVerticesStay();
    void nothingPassesAFreeBorder();
    void threadsDoNotChangeAByte();
    void whereNothingIsGainedNothingHappens();
    void largeStarsAreLeftAlone();
    void collapsesThatWouldDamageAreNotOffered();
    void onlyWhatIsWorthItIsChosen();
};

void TestExchangeVertices::verticesGoWhereTheErrorIs()
{
    SurfacePair pair = WavesAndFewVertices();
    const auto inWaves = [&] {
        std::size_t count = 0;
        const SurfaceArrays& s = pair.simplified;
        for (std::uint32_t v = 0; v < s.VertexCount(); ++v)
            count += s.points[v].x > 0 && s.points[v].y > 0 ? 1 : 0;
        return count;
    };
    RefinementState state = Begin(pair, 1);
    const std::size_t before = inWaves();
    const double errorBefore = ExactRms(pair);
    const std::size_t exchanges = Exchange(state, 1);
    // Where it is flat a collapse costs nothing; collapses near one another wait for the next round.
    QVERIFY2(exchanges >= 15, qPrintable(QString::number(exchanges)));
    QVERIFY(inWaves() >= before + exchanges * 9 / 10); // but for those at its rim
    QVERIFY2(ExactRms(pair) < 0.9 * errorBefore,
             qPrintable(QString("%1 of it").arg(ExactRms(pair) / errorBefore)));
}

void TestExchangeVertices::roundsFitBetterThanMovesAlone()
{
    SurfacePair moved = WavesAndFewVertices(), exchanged = WavesAndFewVertices();
    RefinementParameters parameters;
    parameters.moveSweeps = 16;
    Refine(moved, parameters);
    parameters.exchange = true;
    const RefinementReport report = Refine(exchanged, parameters);
    QVERIFY(report.exchanges > 0);
    QVERIFY(report.rmsAfter < report.rmsBefore);
    QVERIFY2(ExactRms(exchanged) < 0.75 * ExactRms(moved),
             qPrintable(QString("%1 of it").arg(ExactRms(exchanged) / ExactRms(moved))));
}

void TestExchangeVertices::topologyAndSamplesStayConsistent()
{
    auto families = Families();
    families.push_back({"waves", Waves(80, 10. / 80), Waves(16, 10. / 16)});
    for (const Family& family : families) {
        SurfacePair pair = MakePair(family.original, family.simplified);
        const auto before = Edges(pair.simplified);
        const auto verticesBefore = VerticesOnFaces(pair.simplified);
        RefinementState state = Begin(pair, 1);
        Exchange(state, 1);
        const auto after = Edges(pair.simplified);
        QCOMPARE(after.boundary, before.boundary);
        QCOMPARE(after.nonManifold, before.nonManifold);
        QCOMPARE(DifferentFaces(pair.simplified), family.simplified.triangles.size());
        QVERIFY2(CornersAreConsistent(pair.simplified), family.name);
        QVERIFY2(SamplesAreConsistent(state), family.name);
        for (std::uint32_t f = 0; f < pair.simplified.FaceCount(); ++f)
            QVERIFY(Norm(AreaVector(pair.simplified, f)) > 0);
        QCOMPARE(VerticesOnFaces(pair.simplified), verticesBefore);
    }
}

void TestExchangeVertices::fixedVerticesStay()
{
    const IndexedMesh coarse = Waves(16, 10. / 16);
    std::vector<std::uint8_t> fixed(coarse.points.size(), 0);
    for (std::size_t v = 0; v < fixed.size(); v += 3) fixed[v] = 1;
    SurfacePair pair = WavesAndFewVertices(fixed);
    const auto before = WavesAndFewVertices(fixed);
    RefinementParameters parameters;
    parameters.exchange = true;
    const RefinementReport report = Refine(pair, parameters);
    QVERIFY(report.exchanges > 0);
    constexpr std::uint8_t kStays = vcg_ext::kFixedVertex;
    for (std::uint32_t v = 0; v < pair.simplified.VertexCount(); ++v) {
        QCOMPARE(pair.simplified.flags[v] & kStays, before.simplified.flags[v] & kStays);
        if (!(before.simplified.flags[v] & kStays)) continue;
        QCOMPARE(pair.simplified.points[v].x, before.simplified.points[v].x);
        QCOMPARE(pair.simplified.points[v].y, before.simplified.points[v].y);
        QCOMPARE(pair.simplified.points[v].z, before.simplified.points[v].z);
    }
}

void TestExchangeVertices::facesBetweenFixedVerticesStay()
{
    // What lies outside a selection: half of the waves.
    const IndexedMesh coarse = Waves(16, 10. / 16);
    std::vector<std::uint8_t> fixed;
    for (const Point& p : coarse.points) fixed.push_back(p[0] > 7.4 ? 1 : 0);
    SurfacePair pair = WavesAndFewVertices(fixed);
    RefinementParameters parameters;
    parameters.exchange = true;
    QVERIFY(Refine(pair, parameters).exchanges > 0);
    std::size_t outside = 0;
    for (std::uint32_t f = 0; f < pair.simplified.FaceCount(); ++f) {
        const Triangle& t = coarse.triangles[f];
        if (!fixed[t[0]] || !fixed[t[1]] || !fixed[t[2]]) continue;
        ++outside;
        for (std::size_t k = 0; k < 3; ++k) QCOMPARE(pair.simplified.triangles[f].v[k], t[k]);
    }
    QVERIFY(outside > 50);
}

void TestExchangeVertices::nothingPassesAFreeBorder()
{
    SurfacePair pair = WavesAndFewVertices();
    float low = 0, high = 0;
    for (const auto& p : pair.original.points) {
        low = std::min({low, p.x, p.y});
        high = std::max({high, p.x, p.y});
    }
    RefinementParameters parameters;
    parameters.exchange = true;
    Refine(pair, parameters);
    const float rounding = 1e-3F;
    for (const auto& p : pair.simplified.points)
        QVERIFY(std::min(p.x, p.y) >= low - rounding && std::max(p.x, p.y) <= high + rounding);
}

void TestExchangeVertices::threadsDoNotChangeAByte()
{
    auto families = Families();
    families.push_back({"waves", Waves(80, 10. / 80), Waves(16, 10. / 16)});
    std::size_t changes = 0;
    for (const Family& family : families) {
        std::vector<unsigned char> expected;
        for (const int threads : {1, 2, 3, 7}) {
            SurfacePair pair = MakePair(family.original, family.simplified);
            RefinementState state = Begin(pair, threads);
            state.blockVertices = 20; // many seams
            RefinementReport report;
            vcg_ext::RefineInRounds(state, threads, report, [](double, double, int) {});
            vcg_ext::ImproveWorstStars(state, vcg_ext::TreeOf(pair.original, threads), threads);
            changes += report.exchanges;
            if (threads == 1) expected = Bytes(pair.simplified);
            QVERIFY2(Bytes(pair.simplified) == expected, family.name);
        }
    }
    QVERIFY(changes > 0);
}

void TestExchangeVertices::whereNothingIsGainedNothingHappens()
{
    SurfacePair pair = MakePair(Grid(40, 40, 0.5), Grid(20, 20));
    const auto before = Bytes(pair.simplified);
    RefinementState state = Begin(pair, 1);
    QCOMPARE(Exchange(state, 1), std::size_t{0});
    QVERIFY(Bytes(pair.simplified) == before);
}

void TestExchangeVertices::collapsesThatWouldDamageAreNotOffered()
{
    // A tube of three sides may become shorter, but not one of two.
    constexpr std::uint32_t kRings = 24;
    const IndexedMesh tube = Torus(kRings, 3);
    SurfacePair pair = MakePair(SubdividedAtMidpoints(tube), tube);
    RefinementState state = Begin(pair, 1);
    vcg_ext::VertexExchanger exchanger(state);
    const auto mayCollapse = [&](std::uint32_t a, std::uint32_t b) {
        return exchanger.OfferCollapse(a, b).stands;
    };
    std::vector<std::array<std::uint32_t, 2>> along;
    for (const Triangle& t : tube.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (a % kRings == b % kRings)
                QVERIFY(!mayCollapse(a, b));
            else if (mayCollapse(a, b))
                along.push_back({a, b});
        }
    QVERIFY(!along.empty());

    const auto [a, b] = along.front();
    for (const std::uint32_t end : {a, b})
        for (const std::uint8_t flag : {vcg_ext::kBorderVertex, vcg_ext::kFixedVertex}) {
            const std::uint8_t before = pair.simplified.flags[end];
            pair.simplified.flags[end] |= flag;
            QVERIFY(!mayCollapse(a, b));
            pair.simplified.flags[end] = before;
        }
}

void TestExchangeVertices::onlyWhatIsWorthItIsChosen()
{
    SurfacePair pair = MakePair(Grid(20, 20), Grid(20, 20));
    const auto choose = [&](float cost, float gain) {
        const vcg_ext::ExchangeOffer collapse{cost, 21 * 5 + 5, 21 * 5 + 6, {}};
        const vcg_ext::ExchangeOffer division{-gain, 21 * 15 + 15, 21 * 15 + 16, {}};
        return vcg_ext::ExchangeChoice(pair.simplified).Choose({collapse}, {division});
    };
    QCOMPARE(choose(1, 10).collapses.size(), std::size_t{1});
    QCOMPARE(choose(1, 10).divisions.size(), std::size_t{1});
    QVERIFY(choose(1, 0.5F).collapses.empty());
    QVERIFY(choose(0, 0).collapses.empty());
}

void TestExchangeVertices::largeStarsAreLeftAlone()
{
    // Measuring a collapse takes the square of the faces around it.
    constexpr int kSides = 600;
    IndexedMesh wheel = Pyramid(kSides, 1, 0.5);
    SurfacePair pair = MakePair(SubdividedAtMidpoints(wheel), Noisy(wheel, 0.02));
    RefinementState state = Begin(pair, 1);
    vcg_ext::VertexExchanger exchanger(state);
    QVERIFY(!exchanger.OfferCollapse(0, 1).stands);
}

QTEST_APPLESS_MAIN(TestExchangeVertices)
#include "test_exchange_vertices.moc"
