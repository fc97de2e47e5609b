// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cmath>
#include <random>

#include "vcg_ext/core/geometry/symmetric_matrix.h"

using namespace vcg_ext;

namespace
{

class Numbers
{
    std::mt19937 generator_{3};
    std::uniform_real_distribution<double> distribution_{-1, 1};

  public:
    Vector3<double> NextVector()
    {
        const double x = distribution_(generator_), y = distribution_(generator_);
        return {x, y, distribution_(generator_)};
    }
    /// Of so many planes.
    SymmetricMatrix3<double> NextMatrix(int planes)
    {
        SymmetricMatrix3<double> sum{};
        for (int i = 0; i < planes; ++i) sum = sum + OuterProduct(NextVector());
        return sum;
    }
};

} // namespace

class TestSymmetricMatrix : public QObject
{
    Q_OBJECT

  private slots:
    void aSolutionSolvesTheRegularizedEquations()
    {
        Numbers numbers;
        for (int i = 0; i < 100; ++i) {
            const SymmetricMatrix3<double> m = numbers.NextMatrix(6);
            const Vector3<double> rhs = numbers.NextVector();
            const double e = 0.01 * m.Trace();
            const Vector3<double> x = SolveRegularized(m, rhs, e);
            // the condition is below 300, so that 1e-12 leaves ten times the rounding of double
            QVERIFY(Norm(m * x + e * x - rhs) < 1e-12 * Norm(rhs));
        }
    }

    /// One plane leaves two directions open; the solution does not go there.
    void openDirectionsStayAtTheOrigin()
    {
        Numbers numbers;
        for (int i = 0; i < 100; ++i) {
            const Vector3<double> n = numbers.NextVector();
            const SymmetricMatrix3<double> m = OuterProduct(n);
            const Vector3<double> x = SolveRegularized(m, 0.5 * n, 1e-6 * m.Trace());
            QVERIFY(Norm(Cross(x, n)) < 1e-6 * Norm(x) * Norm(n));
            QVERIFY(std::abs(Dot(x, n) - 0.5) < 1e-5); // the pull to the origin is 1e-6 of it
        }
    }

    /// Where rounding has made a matrix slightly indefinite, the solution is still that of a definite one: it
    /// goes along the right side, not against it.
    void roundingDoesNotTurnASolutionAround()
    {
        constexpr float kLess = 1 - 1e-5F, kSmall = 1e-6F;
        const Vector3<float> y = SolveRegularized({1, 1, 0, kLess, 0, 1}, {0, 1, 0}, kSmall);
        QVERIFY(y.y > 0 && y.y <= 2 / kSmall);
        const Vector3<float> z = SolveRegularized({1, 0, 1, 1, 0, kLess}, {0, 0, 1}, kSmall);
        QVERIFY(z.z > 0 && z.z <= 2 / kSmall);
    }

    void fourLanesDoWhatOneNumberDoes()
    {
        Numbers numbers;
        for (int i = 0; i < 100; ++i) {
            const SymmetricMatrix3<double> d = numbers.NextMatrix(4);
            const Vector3<double> r = numbers.NextVector();
            const auto f = [](double value) { return static_cast<float>(value); };
            const SymmetricMatrix3<float> m{f(d.xx), f(d.xy), f(d.xz), f(d.yy), f(d.yz), f(d.zz)};
            const Vector3<float> rhs{f(r.x), f(r.y), f(r.z)};
            const Vector3<float> one = SolveRegularized(m, rhs, 0.01F);
            const auto four =
                SolveRegularized(SymmetricMatrix3<Float4>{Splat(m.xx), Splat(m.xy), Splat(m.xz), Splat(m.yy),
                                                          Splat(m.yz), Splat(m.zz)},
                                 Splat(rhs), Splat(0.01F));
            for (int lane = 0; lane < kLanes; ++lane) {
                const Vector3<float> x = Lane(four, lane);
                QVERIFY(x.x == one.x && x.y == one.y && x.z == one.z);
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestSymmetricMatrix)
#include "test_symmetric_matrix.moc"
