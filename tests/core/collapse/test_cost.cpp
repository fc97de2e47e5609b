// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <random>
#include <utility>

#include "vcg_ext/core/collapse/cost.h"

using namespace vcg_ext;
using namespace vcg_ext;

namespace
{

constexpr float kPi = 3.14159265f;

/// Random numbers that are the same on every run.
class Numbers
{
    std::mt19937 generator_{7};
    std::uniform_real_distribution<float> distribution_{-1, 1};

  public:
    float Next() { return distribution_(generator_); }
    Vector3<float> NextVector() { return {Next(), Next(), Next()}; }
    /// The quadric of \p faces faces around a vertex.
    SymmetricMatrix3<float> NextStar(int faces)
    {
        SymmetricMatrix3<float> sum{};
        for (int i = 0; i < faces; ++i) sum = sum + OuterProduct(NextVector());
        return sum;
    }
    EdgeEnd<float> NextEnd()
    {
        const Vector3<float> position = NextVector();
        const float weight = 2 + Next();
        const SymmetricMatrix3<float> star = NextStar(6);
        return {position, weight, star, {NextStar(9), NextVector(), 3 + Next()}};
    }
};

template <class Real>
Vector3<Real> As(const Vector3<float>& a)
{
    return {Real{} + a.x, Real{} + a.y, Real{} + a.z};
}
template <class Real>
SymmetricMatrix3<Real> As(const SymmetricMatrix3<float>& m)
{
    return {Real{} + m.xx, Real{} + m.xy, Real{} + m.xz, Real{} + m.yy, Real{} + m.yz, Real{} + m.zz};
}
template <class Real>
EdgeEnd<Real> As(const EdgeEnd<float>& end)
{
    return {As<Real>(end.position),
            Real{} + end.weight,
            As<Real>(end.star),
            {As<Real>(end.history.matrix), As<Real>(end.history.linear), Real{} + end.history.constant}};
}

template <class Real>
struct PlacedEdge {
    Vector3<Real> offset;
    Real cost;
};
template <class Real>
PlacedEdge<Real> Place(const EdgeEnd<float>& a, const EdgeEnd<float>& b)
{
    const EdgeEnd<Real> first = As<Real>(a), second = As<Real>(b);
    const Vector3<Real> half = HalfEdgeVector(first, second);
    const Vector3<Real> offset = OptimalOffset(first, second, half);
    constexpr float kArea = 0.7f;
    return {offset, EdgeCost(first, second, half, offset, Real{} + kArea)};
}

bool Near(double a, double b, double relative)
{
    return std::abs(a - b) <= relative * std::max({1.0, std::abs(a), std::abs(b)});
}

/// An edge of length 2 in the plane z = 0, with stars of \p doubleArea there.
std::pair<EdgeEnd<float>, EdgeEnd<float>> FlatEdge(float doubleArea)
{
    const SymmetricMatrix3<float> plane{0, 0, 0, 0, 0, doubleArea};
    EdgeEnd<float> a{{0, 0, 0}, 1, plane, {plane, {}, 0}};
    EdgeEnd<float> b = a;
    b.position = {2, 0, 0};
    return {a, b};
}

/// The two other corners of a face at the origin that is turned by \p degrees about the x axis.
void TurnedFace(float degrees, Vector3<float>& a, Vector3<float>& b)
{
    const float angle = degrees * kPi / 180;
    a = {1, 0, 0};
    b = {0, std::cos(angle), std::sin(angle)};
}

} // namespace

class TestCost : public QObject
{
    Q_OBJECT

  private slots:
    void fourLanesDoWhatOneNumberDoes()
    {
        Numbers numbers;
        for (int i = 0; i < 200; ++i) {
            const EdgeEnd<float> a = numbers.NextEnd(), b = numbers.NextEnd();
            const PlacedEdge<float> one = Place<float>(a, b);
            const PlacedEdge<Float4> four = Place<Float4>(a, b);
            for (int lane = 0; lane < kLanes; ++lane) {
                QVERIFY(Near(one.offset.x, four.offset.x[lane], 1e-6));
                QVERIFY(Near(one.offset.y, four.offset.y[lane], 1e-6));
                QVERIFY(Near(one.offset.z, four.offset.z[lane], 1e-6));
                QVERIFY(Near(one.cost, four.cost[lane], 1e-6));
            }
        }
    }

    void floatIsDoubleWithinItsRounding()
    {
        Numbers numbers;
        for (int i = 0; i < 200; ++i) {
            const EdgeEnd<float> a = numbers.NextEnd(), b = numbers.NextEnd();
            const PlacedEdge<float> one = Place<float>(a, b);
            const PlacedEdge<double> exact = Place<double>(a, b);
            QVERIFY(Near(one.cost, exact.cost, 1e-4)); // stars of 6 random planes: condition up to 1e3
        }
    }

    void aPlacementIsWhereTheQuadricIsLowest()
    {
        Numbers numbers;
        for (int i = 0; i < 100; ++i) {
            const EdgeEnd<double> a = As<double>(numbers.NextEnd()), b = As<double>(numbers.NextEnd());
            const Vector3<double> half = HalfEdgeVector(a, b);
            const auto stars = [&](const Vector3<double>& offset) {
                return QuadraticForm(a.weight * a.star, offset + half) +
                       QuadraticForm(b.weight * b.star, offset - half);
            };
            const Vector3<double> best = OptimalOffset(a, b, half);
            const double lowest = stars(best);
            for (int k = 0; k < 20; ++k) {
                const Vector3<double> step = 0.05 * As<double>(numbers.NextVector());
                QVERIFY(stars(best + step) >= lowest * (1 - 1e-4)); // the pull to the midpoint costs 1e-6
            }
        }
    }

    void flatStarsPlaceInTheMiddleOfTheEdge()
    {
        EdgeEnd<float> a{{0, 0, 0}, 1, OuterProduct(Vector3<float>{0, 0, 1}), {}};
        EdgeEnd<float> b = a;
        b.position = {2, 0, 0};
        const PlacedEdge<float> placed = Place<float>(a, b);
        QCOMPARE(placed.offset.x, 0.0f);
        QCOMPARE(placed.offset.y, 0.0f);
        QCOMPARE(placed.offset.z, 0.0f);
        QCOMPARE(placed.cost, 0.0f);
    }

    void starsWithoutAreaPlaceInTheMiddleToo()
    {
        const EdgeEnd<float> a{{0, 0, 0}, 1, {}, {}}, b{{1, 1, 1}, 1, {}, {}};
        const PlacedEdge<float> placed = Place<float>(a, b);
        QCOMPARE(Dot(placed.offset, placed.offset), 0.0f);
        QVERIFY(std::isfinite(placed.cost));
    }

    void aQuadricKeepsItsValuesWhenItsCentreMoves()
    {
        Numbers numbers;
        for (int i = 0; i < 50; ++i) {
            const CentredQuadric<double> q = As<double>(numbers.NextEnd()).history;
            const Vector3<double> shift = As<double>(numbers.NextVector()),
                                  d = As<double>(numbers.NextVector());
            if (q(shift) < 0) continue; // such a constant is set to 0
            QVERIFY(Near(Recentred(q, shift)(d), q(shift + d), 1e-12));
        }
    }

    void theVolumePlaneDecidesWhereTheStarsDoNot()
    {
        // Two stars that know only the directions x and y leave z to the plane G.t = (G_b - G_a).half.
        const SymmetricMatrix3<double> vertical{1, 0, 0, 1, 0, 0};
        const EdgeEnd<double> a{{0, 0, 0}, 1, vertical, {}}, b{{1, 0, 0.5}, 1, vertical, {}};
        const Vector3<double> half = HalfEdgeVector(a, b);
        const StarAreas<double> areas{{0, 0, 2}, {0, 0, 3}, {}, 6};
        const Vector3<double> offset = VolumeAwareOffset(a, b, half, areas);
        QVERIFY(Near(offset.z, (3 - 2) * half.z / 5, 1e-5));
    }

    void aFaceMayTurnBySeventySevenDegreesButNotBySeventyNine()
    {
        const Vector3<float> before{0, 0, 2};
        Vector3<float> a, b;
        for (const float degrees : {0.0f, 45.0f, 77.0f, 79.0f, 90.0f, 120.0f, 180.0f}) {
            TurnedFace(degrees, a, b);
            QCOMPARE(bool(TurnedTooFar(MoveFace(a, b), before)), degrees > 78);
        }
    }

    void anErrorOfRoundingCostsNoMoreThanItsBound()
    {
        for (const float distanceArea : {0.0f, 50.0f}) {
            const auto [a, b] = FlatEdge(9);
            const Vector3<float> half = HalfEdgeVector(a, b);
            const float bound = RoundingCost(a, b, distanceArea);
            QVERIFY(EdgeCost(a, b, half, {0, 0, 0.99f * kNoDistance}, distanceArea) < bound);
            QVERIFY(EdgeCost(a, b, half, {0, 0, 1.01f * kNoDistance}, distanceArea) > bound);
        }
    }

    void aDistanceCostsTheSameWhateverTheSizeOfTheStar()
    {
        // Each end has a star of that double area in the plane z = 0: at z = h it costs h^2 times both, and
        // h^2 once more over the area that every distance counts for.
        constexpr float kArea = 50, kHeight = 0.5f;
        for (const float starArea : {1e-3f, 1.0f, 1e3f}) {
            const auto [a, b] = FlatEdge(starArea);
            const float cost = EdgeCost(a, b, HalfEdgeVector(a, b), {0, 0, kHeight}, kArea);
            QVERIFY(Near(cost, kHeight * kHeight * (2 * starArea + kArea), 1e-6));
        }
    }

    void aDistanceCountsWithTheLargerWeight()
    {
        auto [a, b] = FlatEdge(1e-6f);
        b.weight = 5;
        b.history = 5.0f * b.history;
        const float cost = EdgeCost(a, b, HalfEdgeVector(a, b), {0, 0, 1}, 50.0f);
        QVERIFY(Near(cost, 5 * 50, 1e-6));
    }

    void theCostOfADistanceNeverFallsInARun()
    {
        // The keys of the sweeps, lower bounds of costs, rely on it.
        QVERIFY(Near(DistanceArea(8, 2), 0.3 * 4, 1e-6)); // 4 is the double area of a face
        QVERIFY(DistanceArea(8, 1) > DistanceArea(8, 2));
        QVERIFY(std::isfinite(DistanceArea(8, 0)));
    }

    void aFaceMustNotLoseItsAreaUnlessItHadNone()
    {
        const MovedFace<float> flat = MoveFace(Vector3<float>{1, 0, 0}, Vector3<float>{2, 0, 0});
        QVERIFY(TurnedTooFar(flat, Vector3<float>{0, 0, 1}));
        QVERIFY(!TurnedTooFar(flat, Vector3<float>{0, 0, 0}));
    }

    void onlySliversArePenalized()
    {
        const auto penalty = [](float height) {
            return QualityPenalty(
                MoveFace(Vector3<float>{1, 0, 0}, Vector3<float>{0.5f, height, 0}).quality2);
        };
        QCOMPARE(penalty(0.8660254f), 1.0f);
        QCOMPARE(penalty(0.031f), 1.0f);
        QVERIFY(Near(penalty(0.01f), 3, 1e-4)); // a third of kPoorQuality
        QVERIFY(std::isfinite(penalty(0)));
    }
};

QTEST_APPLESS_MAIN(TestCost)
#include "test_cost.moc"
