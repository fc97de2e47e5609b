// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/mesh/corner_attributes.h"

namespace vcg_ext
{

/// The channels of a mesh's corners, and which of them share a scale: a pair of texture coordinates, all
/// parts of colors, every scalar by itself.
struct Channels {
    std::vector<ChannelKind> kinds;
    std::vector<std::uint32_t> group; ///< of each channel
    std::vector<float> unit; ///< a difference that counts as a whole one: 1, of a scalar what lies between
                             ///< its 1st and its 99th percentile
    std::vector<std::uint32_t> textures; ///< the first channel of every pair of texture coordinates
    std::uint32_t groups = 0;

    std::size_t size() const { return kinds.size(); }
    bool HasTexture() const { return !textures.empty(); }
    /// Channels that are no texture coordinates.
    bool HasValues() const { return kinds.size() > 2 * textures.size(); }
};

namespace channels_detail
{

/// What lies between the percentiles of a channel's values, from an even sample.
inline float Spread(const CornerAttributes& attributes, std::size_t faces, std::size_t channel)
{
    constexpr std::size_t kSamples = 1 << 16;
    constexpr double kLow = 0.01, kHigh = 0.99;
    const std::size_t corners = 3 * faces, step = std::max<std::size_t>(1, corners / kSamples);
    std::vector<float> sample;
    for (std::size_t i = 0; i < corners; i += step)
        sample.push_back(attributes.values[i * attributes.Channels() + channel]);
    std::sort(sample.begin(), sample.end());
    if (sample.empty()) return 1;
    const auto at = [&](double part) {
        return sample[static_cast<std::size_t>(part * static_cast<double>(sample.size() - 1))];
    };
    const float spread = at(kHigh) - at(kLow), whole = sample.back() - sample.front();
    return spread > 0 ? spread : whole > 0 ? whole : 1;
}

} // namespace channels_detail

/// \throws std::invalid_argument where texture coordinates do not come in pairs
inline Channels ChannelsOf(const CornerAttributes& attributes, std::size_t faces)
{
    constexpr std::uint32_t kNoGroup = ~std::uint32_t{0};
    Channels channels;
    channels.kinds = attributes.kinds;
    std::uint32_t colors = kNoGroup;
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const ChannelKind kind = channels.kinds[k];
        channels.unit.push_back(kind == ChannelKind::Scalar ? channels_detail::Spread(attributes, faces, k)
                                                            : 1.0f);
        if (kind == ChannelKind::Texture) {
            if (k + 1 == channels.size() || channels.kinds[k + 1] != ChannelKind::Texture)
                throw std::invalid_argument("channel " + std::to_string(k) +
                                            " is a texture coordinate without a second one");
            channels.textures.push_back(static_cast<std::uint32_t>(k));
            channels.group.insert(channels.group.end(), 2, channels.groups++);
            channels.unit.push_back(1);
            ++k;
        } else if (kind == ChannelKind::Color) {
            if (colors == kNoGroup) colors = channels.groups++;
            channels.group.push_back(colors);
        } else {
            channels.group.push_back(channels.groups++);
        }
    }
    return channels;
}

/// Twice the signed area in the texture of three corners with the values \p a, \p b and \p c, of the pair
/// that begins with channel \p first. In double precision its sign is that of the floats.
inline double DoubleTextureArea(const float* a, const float* b, const float* c, std::uint32_t first)
{
    const auto from = [&](const float* p, std::uint32_t k) {
        return static_cast<double>(p[k]) - static_cast<double>(a[k]);
    };
    const std::uint32_t second = first + 1;
    return from(b, first) * from(c, second) - from(b, second) * from(c, first);
}

/// Whether a face with a texture area of \p before turns over, or loses it, with one of \p after.
inline bool TextureTurns(double before, double after)
{
    return before > 0 ? !(after > 0) : before < 0 && !(after < 0);
}

} // namespace vcg_ext
