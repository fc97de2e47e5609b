// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <array>
#include <cmath>

#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/frame.h"

using namespace vcg_ext;

class TestFrame : public QObject
{
    Q_OBJECT

  private slots:
    /// Whatever size and place a mesh has; at the ends of the range the square of the size is no number.
    void theBoxLiesAboutTheOriginWithADiagonalOf1024()
    {
        for (const double size : {1e-200, 1e-3, 1.0, 1e6, 1e200}) {
            Box3<double> box = EmptyBox<double>();
            box.Add({5 * size, 0, size});
            box.Add({7 * size, 3 * size, 7 * size});
            const Frame frame = FrameOf(box); // sides 2, 3, 6: a diagonal of 7
            const Vector3<float> high = frame.Into({7 * size, 3 * size, 7 * size});
            const float part = 1024.0F / 7 / 2;
            const auto near = [](float a, float b) { return std::abs(a - b) < 1e-6F * std::abs(b); };
            QVERIFY(near(high.x, 2 * part) && near(high.y, 3 * part) && near(high.z, 6 * part));
            const std::array<double, 3> back = frame.OutOf(high);
            // rounding of a float, half a unit in the 24th digit of at most half the box
            QVERIFY(std::abs(back[2] / size - 7) < 6 * 0x1p-25);
        }
    }

    void whatHasNoSizeIsNotScaled()
    {
        Box3<double> box = EmptyBox<double>();
        QVERIFY(box.IsEmpty());
        box.Add({3, 4, 5});
        QVERIFY(!box.IsEmpty());
        const Frame frame = FrameOf(box);
        QCOMPARE(frame.scale, 1.0);
        QCOMPARE(frame.Into({3, 4, 6}).z, 1.0F);
    }
};

QTEST_APPLESS_MAIN(TestFrame)
#include "test_frame.moc"
