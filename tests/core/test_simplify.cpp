// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cmath>
#include <limits>
#include <string>
#include <map>
#include <set>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/simplify.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::View;

namespace
{

DecimationParameters Target(std::size_t faces, Effort effort = Effort::Balanced)
{
    DecimationParameters parameters;
    parameters.targetFaces = faces;
    parameters.effort = effort;
    parameters.threads = 1;
    return parameters;
}

std::string Refusal(const MeshView& view, const DecimationParameters& parameters)
{
    try {
        Simplify(view, parameters);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

IndexedMesh Rough()
{
    return test_meshes::Noisy(test_meshes::Torus(30, 15), 0.01);
}

} // namespace

class TestSimplify : public QObject
{
    Q_OBJECT

  private slots:
    void refusesByNameBeforeItWorks()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(1);
        QCOMPARE(Refusal(View(mesh), Target(0)), std::string("target_faces = 0 is less than 1"));
        auto parameters = Target(10);
        parameters.featureWeight = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(Refusal(View(mesh), parameters).find("feature_weight = nan is outside [0, 50]") == 0);
        parameters = Target(10);
        parameters.threads = -1;
        QCOMPARE(Refusal(View(mesh), parameters), std::string("threads = -1 is less than 0"));
        QCOMPARE(Refusal(View(IndexedMesh{}), Target(10)), std::string("the mesh has no faces"));
        IndexedMesh endless = mesh;
        endless.points[3][1] = std::numeric_limits<double>::infinity();
        QCOMPARE(Refusal(View(endless), Target(10)),
                 std::string("the coordinates of 1 of 42 vertices are not finite"));
    }

    /// What only VCG's queue can do is not replaced by something else in silence.
    void refusesWhatNeedsTheQueue()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(1);
        auto strict = Target(10);
        strict.order = Order::Strict;
        QVERIFY(Refusal(View(mesh), strict).find("vcg_ext/decimate.h") != std::string::npos);
    }

    void theReportIsAboutTheResult()
    {
        const IndexedMesh mesh = Rough();
        const auto [result, report] = Simplify(View(mesh), Target(120));
        QCOMPARE(report.facesBefore, mesh.triangles.size());
        QCOMPARE(report.faces, result.triangles.size());
        QCOMPARE(report.vertices, result.positions.size());
        QCOMPARE(report.stopReason, StopReason::Target);
        QVERIFY(report.targetReached && report.faces <= 120);
        QCOMPARE(report.edges.boundary, std::size_t{0});
        const auto values = LaplacianDescriptor(View(mesh));
        const auto measured = MeasureDistances(View(mesh), result, {values.begin(), values.end()});
        // one measures in the frame of the result, the other in that of the original: rounding
        const auto near = [](double a, double b) { return std::fabs(a - b) < 1e-9 * b; };
        QVERIFY(near(report.distances->hausdorff, measured.hausdorff));
        // and their samples come in the order of different trees: three standard errors of either
        QVERIFY(std::fabs(report.distances->rms / measured.rms - 1) < 3 * 0.01 * std::sqrt(2.0));
        // the engine's descriptor has rounded otherwise, so a few vertices at the rank of a tenth may differ
        QVERIFY(std::fabs(report.distances->featureRms / measured.featureRms - 1) < 0.02);
        QCOMPARE(report.distances->folded, measured.folded);
    }

    void theMeasurementCanBeLeftOut()
    {
        auto parameters = Target(120);
        const IndexedMesh mesh = Rough();
        const Simplification with = Simplify(View(mesh), parameters);
        parameters.measureError = false;
        const Simplification without = Simplify(View(mesh), parameters);
        QVERIFY(with.report.distances && !without.report.distances);
        QVERIFY(with.mesh.positions == without.mesh.positions);
    }

    void isBitIdenticalForAnyNumberOfThreads()
    {
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(120, 60), 0.005);
        auto parameters = Target(1500);
        const Simplification one = Simplify(View(mesh), parameters);
        for (const int threads : {2, 3, 7}) {
            parameters.threads = threads;
            const Simplification many = Simplify(View(mesh), parameters);
            QVERIFY(many.mesh.positions == one.mesh.positions);
            QVERIFY(many.mesh.triangles == one.mesh.triangles);
            QCOMPARE(many.report.distances->rms, one.report.distances->rms);
            QCOMPARE(many.report.distances->hausdorff, one.report.distances->hausdorff);
        }
    }

    /// Before and after the collapse there is enough for several threads in every loop: they take 16,384
    /// vertices or faces at a time, or fewer.
    void isBitIdenticalWhereThreadsShareEveryLoop()
    {
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(300, 150), 0.002);
        auto parameters = Target(36000);
        const Simplification one = Simplify(View(mesh), parameters);
        parameters.threads = 3;
        const Simplification many = Simplify(View(mesh), parameters);
        QVERIFY(many.mesh.positions.size() > 16384);
        QVERIFY(many.mesh.positions == one.mesh.positions);
        QVERIFY(many.mesh.triangles == one.mesh.triangles);
        QCOMPARE(many.report.distances->rms, one.report.distances->rms);
    }

    void progressRisesThroughAllStages()
    {
        const IndexedMesh mesh = Rough();
        std::vector<int> percents;
        auto parameters = Target(120);
        parameters.progress = [&](int percent, const char*) {
            percents.push_back(percent);
            return true;
        };
        Simplify(View(mesh), parameters);
        QVERIFY(std::is_sorted(percents.begin(), percents.end()));
        QVERIFY(percents.front() >= 0 && percents.back() <= 100);
        QVERIFY(percents.back() > 50); // the refinement's part
    }

    void everyStageReports_data()
    {
        QTest::addColumn<int>("effort");
        QTest::newRow("fast") << static_cast<int>(Effort::Fast);
        QTest::newRow("balanced") << static_cast<int>(Effort::Balanced);
        QTest::newRow("best") << static_cast<int>(Effort::Best);
    }
    /// Questions come after equal pieces of work: their number at a percentage is the work it stands for. No
    /// percentage stands for more than a fifth of the run (of this small one: of a million faces it is a
    /// tenth), loops report from within, none of the stages is left out, and the last ones are not crowded
    /// behind 95.
    void everyStageReports()
    {
        QFETCH(int, effort);
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(300, 150), 0.002);
        auto parameters =
            Target(mesh.triangles.size() / 3); // loops over what is left are long enough to tell
        parameters.effort = static_cast<Effort>(effort);
        parameters.threads = 1; // others would do a part of the work that is counted
        std::map<int, int> questions;
        std::set<std::string> stages;
        int all = 0, last = 0;
        std::set<int> whileRefining;
        bool rises = true;
        parameters.progress = [&](int percent, const char* stage) {
            rises = rises && percent >= last && percent <= 100;
            if (stage == std::string("Refining")) whileRefining.insert(percent);
            last = percent;
            stages.insert(stage);
            ++questions[percent];
            ++all;
            return true;
        };
        Simplify(View(mesh), parameters);
        QVERIFY(rises);
        for (const char* stage :
             {"Reading the mesh", "Computing the descriptor", "Collapsing edges", "Repairing folds",
              "Counting self-intersections", "Counting edges", "Measuring distances"})
            QVERIFY2(stages.count(stage) == 1, stage);
        QVERIFY(all > 100);
        int late = 0;
        for (const auto& [percent, count] : questions) {
            QVERIFY2(5 * count <= all,
                     qPrintable(QString("%1 %: %2 of %3").arg(percent).arg(count).arg(all)));
            if (percent >= 95) late += count;
        }
        QVERIFY(5 * late < all);
        // the stages alone report some 25, and the passes of balanced and best 4 and 8
        QVERIFY2(questions.size() >= 30, qPrintable(QString::number(questions.size())));
        const std::size_t passes = parameters.effort == Effort::Balanced ? 8 : 40;
        if (parameters.effort != Effort::Fast)
            QVERIFY2(whileRefining.size() >= passes, qPrintable(QString::number(whileRefining.size())));
    }

    /// Of a soup most questions come before anything is collapsed; the first one may be the last.
    void cleaningAsks()
    {
        IndexedMesh soup;
        const IndexedMesh mesh = test_meshes::Torus(200, 100);
        for (const auto& triangle : mesh.triangles) {
            const auto first = static_cast<std::uint32_t>(soup.points.size());
            for (const std::uint32_t v : triangle) soup.points.push_back(mesh.points[v]);
            soup.AddTriangle(first, first + 1, first + 2);
        }
        auto parameters = Target(1000);
        parameters.effort = Effort::Fast;
        parameters.threads = 1;
        const auto questionsWhileReading = [&](bool clean, int answers) {
            int questions = 0, reading = 0;
            parameters.cleanInput = clean;
            parameters.progress = [&](int, const char* stage) {
                reading += stage == std::string("Reading the mesh");
                return ++questions != answers;
            };
            const Simplification result = Simplify(View(soup), parameters);
            return std::pair{reading, result.report.stopReason};
        };
        const int withIt = questionsWhileReading(true, 0).first;
        QVERIFY(withIt >= questionsWhileReading(false, 0).first + 5);
        for (int last = 1; last <= 5; ++last)
            QVERIFY(questionsWhileReading(true, last) == (std::pair{last, StopReason::Cancelled}));
    }

    /// Wherever the answer is no, it is the last question, and nothing half-done comes back.
    void stopsAtEveryQuestion()
    {
        const IndexedMesh mesh = Rough();
        int questions = 0;
        auto parameters = Target(120);
        parameters.progress = [&](int, const char*) {
            ++questions;
            return true;
        };
        Simplify(View(mesh), parameters);
        const int all = questions;
        QVERIFY(all > 5);
        for (int last = 1; last <= all; ++last) {
            questions = 0;
            parameters.progress = [&](int, const char*) { return ++questions < last; };
            const Simplification result = Simplify(View(mesh), parameters);
            QCOMPARE(questions, last);
            QCOMPARE(result.report.stopReason, StopReason::Cancelled);
            QCOMPARE(result.report.faces, mesh.triangles.size());
            QVERIFY(result.mesh.triangles.empty());
        }
    }

    void meshOfDegenerateFacesIsRefused()
    {
        IndexedMesh segments; // faces that name a vertex twice
        segments.points = {{0, 0, 0}, {1, 0, 0}};
        segments.AddTriangle(0, 1, 1);
        for (const bool clean : {true, false}) {
            DecimationParameters parameters = Target(1);
            parameters.cleanInput = clean;
            QVERIFY_EXCEPTION_THROWN(Simplify(View(segments), parameters), std::invalid_argument);
        }
    }

    void weldingEverythingIsRefused()
    {
        DecimationParameters parameters = Target(1);
        parameters.weldDistance = 100;
        QVERIFY_EXCEPTION_THROWN(Simplify(View(test_meshes::Grid(1, 1)), parameters), std::invalid_argument);
    }
};

QTEST_APPLESS_MAIN(TestSimplify)
#include "test_simplify.moc"
