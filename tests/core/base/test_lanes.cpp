// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <array>
#include <cstdint>

#include "vcg_ext/core/base/float4.h"

using namespace vcg_ext;

namespace
{

constexpr std::array<std::uint32_t, 8> kExponents{0x07060504, 0x03020100, 0x00010203, 0x04050607,
                                                  0x00000000, 0x07070707, 0x01020407, 0x06050301};
constexpr std::array<std::uint32_t, 8> kPowers{0x80402010, 0x08040201, 0x01020408, 0x10204080,
                                               0x01010101, 0x80808080, 0x02041080, 0x40200802};

} // namespace

/// Operations on four numbers that only processors without AVX2 use for the descriptor.
class TestLanes : public QObject
{
    Q_OBJECT

  private slots:
    void powersOfTwoOfFour()
    {
        for (const std::size_t first : {0U, 4U}) {
            Unsigned4 bytes{};
            for (std::size_t i = 0; i < 4; ++i) bytes[i] = kExponents[first + i];
            const Unsigned4 powers = PowersOfTwo(bytes);
            for (std::size_t i = 0; i < 4; ++i) QCOMPARE(powers[i], kPowers[first + i]);
        }
    }
};

QTEST_APPLESS_MAIN(TestLanes)
#include "test_lanes.moc"
