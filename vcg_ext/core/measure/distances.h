// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// How far two surfaces are apart; lengths in percent of the original's bounding-box diagonal.
struct DistanceReport {
    double hausdorff = 0; ///< largest distance found, both ways
    double rms = 0;       ///< square root of the mean, over both directions, of the mean squared distance
    double featureRms =
        0; ///< original to simplified at the tenth of the vertices with the largest descriptor
    std::size_t folded = 0; ///< simplified faces turned by more than 90 degrees against the original's face
                            ///< at the point closest to their centroid
};

namespace distance_detail
{

/// One way of the comparison.
struct OneWay {
    double sumOfSquares = 0;
    double largest2 = 0;
    std::size_t count = 0;

    double MeanSquare() const { return count > 0 ? sumOfSquares / static_cast<double>(count) : 0; }
};

constexpr std::size_t kGrain = 1024; ///< points that one thread measures at a time

/// Points spread evenly by area: stratified along the faces, low-discrepancy inside them. Deterministic.
inline std::vector<Vector3<double>> SamplePoints(const ExactSurface& surface, std::size_t count)
{
    std::vector<double> upTo(surface.FaceCount());
    double area = 0;
    for (std::size_t f = 0; f < upTo.size(); ++f) upTo[f] = area += Norm(surface.AreaVector(f));
    std::vector<Vector3<double>> points;
    if (!(area > 0)) return points;
    points.reserve(count);
    std::size_t f = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = area * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        while (f + 1 < upTo.size() && upTo[f] < at) ++f;
        const double n = static_cast<double>(i + 1);
        double a = std::fmod(n * 0.7548776662466927, 1.0); // the two-dimensional golden ratio sequence
        double b = std::fmod(n * 0.5698402909980532, 1.0);
        if (a + b > 1) {
            a = 1 - a;
            b = 1 - b;
        }
        points.push_back((1 - a - b) * surface.Corner(f, 0) + a * surface.Corner(f, 1) +
                         b * surface.Corner(f, 2));
    }
    return points;
}

template <class PointAt>
OneWay Measure(const ExactSurface& to, std::size_t count, const PointAt& point, int threads)
{
    std::vector<OneWay> parts((count + kGrain - 1) / kGrain);
    ParallelRanges(threads, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
        OneWay& part = parts[begin / kGrain];
        ExactSurface::Search search;
        for (std::size_t i = begin; i < end; ++i) {
            const double distance2 = to.Distance2(point(i), search);
            part.sumOfSquares += distance2;
            part.largest2 = std::max(part.largest2, distance2);
        }
    });
    OneWay all;
    all.count = count;
    for (const OneWay& part : parts) { // in this order, whatever the threads
        all.sumOfSquares += part.sumOfSquares;
        all.largest2 = std::max(all.largest2, part.largest2);
    }
    return all;
}

/// The larger of \p known2 and the largest squared distance of \p count points.
template <class PointAt>
double Largest2(const ExactSurface& to, std::size_t count, const PointAt& point, double known2, int threads)
{
    std::vector<double> parts((count + kGrain - 1) / kGrain, known2);
    ParallelRanges(threads, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
        double& largest2 = parts[begin / kGrain];
        ExactSurface::Search search;
        for (std::size_t i = begin; i < end; ++i) largest2 = to.LargerDistance2(point(i), largest2, search);
    });
    for (const double part : parts) known2 = std::max(known2, part);
    return known2;
}

/// \param near2 squared distance within which most centroids are
inline std::size_t CountFolded(const ExactSurface& original, const ExactSurface& simplified, double near2,
                               int threads)
{
    std::vector<std::size_t> parts((simplified.FaceCount() + kGrain - 1) / kGrain);
    ParallelRanges(threads, simplified.FaceCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        ExactSurface::Search search;
        for (std::size_t f = begin; f < end; ++f) {
            const Vector3<double> centroid =
                (1.0 / 3) * (simplified.Corner(f, 0) + simplified.Corner(f, 1) + simplified.Corner(f, 2));
            original.LargerDistance2(centroid, near2, search); // so that the last face is a near one
            if (original.FacesAwayFrom(centroid, simplified.AreaVector(f), search)) ++parts[begin / kGrain];
        }
    });
    return std::accumulate(parts.begin(), parts.end(), std::size_t{0});
}

/// The vertices on faces, in ascending order.
inline std::vector<std::uint32_t> ReferencedVertices(const MeshView& view)
{
    std::vector<bool> used(view.vertexCount);
    for (std::size_t k = 0; k < 3 * view.faceCount; ++k) used[view.triangles[k]] = true;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < view.vertexCount; ++v)
        if (used[v]) vertices.push_back(v);
    return vertices;
}

/// The tenth of \p vertices with the largest value, in ascending order; ties by index.
inline std::vector<std::uint32_t> LargestTenth(std::vector<std::uint32_t> vertices,
                                               const std::vector<float>& value)
{
    const auto tenth = static_cast<std::ptrdiff_t>((vertices.size() + 9) / 10);
    std::nth_element(
        vertices.begin(), vertices.begin() + (tenth > 0 ? tenth - 1 : 0), vertices.end(),
        [&](std::uint32_t a, std::uint32_t b) { return value[a] != value[b] ? value[a] > value[b] : a < b; });
    vertices.resize(static_cast<std::size_t>(tenth));
    std::sort(vertices.begin(), vertices.end());
    return vertices;
}

} // namespace distance_detail

/// Measures both ways with \p samples points by area a side and every vertex of both.
/// \param original with a face \param tree of its faces
/// \param simplified with a face \param descriptor one value a vertex of \p original, says where its features
/// are \pre finite positions
inline DistanceReport MeasureDistances(const MeshView& original, const FaceTree& tree,
                                       const DecimatedMesh& simplified, const std::vector<float>& descriptor,
                                       std::size_t samples, int threads)
{
    using namespace distance_detail;
    std::vector<std::uint8_t> fixed;
    const MeshView result = ViewOf(simplified, original, fixed);
    const FaceTree resultTree(result, tree.frame(), threads);
    const float slack = RoundingOf(original, result, tree.frame());
    const ExactSurface from(original, tree, slack), to(result, resultTree, slack);

    const auto fromPoints = SamplePoints(from, samples), toPoints = SamplePoints(to, samples);
    const auto vertices = ReferencedVertices(original);
    const auto features = LargestTenth(vertices, descriptor);
    const auto forward = Measure(
        to, fromPoints.size(), [&](std::size_t i) { return fromPoints[i]; }, threads);
    const auto backward = Measure(
        from, toPoints.size(), [&](std::size_t i) { return toPoints[i]; }, threads);
    const auto feature = Measure(
        to, features.size(), [&](std::size_t i) { return from.Vertex(features[i]); }, threads);
    const auto vertexAt = [&](std::size_t i) { return from.Vertex(vertices[i]); };
    const auto resultVertexAt = [&](std::size_t v) { return to.Vertex(v); };
    double largest2 = std::max({forward.largest2, backward.largest2, feature.largest2});
    largest2 = Largest2(to, vertices.size(), vertexAt, largest2, threads);
    largest2 = Largest2(from, result.vertexCount, resultVertexAt, largest2, threads);

    // The frame may be the simplified mesh's; percents are of the original's diagonal.
    const double percent = 100 / kFrameDiagonal * (FrameOf(original).scale / tree.frame().scale);
    DistanceReport report;
    report.hausdorff = percent * std::sqrt(largest2);
    report.rms = percent * std::sqrt((forward.MeanSquare() + backward.MeanSquare()) / 2);
    report.featureRms = percent * std::sqrt(feature.MeanSquare());
    report.folded = CountFolded(from, to, largest2, threads);
    return report;
}

/// The same where there is no tree yet. \param threads 0: all
inline DistanceReport MeasureDistances(const MeshView& original, const DecimatedMesh& simplified,
                                       const std::vector<float>& descriptor, std::size_t samples = 100000,
                                       int threads = 0)
{
    threads = ResolveThreads(threads);
    const FaceTree tree(original, FrameOf(original), threads);
    return MeasureDistances(original, tree, simplified, descriptor, samples, threads);
}

} // namespace vcg_ext
