// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace vcg_ext
{

/// The Laplacian descriptor (Eq. 5) of every vertex, 0 where it has no faces; within float rounding the same
/// as OneRingDescriptor<LaplacianFold>, several times faster: one pass over the faces counts every neighbour
/// once; the few vertices where that is not so (borders, non-manifold edges) or where a face is a needle are
/// done again by their rings.
/// \param threads 0: all \pre as OneRings
VCG_EXT_INLINE std::vector<double> LaplacianDescriptor(const MeshView& mesh, int threads = 1);

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/core/descriptor/laplacian_inl.h"
#endif
