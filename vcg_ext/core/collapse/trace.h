// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace vcg_ext
{

/// How far the sweeps went and what they were guided by. Who simplifies a mesh in parts finds one cost and
/// one scale for all of them in the parts' traces.
struct CollapseTrace {
    struct Step {
        double cost;       ///< what a collapse cost at most, in the mesh's unit of length to the fourth power
        std::size_t faces; ///< that were left
    };
    std::vector<Step> steps;    ///< one a sweep
    double descriptorScale = 0; ///< 1 / the descriptor that counted as 1
};

} // namespace vcg_ext
