// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vcg_ext/core/mesh/corner_attributes.h"

namespace vcg_ext
{

/// Which part of a VCG mesh holds an attribute.
enum class AttributeCarrier {
    WedgeTexture,
    VertexTexture,
    VertexColor,
    VertexQuality,
    WedgeColor,
    FaceColor,
    CustomVertex, ///< a per-vertex attribute with a name
    CustomFace,
    VertexRadius,
    FaceQuality
};

enum class AttributePlace { Vertex, Wedge, Face };

/// What is the same for all attributes of a carrier.
struct CarrierRow {
    AttributePlace place;
    ChannelKind kind;
    std::size_t components; ///< of custom ones each has its own
    const char* name;
};

/// The rows are in the order of AttributeCarrier.
constexpr CarrierRow kCarriers[] = {
    {AttributePlace::Wedge, ChannelKind::Texture, 2, "texture coordinates"},
    {AttributePlace::Vertex, ChannelKind::Texture, 2, "vertex texture coordinates"},
    {AttributePlace::Vertex, ChannelKind::Color, 4, "vertex color"},
    {AttributePlace::Vertex, ChannelKind::Scalar, 1, "vertex quality"},
    {AttributePlace::Wedge, ChannelKind::Color, 4, "wedge color"},
    {AttributePlace::Face, ChannelKind::Color, 4, "face color"},
    {AttributePlace::Vertex, ChannelKind::Scalar, 0, ""},
    {AttributePlace::Face, ChannelKind::Scalar, 0, ""},
    {AttributePlace::Vertex, ChannelKind::Scalar, 1, "vertex radius"},
    {AttributePlace::Face, ChannelKind::Scalar, 1, "face quality"},
};

/// One number of an attribute, and the channel of the corners that it is.
struct AttributeComponent {
    static constexpr std::uint32_t kNoChannel = ~std::uint32_t{0};
    std::uint32_t channel = kNoChannel; ///< none where it is the same everywhere
    double offset = 0, scale = 1;       ///< the channel has (number - offset) / scale

    bool HasChannel() const { return channel != kNoChannel; }
    float ToChannel(double number) const { return static_cast<float>((number - offset) / scale); }
    double FromChannel(float value) const { return static_cast<double>(value) * scale + offset; }
};

/// One attribute of a mesh that has become channels of its corners.
struct MeshAttribute {
    AttributeCarrier carrier = AttributeCarrier::VertexColor;
    std::string name; ///< of a custom one the mesh's, otherwise the carrier's
    std::vector<AttributeComponent> components;

    const CarrierRow& Row() const { return kCarriers[static_cast<std::size_t>(carrier)]; }
};

/// How the attributes of a mesh have become channels.
struct AttributeLayout {
    std::vector<MeshAttribute> attributes;
    std::size_t channels = 0;
    bool vertexTextures = false;  ///< vertices have different texture indices
    bool doubledVertices = false; ///< some were welded: where their values differ they are doubled again
};

inline bool HasTexture(const AttributeLayout& layout)
{
    const auto isTexture = [](const MeshAttribute& a) { return a.Row().kind == ChannelKind::Texture; };
    return std::any_of(layout.attributes.begin(), layout.attributes.end(), isTexture);
}

} // namespace vcg_ext
