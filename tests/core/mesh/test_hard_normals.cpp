// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From the normals that a mesh is shaded with to the seams of its hard edges.

#include <QtTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/mesh/hard_normals.h"
#include "vcg_ext/core/simplify.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::Point;

namespace
{

/// A mesh whose corners are shaded with a function of their place and of the center of their face.
struct Shaded {
    IndexedMesh mesh;
    std::vector<float> cornerNormals;

    using Normal = std::function<Point(const Point& place, const Point& center)>;

    Shaded(IndexedMesh m, const Normal& normal) : mesh(std::move(m))
    {
        for (const auto& t : mesh.triangles) {
            Point center{0, 0, 0};
            for (const std::uint32_t v : t)
                for (std::size_t k = 0; k < 3; ++k) center[k] += mesh.points[v][k] / 3;
            for (const std::uint32_t v : t)
                for (const double x : normal(mesh.points[v], center))
                    cornerNormals.push_back(static_cast<float>(x));
        }
    }
    MeshView View() const
    {
        MeshView view = test_meshes::View(mesh);
        view.cornerNormals = cornerNormals.data();
        return view;
    }
};

DecimationParameters Target(std::size_t faces, int threads = 1)
{
    DecimationParameters parameters;
    parameters.targetFaces = faces;
    parameters.threads = threads;
    parameters.measureError = false;
    return parameters;
}

Point Leaning(double degrees)
{
    constexpr double kDegree = 3.14159265358979 / 180;
    return {std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree)};
}

/// A flat sheet that is shaded as if it were bent by an angle along x = 1/2, from y = 0 to y = \p end.
Shaded BentSheet(double degrees, double end = 2)
{
    return {test_meshes::Grid(20, 20, 0.05), [=](const Point& p, const Point& center) {
                const bool onLine = std::fabs(p[0] - 0.5) < 1e-9 && p[1] < end - 1e-9;
                return Leaning(onLine ? (center[0] < 0.5 ? -degrees / 2 : degrees / 2) : 0);
            }};
}

/// The sides of every vertex of a result.
std::map<std::uint32_t, std::set<std::uint32_t>> SidesOf(const DecimatedMesh& mesh)
{
    std::map<std::uint32_t, std::set<std::uint32_t>> sides;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) sides[mesh.triangles[f][k]].insert(mesh.cornerSides[3 * f + k]);
    return sides;
}

/// Single precision in the frame of the collapse.
constexpr double kRounding = 1e-4;

} // namespace

class TestHardNormals : public QObject
{
    Q_OBJECT

  private slots:
    /// A hard edge stays where it is, though the surface is flat: no face reaches over it, and its vertices
    /// have two sides, all others one. Threads change nothing.
    void aHardEdgeIsASeam()
    {
        const Shaded sheet = BentSheet(40);
        const DecimatedMesh one = Simplify(sheet.View(), Target(40)).mesh;
        for (const int threads : {1, 2}) {
            const Simplification result = Simplify(sheet.View(), Target(40, threads));
            QVERIFY(result.mesh.positions == one.positions && result.mesh.triangles == one.triangles);
            QVERIFY(result.mesh.cornerSides == one.cornerSides);
            QVERIFY(result.mesh.triangles.size() <= 40);
            QCOMPARE(result.report.attributes->charts, std::size_t{2});
            for (const auto& t : result.mesh.triangles) {
                double least = 1, most = 0;
                for (const std::uint32_t v : t) {
                    least = std::min(least, result.mesh.positions[v][0]);
                    most = std::max(most, result.mesh.positions[v][0]);
                }
                QVERIFY(most < 0.5 + kRounding || least > 0.5 - kRounding);
            }
            for (const auto& [v, sides] : SidesOf(result.mesh)) {
                const bool onEdge = std::fabs(result.mesh.positions[v][0] - 0.5) < kRounding;
                QCOMPARE(sides.size(), std::size_t{onEdge ? 2U : 1U});
            }
        }
    }

    /// One that is smooth is none, and the run is the one without normals, byte by byte.
    void aSmoothEdgeIsNoSeam()
    {
        const Shaded sheet = BentSheet(25);
        const Simplification result = Simplify(sheet.View(), Target(40));
        QVERIFY(!result.report.attributes && result.mesh.cornerSides.empty());
        const DecimatedMesh plain = Simplify(test_meshes::View(sheet.mesh), Target(40)).mesh;
        QVERIFY(result.mesh.positions == plain.positions && result.mesh.triangles == plain.triangles);
    }

    /// A hard edge that ends within the surface still ends there: around its last vertex all is one side, on
    /// the line before it there are two. Where collapses shorten it, sides that meet become one.
    void aHardEdgeMayEnd()
    {
        const Shaded sheet = BentSheet(40, 0.5);
        const Simplification result = Simplify(sheet.View(), Target(60));
        QCOMPARE(result.report.attributes->charts, std::size_t{1});
        bool starts = false, ends = false;
        for (const auto& [v, sides] : SidesOf(result.mesh)) {
            const Point& p = result.mesh.positions[v];
            const bool onLine = std::fabs(p[0] - 0.5) < kRounding && p[1] < 0.5 - 0.05;
            QVERIFY(sides.size() == 1 || onLine);
            starts = starts || (sides.size() == 2 && p[1] < kRounding);
            ends = ends || (sides.size() == 1 && std::fabs(p[0] - 0.5) < kRounding && p[1] > kRounding);
        }
        QVERIFY(starts && ends);
    }

    /// Other seams are smooth where their normals are: on either side of that of a label the surface is the
    /// same side, also where the hard edge crosses it.
    void otherSeamsAreSmooth()
    {
        const Shaded sheet = BentSheet(40);
        std::vector<std::int32_t> labels;
        for (const auto& t : sheet.mesh.triangles) {
            double y = 0;
            for (const std::uint32_t v : t) y += sheet.mesh.points[v][1];
            labels.push_back(y > 1.5 ? 1 : 0);
        }
        CornerAttributes attributes;
        attributes.labels = labels.data();
        MeshView view = sheet.View();
        view.attributes = &attributes;
        const Simplification result = Simplify(view, Target(40));
        QCOMPARE(result.report.attributes->charts, std::size_t{4});
        std::size_t onLabels = 0;
        for (const auto& [v, sides] : SidesOf(result.mesh)) {
            const Point& p = result.mesh.positions[v];
            onLabels += std::fabs(p[1] - 0.5) < kRounding;
            QCOMPARE(sides.size(), std::size_t{std::fabs(p[0] - 0.5) < kRounding ? 2U : 1U});
        }
        QVERIFY(onLabels >= 3);
    }

    /// Vertices that were doubled for the sake of their normals meet again, and their edge is a seam.
    void doubledVerticesMakeAHardEdge()
    {
        const IndexedMesh half = test_meshes::Grid(10, 20, 0.05);
        const IndexedMesh sheet = test_meshes::Merged(half, test_meshes::Moved(half, 0, 1, {0.5, 0, 0}));
        std::vector<float> normals;
        for (std::size_t v = 0; v < sheet.points.size(); ++v)
            for (const double x : Leaning(v < half.points.size() ? -20 : 20))
                normals.push_back(static_cast<float>(x));
        MeshView view = test_meshes::View(sheet);
        view.vertexNormals = normals.data();
        const Simplification result = Simplify(view, Target(40));
        QCOMPARE(result.report.cleaning->weldedVertices, std::size_t{21});
        QCOMPARE(result.report.attributes->charts, std::size_t{2});
        for (const auto& [v, sides] : SidesOf(result.mesh)) {
            const bool onEdge = std::fabs(result.mesh.positions[v][0] - 0.5) < kRounding;
            QCOMPARE(sides.size(), std::size_t{onEdge ? 2U : 1U});
        }
    }

    /// Where every face is shaded by itself, on a surface that is rough, normals make no seams.
    void facesShadedOneByOneHaveNoHardEdges()
    {
        const Shaded rough(test_meshes::Grid(20, 20, 0.05), [](const Point&, const Point& center) {
            return Point{std::sin(997 * center[0] + 463 * center[1]), std::sin(613 * center[1]), 1};
        });
        QVERIFY(!Simplify(rough.View(), Target(200)).report.attributes);
    }

    /// Nor on one that is gently rough, where but some edges are sharp.
    void facesOfARoughSheetHaveNoHardEdges()
    {
        IndexedMesh sheet = test_meshes::Grid(20, 20, 0.05);
        for (Point& p : sheet.points) p[2] = 0.02 * std::sin(997 * p[0] + 463 * p[1]) * std::sin(613 * p[1]);
        Shaded rough(sheet, [](const Point&, const Point&) { return Point{0, 0, 1}; });
        for (std::size_t f = 0; f < sheet.triangles.size(); ++f) {
            const auto at = [&](std::size_t k) {
                const Point& p = sheet.points[sheet.triangles[f][k]];
                return Vector3<double>{p[0], p[1], p[2]};
            };
            const Vector3<double> normal = Cross(at(1) - at(0), at(2) - at(0));
            for (std::size_t k = 0; k < 3; ++k) {
                float* const n = rough.cornerNormals.data() + 9 * f + 3 * k;
                n[0] = static_cast<float>(normal.x);
                n[1] = static_cast<float>(normal.y);
                n[2] = static_cast<float>(normal.z);
            }
        }
        QVERIFY(!Simplify(rough.View(), Target(200)).report.attributes);
    }

    /// Around a vertex of very many faces all are not compared with all, and the sides are the same: those
    /// that lean left and those that lean right, all a little different, and some between, which belong to
    /// the right.
    void aHubHasItsSides()
    {
        constexpr std::uint32_t kFaces = 20000;
        IndexedMesh fan;
        fan.points.assign(kFaces + 1, {0, 0, 0});
        for (std::uint32_t i = 0; i < kFaces; ++i) fan.AddTriangle(0, i + 1, (i + 1) % kFaces + 1);
        std::vector<Vector3<float>> normals(std::size_t{3} * kFaces, {0, 0, 1});
        const auto isLeft = [](std::uint32_t i) { return i % 2 == 0; };
        for (std::uint32_t i = 0; i < kFaces; ++i) {
            const double jitter = 5 * std::sin(i), between = i % 11 == 0 ? 25 : 0;
            const Point n = Leaning(isLeft(i) ? -50 + jitter : 50 + jitter - between);
            normals[3 * std::size_t{i}] = {static_cast<float>(n[0]), 0, static_cast<float>(n[2])};
        }
        const MeshView view = test_meshes::View(fan);
        const std::vector<std::uint32_t> sides = SideFinder(view, normals).Find(1);
        QVERIFY(!sides.empty());
        for (std::uint32_t i = 0; i < kFaces; ++i) QCOMPARE(sides[3 * std::size_t{i}], isLeft(i) ? 0U : 3U);
    }

    /// Lengths of normals say nothing, though their squares are no floats.
    void normalsMayHaveAnyLength()
    {
        for (const float length : {1e-30F, 1e30F}) {
            Shaded sheet = BentSheet(40);
            for (float& x : sheet.cornerNormals) x *= length;
            QCOMPARE(Simplify(sheet.View(), Target(40)).report.attributes->charts, std::size_t{2});
        }
    }

    /// Corners without a normal, or with one that is no number, make no side of their own: not among others,
    /// and not where a vertex has no others.
    void whatIsNoNormalSaysNothing()
    {
        Shaded sheet = BentSheet(40);
        for (std::size_t f = 0; f < sheet.mesh.triangles.size(); ++f) {
            if (sheet.mesh.points[sheet.mesh.triangles[f][0]][0] > 0.3) continue;
            for (std::size_t k = 0; k < 9; ++k)
                sheet.cornerNormals[9 * f + k] = f % 2 == 0 ? 0 : std::nanf("");
        }
        const Simplification result = Simplify(sheet.View(), Target(100));
        QCOMPARE(result.report.attributes->charts, std::size_t{2});
        for (const auto& [v, sides] : SidesOf(result.mesh))
            QVERIFY(sides.size() == 1 || std::fabs(result.mesh.positions[v][0] - 0.5) < kRounding);
    }
};

QTEST_APPLESS_MAIN(TestHardNormals)
#include "test_hard_normals.moc"
