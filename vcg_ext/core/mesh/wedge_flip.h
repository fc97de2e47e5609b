// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/surface_wedges.h"

namespace vcg_ext
{

/// The wedges around an edge a b with the faces (a, b, c) and (b, a, d), seen from the corners of a in the
/// first face and of b in the second.
class WedgeFlip
{
    const SurfaceArrays& surface_;
    SurfaceWedges& wedges_;
    std::array<Corner, 3> first_, second_; ///< of a, b, c and of b, a, d

  public:
    /// \pre \p surface has wedges
    WedgeFlip(const SurfaceArrays& surface, Corner atA, Corner atB)
        : surface_(surface), wedges_(*surface.wedges), first_(CornersFrom(atA)), second_(CornersFrom(atB))
    {
    }

    /// May the edge be flipped? It is no seam, the texture turns nowhere, and both diagonals carry the same
    /// values where they pass each other.
    bool IsAllowed() const
    {
        const std::uint32_t a = Id(first_[0]), b = Id(first_[1]), c = Id(first_[2]), d = Id(second_[2]);
        if (a != Id(second_[1]) || b != Id(second_[0])) return false;
        for (const std::uint32_t first : wedges_.channels.textures) {
            const double before0 = wedges_.TextureArea(a, b, c, first);
            const double before1 = wedges_.TextureArea(b, a, d, first);
            if (!(before0 * before1 > 0) || TextureTurns(before0, wedges_.TextureArea(a, d, c, first)) ||
                TextureTurns(before0, wedges_.TextureArea(b, c, d, first)))
                return false;
        }
        return Difference2(a, b, c, d) <= kMostDifference * kMostDifference;
    }

    /// Gives the new faces (a, d, c) and (b, c, d) their wedges.
    void Flip()
    {
        Id(first_[1]) = Id(second_[2]);
        Id(second_[1]) = Id(first_[2]);
    }

  private:
    static constexpr float kMostDifference = 0.05f; ///< of texture: part of the shorter diagonal
    static constexpr float kValueScale = 2;         ///< of values: so many times their unit

    static std::array<Corner, 3> CornersFrom(Corner corner)
    {
        const int k = IndexOf(corner);
        return {corner, MakeCorner(FaceOf(corner), kNextIndex[k]),
                MakeCorner(FaceOf(corner), kPreviousIndex[k])};
    }
    std::uint32_t& Id(Corner corner) const
    {
        return wedges_.ofFace[FaceOf(corner)][static_cast<std::size_t>(IndexOf(corner))];
    }
    Vector3<float> Position(Corner corner) const
    {
        return PositionOf(surface_, surface_.triangles[FaceOf(corner)].v[IndexOf(corner)]);
    }

    /// Squared, where a b and c d are closest to each other.
    float Difference2(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const
    {
        const Vector3<float> pa = Position(first_[0]);
        const Vector3<float> ab = Position(first_[1]) - pa, ac = Position(first_[2]) - pa;
        const Vector3<float> ad = Position(second_[2]) - pa, cd = ad - ac;
        const float xx = Dot(ab, ab), xy = Dot(ab, cd), yy = Dot(cd, cd), xz = Dot(ab, ac), yz = Dot(cd, ac);
        const float determinant = xx * yy - xy * xy;
        if (!(determinant > 0)) return 0;
        const float s = (xz * yy - xy * yz) / determinant, t = (xy * xz - xx * yz) / determinant;
        const float area = Norm(Cross(ab, ac)) + Norm(Cross(ab, ad));
        const float shorter2 = std::min(xx, yy);
        float sum = 0;
        for (std::size_t k = 0; k < wedges_.channels.size(); ++k) {
            const auto value = [&](std::uint32_t wedge) { return wedges_.Values(wedge)[k]; };
            const float difference =
                value(a) + s * (value(b) - value(a)) - value(c) - t * (value(d) - value(c));
            sum += difference * difference * Scale2(a, b, c, d, k, area / shorter2);
        }
        return sum;
    }
    /// What a squared difference of channel \p k counts for. \param area of both faces, times two, over the
    /// squared length of the shorter diagonal
    float Scale2(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::size_t k,
                 float area) const
    {
        const Channels& channels = wedges_.channels;
        if (channels.kinds[k] != ChannelKind::Texture) {
            const float scale = kValueScale / channels.unit[k];
            return scale * scale;
        }
        const auto first =
            static_cast<std::uint32_t>(k > 0 && channels.kinds[k - 1] == ChannelKind::Texture &&
                                               channels.group[k - 1] == channels.group[k]
                                           ? k - 1
                                           : k);
        const double texture =
            std::fabs(wedges_.TextureArea(a, b, c, first)) + std::fabs(wedges_.TextureArea(b, a, d, first));
        return texture > 0 ? area / static_cast<float>(texture) : 0;
    }
};

/// Marks vertices on seams as the collapse does: kSeamVertex, and kSeamCorner unless they are inner ones of a
/// single seam. \pre \p surface has wedges, corner lists and border marks
inline void MarkSeams(SurfaceArrays& surface)
{
    const auto id = [&](std::uint32_t f, std::uint32_t v) {
        const std::uint32_t* corners = surface.triangles[f].v;
        return surface.wedges->ofFace[f][corners[0] == v ? 0 : corners[1] == v ? 1 : 2];
    };
    const auto seamSides = [&](std::uint32_t v) {
        int sides = 0;
        for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
            for (const std::uint32_t w : {NextVertex(surface, *c), PreviousVertex(surface, *c)}) {
                int others = 0;
                bool differs = false;
                for (const Corner* d = BeginCorners(surface, v); d != EndCorners(surface, v); ++d) {
                    const std::uint32_t f = FaceOf(*c), g = FaceOf(*d);
                    if (f == g || !HasVertex(surface.triangles[g], w)) continue;
                    ++others;
                    differs |= id(f, v) != id(g, v) || id(f, w) != id(g, w);
                }
                sides += others == 1 && differs;
            }
        return sides;
    };
    constexpr int kInner = 4; // two edges with two faces
    for (std::uint32_t v = 0; v < surface.VertexCount(); ++v) {
        const int sides = surface.wedges->keepSeams ? seamSides(v) : 0;
        unsigned flags = surface.flags[v] & ~unsigned{kSeamVertex | kSeamCorner};
        if (sides > 0) flags |= kSeamVertex;
        if (sides > 0 && (sides != kInner || (flags & kBorderVertex))) flags |= kSeamCorner;
        surface.flags[v] = static_cast<std::uint8_t>(flags);
    }
}

} // namespace vcg_ext
