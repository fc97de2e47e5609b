// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/bound/bound_keeper.h"
#include "vcg_ext/core/bound/piece_proof.h"
#include "vcg_ext/core/bound/segment_proof.h"
#include "vcg_ext/core/simplify.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::View;

namespace
{

using Point = std::array<double, 3>;

Point Mixed(const Point& a, const Point& b, double t)
{
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}
double Squared(const Point& a, const Point& b)
{
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

double Along(const Point& p, const Point& a, const Point& b, const Point& c)
{
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (p[k] - a[k]) * (b[k] - c[k]);
    return sum;
}
double ToSegment2(const Point& p, const Point& a, const Point& b)
{
    const double length2 = Squared(a, b);
    const double t = length2 > 0 ? std::clamp(Along(p, a, b, a) / length2, 0.0, 1.0) : 0;
    return Squared(p, Mixed(a, b, t));
}
/// Squared distance to a triangle: to its three sides, and to its plane where the foot lies inside. Shares
/// nothing with the library.
double Distance2(const Point& p, const std::array<Point, 3>& t)
{
    const double best2 =
        std::min({ToSegment2(p, t[0], t[1]), ToSegment2(p, t[1], t[2]), ToSegment2(p, t[2], t[0])});
    const Point u = Mixed({0, 0, 0}, t[0], -1);
    Point e, f;
    for (std::size_t k = 0; k < 3; ++k) {
        e[k] = t[1][k] + u[k];
        f[k] = t[2][k] + u[k];
    }
    const Point n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    const double n2 = Squared(n, {0, 0, 0});
    if (!(n2 > 0)) return best2;
    const double height = Along(p, t[0], n, {0, 0, 0});
    const Point foot = Mixed(p, {p[0] - n[0], p[1] - n[1], p[2] - n[2]}, height / n2);
    for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = t[k], &b = t[(k + 1) % 3];
        const Point side{b[0] - a[0], b[1] - a[1], b[2] - a[2]},
            to{foot[0] - a[0], foot[1] - a[1], foot[2] - a[2]};
        const Point c{side[1] * to[2] - side[2] * to[1], side[2] * to[0] - side[0] * to[2],
                      side[0] * to[1] - side[1] * to[0]};
        if (c[0] * n[0] + c[1] * n[1] + c[2] * n[2] < 0) return best2;
    }
    return std::min(best2, height * height / n2);
}

using Soup = std::vector<std::array<Point, 3>>;

Soup SoupOf(const MeshView& view)
{
    Soup soup;
    for (std::size_t f = 0; f < view.faceCount; ++f) {
        const std::uint32_t* t = view.triangles + 3 * f;
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        soup.push_back({view.Position(t[0]), view.Position(t[1]), view.Position(t[2])});
    }
    return soup;
}

/// The largest distance found from points of \p from, corners and \p steps rows of each face, to \p to.
double OneSided(const Soup& from, const Soup& to, int steps)
{
    double largest2 = 0;
    for (const auto& face : from)
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const double s = i + j > 0 ? static_cast<double>(j) / (i + j) : 0;
                const Point p =
                    Mixed(face[0], Mixed(face[1], face[2], s), static_cast<double>(i + j) / steps);
                double nearest2 = std::numeric_limits<double>::infinity();
                for (const auto& other : to) {
                    double bound2 = 0; // boxes first, or this takes minutes
                    for (std::size_t k = 0; k < 3; ++k) {
                        const auto [low, high] = std::minmax({other[0][k], other[1][k], other[2][k]});
                        const double d = std::max({low - p[k], p[k] - high, 0.0});
                        bound2 += d * d;
                    }
                    if (bound2 < nearest2) nearest2 = std::min(nearest2, Distance2(p, other));
                    if (nearest2 <= largest2) break;
                }
                largest2 = std::max(largest2, nearest2);
            }
    return std::sqrt(largest2);
}

DecimationParameters Bounded(double percent, Effort effort = Effort::Fast)
{
    DecimationParameters parameters;
    parameters.targetFaces = 1;
    parameters.maxError = percent;
    parameters.effort = effort;
    parameters.threads = 1;
    parameters.measureError = false;
    return parameters;
}

double Diagonal(const IndexedMesh& mesh)
{
    return kFrameDiagonal / FrameOf(View(mesh)).scale;
}

/// Two sheets closer to each other than the bound: each must stay, or be where the other is.
IndexedMesh ParallelSheets()
{
    IndexedMesh below = test_meshes::Grid(8, 8, 0.1), above = below;
    for (auto& p : above.points) p[2] += 0.004;
    return Merged(below, above);
}
/// Long faces without width, and some without area.
IndexedMesh Needles()
{
    IndexedMesh mesh = test_meshes::Grid(12, 3, 1);
    for (auto& p : mesh.points) p = {p[0], 1e-4 * p[1], 0.01 * std::sin(3 * p[0])};
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (int i = 0; i < 3; ++i) mesh.points.push_back({1.0 * i, 2, 0}); // three points of a line
    mesh.triangles.push_back({first, first + 1, first + 2});
    return mesh;
}
IndexedMesh TinyComponents()
{
    IndexedMesh mesh = test_meshes::Box(3);
    for (int i = 0; i < 12; ++i)
        mesh = Merged(mesh, Moved(test_meshes::Icosphere(1), 0.3 * i, 0.01, {0.3 * i - 1, 1.5, 0.2 * i}));
    return mesh;
}
/// Edges as long as the mesh: their ends alone are covered by anything.
IndexedMesh LongBox()
{
    IndexedMesh mesh = test_meshes::Box(1);
    mesh = SubdividedAtMidpoints(mesh);
    for (auto& p : mesh.points) p[0] *= 20;
    return mesh;
}
/// A sheet with holes in it, which collapses might close or open.
IndexedMesh Perforated()
{
    IndexedMesh mesh = test_meshes::Grid(14, 14, 0.1);
    for (auto& p : mesh.points) p[2] = 0.05 * std::sin(4 * p[0]);
    IndexedMesh holes = mesh;
    holes.triangles.clear();
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        if (f % 23 != 5) holes.triangles.push_back(mesh.triangles[f]);
    return holes;
}
IndexedMesh WithRepeatedIndices()
{
    IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(16, 10), 0.01);
    mesh.triangles.push_back({0, 0, 40});
    mesh.triangles.push_back({7, 9, 9});
    return mesh;
}

const std::vector<std::pair<const char*, IndexedMesh>>& Meshes()
{
    static const std::vector<std::pair<const char*, IndexedMesh>> meshes = {
        {"parallel sheets", ParallelSheets()},
        {"needles", Needles()},
        {"tiny components", TinyComponents()},
        {"long box", LongBox()},
        {"holes", Perforated()},
        {"repeated indices", WithRepeatedIndices()},
        {"rough torus", test_meshes::Noisy(test_meshes::Torus(20, 10), 0.01)},
        {"thin shell", test_meshes::Shell(2, 0.02)},
        {"book", test_meshes::Book(5)},
        {"open cylinder", test_meshes::OpenCylinder(20, 10)},
    };
    return meshes;
}

} // namespace

class TestBound : public QObject
{
    Q_OBJECT

  private slots:
    /// The promise: no point of either surface is farther from the other than certified, and that is not more
    /// than was asked for.
    void noPointIsFartherThanCertified_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<double>("percent");
        QTest::addColumn<bool>("balanced");
        for (std::size_t i = 0; i < Meshes().size(); ++i)
            for (const double percent : {3.0, 0.5, 0.1})
                for (const bool balanced : {false, true})
                    QTest::addRow("%s, %g %%, %s", Meshes()[i].first, percent, balanced ? "balanced" : "fast")
                        << static_cast<int>(i) << percent << balanced;
    }
    void noPointIsFartherThanCertified()
    {
        QFETCH(int, index);
        QFETCH(double, percent);
        QFETCH(bool, balanced);
        const IndexedMesh& mesh = Meshes()[static_cast<std::size_t>(index)].second;
        const auto parameters = Bounded(percent, balanced ? Effort::Balanced : Effort::Fast);
        const Simplification result = Simplify(View(mesh), parameters);
        QVERIFY(result.report.certifiedError.has_value());
        QVERIFY(*result.report.certifiedError <= percent);
        std::vector<std::uint8_t> fixed;
        const MeshView view = ViewOf(result.mesh, View(mesh), fixed);
        const Soup before = SoupOf(View(mesh)), after = SoupOf(view);
        // a millionth, because the certificate has a frame of its own, and the rounding of doubles beside it
        const double allowed = (1.000001 * *result.report.certifiedError / 100 + 1e-14) * Diagonal(mesh);
        const double there = OneSided(before, after, 3), back = OneSided(after, before, 8);
        QVERIFY2(there <= allowed, qPrintable(QString("original %1 of %2").arg(there).arg(allowed)));
        QVERIFY2(back <= allowed, qPrintable(QString("result %1 of %2").arg(back).arg(allowed)));
    }

    /// The proof by itself, against points of the triangle by the thousand: it neither accepts what is
    /// farther nor gives up or refuses what is closer, and its counterexample is one.
    void provesWhatIsTrueAndRefutesTheRest()
    {
        constexpr int kRows = 60;
        for (unsigned seed = 1; seed <= 40; ++seed) {
            const IndexedMesh patch = test_meshes::Noisy(test_meshes::Grid(4, 4, 0.25), 0.1, seed);
            IndexedMesh roof = test_meshes::Noisy(test_meshes::Grid(1, 1), 0.2, seed + 100);
            roof.triangles.resize(1);
            const MeshView view = View(patch);
            const FaceTree tree(view, Frame{}, 1);
            const ExactSurface surface(view, tree, 1e-4F);
            const Soup to = SoupOf(View(patch)), from = SoupOf(View(roof));
            const double distance = OneSided(from, to, kRows);
            // no point is farther from the next sample than the longest side over the rows
            const double spacing = 1.8 / kRows;
            std::array<Vector3<double>, 3> triangle;
            for (std::size_t k = 0; k < 3; ++k) triangle[k] = {from[0][k][0], from[0][k][1], from[0][k][2]};
            PieceProof generous(surface, distance + spacing);
            QCOMPARE(generous.Prove(triangle), PieceProof::Result::Proven);
            QVERIFY(generous.Reached() >= distance * (1 - 1e-9));
            PieceProof strict(surface, 0.999 * distance);
            QCOMPARE(strict.Prove(triangle), PieceProof::Result::Refuted);
            const Vector3<double>& p = strict.Counterexample();
            double nearest2 = std::numeric_limits<double>::infinity();
            for (const auto& face : to) nearest2 = std::min(nearest2, Distance2({p.x, p.y, p.z}, face));
            QVERIFY(std::sqrt(nearest2) > 0.999 * distance);
        }
    }

    /// A result that lost a part is refused, and so is one that has a part too much. Both are near each other
    /// one way.
    void certifiesBothWays_data()
    {
        QTest::addColumn<bool>("lost");
        QTest::addRow("a part is lost") << true;
        QTest::addRow("a part too much") << false;
    }
    void certifiesBothWays()
    {
        QFETCH(bool, lost);
        const IndexedMesh one = test_meshes::Grid(3, 3);
        const IndexedMesh both = Merged(one, Moved(one, 0, 1, {0, 0, 1}));
        const IndexedMesh &before = lost ? both : one, &after = lost ? one : both;
        DecimatedMesh result;
        result.positions.assign(after.points.begin(), after.points.end());
        result.triangles.assign(after.triangles.begin(), after.triangles.end());
        result.vertexOrigin.assign(after.points.size(), 0);
        result.faceOrigin.assign(after.triangles.size(), 0);
        const MeshView view = View(before);
        for (const double percent : {10.0, 30.0}) { // the diagonal is 4.2 or 4.4, the parts are 1 apart
            BoundKeeper keeper(view, percent, 1);
            keeper.task.tree = std::make_unique<FaceTree>(view, FrameOf(view), 1);
            QCOMPARE(keeper.Accepts(std::vector<std::uint32_t>(view.vertexCount, kNone), result),
                     percent > 20);
            QCOMPARE(keeper.CertifiedError().has_value(), percent > 20);
        }
    }

    /// A limit below the spacing of single precision: from the one face to the other there is no way by
    /// halves.
    void segmentBetweenNeighboringNumbersEnds()
    {
        const SegmentEnd left{{0, 0, 0}, 0, 0}, right{{1, 0, 0}, 1, 0};
        const auto distance2 = [](std::uint32_t, const Vector3<float>&) { return 1.0F; };
        int calls = 0;
        const auto find = [&](const Vector3<float>& p, std::uint32_t, std::uint32_t) {
            const bool going = ++calls < 1000;
            return going ? std::make_optional(SegmentEnd{p, p.x < 0.3F ? 0U : 1U, 0}) : std::nullopt;
        };
        SegmentStack stack;
        QVERIFY(SegmentIsWithin(left, right, 1e-12F, distance2, find, stack));
    }

    /// A bound that refuses everything would be true as well.
    void usesTheBound()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(4); // 5,120 faces
        const double percent = 1;
        const Simplification result = Simplify(View(mesh), Bounded(percent));
        QCOMPARE(result.report.stopReason, StopReason::ErrorBound);
        // The best triangles of a sphere of radius r within e on both sides have a circumradius of
        // sqrt(4 r e); a mesh of such equilateral triangles has so many faces.
        const double e = percent / 100 * Diagonal(mesh), circumradius2 = 4 * e;
        const double ideal = 4 * 3.14159265 / (0.75 * std::sqrt(3.0) * circumradius2);
        // Twice as many are left (140 of 70); a bound that was used for one side only would leave four times.
        QVERIFY(static_cast<double>(result.report.faces) < 2.5 * ideal);
        QVERIFY(*result.report.certifiedError > 0.9 * percent);
    }

    /// Whichever comes first.
    void stopsAtTheTargetToo()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(3);
        auto parameters = Bounded(5);
        parameters.targetFaces = 600;
        const Simplification result = Simplify(View(mesh), parameters);
        QCOMPARE(result.report.faces, std::size_t{600});
        QCOMPARE(result.report.stopReason, StopReason::Target);
        QVERIFY(result.report.certifiedError.has_value());
    }

    void flatPartsGoCompletely()
    {
        const Simplification result = Simplify(View(test_meshes::Box(8)), Bounded(0.01));
        QCOMPARE(result.report.faces, std::size_t{12});
    }

    void sameBytesForEveryNumberOfThreads()
    {
        // five blocks of 8,192 vertices, so that they are shifted; long edges from block to block at the
        // waist
        IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(340, 124), 0.002);
        for (auto& p : mesh.points) p[0] *= p[0] > 0.5 ? 8 : 1;
        auto parameters = Bounded(0.3, Effort::Balanced);
        parameters.avoidSelfIntersections = false; // test_crossings has the threads of that
        const Simplification one = Simplify(View(mesh), parameters);
        QVERIFY(one.report.certifiedError.has_value());
        parameters.threads = 3;
        const Simplification many = Simplify(View(mesh), parameters);
        QVERIFY(one.mesh.positions == many.mesh.positions);
        QVERIFY(one.mesh.triangles == many.mesh.triangles);
        QCOMPARE(one.report.certifiedError, many.report.certifiedError);
    }

    void fixedVerticesStay()
    {
        const IndexedMesh mesh = test_meshes::Noisy(test_meshes::Torus(30, 14), 0.01);
        std::vector<std::uint8_t> fixed(mesh.points.size(), 0);
        for (std::size_t v = 0; v < fixed.size(); v += 3) fixed[v] = 1;
        MeshView view = View(mesh);
        view.fixedVertices = fixed.data();
        const Simplification result = Simplify(view, Bounded(1, Effort::Balanced));
        QVERIFY(result.report.certifiedError.has_value());
        std::size_t kept = 0;
        for (std::size_t v = 0; v < result.mesh.positions.size(); ++v) {
            const std::uint32_t origin = result.mesh.vertexOrigin[v];
            if (!fixed[origin]) continue;
            ++kept;
            QVERIFY(result.mesh.positions[v] == view.Position(origin));
        }
        QCOMPARE(kept, static_cast<std::size_t>(std::count(fixed.begin(), fixed.end(), 1)));
    }

    /// Where the caller has floats, so has the result: what is certified is what is returned.
    void floatsStayFloats()
    {
        const IndexedMesh mesh =
            Moved(test_meshes::Noisy(test_meshes::Torus(24, 12), 0.01), 0, 1, {500, 0, 0});
        std::vector<std::array<float, 3>> points;
        for (const auto& p : mesh.points)
            points.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
        MeshView view = View(mesh);
        view.positions = points.data();
        view.positionStride = sizeof points[0];
        view.doublePositions = false;
        const Simplification result = Simplify(view, Bounded(1, Effort::Balanced));
        QVERIFY(result.report.certifiedError.has_value());
        for (const auto& p : result.mesh.positions)
            for (const double x : p) QCOMPARE(static_cast<double>(static_cast<float>(x)), x);
    }

    void badBoundsAreRefusedByName()
    {
        const IndexedMesh mesh = test_meshes::Icosphere(1);
        for (const double percent : {-0.1, 100.5, std::numeric_limits<double>::quiet_NaN()}) {
            std::string said = "accepted";
            try {
                Simplify(View(mesh), Bounded(percent));
            } catch (const std::invalid_argument& error) {
                said = error.what();
            }
            QVERIFY2(said.find("max_error = ") == 0 && said.find("[0, 100]") != std::string::npos,
                     said.c_str());
        }
    }

    void noBoundPromisesNothing()
    {
        auto parameters = Bounded(0);
        parameters.targetFaces = 40;
        QVERIFY(!Simplify(View(test_meshes::Icosphere(2)), parameters).report.certifiedError.has_value());
    }
};

QTEST_APPLESS_MAIN(TestBound)
#include "test_bound.moc"
