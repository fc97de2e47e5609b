// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vcg_ext
{

/// What one number of a corner is.
enum class ChannelKind : std::uint8_t {
    Texture, ///< a texture coordinate; always two in a row, u and v
    Color,   ///< a part of a color, 0..1
    Scalar   ///< anything else, in its own unit
};

/// What the corners and faces of a mesh carry beside positions; arrays that somebody else owns.
struct CornerAttributes {
    const float* values = nullptr;  ///< kinds.size() numbers a corner, three corners a face; may be null
    std::vector<ChannelKind> kinds; ///< one a channel
    const std::int32_t* labels = nullptr; ///< one a face: material, texture, part, ...; may be null
    /// One a corner: corners of a vertex with different ones are on different sides of a seam, whatever else
    /// they carry; may be null.
    const std::uint32_t* sides = nullptr;

    std::size_t Channels() const { return kinds.size(); }
    const float* Corner(std::size_t face, std::size_t corner) const
    {
        return values + (3 * face + corner) * kinds.size();
    }
    std::int32_t Label(std::size_t face) const { return labels != nullptr ? labels[face] : 0; }
    std::uint32_t Side(std::size_t face, std::size_t corner) const
    {
        return sides != nullptr ? sides[3 * face + corner] : 0;
    }
};

/// Faces with a value that is not a finite number.
inline std::size_t CountNonFinite(const CornerAttributes& attributes, std::size_t faces)
{
    const std::size_t perFace = 3 * attributes.Channels();
    std::size_t count = 0;
    for (std::size_t f = 0; f < faces; ++f) {
        bool finite = true;
        for (std::size_t k = 0; k < perFace; ++k) finite &= std::isfinite(attributes.values[f * perFace + k]);
        count += !finite;
    }
    return count;
}

} // namespace vcg_ext
