// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/simplify.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;

namespace
{

constexpr double kRatio = 16; ///< of the costs of a mesh that is twice as large

/// Two waves across a square, so that costs differ.
IndexedMesh Relief(double size = 1)
{
    constexpr std::uint32_t kSide = 40;
    IndexedMesh mesh;
    for (std::uint32_t j = 0; j < kSide; ++j)
        for (std::uint32_t i = 0; i < kSide; ++i) {
            const double x = i / 6.0, y = j / 6.0;
            mesh.points.push_back({size * x, size * y, size * std::sin(x) * std::cos(1.7 * y)});
        }
    for (std::uint32_t j = 0; j + 1 < kSide; ++j)
        for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
            const std::uint32_t v = j * kSide + i;
            mesh.triangles.push_back({v, v + 1, v + kSide + 1});
            mesh.triangles.push_back({v, v + kSide + 1, v + kSide});
        }
    return mesh;
}

MeshView ViewOf(const IndexedMesh& mesh)
{
    MeshView view;
    view.positions = mesh.points.data();
    view.positionStride = sizeof mesh.points[0];
    view.doublePositions = true;
    view.vertexCount = mesh.points.size();
    view.triangles = mesh.triangles.front().data();
    view.faceCount = mesh.triangles.size();
    return view;
}

DecimationParameters Parameters(std::size_t target)
{
    DecimationParameters parameters;
    parameters.targetFaces = target;
    parameters.effort = Effort::Fast;
    parameters.measureError = false;
    return parameters;
}

Simplification WithLimit(const IndexedMesh& mesh, double limit)
{
    DecimationParameters parameters = Parameters(1);
    parameters.costLimit = limit;
    return Simplify(ViewOf(mesh), parameters);
}

using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Edges between two vertices of the input that are fixed. \param original original(v) is the input vertex
template <class Original>
Edges FixedEdges(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                 const std::vector<std::uint8_t>& fixed, const Original& original)
{
    Edges edges;
    for (const auto& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = original(triangle[k]), b = original(triangle[(k + 1) % 3]);
            if (fixed[a] && fixed[b]) edges.insert(std::minmax(a, b));
        }
    return edges;
}

/// Those between fixed vertices that the input did not have.
std::size_t NewFixedEdges(const IndexedMesh& mesh, const std::vector<std::uint8_t>& fixed, bool sharedSeams,
                          Effort effort)
{
    MeshView view = ViewOf(mesh);
    view.fixedVertices = fixed.data();
    view.sharedSeams = sharedSeams;
    DecimationParameters parameters = Parameters(1);
    parameters.effort = effort;
    const DecimatedMesh result = Simplify(view, parameters).mesh;
    const Edges before = FixedEdges(mesh.triangles, fixed, [](std::uint32_t v) { return v; });
    const Edges after =
        FixedEdges(result.triangles, fixed, [&](std::uint32_t v) { return result.vertexOrigin[v]; });
    return static_cast<std::size_t>(
        std::count_if(after.begin(), after.end(), [&](const auto& edge) { return before.count(edge) == 0; }));
}

} // namespace

class TestSchedule : public QObject
{
    Q_OBJECT

  private slots:
    void theTraceHasEverySweep()
    {
        const Simplification result = Simplify(ViewOf(Relief()), Parameters(300));
        const auto& steps = result.report.trace.steps;
        QVERIFY(steps.size() > 2);
        QCOMPARE(steps.back().faces, result.report.faces);
        for (std::size_t i = 1; i < steps.size(); ++i) QVERIFY(steps[i].faces <= steps[i - 1].faces);
        QVERIFY(result.report.trace.descriptorScale > 0);
    }

    void aLimitOfTheCostEndsTheRun()
    {
        const auto steps = Simplify(ViewOf(Relief()), Parameters(300)).report.trace.steps;
        const double limit = steps[steps.size() / 2].cost;
        const Simplification result = WithLimit(Relief(), limit);
        QCOMPARE(result.report.stopReason, StopReason::ErrorBound);
        QVERIFY(result.report.faces > 300);
        QVERIFY(result.report.faces < Relief().triangles.size());
        // The limit and the costs are rounded to float in the frame, and come back as double.
        for (const auto& step : result.report.trace.steps) QVERIFY(step.cost <= limit * (1 + 1e-6));
    }

    void aHigherLimitLeavesFewerFaces()
    {
        const auto steps = Simplify(ViewOf(Relief()), Parameters(100)).report.trace.steps;
        const double limit = steps[steps.size() / 2].cost;
        QVERIFY(WithLimit(Relief(), 4 * limit).report.faces < WithLimit(Relief(), limit).report.faces);
    }

    void aLimitFarAwayChangesNothing()
    {
        const Simplification free = Simplify(ViewOf(Relief()), Parameters(300));
        DecimationParameters parameters = Parameters(300);
        parameters.costLimit = 1000 * free.report.trace.steps.back().cost;
        const Simplification limited = Simplify(ViewOf(Relief()), parameters);
        QCOMPARE(limited.report.stopReason, StopReason::Target);
        QVERIFY(limited.mesh.positions == free.mesh.positions);
        QVERIFY(limited.mesh.triangles == free.mesh.triangles);
    }

    /// A power of two as the factor, so that no rounding differs.
    void theLimitIsALengthToTheFourthPower()
    {
        const auto steps = Simplify(ViewOf(Relief()), Parameters(300)).report.trace.steps;
        const double limit = steps[steps.size() / 2].cost;
        const Simplification small = WithLimit(Relief(), limit), large = WithLimit(Relief(2), kRatio * limit);
        QVERIFY(small.mesh.triangles == large.mesh.triangles);
        QCOMPARE(large.report.trace.steps.back().cost, kRatio * small.report.trace.steps.back().cost);
    }

    void theDescriptorsScaleCanBeGiven()
    {
        const Simplification own = Simplify(ViewOf(Relief()), Parameters(300));
        DecimationParameters parameters = Parameters(300);
        parameters.descriptorScale = own.report.trace.descriptorScale;
        const Simplification given = Simplify(ViewOf(Relief()), parameters);
        QVERIFY(given.mesh.positions == own.mesh.positions);
        parameters.descriptorScale = 0.1 * own.report.trace.descriptorScale;
        const Simplification other = Simplify(ViewOf(Relief()), parameters);
        QCOMPARE(other.report.trace.descriptorScale,
                 static_cast<double>(static_cast<float>(parameters.descriptorScale)));
        QVERIFY(other.mesh.positions != own.mesh.positions);
    }

    /// Every third vertex is fixed, so that there are many pairs with one vertex between them.
    void sharedSeamsGetNoNewEdges()
    {
        const IndexedMesh mesh = Relief();
        std::vector<std::uint8_t> fixed(mesh.points.size(), 0);
        for (std::size_t v = 0; v < fixed.size(); v += 3) fixed[v] = 1;
        for (const Effort effort : {Effort::Fast, Effort::Balanced}) {
            QVERIFY(NewFixedEdges(mesh, fixed, false, effort) > 0);
            QCOMPARE(NewFixedEdges(mesh, fixed, true, effort), std::size_t{0});
        }
    }

    void aLimitBelowZeroIsRefused()
    {
        QVERIFY_EXCEPTION_THROWN(WithLimit(Relief(), -1), std::invalid_argument);
        DecimationParameters parameters = Parameters(300);
        parameters.descriptorScale = std::numeric_limits<double>::quiet_NaN();
        QVERIFY_EXCEPTION_THROWN(Simplify(ViewOf(Relief()), parameters), std::invalid_argument);
    }
};

QTEST_APPLESS_MAIN(TestSchedule)
#include "test_schedule.moc"
