// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

/// The equations of values at wedges that are interpolated over faces and have to fit samples:
///
///     least  sum_samples area |sum_i w_i s_i - sample|^2  +  r sum_wedges mass |s - s_0|^2
///
/// A face sums up its samples: the products of their weights, and those with what the samples miss.
class WedgeEquations
{
    static constexpr double kPull = 0.02; ///< r
    static constexpr int kSteps = 20;
    static constexpr double kSmallResidual = 1e-8; ///< of the first, squared
    static constexpr std::size_t kGrain = 2048;

    const std::vector<std::array<std::uint32_t, 3>>& faces_;
    std::size_t wedges_;
    int threads_;
    std::vector<std::array<double, 6>> products_;      ///< of every face: 00 01 02 11 12 22
    std::vector<std::uint32_t> cornerBegin_, corners_; ///< of every wedge, as 3 face + k
    std::vector<double> mass_;

  public:
    /// \param faces the wedges of every face; outlives this object
    WedgeEquations(const std::vector<std::array<std::uint32_t, 3>>& faces, std::size_t wedges,
                   std::vector<std::array<double, 6>> products, int threads)
        : faces_(faces), wedges_(wedges), threads_(threads), products_(std::move(products)),
          cornerBegin_(wedges + 2, 0), corners_(3 * faces.size()), mass_(wedges, 0)
    {
        for (const auto& face : faces)
            for (const std::uint32_t w : face) ++cornerBegin_[w + 2];
        for (std::size_t w = 2; w < cornerBegin_.size(); ++w) cornerBegin_[w] += cornerBegin_[w - 1];
        for (std::size_t i = 0; i < corners_.size(); ++i)
            corners_[cornerBegin_[faces[i / 3][i % 3] + 1]++] = static_cast<std::uint32_t>(i);
        ForEachWedge([&](std::size_t w) {
            ForEachCorner(w, [&](std::size_t f, std::size_t k) {
                for (std::size_t j = 0; j < 3; ++j) mass_[w] += Product(f, k, j);
            });
        });
    }

    /// What has to be added to the values of one channel. \param missing of every face's corners: the sum of
    /// area x weight x (sample - value) \param isFree of every wedge: its value may change
    std::vector<double> Solve(const std::vector<std::array<double, 3>>& missing,
                              const std::vector<std::uint8_t>& isFree) const
    {
        std::vector<double> x(wedges_, 0), residual(wedges_), preconditioned(wedges_), direction(wedges_),
            image(wedges_);
        ForEachWedge([&](std::size_t w) {
            double sum = 0;
            ForEachCorner(w, [&](std::size_t f, std::size_t k) { sum += missing[f][k]; });
            residual[w] = isFree[w] ? sum : 0;
            preconditioned[w] = direction[w] = residual[w] / Diagonal(w);
        });
        double size = DotProduct(residual, preconditioned);
        const double start = size;
        for (int step = 0; step < kSteps && size > kSmallResidual * start && size > 0; ++step) {
            Apply(direction, isFree, image);
            const double curvature = DotProduct(direction, image);
            if (!(curvature > 0)) break;
            const double length = size / curvature;
            ForEachWedge([&](std::size_t w) {
                x[w] += length * direction[w];
                residual[w] -= length * image[w];
                preconditioned[w] = residual[w] / Diagonal(w);
            });
            const double next = DotProduct(residual, preconditioned), ratio = next / size;
            ForEachWedge([&](std::size_t w) { direction[w] = preconditioned[w] + ratio * direction[w]; });
            size = next;
        }
        return x;
    }

  private:
    template <class Visit>
    void ForEachWedge(const Visit& visit) const
    {
        ParallelRanges(threads_, wedges_, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t w = begin; w < end; ++w) visit(w);
        });
    }
    template <class Visit>
    void ForEachCorner(std::size_t w, const Visit& visit) const
    {
        for (std::uint32_t i = cornerBegin_[w]; i < cornerBegin_[w + 1]; ++i)
            visit(corners_[i] / 3, corners_[i] % 3);
    }
    double Product(std::size_t f, std::size_t i, std::size_t j) const
    {
        constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
        return products_[f][kPlace[i][j]];
    }
    double Diagonal(std::size_t w) const
    {
        constexpr double kNothing = 1e-300; // a wedge without samples has no residual either
        return (1 + kPull) * mass_[w] + kNothing;
    }

    void Apply(const std::vector<double>& in, const std::vector<std::uint8_t>& isFree,
               std::vector<double>& out) const
    {
        ForEachWedge([&](std::size_t w) {
            double sum = kPull * mass_[w] * in[w];
            ForEachCorner(w, [&](std::size_t f, std::size_t k) {
                for (std::size_t j = 0; j < 3; ++j) sum += Product(f, k, j) * in[faces_[f][j]];
            });
            out[w] = isFree[w] ? sum : 0;
        });
    }

    /// In an order that depends on the size only.
    double DotProduct(const std::vector<double>& a, const std::vector<double>& b) const
    {
        std::vector<double> parts(wedges_ / kGrain + 1, 0);
        ParallelRanges(threads_, wedges_, kGrain, [&](std::size_t begin, std::size_t end, int) {
            double sum = 0;
            for (std::size_t w = begin; w < end; ++w) sum += a[w] * b[w];
            parts[begin / kGrain] = sum;
        });
        double sum = 0;
        for (const double part : parts) sum += part;
        return sum;
    }
};

} // namespace vcg_ext
