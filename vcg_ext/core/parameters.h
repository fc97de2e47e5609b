// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "vcg_ext/core/base/progress.h"

namespace vcg_ext
{

/// How open borders are treated.
enum class Boundary {
    Free,     ///< like any other edge
    Preserve, ///< planes perpendicular to the border keep its shape
    Lock      ///< border vertices neither move nor disappear
};

/// Quality/speed trade-off.
enum class Effort {
    Fast,     ///< collapse only
    Balanced, ///< collapse, then refine
    Best      ///< and exchange vertices between places, then mend the worst ones
};

/// Collapse algorithm.
enum class Order {
    Sweeps, ///< the parallel engine on arrays
    Strict  ///< the cheapest collapse each time: VCG's queue (LocalOptimization), or with attributes that of
            ///< the engine; one thread
};

/// What becomes of seams: edges at which texture, material or color is cut.
enum class Seams {
    Keep,  ///< every chart stays, and so does the shape of its border
    Ignore ///< charts may vanish where the target asks for it; the texture is then wrong there
};

enum class StopReason {
    Target = 0,
    ErrorBound = 1,
    NoLegalCollapse = 2,
    Cancelled = 3,
    Seams = 4 ///< no legal collapse, where without Seams::Keep there would have been
};

/// What a decimation does. The defaults are those of the filter.
struct DecimationParameters {
    std::size_t targetFaces = 0; ///< at least 1; at most so many faces remain, if that can be reached
    double maxError = 0;      ///< percent of the diagonal of the bounding box; no point of either surface is
                              ///< farther from the other; the target is then the lower end. 0: no bound
    double featureWeight = 2; ///< lambda of Eq. 6, [0, 50], dimensionless; 0 is plain decimation
    Effort effort = Effort::Balanced;
    Boundary boundary = Boundary::Preserve;
    double attributeWeight = 1; ///< of MeshView::attributes against the geometry, [0, 100]; 0: they are
                                ///< transferred and guide nothing
    Seams seams = Seams::Keep;
    bool preserveTopology = false;      ///< full link condition: handles and holes stay
    bool avoidSelfIntersections = true; ///< no more faces cross each other than before
    Order order = Order::Sweeps;
    bool cleanInput = true;   ///< weld open borders, drop degenerate and duplicate faces first: CleanedInput
    double weldDistance = 0;  ///< of cleanInput, percent of the diagonal, [0, 100]; 0: equal coordinates
    int threads = 0;          ///< 0: all; the result does not depend on it
    bool measureError = true; ///< fill DecimationReport::distances
    Progress progress;        ///< may be empty

    // For meshes that are simplified in parts. Order strict knows none of these.
    double costLimit = 0; ///< no collapse costs more: area times squared distance, weighted as in Eq. 6, in
                          ///< the mesh's unit of length to the fourth power; 0: no limit
    double descriptorScale = 0; ///< of CollapseTrace, for l of Eq. 6; 0: the mesh's own
};

} // namespace vcg_ext
