// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/refine/refine.h"

/// Pairs of an original and a simplified surface for the refinement, and what is measured on them.
namespace test_meshes
{

/// An original and a simplified surface in one frame, with the nearest vertices as the collapse map.
struct SurfacePair {
    vcg_ext::SurfaceArrays original, simplified;
    vcg_ext::Buffer<std::uint32_t> root;
};

inline SurfacePair MakePair(const IndexedMesh& original, const IndexedMesh& simplified,
                            const std::vector<std::uint8_t>& fixed = {})
{
    const vcg_ext::Frame frame = vcg_ext::FrameOf(View(original));
    vcg_ext::MeshView view = View(simplified);
    if (!fixed.empty()) view.fixedVertices = fixed.data();
    SurfacePair pair{vcg_ext::BuildSurfaceArrays(View(original), frame),
                     vcg_ext::BuildSurfaceArrays(view, frame),
                     vcg_ext::Buffer<std::uint32_t>(original.points.size())};
    for (std::uint32_t v = 0; v < original.points.size(); ++v) {
        float nearest = std::numeric_limits<float>::max();
        pair.root[v] = vcg_ext::kNone;
        for (std::uint32_t w = 0; w < simplified.points.size(); ++w) {
            const float d =
                SquaredNorm(vcg_ext::PositionOf(pair.original, v) - vcg_ext::PositionOf(pair.simplified, w));
            if (pair.simplified.cornerCount[w] == 0 || d >= nearest) continue;
            nearest = d;
            pair.root[v] = w;
        }
    }
    return pair;
}

/// The same where each vertex of the original was collapsed to the one of the same number.
inline SurfacePair MakePairOfSameVertices(const IndexedMesh& original, const IndexedMesh& simplified)
{
    const vcg_ext::Frame frame = vcg_ext::FrameOf(View(original));
    SurfacePair pair{vcg_ext::BuildSurfaceArrays(View(original), frame),
                     vcg_ext::BuildSurfaceArrays(View(simplified), frame),
                     vcg_ext::Buffer<std::uint32_t>(original.points.size())};
    for (std::uint32_t v = 0; v < pair.root.size(); ++v) pair.root[v] = v;
    return pair;
}

inline vcg_ext::RefinementReport Refine(SurfacePair& pair,
                                        const vcg_ext::RefinementParameters& parameters = {})
{
    return vcg_ext::Refine(pair.original, pair.simplified, pair.root, parameters);
}

inline std::vector<unsigned char> Bytes(const vcg_ext::SurfaceArrays& surface)
{
    std::vector<unsigned char> bytes;
    const auto append = [&](const auto& buffer) {
        const auto* data = reinterpret_cast<const unsigned char*>(buffer.data());
        bytes.insert(bytes.end(), data, data + buffer.size() * sizeof(*buffer.data()));
    };
    append(surface.points);
    append(surface.triangles);
    return bytes;
}

inline float ExactSquaredDistance(const vcg_ext::Vector3<float>& p, const vcg_ext::SurfaceArrays& surface)
{
    float nearest = std::numeric_limits<float>::max();
    for (const vcg_ext::SurfaceTriangle& t : surface.triangles) {
        const vcg_ext::Vector3<float> a = vcg_ext::PositionOf(surface, t.v[0]);
        const vcg_ext::Vector3<float> b = vcg_ext::PositionOf(surface, t.v[1]) - a,
                                      c = vcg_ext::PositionOf(surface, t.v[2]) - a;
        nearest = std::min(nearest, vcg_ext::ClosestOnTriangle(p - a, b, c).distance2);
    }
    return nearest;
}

/// Root of the mean squared distance of vertices and face centroids to the other surface, by all faces.
inline double ExactRms(const vcg_ext::SurfaceArrays& from, const vcg_ext::SurfaceArrays& to)
{
    double sum = 0;
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < from.VertexCount(); ++v) {
        if (from.cornerCount[v] == 0) continue;
        sum += static_cast<double>(ExactSquaredDistance(vcg_ext::PositionOf(from, v), to));
        ++count;
    }
    for (std::uint32_t f = 0; f < from.FaceCount(); ++f, ++count)
        sum += static_cast<double>(ExactSquaredDistance(vcg_ext::Centroid(from, f), to));
    return std::sqrt(sum / static_cast<double>(count));
}
inline double ExactRms(const SurfacePair& pair)
{
    return ExactRms(pair.original, pair.simplified) + ExactRms(pair.simplified, pair.original);
}

inline vcg_ext::EdgeCounts Edges(const vcg_ext::SurfaceArrays& surface)
{
    return vcg_ext::CountEdges(surface.FaceCount(), [&](std::size_t f) { return surface.triangles[f].v; });
}

inline std::size_t DifferentFaces(const vcg_ext::SurfaceArrays& surface)
{
    std::set<std::array<std::uint32_t, 3>> faces;
    for (const vcg_ext::SurfaceTriangle& t : surface.triangles) {
        std::array<std::uint32_t, 3> face{t.v[0], t.v[1], t.v[2]};
        std::sort(face.begin(), face.end());
        faces.insert(face);
    }
    return faces.size();
}

/// Do the lists name every corner once, at the vertex it belongs to?
inline bool CornersAreConsistent(const vcg_ext::SurfaceArrays& surface)
{
    std::size_t corners = 0;
    for (std::uint32_t v = 0; v < surface.VertexCount(); ++v)
        for (const auto* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c, ++corners)
            if (surface.triangles[vcg_ext::FaceOf(*c)].v[vcg_ext::IndexOf(*c)] != v) return false;
    return corners == 3 * surface.FaceCount();
}

/// Meshes with every kind of place that the refinement must cope with, coarse and perturbed against fine.
struct Family {
    const char* name;
    IndexedMesh original, simplified;
};
inline std::vector<Family> Families()
{
    std::vector<Family> families;
    families.push_back({"sphere", Icosphere(3), Noisy(Icosphere(2), 0.05)});
    families.push_back({"box", Box(8), Noisy(Box(3), 0.04)});
    families.push_back({"torus", Torus(32, 16), Noisy(Torus(16, 8), 0.04)});
    families.push_back({"open cylinder", OpenCylinder(32, 16), Noisy(OpenCylinder(12, 6), 0.04)});
    families.push_back({"grid", Grid(20, 20, 0.05), Noisy(Grid(6, 6, 1 / 6.0), 0.02)});
    families.push_back({"book", Book(5), Noisy(Book(5), 0.05)});
    families.push_back({"bow tie", BowTie(), Noisy(BowTie(), 0.05)});
    families.push_back(
        {"two components and isolated vertices",
         WithIsolatedVertices(Merged(Icosphere(2), Moved(Icosphere(2), 1, 1, {3, 0, 0})), 3),
         WithIsolatedVertices(Noisy(Merged(Icosphere(1), Moved(Icosphere(1), 1, 1, {3, 0, 0})), 0.05), 2)});
    return families;
}

} // namespace test_meshes
