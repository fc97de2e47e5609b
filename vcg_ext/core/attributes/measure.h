// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/attributes/attribute_report.h"
#include "vcg_ext/core/attributes/chart_samples.h"
#include "vcg_ext/core/attributes/chart_search.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"

namespace vcg_ext
{

namespace measure_attributes_detail
{

constexpr std::size_t kGrain = 512;

/// Points spread evenly by area over the faces of \p surface, as many as \p count.
inline std::vector<ChartPoint> EvenPoints(const ChartSearch& surface, std::size_t faces, std::size_t count)
{
    std::vector<double> upTo(faces);
    double area = 0;
    for (std::size_t f = 0; f < faces; ++f)
        upTo[f] = area += static_cast<double>(Norm(surface.Normal(static_cast<std::uint32_t>(f))));
    std::vector<ChartPoint> points;
    if (!(area > 0)) return points;
    std::size_t f = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = area * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        while (f + 1 < faces && upTo[f] < at) ++f;
        const std::array<float, 3> w = SpreadWeights(i);
        points.push_back({static_cast<std::uint32_t>(f), {w[0], w[1], w[2]}, 0});
    }
    return points;
}

inline Vector3<float> PlaceOf(const ChartSearch& surface, const ChartPoint& at)
{
    return at.weights[0] * surface.CornerAt(at.face, 0) + at.weights[1] * surface.CornerAt(at.face, 1) +
           at.weights[2] * surface.CornerAt(at.face, 2);
}

/// \param values of all corners, \p channels each
inline double ValueOf(const float* values, std::size_t channels, const ChartPoint& at, std::size_t k)
{
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j)
        sum += static_cast<double>(at.weights[j]) *
               static_cast<double>(values[(3 * std::size_t{at.face} + j) * channels + k]);
    return sum;
}

} // namespace measure_attributes_detail

/// Compares the attributes of a result with the original's.
class AttributeMeasure
{
    static constexpr std::size_t kPoints = 40000; ///< a side

    const MeshView& view_;
    const DecimatedMesh& mesh_;
    const CornerAttributes& input_;
    int threads_;
    std::vector<std::uint8_t> fixed_;
    MeshView simplifiedView_;
    FaceTree simplifiedTree_;
    ChartSearch original_, simplified_;

  public:
    /// \param tree of the original's faces \pre \p mesh has faces, wedges and values
    AttributeMeasure(const MeshView& view, const FaceTree& tree, const DecimatedMesh& mesh, int threads)
        : view_(view), mesh_(mesh), input_(*view.attributes), threads_(threads),
          simplifiedView_(ViewOf(mesh, view, fixed_)),
          simplifiedTree_(simplifiedView_, tree.frame(), threads),
          original_(view, tree, mesh.wedges->inputChart, threads),
          simplified_(simplifiedView_, simplifiedTree_, mesh.wedges->chart, threads)
    {
    }

    void Measure(AttributeReport& report) const
    {
        using namespace measure_attributes_detail;
        const auto ofOriginal = EvenPoints(original_, view_.faceCount, kPoints);
        const auto ofSimplified = EvenPoints(simplified_, mesh_.triangles.size(), kPoints);
        std::vector<double> there = MeanSquares(original_, mesh_.wedges->inputChart, input_.values,
                                                ofOriginal, simplified_, mesh_.cornerValues.data());
        const std::vector<double> back =
            MeanSquares(simplified_, mesh_.wedges->chart, mesh_.cornerValues.data(), ofSimplified, original_,
                        input_.values);
        for (std::size_t k = 0; k < there.size(); ++k)
            report.rms.push_back(std::sqrt((there[k] + back[k]) / 2));
        for (const std::uint32_t first : mesh_.wedges->channels.textures)
            report.textures.push_back(DeviationOf(first, ofSimplified));
    }

  private:
    /// Of every channel the mean squared difference between points of one surface and the closest of their
    /// chart of the other.
    std::vector<double> MeanSquares(const ChartSearch& from, const std::vector<std::uint32_t>& charts,
                                    const float* fromValues, const std::vector<ChartPoint>& points,
                                    const ChartSearch& to, const float* toValues) const
    {
        using namespace measure_attributes_detail;
        const std::size_t channels = input_.Channels();
        std::vector<std::vector<double>> parts(points.size() / kGrain + 1, std::vector<double>(channels, 0));
        ParallelRanges(threads_, points.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t chart = charts[points[i].face];
                if (chart == kNone) continue;
                const ChartPoint at =
                    to.Closest(PlaceOf(from, points[i]), from.Normal(points[i].face), chart);
                if (at.face == kNone) continue;
                for (std::size_t k = 0; k < channels; ++k) {
                    const double difference =
                        ValueOf(fromValues, channels, points[i], k) - ValueOf(toValues, channels, at, k);
                    parts[begin / kGrain][k] += difference * difference;
                }
            }
        });
        std::vector<double> sum(channels, 0);
        for (const auto& part : parts)
            for (std::size_t k = 0; k < channels; ++k)
                sum[k] += part[k] / static_cast<double>(std::max<std::size_t>(1, points.size()));
        return sum;
    }

    /// How far points of the result are from where the original has their texture coordinates, in their
    /// chart.
    TextureDeviation DeviationOf(std::uint32_t first, const std::vector<ChartPoint>& points) const
    {
        using namespace measure_attributes_detail;
        const std::size_t channels = input_.Channels(), corners = 3 * view_.faceCount;
        std::vector<std::array<float, 3>> places(corners);
        std::vector<std::uint32_t> triangles(corners);
        for (std::size_t i = 0; i < corners; ++i) {
            places[i] = {input_.values[i * channels + first], input_.values[i * channels + first + 1], 0};
            triangles[i] = static_cast<std::uint32_t>(i);
        }
        MeshView texture;
        texture.positions = places.data();
        texture.positionStride = sizeof places[0];
        texture.vertexCount = corners;
        texture.triangles = triangles.data();
        texture.faceCount = view_.faceCount;
        const FaceTree tree(texture, FrameOf(texture), threads_);
        const ChartSearch search(texture, tree, mesh_.wedges->inputChart, threads_);
        std::vector<double> distance2(points.size(), 0);
        ParallelRanges(threads_, points.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto value = [&](std::size_t k) {
                    return ValueOf(mesh_.cornerValues.data(), channels, points[i], k);
                };
                const Vector3<float> uv = tree.frame().Into({value(first), value(first + 1), 0});
                const ChartPoint at = search.ClosestInChart(uv, mesh_.wedges->chart[points[i].face]);
                if (at.face == kNone) continue;
                const Vector3<float> apart = PlaceOf(simplified_, points[i]) - PlaceOf(original_, at);
                distance2[i] = static_cast<double>(SquaredNorm(apart));
            }
        });
        TextureDeviation deviation;
        double sum = 0, largest2 = 0;
        for (const double d2 : distance2) {
            sum += d2;
            largest2 = std::max(largest2, d2);
        }
        constexpr double kPercent = 100 / kFrameDiagonal;
        deviation.rms =
            kPercent * std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, points.size())));
        deviation.largest = kPercent * std::sqrt(largest2);
        return deviation;
    }
};

} // namespace vcg_ext
