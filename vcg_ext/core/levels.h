// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/pipeline.h"
#include "vcg_ext/core/simplify.h"

namespace vcg_ext
{

/// A level of detail: what takes the place of the members of DecimationParameters with these names.
struct Level {
    std::size_t targetFaces = 1; ///< at least 1
    double maxError = 0;         ///< percent of the diagonal; 0: no bound
};

/// \throws std::invalid_argument unless there are levels, in order from the finest to the coarsest; equal
/// ones
///         are welcome
inline void CheckLevels(const std::vector<Level>& levels)
{
    if (levels.empty()) throw std::invalid_argument("there are no levels");
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const Level &finer = levels[i - 1], &level = levels[i];
        if (level.targetFaces > finer.targetFaces)
            throw std::invalid_argument("target_faces = " + std::to_string(level.targetFaces) + " of level " +
                                        std::to_string(i + 1) + " is more than that of the level before it");
        if (!(level.maxError >= finer.maxError))
            throw std::invalid_argument("max_error = " + std::to_string(level.maxError) + " of level " +
                                        std::to_string(i + 1) + " is less than that of the level before it");
    }
}

/// The parameters of one level in a run of its own.
inline DecimationParameters ParametersOf(const DecimationParameters& parameters, const Level& level)
{
    DecimationParameters own = parameters;
    own.targetFaces = level.targetFaces;
    own.maxError = level.maxError;
    return own;
}

/// Every level by a run of its own, for what cannot go on from one level to the next: a bound, or order
/// strict. \param simplify called as simplify(DecimationParameters), returns a Simplification
/// \pre CheckLevels passes
template <class Simplify>
std::vector<Simplification> EachLevelByItself(const DecimationParameters& parameters,
                                              const std::vector<Level>& levels, const Simplify& simplify)
{
    std::vector<Simplification> results;
    const int count = static_cast<int>(levels.size());
    for (int i = 0; i < count; ++i) {
        DecimationParameters own = ParametersOf(parameters, levels[static_cast<std::size_t>(i)]);
        if (parameters.progress)
            own.progress = [&](int percent, const char* stage) {
                return parameters.progress((100 * i + percent) / count, stage);
            };
        results.push_back(simplify(own));
        if (results.back().report.stopReason != StopReason::Cancelled) continue;
        const Simplification cancelled = results.back();
        return std::vector<Simplification>(levels.size(), cancelled);
    }
    return results;
}

/// Levels of detail of a mesh of plain arrays, which stays as it is: each is a result as that of Simplify,
/// with everything that it promises, refined and measured against the original.
///
/// Without a bound the collapse of a level goes on where that of the level before it stopped; one that would
/// make faces cross is done again from the original, and those after it go on from there. Levels with a bound
/// are runs of their own. With effort fast, and without measurement, levels of 50, 25 and 10 % take about
/// twice as long as the last one alone, which is less than the sum. The first level is to the bit what
/// Simplify returns for it. Where the run is cancelled every level is as that of a cancelled Simplify.
///
/// \param parameters targetFaces and maxError are not read
/// \param levels from the finest to the coarsest; a bound for all of them or for none
/// \throws as Simplify and CheckLevels
VCG_EXT_INLINE std::vector<Simplification> SimplifyLevels(const MeshView& view,
                                                          const DecimationParameters& parameters,
                                                          const std::vector<Level>& levels);

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/core/levels_inl.h"
#endif
