// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace vcg_ext
{

/// How far points of a result are from where the original has their texture coordinates, in their chart;
/// percent of the bounding box's diagonal.
struct TextureDeviation {
    double rms = 0;
    double largest = 0;
};

/// What has become of the attributes.
struct AttributeReport {
    /// Of every channel, in its own unit: between points of either surface and the closest of the same chart
    /// of the other. Empty where it was not measured, as the next.
    std::vector<double> rms;
    std::vector<TextureDeviation> textures; ///< of every pair of texture coordinates
    std::size_t charts = 0;                 ///< of the original
    std::size_t turnedFaces = 0; ///< whose texture has turned over against what most of their chart has
    std::size_t heldFaces = 0;   ///< more than the target, because seams allow no further collapse
};

} // namespace vcg_ext
