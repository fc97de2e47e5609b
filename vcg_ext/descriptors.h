// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <stdexcept>
#include <vector>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/curvature.h"
#include "vcg_ext/core/descriptor/laplacian.h"
#include "vcg_ext/core/descriptor/rescale.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/core/descriptor/one_ring_descriptors.h"

namespace vcg_ext
{

/// How much of a feature a vertex is: one number >= 0 a vertex, 0 in flat regions. Rows of kDescriptors.
enum class Descriptor {
    Laplacian,
    NormalizedUmbrella,
    MeanCurvature,
    GaussianCurvature,
    CurvatureEstimation
};

struct DescriptorRow {
    Descriptor kind;
    const char* id;
    const char* name;
    const char* help;
    /// One value a vertex, 0 where it has no faces. \pre as OneRings
    std::vector<double> (*compute)(const MeshView& mesh, int threads);
};

/// The magnitudes: a descriptor tells how much, not which way, the surface bends.
inline std::vector<double> Absolute(std::vector<double> values)
{
    for (double& value : values) value = std::fabs(value);
    return values;
}

/// Adding a descriptor means one function and one row; the enum is the index of the row.
inline constexpr DescriptorRow kDescriptors[] = {
    {Descriptor::Laplacian, "laplacian", "Laplacian",
     "Mean of the edge vectors along the vertex normal, divided by the mean edge length (Eq. 5 of Zhang et al. "
     "2012); from 0 to 1, the same at every scale",
     [](const MeshView& mesh, int threads) { return LaplacianDescriptor(mesh, threads); }},
    {Descriptor::NormalizedUmbrella, "normalised_umbrella", "Normalized umbrella",
     "The same with every edge scaled to length 1, so that long edges do not outweigh short ones",
     [](const MeshView& mesh, int threads) {
         return OneRingDescriptor<NormalizedUmbrellaFold>(mesh, threads);
     }},
    {Descriptor::MeanCurvature, "mean_curvature", "Mean curvature",
     "Magnitude of the mean curvature (Meyer et al. 2002, by VCG), in 1 / length; non-manifold edges count as "
     "borders",
     [](const MeshView& mesh, int) { return Absolute(ComputeDiscreteCurvatures(mesh).mean); }},
    {Descriptor::GaussianCurvature, "gaussian_curvature", "Gaussian curvature",
     "Magnitude of the Gaussian curvature (Meyer et al. 2002, by VCG), in 1 / length squared; non-manifold "
     "edges count as borders",
     [](const MeshView& mesh, int) { return Absolute(ComputeDiscreteCurvatures(mesh).gaussian); }},
    {Descriptor::CurvatureEstimation, "curvature_estimation", "Curvature estimation",
     "Mean of |2 n.e| / |e|^2 over the neighbors, in 1 / length; named after Wang et al. 2011, whose paper was not "
     "available, so the formula is ours",
     [](const MeshView& mesh, int threads) {
         return OneRingDescriptor<CurvatureEstimationFold>(mesh, threads);
     }},
};

/// One value a vertex, 0 where it has no faces. \param threads 0: all; the values do not depend on it
/// \pre as OneRings
inline std::vector<double> ComputeDescriptor(const MeshView& mesh, Descriptor kind, int threads = 1)
{
    return kDescriptors[static_cast<std::size_t>(kind)].compute(mesh, threads);
}

/// The same of any VCG triangle mesh, which stays as it is: one value for each element of mesh.vert, 0 for
/// deleted ones. Needs no component beyond the coordinates; polygons' diagonals (faux edges) are respected.
template <class Mesh>
std::vector<double> ComputeDescriptor(const Mesh& mesh, Descriptor kind, int threads = 1)
{
    return ComputeDescriptor(MeshArrays<Mesh>(mesh).View(), kind, threads);
}

} // namespace vcg_ext
