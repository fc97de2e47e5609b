// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <set>

#include "analytic_meshes.h"
#include "mesh_checks.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/collapse/initialize.h"
#include "vcg_ext/core/collapse/load.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;

namespace
{

test_meshes::Defects DefectsOf(const DecimatedMesh& mesh)
{
    return test_meshes::FindDefects({mesh.positions, mesh.triangles, {}});
}

DecimationParameters Parameters(std::size_t target, int threads = 1)
{
    DecimationParameters parameters;
    parameters.targetFaces = target;
    parameters.effort = Effort::Fast;
    parameters.threads = threads;
    return parameters;
}

template <class Values>
bool IsAscendingBelow(const Values& values, std::size_t end)
{
    return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end() &&
           (values.empty() || values.back() < end);
}

/// Whatever the input, this holds for the outcome.
void VerifySound(const IndexedMesh& input, const DecimatedMesh& result)
{
    QCOMPARE(result.positions.size(), result.vertexOrigin.size());
    QCOMPARE(result.triangles.size(), result.faceOrigin.size());
    QVERIFY(IsAscendingBelow(result.vertexOrigin, input.points.size()));
    QVERIFY(IsAscendingBelow(result.faceOrigin, input.triangles.size()));
    for (const auto& p : result.positions)
        for (const double x : p) QVERIFY(std::isfinite(x));
    for (const auto& t : result.triangles)
        for (const std::uint32_t v : t) QVERIFY(v < result.positions.size());
    const test_meshes::Defects before = test_meshes::FindDefects(input), after = DefectsOf(result);
    QVERIFY(after.nonManifoldEdges <= before.nonManifoldEdges);
    QVERIFY(after.nonManifoldFans <= before.nonManifoldFans);
    QVERIFY(after.duplicateFaces <= before.duplicateFaces);
    QVERIFY(after.degenerateFaces <= before.degenerateFaces);
}

bool SameBytes(const DecimatedMesh& a, const DecimatedMesh& b)
{
    return a.positions == b.positions && a.triangles == b.triangles && a.vertexOrigin == b.vertexOrigin &&
           a.faceOrigin == b.faceOrigin;
}

double EnclosedVolume(const DecimatedMesh& mesh)
{
    double volume = 0;
    for (const auto& t : mesh.triangles) {
        const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return volume / 6;
}

double AreaOf(const DecimatedMesh& mesh)
{
    const IndexedMesh surface{mesh.positions, mesh.triangles, {}};
    double area = 0;
    for (const auto& t : mesh.triangles) area += test_meshes::TriangleArea(surface, t);
    return area;
}

/// A hub with \p spokes triangles around it, closed below where asked.
IndexedMesh Fan(int spokes, bool closed)
{
    IndexedMesh mesh = test_meshes::Pyramid(spokes);
    if (!closed) return mesh;
    const std::size_t below = mesh.points.size();
    mesh.points.push_back({0, 0, -1});
    for (std::size_t i = 0; i < static_cast<std::size_t>(spokes); ++i)
        mesh.AddTriangle(below, 1 + (i + 1) % static_cast<std::size_t>(spokes), 1 + i);
    return mesh;
}

IndexedMesh Tetrahedron()
{
    IndexedMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return mesh;
}

/// A sphere with some of its faces there twice, some with a repeated vertex and some without area.
IndexedMesh Littered()
{
    IndexedMesh mesh = test_meshes::Icosphere(2);
    for (std::size_t f = 0; f < 20; ++f) mesh.triangles.push_back(mesh.triangles[7 * f]);
    for (std::uint32_t v = 0; v < 20; ++v) mesh.triangles.push_back({v, v, v + 1});
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (std::uint32_t i = 0; i < 9; ++i) mesh.points.push_back({2 + 0.1 * i, 0, 0});
    for (std::uint32_t i = 0; i + 2 < 9; ++i)
        mesh.triangles.push_back({first + i, first + i + 1, first + i + 2});
    return mesh;
}

IndexedMesh Coincident()
{
    IndexedMesh mesh = test_meshes::Icosphere(1);
    for (auto& p : mesh.points) p = {3, 4, 5};
    return mesh;
}

/// An edge with many pages, each a strip of squares.
IndexedMesh ThickBook(int pages)
{
    IndexedMesh mesh;
    constexpr std::size_t kHeight = 6, kWidth = 4;
    for (std::size_t i = 0; i <= kHeight; ++i) mesh.points.push_back({0, 0, static_cast<double>(i)});
    for (int page = 0; page < pages; ++page) {
        const double angle = 2 * test_meshes::kPi * page / pages;
        const std::size_t first = mesh.points.size();
        const auto at = [&](std::size_t i, std::size_t j) {
            return j == 0 ? i : first + (j - 1) * (kHeight + 1) + i;
        };
        for (std::size_t j = 1; j <= kWidth; ++j)
            for (std::size_t i = 0; i <= kHeight; ++i)
                mesh.points.push_back({static_cast<double>(j) * std::cos(angle),
                                       static_cast<double>(j) * std::sin(angle), static_cast<double>(i)});
        for (std::size_t j = 0; j < kWidth; ++j)
            for (std::size_t i = 0; i < kHeight; ++i)
                mesh.AddQuad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), false);
    }
    return mesh;
}

const std::map<QByteArray, std::function<IndexedMesh()>>& Families()
{
    using namespace test_meshes;
    static const std::map<QByteArray, std::function<IndexedMesh()>> families{
        {"sphere", [] { return Icosphere(4); }},
        {"noisy sphere", [] { return Noisy(Icosphere(4), 0.01); }},
        {"box", [] { return Box(12); }},
        {"torus", [] { return Torus(60, 24); }},
        {"grid", [] { return Grid(40, 30); }},
        {"noisy grid", [] { return Noisy(Grid(40, 30), 0.2); }},
        {"open cylinder", [] { return OpenCylinder(40, 20); }},
        {"two components", [] { return Merged(Torus(30, 12), Box(6)); }},
        {"bow tie", [] { return BowTie(); }},
        {"book", [] { return ThickBook(9); }},
        {"isolated vertices", [] { return WithIsolatedVertices(Icosphere(3), 50); }},
        {"littered", Littered},
        {"coincident", Coincident},
        {"tetrahedron", Tetrahedron},
        {"open fan", [] { return Fan(1500, false); }},
        {"closed fan", [] { return Fan(1500, true); }},
        {"far away",
         [] {
             return Moved(Icosphere(3), 1, 1e-3, {1e4, -2e4, 3e4});
         }},
    };
    return families;
}

/// More than one block of the engine, with a border, creases and smooth parts.
IndexedMesh ManyBlocks()
{
    using namespace test_meshes;
    return Noisy(Merged(Torus(500, 100), Merged(Grid(120, 80, 0.02), Box(30))), 1e-4);
}

CollapsedSurface Surface(const MeshView& view, const DecimationParameters& parameters, KeptForLater kept = {})
{
    CollapseEngine engine(view, parameters, kept, StageProgress(parameters.progress));
    engine.Collapse(parameters.targetFaces);
    return std::move(engine).Extract();
}

DecimatedMesh Collapsed(const MeshView& view, const DecimationParameters& parameters)
{
    return ToMesh(view, Surface(view, parameters));
}

} // namespace

class TestEngine : public QObject
{
    Q_OBJECT

  private slots:
    void isSoundOnEveryFamily_data()
    {
        QTest::addColumn<QByteArray>("family");
        QTest::addColumn<int>("percent");
        for (const auto& [name, make] : Families())
            for (const int percent : {50, 10, 1})
                QTest::newRow(name + " " + QByteArray::number(percent)) << name << percent;
    }
    void isSoundOnEveryFamily()
    {
        QFETCH(QByteArray, family);
        QFETCH(int, percent);
        const IndexedMesh mesh = Families().at(family)();
        const std::size_t target =
            std::max<std::size_t>(1, mesh.triangles.size() * static_cast<std::size_t>(percent) / 100);
        for (const bool topology : {false, true}) {
            DecimationParameters parameters = Parameters(target);
            parameters.preserveTopology = topology;
            const DecimatedMesh result = Collapsed(View(mesh), parameters);
            VerifySound(mesh, result);
            QCOMPARE(result.stopReason == StopReason::Target, result.triangles.size() <= target);
        }
    }

    void reachesEveryTargetOnASphere()
    {
        const IndexedMesh sphere = test_meshes::Icosphere(3);
        for (std::size_t target = 4; target < sphere.triangles.size(); target += 46) {
            const DecimatedMesh result = Collapsed(View(sphere), Parameters(target));
            QCOMPARE(result.stopReason, StopReason::Target);
            QCOMPARE(result.triangles.size(), target); // an inner edge takes two faces with it
        }
    }

    void stopsWithAReasonWhereNothingMayGo()
    {
        const DecimatedMesh result = Collapsed(View(Tetrahedron()), Parameters(1));
        QCOMPARE(result.stopReason, StopReason::NoLegalCollapse);
        QCOMPARE(result.triangles.size(), std::size_t{4});
    }

    void leavesAMeshWithinTheTargetAsItIs()
    {
        const IndexedMesh box = test_meshes::Box(3);
        const DecimatedMesh result = Collapsed(View(box), Parameters(box.triangles.size()));
        QCOMPARE(result.triangles.size(), box.triangles.size());
        QVERIFY(std::equal(result.triangles.begin(), result.triangles.end(), box.triangles.begin()));
        QVERIFY(std::equal(result.positions.begin(), result.positions.end(), box.points.begin()));
    }

    void givesTheSameBytesOnAnyNumberOfThreads()
    {
        const IndexedMesh mesh = ManyBlocks();
        for (const std::size_t percent : {40, 5}) {
            const std::size_t target = mesh.triangles.size() * percent / 100;
            const DecimatedMesh one = Collapsed(View(mesh), Parameters(target, 1));
            for (const int threads : {1, 2, 3, 7})
                QVERIFY(SameBytes(one, Collapsed(View(mesh), Parameters(target, threads))));
        }
    }

    void reducesABoxToItsCorners()
    {
        const DecimatedMesh result = Collapsed(View(test_meshes::Box(12)), Parameters(12));
        QCOMPARE(result.triangles.size(), std::size_t{12});
        for (const auto& p : result.positions)
            for (const double x : p) QVERIFY(std::abs(x - std::round(x)) < 1e-3);
        QVERIFY(std::abs(EnclosedVolume(result) - 1) < 1e-3);
    }

    void keepsTheVolumeOfASphere()
    {
        const IndexedMesh sphere = test_meshes::Icosphere(4);
        const DecimatedMesh whole = Collapsed(View(sphere), Parameters(sphere.triangles.size()));
        const DecimatedMesh result = Collapsed(View(sphere), Parameters(200));
        QVERIFY(std::abs(EnclosedVolume(result) / EnclosedVolume(whole) - 1) < 0.01);
    }

    void keepsTheTopologyWhereItIsAsked()
    {
        for (const char* family : {"torus", "open cylinder", "book", "two components"}) {
            const IndexedMesh mesh = Families().at(family)();
            DecimationParameters parameters = Parameters(1);
            parameters.preserveTopology = true;
            const DecimatedMesh result = Collapsed(View(mesh), parameters);
            QCOMPARE(DefectsOf(result).eulerCharacteristic,
                     test_meshes::FindDefects(mesh).eulerCharacteristic);
            QCOMPARE(result.stopReason, StopReason::NoLegalCollapse);
        }
    }

    void closesSmallHolesOnlyWhereTheTargetNeedsIt()
    {
        IndexedMesh mesh = test_meshes::Icosphere(3);
        mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4); // one hole
        const auto borderEdges = [&](std::size_t target, bool topology) {
            DecimationParameters parameters = Parameters(target);
            parameters.preserveTopology = topology;
            const DecimatedMesh result = Collapsed(View(mesh), parameters);
            VerifySound(mesh, result);
            return DefectsOf(result).borderEdges;
        };
        QVERIFY(borderEdges(100, false) > 0);
        QVERIFY(borderEdges(1, true) > 0);
        const DecimatedMesh closed = Collapsed(View(mesh), Parameters(4));
        QCOMPARE(closed.stopReason, StopReason::Target);
        VerifySound(mesh, closed);
    }

    /// Closing the base of a tall pyramid would leave two faces on the same corners.
    void closesNoHoleOntoTheOtherSide()
    {
        IndexedMesh mesh;
        mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.87, 0}, {0.5, 0.29, 10}};
        mesh.AddTriangle(0, 1, 3);
        mesh.AddTriangle(1, 2, 3);
        mesh.AddTriangle(2, 0, 3);
        VerifySound(mesh, Collapsed(View(mesh), Parameters(2)));
    }

    void preservesAStraightBorder()
    {
        const DecimatedMesh result = Collapsed(View(test_meshes::Grid(30, 30)), Parameters(2));
        QCOMPARE(result.triangles.size(), std::size_t{2});
        for (const auto& p : result.positions)
            for (std::size_t k = 0; k < 2; ++k) QVERIFY(std::min(std::abs(p[k]), std::abs(p[k] - 30)) < 0.05);
    }

    void locksTheBorderWhereItIsAsked()
    {
        const IndexedMesh grid = test_meshes::Noisy(test_meshes::Grid(20, 20), 0.1);
        DecimationParameters parameters = Parameters(1);
        parameters.boundary = Boundary::Lock;
        const DecimatedMesh result = Collapsed(View(grid), parameters);
        VerifySound(grid, result);
        std::size_t onBorder = 0;
        for (std::size_t v = 0; v < result.positions.size(); ++v) {
            const std::uint32_t origin = result.vertexOrigin[v];
            const std::uint32_t i = origin % 21, j = origin / 21;
            if (i != 0 && i != 20 && j != 0 && j != 20) continue;
            ++onBorder;
            QCOMPARE(result.positions[v], grid.points[origin]);
        }
        QCOMPARE(onBorder, std::size_t{80});
    }

    /// Every edge across a strip joins two vertices of its border: merging them would leave a pinched vertex.
    void aNarrowStripIsNotPinched()
    {
        const IndexedMesh strip = test_meshes::Noisy(test_meshes::Grid(40, 1), 0.1);
        for (const Boundary boundary : {Boundary::Free, Boundary::Preserve})
            for (std::size_t target = 2; target < strip.triangles.size(); target += 6) {
                DecimationParameters parameters = Parameters(target);
                parameters.boundary = boundary;
                VerifySound(strip, Collapsed(View(strip), parameters));
            }
    }

    void aFreeBorderMayBeEaten()
    {
        const IndexedMesh grid = test_meshes::Noisy(test_meshes::Grid(20, 20), 0.1);
        const auto area = [&](Boundary boundary) {
            DecimationParameters parameters = Parameters(40);
            parameters.boundary = boundary;
            const DecimatedMesh result = Collapsed(View(grid), parameters);
            VerifySound(grid, result);
            return AreaOf(result);
        };
        // Half of it goes; where only one of border planes and border costs is left out, a tenth at most.
        QVERIFY(area(Boundary::Free) < 0.75 * area(Boundary::Preserve));
    }

    void fixedVerticesNeitherMoveNorGo()
    {
        const IndexedMesh sphere = test_meshes::Noisy(test_meshes::Icosphere(3), 0.01);
        std::vector<std::uint8_t> fixed(sphere.points.size());
        for (std::size_t v = 0; v < fixed.size(); ++v) fixed[v] = sphere.points[v][2] > 0.3;
        MeshView view = View(sphere);
        view.fixedVertices = fixed.data();
        const DecimatedMesh result = Collapsed(view, Parameters(1));
        VerifySound(sphere, result);
        std::set<std::uint32_t> kept(result.vertexOrigin.begin(), result.vertexOrigin.end());
        for (std::uint32_t v = 0; v < fixed.size(); ++v) QVERIFY(!fixed[v] || kept.count(v) == 1);
        for (std::size_t v = 0; v < result.positions.size(); ++v)
            if (fixed[result.vertexOrigin[v]])
                QCOMPARE(result.positions[v], sphere.points[result.vertexOrigin[v]]);
        // Faces between fixed vertices cannot go, almost everything else can.
        std::size_t untouchable = 0;
        for (const auto& t : sphere.triangles) untouchable += fixed[t[0]] && fixed[t[1]] && fixed[t[2]];
        QVERIFY(result.triangles.size() < untouchable + 60);
        QVERIFY(result.stopReason == StopReason::NoLegalCollapse);
    }

    void unmovedVerticesKeepEveryBit()
    {
        const IndexedMesh mesh = test_meshes::Moved(test_meshes::Torus(40, 16), 1, 0.3, {0.1, 0.2, 0.3});
        const DecimatedMesh result = Collapsed(View(mesh), Parameters(mesh.triangles.size() * 9 / 10));
        std::size_t same = 0;
        for (std::size_t v = 0; v < result.positions.size(); ++v)
            same += result.positions[v] == mesh.points[result.vertexOrigin[v]];
        QVERIFY(same > mesh.points.size() / 2);
    }

    void flatPartsAndStraightCreasesKeepEveryBit()
    {
        const IndexedMesh box = test_meshes::Moved(test_meshes::Box(12), 1, 0.3, {0.1, 0.2, 0.3});
        const DecimatedMesh result = Collapsed(View(box), Parameters(1200)); // of 1728
        std::size_t same = 0;
        for (std::size_t v = 0; v < result.positions.size(); ++v)
            same += result.positions[v] == box.points[result.vertexOrigin[v]];
        // Few edges have no end at which all faces of the ring, which are in rows, keep an area.
        QVERIFY(same > result.positions.size() * 95 / 100);
    }

    void everyInputFaceIsInTheOrderOnce()
    {
        const IndexedMesh sphere = test_meshes::Icosphere(4);
        for (const int threads : {1, 3}) {
            std::vector<std::uint32_t> order = Surface(View(sphere), Parameters(200, threads)).faceOrder;
            std::sort(order.begin(), order.end());
            QCOMPARE(order.size(), sphere.triangles.size());
            for (std::uint32_t f = 0; f < order.size(); ++f) QCOMPARE(order[f], f);
        }
    }

    /// Processors with and without AVX2 come to the same costs.
    void eightEdgesAtOnceCostTheSameBits()
    {
        for (const IndexedMesh& mesh :
             {test_meshes::Noisy(test_meshes::Icosphere(3), 0.05), test_meshes::Pyramid(41),
              test_meshes::Noisy(test_meshes::Grid(9, 9), 0.1)}) {
            const MeshView view = View(mesh);
            SweepState state;
            SweepLoader(view, state, 1).Load();
            SweepStarter(view, state, 1, Boundary::Preserve).Start();
            NeighbourScratch neighbours;
            for (std::uint32_t v = 0; v < state.VertexCount(); ++v) {
                QVERIFY(CollectNeighbours(state, v, {0, state.VertexCount()}, neighbours));
                std::vector<float> costs[2];
                for (const bool eight : {false, true}) {
                    state.eightAtOnce = eight && HasAvx2();
                    EvaluateEdges(state, v, neighbours);
                    const float* cost = neighbours.cost.data();
                    costs[eight].assign(cost, cost + neighbours.size);
                }
                QVERIFY(std::all_of(costs[0].begin(), costs[0].end(), [](float c) { return c >= 0; }));
                QCOMPARE(std::memcmp(costs[0].data(), costs[1].data(), sizeof(float) * costs[0].size()), 0);
            }
        }
    }

    void theTipOfAFoldKnowsItsOutline()
    {
        // A tetrahedron pressed flat: around its square the faces turn by 180 degrees.
        const IndexedMesh flat{
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, {}};
        const MeshView view = View(flat);
        SweepState state;
        SweepLoader(view, state, 1).Load();
        SweepStarter(view, state, 1, Boundary::Preserve).Start();
        const float side2 = 1024.0F * 1024.0F / 2; // in the frame
        for (std::uint32_t v = 0; v < 4; ++v) {
            const auto history = state.vertices[v].History().matrix;
            for (const float inPlane : {history.xx, history.yy})
                QVERIFY(std::abs(inPlane / (0.7F * 2 * side2) - 1) < 1e-5F); // two faces, one edge
        }
    }

    void featureWeightShiftsFacesToFeatures()
    {
        // Two equal grids, one with a bump of small creases: the weight spends more vertices on it.
        const auto verticesOnBump = [](double weight) {
            IndexedMesh mesh = test_meshes::Noisy(test_meshes::Grid(60, 60), 0.02);
            for (auto& p : mesh.points)
                if (std::hypot(p[0] - 15, p[1] - 30) < 8) p[2] += 0.3 * std::abs(std::sin(p[0]));
            DecimationParameters parameters = Parameters(700);
            parameters.featureWeight = weight;
            const DecimatedMesh result = Collapsed(View(mesh), parameters);
            return std::count_if(result.positions.begin(), result.positions.end(),
                                 [](const auto& p) { return std::hypot(p[0] - 15, p[1] - 30) < 9; });
        };
        QVERIFY(verticesOnBump(8) > verticesOnBump(0));
    }

    void guidanceReplacesTheDescriptor()
    {
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Grid(50, 50), 0.1);
        std::vector<float> guidance(mesh.points.size());
        for (std::size_t v = 0; v < guidance.size(); ++v) guidance[v] = mesh.points[v][0] < 25 ? 1.0f : 0.0f;
        MeshView view = View(mesh);
        view.guidance = guidance.data();
        DecimationParameters parameters = Parameters(800);
        parameters.featureWeight = 6;
        const DecimatedMesh result = Collapsed(view, parameters);
        const auto left = std::count_if(result.positions.begin(), result.positions.end(),
                                        [](const auto& p) { return p[0] < 25; });
        const auto right = static_cast<std::ptrdiff_t>(result.positions.size()) - left;
        QVERIFY2(2 * left > 5 * right, qPrintable(QString("%1 to %2").arg(left).arg(right))); // 1 without it
    }

    void reportsProgressAndStopsWhenToldTo()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(4);
        DecimationParameters parameters = Parameters(100);
        int calls = 0, last = 0;
        parameters.progress = [&](int percent, const char*) {
            ++calls;
            const bool rising = percent >= last && percent <= 100;
            last = percent;
            return rising;
        };
        QCOMPARE(Collapsed(View(mesh), parameters).stopReason, StopReason::Target);
        QVERIFY(calls > 1);
        parameters.progress = [](int, const char*) { return false; };
        QVERIFY_EXCEPTION_THROWN(Collapsed(View(mesh), parameters), Cancelled);
    }

    void floatsAreReadInPlace()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(3);
        struct Vertex {
            int other = 0;
            std::array<float, 3> p{};
        };
        std::vector<Vertex> vertices(mesh.points.size());
        IndexedMesh rounded = mesh;
        for (std::size_t v = 0; v < vertices.size(); ++v)
            for (std::size_t k = 0; k < 3; ++k) {
                vertices[v].p[k] = static_cast<float>(mesh.points[v][k]);
                rounded.points[v][k] = static_cast<double>(vertices[v].p[k]);
            }
        MeshView view = View(mesh);
        view.positions = vertices.front().p.data();
        view.positionStride = sizeof(Vertex);
        view.doublePositions = false;
        QVERIFY(SameBytes(Collapsed(view, Parameters(200)), Collapsed(View(rounded), Parameters(200))));
    }

    void goesOnFromOneTargetToTheNext()
    {
        const IndexedMesh mesh = test_meshes::Torus(60, 24);
        CollapseEngine engine(View(mesh), Parameters(1));
        QCOMPARE(engine.Collapse(1000), StopReason::Target);
        QCOMPARE(engine.Collapse(200), StopReason::Target);
        const DecimatedMesh result = ToMesh(View(mesh), std::move(engine).Extract());
        VerifySound(mesh, result);
        QVERIFY(result.triangles.size() <= 200);
    }

    /// Every call begins with the corner lists where the call before left them.
    void goesOnInManySteps()
    {
        const IndexedMesh mesh = test_meshes::Torus(30, 16);
        CollapseEngine engine(View(mesh), Parameters(1), {true, true});
        for (const std::size_t percent : {90, 80, 70, 60, 50, 40, 30, 20, 10, 8, 6}) {
            const std::size_t target = mesh.triangles.size() * percent / 100;
            QCOMPARE(engine.Collapse(target), StopReason::Target);
        }
        const CollapsedSurface surface = std::move(engine).Extract();
        VerifySound(mesh, ToMesh(View(mesh), surface));
        QCOMPARE(surface.original.FaceCount(), mesh.triangles.size());
    }

    void handsOverBothSurfacesForRefinement()
    {
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(60, 24), 0.01);
        const CollapsedSurface surface = Surface(View(mesh), Parameters(300), {true, false});
        const SurfaceArrays& original = surface.original;
        QCOMPARE(original.VertexCount(), mesh.points.size());
        QCOMPARE(original.FaceCount(), mesh.triangles.size());
        std::size_t corners = 0;
        for (std::uint32_t v = 0; v < original.VertexCount(); ++v)
            for (std::uint32_t i = 0; i < original.cornerCount[v]; ++i, ++corners) {
                const Corner corner = original.corners[original.cornerOffset[v] + i];
                QCOMPARE(original.triangles[FaceOf(corner)].v[IndexOf(corner)], v);
            }
        QCOMPARE(corners, 3 * mesh.triangles.size());
        QCOMPARE(surface.simplified.FaceCount(), std::size_t{300});
        std::set<std::uint32_t> roots(surface.root.begin(), surface.root.end());
        QCOMPARE(roots.size(), surface.simplified.VertexCount());
    }
};

QTEST_APPLESS_MAIN(TestEngine)
#include "test_engine.moc"
