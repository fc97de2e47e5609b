// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/border_planes.h"
#include "vcg_ext/core/collapse/seams.h"
#include "vcg_ext/core/collapse/star_sums.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// Gives every vertex its descriptor, weight and quadrics before the first collapse. One pass over the stars,
/// four faces at a time, and one over the vertices once the descriptor's scale is known.
class SweepStarter
{
    static constexpr std::size_t kGrain = 4096;
    static constexpr float kFlatCosine2 = 0.9330127f;     ///< cos^2 of 15 degrees
    static constexpr std::uint32_t kMaxSamples = 1 << 16; ///< for the percentile

    /// A star with its faces' corners written out, padded to whole vectors.
    struct Star {
        std::vector<std::uint32_t> next, previous, face;
        std::uint32_t size = 0;
    };

    const MeshView& view_;
    SweepState& state_;
    int threads_;
    Boundary boundary_;
    double givenScale_;

  public:
    /// \param givenScale the descriptor's, 0: the mesh's own
    SweepStarter(const MeshView& view, SweepState& state, int threads, Boundary boundary,
                 double givenScale = 0)
        : view_(view), state_(state), threads_(threads), boundary_(boundary), givenScale_(givenScale)
    {
    }

    void Start()
    {
        const std::uint32_t count = state_.VertexCount();
        state_.descriptor.Allocate(count);
        state_.key.Allocate(count);
        std::vector<Star> stars(static_cast<std::size_t>(threads_));
        ParallelRanges(threads_, count, kGrain, [&](std::size_t begin, std::size_t end, int thread) {
            for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
                ReadAhead(state_).At(v, static_cast<std::uint32_t>(end), [](std::uint32_t) { return true; });
                StartVertex(v, stars[static_cast<std::size_t>(thread)]);
            }
        });
        if (view_.fauxEdges != nullptr && view_.guidance == nullptr) TakePolygonDescriptor();
        state_.descriptorScale = view_.guidance != nullptr ? 1.0f
                                 : givenScale_ > 0         ? static_cast<float>(givenScale_)
                                                           : DescriptorScale(DescriptorSample());
        ParallelRanges(threads_, count, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) WeightVertex(v);
        });
    }

  private:
    void Gather(std::uint32_t v, Star& star) const
    {
        const Corner* list = state_.CornersOf(v);
        star.size = state_.cornerCount[v];
        const std::size_t padded = star.size + kLanes;
        if (star.next.size() < padded) {
            star.next.resize(2 * padded);
            star.previous.resize(2 * padded);
            star.face.resize(2 * padded);
        }
        for (std::uint32_t i = 0; i < star.size; ++i) {
            star.next[i] = state_.Next(list[i]);
            star.previous[i] = state_.Previous(list[i]);
            star.face[i] = FaceOf(list[i]);
        }
        for (std::uint32_t i = star.size; i < padded; ++i) {
            star.next[i] = star.next[star.size - 1];
            star.previous[i] = star.previous[star.size - 1];
            star.face[i] = star.face[star.size - 1];
        }
    }

    /// Is every edge at the vertex on as many faces in one direction as in the other? Sums of a mixing
    /// function over both ends stand for the sets.
    static bool IsClosed(const Star& star)
    {
        const auto mix = [](std::uint64_t x) {
            x = (x + 1) * 0x9E3779B97F4A7C15u;
            return (x ^ x >> 29) * 0xBF58476D1CE4E5B9u;
        };
        std::uint64_t difference = 0;
        for (std::uint32_t i = 0; i < star.size; ++i) difference += mix(star.next[i]) - mix(star.previous[i]);
        return difference == 0;
    }

    void LoadPositions(const std::uint32_t* v, Vector3<Float4>& p) const
    {
        Float4 unused;
        LoadTransposed(state_.vertices[v[0]].value, state_.vertices[v[1]].value, state_.vertices[v[2]].value,
                       state_.vertices[v[3]].value, p.x, p.y, p.z, unused);
    }
    void LoadNormals(const std::uint32_t* f, Vector3<Float4>& m) const
    {
        Float4 unused;
        LoadTransposed(state_.faces[f[0]].scaledNormal, state_.faces[f[1]].scaledNormal,
                       state_.faces[f[2]].scaledNormal, state_.faces[f[3]].scaledNormal, m.x, m.y, m.z,
                       unused);
    }

    StarSums<float> SumStar(std::uint32_t v, const Star& star) const
    {
        StarSums<Float4> sums;
        const Vector3<float> at = state_.Position(v);
        const Vector3<Float4> centre{Splat(at.x), Splat(at.y), Splat(at.z)};
        for (std::uint32_t i = 0; i < star.size; i += kLanes) {
            const Float4 mask = LaneWeights(star.size - i);
            Vector3<Float4> a, b, m;
            LoadPositions(&star.next[i], a);
            LoadPositions(&star.previous[i], b);
            LoadNormals(&star.face[i], m);
            a = mask * (a - centre);
            b = mask * (b - centre);
            m = mask * m;
            sums.Add(a, b, m);
        }
        return Summed(sums);
    }

    /// Does every face lie within 15 degrees of the star's normal, so that no edge can be a crease?
    bool IsFlat(const Star& star, const Vector3<float>& normal) const
    {
        const float normal2 = Dot(normal, normal);
        for (std::uint32_t i = 0; i < star.size; ++i) {
            const Vector3<float> m = state_.faces[star.face[i]].Normal();
            const float product = Dot(m, normal);
            if (product < 0 || product * product < kFlatCosine2 * normal2 * Dot(m, m)) return false;
        }
        return normal2 > 0;
    }

    void StartVertex(std::uint32_t v, Star& star)
    {
        VertexRecord& record = state_.vertices[v];
        state_.key[v] = state_.cornerCount[v] > 0 ? 0 : kNoKey;
        state_.descriptor[v] = 0;
        record.SetMatrix(VertexRecord::kStar, {});
        record.SetHistory({});
        if (state_.cornerCount[v] == 0) return;
        Gather(v, star);
        StarSums<float> sums = SumStar(v, star);
        SymmetricMatrix3<float> history = sums.star;
        if (!IsClosed(star)) {
            StartBorder(v, star, sums);
            history = sums.star;
        }
        if (state_.Has(v, kSeamVertex)) {
            const SymmetricMatrix3<float> seams = SeamPlanesAt(state_, *state_.wedges, v);
            sums.star = sums.star + seams;
            history = history + seams;
        }
        if (!IsFlat(star, sums.normal)) history = history + CreasesOf(v, star);
        record.SetMatrix(VertexRecord::kStar, sums.star);
        record.SetHistory({history, {}, 0});
        state_.descriptor[v] = StarDescriptor(sums);
    }

    /// Marks the vertex, counts each of its edges once in the descriptor and adds the border's planes.
    void StartBorder(std::uint32_t v, const Star& star, StarSums<float>& sums)
    {
        std::uint8_t flags = state_.flags[v] | kBorderVertex;
        if (boundary_ == Boundary::Lock) flags |= kFixedVertex;
        state_.flags[v] = flags;
        sums.edges = {};
        sums.length = 0;
        const auto add = [&](std::uint32_t w) {
            const Vector3<float> edge = state_.Position(w) - state_.Position(v);
            const float share = 1.0f / static_cast<float>(std::max(1, FacesOnEdge(state_, v, w)));
            sums.AddEdge(edge, share);
        };
        for (std::uint32_t i = 0; i < star.size; ++i) {
            add(star.next[i]);
            add(star.previous[i]);
        }
        if (boundary_ != Boundary::Free) sums.star = sums.star + BorderPlanesAt(state_, v);
    }

    /// Of every face at \p v and the first of those that share its outgoing edge.
    SymmetricMatrix3<float> CreasesOf(std::uint32_t v, const Star& star) const
    {
        CreasePlanes<float> creases;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> byPrevious(star.size);
        for (std::uint32_t i = 0; i < star.size; ++i) byPrevious[i] = {star.previous[i], star.face[i]};
        std::sort(byPrevious.begin(), byPrevious.end());
        for (std::uint32_t i = 0; i < star.size; ++i) {
            const auto other = std::lower_bound(byPrevious.begin(), byPrevious.end(),
                                                std::make_pair(star.next[i], std::uint32_t{0}));
            if (other == byPrevious.end() || other->first != star.next[i]) continue;
            creases.Add(state_.Position(star.next[i]) - state_.Position(v),
                        state_.faces[star.face[i]].Normal(), state_.faces[other->second].Normal());
        }
        return creases.Sum();
    }

    /// The diagonals of polygons join no neighbours; they are known of the input only.
    void TakePolygonDescriptor()
    {
        const std::vector<double> values = LaplacianDescriptor(view_, threads_);
        for (std::uint32_t v = 0; v < state_.VertexCount(); ++v)
            state_.descriptor[v] = static_cast<float>(values[state_.origin[v]]);
    }

    std::vector<float> DescriptorSample() const
    {
        std::vector<float> sample;
        const std::uint32_t step = std::max(1u, state_.VertexCount() / kMaxSamples);
        for (std::uint32_t v = 0; v < state_.VertexCount(); v += step)
            if (state_.cornerCount[v] > 0) sample.push_back(state_.descriptor[v]);
        return sample;
    }

    void WeightVertex(std::size_t v)
    {
        VertexRecord& record = state_.vertices[v];
        const float l = view_.guidance != nullptr ? view_.guidance[state_.origin[v]]
                                                  : state_.descriptor[v] * state_.descriptorScale;
        const Importance<float> importance = ImportanceOf(std::clamp(l, 0.0f, 1.0f), state_.featureWeight);
        const float weight = importance.weight;
        state_.descriptor[v] = importance.descriptor;
        record.value[VertexRecord::kWeight] = weight;
        record.SetMatrix(VertexRecord::kMatrix, weight * record.Matrix(VertexRecord::kMatrix));
    }
};

} // namespace vcg_ext
