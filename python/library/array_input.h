// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "simplify_arrays.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/mesh_view.h"

namespace array_library
{

/// The caller's mesh, checked, as the core reads it.
struct Input {
    vcg_ext::MeshView view;
    vcg_ext::CornerAttributes attributes; ///< the view points to it where there are some
    std::vector<std::uint32_t> triangles; ///< where the caller's indices are not 32 bits long
    std::vector<std::uint8_t> onFace;     ///< one a vertex
    std::vector<std::uint8_t> fixed;      ///< empty: the caller's
    std::vector<float> guidance;          ///< empty: the core computes the Laplacian descriptor
};

/// Reads and checks the caller's mesh into \p input, which does not move afterwards: its view points into it.
/// \throws std::invalid_argument that says what is wrong with the mesh
void Take(const laplacian_simplify_mesh& mesh, const laplacian_simplify_parameters& parameters, Input& input);

} // namespace array_library
