// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <vcg/complex/complex.h>

#include "filters.h"
#include "number_text.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/measure/surface_distance.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/mesh_arrays.h"
#include "vertex_quality.h"

namespace laplacian_simplify
{

template <class Vertex>
std::array<double, 3> PositionOf(const Vertex& vertex)
{
    return {static_cast<double>(vertex.cP()[0]), static_cast<double>(vertex.cP()[1]),
            static_cast<double>(vertex.cP()[2])};
}

/// Remembers the surface of a mesh: the distance of a result to it becomes the quality of the result's
/// vertices.
class ErrorAsQuality
{
    std::vector<std::array<double, 3>> positions_;
    std::vector<std::uint32_t> triangles_;
    int threads_;

    vcg_ext::MeshView View() const
    {
        vcg_ext::MeshView view;
        view.positions = positions_.data();
        view.positionStride = sizeof positions_.front();
        view.doublePositions = true;
        view.vertexCount = positions_.size();
        view.triangles = triangles_.data();
        view.faceCount = triangles_.size() / 3;
        return view;
    }

    /// A shorter distance is rounding, and all colors of the ramp would tell of nothing else.
    static double Visible(const vcg_ext::MeshView& view)
    {
        constexpr double kRounding = 1e-6; // of the diagonal: that of single precision, a few times
        return kRounding * vcg_ext::kFrameDiagonal * vcg_ext::FrameOf(view).unit;
    }

  public:
    /// \param original may change and go afterward \pre a face; finite positions
    template <class Mesh>
    ErrorAsQuality(const Mesh& original, int threads) : threads_(threads)
    {
        const vcg_ext::MeshArrays<Mesh> arrays(original);
        const vcg_ext::MeshView& view = arrays.View();
        triangles_.assign(view.triangles, view.triangles + 3 * view.faceCount);
        positions_.reserve(original.vert.size());
        for (const auto& vertex : original.vert) positions_.push_back(PositionOf(vertex));
    }

    /// Overwrites quality and color of the current mesh: red is the least distance, blue the largest, as of
    /// MeshLab's Hausdorff Distance, where that is no rounding. \return a line for the log
    template <class Host>
    std::string Store(Host& host) const
    {
        auto& mesh = host.Mesh();
        std::vector<bool> inScope;
        std::vector<std::array<double, 3>> points;
        for (const auto& vertex : mesh.vert) {
            inScope.push_back(!vertex.IsD());
            if (inScope.back()) points.push_back(PositionOf(vertex));
        }
        const vcg_ext::MeshView view = View();
        const std::vector<double> distances = vcg_ext::SurfaceDistance(view, threads_).Of(points);
        const auto [least, largest] = std::minmax_element(distances.begin(), distances.end());
        const ColorRange colors{*least, std::max(*largest, *least + Visible(view))};
        std::vector<double> values(mesh.vert.size());
        std::size_t next = 0;
        for (std::size_t v = 0; v < values.size(); ++v)
            if (inScope[v]) values[v] = distances[next++];
        host.Require(kVertexQuality | kVertexColor);
        StoreAsQuality(mesh, values, inScope, colors);
        return "Distance of the vertices to the original, as quality: from " + RoundedText(*least, 4) +
               " to " + RoundedText(*largest, 4) + " in the unit of the mesh";
    }
};

} // namespace laplacian_simplify
