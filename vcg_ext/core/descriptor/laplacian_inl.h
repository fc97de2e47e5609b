// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/float8.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/descriptor/laplacian_passes.h"
#include "vcg_ext/core/descriptor/one_ring_descriptors.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

VCG_EXT_INLINE std::vector<double> LaplacianDescriptor(const MeshView& mesh, int threads)
{
    if (mesh.fauxEdges != nullptr) return OneRingDescriptor<LaplacianFold>(mesh, threads);
    threads = UsefulThreadCount(threads, mesh.faceCount);
    const bool eightAtOnce = HasAvx2();
    return mesh.doublePositions ? LaplacianDescriptorOf<double>(mesh, threads, eightAtOnce)
                                : LaplacianDescriptorOf<float>(mesh, threads, eightAtOnce);
}

} // namespace vcg_ext
