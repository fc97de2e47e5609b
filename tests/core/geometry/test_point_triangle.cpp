// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "vcg_ext/core/geometry/point_triangle.h"

using vcg_ext::Float4;
using vcg_ext::Vector3;

namespace
{

Vector3<float> RandomVector(std::mt19937& random, float size)
{
    const auto number = [&] { return size * (static_cast<float>(random()) / 2147483648.0F - 1); };
    const float x = number(), y = number();
    return {x, y, number()};
}

bool Near(float a, float b, float scale)
{
    return std::abs(a - b) <= 1e-4F * scale;
}

} // namespace

class TestPointTriangle : public QObject
{
    Q_OBJECT

  private slots:
    void closestPointsInFoursAreThoseOfThePlainForm()
    {
        std::mt19937 random(1);
        for (int i = 0; i < 2000; ++i) {
            const Vector3<float> b = RandomVector(random, 1), c = RandomVector(random, 1);
            const auto prepared = vcg_ext::PrepareTriangle(b, c);
            Vector3<Float4> points{};
            std::array<Vector3<float>, 4> p;
            for (int lane = 0; lane < 4; ++lane) {
                p[static_cast<std::size_t>(lane)] = RandomVector(random, 2);
                SetLane(points, lane, p[static_cast<std::size_t>(lane)]);
            }
            const auto four = ClosestOnTriangle(points, prepared);
            for (int lane = 0; lane < 4; ++lane) {
                const Vector3<float> query = p[static_cast<std::size_t>(lane)];
                const auto one = vcg_ext::ClosestOnTriangle(query, b, c);
                QVERIFY(Near(four.distance2[lane], one.distance2, 10));
                const float* w = one.weights;
                const Vector3<float> difference = query - w[1] * b - w[2] * c;
                QVERIFY(Near(four.difference.x[lane], difference.x, 10));
                QVERIFY(Near(four.difference.y[lane], difference.y, 10));
                QVERIFY(Near(four.difference.z[lane], difference.z, 10));
                if (prepared.quality > 0.01F) QVERIFY(Near(four.originWeight[lane], w[0], 100));
                const bool inside = w[0] > 1e-3F && w[1] > 1e-3F && w[2] > 1e-3F;
                if (inside && prepared.quality > 0.01F) QVERIFY(four.inside[lane] != 0);
                const float far2 = vcg_ext::ClosestOnTriangle(query - b, c - b, c - b).distance2;
                if (w[0] == 0 && prepared.quality > 0.01F) QVERIFY(four.onFarEdge[lane] != 0);
                if (four.onFarEdge[lane]) QVERIFY(far2 < one.distance2 * 1.001F + 1e-4F);
            }
        }
    }

    /// Their dot products cancel: a point far from the needle seemed to be over it, and weights became
    /// infinite.
    void closestPointOfANeedleIsWhereItsWeightsAre()
    {
        std::mt19937 random(3);
        for (int i = 0; i < 20000; ++i) {
            const Vector3<float> b = RandomVector(random, 1);
            const float sine = std::pow(10.0F, -3 - 4 * std::abs(RandomVector(random, 1).x));
            const Vector3<float> c = b + sine * RandomVector(random, 1), p = RandomVector(random, 1);
            const auto closest = vcg_ext::ClosestOnTriangle(p, b, c);
            for (const float weight : closest.weights) QVERIFY(weight >= -1e-3F && weight <= 1 + 1e-3F);
            const float distance = Norm(p - closest.weights[1] * b - closest.weights[2] * c);
            QVERIFY2(Near(std::sqrt(closest.distance2), distance, 10), qPrintable(QString::number(distance)));
        }
    }
    void closestPointOfADegenerateTriangleIsThatOfItsLongestEdge()
    {
        const std::array<std::pair<Vector3<float>, Vector3<float>>, 4> triangles{
            {{{1, 0, 0}, {2, 0, 0}}, {{2, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {2, 0, 0}}, {{2, 0, 0}, {0, 0, 0}}}};
        for (const auto& [b, c] : triangles) {
            const auto plain = vcg_ext::ClosestOnTriangle({1.5F, 1, 0}, b, c);
            QCOMPARE(plain.distance2, 1.0F);
            const Vector3<Float4> p{vcg_ext::Splat(1.5F), vcg_ext::Splat(1.0F), vcg_ext::Splat(0.0F)};
            const auto four = ClosestOnTriangle(p, vcg_ext::PrepareTriangle(b, c));
            QCOMPARE(four.distance2[0], 1.0F);
            QVERIFY(!four.inside[0]);
        }
    }
};

QTEST_APPLESS_MAIN(TestPointTriangle)
#include "test_point_triangle.moc"
