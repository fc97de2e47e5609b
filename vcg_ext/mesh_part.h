// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "buffer.h"
#include "decimation_types.h"

namespace vcg_ext
{

/// All faces at some vertices of a mesh, in its order, as a mesh with vertices of its own: what is computed
/// from the one-rings of those vertices is the same in both, and costs what they cost.
template <class Scalar>
class MeshPart
{
    std::vector<std::uint32_t> triangles_, origin_;
    std::vector<std::uint8_t> wanted_;
    std::vector<Scalar> positions_;

    static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

    void AddVertex(const MeshView& mesh, std::uint32_t vertex, std::uint8_t wanted)
    {
        const auto* p = static_cast<const unsigned char*>(mesh.positions) + vertex * mesh.positionStride;
        positions_.resize(positions_.size() + 3);
        std::memcpy(&positions_[positions_.size() - 3], p, 3 * sizeof(Scalar));
        origin_.push_back(vertex);
        wanted_.push_back(wanted);
    }

  public:
    /// \param wanted one byte a vertex, not 0: its faces are in the part \pre mesh has no faux edges
    MeshPart(const MeshView& mesh, const std::vector<std::uint8_t>& wanted)
    {
        for (std::size_t f = 0; f < mesh.faceCount; ++f) {
            const std::uint32_t* v = mesh.triangles + 3 * f;
            if (wanted[v[0]] | wanted[v[1]] | wanted[v[2]]) triangles_.insert(triangles_.end(), v, v + 3);
        }
        Buffer<std::uint32_t> place;
        place.AllocateOnLargePages(mesh.vertexCount);
        std::fill(place.begin(), place.end(), kAbsent);
        for (std::uint32_t& v : triangles_) {
            if (place[v] == kAbsent) {
                place[v] = static_cast<std::uint32_t>(origin_.size());
                AddVertex(mesh, v, wanted[v]);
            }
            v = place[v];
        }
    }

    MeshView View() const
    {
        MeshView view;
        view.positions = positions_.data();
        view.positionStride = 3 * sizeof(Scalar);
        view.doublePositions = sizeof(Scalar) == sizeof(double);
        view.vertexCount = origin_.size();
        view.triangles = triangles_.data();
        view.faceCount = triangles_.size() / 3;
        return view;
    }

    /// Of every vertex of the part: its index in the mesh.
    const std::vector<std::uint32_t>& Origin() const { return origin_; }
    /// Of every vertex of the part: not 0 where all its faces are here.
    const std::uint8_t* Wanted() const { return wanted_.data(); }
};

} // namespace vcg_ext
