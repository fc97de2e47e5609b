// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/mesh/channels.h"

namespace vcg_ext
{

/// The attributes of a simplified surface, between the collapse and the end. A wedge is a vertex together
/// with one tuple of everything that its corners carry; faces that are joined over edges without a difference
/// in wedges are a chart.
struct SurfaceWedges {
    Channels channels;     ///< none where there are labels alone
    std::size_t count = 0; ///< of wedges
    bool keepSeams = true;
    std::vector<float> values;                        ///< of every wedge, as the collapse left them
    std::vector<std::array<std::uint32_t, 3>> ofFace; ///< the wedges of every face's corners
    std::vector<std::uint32_t> chart;                 ///< of every face
    std::vector<std::uint32_t> inputChart; ///< of every face of the input; kNone where it was left out

    std::vector<std::uint32_t> side; ///< of every wedge, as WedgeSet::side; empty where there are none

    /// Of every wedge the quadric of its attributes (attributes/wedge_quadric.h), and where it is centered;
    /// empty where no move has to ask for them.
    std::vector<float> quadrics;
    std::vector<Vector3<float>> centers;

    std::size_t Count() const { return count; }
    const float* Values(std::uint32_t wedge) const { return values.data() + wedge * channels.size(); }
    double TextureArea(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t first) const
    {
        return DoubleTextureArea(Values(a), Values(b), Values(c), first);
    }
};

} // namespace vcg_ext
