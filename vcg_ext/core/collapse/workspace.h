// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/bound/trial_faces.h"
#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// One thread's room for new corner lists behind those of the pool. Room is claimed in chunks; where a list
/// comes to lie depends on the threads, what is in it does not.
class CornerArena
{
    static constexpr std::uint32_t kChunk = 4096;
    static constexpr std::uint32_t kLongList = kChunk / 8; ///< from here on a list claims room of its own

    std::uint32_t next_ = 0, end_ = 0;

  public:
    /// Entries of a pool that holds \p corners corners in compact lists and all lists that one sweep makes.
    /// No vertex takes part in two collapses of a sweep, so the new lists together are not longer than the
    /// old ones; an eighth of each chunk at most is left unused.
    static std::size_t PoolSize(std::size_t corners, int threads)
    {
        return corners + corners + corners / 7 + (static_cast<std::size_t>(threads) + 1) * kChunk;
    }

    /// Forgets what was claimed; a new sweep has compact lists again.
    void Reset() { next_ = end_ = 0; }

    /// Room for \p size corners. \param poolEnd end of what all threads have claimed
    std::uint32_t Claim(std::uint32_t size, std::uint32_t& poolEnd)
    {
        if (size > kLongList) return FetchAdd(poolEnd, size);
        if (end_ - next_ < size) {
            next_ = FetchAdd(poolEnd, kChunk);
            end_ = next_ + kChunk;
        }
        const std::uint32_t begin = next_;
        next_ += size;
        return begin;
    }
};

/// The neighbours of the vertex that is looked at, and what merging with each of them would cost. Grows to
/// any valence; arrays are padded so that whole vectors may be written.
struct NeighbourScratch {
    static constexpr std::size_t kPadding = 8;
    Buffer<std::uint32_t> vertex;
    Buffer<float> cost;
    std::uint32_t size = 0;

    void Reserve(std::size_t wanted)
    {
        if (wanted + kPadding <= vertex.size()) return;
        const std::size_t room = std::max<std::size_t>(64, 2 * wanted + kPadding);
        vertex.Allocate(room);
        cost.Allocate(room);
    }
};

/// The change of one face's m m^T, as it is added to the star quadrics of its other two vertices.
struct alignas(16) StarChange {
    float value[8]; ///< xx xy xz yy yz zz 0 0
};
struct alignas(16) NewNormal {
    float value[4]; ///< m and a zero
};

/// Both stars of an edge that is tried: the faces that stay, first those of the vertex that would go, and the
/// faces that would die. The ring kernel adds what a collapse then writes.
struct StarScratch {
    Buffer<std::uint32_t> next, previous; ///< of each kept corner
    Buffer<Corner> corner;
    Buffer<NewNormal> normal;
    Buffer<StarChange> change;
    Buffer<std::uint32_t> deadFace, wing; ///< wing: the vertex of the dead face that is not on the edge
    Buffer<std::uint32_t> sorted;         ///< room for the guard
    std::uint32_t kept = 0, keptOfRemoved = 0, dead = 0;
    StarSums<float> sums; ///< over the kept faces with the new vertex

    void Reserve(std::size_t wanted)
    {
        if (wanted + kLanes <= next.size()) return;
        const std::size_t room = std::max<std::size_t>(128, 2 * wanted + kLanes);
        for (Buffer<std::uint32_t>* values : {&next, &previous, &corner, &deadFace, &wing})
            values->Allocate(room);
        normal.Allocate(room);
        change.Allocate(room);
        sorted.Allocate(4 * room);
    }
};

/// The wedges around an edge that is tried: those of the vertex that would go, then those of the other. Empty
/// where the mesh has no attributes.
struct WedgeScratch {
    std::vector<std::uint32_t> wedge;
    std::size_t ofRemoved = 0;                       ///< how many are the first vertex's
    std::vector<std::size_t> group;                  ///< of each: the first of those that it merges with
    std::vector<std::array<std::uint32_t, 2>> pairs; ///< of the faces on the edge: their wedges at both ends
    std::array<bool, 2> blocked{}; ///< the new vertex may not be where the first, the second end is
    std::vector<float> value;      ///< what the wedges have with the new vertex
    std::vector<float> quadric;
    std::vector<std::uint32_t> deadFace;
    bool refusedBySeams = false; ///< something was, that nothing else forbids
};

/// What one thread needs to itself.
struct Workspace {
    NeighbourScratch neighbours;
    StarScratch star;
    BoundScratch bound;
    WedgeScratch wedges;
    CornerArena arena;
};

} // namespace vcg_ext
