// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace
{

constexpr std::size_t kGrain = 1024; ///< points that one thread measures at a time

vcg_ext::MeshView ViewOf(const laplacian_simplify_surface& surface)
{
    vcg_ext::MeshView view;
    view.positions = surface.positions;
    view.doublePositions = true;
    view.positionStride = 3 * sizeof(double);
    view.vertexCount = surface.vertex_count;
    view.triangles = surface.faces;
    view.faceCount = surface.face_count;
    return view;
}

/// The points in the frame of the surface.
std::vector<vcg_ext::Vector3<double>> InFrame(const vcg_ext::Frame& frame, const double* points,
                                              std::size_t count)
{
    std::vector<vcg_ext::Vector3<double>> inside;
    inside.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        inside.push_back(frame.Into<double>({points[3 * i], points[3 * i + 1], points[3 * i + 2]}));
    return inside;
}

void MeasureDistances(const vcg_ext::MeshView& view, const double* points, std::size_t count, int threads,
                      double* distances)
{
    const vcg_ext::Frame frame = FrameOf(view);
    const vcg_ext::FaceTree tree(view, frame, threads);
    const auto inside = InFrame(frame, points, count);
    double largest = 0;
    for (const auto& p : inside) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const float slack = std::max(RoundingOf(view, view, frame), vcg_ext::RoundingOf(largest));
    const vcg_ext::ExactSurface exact(view, tree, slack);
    vcg_ext::ParallelRanges(threads, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
        vcg_ext::ExactSurface::Search search;
        for (std::size_t i = begin; i < end; ++i)
            distances[i] = std::sqrt(exact.Distance2(inside[i], search)) * frame.unit;
    });
}

/// The edges of a mesh, sorted by their lower vertex: far quicker than sorting them all.
struct EdgesByVertex {
    std::vector<std::uint32_t> begin;  ///< of each vertex in higher, and the end of the last one
    std::vector<std::uint32_t> higher; ///< the other vertex, once a face
};

template <class Visit>
void ForEachEdge(const laplacian_simplify_surface& surface, const std::uint8_t* fixed, const Visit& visit)
{
    for (std::size_t f = 0; f < surface.face_count; ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = surface.faces[3 * f + k], b = surface.faces[3 * f + (k + 1) % 3];
            if (!(fixed[a] && fixed[b])) visit(std::min(a, b), std::max(a, b));
        }
}

EdgesByVertex SortEdges(const laplacian_simplify_surface& surface, const std::uint8_t* fixed)
{
    EdgesByVertex edges;
    edges.begin.resize(surface.vertex_count + 2);
    std::size_t count = 0;
    ForEachEdge(surface, fixed, [&](std::uint32_t low, std::uint32_t) {
        ++edges.begin[low + 2];
        ++count;
    });
    for (std::size_t v = 2; v < edges.begin.size(); ++v) edges.begin[v] += edges.begin[v - 1];
    edges.higher.resize(count);
    ForEachEdge(surface, fixed,
                [&](std::uint32_t low, std::uint32_t high) { edges.higher[edges.begin[low + 1]++] = high; });
    return edges;
}

} // namespace

std::int32_t laplacian_simplify_distances(const laplacian_simplify_surface* surface, const double* points,
                                          std::uint64_t point_count, std::int32_t threads, double* distances)
{
    try {
        const vcg_ext::ThreadsOfRun run; // they end with it
        MeasureDistances(ViewOf(*surface), points, point_count, vcg_ext::ResolveThreads(threads), distances);
        return 0;
    } catch (const std::exception&) { // std::bad_alloc, std::length_error

        return 1;
    }
}

std::int32_t laplacian_simplify_descriptor(const laplacian_simplify_surface* surface, std::int32_t threads,
                                           double* values)
{
    try {
        const vcg_ext::ThreadsOfRun run; // they end with it
        const std::vector<double> found =
            vcg_ext::LaplacianDescriptor(ViewOf(*surface), vcg_ext::ResolveThreads(threads));
        std::copy(found.begin(), found.end(), values);
        return 0;
    } catch (const std::exception&) { // std::bad_alloc, std::length_error

        return 1;
    }
}

std::int32_t laplacian_simplify_edges(const laplacian_simplify_surface* surface,
                                      const std::uint8_t* fixed_vertices, std::uint64_t* boundary,
                                      std::uint64_t* non_manifold)
{
    *boundary = *non_manifold = 0;
    try {
        EdgesByVertex edges = SortEdges(*surface, fixed_vertices);
        for (std::size_t v = 0; v < surface->vertex_count; ++v) {
            const auto end = edges.higher.begin() + edges.begin[v + 1];
            auto first = edges.higher.begin() + edges.begin[v];
            std::sort(first, end);
            while (first != end) {
                const auto next = std::upper_bound(first, end, *first);
                *boundary += next - first == 1;
                *non_manifold += next - first > 2;
                first = next;
            }
        }
        return 0;
    } catch (const std::exception&) { // std::bad_alloc, std::length_error

        return 1;
    }
}
