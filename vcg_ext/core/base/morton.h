// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

/// Cells of a box, numbered along a Morton curve: neighbours in space have numbers near each other.
/// \tparam kBitsPerAxis at most 10
template <int kBitsPerAxis>
class MortonGrid
{
    std::array<double, 3> low_;
    double scale_;

  public:
    static constexpr int kCodeBits = 3 * kBitsPerAxis;

    MortonGrid(const std::array<double, 3>& low, const std::array<double, 3>& high) : low_(low), scale_(0)
    {
        double extent = 0;
        for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, high[k] - low[k]);
        const double scale = (1 << kBitsPerAxis) / extent;
        if (extent > 0 && std::isfinite(scale)) scale_ = scale; // else all lie in one cell
    }

    std::uint32_t Code(const std::array<double, 3>& p) const
    {
        constexpr double kHighest = (1 << kBitsPerAxis) - 1;
        std::uint32_t code = 0;
        if (!(scale_ > 0)) return code; // an extent beyond all numbers, or none
        for (std::size_t k = 0; k < 3; ++k) {
            const double cell = std::clamp((p[k] - low_[k]) * scale_, 0.0, kHighest);
            code |= SpreadBits(static_cast<std::uint32_t>(cell)) << k;
        }
        return code;
    }

  private:
    /// Every third bit of the result is one of the lowest 10 of \p x.
    static std::uint32_t SpreadBits(std::uint32_t x)
    {
        x = (x | x << 16) & 0x030000FFu;
        x = (x | x << 8) & 0x0300F00Fu;
        x = (x | x << 4) & 0x030C30C3u;
        return (x | x << 2) & 0x09249249u;
    }
};

/// An input vertex and where it lies on the curve.
struct OrderedVertex {
    std::uint32_t code, origin;
};

/// Sorts by codes of so many bits; equal codes stay in their order.
template <int kCodeBits>
void SortByCode(Buffer<OrderedVertex>& vertices, int threads)
{
    constexpr int kDigitBits = (kCodeBits + 1) / 2;
    constexpr std::uint32_t kDigits = std::uint32_t{1} << kDigitBits;
    Buffer<OrderedVertex> sorted(vertices.size());
    for (const int shift : {0, kDigitBits}) {
        StableScatter(
            threads, vertices.size(), kDigits,
            [&](std::size_t i) { return vertices[i].code >> shift & (kDigits - 1); },
            [&](std::size_t i, std::uint32_t place) { sorted[place] = vertices[i]; });
        std::swap(vertices, sorted);
    }
}

} // namespace vcg_ext
