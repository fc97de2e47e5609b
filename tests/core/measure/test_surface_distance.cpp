// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest>

#include "analytic_meshes.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/measure/surface_distance.h"

using namespace vcg_ext;

namespace
{

using Points = std::vector<std::array<double, 3>>;

std::vector<double> Distances(const test_meshes::IndexedMesh& mesh, const Points& points, int threads = 1)
{
    const MeshView view = test_meshes::View(mesh);
    return SurfaceDistance(view, threads).Of(points);
}

/// The least distance over all faces, in the mesh's own coordinates.
double ByTryingAllFaces(const test_meshes::IndexedMesh& mesh, const std::array<double, 3>& point)
{
    const auto vector = [](const auto& p) { return Vector3<double>{p[0], p[1], p[2]}; };
    double least2 = std::numeric_limits<double>::max();
    for (const auto& face : mesh.triangles) {
        const Vector3<double> a = vector(mesh.points[face[0]]);
        least2 = std::min(least2, ClosestOnTriangle(vector(point) - a, vector(mesh.points[face[1]]) - a,
                                                    vector(mesh.points[face[2]]) - a)
                                      .distance2);
    }
    return std::sqrt(least2);
}

/// Where a torus was, not a coordinate of it left: far from it, near it and between its faces.
Points AroundATorus(std::size_t count)
{
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const auto t = static_cast<double>(i);
        points.push_back({2 * std::sin(t), 2 * std::sin(1.7 * t + 1), std::sin(2.3 * t + 2)});
    }
    return points;
}

} // namespace

class TestSurfaceDistance : public QObject
{
    Q_OBJECT

  private slots:
    void isThatOfTheClosestOfAllFaces()
    {
        const auto mesh = test_meshes::Torus(24, 12);
        const Points points = AroundATorus(500);
        const std::vector<double> distances = Distances(mesh, points);
        // both are sums of a few products of numbers up to 3, in another frame
        constexpr double kRounding = 1e-13;
        for (std::size_t i = 0; i < points.size(); ++i)
            QVERIFY(std::abs(distances[i] - ByTryingAllFaces(mesh, points[i])) <= kRounding);
    }

    void isInTheUnitOfTheCoordinates()
    {
        for (const double unit : {1e-12, 1.0, 1e12}) {
            auto plane = test_meshes::Grid(4, 4, unit);
            const double distance = Distances(plane, {{1.3 * unit, 1.7 * unit, 0.25 * unit}}).front();
            QVERIFY(std::abs(distance - 0.25 * unit) <= 1e-13 * unit);
        }
    }

    void isZeroAtEveryVertexToTheBit()
    {
        auto mesh = test_meshes::Moved(test_meshes::Noisy(test_meshes::Torus(24, 12), .1), 1, 0.3, {7, 8, 9});
        Points points(mesh.points.begin(), mesh.points.end());
        for (const double distance : Distances(mesh, points)) QCOMPARE(distance, 0.0);
    }

    /// A vertex of no face may be anywhere; what single precision does there must not hide the closest face.
    void ofPointsFarFromTheMesh()
    {
        const auto mesh = test_meshes::Torus(48, 24);
        constexpr double kFar = 1e3;
        Points points = AroundATorus(500);
        for (auto& point : points)
            for (double& x : point) x *= kFar;
        const std::vector<double> distances = Distances(mesh, points);
        for (std::size_t i = 0; i < points.size(); ++i) // to some roundings of 3 kFar
            QVERIFY(std::abs(distances[i] - ByTryingAllFaces(mesh, points[i])) <= 1e-15 * 10 * kFar);
    }

    void doesNotDependOnThreads()
    {
        const auto mesh = test_meshes::Torus(24, 12);
        const Points points = AroundATorus(5000); // several ranges
        const auto one = Distances(mesh, points, 1);
        for (const int threads : {2, 3}) QVERIFY(Distances(mesh, points, threads) == one);
    }
};

QTEST_APPLESS_MAIN(TestSurfaceDistance)
#include "test_surface_distance.moc"
