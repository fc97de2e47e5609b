// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/base/morton.h"
#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// Faces whose corners fit the 32 bits of a pool with the lists of one sweep behind it.
constexpr std::size_t kMaxFaces = std::size_t{1} << 29;
constexpr std::size_t kMaxVertices = std::size_t{1} << 30;

/// Reads a MeshView into a SweepState: order, frame, records, corner lists. Quadrics and descriptors come
/// after it (sweep_start.h). Faces that name a vertex twice stay out unless all their vertices are fixed.
class SweepLoader
{
    struct SortedFace {
        std::uint32_t v[3];
        std::uint32_t origin;
        std::uint32_t Smallest() const { return std::min(v[0], std::min(v[1], v[2])); }
    };
    static_assert(sizeof(SortedFace) == 4 * sizeof(Corner));

    static constexpr std::size_t kGrain = 1 << 14;
    static constexpr int kFaceBucketBits = 11;
    static constexpr std::uint32_t kUnreferenced = ~std::uint32_t{0};

    const MeshView& view_;
    SweepState& state_;
    int threads_;
    Buffer<std::uint32_t> inputCorners_; ///< faces of every input vertex
    Buffer<std::uint32_t> indexOf_;      ///< record of every input vertex
    Box3<double> box_{};                 ///< of the vertices with faces

  public:
    SweepLoader(const MeshView& view, SweepState& state, int threads)
        : view_(view), state_(state), threads_(threads)
    {
        if (view.faceCount >= kMaxFaces || view.vertexCount >= kMaxVertices)
            throw std::length_error("the mesh has " + std::to_string(view.faceCount) + " faces and " +
                                    std::to_string(view.vertexCount) +
                                    " vertices; the engine handles fewer than 2^29 faces and 2^30 vertices");
    }

    void Load()
    {
        CountCorners();
        MeasureBox();
        MakeVertices();
        MakeFaces();
        MakeCornerLists();
    }

  private:
    bool Fixed(std::uint32_t vertex) const
    {
        return view_.fixedVertices != nullptr && view_.fixedVertices[vertex] != 0;
    }
    const std::uint32_t* Triangle(std::size_t face) const { return view_.triangles + 3 * face; }
    bool Kept(std::size_t face) const
    {
        const std::uint32_t* t = Triangle(face);
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) return true;
        return Fixed(t[0]) && Fixed(t[1]) && Fixed(t[2]);
    }
    void Count(std::uint32_t& counter) const
    {
        if (threads_ > 1)
            FetchAdd(counter, 1);
        else
            ++counter;
    }

    void CountCorners()
    {
        inputCorners_.Allocate(view_.vertexCount);
        std::fill(inputCorners_.begin(), inputCorners_.end(), 0u);
        ParallelRanges(threads_, view_.faceCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t face = begin; face < end; ++face) {
                if (!Kept(face)) continue;
                for (int j = 0; j < 3; ++j) Count(inputCorners_[Triangle(face)[j]]);
            }
        });
    }

    /// Records are made for vertices with faces; a fixed one without any has a record too, so that it stays.
    bool HasRecord(std::uint32_t vertex) const { return inputCorners_[vertex] != 0 || Fixed(vertex); }

    void MeasureBox()
    {
        std::vector<Box3<double>> boxes(static_cast<std::size_t>(threads_), EmptyBox<double>());
        ParallelRanges(threads_, view_.vertexCount, kGrain,
                       [&](std::size_t begin, std::size_t end, int thread) {
                           Box3<double> box = boxes[static_cast<std::size_t>(thread)];
                           for (std::size_t v = begin; v < end; ++v) {
                               if (inputCorners_[v] == 0) continue;
                               const std::array<double, 3> p = view_.Position(v);
                               box.Add({p[0], p[1], p[2]});
                           }
                           boxes[static_cast<std::size_t>(thread)] = box;
                       });
        Box3<double> all = EmptyBox<double>();
        for (const Box3<double>& box : boxes) {
            if (box.IsEmpty()) continue;
            all.Add(box.low);
            all.Add(box.high);
        }
        if (!all.IsEmpty()) box_ = all;
        state_.frame = FrameOf(box_);
    }

    void MakeVertices()
    {
        Buffer<OrderedVertex> sorted = SortVertices();
        const std::size_t count = sorted.size();
        state_.vertices.Allocate(count);
        state_.origin.Allocate(count);
        state_.cornerCount.Allocate(count);
        state_.flags.Allocate(count);
        indexOf_.Allocate(view_.vertexCount);
        constexpr std::size_t kAhead = 16; // vertices: about what memory takes to answer
        ParallelRanges(threads_, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                if (v + kAhead < count) Prefetch(view_.PositionAddress(sorted[v + kAhead].origin));
                const std::uint32_t origin = sorted[v].origin;
                state_.vertices[v].SetPosition(state_.frame.Into(view_.Position(origin)));
                state_.origin[v] = origin;
                state_.cornerCount[v] = inputCorners_[origin];
                state_.flags[v] = Fixed(origin) ? std::uint8_t{kFixedVertex} : std::uint8_t{0};
                indexOf_[origin] = static_cast<std::uint32_t>(v);
            }
        });
        inputCorners_.Release();
    }

    /// The vertices with a record, in Morton order.
    Buffer<OrderedVertex> SortVertices() const
    {
        std::size_t count = 0;
        for (std::uint32_t v = 0; v < view_.vertexCount; ++v) count += HasRecord(v);
        Buffer<OrderedVertex> vertices(count);
        std::size_t at = 0;
        for (std::uint32_t v = 0; v < view_.vertexCount; ++v)
            if (HasRecord(v)) vertices[at++].origin = v;
        constexpr int kBitsPerAxis = 8;
        using Grid = MortonGrid<kBitsPerAxis>;
        const Grid grid({box_.low.x, box_.low.y, box_.low.z}, {box_.high.x, box_.high.y, box_.high.z});
        ParallelRanges(threads_, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                vertices[i].code = grid.Code(view_.Position(vertices[i].origin));
        });
        SortByCode<Grid::kCodeBits>(vertices, threads_);
        return vertices;
    }

    /// Faces in the order of their smallest vertex: first into buckets of 2048 vertices, then within each.
    void MakeFaces()
    {
        const std::vector<std::uint32_t> bucketBegin = SortIntoBuckets();
        const std::size_t count = bucketBegin.back();
        state_.faces.Allocate(count);
        state_.aliveFaces = count;
        ParallelFor(threads_, bucketBegin.size() - 1, [&](std::size_t bucket, int) {
            std::array<std::uint32_t, (1 << kFaceBucketBits) + 1> next{};
            constexpr std::uint32_t kMask = (1u << kFaceBucketBits) - 1;
            const std::uint32_t begin = bucketBegin[bucket], end = bucketBegin[bucket + 1];
            for (std::uint32_t i = begin; i < end; ++i) ++next[(Bucketed(i).Smallest() & kMask) + 1];
            for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const SortedFace face = Bucketed(i);
                MakeFace(begin + next[face.Smallest() & kMask]++, face);
            }
        });
    }

    /// Four numbers each, in memory that the corners have no use for before the second sweep.
    SortedFace Bucketed(std::size_t place) const
    {
        SortedFace face{};
        std::memcpy(&face, &state_.spareCorners[4 * place], sizeof face);
        return face;
    }

    /// \return the first place of every bucket, and the number of faces behind them
    std::vector<std::uint32_t> SortIntoBuckets()
    {
        // Dropped faces go to a bucket of their own behind the others.
        const std::size_t buckets = (state_.VertexCount() >> kFaceBucketBits) + 1;
        state_.spareCorners.Allocate(CornerArena::PoolSize(3 * view_.faceCount, threads_));
        const auto mapped = [&](std::size_t face) {
            const std::uint32_t* t = Triangle(face);
            return SortedFace{{indexOf_[t[0]], indexOf_[t[1]], indexOf_[t[2]]},
                              static_cast<std::uint32_t>(face)};
        };
        const auto bucketOf = [&](std::size_t face) {
            return Kept(face) ? mapped(face).Smallest() >> kFaceBucketBits
                              : static_cast<std::uint32_t>(buckets);
        };
        std::vector<std::uint32_t> bucketBegin = StableScatter(
            threads_, view_.faceCount, buckets + 1, bucketOf, [&](std::size_t face, std::uint32_t place) {
                if (!Kept(face)) return;
                const SortedFace sorted = mapped(face);
                std::memcpy(&state_.spareCorners[4 * std::size_t{place}], &sorted, sizeof sorted);
            });
        bucketBegin.pop_back();
        indexOf_.Release();
        return bucketBegin;
    }

    void MakeFace(std::size_t place, const SortedFace& from)
    {
        FaceRecord& face = state_.faces[place];
        std::copy(from.v, from.v + 3, face.v);
        face.origin = from.origin;
        const Vector3<float> m =
            ScaledNormal(state_.Position(from.v[0]), state_.Position(from.v[1]), state_.Position(from.v[2]));
        face.scaledNormal[0] = m.x;
        face.scaledNormal[1] = m.y;
        face.scaledNormal[2] = m.z;
        face.scaledNormal[3] = 0;
    }

    void MakeCornerLists()
    {
        const std::uint32_t vertices = state_.VertexCount();
        state_.cornerOffset.Allocate(vertices);
        Buffer<std::uint32_t> next(vertices);
        std::uint32_t total = 0;
        for (std::uint32_t v = 0; v < vertices; ++v) {
            state_.cornerOffset[v] = next[v] = total;
            total += state_.cornerCount[v];
        }
        state_.corners.Allocate(CornerArena::PoolSize(total, threads_));
        ParallelRanges(threads_, state_.faces.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f)
                for (int j = 0; j < 3; ++j) {
                    std::uint32_t& place = next[state_.faces[f].v[j]];
                    const std::uint32_t here = threads_ > 1 ? FetchAdd(place, 1) : place++;
                    state_.corners[here] = MakeCorner(static_cast<std::uint32_t>(f), j);
                }
        });
        if (threads_ > 1) SortCornerLists();
    }

    /// Undoes the accidental order in which several threads filled the lists.
    void SortCornerLists()
    {
        ParallelRanges(threads_, state_.VertexCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                Corner* list = state_.corners.data() + state_.cornerOffset[v];
                std::sort(list, list + state_.cornerCount[v]);
            }
        });
    }
};

} // namespace vcg_ext
