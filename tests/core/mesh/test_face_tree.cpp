// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/face_tree.h"

using namespace test_meshes;
using vcg_ext::FaceTree;
using vcg_ext::SurfaceArrays;
using vcg_ext::Vector3;

namespace
{

constexpr float kFar = std::numeric_limits<float>::max();

/// What a tree answers, by every face.
struct Truth {
    float along2 = kFar, away2 = kFar;
};
Truth MeasureAll(const SurfaceArrays& surface, const Vector3<float>& p, const Vector3<float>& direction)
{
    Truth truth;
    for (std::uint32_t f = 0; f < surface.FaceCount(); ++f) {
        const auto& v = surface.triangles[f].v;
        const Vector3<float> a = PositionOf(surface, v[0]);
        const float d2 =
            vcg_ext::ClosestOnTriangle(p - a, PositionOf(surface, v[1]) - a, PositionOf(surface, v[2]) - a)
                .distance2;
        float& side = Dot(AreaVector(surface, f), direction) < 0 ? truth.away2 : truth.along2;
        side = std::min(side, d2);
    }
    return truth;
}

/// The least absolute cosine between a face's normal and \p direction.
float LeastSlope(const SurfaceArrays& surface, const Vector3<float>& direction)
{
    float least = 1;
    for (std::uint32_t f = 0; f < surface.FaceCount(); ++f) {
        const Vector3<float> normal = AreaVector(surface, f);
        if (Norm(normal) > 0) least = std::min(least, std::abs(Dot(normal, direction)) / Norm(normal));
    }
    return least;
}

} // namespace

class TestFaceTree : public QObject
{
    Q_OBJECT

  private slots:
    /// Also where the only wanted faces are far away, behind many that are not.
    void closestOfSomeFaces()
    {
        const IndexedMesh mesh = Noisy(Icosphere(3), 0.05);
        const auto frame = vcg_ext::FrameOf(View(mesh));
        const SurfaceArrays surface = vcg_ext::BuildSurfaceArrays(View(mesh), frame);
        const FaceTree tree(View(mesh), frame, 1);
        for (const std::uint32_t only : {0u, 700u, 1279u})
            for (const float limit2 : {kFar, 1e4F}) {
                const auto wanted = [&](std::uint32_t f) { return f == only || f == only / 2; };
                for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
                    const Vector3<float> p = 1.1F * PositionOf(surface, v);
                    const float a2 = tree.Distance2ToFace(only, p), b2 = tree.Distance2ToFace(only / 2, p);
                    const auto found = tree.ClosestWanted(p, limit2, wanted);
                    if (std::min(a2, b2) > 1.001F * limit2) QVERIFY(!(found.distance2 < kFar));
                    if (std::min(a2, b2) < 0.999F * limit2) {
                        QVERIFY(wanted(found.face));
                        // four lanes at a time round in another order
                        QVERIFY(std::abs(found.distance2 - std::min(a2, b2)) <= 1e-4F * found.distance2);
                    }
                }
            }
    }

    void answersAsEveryFaceMeasured()
    {
        for (const IndexedMesh& mesh : {Noisy(Icosphere(3), 0.05), Shell(2, 0.03), Box(1), Grid(1, 1)}) {
            const auto frame = vcg_ext::FrameOf(View(mesh));
            const SurfaceArrays surface = vcg_ext::BuildSurfaceArrays(View(mesh), frame);
            const FaceTree tree(View(mesh), frame, 2);
            std::mt19937 random(7);
            std::normal_distribution<float> gauss;
            for (int i = 0; i < 400; ++i) {
                const auto vector = [&] {
                    return Vector3<float>{gauss(random), gauss(random), gauss(random)};
                };
                const Vector3<float> p = 300.0F * vector(), towards = vector();
                const Vector3<float> direction = (1 / Norm(towards)) * towards;
                const Truth truth = MeasureAll(surface, p, direction);
                const float nearest2 = std::min(truth.along2, truth.away2);
                // single precision at distances of hundreds: a few units in the seventh digit of 300^2
                const auto close = [](float a, float b) { return std::abs(a - b) <= 1e-4F * b + 0.01F; };
                QVERIFY(close(tree.Distance2(p), nearest2));
                QVERIFY(close(SquaredNorm(tree.Closest(p) - p), nearest2));
                if (truth.along2 < kFar)
                    QVERIFY(close(tree.DistanceAlong2(p, direction), truth.along2));
                else
                    QVERIFY(!(tree.DistanceAlong2(p, direction) < kFar));
                // a reach twice as far as a face that faces away, or half as far as the nearest of them
                if (truth.away2 < kFar) QVERIFY(tree.MayFaceAway(p, direction, 4 * truth.away2));
                const bool mayAway = tree.MayFaceAway(p, direction, truth.away2 / 4);
                // a face that is seen from its edge, up to rounding, may count as one that faces away
                QVERIFY(!mayAway || LeastSlope(surface, direction) < 2e-3F);
                // within a thousandth it may be an edge of both sides, and either answer is right
                if (std::abs(truth.along2 - truth.away2) <= 1e-3F * nearest2) continue;
                const bool away = truth.away2 < truth.along2;
                QCOMPARE(tree.FacesAwayFrom(p, direction), away);
                if (truth.along2 < kFar) QCOMPARE(tree.FacesAwayFrom(p, direction, 4 * truth.along2), away);
            }
        }
    }

    void findsWhatIsInABox()
    {
        const IndexedMesh mesh = Grid(16, 16);
        const auto frame = vcg_ext::FrameOf(View(mesh));
        const SurfaceArrays surface = vcg_ext::BuildSurfaceArrays(View(mesh), frame);
        const FaceTree tree(View(mesh), frame, 1);
        const vcg_ext::Box3<float> box{{-100, 20, -1}, {-50, 90, 1}};
        const auto [low, high] = box;
        std::vector<int> visits(mesh.triangles.size(), 0);
        tree.ForEachNear(box, [&](std::uint32_t f, const Vector3<float>& a, const Vector3<float>& ab,
                                  const Vector3<float>&) {
            ++visits[f];
            QVERIFY(Norm(a - PositionOf(surface, surface.triangles[f].v[0])) < 1e-3F);
            QVERIFY(Norm(a + ab - PositionOf(surface, surface.triangles[f].v[1])) < 1e-3F);
        });
        for (std::uint32_t f = 0; f < visits.size(); ++f) {
            const Vector3<float> c = Centroid(surface, f);
            const bool inside = c.x > low.x && c.x < high.x && c.y > low.y && c.y < high.y;
            const bool far =
                c.x < low.x - 200 || c.x > high.x + 200 || c.y < low.y - 200 || c.y > high.y + 200;
            QVERIFY(visits[f] <= 1 && (visits[f] == 1 || !inside) && (visits[f] == 0 || !far));
        }
    }
};

QTEST_APPLESS_MAIN(TestFaceTree)
#include "test_face_tree.moc"
