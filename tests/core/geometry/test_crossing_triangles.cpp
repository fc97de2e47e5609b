// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "vcg_ext/core/geometry/crossing_triangles.h"

using vcg_ext::ExactPoint;
using vcg_ext::ExactTriangle;
using vcg_ext::Orientation;
using vcg_ext::TrianglesCross;

namespace
{

/// Points with integer coordinates, in which nothing is rounded, as x / w.
using Integers = vcg_ext::Vector3<std::int64_t>;
struct Rational {
    Integers x;
    std::int64_t w = 1; ///< > 0
};
using IntegerTriangle = std::array<Integers, 3>;

bool IsZero(const Integers& a)
{
    return a.x == 0 && a.y == 0 && a.z == 0;
}
Integers NormalOf(const IntegerTriangle& t)
{
    return Cross(t[1] - t[0], t[2] - t[0]);
}
bool IsInside(const Rational& p, const IntegerTriangle& t)
{
    const Integers normal = NormalOf(t);
    if (Dot(normal, p.x - p.w * t[0]) != 0) return false;
    for (std::size_t k = 0; k < 3; ++k)
        if (Dot(Cross(t[(k + 1) % 3] - t[k], p.x - p.w * t[k]), normal) < 0) return false;
    return true;
}

/// Every point that can be a corner of what the triangles have in common: their own, where edges of \p s pass
/// through the plane of \p t, and where they meet edges.
void AddCorners(const IntegerTriangle& s, const IntegerTriangle& t, std::vector<Rational>& corners)
{
    const Integers normal = NormalOf(t);
    for (std::size_t k = 0; k < 3; ++k) {
        corners.push_back({s[k]});
        const Integers along = s[(k + 1) % 3] - s[k];
        const std::int64_t slope = Dot(normal, along), height = Dot(normal, t[0] - s[k]);
        if (slope != 0) {
            const std::int64_t sign = slope > 0 ? 1 : -1;
            corners.push_back({(sign * slope) * s[k] + (sign * height) * along, sign * slope});
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const Integers edge = t[(i + 1) % 3] - t[i], across = Cross(along, edge);
            if (IsZero(across) || Dot(t[i] - s[k], across) != 0) continue;
            const std::int64_t w = Dot(across, across), u = Dot(Cross(t[i] - s[k], edge), across);
            corners.push_back({w * s[k] + u * along, w});
        }
    }
}

bool Equal(const Integers& a, const Integers& b)
{
    return IsZero(a - b);
}
/// Is the point among what shared corners span?
bool IsShared(const Rational& p, const std::vector<Integers>& shared)
{
    if (shared.size() == 1) return IsZero(p.x - p.w * shared[0]);
    if (shared.size() < 2) return false;
    const Integers along = shared[1] - shared[0], to = p.x - p.w * shared[0];
    return shared.size() == 3 ||
           (IsZero(Cross(along, to)) && Dot(along, to) >= 0 && Dot(along, to) <= p.w * Dot(along, along));
}

/// The definition of crossing, by the corners of what the triangles have in common.
bool ReallyCross(const IntegerTriangle& s, const IntegerTriangle& t)
{
    if (IsZero(NormalOf(s)) || IsZero(NormalOf(t))) return false;
    std::vector<Integers> shared;
    for (const Integers& p : s)
        if (std::any_of(t.begin(), t.end(), [&](const Integers& q) { return Equal(p, q); }))
            shared.push_back(p);
    std::vector<Rational> corners;
    AddCorners(s, t, corners);
    AddCorners(t, s, corners);
    return std::any_of(corners.begin(), corners.end(), [&](const Rational& p) {
        return IsInside(p, s) && IsInside(p, t) && !IsShared(p, shared);
    });
}

ExactTriangle AsDoubles(const IntegerTriangle& t, double scale, double shift)
{
    const auto number = [&](std::int64_t x) { return scale * static_cast<double>(x) + shift; };
    ExactTriangle exact;
    for (std::size_t k = 0; k < 3; ++k) exact[k] = {number(t[k].x), number(t[k].y), number(t[k].z)};
    return exact;
}

} // namespace

class TestCrossingTriangles : public QObject
{
    Q_OBJECT

  private slots:
    void smallestCases_data()
    {
        QTest::addColumn<QVector<double>>("s");
        QTest::addColumn<QVector<double>>("t");
        QTest::addColumn<bool>("cross");
        const QVector<double> flat = {0, 0, 0, 4, 0, 0, 0, 4, 0};
        QTest::newRow("apart") << flat << QVector<double>{0, 0, 1, 4, 0, 1, 0, 4, 1} << false;
        QTest::newRow("pierced") << flat << QVector<double>{1, 1, -1, 1, 1, 1, 9, 9, 0} << true;
        QTest::newRow("corner touches") << flat << QVector<double>{1, 1, 0, 1, 1, 1, 2, 1, 1} << true;
        QTest::newRow("corner just above")
            << flat << QVector<double>{1, 1, 1e-300, 1, 1, 1, 2, 1, 1} << false;
        QTest::newRow("in a plane, apart") << flat << QVector<double>{5, 0, 0, 9, 0, 0, 5, 4, 0} << false;
        QTest::newRow("edges in a line, just apart")
            << flat << QVector<double>{std::nextafter(4.0, 5.0), 0, 0, 8, 0, 0, 8, -4, 0} << false;
        QTest::newRow("in a plane, inside") << flat << QVector<double>{1, 1, 0, 2, 1, 0, 1, 2, 0} << true;
        QTest::newRow("in a plane, a star") << flat << QVector<double>{-1, 1, 0, 4, 1, 0, 1, -1, 0} << true;
        QTest::newRow("duplicates") << flat << QVector<double>{4, 0, 0, 0, 0, 0, 0, 4, 0} << false;
        QTest::newRow("at a corner") << flat << QVector<double>{0, 0, 0, -4, 0, 0, 0, -4, 1} << false;
        QTest::newRow("at a corner, pierced") << flat << QVector<double>{0, 0, 0, 3, 1, 1, 1, 3, -1} << true;
        QTest::newRow("at a corner, overlapping")
            << flat << QVector<double>{0, 0, 0, 4, 1, 0, 1, 4, 0} << true;
        QTest::newRow("at an edge") << flat << QVector<double>{4, 0, 0, 0, 0, 0, 0, -4, 0} << false;
        QTest::newRow("at an edge, folded nearly")
            << flat << QVector<double>{4, 0, 0, 0, 0, 0, 1, 4, 1e-12} << false;
        QTest::newRow("at an edge, folded") << flat << QVector<double>{4, 0, 0, 0, 0, 0, 1, 4, 0} << true;
        QTest::newRow("corner on a neighbor's edge")
            << flat << QVector<double>{2, 0, 0, 2, -1, 0, 3, -1, 0} << true;
        QTest::newRow("without area") << flat << QVector<double>{1, 1, -1, 1, 1, 1, 1, 1, 3} << false;
    }
    void smallestCases()
    {
        QFETCH(QVector<double>, s);
        QFETCH(QVector<double>, t);
        QFETCH(bool, cross);
        const auto triangle = [](const QVector<double>& x) {
            return ExactTriangle{{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}}};
        };
        const ExactTriangle a = triangle(s), b = triangle(t);
        for (int turn = 0; turn < 3; ++turn) {
            const auto k = static_cast<std::size_t>(turn);
            const ExactTriangle turned{a[k], a[(k + 2) % 3], a[(k + 1) % 3]};
            QCOMPARE(TrianglesCross(turned, b), cross);
            QCOMPARE(TrianglesCross(b, turned), cross);
        }
    }

    /// On a small grid nearly every pair touches, overlaps or shares something.
    void answersAreThoseOfIntegers_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("shift");
        QTest::newRow("grid of 2") << 2 << 1.0 << 0.0;
        QTest::newRow("grid of 3, far away") << 3 << std::ldexp(1.0, -30) << 1.0;
        QTest::newRow("grid of 50") << 50 << 1.0 << -25.0;
        QTest::newRow("small") << 3 << 1e-60 << 0.0;
    }
    void answersAreThoseOfIntegers()
    {
        QFETCH(int, size);
        QFETCH(double, scale);
        QFETCH(double, shift);
        std::mt19937 random(1);
        const auto number = [&] { return static_cast<std::int64_t>(random() % static_cast<unsigned>(size)); };
        int crossing = 0;
        for (int i = 0; i < 100000; ++i) {
            IntegerTriangle s, t;
            for (Integers* p : {&s[0], &s[1], &s[2], &t[0], &t[1], &t[2]})
                *p = {number(), number(), number()};
            for (std::size_t k = 0; k < random() % 4; ++k) t[k] = s[k]; // shared corners, on large grids, too
            const bool cross = ReallyCross(s, t);
            crossing += cross;
            QCOMPARE(TrianglesCross(AsDoubles(s, scale, shift), AsDoubles(t, scale, shift)), cross);
        }
        QVERIFY(crossing > 1000);
    }

    /// Needles, whose corners span so little that double precision says nothing about the side of a point.
    void orientationIsExactWhereRoundingIsLarger()
    {
        std::mt19937_64 random(2);
        const auto number = [&](std::int64_t most) {
            return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most)) - most;
        };
        const auto asDouble = [](const Integers& p) {
            return ExactPoint{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        };
        int uncertain = 0;
        for (int i = 0; i < 10000; ++i) {
            constexpr std::int64_t kFar = std::int64_t{1} << 40;
            const Integers a{number(kFar), number(kFar), number(kFar)},
                u{number(kFar), number(kFar), number(kFar)};
            const Integers v = std::int64_t{3} * u + Integers{number(9), number(9), number(9)};
            const Integers inPlane = a + std::int64_t{2} * v - std::int64_t{5} * u;
            const Integers normal = Cross(u, v - std::int64_t{3} * u);
            const ExactPoint p = asDouble(a), q = asDouble(a + u), r = asDouble(a + v);
            uncertain += vcg_ext::CertainOrientation(p, q, r, asDouble(inPlane)) == 0;
            QCOMPARE(Orientation(p, q, r, asDouble(inPlane)), 0);
            const int sign = normal.x > 0 ? 1 : normal.x < 0 ? -1 : 0;
            QCOMPARE(Orientation(p, q, r, asDouble(inPlane + Integers{1, 0, 0})), sign);
            QCOMPARE(Orientation(p, q, r, asDouble(inPlane - Integers{1, 0, 0})), -sign);
        }
        QVERIFY(uncertain > 1000);
    }

    /// Differences of coordinates that fit no double: all but the last points lie on x + y + z = 3 small.
    void differencesAreExactToo()
    {
        const double small = std::ldexp(1.0, -60);
        const ExactPoint a{small, small, small}, b{1, -1, 3 * small}, c{-2, 3 * small, 2};
        const int up = Dot(Cross(b - a, c - a), ExactPoint{1, 1, 1}) > 0 ? 1 : -1;
        QCOMPARE(Orientation(a, b, c, {2, -2, 3 * small}), 0);
        QCOMPARE(Orientation(a, b, c, {5, -2, -3}), -up);
        QCOMPARE(Orientation(a, b, c, {5, 4 * small, -5}), up);
    }
};

QTEST_APPLESS_MAIN(TestCrossingTriangles)
#include "test_crossing_triangles.moc"
