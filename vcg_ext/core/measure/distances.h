// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/measure/group_search.h"
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

/// Points spread evenly by area over a surface: stratified along the faces in the order of its tree,
/// low-discrepancy inside them. Deterministic, and those that follow each other are near each other.
class SurfaceSamples
{
    const ExactSurface& surface_;
    std::vector<std::uint32_t> faces_; ///< of every sample

  public:
    double doubleArea = 0; ///< of the surface

    /// \pre \p surface outlives this object
    SurfaceSamples(const ExactSurface& surface, std::size_t count, int threads) : surface_(surface)
    {
        const Buffer<std::uint32_t>& order = surface.Tree().Order();
        const Buffer<float> areas = surface.Tree().DoubleAreas(threads);
        for (std::size_t i = 0; i < order.size(); ++i) doubleArea += static_cast<double>(areas[i]);
        if (!(doubleArea > 0)) return;
        faces_.reserve(count);
        double upTo = static_cast<double>(areas[0]);
        for (std::size_t i = 0, at = 0; i < count; ++i) {
            const double wanted =
                doubleArea * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            while (at + 1 < order.size() && upTo < wanted) upTo += static_cast<double>(areas[++at]);
            faces_.push_back(order[at]);
        }
    }
    std::size_t size() const { return faces_.size(); }
    Vector3<double> operator()(std::size_t i) const
    {
        const double n = static_cast<double>(i + 1);
        double a = n * 0.7548776662466927, b = n * 0.5698402909980532; // the two-dimensional golden ratio
        a -= std::floor(a);
        b -= std::floor(b);
        if (a + b > 1) {
            a = 1 - a;
            b = 1 - b;
        }
        const std::size_t f = faces_[i];
        return (1 - a - b) * surface_.Corner(f, 0) + a * surface_.Corner(f, 1) + b * surface_.Corner(f, 2);
    }
};

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

/// Calls visit(search, begin, end) for groups of points begin .. end - 1, which the search has taken.
template <class PointAt, class Visit>
void ForEachGroup(const ExactSurface& to, std::size_t count, const PointAt& point, int threads,
                  const Visit& visit)
{
    ParallelRanges(threads, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
        GroupSearch search(to);
        for (std::size_t first = begin; first < end; first += GroupSearch::kMost) {
            const std::size_t size = std::min(end - first, GroupSearch::kMost);
            search.Take(size, [&](std::size_t i) { return point(first + i); });
            visit(search, first, first + size);
        }
    });
}

/// The larger of \p known2 and the largest squared distance of \p count points.
template <class PointAt>
double Largest2(const ExactSurface& to, std::size_t count, const PointAt& point, double known2, int threads)
{
    std::vector<double> parts((count + kGrain - 1) / kGrain, known2);
    ForEachGroup(to, count, point, threads, [&](GroupSearch& search, std::size_t begin, std::size_t) {
        double& largest2 = parts[begin / kGrain];
        largest2 = search.LargerDistance2(largest2);
    });
    for (const double part : parts) known2 = std::max(known2, part);
    return known2;
}

/// \param origins for each simplified face one of the original that is near it
inline std::size_t CountFolded(const ExactSurface& original, const ExactSurface& simplified,
                               const std::vector<std::uint32_t>& origins, int threads)
{
    const Buffer<std::uint32_t>& order = simplified.Tree().Order();
    const auto centroid = [&](std::size_t i) {
        const std::size_t f = order[i];
        return (1.0 / 3) * (simplified.Corner(f, 0) + simplified.Corner(f, 1) + simplified.Corner(f, 2));
    };
    std::vector<std::size_t> parts((order.size() + kGrain - 1) / kGrain);
    ForEachGroup(original, order.size(), centroid, threads,
                 [&](GroupSearch& search, std::size_t begin, std::size_t end) {
                     std::array<Vector3<double>, GroupSearch::kMost> directions;
                     std::array<std::uint32_t, GroupSearch::kMost> near;
                     for (std::size_t i = begin; i < end; ++i) {
                         directions[i - begin] = simplified.AreaVector(order[i]);
                         near[i - begin] = origins[order[i]];
                     }
                     parts[begin / kGrain] += search.CountFacingAway(directions, near);
                 });
    return std::accumulate(parts.begin(), parts.end(), std::size_t{0});
}

/// The vertices on faces, those that are near each other in space near each other.
inline std::vector<std::uint32_t> ReferencedVertices(const MeshView& view, const FaceTree& tree)
{
    std::vector<bool> used(view.vertexCount);
    std::vector<std::uint32_t> vertices;
    vertices.reserve(view.vertexCount);
    for (const std::uint32_t f : tree.Order())
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = view.triangles[3 * std::size_t{f} + k];
            if (used[v]) continue;
            used[v] = true;
            vertices.push_back(v);
        }
    return vertices;
}

/// The tenth of \p vertices with the largest value, in their order; ties by index.
inline std::vector<std::uint32_t> LargestTenth(const std::vector<std::uint32_t>& vertices,
                                               const std::vector<float>& value)
{
    if (vertices.empty()) return {};
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return value[a] != value[b] ? value[a] > value[b] : a < b;
    };
    std::vector<std::uint32_t> ranked = vertices;
    const auto last = ranked.begin() + static_cast<std::ptrdiff_t>((ranked.size() + 9) / 10 - 1);
    std::nth_element(ranked.begin(), last, ranked.end(), before);
    std::vector<std::uint32_t> tenth;
    for (const std::uint32_t v : vertices)
        if (!before(*last, v)) tenth.push_back(v);
    return tenth;
}

} // namespace distance_detail

/// Measures both ways with \p samples points by area a side and every vertex of both.
/// \param original with a face \param tree of its faces
/// \param simplified with a face \param simplifiedTree of its faces, in the same frame
/// \param descriptor one value a vertex of \p original, says where its features are \pre finite positions
inline DistanceReport MeasureDistances(const MeshView& original, const FaceTree& tree,
                                       const MeshView& simplified, const FaceTree& simplifiedTree,
                                       const std::vector<std::uint32_t>& origins,
                                       const std::vector<float>& descriptor, std::size_t samples, int threads)
{
    using namespace distance_detail;
    const float slack = RoundingOf(original, simplified, tree.frame());
    const ExactSurface from(original, tree, slack), to(simplified, simplifiedTree, slack);

    const SurfaceSamples fromSamples(from, samples, threads), toSamples(to, samples, threads);
    const auto vertices = ReferencedVertices(original, tree);
    const auto resultVertices = ReferencedVertices(simplified, simplifiedTree);
    const auto features = LargestTenth(vertices, descriptor);
    const auto vertexAt = [&](std::size_t i) { return from.Vertex(vertices[i]); };
    const auto featureAt = [&](std::size_t i) { return from.Vertex(features[i]); };
    const auto resultVertexAt = [&](std::size_t i) { return to.Vertex(resultVertices[i]); };

    const OneWay forward = Measure(to, fromSamples.size(), fromSamples, threads);
    const OneWay backward = Measure(from, toSamples.size(), toSamples, threads);
    const OneWay feature =
        Measure(to, features.size(), featureAt, threads);
    double largest2 = std::max({forward.largest2, backward.largest2, feature.largest2});
    largest2 = Largest2(to, vertices.size(), vertexAt, largest2, threads);
    largest2 = Largest2(from, resultVertices.size(), resultVertexAt,
                        largest2, threads);

    // The frame may be the simplified mesh's; percents are of the original's diagonal.
    const double percent = 100 / kFrameDiagonal * (FrameOf(original).scale / tree.frame().scale);
    DistanceReport report;
    report.hausdorff = percent * std::sqrt(largest2);
    report.rms = percent * std::sqrt((forward.MeanSquare() + backward.MeanSquare()) / 2);
    report.featureRms = percent * std::sqrt(feature.MeanSquare());
    report.folded = CountFolded(from, to, origins, threads);
    return report;
}

/// The same for a result that has no tree yet.
inline DistanceReport MeasureDistances(const MeshView& original, const FaceTree& tree,
                                       const DecimatedMesh& simplified, const std::vector<float>& descriptor,
                                       std::size_t samples, int threads)
{
    std::vector<std::uint8_t> fixed;
    const MeshView result = ViewOf(simplified, original, fixed);
    const FaceTree resultTree(result, tree.frame(), threads);
    return MeasureDistances(original, tree, result, resultTree, simplified.faceOrigin, descriptor, samples, threads);
}

/// The same where there is no tree at all. \param threads 0: all
inline DistanceReport MeasureDistances(const MeshView& original, const DecimatedMesh& simplified,
                                       const std::vector<float>& descriptor, std::size_t samples = 100000,
                                       int threads = 0)
{
    threads = ResolveThreads(threads);
    const FaceTree tree(original, FrameOf(original), threads);
    return MeasureDistances(original, tree, simplified, descriptor, samples, threads);
}

} // namespace vcg_ext
