// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/base/progress.h"
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

/// Squared distances of some points, one way.
struct OneWay {
    double sumOfSquares = 0, sumOfFourths = 0;
    double largest2 = 0;
    std::size_t count = 0;

    double MeanSquare() const { return count > 0 ? sumOfSquares / static_cast<double>(count) : 0; }
    /// Of the mean square, squared; nothing is made of how evenly the points are spread, which lowers it.
    double StandardError2() const
    {
        if (count == 0) return 0;
        const double n = static_cast<double>(count), mean = MeanSquare();
        return std::max(0.0, sumOfFourths / n - mean * mean) / n;
    }
    void Add(double distance2)
    {
        sumOfSquares += distance2;
        sumOfFourths += distance2 * distance2;
        largest2 = std::max(largest2, distance2);
        ++count;
    }
    void Add(const OneWay& other)
    {
        sumOfSquares += other.sumOfSquares;
        sumOfFourths += other.sumOfFourths;
        largest2 = std::max(largest2, other.largest2);
        count += other.count;
    }
};

/// A root mean square is known well enough where its standard error is at most this part of it.
constexpr double kRmsError = 0.01;
/// Points that are measured whatever that says, so that it says something.
constexpr std::size_t kLeastPoints = 6000;

/// Is the root of \p meanSquare known well enough by \p points? \param error2 squared standard error of the
/// mean square \param largest2 what may be found where none of the points is, which is about one of as many
/// parts of the surface
inline bool IsPrecise(double meanSquare, double error2, double largest2, std::size_t points)
{
    const double allowed = 2 * kRmsError * meanSquare; // the derivative of the root
    return points >= kLeastPoints && error2 <= allowed * allowed &&
           largest2 <= allowed * static_cast<double>(points);
}

/// Points are measured in batches until a mean is known well enough: every kBatches-th point is one, in an
/// order in which those of the first few batches, too, are spread evenly.
constexpr std::array<std::size_t, 16> kBatches{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};

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
            const double wanted = doubleArea * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
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

/// Measures those of \p count points that belong to a batch, into \p all.
template <class PointAt>
void MeasureBatch(const ExactSurface& to, std::size_t batch, std::size_t count, const PointAt& point,
                  int threads, OneWay& all)
{
    const std::size_t first = kBatches[batch], step = kBatches.size();
    const std::size_t points = count > first ? (count - first - 1) / step + 1 : 0;
    std::vector<OneWay> parts((points + kGrain - 1) / kGrain);
    ParallelRanges(threads, points, kGrain, [&](std::size_t begin, std::size_t end, int) {
        OneWay part;
        ExactSurface::Search search;
        for (std::size_t i = begin; i < end; ++i) part.Add(to.Distance2(point(first + i * step), search));
        parts[begin / kGrain] = part;
    });
    for (const OneWay& part : parts) all.Add(part); // in this order, whatever the threads
}

/// The larger of \p known2 and the largest squared distance of \p count points, those that follow each other
/// near each other.
template <class PointAt>
double Largest2(const ExactSurface& to, std::size_t count, const PointAt& point, double known2, int threads)
{
    // A face comes near several points only where they are not much sparser than the faces.
    const std::size_t most = 2 * count > to.FaceCount() ? GroupSearch::kMost : 1;
    std::vector<double> parts((count + kGrain - 1) / kGrain, known2);
    ParallelRanges(threads, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
        double& largest2 = parts[begin / kGrain];
        GroupSearch search(to);
        for (std::size_t first = begin; first < end; first += most) {
            search.Take(std::min(end - first, most), [&](std::size_t i) { return point(first + i); });
            largest2 = search.LargerDistance2(largest2);
        }
    });
    for (const double part : parts) known2 = std::max(known2, part);
    return known2;
}

/// \param origins for each simplified face one of the original that may be near it; may be empty
/// \param near2 squared distance within which most centroids are
inline std::size_t CountFolded(const ExactSurface& original, const ExactSurface& simplified,
                               const std::vector<std::uint32_t>& origins, double near2, int threads)
{
    const Buffer<std::uint32_t>& order = simplified.Tree().Order();
    std::vector<std::size_t> parts((order.size() + kGrain - 1) / kGrain);
    ParallelRanges(threads, order.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        ExactSurface::Search search;
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t f = order[i];
            const Vector3<double> direction = simplified.AreaVector(f);
            const Vector3<double> centroid =
                (1.0 / 3) * (simplified.Corner(f, 0) + simplified.Corner(f, 1) + simplified.Corner(f, 2));
            // A near face that faces along, to begin with: most often none that faces away is as near.
            if (!origins.empty()) search.last = origins[f];
            if (!search.last || Dot(original.AreaVector(*search.last), direction) <= 0)
                original.LargerDistance2(centroid, near2, search);
            if (original.FacesAwayFrom(centroid, direction, search)) ++parts[begin / kGrain];
        }
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

/// Takes the vertices out of both lists, of those on faces, that are still where they were: their distance is
/// 0, both ways.
inline void DropUnmoved(const MeshView& original, const DecimatedMesh& simplified,
                        std::vector<std::uint32_t>& vertices, std::vector<std::uint32_t>& resultVertices)
{
    if (simplified.vertexOrigin.empty()) return;
    std::vector<bool> unmoved(original.vertexCount);
    const auto isUnmoved = [&](std::uint32_t v) {
        const std::uint32_t origin = simplified.vertexOrigin[v];
        if (simplified.positions[v] != original.Position(origin)) return false;
        unmoved[origin] = true;
        return true;
    };
    resultVertices.erase(std::remove_if(resultVertices.begin(), resultVertices.end(), isUnmoved),
                         resultVertices.end());
    const auto wasUnmoved = [&](std::uint32_t v) { return unmoved[v]; };
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), wasUnmoved), vertices.end());
}

/// The tenth of \p vertices with the largest value, in their order; ties by index.
inline std::vector<std::uint32_t> LargestTenth(const std::vector<std::uint32_t>& vertices,
                                               const std::vector<float>& value)
{
    if (vertices.empty()) return {};
    const std::size_t count = (vertices.size() + 9) / 10;
    std::vector<float> ranked(vertices.size());
    std::transform(vertices.begin(), vertices.end(), ranked.begin(),
                   [&](std::uint32_t v) { return value[v]; });
    const auto last = ranked.begin() + static_cast<std::ptrdiff_t>(count - 1);
    std::nth_element(ranked.begin(), last, ranked.end(), std::greater<>());
    std::vector<std::uint32_t> tenth, tied;
    for (const std::uint32_t v : vertices) {
        if (value[v] == *last) tied.push_back(v);
        if (value[v] >= *last) tenth.push_back(v);
    }
    if (tenth.size() <= count) return tenth;          // fewer where values are no numbers
    const std::size_t surplus = tenth.size() - count; // of those that are tied, the largest indices
    const auto kept = tied.begin() + static_cast<std::ptrdiff_t>(tied.size() - surplus);
    std::nth_element(tied.begin(), kept, tied.end());
    const auto isSurplus = [&](std::uint32_t v) { return value[v] == *last && v >= *kept; };
    tenth.erase(std::remove_if(tenth.begin(), tenth.end(), isSurplus), tenth.end());
    return tenth;
}

} // namespace distance_detail

/// Measures both ways: the largest distance with every vertex of both and \p samples points by area a side,
/// the rms with so many of these that its standard error is at most kRmsError of it. The feature rms is that
/// of all the features, or of as many as give it the same standard error. \param original with a face \param
/// tree of its faces \param simplified with a face \param simplifiedTree of its faces, in the same frame
/// \param descriptor one value a vertex of \p original, says where its features are \pre finite positions
inline DistanceReport MeasureDistances(const MeshView& original, const FaceTree& tree,
                                       const DecimatedMesh& simplified, const FaceTree& simplifiedTree,
                                       const std::vector<float>& descriptor, std::size_t samples, int threads,
                                       const StageProgress& progress = {})
{
    using namespace distance_detail;
    const auto reached = [&](int percent, int until, int loops = 1) {
        progress(percent, "Measuring distances", until, loops);
    };
    std::vector<std::uint8_t> fixed;
    const MeshView result = ViewOf(simplified, original, fixed);
    const float slack = RoundingOf(original, result, tree.frame());
    const ExactSurface from(original, tree, slack), to(result, simplifiedTree, slack);

    const SurfaceSamples fromSamples(from, samples, threads), toSamples(to, samples, threads);
    auto vertices = ReferencedVertices(original, tree),
         resultVertices = ReferencedVertices(result, simplifiedTree);
    const auto features = LargestTenth(vertices, descriptor);
    DropUnmoved(original, simplified, vertices, resultVertices);
    const auto vertexAt = [&](std::size_t i) { return from.Vertex(vertices[i]); };
    const auto featureAt = [&](std::size_t i) { return from.Vertex(features[i]); };
    const auto resultVertexAt = [&](std::size_t i) { return to.Vertex(resultVertices[i]); };

    reached(8, 28, 2);
    OneWay forward, backward, feature;
    double largest2 = 0;
    for (std::size_t batch = 0; batch < kBatches.size(); ++batch) {
        MeasureBatch(to, batch, fromSamples.size(), fromSamples, threads, forward);
        MeasureBatch(from, batch, toSamples.size(), toSamples, threads, backward);
        largest2 = std::max({largest2, forward.largest2, backward.largest2});
        if (batch == 0) { // far fewer vertices are farther than some points
            reached(28, 40);
            largest2 = Largest2(to, vertices.size(), vertexAt, largest2, threads);
            reached(40, 84, 3);
            largest2 = Largest2(from, resultVertices.size(), resultVertexAt, largest2, threads);
            // The farthest point may lie inside a face: no sample is left out, though few are measured
            // exactly.
            largest2 = Largest2(to, fromSamples.size(), fromSamples, largest2, threads);
            largest2 = Largest2(from, toSamples.size(), toSamples, largest2, threads);
            reached(84, 86, 2);
        }
        const double error2 = forward.StandardError2() + backward.StandardError2();
        if (IsPrecise(forward.MeanSquare() + backward.MeanSquare(), error2, largest2,
                      std::min(forward.count, backward.count)))
            break;
    }
    reached(86, 96);
    for (std::size_t batch = 0; batch < kBatches.size(); ++batch) {
        MeasureBatch(to, batch, features.size(), featureAt, threads, feature);
        if (IsPrecise(feature.MeanSquare(), feature.StandardError2(), largest2, feature.count)) break;
    }

    // The frame may be the simplified mesh's; percents are of the original's diagonal.
    const double percent = 100 / kFrameDiagonal * (FrameOf(original).scale / tree.frame().scale);
    DistanceReport report;
    report.hausdorff = percent * std::sqrt(largest2);
    report.rms = percent * std::sqrt((forward.MeanSquare() + backward.MeanSquare()) / 2);
    report.featureRms = percent * std::sqrt(feature.MeanSquare());
    reached(96, 100);
    report.folded = CountFolded(from, to, simplified.faceOrigin, largest2, threads);
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
    return MeasureDistances(original, tree, simplified, resultTree, descriptor, samples, threads);
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
