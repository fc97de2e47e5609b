// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

namespace vcg_ext
{

namespace polygon_detail
{

/// One edge of one face.
struct Side {
    std::uint64_t edge; ///< both vertices, the smaller index first
    std::uint32_t face;
    std::uint8_t k;
    bool forward; ///< the face runs from the smaller index to the larger one
};

/// All sides of all live faces, those of the same edge one after the other.
template <class Mesh>
std::vector<Side> SortedSides(const Mesh& mesh)
{
    std::vector<Side> sides;
    sides.reserve(3 * mesh.face.size());
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
        const auto& face = mesh.face[f];
        if (face.IsD()) continue;
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t a = vcg::tri::Index(mesh, face.cV0(k)),
                                b = vcg::tri::Index(mesh, face.cV1(k));
            sides.push_back({std::min(a, b) << 32 | std::max(a, b), static_cast<std::uint32_t>(f),
                             static_cast<std::uint8_t>(k), a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::pair(a.edge, a.face) < std::pair(b.edge, b.face);
    });
    return sides;
}

/// Faces that are joined across diagonals.
class Patches
{
    std::vector<std::uint32_t> parent_;

  public:
    explicit Patches(std::size_t faces) : parent_(faces)
    {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::uint32_t PatchOf(std::uint32_t face)
    {
        while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
        return face;
    }

    void Join(std::uint32_t a, std::uint32_t b) { parent_[PatchOf(a)] = PatchOf(b); }

    /// A patch of n faces has at most n + 2 vertices: three, and one more with each further face. It has as
    /// many where it is a simple polygon: no vertex is inside, or twice on its border. \returns one flag for
    /// each face, set at patches
    template <class Mesh>
    std::vector<bool> SimplePolygons(const Mesh& mesh)
    {
        std::vector<std::size_t> faces(parent_.size()), vertices(parent_.size());
        std::vector<std::pair<std::uint32_t, std::size_t>> corners;
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            if (mesh.face[f].IsD()) continue;
            const std::uint32_t patch = PatchOf(static_cast<std::uint32_t>(f));
            ++faces[patch];
            for (int k = 0; k < 3; ++k)
                corners.emplace_back(patch, vcg::tri::Index(mesh, mesh.face[f].cV(k)));
        }
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        for (const auto& [patch, vertex] : corners) ++vertices[patch];
        std::vector<bool> simple(parent_.size());
        for (std::size_t f = 0; f < simple.size(); ++f) simple[f] = vertices[f] == faces[f] + 2;
        return simple;
    }
};

} // namespace polygon_detail

/// Leaves faux flags (diagonals of polygons) only where the faces that they join make up a simple polygon.
/// MeshLab's writers walk around a polygon until they are where they began; around anything else they walk
/// for ever.
///
/// A diagonal has exactly two faces, which run through it in opposite directions and both have the flag.
/// \pre the mesh has fewer than 2^32 vertices and faces
template <class Mesh>
void ClearFauxEdgesOutsidePolygons(Mesh& mesh)
{
    if (std::none_of(mesh.face.begin(), mesh.face.end(),
                     [](const auto& f) { return !f.IsD() && f.IsAnyF(); }))
        return;
    const std::vector<polygon_detail::Side> sides = polygon_detail::SortedSides(mesh);
    polygon_detail::Patches patches(mesh.face.size());
    const auto isFaux = [&](const polygon_detail::Side& side) { return mesh.face[side.face].IsF(side.k); };
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        while (end < sides.size() && sides[end].edge == sides[i].edge) ++end;
        if (end - i == 2 && sides[i].forward != sides[i + 1].forward && isFaux(sides[i]) &&
            isFaux(sides[i + 1]))
            patches.Join(sides[i].face, sides[i + 1].face);
        else
            for (std::size_t j = i; j < end; ++j) mesh.face[sides[j].face].ClearF(sides[j].k);
    }
    const std::vector<bool> simple = patches.SimplePolygons(mesh);
    for (std::size_t f = 0; f < mesh.face.size(); ++f)
        if (!mesh.face[f].IsD() && !simple[patches.PatchOf(static_cast<std::uint32_t>(f))])
            for (int k = 0; k < 3; ++k) mesh.face[f].ClearF(k);
}

} // namespace vcg_ext
