// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float8.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/cost.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// A vertex as the inner loops read it: 80 bytes, five vectors of four floats.
struct alignas(16) VertexRecord {
    enum Slot : int { kPosition = 0, kWeight = 3, kStar = 4, kMatrix = 10, kLinear = 16, kConstant = 19 };
    float value[20];

    Vector3<float> Position() const { return {value[0], value[1], value[2]}; }
    SymmetricMatrix3<float> Matrix(Slot slot) const
    {
        return {value[slot],     value[slot + 1], value[slot + 2],
                value[slot + 3], value[slot + 4], value[slot + 5]};
    }
    CentredQuadric<float> History() const
    {
        return {Matrix(kMatrix), {value[kLinear], value[kLinear + 1], value[kLinear + 2]}, value[kConstant]};
    }
    EdgeEnd<float> End() const { return {Position(), value[kWeight], Matrix(kStar), History()}; }

    void SetPosition(const Vector3<float>& p)
    {
        value[0] = p.x;
        value[1] = p.y;
        value[2] = p.z;
    }
    void SetMatrix(Slot slot, const SymmetricMatrix3<float>& m)
    {
        value[slot] = m.xx;
        value[slot + 1] = m.xy;
        value[slot + 2] = m.xz;
        value[slot + 3] = m.yy;
        value[slot + 4] = m.yz;
        value[slot + 5] = m.zz;
    }
    void AddToStar(const SymmetricMatrix3<float>& m) { SetMatrix(kStar, Matrix(kStar) + m); }
    void SetHistory(const CentredQuadric<float>& q)
    {
        SetMatrix(kMatrix, q.matrix);
        value[kLinear] = q.linear.x;
        value[kLinear + 1] = q.linear.y;
        value[kLinear + 2] = q.linear.z;
        value[kConstant] = q.constant;
    }
};
static_assert(sizeof(VertexRecord) == 80, "loaded as five vectors of four floats");

/// A face as the inner loops read it: 32 bytes.
struct alignas(16) FaceRecord {
    static constexpr std::uint32_t kDead = 0x80000000u;
    std::uint32_t v[3];
    std::uint32_t origin;  ///< the input face; with kDead once the face is gone
    float scaledNormal[4]; ///< m of ScaledNormal, and a zero

    bool Alive() const { return origin < kDead; }
    Vector3<float> Normal() const { return {scaledNormal[0], scaledNormal[1], scaledNormal[2]}; }
};
static_assert(sizeof(FaceRecord) == 32, "two to a cache line");

/// Mark of a vertex beside those of SurfaceFlag: it took part in a collapse of the running sweep.
constexpr std::uint8_t kMergedVertex = 128;

/// Key of a vertex that is never looked at again: it is gone.
constexpr float kNoKey = FLT_MAX;
/// Key of a vertex whose every collapse was refused when it was looked at.
constexpr float kRefusedKey = 1e38f;
/// No threshold is higher: what is refused stays out of reach.
constexpr float kHighestThreshold = 5e37f;

struct CollapseBound;
struct CollapseCrossings;
struct WedgeSet;

/// Everything that the collapses read and write. Vertices are in Morton order, faces in the order of their
/// smallest vertex, so that neighbours in space are neighbours in memory.
struct SweepState {
    Buffer<VertexRecord> vertices;
    Buffer<FaceRecord> faces;
    Buffer<std::uint32_t> cornerOffset; ///< start of the vertex's list in corners
    Buffer<std::uint32_t> cornerCount;  ///< its faces; 0: the vertex is gone
    Buffer<Corner> corners;             ///< lists in vertex order, then those made during the sweep
    Buffer<Corner> spareCorners;        ///< where the next sweep's lists are compacted to
    Buffer<Corner> originalCorners;     ///< the input's lists, if they are kept, once all others have moved
    Buffer<float> key;                  ///< a vertex is looked at once the threshold reaches its key
    Buffer<float> descriptor;           ///< l of the vertex, in [0, 1]
    Buffer<std::uint8_t> flags;         ///< of SurfaceFlag, and kMergedVertex
    Buffer<std::uint32_t> origin;       ///< the input vertex
    Buffer<std::uint32_t> mergedInto;   ///< whom a vertex was merged into, itself if it was not; may be empty
    std::size_t aliveFaces = 0;

    Frame frame;                   ///< of the box of the referenced vertices
    float descriptorScale = 1;     ///< 1 / the descriptor that counts as 1
    float featureWeight = 0;       ///< lambda
    float distanceArea = 0;        ///< DistanceArea of what is left; the same throughout a sweep
    bool ratchetRecomputes = true; ///< the survivor's descriptor is measured again
    bool bordersCount = true;      ///< planes perpendicular to open borders belong to the quadrics
    bool keepOriginal = false;     ///< the input's lists are not overwritten
    bool eightAtOnce = HasAvx2();  ///< the same bytes, in less time
    bool anyFixed = false;
    bool preserveTopology = false;
    bool sharedSeams = false;               ///< of MeshView
    CollapseBound* bound = nullptr;         ///< what the collapses may not exceed; null: nothing
    CollapseCrossings* crossings = nullptr; ///< where faces may not cross; null: they may everywhere
    WedgeSet* wedges = nullptr;             ///< the attributes that guide; null: none

    std::uint32_t VertexCount() const { return static_cast<std::uint32_t>(vertices.size()); }
    Vector3<float> Position(std::uint32_t v) const { return vertices[v].Position(); }
    const Corner* CornersOf(std::uint32_t v) const { return corners.data() + cornerOffset[v]; }
    bool Has(std::uint32_t v, unsigned mask) const { return (flags[v] & mask) != 0; }
    std::uint32_t Next(Corner corner) const { return faces[FaceOf(corner)].v[kNextIndex[corner & 3]]; }
    std::uint32_t Previous(Corner corner) const
    {
        return faces[FaceOf(corner)].v[kPreviousIndex[corner & 3]];
    }
};

/// A pass over many vertices waits for memory most of all. Asked for in two stages, what it is about to read
/// has arrived when it comes to it: the faces of a vertex, and a few vertices later its neighbours' records.
class ReadAhead
{
    static constexpr std::size_t kToFaces = 16, kToNeighbours = 8; // vertices
    const SweepState& state_;

  public:
    explicit ReadAhead(const SweepState& state) : state_(state) {}

    /// \param i where the pass is on its way to \p end \param vertexAt vertexAt(i), its vertex
    /// \param wanted whether the pass will look at a vertex at all
    template <class VertexAt, class Wanted>
    void At(std::size_t i, std::size_t end, const VertexAt& vertexAt, const Wanted& wanted) const
    {
        const auto forEachCorner = [&](std::size_t ahead, const auto& visit) {
            if (i + ahead >= end) return;
            const std::uint32_t v = vertexAt(i + ahead);
            if (!wanted(v)) return;
            const Corner* list = state_.CornersOf(v);
            for (std::uint32_t k = 0; k < state_.cornerCount[v]; ++k) visit(list[k]);
        };
        forEachCorner(kToFaces, [&](Corner c) { Prefetch(&state_.faces[FaceOf(c)]); });
        forEachCorner(kToNeighbours, [&](Corner c) {
            const float* record = state_.vertices[state_.Next(c)].value;
            Prefetch(record);
            Prefetch(record + 16); // the rest of the record, in the next line of the cache
        });
    }
    /// The same of a pass over the vertices themselves.
    template <class Wanted>
    void At(std::uint32_t v, std::uint32_t end, const Wanted& wanted) const
    {
        At(
            std::size_t{v}, std::size_t{end}, [](std::size_t i) { return static_cast<std::uint32_t>(i); },
            wanted);
    }
};

/// Faces on the edge from a to b: a walk over the shorter of the two lists.
inline int FacesOnEdge(const SweepState& state, std::uint32_t a, std::uint32_t b)
{
    if (state.cornerCount[b] < state.cornerCount[a]) std::swap(a, b);
    const Corner* list = state.CornersOf(a);
    int faces = 0;
    for (std::uint32_t i = 0; i < state.cornerCount[a]; ++i)
        faces += state.Next(list[i]) == b || state.Previous(list[i]) == b;
    return faces;
}

} // namespace vcg_ext
