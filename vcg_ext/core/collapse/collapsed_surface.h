// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/collapse/trace.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/surface_wedges.h"

namespace vcg_ext
{

struct BoundTask;

/// What the stages behind the collapse need of it.
struct KeptForLater {
    bool original = false;   ///< CollapsedSurface::original and root
    bool descriptor = false; ///< CollapsedSurface::descriptor
    BoundTask* bound =
        nullptr; ///< keeps both surfaces this close, CollapsedSurface::coveredBy; null: no bound
    /// One byte an input vertex, not 0: faces may not cross where it goes; null: they may everywhere.
    const std::vector<std::uint8_t>* guarded = nullptr;
};

/// What a collapse hands on to the stages behind it: the surface that is left and, where the refinement needs
/// it, the original in the same frame.
struct CollapsedSurface {
    Frame frame;
    SurfaceArrays simplified;           ///< corner lists are filled where `original` is
    Buffer<std::uint32_t> vertexOrigin; ///< the input vertex that each of its vertices was
    Buffer<std::uint32_t> faceOrigin;   ///< the input face that each of its faces was
    /// Of the vertices without kMovedVertex, in the mesh's own coordinates; empty: where the input has them.
    std::vector<std::array<double, 3>> positions;

    SurfaceArrays original;     ///< with sample weights e^{2 l}; empty where nobody will refine
    Buffer<std::uint32_t> root; ///< the simplified vertex that each original one was merged into

    /// All input faces, those that are close in space close to each other; may be empty.
    std::vector<std::uint32_t> faceOrder;
    /// The Laplacian descriptor of every input vertex up to a factor; empty where the collapse had no use for
    /// it.
    std::vector<float> descriptor;
    /// The input face of the face that is close to each input vertex, where there was a bound; kNone of those
    /// without faces.
    std::vector<std::uint32_t> coveredBy;
    std::optional<SurfaceWedges> wedges; ///< of the simplified faces, where the mesh has attributes
    StopReason stopReason = StopReason::Target;
    CollapseTrace trace;
};

namespace collapsed_surface_detail
{

constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

/// \return for every place of the input the element that was there, or kNowhere
inline Buffer<std::uint32_t> ByOrigin(const Buffer<std::uint32_t>& origin, std::size_t inputSize)
{
    Buffer<std::uint32_t> at(inputSize);
    std::fill(at.begin(), at.end(), kNowhere);
    for (std::uint32_t i = 0; i < origin.size(); ++i) at[origin[i]] = i;
    return at;
}

inline std::array<double, 3> PositionOf(const MeshView& input, const CollapsedSurface& surface,
                                        std::uint32_t v)
{
    if (surface.simplified.flags[v] & kMovedVertex)
        return surface.frame.OutOf(::vcg_ext::PositionOf(surface.simplified, v));
    return surface.positions.empty() ? input.Position(surface.vertexOrigin[v]) : surface.positions[v];
}

} // namespace collapsed_surface_detail

/// The simplified surface as a mesh, vertices and faces in the order of the input. Vertices that never moved
/// have the input's coordinates to the last bit.
inline DecimatedMesh ToMesh(const MeshView& input, const CollapsedSurface& surface)
{
    using namespace collapsed_surface_detail;
    DecimatedMesh mesh;
    mesh.stopReason = surface.stopReason;
    const std::size_t vertices = surface.vertexOrigin.size(), faces = surface.faceOrigin.size();
    mesh.positions.reserve(vertices);
    mesh.vertexOrigin.reserve(vertices);
    Buffer<std::uint32_t> place(vertices);
    const Buffer<std::uint32_t> vertexAt = ByOrigin(surface.vertexOrigin, input.vertexCount);
    for (std::uint32_t origin = 0; origin < input.vertexCount; ++origin) {
        const std::uint32_t v = vertexAt[origin];
        if (v == kNowhere) continue;
        place[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(PositionOf(input, surface, v));
        mesh.vertexOrigin.push_back(origin);
    }
    mesh.triangles.reserve(faces);
    mesh.faceOrigin.reserve(faces);
    if (surface.wedges) {
        mesh.wedges = surface.wedges;
        mesh.wedges->ofFace.clear();
        mesh.wedges->chart.clear();
    }
    const Buffer<std::uint32_t> faceAt = ByOrigin(surface.faceOrigin, input.faceCount);
    for (std::uint32_t origin = 0; origin < input.faceCount; ++origin) {
        const std::uint32_t f = faceAt[origin];
        if (f == kNowhere) continue;
        const std::uint32_t* v = surface.simplified.triangles[f].v;
        mesh.triangles.push_back({place[v[0]], place[v[1]], place[v[2]]});
        mesh.faceOrigin.push_back(origin);
        if (!surface.wedges) continue;
        mesh.wedges->ofFace.push_back(surface.wedges->ofFace[f]);
        mesh.wedges->chart.push_back(surface.wedges->chart[f]);
    }
    return mesh;
}

} // namespace vcg_ext
