// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "number_text.h"
#include "vcg_ext/descriptors.h"

namespace laplacian_simplify
{

/// The quality of every element of mesh.vert, 0 for deleted ones.
/// \throws std::invalid_argument if some are not finite, with their number
template <class Mesh>
std::vector<double> StoredQuality(const Mesh& mesh)
{
    std::vector<double> quality(mesh.vert.size());
    std::size_t bad = 0;
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        if (mesh.vert[v].IsD()) continue;
        quality[v] = static_cast<double>(mesh.vert[v].cQ());
        bad += !std::isfinite(quality[v]);
    }
    if (bad > 0)
        throw std::invalid_argument("descriptor = vertex_quality, but the quality is not finite at " +
                                    CountText(bad) + " of " + CountText(static_cast<std::size_t>(mesh.vn)) +
                                    " vertices");
    return quality;
}

/// Whether option \p option of a parameter "descriptor" is the vertex quality as it is.
inline bool IsStoredQuality(int option)
{
    return option >= static_cast<int>(std::size(vcg_ext::kDescriptors));
}

/// The values of option \p option of a parameter "descriptor": a row of kDescriptors or, after the last row,
/// the vertex quality as it is. One value for each element of mesh.vert.
template <class Mesh>
std::vector<double> DescriptorValues(const Mesh& mesh, int option, int threads)
{
    if (IsStoredQuality(option)) return StoredQuality(mesh);
    return vcg_ext::ComputeDescriptor(mesh, static_cast<vcg_ext::Descriptor>(option), threads);
}

/// The same rescaled to [0, 1] for the decimation. Empty for the Laplacian descriptor, which the decimation
/// computes itself.
template <class Mesh>
std::vector<float> Guidance(const Mesh& mesh, int option, int threads)
{
    if (option == static_cast<int>(vcg_ext::Descriptor::Laplacian)) return {};
    std::vector<float> guidance;
    guidance.reserve(mesh.vert.size());
    for (const double value : vcg_ext::RescaledToUnit(DescriptorValues(mesh, option, threads)))
        guidance.push_back(static_cast<float>(value));
    return guidance;
}

} // namespace laplacian_simplify
