// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "surface_pairs.h"
#include "vcg_ext/core/refine/renewed_origins.h"
#include "vcg_ext/core/simplify.h"

using namespace test_meshes;
using vcg_ext::DecimatedMesh;
using vcg_ext::DecimationParameters;

namespace
{

double Apart(const std::array<double, 3>& p, const Point& q)
{
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

template <class T>
bool AscendsStrictly(const std::vector<T>& values)
{
    return std::adjacent_find(values.begin(), values.end(), [](T a, T b) { return a >= b; }) == values.end();
}

/// Flat but for waves in one corner: vertices cross it.
IndexedMesh Waves()
{
    IndexedMesh sheet = Noisy(Grid(60, 60, 1. / 6), 0.002);
    for (Point& p : sheet.points)
        if (p[0] > 5 && p[1] > 5) p[2] += .3 * std::sin(3 * p[0]) * std::sin(3 * p[1]);
    return sheet;
}

struct Farthest {
    double vertices = 0, faces = 0;
};

/// How far the result's vertices are from their origins, and its faces' nearest corners from a corner of
/// theirs.
Farthest FarthestOrigins(const IndexedMesh& mesh, const DecimatedMesh& result)
{
    Farthest farthest;
    for (std::size_t v = 0; v < result.positions.size(); ++v)
        farthest.vertices =
            std::max(farthest.vertices, Apart(result.positions[v], mesh.points[result.vertexOrigin[v]]));
    for (std::size_t f = 0; f < result.triangles.size(); ++f) {
        const Point& corner = mesh.points[mesh.triangles[result.faceOrigin[f]][0]];
        double nearest = 1e9;
        for (const std::uint32_t v : result.triangles[f])
            nearest = std::min(nearest, Apart(result.positions[v], corner));
        farthest.faces = std::max(farthest.faces, nearest);
    }
    return farthest;
}

} // namespace

class TestRenewedOrigins : public QObject
{
    Q_OBJECT

  private slots:
    void originsAreNearAndDifferent_data()
    {
        QTest::addColumn<int>("percent");
        for (const int percent : {50, 20, 5}) QTest::addRow("%d %%", percent) << percent;
    }
    void originsAreNearAndDifferent()
    {
        QFETCH(int, percent);
        const IndexedMesh mesh = Waves();
        DecimationParameters parameters;
        parameters.targetFaces = mesh.triangles.size() * static_cast<std::size_t>(percent) / 100;
        const Farthest balanced = FarthestOrigins(mesh, vcg_ext::Simplify(View(mesh), parameters).mesh);
        parameters.effort = vcg_ext::Effort::Best;
        const DecimatedMesh result = vcg_ext::Simplify(View(mesh), parameters).mesh;
        const Farthest best = FarthestOrigins(mesh, result);
        QVERIFY(AscendsStrictly(result.vertexOrigin));
        QVERIFY(AscendsStrictly(result.faceOrigin));
        // Collapses carry vertices along, too, not always as far; the sheet is 14 from corner to corner, and
        // an origin anywhere on it would be up to that far.
        QVERIFY(best.vertices < 2 * balanced.vertices);
        QVERIFY(best.faces < 2 * balanced.faces);
    }

    void whereNothingIsFreeNearbyAnythingElseIsTaken()
    {
        // Two sheets; of the first one everything is used.
        const IndexedMesh mesh = Merged(Grid(2, 2), Grid(2, 2, 3));
        const vcg_ext::MeshView view = View(mesh);
        vcg_ext::CollapsedSurface surface;
        surface.original = vcg_ext::BuildSurfaceArrays(view, vcg_ext::FrameOf(view));
        surface.vertexOrigin.Allocate(9);
        surface.faceOrigin.Allocate(8);
        for (std::uint32_t v = 0; v < 9; ++v) surface.vertexOrigin[v] = v;
        for (std::uint32_t f = 0; f < 8; ++f) surface.faceOrigin[f] = f;
        vcg_ext::FreeOrigins free(view, surface);
        QCOMPARE(free.TakeVertex(0 | vcg_ext::kFacePlace), 9U);
        QCOMPARE(free.TakeFace(vcg_ext::kNone), 8U);
        QCOMPARE(free.TakeFace(15 | vcg_ext::kFacePlace), 15U);
        free.FreeFace(3);
        QCOMPARE(free.TakeFace(0), 3U); // the only one around vertex 0's sheet
    }
};

QTEST_APPLESS_MAIN(TestRenewedOrigins)
#include "test_renewed_origins.moc"
