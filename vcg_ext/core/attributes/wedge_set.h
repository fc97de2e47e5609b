// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/mesh/channels.h"
#include "vcg_ext/core/attributes/wedge_quadric.h"
#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// What the collapses must know of the attributes.
///
/// A wedge is a vertex together with one tuple of everything that its corners carry: label, side and
/// channels. An edge is a seam where its two faces differ in the wedge at either end. Faces that are joined
/// over edges that are no seams are a chart.
struct WedgeSet {
    Channels channels;
    WedgeLayout layout;
    Buffer<float> records;          ///< of the layout, one a wedge
    Buffer<std::uint32_t> ofCorner; ///< the wedge of corner k of face f at 3 f + k
    /// Of every wedge: those of a vertex with the same are on the same side of its hard edges. Empty where
    /// the mesh has none.
    Buffer<std::uint32_t> side;
    Buffer<std::uint32_t> chart;           ///< of every face; kNone once it is gone
    std::vector<std::uint32_t> chartFaces; ///< of every chart, as of the last count
    /// A face of every chart that no thread takes while others work, so that no chart is lost unseen; kNone
    /// where the chart is gone.
    std::vector<std::uint32_t> witness;
    float weight = 1;      ///< of attributes against the geometry; 0: the values guide nothing
    bool keepSeams = true; ///< no chart vanishes, no texture turns over, seams keep their shape

    std::size_t Count() const { return records.size() / std::max<std::size_t>(1, layout.RecordSize()); }
    float* Values(std::uint32_t wedge) { return records.data() + wedge * layout.RecordSize(); }
    const float* Values(std::uint32_t wedge) const { return records.data() + wedge * layout.RecordSize(); }
    WedgeQuadric<float> Quadric(std::uint32_t wedge)
    {
        return {channels, layout, Values(wedge) + layout.channels};
    }
    WedgeQuadric<const float> Quadric(std::uint32_t wedge) const
    {
        return {channels, layout, Values(wedge) + layout.channels};
    }
    std::uint32_t& Of(Corner corner)
    {
        return ofCorner[3 * std::size_t{FaceOf(corner)} + static_cast<std::size_t>(IndexOf(corner))];
    }
    std::uint32_t Of(Corner corner) const
    {
        return ofCorner[3 * std::size_t{FaceOf(corner)} + static_cast<std::size_t>(IndexOf(corner))];
    }
};

/// Counts the faces of every chart and chooses its witness.
inline void CountCharts(WedgeSet& set)
{
    std::fill(set.chartFaces.begin(), set.chartFaces.end(), 0u);
    std::fill(set.witness.begin(), set.witness.end(), kNone);
    for (std::size_t f = 0; f < set.chart.size(); ++f) {
        const std::uint32_t chart = set.chart[f];
        if (chart == kNone) continue;
        if (set.chartFaces[chart]++ == 0) set.witness[chart] = static_cast<std::uint32_t>(f);
    }
}

} // namespace vcg_ext
