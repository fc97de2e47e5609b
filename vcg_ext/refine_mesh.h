// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/space/index/kdtree/kdtree.h>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/refine.h"
#include "vcg_ext/mesh_arrays.h"

namespace vcg_ext
{

/// For every vertex of \p original the nearest one of \p simplified that is on a face; kNone where there is
/// none. Stands in for the map of a collapse that nobody kept.
inline Buffer<std::uint32_t> NearestVertices(const SurfaceArrays& original, const SurfaceArrays& simplified,
                                             int threads = 1)
{
    const auto pointOf = [](const SurfacePoint& p) { return vcg::Point3f(p.x, p.y, p.z); };
    std::vector<vcg::Point3f> points;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < simplified.VertexCount(); ++v) {
        if (simplified.cornerCount[v] == 0) continue;
        points.push_back(pointOf(simplified.points[v]));
        vertices.push_back(v);
    }
    Buffer<std::uint32_t> nearest(original.VertexCount());
    std::fill(nearest.begin(), nearest.end(), kNone);
    if (points.empty()) return nearest;
    vcg::KdTree<float> tree(vcg::VectorConstDataWrapper<std::vector<vcg::Point3f>>{points});
    ParallelRanges(threads, nearest.size(), 4096, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v) {
            unsigned int found = 0;
            float distance2 = 0;
            tree.doQueryClosest(pointOf(original.points[v]), found, distance2);
            nearest[v] = vertices[found];
        }
    });
    return nearest;
}

/// Refines a VCG mesh that any tool has simplified against its original; see Refine.
///
/// Vertices that do not move keep their coordinates to the last bit. Adjacency, normals and what is stored
/// per wedge are not updated: flips exchange the corners of faces, so set parameters.flip to false for meshes
/// with texture coordinates per wedge. Faces that a flip has changed lose their faux flags.
/// \tparam Original may be another type of mesh, of the other precision
/// \param fixed one byte per element of simplified.vert, not 0 where it must stay; may be empty
/// \pre both meshes lie in the same place, coordinates are finite
template <class Mesh, class Original>
RefinementReport RefineMesh(Mesh& simplified, const Original& original,
                            const RefinementParameters& parameters = {},
                            const std::vector<std::uint8_t>& fixed = {})
{
    using Scalar = typename Mesh::ScalarType;
    const MeshArrays<Original> originalArrays(original);
    const MeshArrays<Mesh> simplifiedArrays(simplified);
    MeshView view = simplifiedArrays.View();
    if (!fixed.empty()) view.fixedVertices = fixed.data();
    const int threads = ResolveThreads(parameters.threads);
    const Frame frame = FrameOf(originalArrays.View());
    const SurfaceArrays before = BuildSurfaceArrays(originalArrays.View(), frame, nullptr, threads);
    SurfaceArrays after = BuildSurfaceArrays(view, frame, nullptr, threads);
    RefinementReport report = Refine(before, after, NearestVertices(before, after, threads), parameters);

    for (std::uint32_t v = 0; v < after.VertexCount(); ++v) {
        if (!(after.flags[v] & kMovedVertex)) continue;
        const auto p = frame.OutOf(PositionOf(after, v));
        for (int k = 0; k < 3; ++k)
            simplified.vert[v].P()[k] = static_cast<Scalar>(p[static_cast<std::size_t>(k)]);
    }
    for (std::size_t f = 0; f < after.FaceCount(); ++f) {
        auto& face = simplified.face[simplifiedArrays.FaceIndex(f)];
        for (int k = 0; k < 3; ++k) {
            auto* vertex = &simplified.vert[after.triangles[f].v[k]];
            if (face.V(k) == vertex) continue;
            face.V(k) = vertex;
            for (int edge = 0; edge < 3; ++edge) face.ClearF(edge);
        }
    }
    return report;
}

} // namespace vcg_ext
