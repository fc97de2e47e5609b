// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/measure/surface_distance.h"
#include "vcg_ext/core/mesh/find_crossings.h"
#include "vcg_ext/core/simplify.h"

using namespace test_meshes;
using vcg_ext::CrossingPair;
using vcg_ext::DecimationParameters;
using vcg_ext::Effort;
using vcg_ext::Simplification;

namespace
{

std::vector<CrossingPair> CrossingsOf(const IndexedMesh& mesh, int threads = 1)
{
    const vcg_ext::MeshView view = View(mesh);
    return FindCrossings(view, vcg_ext::FaceTree(view, vcg_ext::FrameOf(view), threads), threads);
}
IndexedMesh MeshOf(const Simplification& simplification)
{
    IndexedMesh mesh;
    mesh.points = simplification.mesh.positions;
    mesh.triangles = simplification.mesh.triangles;
    return mesh;
}

/// Every two faces, one after the other.
std::vector<CrossingPair> AllPairs(const IndexedMesh& mesh)
{
    const vcg_ext::ExactFaces faces(View(mesh));
    std::vector<CrossingPair> pairs;
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
        for (std::uint32_t g = f + 1; g < mesh.triangles.size(); ++g)
            if (TrianglesCross(faces[f], faces[g])) pairs.emplace_back(f, g);
    return pairs;
}

/// Two sheets so close to each other that coarse faces of one cut through the other.
IndexedMesh TwoSheets()
{
    IndexedMesh sheet = Grid(60, 60);
    for (Point& p : sheet.points) p[2] = 4 * std::sin(p[0] / 6) * std::cos(p[1] / 7);
    return Merged(sheet, Moved(sheet, 0, 1, {0, 0, 0.3}));
}
IndexedMesh TwoSpheres(int levels)
{
    return Merged(Icosphere(levels), Moved(Icosphere(levels), 0.3, 1, {0.4, 0.1, 0}));
}
IndexedMesh Soup()
{
    std::mt19937 random(3);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
    IndexedMesh mesh;
    for (std::size_t f = 0; f < 500; ++f) {
        const Point center{number(), number(), number()};
        for (int k = 0; k < 3; ++k) {
            Point p = center;
            for (double& x : p) x += 0.2 * number();
            mesh.points.push_back(p);
        }
        mesh.AddTriangle(3 * f, 3 * f + 1, 3 * f + 2);
    }
    return mesh;
}

/// Texture coordinates for two sheets of 60 x 60: each is cut into three by three charts along edges of the
/// grid, and each chart has a square of the texture of its own, where the corners' places in the chart are.
struct Charts {
    const IndexedMesh& mesh;
    std::vector<float> values{};
    std::vector<std::int32_t> labels{};
    vcg_ext::CornerAttributes attributes{};

    explicit Charts(const IndexedMesh& sheets) : mesh(sheets)
    {
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            Point centroid{0, 0, 0};
            for (const std::uint32_t v : mesh.triangles[f])
                for (std::size_t k = 0; k < 3; ++k) centroid[k] += mesh.points[v][k] / 3;
            const int i = static_cast<int>(centroid[0] / 20), j = static_cast<int>(centroid[1] / 20);
            labels.push_back(i + 3 * j + (2 * f < mesh.triangles.size() ? 0 : 9));
            for (const std::uint32_t v : mesh.triangles[f]) {
                values.push_back(static_cast<float>(mesh.points[v][0] / 20 - i + 2 * labels.back()));
                values.push_back(static_cast<float>(mesh.points[v][1] / 20 - j));
            }
        }
        attributes.kinds = {vcg_ext::ChannelKind::Texture, vcg_ext::ChannelKind::Texture};
    }
    vcg_ext::MeshView WithTexture()
    {
        attributes.values = values.data();
        attributes.labels = labels.data();
        vcg_ext::MeshView view = View(mesh);
        view.attributes = &attributes;
        return view;
    }

    /// Does every face of the result show the part of its own square where it is, and none of them mirrored?
    /// \param apart how far the surfaces may be from each other, and so a corner from what it shows
    bool AreKept(const Simplification& result, double apart) const
    {
        for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
            const float* const uv = result.mesh.cornerValues.data() + 6 * f;
            const int label = labels[result.mesh.faceOrigin[f]];
            const int column = label % 9 % 3, row = label % 9 / 3; // of the chart
            for (std::size_t k = 0; k < 3; ++k) {
                const double u = uv[2 * k] - static_cast<float>(2 * label), v = uv[2 * k + 1];
                const Point& p = result.mesh.positions[result.mesh.triangles[f][k]];
                if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) return false;
                if (!(std::hypot(20 * (u + column) - p[0], 20 * (v + row) - p[1]) <= apart)) return false;
            }
            const float doubleArea = (uv[2] - uv[0]) * (uv[5] - uv[1]) - (uv[4] - uv[0]) * (uv[3] - uv[1]);
            if (!(doubleArea > 0)) return false;
        }
        return result.mesh.cornerValues.size() == 6 * result.mesh.triangles.size();
    }
};

/// The largest distance of the vertices, centers of edges and centroids of one mesh from the other, both
/// ways, in percent of the original's diagonal.
double LargestDistance(const IndexedMesh& original, const IndexedMesh& result)
{
    double largest = 0;
    for (const auto& [from, to] : {std::pair{&original, &result}, std::pair{&result, &original}}) {
        std::vector<Point> points;
        for (const auto& t : from->triangles) {
            const Point &a = from->points[t[0]], &b = from->points[t[1]], &c = from->points[t[2]];
            Point middle{}, centroid{};
            for (std::size_t k = 0; k < 3; ++k) {
                middle[k] = (a[k] + b[k]) / 2;
                centroid[k] = (a[k] + b[k] + c[k]) / 3;
            }
            points.insert(points.end(), {a, middle, centroid});
        }
        const vcg_ext::MeshView view = View(*to);
        const auto distances = vcg_ext::SurfaceDistance(view, 1).Of(points);
        largest = std::max(largest, *std::max_element(distances.begin(), distances.end()));
    }
    return 100 * largest / (vcg_ext::kFrameDiagonal * vcg_ext::FrameOf(View(original)).unit);
}

DecimationParameters Percent(const IndexedMesh& mesh, double percent, Effort effort)
{
    DecimationParameters parameters;
    parameters.targetFaces =
        static_cast<std::size_t>(percent / 100 * static_cast<double>(mesh.triangles.size()));
    parameters.effort = effort;
    parameters.measureError = false;
    parameters.threads = 1;
    return parameters;
}

} // namespace

Q_DECLARE_METATYPE(Effort)

class TestCrossings : public QObject
{
    Q_OBJECT

    static void AddEfforts()
    {
        QTest::addColumn<Effort>("effort");
        QTest::newRow("fast") << Effort::Fast;
        QTest::newRow("balanced") << Effort::Balanced;
    }

  private slots:
    void pairsAreThoseOfAllFaces_data()
    {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3, 7}) QTest::addRow("%d threads", threads) << threads;
    }
    void pairsAreThoseOfAllFaces()
    {
        QFETCH(int, threads);
        for (const IndexedMesh& mesh :
             {Soup(), TwoSpheres(2), Merged(Grid(9, 9), Moved(Grid(9, 9), 0, 1, {0.5, 0.25, 0}))}) {
            const auto pairs = AllPairs(mesh);
            QVERIFY(pairs.size() > 50);
            QVERIFY(CrossingsOf(mesh, threads) == pairs);
        }
    }

    /// Faces of triangle soup share corners by their coordinates alone.
    void soupOfASurfaceDoesNotCross()
    {
        const IndexedMesh sphere = Icosphere(3);
        IndexedMesh soup;
        for (const Triangle& t : sphere.triangles) {
            for (const std::uint32_t v : t) soup.points.push_back(sphere.points[v]);
            soup.AddTriangle(soup.points.size() - 3, soup.points.size() - 2, soup.points.size() - 1);
        }
        QVERIFY(CrossingsOf(soup).empty());
    }

    void noFacesCrossThatDidNotBefore_data() { AddEfforts(); }
    void noFacesCrossThatDidNotBefore()
    {
        QFETCH(Effort, effort);
        for (const IndexedMesh& mesh : {TwoSheets(), Shell(4, 0.015)}) {
            QVERIFY(CrossingsOf(mesh).empty());
            DecimationParameters parameters = Percent(mesh, 1, effort);
            const Simplification result = Simplify(View(mesh), parameters);
            QVERIFY(CrossingsOf(MeshOf(result)).empty());
            QVERIFY(result.report.selfIntersections == std::size_t{0});
            QVERIFY(result.report.targetReached);
            parameters.avoidSelfIntersections = false;
            const Simplification plain = Simplify(View(mesh), parameters);
            QVERIFY(!plain.report.selfIntersections);
            QVERIFY(!CrossingsOf(MeshOf(plain)).empty());
        }
    }

    /// Then all of the original's faces need not be searched, and nothing is collapsed twice.
    void aFewAreRepaired_data() { AddEfforts(); }
    void aFewAreRepaired()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSheets();
        // where the walls are about as far from each other as the error
        DecimationParameters parameters = Percent(mesh, effort == Effort::Fast ? 6 : 5, effort);
        const Simplification repaired = Simplify(View(mesh), parameters);
        parameters.avoidSelfIntersections = false;
        const Simplification plain = Simplify(View(mesh), parameters);
        const std::size_t crossings = CrossingsOf(MeshOf(plain)).size();
        QVERIFY2(crossings > 0 && crossings <= 20, qPrintable(QString::number(crossings)));
        QVERIFY(repaired.report.selfIntersections == std::size_t{0});
        QVERIFY(!repaired.report.selfIntersectionsBefore);
        QVERIFY(repaired.mesh.vertexOrigin == plain.mesh.vertexOrigin); // of the same collapses
    }

    void noMoreCrossThanBefore_data() { AddEfforts(); }
    void noMoreCrossThanBefore()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSpheres(4);
        const std::size_t before = CrossingsOf(mesh).size();
        for (const double percent : {50.0, 10.0, 2.0}) {
            const Simplification result = Simplify(View(mesh), Percent(mesh, percent, effort));
            QVERIFY(result.report.selfIntersections == CrossingsOf(MeshOf(result)).size());
            QVERIFY(result.report.selfIntersectionsBefore == before);
            QVERIFY(*result.report.selfIntersections > 0 && *result.report.selfIntersections <= before);
        }
    }

    void whatIsFixedStays_data() { AddEfforts(); }
    void whatIsFixedStays()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSheets();
        std::vector<std::uint8_t> fixed(mesh.points.size(), 0);
        for (std::size_t v = 0; v < fixed.size(); v += 97) fixed[v] = 1;
        vcg_ext::MeshView view = View(mesh);
        view.fixedVertices = fixed.data();
        const Simplification result = Simplify(view, Percent(mesh, 2, effort));
        QCOMPARE(CrossingsOf(MeshOf(result)).size(), std::size_t{0});
        std::size_t found = 0;
        for (std::size_t v = 0; v < result.mesh.positions.size(); ++v) {
            const std::uint32_t origin = result.mesh.vertexOrigin[v];
            if (!fixed[origin]) continue;
            ++found;
            QVERIFY(result.mesh.positions[v] == mesh.points[origin]);
        }
        QCOMPARE(found, static_cast<std::size_t>(std::count(fixed.begin(), fixed.end(), 1)));
    }

    void boundHoldsAsWell_data() { AddEfforts(); }
    void boundHoldsAsWell()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSheets();
        DecimationParameters parameters = Percent(mesh, 0.5, effort);
        parameters.maxError = 2;
        const Simplification result = Simplify(View(mesh), parameters);
        QCOMPARE(CrossingsOf(MeshOf(result)).size(), std::size_t{0});
        QVERIFY(result.report.certifiedError && *result.report.certifiedError <= 2);
        parameters.avoidSelfIntersections = false;
        QVERIFY(!CrossingsOf(MeshOf(Simplify(View(mesh), parameters))).empty());
    }

    /// What is repaired keeps its texture: flips take wedges along, and what moves stays in its square.
    void textureIsKeptWhereFacesAreRepaired_data() { AddEfforts(); }
    void textureIsKeptWhereFacesAreRepaired()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSheets();
        Charts charts(mesh);
        DecimationParameters parameters = Percent(mesh, 6, effort);
        constexpr double kApart = 2;
        const Simplification repaired = Simplify(charts.WithTexture(), parameters);
        parameters.avoidSelfIntersections = false;
        const Simplification plain = Simplify(charts.WithTexture(), parameters);
        const std::size_t crossings = CrossingsOf(MeshOf(plain)).size();
        QVERIFY2(crossings > 0 && crossings <= 20, qPrintable(QString::number(crossings)));
        QVERIFY(repaired.mesh.vertexOrigin == plain.mesh.vertexOrigin); // of the same collapses
        QVERIFY(repaired.mesh.positions != plain.mesh.positions);
        QCOMPARE(CrossingsOf(MeshOf(repaired)).size(), std::size_t{0});
        QVERIFY(charts.AreKept(repaired, kApart)); // the edges are three times as long
    }

    /// A bound, seams and no crossings at once, where the collapse has to be guarded.
    void boundAndTextureAreKept_data() { AddEfforts(); }
    void boundAndTextureAreKept()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSheets();
        Charts charts(mesh);
        DecimationParameters parameters = Percent(mesh, 1, effort);
        parameters.maxError = 2;
        const Simplification result = Simplify(charts.WithTexture(), parameters);
        QCOMPARE(CrossingsOf(MeshOf(result)).size(), std::size_t{0});
        QVERIFY(result.report.selfIntersections == std::size_t{0});
        constexpr double kApart = 20; // anywhere in the square: the faces are large, and lie off the original
        QVERIFY(charts.AreKept(result, kApart));
        QVERIFY(result.report.certifiedError && *result.report.certifiedError <= 2);
        // by another way; the certificate has a frame of its own, which rounds by less than a millionth
        QVERIFY(LargestDistance(mesh, MeshOf(result)) <= 1.000001 * *result.report.certifiedError);
        parameters.avoidSelfIntersections = false;
        QVERIFY(!CrossingsOf(MeshOf(Simplify(charts.WithTexture(), parameters))).empty());
    }

    void sameBytesForEveryNumberOfThreads_data() { AddEfforts(); }
    void sameBytesForEveryNumberOfThreads()
    {
        QFETCH(Effort, effort);
        const IndexedMesh mesh = TwoSheets();
        DecimationParameters parameters = Percent(mesh, 1, effort);
        const Simplification one = Simplify(View(mesh), parameters);
        for (const int threads : {2, 3, 7}) {
            parameters.threads = threads;
            const Simplification several = Simplify(View(mesh), parameters);
            QVERIFY(several.mesh.positions == one.mesh.positions);
            QVERIFY(several.mesh.triangles == one.mesh.triangles);
        }
    }

    /// Positions are those that the caller gets: of floats, floats.
    void floatsAreRoundedBeforeTheyAreCounted()
    {
        const IndexedMesh mesh = TwoSheets();
        std::vector<std::array<float, 3>> points;
        for (const Point& p : mesh.points)
            points.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
        vcg_ext::MeshView view = View(mesh);
        view.positions = points.data();
        view.positionStride = sizeof points[0];
        view.doublePositions = false;
        const Simplification result = Simplify(view, Percent(mesh, 1, Effort::Balanced));
        for (const auto& p : result.mesh.positions)
            for (const double x : p) QCOMPARE(static_cast<double>(static_cast<float>(x)), x);
        QCOMPARE(CrossingsOf(MeshOf(result)).size(), std::size_t{0});
    }
};

QTEST_APPLESS_MAIN(TestCrossings)
#include "test_crossings.moc"
