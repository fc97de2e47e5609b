// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analytic_meshes.h"
#include "vcg_ext/core/measure/exact_surface.h"

using namespace vcg_ext;

namespace
{

/// An ExactSurface with all that it needs.
struct Searched {
    test_meshes::IndexedMesh mesh;
    MeshView view;
    FaceTree tree;
    ExactSurface surface;

    explicit Searched(test_meshes::IndexedMesh source)
        : mesh(std::move(source)), view(test_meshes::View(mesh)), tree(view, FrameOf(view), 1),
          surface(view, tree, RoundingOf(view, view, tree.frame()))
    {
    }
    Searched(const Searched&) = delete;
    Searched& operator=(const Searched&) = delete;

    double BruteForce2(const Vector3<double>& p) const
    {
        double nearest2 = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < surface.FaceCount(); ++f) {
            const Vector3<double> a = surface.Corner(f, 0);
            nearest2 = std::min(
                nearest2,
                ClosestOnTriangle(p - a, surface.Corner(f, 1) - a, surface.Corner(f, 2) - a).distance2);
        }
        return nearest2;
    }
};

/// Points in and around the frame's box, and points on faces.
std::vector<Vector3<double>> Queries(const ExactSurface& surface)
{
    std::vector<Vector3<double>> points;
    for (int i = 1; i <= 300; ++i) {
        const auto coordinate = [&](double step) { return 1500 * (std::fmod(i * step, 1.0) - 0.5); };
        points.push_back({coordinate(0.8191725), coordinate(0.6710436), coordinate(0.5497005)});
        const auto f = static_cast<std::size_t>(i) % surface.FaceCount();
        points.push_back(0.25 * surface.Corner(f, 0) + 0.35 * surface.Corner(f, 1) +
                         0.4 * surface.Corner(f, 2));
        points.push_back(surface.Corner(f, 0));
    }
    return points;
}

} // namespace

class TestExactSurface : public QObject
{
    Q_OBJECT

  private slots:
    /// Single precision says where to look, double precision what is found there.
    void findsWhatLookingAtEveryFaceFinds()
    {
        auto needles = test_meshes::Noisy(test_meshes::Torus(24, 12), 0.05);
        needles.AddTriangle(0, 1, 1); // a segment
        needles.AddTriangle(5, 5, 5); // a point
        const auto far = test_meshes::Moved(test_meshes::Icosphere(3), 1, 1e-3, {1e4, -2e4, 3e4});
        test_meshes::IndexedMesh fan; // more faces at one vertex than candidates
        fan.points.push_back({0, 0, 0});
        for (std::uint32_t i = 1; i <= 300; ++i) {
            fan.points.push_back({std::cos(0.02 * i), std::sin(0.02 * i), 0.1 * std::sin(0.3 * i)});
            if (i > 1) fan.AddTriangle(0, i - 1, i);
        }
        for (const auto& mesh : {needles, far, test_meshes::Grid(9, 1), fan}) {
            const Searched searched(mesh);
            ExactSurface::Search search;
            for (const Vector3<double>& p : Queries(searched.surface)) {
                const double found2 = searched.surface.Distance2(p, search),
                             expected2 = searched.BruteForce2(p);
                QCOMPARE(found2, expected2);
            }
        }
    }

    /// The heights over needles are rounding in single precision. There is an answer all the same, and it is
    /// at most by the width of a needle too long.
    void needlesHaveADistance()
    {
        test_meshes::IndexedMesh fan;
        constexpr int kNeedles = 200;
        constexpr double kWidth = 2e-6;
        fan.points.push_back({0, 0, 0});
        for (int i = 0; i <= kNeedles; ++i) fan.points.push_back({1, kWidth * i, 1e-7 * (i % 3)});
        for (std::uint32_t i = 1; i <= kNeedles; ++i) fan.AddTriangle(0, i, i + 1);
        const Searched searched(fan);
        const double width = kWidth * searched.surface.Vertex(1).x * 2; // in the frame, more or less
        ExactSurface::Search search;
        for (int i = 0; i < 2000; ++i) {
            const double x = 900 * (std::fmod(i * 0.7548776662466927, 1.0) - 0.5);
            const Vector3<double> p{x, 1e-3 * std::fmod(i * 0.5698402909980532, 1.0), 1e-4 * (i % 7)};
            const double found = std::sqrt(searched.surface.Distance2(p, search));
            const double expected = std::sqrt(searched.BruteForce2(p));
            QVERIFY2(found >= expected && found <= expected + std::fabs(width) + 1e-3,
                     qPrintable(QString("%1 %2").arg(found).arg(expected)));
        }
    }

    void coincidingFacesAreOneSurface()
    {
        test_meshes::IndexedMesh pile;
        pile.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        for (int i = 0; i < 5000; ++i) pile.AddTriangle(0, 1, 2);
        const Searched searched(pile);
        const Vector3<double> above = searched.surface.Vertex(0) + Vector3<double>{0, 0, 3};
        ExactSurface::Search search;
        QCOMPARE(searched.surface.Distance2(above, search), 9.0);
        QCOMPARE(searched.surface.Distance2(searched.surface.Vertex(0), search), 0.0);
    }

    void aSideIsThatOfTheClosestFace()
    {
        const Searched searched(test_meshes::Grid(4, 4)); // looks up
        const Vector3<double> up{0, 0, 1}, down{0, 0, -1};
        const Vector3<double> middle = searched.surface.Vertex(12),
                              inside = middle + Vector3<double>{20, 9, 4};
        ExactSurface::Search search;
        for (const auto& p : {middle, inside}) {
            QVERIFY(!searched.surface.FacesAwayFrom(p, up, search));
            QVERIFY(searched.surface.FacesAwayFrom(p, down, search));
        }
    }

    /// Both sheets of a double wall are equally close to the middle between them; one that looks along is
    /// enough.
    void ofTwoSidesThatAreEquallyCloseOneIsEnough()
    {
        test_meshes::IndexedMesh wall;
        wall.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}};
        wall.AddTriangle(0, 1, 2);
        wall.AddTriangle(3, 5, 4);
        const Searched searched(wall);
        const auto& surface = searched.surface;
        const Vector3<double> low = (1.0 / 3) * (surface.Vertex(0) + surface.Vertex(1) + surface.Vertex(2));
        const Vector3<double> high = (1.0 / 3) * (surface.Vertex(3) + surface.Vertex(4) + surface.Vertex(5));
        const Vector3<double> up{0, 0, 1};
        ExactSurface::Search search;
        QVERIFY(!surface.FacesAwayFrom(0.5 * (low + high), up, search));
        QVERIFY(!surface.FacesAwayFrom(0.6 * low + 0.4 * high, up, search));
        QVERIFY(surface.FacesAwayFrom(0.4 * low + 0.6 * high, up, search));
    }
};

QTEST_APPLESS_MAIN(TestExactSurface)
#include "test_exact_surface.moc"
