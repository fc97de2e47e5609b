// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include <vcg/complex/complex.h>

namespace laplacian_simplify
{

/// The values that are red and blue; the others are between, or like the closer one.
struct ColorRange {
    double red;
    double blue;
};

/// Stores a value as the quality of a vertex and, with a range, as its color in the host's ramp.
template <class Vertex>
void StoreAsQuality(Vertex& vertex, double value, const std::optional<ColorRange>& colors)
{
    vertex.Q() = static_cast<std::decay_t<decltype(vertex.Q())>>(value);
    if (colors)
        vertex.C().SetColorRamp(static_cast<float>(colors->red), static_cast<float>(colors->blue),
                                static_cast<float>(value));
}

/// The same for each element of mesh.vert.
template <class Mesh>
void StoreAsQuality(Mesh& mesh, const std::vector<double>& values, const std::vector<bool>& inScope,
                    const std::optional<ColorRange>& colors)
{
    for (std::size_t v = 0; v < values.size(); ++v)
        if (inScope[v]) StoreAsQuality(mesh.vert[v], values[v], colors);
}

} // namespace laplacian_simplify
