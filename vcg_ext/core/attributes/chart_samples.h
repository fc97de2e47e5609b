// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/attributes/chart_search.h"
#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

/// Point \p index of a sequence that covers a triangle evenly: the R2 sequence.
inline std::array<float, 3> SpreadWeights(std::size_t index)
{
    constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
    const auto part = [&](double step) {
        return std::fmod(0.5 + static_cast<double>(index + 1) * step, 1.0);
    };
    double u = part(kFirst), v = part(kSecond);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    return {static_cast<float>(1 - u - v), static_cast<float>(u), static_cast<float>(v)};
}

/// Points of the original, each joined to the closest point of its chart of the simplified surface that faces
/// the same way, in the order of the simplified faces.
class ChartSamples
{
    static constexpr std::size_t kPerFace = 16;    ///< of the simplified surface
    static constexpr std::size_t kMostPerFace = 4; ///< of the original
    static constexpr std::size_t kGrain = 512;

  public:
    struct Sample {
        std::uint32_t face = 0;         ///< of the original
        std::uint32_t index = 0;        ///< which of the face's samples
        std::array<float, 3> weights{}; ///< on the simplified face
    };

    std::size_t perFace = 1;          ///< samples of each face of the original
    std::vector<std::uint32_t> begin; ///< of the samples of every simplified face, and their number
    Buffer<Sample> samples;

    /// \param order of the original's faces, neighbors close to each other; empty: as they are
    /// \param charts of every face of the original
    ChartSamples(const ChartSearch& original, const ChartSearch& simplified,
                 const std::vector<std::uint32_t>& charts, const std::vector<std::uint32_t>& order,
                 std::size_t simplifiedFaces, int threads)
    {
        const std::size_t faces = charts.size();
        perFace = std::clamp((kPerFace * simplifiedFaces + faces - 1) / faces, std::size_t{1}, kMostPerFace);
        Buffer<Sample> found(faces * perFace);
        Buffer<std::uint32_t> target(faces * perFace);
        ParallelRanges(threads, faces, kGrain, [&](std::size_t first, std::size_t last, int) {
            std::uint32_t hint = kNone;
            for (std::size_t i = first; i < last; ++i) {
                const std::uint32_t face = order.size() == faces ? order[i] : static_cast<std::uint32_t>(i);
                for (std::size_t k = 0; k < perFace; ++k) {
                    ChartPoint at;
                    if (charts[face] != kNone)
                        at = simplified.Closest(PointOf(original, face, k), original.Normal(face),
                                                charts[face], hint);
                    target[i * perFace + k] = hint = at.face;
                    found[i * perFace + k] = {
                        face, static_cast<std::uint32_t>(k), {at.weights[0], at.weights[1], at.weights[2]}};
                }
            }
        });
        Sort(found, target, simplifiedFaces);
    }

    /// Where in its face of the original the sample is.
    std::array<float, 3> Weights(std::uint32_t index) const
    {
        if (perFace == 1) return {1.0f / 3, 1.0f / 3, 1.0f / 3};
        return SpreadWeights(index);
    }

  private:
    Vector3<float> PointOf(const ChartSearch& original, std::uint32_t face, std::size_t k) const
    {
        const std::array<float, 3> w = Weights(static_cast<std::uint32_t>(k));
        return w[0] * original.CornerAt(face, 0) + w[1] * original.CornerAt(face, 1) +
               w[2] * original.CornerAt(face, 2);
    }

    void Sort(const Buffer<Sample>& found, const Buffer<std::uint32_t>& target, std::size_t faces)
    {
        begin.assign(faces + 1, 0);
        for (const std::uint32_t face : target)
            if (face != kNone) ++begin[face + 1];
        for (std::size_t f = 0; f < faces; ++f) begin[f + 1] += begin[f];
        samples.Allocate(begin[faces]);
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t i = 0; i < target.size(); ++i)
            if (target[i] != kNone) samples[next[target[i]]++] = found[i];
    }
};

} // namespace vcg_ext
