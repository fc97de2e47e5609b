// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/attributes/wedge_set.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/mesh/surface_wedges.h"

namespace vcg_ext
{

/// The charts of the input's faces, before the first collapse.
inline std::vector<std::uint32_t> ChartsOfInput(const SweepState& state, const WedgeSet& set,
                                                std::size_t inputFaces)
{
    std::vector<std::uint32_t> charts(inputFaces, kNone);
    for (std::size_t f = 0; f < state.faces.size(); ++f) charts[state.faces[f].origin] = set.chart[f];
    return charts;
}

/// What is left of the wedges, numbered in the order of the faces that are left.
inline SurfaceWedges ExtractWedges(const SweepState& state, const WedgeSet& set)
{
    SurfaceWedges wedges;
    wedges.channels = set.channels;
    wedges.keepSeams = set.keepSeams;
    const std::size_t channels = set.channels.size();
    const bool quadrics = set.weight > 0 && set.channels.HasValues() && !set.channels.HasTexture();
    std::vector<std::uint32_t> place(set.Count(), kNone);
    for (std::size_t f = 0; f < state.faces.size(); ++f) {
        if (!state.faces[f].Alive()) continue;
        wedges.chart.push_back(set.chart[f]);
        auto& corners = wedges.ofFace.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t id = set.ofCorner[3 * f + k];
            if (place[id] == kNone) {
                place[id] = static_cast<std::uint32_t>(wedges.count++);
                if (!set.side.empty()) wedges.side.push_back(set.side[id]);
                const float* record = set.Values(id);
                wedges.values.insert(wedges.values.end(), record, record + channels);
                if (quadrics) {
                    wedges.quadrics.insert(wedges.quadrics.end(), record + channels,
                                           record + set.layout.RecordSize());
                    wedges.centers.push_back(state.Position(state.faces[f].v[k]));
                }
            }
            corners[k] = place[id];
        }
    }
    return wedges;
}

} // namespace vcg_ext
