// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/descriptors.h"
#include "vcg_ext/core/refine/refine.h"
#include "vcg_ext/core/mesh/build_surface.h"

namespace vcg_ext
{

namespace refine_detail
{

/// Sample weights e^{2 l} with l in [0, 1]: the view's guidance, or the Laplacian descriptor.
inline std::vector<float> SampleWeights(const MeshView& view, int threads)
{
    std::vector<float> weights(view.vertexCount);
    if (view.guidance != nullptr) {
        for (std::size_t v = 0; v < weights.size(); ++v) weights[v] = std::exp(2 * view.guidance[v]);
        return weights;
    }
    const auto l = RescaledToUnit(ComputeDescriptor(view, Descriptor::Laplacian, threads));
    for (std::size_t v = 0; v < weights.size(); ++v) weights[v] = static_cast<float>(std::exp(2 * l[v]));
    return weights;
}

} // namespace refine_detail

/// Refines the outcome of any collapse in place; vertices that the refinement leaves alone keep their bits.
/// \param root the vertex of \p mesh that each vertex of \p original became part of, 0xFFFFFFFF for none
/// \return false where the parameters' progress asked to stop
inline bool RefineDecimated(const MeshView& original, DecimatedMesh& mesh,
                            const std::vector<std::uint32_t>& root, const DecimationParameters& parameters)
{
    if (mesh.triangles.empty()) return true;
    const int threads = ResolveThreads(parameters.threads);
    const Frame frame = FrameOf(original);
    const auto weights = refine_detail::SampleWeights(original, threads);
    const SurfaceArrays before = BuildSurfaceArrays(original, frame, weights.data(), threads);
    std::vector<std::uint8_t> fixed;
    const MeshView collapsed = ViewOf(mesh, original, fixed);
    SurfaceArrays after = BuildSurfaceArrays(collapsed, frame, nullptr, threads);
    Buffer<std::uint32_t> roots(root.size());
    std::copy(root.begin(), root.end(), roots.begin());

    RefinementParameters refinement;
    refinement.threads = threads;
    refinement.progress = parameters.progress;
    if (Refine(before, after, roots, refinement).cancelled) return false;
    WriteBack(after, frame, mesh);
    return true;
}

} // namespace vcg_ext
