// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/repair/local_energy.h"
#include "vcg_ext/core/repair/local_repair.h"

namespace vcg_ext
{

/// Repairs faces in passes, cheap repairs first: they often repair a neighbour too.
/// \param faulty faces, at the start and at the end, in ascending order
/// \param attempts as many faces are tried at most, which bounds the time \param stage named to the progress
/// \param faults of all faces, at the start \param enough so many of them may stay
template <class Faults>
void RunRepairPasses(LocalRepair<Faults>& repair, std::vector<std::uint32_t>& faulty, std::size_t attempts,
                     Boundary boundary, const StageProgress& progress, const char* stage,
                     std::ptrdiff_t faults = std::numeric_limits<std::ptrdiff_t>::max(),
                     std::ptrdiff_t enough = 0)
{
    constexpr float kTolerances[] = {1, 1.05F, 1.1F, 1.3F, 2};
    constexpr std::size_t kPasses = std::size(kTolerances);
    for (std::size_t pass = 0; pass < kPasses; ++pass) {
        for (const std::uint32_t f : faulty) {
            if (attempts == 0 || faults <= enough) break;
            --attempts;
            progress(static_cast<int>(100 * pass / kPasses), stage);
            faults -= repair.Repair(f, kTolerances[pass], pass > 0 && boundary != Boundary::Lock);
        }
        faulty.insert(faulty.end(), repair.Changed().begin(), repair.Changed().end());
        SortUnique(faulty);
        faulty.erase(std::remove_if(faulty.begin(), faulty.end(),
                                    [&](std::uint32_t f) { return !repair.IsFaulty(f); }),
                     faulty.end());
        if (attempts == 0 || faults <= enough) return;
    }
}

} // namespace vcg_ext
