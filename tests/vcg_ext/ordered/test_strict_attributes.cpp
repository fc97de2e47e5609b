// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Order strict with attributes: the cheapest collapse first, by the rules that the sweeps have for seams.

#include <QtTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/decimate.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::Point;

namespace
{

DecimationParameters Target(std::size_t faces, Effort effort = Effort::Balanced)
{
    DecimationParameters parameters;
    parameters.order = Order::Strict;
    parameters.targetFaces = faces;
    parameters.effort = effort;
    parameters.threads = 1;
    parameters.measureError = false;
    return parameters;
}

/// A sheet cut into four by four charts, each with a cell of the texture to itself.
struct Patchwork {
    IndexedMesh mesh;
    std::vector<float> values;
    std::vector<std::int32_t> labels;
    CornerAttributes attributes;

    explicit Patchwork(int size, double height) : mesh(test_meshes::Grid(size, size, 1.0 / size))
    {
        attributes.kinds = {ChannelKind::Texture, ChannelKind::Texture};
        for (const auto& t : mesh.triangles) {
            double x = 0, y = 0;
            for (const std::uint32_t v : t) {
                x += mesh.points[v][0] / 3;
                y += mesh.points[v][1] / 3;
            }
            const int column = static_cast<int>(4 * x), row = static_cast<int>(4 * y);
            labels.push_back(column + 4 * row);
            for (const std::uint32_t v : t) {
                values.push_back(static_cast<float>(4 * mesh.points[v][0] + column)); // with gaps between
                values.push_back(static_cast<float>(4 * mesh.points[v][1] + row));
            }
        }
        for (Point& p : mesh.points) p[2] = height * std::sin(5 * p[0]) * std::cos(4 * p[1]);
    }
    MeshView View()
    {
        attributes.values = values.data();
        attributes.labels = labels.data();
        MeshView view = test_meshes::View(mesh);
        view.attributes = &attributes;
        return view;
    }
};

} // namespace

class TestStrictAttributes : public QObject
{
    Q_OBJECT

  private slots:
    /// Every face shows its own cell of the texture, right way up, at the place where that belongs; no chart
    /// is lost, and seams do not open.
    void chartsStayInTheirPlace()
    {
        Patchwork sheet(32, 0.1);
        for (const Effort effort : {Effort::Fast, Effort::Balanced, Effort::Best}) {
            const Simplification result = Decimate(sheet.View(), Target(300, effort));
            const DecimatedMesh& mesh = result.mesh;
            QVERIFY(mesh.triangles.size() <= 300);
            QCOMPARE(result.report.attributes->charts, std::size_t{16});
            QCOMPARE(result.report.attributes->turnedFaces, std::size_t{0});
            const auto edges =
                CountEdges(mesh.triangles.size(), [&](std::size_t f) { return mesh.triangles[f].data(); });
            QCOMPARE(edges.nonManifold, std::size_t{0});
            std::set<std::int32_t> shown;
            double squares = 0;
            for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
                const std::int32_t label = sheet.labels[mesh.faceOrigin[f]];
                const int column = label % 4, row = label / 4;
                shown.insert(label);
                for (std::size_t k = 0; k < 3; ++k) {
                    const float* uv = mesh.cornerValues.data() + 2 * (3 * f + k);
                    const double u = static_cast<double>(uv[0]) - column;
                    const double v = static_cast<double>(uv[1]) - row;
                    constexpr double kRounding = 1e-4;
                    QVERIFY(u > column - kRounding && u < column + 1 + kRounding);
                    QVERIFY(v > row - kRounding && v < row + 1 + kRounding);
                    const Point& p = mesh.positions[mesh.triangles[f][k]];
                    squares += std::pow(p[0] - u / 4, 2) + std::pow(p[1] - v / 4, 2);
                }
            }
            QCOMPARE(shown.size(), std::size_t{16});
            const double edge = std::sqrt(2.3 / 300); // of a result, on a sheet of about the area 1
            const double rms = std::sqrt(squares / static_cast<double>(3 * mesh.triangles.size()));
            QVERIFY2(rms < 0.05 * edge, qPrintable(QString("%1 of an edge").arg(rms / edge)));
        }
    }

    /// On a plane everything costs nothing but the seams, and they stay what they are.
    void flatChartsGoDownToAFew()
    {
        Patchwork sheet(16, 0);
        const Simplification result = Decimate(sheet.View(), Target(40, Effort::Fast));
        QVERIFY(result.report.targetReached);
        for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
            for (const std::uint32_t v : result.mesh.triangles[f]) {
                const std::int32_t label = sheet.labels[result.mesh.faceOrigin[f]];
                const int column = label % 4, row = label / 4;
                const Point& p = result.mesh.positions[v];
                constexpr double kRounding = 1e-4; // of single precision in the frame
                QVERIFY(std::fabs(4 * p[0] - column - 0.5) < 0.5 + kRounding);
                QVERIFY(std::fabs(4 * p[1] - row - 0.5) < 0.5 + kRounding);
            }
    }

    /// Charts hold a target up, and the report says so; where they may merge it is reached.
    void seamsHoldUpATarget()
    {
        Patchwork sheet(16, 0.1);
        auto parameters = Target(8, Effort::Fast);
        const Simplification kept = Decimate(sheet.View(), parameters);
        QCOMPARE(kept.report.stopReason, StopReason::Seams);
        QVERIFY(kept.report.faces >= 16);
        parameters.seams = Seams::Ignore;
        const Simplification ignored = Decimate(sheet.View(), parameters);
        QCOMPARE(ignored.report.stopReason, StopReason::Target);
        QVERIFY(ignored.report.faces <= 8);
    }

    /// What costs nothing goes first, all of it, before anything is taken that costs something: a hump in a
    /// corner of a flat sheet keeps all its vertices, bit by bit.
    void theCheapestGoesFirst()
    {
        Patchwork sheet(32, 0);
        const auto onHump = [](const Point& p) { return p[0] > 0.76 && p[1] > 0.76; };
        std::set<Point> hump;
        for (Point& p : sheet.mesh.points) {
            if (!onHump(p)) continue;
            p[2] = 0.05 * std::sin(40 * p[0]) * std::sin(37 * p[1]);
            hump.insert(p);
        }
        const DecimatedMesh mesh = Decimate(sheet.View(), Target(400, Effort::Fast)).mesh;
        QVERIFY(mesh.triangles.size() <= 400);
        std::size_t found = 0;
        for (const Point& p : mesh.positions) found += hump.count(p);
        QCOMPARE(found, hump.size());
    }

    /// A run may be canceled while nothing collapses: none of these tetrahedra may.
    void whatCollapsesNothingMayBeCanceled()
    {
        IndexedMesh solids;
        for (int i = 0; i < 3000; ++i) {
            const std::size_t at = solids.points.size();
            const double x = 2 * i;
            for (const Point& p : {Point{x, 0, 0}, Point{x + 1, 0, 0}, Point{x, 1, 0}, Point{x, 0, 1}})
                solids.points.push_back(p);
            solids.AddTriangle(at, at + 2, at + 1);
            solids.AddTriangle(at, at + 1, at + 3);
            solids.AddTriangle(at + 1, at + 2, at + 3);
            solids.AddTriangle(at + 2, at, at + 3);
        }
        std::vector<std::int32_t> labels(solids.triangles.size());
        for (std::size_t f = 0; f < labels.size(); ++f) labels[f] = static_cast<std::int32_t>(f / 4 % 2);
        CornerAttributes attributes;
        attributes.labels = labels.data();
        MeshView view = test_meshes::View(solids);
        view.attributes = &attributes;
        auto parameters = Target(4, Effort::Fast);
        int told = 0;
        parameters.progress = [&](int, const char* stage) {
            told += std::string(stage) == "Collapsing edges";
            return told < 2; // the first time before anything is looked at
        };
        const Simplification result = Decimate(view, parameters);
        QCOMPARE(result.report.stopReason, StopReason::Cancelled);
        parameters.progress = {};
        QCOMPARE(Decimate(view, parameters).report.faces, labels.size());
    }

    /// Threads change nothing.
    void threadsDoNotMatter()
    {
        Patchwork sheet(24, 0.1);
        auto parameters = Target(200);
        const DecimatedMesh one = Decimate(sheet.View(), parameters).mesh;
        parameters.threads = 3;
        const DecimatedMesh three = Decimate(sheet.View(), parameters).mesh;
        QVERIFY(one.positions == three.positions && one.triangles == three.triangles &&
                one.cornerValues == three.cornerValues);
    }
};

QTEST_APPLESS_MAIN(TestStrictAttributes)
#include "test_strict_attributes.moc"
