// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/weld.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/attribute_access.h"
#include "vcg_ext/mesh_attribute.h"

namespace vcg_ext
{

/// How the attributes of a mesh are read.
struct AttributeReading {
    bool vertexQuality = true; ///< it is an attribute like the others
    bool welds = false;        ///< the mesh will be welded
    double weldDistance = 0;   ///< as WeldedVertices
    int threads = 1;
};

/// What a VCG mesh carries beside its surface, as CornerAttributes of the view of MeshArrays.
///
/// Numbers that are the same everywhere are left out, and so are scalars of which one is not finite. Labels
/// are the texture index and attributes of faces that are hard: they change at fewer than a fifth of the
/// edges. Other attributes of faces become means at vertices. Scalars at vertices that will be welded are
/// averaged: they make no seam.
template <class Mesh>
class MeshAttributes
{
    const Mesh& mesh_;
    const MeshArrays<Mesh>& arrays_;
    const MeshView& view_;
    AttributeReading reading_;
    AttributeLayout layout_;
    std::vector<float> values_;
    std::vector<std::int32_t> labels_;
    CornerAttributes corners_;
    std::vector<std::uint32_t> weld_; ///< as WeldedVertices; made when it is needed
    bool knowsWeld_ = false;
    std::vector<std::array<std::uint32_t, 2>> neighbors_; ///< faces at a common edge; as weld_

  public:
    /// \pre mesh, arrays and view outlive this and are not changed
    /// \param view of the arrays, with its fixed vertices
    MeshAttributes(const Mesh& mesh, const MeshArrays<Mesh>& arrays, const MeshView& view,
                   const AttributeReading& reading)
        : mesh_(mesh), arrays_(arrays), view_(view), reading_(reading)
    {
        if (view.faceCount == 0) return;
        for (MeshAttribute& attribute : AttributesOf(mesh)) Consider(std::move(attribute));
        ShareEqualTextures();
        LabelByTexture();
        Fill();
    }
    MeshAttributes(const MeshAttributes&) = delete;
    MeshAttributes& operator=(const MeshAttributes&) = delete;

    /// Null where there is nothing to be kept.
    const CornerAttributes* Corners() const
    {
        return corners_.kinds.empty() && labels_.empty() ? nullptr : &corners_;
    }
    const AttributeLayout& Layout() const { return layout_; }

  private:
    struct Extent {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        bool finite = true;

        void Add(double x)
        {
            low = std::min(low, x);
            high = std::max(high, x);
            finite = finite && std::isfinite(x);
        }
        bool Varies() const { return !finite || low < high; }
        bool FitsScalar() const { return finite && std::isfinite(high - low); }
    };

    /// Gives an attribute that is not the same everywhere its channels, or makes labels of it.
    void Consider(MeshAttribute attribute)
    {
        if (attribute.carrier == AttributeCarrier::VertexQuality && !reading_.vertexQuality) return;
        std::vector<Extent> extents(attribute.components.size());
        WithAccess(mesh_, attribute, [&](const auto& access) {
            ForEachElement(attribute.Row().place, [&](std::size_t i) {
                for (std::size_t c = 0; c < extents.size(); ++c) extents[c].Add(access.Get(i, c));
            });
        });
        const auto varies = [](const Extent& extent) { return extent.Varies(); };
        if (std::none_of(extents.begin(), extents.end(), varies)) return;
        const ChannelKind kind = attribute.Row().kind;
        const auto fits = [](const Extent& extent) { return extent.FitsScalar(); };
        if (kind == ChannelKind::Scalar && !std::all_of(extents.begin(), extents.end(), fits)) return;
        if (attribute.Row().place == AttributePlace::Face && IsHard(attribute)) return Label(attribute);
        for (std::size_t c = 0; c < extents.size(); ++c) {
            if (kind != ChannelKind::Texture && !extents[c].Varies()) continue; // of textures the pair stays
            AttributeComponent& component = attribute.components[c];
            component.channel = static_cast<std::uint32_t>(corners_.kinds.size());
            corners_.kinds.push_back(kind);
            if (kind != ChannelKind::Scalar) continue;
            component.offset = extents[c].low;
            component.scale = extents[c].high - extents[c].low;
        }
        layout_.attributes.push_back(std::move(attribute));
    }

    template <class Visit>
    void ForEachElement(AttributePlace place, const Visit& visit) const
    {
        if (place == AttributePlace::Vertex) { // those of no face say nothing of the surface
            for (std::size_t i = 0; i < 3 * view_.faceCount; ++i) visit(view_.triangles[i]);
            return;
        }
        for (std::size_t f = 0; f < view_.faceCount; ++f) {
            const std::size_t face = arrays_.FaceIndex(f);
            if (place == AttributePlace::Face)
                visit(face);
            else
                for (std::size_t k = 0; k < 3; ++k) visit(3 * face + k);
        }
    }

    /// Texture coordinates of vertices that are those of the wedges are the same channels.
    void ShareEqualTextures()
    {
        auto& all = layout_.attributes;
        if (all.size() < 2 || all[0].carrier != AttributeCarrier::WedgeTexture ||
            all[1].carrier != AttributeCarrier::VertexTexture)
            return;
        bool same = true;
        WithAccess(mesh_, all[0], [&](const auto& wedges) {
            WithAccess(mesh_, all[1], [&](const auto& vertices) {
                for (std::size_t i = 0; i < 3 * view_.faceCount; ++i) {
                    const std::size_t wedge = 3 * arrays_.FaceIndex(i / 3) + i % 3;
                    for (std::size_t c = 0; c < 2; ++c)
                        same = same && wedges.Get(wedge, c) == vertices.Get(view_.triangles[i], c);
                }
            });
        });
        if (!same) return;
        corners_.kinds.erase(corners_.kinds.begin(), corners_.kinds.begin() + 2);
        for (std::size_t a = 1; a < all.size(); ++a)
            for (AttributeComponent& component : all[a].components)
                if (component.HasChannel()) component.channel -= 2;
    }

    void LabelByTexture()
    {
        if (vcg::tri::HasPerWedgeTexCoord(mesh_))
            LabelBy([&](std::size_t f) { return mesh_.face[arrays_.FaceIndex(f)].cWT(0).N(); });
        if (!vcg::tri::HasPerVertexTexCoord(mesh_)) return;
        const auto index = [&](std::size_t f) { return mesh_.vert[view_.triangles[3 * f]].cT().N(); };
        layout_.vertexTextures = LabelBy(index);
    }
    void Label(const MeshAttribute& attribute)
    {
        WithAccess(mesh_, attribute, [&](const auto& access) {
            for (std::size_t c = 0; c < attribute.components.size(); ++c)
                LabelBy([&](std::size_t f) { return access.Get(arrays_.FaceIndex(f), c); });
        });
    }

    /// Faces of different numbers get different labels. \return whether there are some
    template <class NumberOf>
    bool LabelBy(const NumberOf& numberOf)
    {
        const auto first = numberOf(0);
        std::size_t same = 1;
        while (same < view_.faceCount && numberOf(same) == first) ++same;
        if (same == view_.faceCount) return false;
        labels_.resize(view_.faceCount, 0);
        using Key = std::pair<std::int32_t, std::decay_t<decltype(first)>>;
        std::map<Key, std::int32_t> labelOf;
        for (std::size_t f = 0; f < view_.faceCount; ++f)
            labels_[f] =
                labelOf.emplace(Key{labels_[f], numberOf(f)}, static_cast<std::int32_t>(labelOf.size()))
                    .first->second;
        return true;
    }

    /// The vertex that stands for \p v once the mesh is welded.
    std::uint32_t Welded(std::uint32_t v)
    {
        if (!std::exchange(knowsWeld_, true) && reading_.welds && CountNonFinite(view_) == 0)
            weld_ = WeldedVertices(view_, reading_.weldDistance, reading_.threads);
        return weld_.empty() ? v : weld_[v];
    }

    bool IsHard(const MeshAttribute& attribute)
    {
        constexpr std::size_t kFifth = 5;
        FindNeighbors();
        std::size_t changes = 0;
        WithAccess(mesh_, attribute, [&](const auto& access) {
            for (const auto& [f, g] : neighbors_) {
                bool differ = false;
                for (std::size_t c = 0; c < attribute.components.size(); ++c)
                    differ =
                        differ || access.Get(arrays_.FaceIndex(f), c) != access.Get(arrays_.FaceIndex(g), c);
                changes += differ;
            }
        });
        return kFifth * changes < neighbors_.size();
    }
    void FindNeighbors()
    {
        if (!neighbors_.empty()) return;
        std::vector<std::pair<std::uint64_t, std::uint32_t>> edges; // ends, face
        for (std::uint32_t f = 0; f < view_.faceCount; ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t a = Welded(view_.triangles[3 * std::size_t{f} + k]);
                const std::uint64_t b = Welded(view_.triangles[3 * std::size_t{f} + (k + 1) % 3]);
                edges.emplace_back(std::min(a, b) << 32U | std::max(a, b), f);
            }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 1; i < edges.size(); ++i)
            if (edges[i].first == edges[i - 1].first)
                neighbors_.push_back({edges[i - 1].second, edges[i].second});
    }

    void Fill()
    {
        neighbors_ = {};
        layout_.channels = corners_.kinds.size();
        values_.resize(3 * view_.faceCount * layout_.channels);
        for (const MeshAttribute& attribute : layout_.attributes)
            WithAccess(mesh_, attribute, [&](const auto& access) {
                for (std::size_t c = 0; c < attribute.components.size(); ++c)
                    if (attribute.components[c].HasChannel()) FillChannel(attribute, c, access);
            });
        if (layout_.channels > 0) corners_.values = values_.data();
        if (!labels_.empty()) corners_.labels = labels_.data();
    }
    template <class Access>
    void FillChannel(const MeshAttribute& attribute, std::size_t c, const Access& access)
    {
        const AttributePlace place = attribute.Row().place;
        if (place == AttributePlace::Wedge) {
            FillCorners(attribute.components[c],
                        [&](std::size_t i) { return access.Get(3 * arrays_.FaceIndex(i / 3) + i % 3, c); });
        } else if (place == AttributePlace::Face) {
            const std::vector<double> means = MeansAtVertices(
                3 * view_.faceCount, [&](std::size_t i) { return view_.triangles[i]; },
                [&](std::size_t i) { return Area(i / 3); },
                [&](std::size_t i) { return access.Get(arrays_.FaceIndex(i / 3), c); });
            FillCorners(attribute.components[c],
                        [&](std::size_t i) { return means[Welded(view_.triangles[i])]; });
        } else if (attribute.Row().kind == ChannelKind::Scalar) {
            const std::vector<double> means = MeansAtVertices(
                view_.vertexCount, [](std::size_t v) { return static_cast<std::uint32_t>(v); },
                [](std::size_t) { return 1.0; }, [&](std::size_t v) { return access.Get(v, c); });
            FillCorners(attribute.components[c],
                        [&](std::size_t i) { return means[Welded(view_.triangles[i])]; });
        } else {
            FillCorners(attribute.components[c],
                        [&](std::size_t i) { return access.Get(view_.triangles[i], c); });
        }
    }
    template <class NumberOf>
    void FillCorners(const AttributeComponent& component, const NumberOf& numberOf)
    {
        for (std::size_t i = 0; i < 3 * view_.faceCount; ++i)
            values_[i * layout_.channels + component.channel] = component.ToChannel(numberOf(i));
    }

    bool IsFixed(std::uint32_t v) const { return view_.fixedVertices && view_.fixedVertices[v] != 0; }

    double Area(std::size_t face) const
    {
        const auto at = [&](std::size_t k) {
            const auto p = view_.Position(view_.triangles[3 * face + k]);
            return Vector3<double>{p[0], p[1], p[2]};
        };
        return Norm(Cross(at(1) - at(0), at(2) - at(0)));
    }

    /// Of every vertex that stands for welded ones the weighted mean of \p count numbers at them.
    template <class VertexOf, class WeightOf, class NumberOf>
    std::vector<double> MeansAtVertices(std::size_t count, const VertexOf& vertexOf, const WeightOf& weightOf,
                                        const NumberOf& numberOf)
    {
        std::vector<double> sum(view_.vertexCount, 0), weights(view_.vertexCount, 0);
        for (std::size_t i = 0; i < count; ++i) {
            constexpr double kOfNoArea = 1e-300; // a vertex of such faces alone has a mean, too
            const double weight = std::max(weightOf(i), kOfNoArea);
            const std::uint32_t v = Welded(vertexOf(i));
            if (v != vertexOf(i) && IsFixed(v)) continue; // that one keeps its own
            sum[v] += weight * numberOf(i);
            weights[v] += weight;
        }
        for (std::size_t v = 0; v < sum.size(); ++v)
            if (weights[v] > 0) sum[v] /= weights[v];
        return sum;
    }
};

} // namespace vcg_ext
