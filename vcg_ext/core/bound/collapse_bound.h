// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/bound/covered_points.h"
#include "vcg_ext/core/bound/original_edges.h"
#include "vcg_ext/core/bound/segment_proof.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/mesh/face_tree.h"

namespace vcg_ext
{

/// A face of the original that is within the limit of a live vertex.
struct NearbyFace {
    std::uint32_t face;
    float distance;
};

/// What a bounded collapse is asked for, and what the runs before it have learnt.
struct BoundTask {
    double bound = 0;               ///< in the frame: kFrameDiagonal is the diagonal of the mesh
    std::unique_ptr<FaceTree> tree; ///< of the original's faces; built where there is none
    /// Where the certificate failed: whole faces are proven there. One byte an input vertex, or empty.
    std::vector<std::uint8_t> strictVertices;
    struct Point {
        Vector3<double> position; ///< in the frame
        std::uint32_t face;       ///< the input face on which it lies
    };
    std::vector<Point> strictPoints; ///< points of the original that must stay covered
};

/// What the collapses must know, and keep up to date, so that both surfaces stay within a limit of each
/// other. All lengths are in the engine's frame.
struct CollapseBound {
    const FaceTree& original;
    ExactSurface exact; ///< the same
    float limit;
    CoveredPoints covered;
    OriginalEdges edges;
    Buffer<NearbyFace> nearby;         ///< of every live vertex
    Buffer<std::uint32_t> ringChanged; ///< the sweep in which the faces around a vertex changed last
    Buffer<std::uint32_t>
        edgeRefused;         ///< 3 face + index of the edge's first vertex: the sweep that refused it
    std::uint32_t sweep = 1; ///< the running one

    /// \param limitInFrame > 0 \pre view and tree outlive this object
    CollapseBound(const MeshView& view, const FaceTree& tree, float limitInFrame)
        : original(tree), exact(view, tree, RoundingOf(view, view, tree.frame())), limit(limitInFrame)
    {
    }

    /// Part of the bound that the collapses may use up; the rest is for what points and edges cannot see.
    static constexpr double kInnerShare = 0.99;
    /// In the frame: what positions in single precision may be wrong.
    static constexpr double kRounding = 1e-4;

    /// The limit of the collapses for a bound, both in the frame.
    static float InnerLimit(double bound)
    {
        return static_cast<float>(std::max(kInnerShare * bound - kRounding, 0.5 * bound));
    }

    /// Is \p point of the simplified surface within the limit? Most often it is close to what its neighbors
    /// are close to, so \p first and \p second are asked first.
    std::optional<SegmentEnd> FindNearby(const Vector3<float>& point, std::uint32_t first,
                                         std::uint32_t second) const
    {
        const float limit2 = limit * limit;
        for (const std::uint32_t face : {first, second}) {
            const float distance2 = original.Distance2ToFace(face, point);
            if (distance2 <= limit2) return SegmentEnd{point, face, std::sqrt(distance2)};
        }
        const auto found = original.FaceWithin(point, limit2);
        if (!found) return std::nullopt;
        return SegmentEnd{point, found->face, std::sqrt(found->distance2)};
    }
};

} // namespace vcg_ext
