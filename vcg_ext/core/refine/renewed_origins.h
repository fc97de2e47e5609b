// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/surface_walk.h"

// An exchange takes a vertex and two faces from one place to another. What callers keep by origin, as colors,
// materials and selections, should be that of the new place.

namespace vcg_ext
{

/// Finds input elements that no element of the result comes from, near places of the original.
class FreeOrigins
{
    const MeshView& input_;
    const SurfaceArrays& original_;
    const std::vector<std::uint32_t>& faceOrder_;
    std::vector<std::uint8_t> isVertexUsed_, isFaceUsed_;
    std::uint32_t nextVertex_ = 0, nextFace_ = 0; ///< none before them is free
    std::vector<std::uint32_t> seenIn_;           ///< the search that has seen a face last
    std::uint32_t search_ = 0;
    std::vector<std::uint32_t> queue_;

  public:
    /// \param input whose faces are those of \p surface.original, in the order of surface.faceOrder
    FreeOrigins(const MeshView& input, const CollapsedSurface& surface)
        : input_(input), original_(surface.original), faceOrder_(surface.faceOrder),
          isVertexUsed_(input.vertexCount, 0), isFaceUsed_(input.faceCount, 0),
          seenIn_(surface.original.FaceCount(), 0)
    {
        for (const std::uint32_t v : surface.vertexOrigin) isVertexUsed_[v] = 1;
        for (const std::uint32_t f : surface.faceOrigin) isFaceUsed_[f] = 1;
    }

    void FreeVertex(std::uint32_t origin) { isVertexUsed_[origin] = 0; }
    void FreeFace(std::uint32_t origin) { isFaceUsed_[origin] = 0; }

    /// A vertex that is free from now on no longer, near \p place or, where there is none, anywhere.
    /// \pre one is free
    std::uint32_t TakeVertex(SurfacePlace place)
    {
        std::uint32_t found = kNone;
        ForEachFaceAround(place, [&](std::uint32_t face) {
            for (std::size_t k = 0; k < 3 && found == kNone; ++k)
                if (const std::uint32_t v = input_.triangles[3 * std::size_t{face} + k]; !isVertexUsed_[v])
                    found = v;
            return found == kNone;
        });
        return Take(isVertexUsed_, found, nextVertex_);
    }
    std::uint32_t TakeFace(SurfacePlace place)
    {
        std::uint32_t found = kNone;
        ForEachFaceAround(place, [&](std::uint32_t face) {
            if (!isFaceUsed_[face]) found = face;
            return found == kNone;
        });
        return Take(isFaceUsed_, found, nextFace_);
    }

  private:
    static std::uint32_t Take(std::vector<std::uint8_t>& isUsed, std::uint32_t found, std::uint32_t& next)
    {
        if (found == kNone) {
            while (isUsed[next]) ++next;
            found = next;
        }
        isUsed[found] = 1;
        return found;
    }
    std::uint32_t FirstFace(SurfacePlace place) const
    {
        if (place == kNone) return kNone;
        if (IsFace(place)) return place & ~kFacePlace;
        return original_.cornerCount[place] > 0 ? FaceOf(*BeginCorners(original_, place)) : kNone;
    }
    /// Calls visit(input face) for the faces around \p place, ring by ring, as long as it returns true; not
    /// for more than so many.
    template <class Visit>
    void ForEachFaceAround(SurfacePlace place, const Visit& visit)
    {
        constexpr std::size_t kMaxFacesAround = 4096;
        const std::uint32_t first = FirstFace(place);
        if (first == kNone) return;
        ++search_;
        queue_.assign(1, first);
        seenIn_[first] = search_;
        for (std::size_t i = 0; i < queue_.size() && i < kMaxFacesAround; ++i) {
            const std::uint32_t face = queue_[i];
            if (!visit(faceOrder_.empty() ? face : faceOrder_[face])) return;
            for (const std::uint32_t v : original_.triangles[face].v)
                for (const Corner* c = BeginCorners(original_, v); c != EndCorners(original_, v); ++c)
                    if (std::exchange(seenIn_[FaceOf(*c)], search_) != search_) queue_.push_back(FaceOf(*c));
        }
    }
};

/// Gives what exchanges have renewed an origin near where it is now. No two elements get the same.
inline void RenameRenewed(const MeshView& input, const RenewedPlaces& renewed, CollapsedSurface& surface)
{
    if (renewed.vertices.empty() && renewed.faces.empty()) return;
    FreeOrigins free(input, surface);
    for (const RenewedPlace& v : renewed.vertices) free.FreeVertex(surface.vertexOrigin[v.element]);
    for (const RenewedPlace& f : renewed.faces) free.FreeFace(surface.faceOrigin[f.element]);
    for (const RenewedPlace& v : renewed.vertices) surface.vertexOrigin[v.element] = free.TakeVertex(v.place);
    for (const RenewedPlace& f : renewed.faces) surface.faceOrigin[f.element] = free.TakeFace(f.place);
}

} // namespace vcg_ext
