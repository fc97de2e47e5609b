// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <cstring>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/collapse/charts.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// Reads the attributes of a MeshView into a WedgeSet for a state that is loaded and not started: wedges,
/// charts, marks of seams, quadrics.
class WedgeLoader
{
    static constexpr std::size_t kGrain = 4096;

    const CornerAttributes& input_;
    SweepState& state_;
    WedgeSet& set_;
    int threads_;
    Buffer<std::uint32_t> firstWedge_; ///< of every vertex

  public:
    WedgeLoader(const CornerAttributes& input, SweepState& state, WedgeSet& set, int threads)
        : input_(input), state_(state), set_(set), threads_(threads)
    {
    }

    /// \throws std::invalid_argument as ChannelsOf
    void Load(const DecimationParameters& parameters, std::size_t inputFaces)
    {
        set_.channels = ChannelsOf(input_, inputFaces);
        set_.layout = {set_.channels.size(), set_.channels.groups};
        set_.weight = static_cast<float>(parameters.attributeWeight);
        set_.keepSeams = parameters.seams == Seams::Keep;
        FindWedges();
        ChartFinder(state_, set_, threads_).Find();
        AddSlopes(parameters);
    }

  private:
    const float* Input(Corner corner) const
    {
        return input_.Corner(state_.faces[FaceOf(corner)].origin, static_cast<std::size_t>(IndexOf(corner)));
    }
    bool AreSame(Corner a, Corner b) const
    {
        const float *x = Input(a), *y = Input(b);
        return std::equal(x, x + input_.Channels(), y) && Side(a) == Side(b) &&
               input_.Label(state_.faces[FaceOf(a)].origin) == input_.Label(state_.faces[FaceOf(b)].origin);
    }
    std::uint32_t Side(Corner corner) const
    {
        return input_.Side(state_.faces[FaceOf(corner)].origin, static_cast<std::size_t>(IndexOf(corner)));
    }

    /// Wedges of a vertex follow each other, in the order of its corners.
    void FindWedges()
    {
        const std::uint32_t vertices = state_.VertexCount();
        set_.ofCorner.Allocate(3 * state_.faces.size());
        firstWedge_.Allocate(std::size_t{vertices} + 1);
        ParallelRanges(threads_, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
            std::vector<Corner> first;
            for (std::size_t v = begin; v < end; ++v)
                firstWedge_[v] = NumberCorners(static_cast<std::uint32_t>(v), first);
        });
        std::uint32_t count = 0;
        for (std::uint32_t v = 0; v < vertices; ++v) count += std::exchange(firstWedge_[v], count);
        firstWedge_[vertices] = count;
        set_.records.Allocate(count * set_.layout.RecordSize());
        if (input_.sides != nullptr) set_.side.Allocate(count);
        ParallelRanges(threads_, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) FillWedges(static_cast<std::uint32_t>(v));
        });
        firstWedge_.Release();
    }

    /// Numbers the wedges at \p v from 0. \return how many there are
    std::uint32_t NumberCorners(std::uint32_t v, std::vector<Corner>& first)
    {
        const Corner* list = state_.CornersOf(v);
        first.clear();
        for (std::uint32_t i = 0; i < state_.cornerCount[v]; ++i) {
            std::uint32_t wedge = 0;
            while (wedge < first.size() && !AreSame(first[wedge], list[i])) ++wedge;
            if (wedge == first.size()) first.push_back(list[i]);
            set_.Of(list[i]) = wedge;
        }
        return static_cast<std::uint32_t>(first.size());
    }
    void FillWedges(std::uint32_t v)
    {
        const Corner* list = state_.CornersOf(v);
        for (std::uint32_t i = 0; i < state_.cornerCount[v]; ++i) {
            std::uint32_t& wedge = set_.Of(list[i]);
            wedge += firstWedge_[v];
            float* record = set_.Values(wedge);
            std::fill(record, record + set_.layout.RecordSize(), 0.0f);
            std::copy_n(Input(list[i]), input_.Channels(), record);
            if (!set_.side.empty()) set_.side[wedge] = Side(list[i]);
        }
    }

    /// Twice the area of a face.
    float DoubleArea(std::size_t f) const
    {
        const Vector3<float> m = state_.faces[f].Normal();
        return Dot(m, m);
    }
    double TextureArea(std::size_t f, std::uint32_t first) const
    {
        const std::uint32_t* w = &set_.ofCorner[3 * f];
        return DoubleTextureArea(set_.Values(w[0]), set_.Values(w[1]), set_.Values(w[2]), first);
    }

    /// The lengths that differences count as. Of texture coordinates a quarter of what the chart stretches
    /// them by; of everything else a part of an edge of the result.
    struct Scales {
        std::vector<float> chart; ///< of every chart, texture by texture
        float value = 0;
    };

    static constexpr float kTextureScale = 0.25f;
    static constexpr float kValueScale = 0.3f;

    Scales MeasureScales(const DecimationParameters& parameters) const
    {
        const std::size_t charts = set_.chartFaces.size(), textures = set_.channels.textures.size();
        std::vector<double> space(charts, 0), texture(charts * textures, 0);
        for (std::size_t f = 0; f < state_.faces.size(); ++f) {
            space[set_.chart[f]] += static_cast<double>(DoubleArea(f));
            for (std::size_t t = 0; t < textures; ++t)
                texture[set_.chart[f] * textures + t] += std::fabs(TextureArea(f, set_.channels.textures[t]));
        }
        Scales scales;
        double all = 0;
        for (std::size_t c = 0; c < charts; ++c) {
            all += space[c];
            for (std::size_t t = 0; t < textures; ++t) {
                const double area = texture[c * textures + t];
                scales.chart.push_back(area > 0 ? static_cast<float>(std::sqrt(space[c] / area)) : 0.0f);
            }
        }
        // No edge is expected to be longer than those of a fiftieth of the faces: with a bound on the error
        // the target says little.
        constexpr std::size_t kFewest = 50;
        const double target = static_cast<double>(
            std::max({parameters.targetFaces, state_.faces.size() / kFewest, std::size_t{1}}));
        constexpr double kEdge2OfArea = 2.3; // of equilateral triangles
        scales.value = kValueScale * static_cast<float>(std::sqrt(kEdge2OfArea * all / 2 / target));
        return scales;
    }

    void AddSlopes(const DecimationParameters& parameters)
    {
        if (!(set_.weight > 0)) return;
        const Scales scales = MeasureScales(parameters);
        ParallelRanges(threads_, state_.VertexCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            std::vector<float> sigma;
            for (std::size_t v = begin; v < end; ++v) {
                const Corner* list = state_.CornersOf(static_cast<std::uint32_t>(v));
                for (std::uint32_t i = 0; i < state_.cornerCount[v]; ++i)
                    AddFace(FaceOf(list[i]), set_.Of(list[i]), scales, sigma);
            }
        });
    }

    /// \return the face's scale of the texture, within kMostStretch of its chart's
    float TextureScale(std::size_t f, std::size_t t, const Scales& scales) const
    {
        constexpr float kMostStretch = 8;
        const float chart = scales.chart[set_.chart[f] * set_.channels.textures.size() + t];
        const auto area = static_cast<float>(std::fabs(TextureArea(f, set_.channels.textures[t])));
        if (!(area > 0)) return kTextureScale * chart;
        const float own = std::sqrt(DoubleArea(f) / area);
        return kTextureScale * std::clamp(own, chart / kMostStretch, chart * kMostStretch);
    }

    /// Adds what face \p f has to say to the quadric of \p wedge. Needles have no slope that could be
    /// believed.
    void AddFace(std::uint32_t f, std::uint32_t wedge, const Scales& scales, std::vector<float>& sigma)
    {
        constexpr float kNeedle = 1e-4f; // double area over squared longest edge
        const FaceRecord& face = state_.faces[f];
        const Vector3<float> a = state_.Position(face.v[0]);
        const Vector3<float> ab = state_.Position(face.v[1]) - a, ac = state_.Position(face.v[2]) - a;
        const Vector3<float> normal = Cross(ab, ac);
        const float normal2 = Dot(normal, normal), longest2 = std::max(Dot(ab, ab), Dot(ac, ac));
        const float doubleArea = std::sqrt(normal2);
        if (!(doubleArea > kNeedle * longest2)) return;
        const Vector3<float> n = (1 / normal2) * normal, towardsB = Cross(ac, n), towardsC = Cross(n, ab);
        sigma.assign(set_.channels.groups, 0);
        const Channels& channels = set_.channels;
        for (std::size_t t = 0; t < channels.textures.size(); ++t)
            sigma[channels.group[channels.textures[t]]] = TextureScale(f, t, scales);
        for (std::size_t k = 0; k < channels.size(); ++k)
            if (channels.kinds[k] != ChannelKind::Texture)
                sigma[channels.group[k]] = scales.value / channels.unit[k];
        WedgeQuadric<float> quadric = set_.Quadric(wedge);
        const std::uint32_t* w = &set_.ofCorner[3 * std::size_t{f}];
        const float *s0 = set_.Values(w[0]), *s1 = set_.Values(w[1]), *s2 = set_.Values(w[2]);
        const auto weightOf = [&](std::uint32_t group) {
            const float scale = set_.weight * sigma[group];
            return doubleArea * scale * scale;
        };
        for (std::uint32_t g = 0; g < channels.groups; ++g) quadric.AddWeight(g, weightOf(g));
        for (std::size_t k = 0; k < channels.size(); ++k)
            quadric.AddSlope(k, weightOf(channels.group[k]),
                             (s1[k] - s0[k]) * towardsB + (s2[k] - s0[k]) * towardsC);
    }
};

} // namespace vcg_ext
