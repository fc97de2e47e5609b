// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/core/attributes/chart_samples.h"
#include "vcg_ext/core/attributes/chart_search.h"
#include "vcg_ext/core/attributes/wedge_equations.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/wedge_flip.h"

namespace vcg_ext
{

/// Gives the wedges of a simplified mesh the values with which its surface fits the original's best: least
/// squares over points of the original, each joined to the simplified faces of its own chart.
///
/// Texture coordinates on seams take no part: they keep the value of the collapse or, where the vertex has
/// moved since, take that of the closest point of the chart. All values of fixed vertices stay. Values stay
/// within the range of their chart of the original. A face whose texture turned over takes back what the
/// collapse had left. A channel that is not cut at a vertex stays uncut.
class AttributeTransfer
{
    static constexpr std::size_t kGrain = 1024;

    const MeshView& view_;
    const CornerAttributes& input_;
    DecimatedMesh& mesh_;
    SurfaceWedges& wedges_;
    int threads_;
    std::vector<std::uint8_t> fixed_;
    MeshView simplifiedView_;
    FaceTree simplifiedTree_;
    ChartSearch original_, simplified_;
    SurfaceArrays surface_; ///< the simplified one, with marks of seams

    struct WedgePlace {
        std::uint32_t vertex = kNone, chart = kNone, face = kNone; ///< one of its faces
        Vector3<float> normal{0, 0, 0}, inside{0, 0, 0}; ///< of its faces; a sum of ways to their centroids
    };
    std::vector<WedgePlace> places_;
    std::vector<float> values_; ///< of every wedge

  public:
    /// \param tree of the original's faces \pre \p mesh has faces and wedges
    AttributeTransfer(const MeshView& view, const FaceTree& tree, DecimatedMesh& mesh, int threads)
        : view_(view), input_(*view.attributes), mesh_(mesh), wedges_(*mesh.wedges), threads_(threads),
          simplifiedView_(ViewOf(mesh, view, fixed_)),
          simplifiedTree_(simplifiedView_, tree.frame(), threads),
          original_(view, tree, wedges_.inputChart, threads),
          simplified_(simplifiedView_, simplifiedTree_, wedges_.chart, threads),
          surface_(BuildSurfaceArrays(simplifiedView_, tree.frame(), nullptr, threads)),
          values_(wedges_.values)
    {
        surface_.wedges = &wedges_;
        MarkSeams(surface_);
        simplified_.LearnNeighbors(surface_, threads);
        FindPlaces();
    }

    /// \param order of the original's faces, neighbors close to each other; may be empty
    void Run(const std::vector<std::uint32_t>& order)
    {
        if (wedges_.channels.size() == 0) return;
        StartFromOriginal();
        Fit(order);
        ClampToCharts();
        JoinUncutChannels();
        TakeBackTurnedFaces();
        wedges_.values = values_;
    }

  private:
    std::size_t Size() const { return wedges_.channels.size(); }
    bool IsTexture(std::size_t k) const { return wedges_.channels.kinds[k] == ChannelKind::Texture; }
    bool IsFixed(std::size_t w) const { return (surface_.flags[places_[w].vertex] & kFixedVertex) != 0; }
    bool IsOnSeam(std::size_t w) const { return (surface_.flags[places_[w].vertex] & kSeamVertex) != 0; }
    bool IsFree(std::size_t w, std::size_t k) const { return !IsFixed(w) && !(IsTexture(k) && IsOnSeam(w)); }

    void FindPlaces()
    {
        places_.resize(wedges_.Count());
        for (std::uint32_t f = 0; f < surface_.FaceCount(); ++f) {
            const Vector3<float> normal = AreaVector(surface_, f), centroid = Centroid(surface_, f);
            for (std::size_t k = 0; k < 3; ++k) {
                WedgePlace& place = places_[wedges_.ofFace[f][k]];
                place.vertex = surface_.triangles[f].v[k];
                place.chart = wedges_.chart[f];
                place.face = f;
                place.normal = place.normal + normal;
                place.inside = place.inside + (centroid - PositionOf(surface_, place.vertex));
            }
        }
    }

    float Interpolated(const ChartPoint& at, std::size_t k) const
    {
        float sum = 0;
        for (std::size_t j = 0; j < 3; ++j) sum += at.weights[j] * input_.Corner(at.face, j)[k];
        return sum;
    }
    bool HasMoved(std::uint32_t v) const
    {
        return mesh_.positions[v] != view_.Position(mesh_.vertexOrigin[v]);
    }

    /// Values of the closest point of the original.
    void StartFromOriginal()
    {
        ParallelRanges(threads_, places_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t w = begin; w < end; ++w) {
                const WedgePlace& place = places_[w];
                if (place.vertex == kNone || IsFixed(w)) continue;
                const bool corner = (surface_.flags[place.vertex] & kSeamCorner) != 0;
                const bool keepsTexture = IsOnSeam(w) && (corner || !HasMoved(place.vertex));
                if (keepsTexture && !wedges_.channels.HasValues()) continue;
                const ChartPoint at = IsOnSeam(w) ? ClosestOnOwnSide(place) : ClosestTo(place);
                if (at.face == kNone) continue;
                for (std::size_t k = 0; k < Size(); ++k)
                    if (!(IsTexture(k) && keepsTexture)) values_[w * Size() + k] = Interpolated(at, k);
            }
        });
    }
    ChartPoint ClosestTo(const WedgePlace& place) const
    {
        return original_.Closest(PositionOf(surface_, place.vertex), place.normal, place.chart,
                                 mesh_.faceOrigin[place.face]);
    }
    /// The same of the faces beside the seam on which the wedge's own faces lie: of a cut inside a chart both
    /// sides are equally close.
    ChartPoint ClosestOnOwnSide(const WedgePlace& place) const
    {
        constexpr float kAside = 0.1f; // of the size of a face
        const Vector3<float> here = PositionOf(surface_, place.vertex);
        const ChartPoint any = ClosestTo(place);
        const float length = Norm(place.inside);
        if (any.face == kNone || !(length > 0)) return any;
        const float size = std::sqrt(Norm(original_.Normal(any.face)));
        const Vector3<float> aside = here + (kAside * size / length) * place.inside;
        const ChartPoint near = original_.Closest(aside, place.normal, place.chart, any.face);
        return original_.ClosestOf(near.face, here);
    }

    void Fit(const std::vector<std::uint32_t>& order)
    {
        const std::size_t faces = surface_.FaceCount();
        const ChartSamples samples(original_, simplified_, wedges_.inputChart, order, faces, threads_);
        std::vector<std::array<double, 6>> products(faces);
        ForEachFace([&](std::size_t f) {
            std::array<double, 6> sum{};
            ForEachSample(samples, f, [&](double area, const ChartSamples::Sample& sample) {
                for (std::size_t i = 0, at = 0; i < 3; ++i)
                    for (std::size_t j = i; j < 3; ++j)
                        sum[at++] += area * static_cast<double>(sample.weights[i] * sample.weights[j]);
            });
            products[f] = sum;
        });
        const WedgeEquations equations(wedges_.ofFace, places_.size(), std::move(products), threads_);
        std::vector<std::array<double, 3>> missing(faces);
        std::vector<std::uint8_t> isFree(places_.size());
        for (std::size_t k = 0; k < Size(); ++k) {
            ForEachFace([&](std::size_t f) { missing[f] = Missing(samples, f, k); });
            for (std::size_t w = 0; w < isFree.size(); ++w)
                isFree[w] = places_[w].vertex != kNone && IsFree(w, k);
            const std::vector<double> change = equations.Solve(missing, isFree);
            for (std::size_t w = 0; w < isFree.size(); ++w)
                if (isFree[w]) values_[w * Size() + k] += static_cast<float>(change[w]);
        }
    }
    template <class Visit>
    void ForEachFace(const Visit& visit) const
    {
        ParallelRanges(threads_, surface_.FaceCount(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f) visit(f);
        });
    }
    template <class Visit>
    void ForEachSample(const ChartSamples& samples, std::size_t f, const Visit& visit) const
    {
        for (std::uint32_t i = samples.begin[f]; i < samples.begin[f + 1]; ++i) {
            const ChartSamples::Sample& sample = samples.samples[i];
            visit(static_cast<double>(Norm(original_.Normal(sample.face))), sample);
        }
    }
    std::array<double, 3> Missing(const ChartSamples& samples, std::size_t f, std::size_t k) const
    {
        std::array<double, 3> sum{};
        const auto& wedge = wedges_.ofFace[f];
        ForEachSample(samples, f, [&](double area, const ChartSamples::Sample& sample) {
            const std::array<float, 3> at = samples.Weights(sample.index);
            double difference = 0;
            for (std::size_t j = 0; j < 3; ++j)
                difference +=
                    static_cast<double>(at[j]) * static_cast<double>(input_.Corner(sample.face, j)[k]) -
                    static_cast<double>(sample.weights[j]) *
                        static_cast<double>(values_[wedge[j] * Size() + k]);
            for (std::size_t j = 0; j < 3; ++j)
                sum[j] += area * difference * static_cast<double>(sample.weights[j]);
        });
        return sum;
    }

    /// Values to the range that they have in their chart of the original.
    void ClampToCharts()
    {
        std::uint32_t charts = 0;
        for (const std::uint32_t chart : wedges_.inputChart)
            if (chart != kNone) charts = std::max(charts, chart + 1);
        std::vector<float> low(charts * Size(), std::numeric_limits<float>::max()), high(low.size(), -low[0]);
        for (std::size_t f = 0; f < view_.faceCount; ++f) {
            const std::uint32_t chart = wedges_.inputChart[f];
            if (chart == kNone) continue;
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t k = 0; k < Size(); ++k) {
                    const float value = input_.Corner(f, j)[k];
                    low[chart * Size() + k] = std::min(low[chart * Size() + k], value);
                    high[chart * Size() + k] = std::max(high[chart * Size() + k], value);
                }
        }
        for (std::size_t w = 0; w < places_.size(); ++w) {
            if (places_[w].vertex == kNone) continue;
            const std::size_t chart = places_[w].chart * Size();
            for (std::size_t k = 0; k < Size(); ++k)
                values_[w * Size() + k] =
                    std::clamp(values_[w * Size() + k], low[chart + k], high[chart + k]);
        }
    }

    /// Wedges of a vertex that had the same value after the collapse have the same at the end.
    void JoinUncutChannels()
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t w = 0; w < places_.size(); ++w)
            if (places_[w].vertex != kNone) order.push_back(w);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::make_pair(places_[a].vertex, a) < std::make_pair(places_[b].vertex, b);
        });
        for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
            while (end < order.size() && places_[order[end]].vertex == places_[order[begin]].vertex) ++end;
            if (end - begin < 2 || IsFixed(order[begin])) continue;
            for (std::size_t k = 0; k < Size(); ++k)
                if (!IsTexture(k))
                    JoinUncut({order.begin() + static_cast<std::ptrdiff_t>(begin),
                               order.begin() + static_cast<std::ptrdiff_t>(end)},
                              k);
        }
    }
    void JoinUncut(std::vector<std::uint32_t> wedges, std::size_t k)
    {
        const auto collapsed = [&](std::uint32_t w) { return wedges_.Values(w)[k]; };
        std::stable_sort(wedges.begin(), wedges.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return collapsed(a) < collapsed(b); });
        for (std::size_t begin = 0, end = 0; begin < wedges.size(); begin = end) {
            float sum = 0;
            while (end < wedges.size() && collapsed(wedges[end]) == collapsed(wedges[begin]))
                sum += values_[wedges[end++] * Size() + k];
            if (end - begin < 2) continue;
            for (std::size_t i = begin; i < end; ++i)
                values_[wedges[i] * Size() + k] = sum / static_cast<float>(end - begin);
        }
    }

    void TakeBackTurnedFaces()
    {
        for (const std::uint32_t first : wedges_.channels.textures)
            for (bool changed = true; changed;) {
                changed = false;
                for (const auto& w : wedges_.ofFace) {
                    const double before = wedges_.TextureArea(w[0], w[1], w[2], first);
                    const auto now = [&](std::size_t j) { return values_.data() + w[j] * Size(); };
                    if (!TextureTurns(before, DoubleTextureArea(now(0), now(1), now(2), first))) continue;
                    for (const std::uint32_t wedge : w)
                        for (std::size_t k = first; k < first + 2; ++k) {
                            float& value = values_[wedge * Size() + k];
                            changed |= value != wedges_.Values(wedge)[k];
                            value = wedges_.Values(wedge)[k];
                        }
                }
            }
    }
};

} // namespace vcg_ext
