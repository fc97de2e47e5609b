// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cmath>
#include <numeric>
#include <vector>

#include "vcg_ext/core/collapse/star_sums.h"

using namespace vcg_ext;

namespace
{

constexpr double kPi = 3.14159265358979323846;

bool Near(double a, double b, double relative)
{
    return std::abs(a - b) <= relative * std::max(1.0, std::abs(b));
}

/// Crease planes of an edge of length 2 whose faces turn by each of \p degrees.
CreasePlanes<double> Creases(const std::vector<double>& degrees)
{
    CreasePlanes<double> creases;
    for (const double turn : degrees) {
        const double angle = turn * kPi / 180;
        creases.Add({2, 0, 0}, {0, 0, 3}, {0, std::sin(angle), std::cos(angle)});
    }
    return creases;
}

} // namespace

class TestStarSums : public QObject
{
    Q_OBJECT

  private slots:
    void aScaledNormalSquaredIsTwiceTheAreaTimesThePlane()
    {
        const Vector3<float> m = ScaledNormal<float>({0, 0, 0}, {3, 0, 0}, {0, 2, 0});
        QVERIFY(Near(QuadraticForm(OuterProduct(m), {5, -4, 1}), 6, 1e-6)); // distance 1, area 3
        const Vector3<float> none = ScaledNormal<float>({1, 1, 1}, {2, 2, 2}, {3, 3, 3});
        QCOMPARE(Dot(none, none), 0.0f);
    }

    void aPerpendicularPlaneStandsOnItsEdge()
    {
        const SymmetricMatrix3<float> plane = PerpendicularPlane<float>({0, 0, 7}, {2, 0, 0});
        QVERIFY(Near(QuadraticForm(plane, {1, 0, 5}), 0, 1e-6));  // in the plane
        QVERIFY(Near(QuadraticForm(plane, {1, 3, 0}), 36, 1e-6)); // distance 3, length 2
        QCOMPARE(PerpendicularPlane<float>({0, 0, 0}, {1, 0, 0}).Trace(), 0.0f);
    }

    void edgesAreCreasesFromThirtyDegreesOn()
    {
        QCOMPARE(Creases({0, 29}).Sum().Trace(), 0.0);
        // Two planes of weight 2², .1 of it.
        QVERIFY(Near(Creases({31}).Sum().Trace(), 0.1 * 8, 1e-6));
        QVERIFY(Near(Creases({91}).Sum().Trace(), 0.1 * 8, 1e-6));
    }

    void twoFoldsMakeATip()
    {
        QVERIFY(Near(Creases({121}).Sum().Trace(), 0.1 * 8, 1e-6));
        QVERIFY(Near(Creases({119, 121}).Sum().Trace(), 0.1 * 16, 1e-6));
        QVERIFY(Near(Creases({121, 180}).Sum().Trace(), 0.7 * 16, 1e-6));
        QVERIFY(Near(Creases({121, 180, 40}).Sum().Trace(), 0.7 * 16 + 0.1 * 8, 1e-6));
    }

    void theDescriptorOfAPyramidIsTheSlopeOfItsEdges()
    {
        const double height = 0.7;
        StarSums<double> sums;
        for (int i = 0; i < 5; ++i) {
            const auto corner = [&](int k) {
                const double angle = 2 * kPi * k / 5;
                return Vector3<double>{std::cos(angle), std::sin(angle), -height};
            };
            const Vector3<double> a = corner(i), b = corner(i + 1);
            sums.Add(a, b, ScaledNormal<double>({0, 0, 0}, a, b));
        }
        const double expected = height / std::sqrt(1 + height * height);
        QVERIFY(Near(StarDescriptor(sums), expected, 1e-12));
        const StarSums<double> whole = sums;
        sums.AddEdge({1, 0, 0}, 0.5); // along the base: to the length alone
        QVERIFY(Near(StarDescriptor(sums), expected * whole.length / (whole.length + 0.5), 1e-12));
        QCOMPARE(StarDescriptor(StarSums<float>()), 0.0f);
    }

    void thePercentileOfTheDescriptorCountsAsOne()
    {
        std::vector<double> sample(2001);
        std::iota(sample.begin(), sample.end(), 1.0);
        QCOMPARE(DescriptorScale(sample), 1.0 / 1999); // two of them are above
        QCOMPARE(DescriptorScale(std::vector<double>{0, 0}), 1.0);
        QCOMPARE(DescriptorScale(std::vector<float>()), 1.0f);
    }

    void importanceNeverFallsAndRisesWithTheNewStar()
    {
        const auto a = ImportanceOf(0.25, 4.0), b = ImportanceOf(0.5, 4.0);
        QCOMPARE(b.weight, std::exp(2.0));
        QCOMPARE(MergedImportance(a, b, 0.0, 4.0).weight, b.weight);
        QCOMPARE(MergedImportance(b, a, 0.4, 4.0).descriptor, 0.5);
        QCOMPARE(MergedImportance(a, b, 0.75, 4.0).descriptor, 0.75);
        QCOMPARE(MergedImportance(a, b, 0.75, 4.0).weight, std::exp(3.0));
    }
};

QTEST_APPLESS_MAIN(TestStarSums)
#include "test_star_sums.moc"
