// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"
#include "vcg_ext/core/levels.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::View;

Q_DECLARE_METATYPE(vcg_ext::Effort)

namespace
{

DecimationParameters With(Effort effort)
{
    DecimationParameters parameters;
    parameters.effort = effort;
    parameters.threads = 1;
    parameters.measureError = false; // with its many samples the slowest part under the sanitizers
    return parameters;
}

std::vector<Level> Targets(const std::vector<std::size_t>& faces)
{
    std::vector<Level> levels;
    for (const std::size_t target : faces) levels.push_back({target, 0});
    return levels;
}

std::string Refusal(const std::vector<Level>& levels)
{
    const IndexedMesh mesh = test_meshes::Icosphere(1);
    try {
        SimplifyLevels(View(mesh), With(Effort::Fast), levels);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

bool Same(const DecimatedMesh& a, const DecimatedMesh& b)
{
    return a.positions == b.positions && a.triangles == b.triangles && a.vertexOrigin == b.vertexOrigin &&
           a.faceOrigin == b.faceOrigin && a.cornerValues == b.cornerValues;
}

/// Two sheets so close to each other that coarse faces of one cut through the other.
IndexedMesh CloseSheets()
{
    IndexedMesh sheet = test_meshes::Grid(40, 40), other = test_meshes::Grid(32, 32, 1.25);
    for (auto* grid : {&sheet, &other})
        for (auto& p : grid->points) p[2] = 3 * std::sin(p[0] / 5) * std::cos(p[1] / 6);
    return test_meshes::Merged(sheet, test_meshes::Moved(other, 0, 1, {0, 0, 0.2}));
}

/// Of the edges of a mesh how many faces each has, at most and at least.
std::pair<int, int> FacesOnEdges(const DecimatedMesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    const auto least = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [low, high] = std::minmax_element(edges.begin(), edges.end(), least);
    return {low->second, high->second};
}

/// The largest distance to the unit sphere of 15 points of every face.
double DistanceToUnitSphere(const DecimatedMesh& mesh)
{
    double largest = 0;
    for (const auto& t : mesh.triangles)
        for (int i = 0; i <= 4; ++i)
            for (int j = 0; i + j <= 4; ++j) {
                std::array<double, 3> p{};
                for (std::size_t k = 0; k < 3; ++k)
                    p[k] = (i * mesh.positions[t[0]][k] + j * mesh.positions[t[1]][k] +
                            (4 - i - j) * mesh.positions[t[2]][k]) /
                           4;
                largest = std::max(largest, std::abs(std::hypot(p[0], p[1], p[2]) - 1));
            }
    return largest;
}

} // namespace

class TestLevels : public QObject
{
    Q_OBJECT

    static void EveryEffort()
    {
        QTest::addColumn<Effort>("effort");
        QTest::newRow("fast") << Effort::Fast;
        QTest::newRow("balanced") << Effort::Balanced;
        QTest::newRow("best") << Effort::Best;
    }

  private slots:
    void firstLevelIsTheSingleRun_data() { EveryEffort(); }
    void firstLevelIsTheSingleRun()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(36, 18), 0.005);
        auto parameters = With(effort);
        const auto levels = SimplifyLevels(View(mesh), parameters, Targets({600, 150}));
        parameters.targetFaces = 600;
        const Simplification single = Simplify(View(mesh), parameters);
        QVERIFY(Same(levels[0].mesh, single.mesh));
        QCOMPARE(levels[0].report.edges.boundary, single.report.edges.boundary);
        QCOMPARE(levels[0].report.selfIntersections, single.report.selfIntersections);
    }

    /// Also of a mesh with a color and a scalar, which are scaled by what the first level asks for.
    void firstLevelWithAttributesIsTheSingleRun()
    {
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(36, 18), 0.005);
        std::vector<float> values;
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t v : t)
                for (const double x : {0.5 + mesh.points[v][0] / 4, std::sin(5 * mesh.points[v][1])})
                    values.push_back(static_cast<float>(x));
        CornerAttributes attributes;
        attributes.kinds = {ChannelKind::Color, ChannelKind::Scalar};
        attributes.values = values.data();
        MeshView view = View(mesh);
        view.attributes = &attributes;
        auto parameters = With(Effort::Fast);
        parameters.targetFaces = 7; // is not read
        const auto levels = SimplifyLevels(view, parameters, Targets({600, 150}));
        parameters.targetFaces = 600;
        QVERIFY(Same(levels[0].mesh, Simplify(view, parameters).mesh));
    }

    /// The finer levels before it cost the last one nothing: its error is that of a run of its own, within
    /// what another order of equal collapses changes.
    void lastLevelIsAsCloseAsTheSingleRun()
    {
        const IndexedMesh mesh = test_meshes::Torus(48, 24);
        auto parameters = With(Effort::Balanced);
        parameters.measureError = true;
        const auto levels = SimplifyLevels(View(mesh), parameters, Targets({1152, 576, 230}));
        parameters.targetFaces = 230;
        const double single = Simplify(View(mesh), parameters).report.distances->rms;
        QVERIFY(levels[2].report.distances->rms < 1.1 * single);
    }

    void sameBytesForAnyNumberOfThreads_data() { EveryEffort(); }
    void sameBytesForAnyNumberOfThreads()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Grid(48, 48), 0.1); // more than one block
        auto parameters = With(effort);
        const auto expected = SimplifyLevels(View(mesh), parameters, Targets({1500, 400, 90}));
        for (const int threads : {2, 3, 7}) {
            parameters.threads = threads;
            const auto levels = SimplifyLevels(View(mesh), parameters, Targets({1500, 400, 90}));
            for (std::size_t i = 0; i < levels.size(); ++i) QVERIFY(Same(levels[i].mesh, expected[i].mesh));
        }
    }

    /// The reports against counts and distances that know nothing of the library.
    void everyLevelIsWhatItsReportSays_data() { EveryEffort(); }
    void everyLevelIsWhatItsReportSays()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = test_meshes::Icosphere(4);
        auto parameters = With(effort);
        parameters.measureError = true;
        const std::vector<std::size_t> targets{2000, 500, 100};
        const auto levels = SimplifyLevels(View(mesh), parameters, Targets(targets));
        QCOMPARE(levels.size(), targets.size());
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const auto& [result, report] = levels[i];
            QVERIFY(report.targetReached);
            QVERIFY(report.faces <= targets[i] && report.faces + 2 > targets[i]); // two faces a collapse
            QCOMPARE(report.faces, result.triangles.size());
            QCOMPARE(report.vertices, result.positions.size());
            QCOMPARE(report.facesBefore, mesh.triangles.size());
            QCOMPARE(FacesOnEdges(result), std::make_pair(2, 2)); // closed
            QCOMPARE(report.distances->folded, std::size_t{0});
            QCOMPARE(*report.selfIntersections, std::size_t{0});
            // In percent of the box's diagonal. The original itself is up to .0012 off the sphere; the points
            // are not those of the report.
            const double reported = report.distances->hausdorff / 100 * 2 * std::sqrt(3.0);
            QVERIFY(std::abs(reported - DistanceToUnitSphere(result)) < 0.0015 + 0.1 * reported);
        }
        QVERIFY(levels[0].report.distances->rms < levels[1].report.distances->rms);
        QVERIFY(levels[1].report.distances->rms < levels[2].report.distances->rms);
    }

    void levelsOutOfReachSayWhy()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(2);
        const auto levels = SimplifyLevels(View(mesh), With(Effort::Balanced), Targets({100, 2, 1}));
        QCOMPARE(levels[0].report.stopReason, StopReason::Target);
        for (const std::size_t i : {1U, 2U}) {
            QCOMPARE(levels[i].report.stopReason, StopReason::NoLegalCollapse);
            QVERIFY(!levels[i].report.targetReached);
            QVERIFY(levels[i].report.faces >= 4); // a closed surface stays one
        }
        QVERIFY(Same(levels[1].mesh, levels[2].mesh));
    }

    void equalLevelsAreEqual_data() { EveryEffort(); }
    void equalLevelsAreEqual()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(24, 12), 0.005);
        const auto levels = SimplifyLevels(View(mesh), With(effort), Targets({200, 200, 60}));
        QVERIFY(Same(levels[0].mesh, levels[1].mesh));
        QVERIFY(levels[2].report.faces <= 60);
    }

    void refusesLevelsThatAreNotFromFineToCoarse()
    {
        QCOMPARE(Refusal({}), std::string("there are no levels"));
        QCOMPARE(Refusal(Targets({20, 10, 11})),
                 std::string("target_faces = 11 of level 3 is more than that of the level before it"));
        QVERIFY(Refusal({{1, 2}, {1, 1}}).find("max_error = 1.0") == 0);
        QCOMPARE(Refusal(Targets({20, 0})), std::string("target_faces = 0 is less than 1"));
        QVERIFY(Refusal({{1, 2}, {1, 101}}).find("max_error = 101") == 0);
        QCOMPARE(Refusal(Targets({20, 20})), std::string("accepted"));
    }

    /// Wherever it is stopped: before the first level is there, between two, in the last.
    void nothingRemainsOfACancelledRun_data()
    {
        QTest::addColumn<double>("maxError");
        QTest::newRow("a chain") << 0.0;
        QTest::newRow("bounds") << 3.0;
    }
    void nothingRemainsOfACancelledRun()
    {
        QFETCH(double, maxError);
        const IndexedMesh mesh = test_meshes::Torus(24, 12);
        const std::vector<Level> levels{{200, maxError}, {100, maxError}, {50, maxError}};
        auto parameters = With(Effort::Balanced);
        int calls = 0, stopAt = 0, last = 0;
        parameters.progress = [&](int percent, const char*) {
            if (percent < last || percent > 100) stopAt = -1; // it may only rise
            last = percent;
            return ++calls != stopAt;
        };
        SimplifyLevels(View(mesh), parameters, levels);
        QVERIFY(calls > 20);
        QCOMPARE(stopAt, 0);
        const int all = calls;
        for (const int at : {1, all / 2, all}) {
            calls = last = 0;
            stopAt = at;
            const auto results = SimplifyLevels(View(mesh), parameters, levels);
            QCOMPARE(calls, at); // the first no is enough
            QCOMPARE(results.size(), levels.size());
            for (const auto& [result, report] : results) {
                QCOMPARE(report.stopReason, StopReason::Cancelled);
                QCOMPARE(report.faces, mesh.triangles.size());
                QVERIFY(result.triangles.empty());
            }
        }
    }

    void noLevelHasCrossings_data() { EveryEffort(); }
    void noLevelHasCrossings()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = CloseSheets();
        auto parameters = With(effort);
        const auto crossings = [&] {
            std::vector<std::size_t> counts;
            for (const auto& level : SimplifyLevels(View(mesh), parameters, Targets({2000, 96, 60})))
                counts.push_back(CrossingKeeper(View(mesh), 1).Find(level.mesh).size());
            return counts;
        };
        QCOMPARE(crossings(), (std::vector<std::size_t>{0, 0, 0}));
        parameters.avoidSelfIntersections = false;
        QVERIFY(crossings()[1] > 0); // so the second level was collapsed again, and the third went on from it
    }

    void levelsByErrorKeepTheirBounds()
    {
        const IndexedMesh mesh = test_meshes::Torus(24, 12);
        auto parameters = With(Effort::Balanced);
        const std::vector<double> bounds{0.5, 1, 3};
        const auto levels =
            SimplifyLevels(View(mesh), parameters, {{1, bounds[0]}, {1, bounds[1]}, {1, bounds[2]}});
        for (std::size_t i = 0; i < levels.size(); ++i) {
            QCOMPARE(levels[i].report.stopReason, StopReason::ErrorBound);
            QVERIFY(*levels[i].report.certifiedError <= bounds[i]);
            if (i > 0) QVERIFY(levels[i].report.faces < levels[i - 1].report.faces);
            parameters.targetFaces = 1;
            parameters.maxError = bounds[i];
            QVERIFY(Same(levels[i].mesh, Simplify(View(mesh), parameters).mesh));
        }
    }

    /// A soup is welded once; its levels name the faces of the soup.
    void cleanedInputIsNamedAsItCame()
    {
        const IndexedMesh closed = test_meshes::Torus(24, 12);
        IndexedMesh soup;
        soup.triangles.push_back({0, 0, 1}); // degenerate: all other faces are one place later
        for (const auto& triangle : closed.triangles) {
            const auto first = static_cast<std::uint32_t>(soup.points.size());
            for (const auto v : triangle) soup.points.push_back(closed.points[v]);
            soup.triangles.push_back({first, first + 1, first + 2});
        }
        const auto levels = SimplifyLevels(View(soup), With(Effort::Fast), Targets({200, 50}));
        const auto expected = SimplifyLevels(View(closed), With(Effort::Fast), Targets({200, 50}));
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const auto& [result, report] = levels[i];
            QCOMPARE(report.facesBefore, soup.triangles.size());
            QCOMPARE(report.cleaning->degenerateFaces, std::size_t{1});
            QCOMPARE(result.faceOrigin.size(), expected[i].mesh.faceOrigin.size());
            QVERIFY(result.faceOrigin[0] > 0 && result.faceOrigin.back() < soup.triangles.size());
            QCOMPARE(FacesOnEdges(result), std::make_pair(2, 2));
        }
    }

    /// Every level has values at its corners: here x and y, which are those of the positions on a flat sheet.
    void attributesReachEveryLevel()
    {
        const IndexedMesh mesh = test_meshes::Grid(20, 20);
        std::vector<float> values;
        for (const auto& t : mesh.triangles)
            for (const auto v : t)
                for (std::size_t k = 0; k < 2; ++k) values.push_back(static_cast<float>(mesh.points[v][k]));
        CornerAttributes attributes;
        attributes.values = values.data();
        attributes.kinds = {ChannelKind::Scalar, ChannelKind::Scalar};
        MeshView view = View(mesh);
        view.attributes = &attributes;
        for (const auto& [result, report] :
             SimplifyLevels(view, With(Effort::Balanced), Targets({200, 40}))) {
            QCOMPARE(result.cornerValues.size(), 6 * result.triangles.size());
            for (std::size_t f = 0; f < result.triangles.size(); ++f)
                for (std::size_t k = 0; k < 6; ++k) {
                    const double is = static_cast<double>(result.cornerValues[6 * f + k]);
                    const double should = result.positions[result.triangles[f][k / 2]][k % 2];
                    QVERIFY(std::abs(is - should) < 0.01); // of 20; single precision, a fit by least squares
                }
            QCOMPARE(report.attributes->turnedFaces, std::size_t{0});
        }
    }
};

QTEST_APPLESS_MAIN(TestLevels)
#include "test_levels.moc"
