// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/closest.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/simplex/face/distance.h>
#include <vcg/space/index/grid_static_ptr.h>

#include "vcg_ext/core/mesh/decimation_types.h"
#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{
namespace distance_detail
{

class MeasuredVertex;
class MeasuredFace;
struct MeasuredTypes
    : public vcg::UsedTypes<vcg::Use<MeasuredVertex>::AsVertexType, vcg::Use<MeasuredFace>::AsFaceType> {
};
class MeasuredVertex : public vcg::Vertex<MeasuredTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags>
{
};
class MeasuredFace
    : public vcg::Face<MeasuredTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::BitFlags>
{
};
class MeasuredMesh : public vcg::tri::TriMesh<std::vector<MeasuredVertex>, std::vector<MeasuredFace>>
{
};

} // namespace distance_detail

/// A surface that answers "where is the closest point": VCG's static grid over a copy of the triangles.
/// Queries may run on several threads at once.
class ClosestSurface
{
    using Face = distance_detail::MeasuredFace;
    using Point = vcg::Point3d;
    distance_detail::MeasuredMesh mesh_;
    mutable vcg::GridStaticPtr<Face, double> grid_; // VCG's queries only read, but are not declared const
    double farthest_ = 0;

  public:
    /// What a query returns.
    struct Closest {
        double distance;
        vcg::Point3d normal; ///< of the face that holds the closest point, of length 1; 0 on degenerate faces
    };

    /// \pre at least one vertex and one face; triangle(f)[0..2] < vertices; finite positions
    template <class PositionOf, class TriangleOf>
    ClosestSurface(std::size_t vertices, std::size_t faces, const PositionOf& position,
                   const TriangleOf& triangle)
    {
        vcg::tri::Allocator<distance_detail::MeasuredMesh>::AddVertices(mesh_, vertices);
        vcg::tri::Allocator<distance_detail::MeasuredMesh>::AddFaces(mesh_, faces);
        for (std::size_t v = 0; v < vertices; ++v) {
            const std::array<double, 3> p = position(v);
            mesh_.vert[v].P() = Point(p[0], p[1], p[2]);
        }
        vcg::Box3d box;
        for (std::size_t f = 0; f < faces; ++f) {
            const std::array<std::uint32_t, 3> corner = triangle(f);
            for (int k = 0; k < 3; ++k) {
                mesh_.face[f].V(k) = &mesh_.vert[corner[static_cast<std::size_t>(k)]];
                box.Add(mesh_.face[f].P(k));
            }
        }
        vcg::tri::UpdateNormal<distance_detail::MeasuredMesh>::PerFaceNormalized(mesh_);
        farthest_ = std::max(box.Diag() * 16, 1e-30);
        box.Offset(std::max(box.Diag() * 0.01, 1e-30));
        grid_.Set(mesh_.face.begin(), mesh_.face.end(), box);
    }

    Closest Find(const vcg::Point3d& p) const
    {
        vcg::face::PointDistanceBaseFunctor<double> distanceTo;
        vcg::tri::EmptyTMark<distance_detail::MeasuredMesh> unmarked; // keeps no state: safe on many threads
        double distance = farthest_;
        Point closest;
        const Face* face = grid_.GetClosest(distanceTo, unmarked, p, farthest_, distance, closest);
        return {std::abs(distance), face ? face->cN() : Point(0, 0, 0)};
    }

    const distance_detail::MeasuredMesh& Mesh() const { return mesh_; }
};

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
    double largest = 0;
};

constexpr std::size_t kGrain = 1024; ///< points that one thread measures at a time

/// Points spread evenly by area: stratified along the faces, low-discrepancy inside them. Deterministic.
inline std::vector<vcg::Point3d> SamplePoints(const MeasuredMesh& mesh, std::size_t count)
{
    std::vector<double> upTo(mesh.face.size());
    double area = 0;
    for (std::size_t f = 0; f < mesh.face.size(); ++f) upTo[f] = area += vcg::DoubleArea(mesh.face[f]);
    std::vector<vcg::Point3d> points;
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
        const MeasuredFace& face = mesh.face[f];
        points.push_back(face.cP(0) * (1 - a - b) + face.cP(1) * a + face.cP(2) * b);
    }
    return points;
}

template <class PointOf>
OneWay Measure(const ClosestSurface& to, std::size_t count, const PointOf& point, int threads)
{
    std::vector<OneWay> parts((count + kGrain - 1) / kGrain);
    ParallelRanges(threads, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
        OneWay& part = parts[begin / kGrain];
        for (std::size_t i = begin; i < end; ++i) {
            const double d = to.Find(point(i)).distance;
            part.sumOfSquares += d * d;
            part.largest = std::max(part.largest, d);
        }
    });
    OneWay all;
    for (const OneWay& part : parts) { // in this order, whatever the threads
        all.sumOfSquares += part.sumOfSquares;
        all.largest = std::max(all.largest, part.largest);
    }
    return all;
}

inline std::size_t CountFolded(const ClosestSurface& original, const MeasuredMesh& simplified, int threads)
{
    std::vector<std::size_t> parts((simplified.face.size() + kGrain - 1) / kGrain);
    ParallelRanges(threads, simplified.face.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t f = begin; f < end; ++f) {
            const MeasuredFace& face = simplified.face[f];
            const vcg::Point3d centroid = (face.cP(0) + face.cP(1) + face.cP(2)) / 3;
            if (original.Find(centroid).normal * face.cN() < 0) ++parts[begin / kGrain];
        }
    });
    return std::accumulate(parts.begin(), parts.end(), std::size_t{0});
}

/// The tenth of the referenced vertices with the largest value; ties by index.
inline std::vector<std::uint32_t> LargestTenth(const MeshView& view, const std::vector<float>& value)
{
    std::vector<bool> used(view.vertexCount);
    for (std::size_t k = 0; k < 3 * view.faceCount; ++k) used[view.triangles[k]] = true;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < view.vertexCount; ++v)
        if (used[v]) vertices.push_back(v);
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
/// \param descriptor one value a vertex of \p original, says where its features are
/// \pre both have a face; finite positions
inline DistanceReport MeasureDistances(const MeshView& original, const DecimatedMesh& simplified,
                                       const std::vector<float>& descriptor, std::size_t samples = 100000,
                                       int threads = 0)
{
    using namespace distance_detail;
    threads = ResolveThreads(threads);
    vcg::Box3d box;
    for (std::size_t k = 0; k < 3 * original.faceCount; ++k) {
        const auto p = original.Position(original.triangles[k]);
        box.Add(vcg::Point3d(p[0], p[1], p[2]));
    }
    // The grid's steps are relative to the box: far from the origin they would drown in rounding.
    const vcg::Point3d center = box.Center();
    const double scale = box.Diag() > 0 ? 1 / box.Diag() : 1;
    constexpr double percent = 100;
    const auto framed = [&](const std::array<double, 3>& p) {
        return std::array<double, 3>{(p[0] - center[0]) * scale, (p[1] - center[1]) * scale,
                                     (p[2] - center[2]) * scale};
    };
    const auto pointOfOriginal = [&](std::size_t v) {
        const auto p = framed(original.Position(v));
        return vcg::Point3d(p[0], p[1], p[2]);
    };
    const ClosestSurface from(
        original.vertexCount, original.faceCount, [&](std::size_t v) { return framed(original.Position(v)); },
        [&](std::size_t f) {
            const std::uint32_t* t = original.triangles + 3 * f;
            return std::array<std::uint32_t, 3>{t[0], t[1], t[2]};
        });
    const ClosestSurface to(
        simplified.positions.size(), simplified.triangles.size(),
        [&](std::size_t v) { return framed(simplified.positions[v]); },
        [&](std::size_t f) { return simplified.triangles[f]; });

    const auto fromPoints = SamplePoints(from.Mesh(), samples);
    const auto toPoints = SamplePoints(to.Mesh(), samples);
    const auto features = LargestTenth(original, descriptor);
    const auto forward = Measure(
        to, fromPoints.size(), [&](std::size_t i) { return fromPoints[i]; }, threads);
    const auto backward = Measure(
        from, toPoints.size(), [&](std::size_t i) { return toPoints[i]; }, threads);
    const auto feature = Measure(
        to, features.size(), [&](std::size_t i) { return pointOfOriginal(features[i]); }, threads);
    std::vector<std::uint32_t> corners(original.triangles, original.triangles + 3 * original.faceCount);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    const auto vertices = Measure(
        to, corners.size(), [&](std::size_t i) { return pointOfOriginal(corners[i]); }, threads);
    const auto back = Measure(
        from, simplified.positions.size(), [&](std::size_t v) { return to.Mesh().vert[v].cP(); }, threads);

    const auto mean = [](const OneWay& way, std::size_t count) {
        return count > 0 ? way.sumOfSquares / static_cast<double>(count) : 0.0;
    };
    DistanceReport report;
    report.hausdorff =
        percent * std::max({forward.largest, backward.largest, vertices.largest, back.largest});
    report.rms =
        percent * std::sqrt((mean(forward, fromPoints.size()) + mean(backward, toPoints.size())) / 2);
    report.featureRms = percent * std::sqrt(mean(feature, features.size()));
    report.folded = CountFolded(from, to.Mesh(), threads);
    return report;
}

} // namespace vcg_ext
