// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/allocate.h>

#include "filters.h"
#include "number_text.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/measure/surface_distance.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/mesh_arrays.h"
#include "vertex_quality.h"

namespace laplacian_simplify
{

/// The distances of a result's vertices to the original, which become their quality.
class ErrorAsQuality
{
    std::vector<double> distances_; ///< one a live vertex of the original; 0 for those that go
    double visible_;                ///< a range of colors below this one would tell of nothing but rounding

  public:
    ErrorAsQuality(std::vector<double> distances, double visible)
        : distances_(std::move(distances)), visible_(visible)
    {
    }

    /// Changes the current mesh and then overwrites its quality and color: red is the least distance, blue
    /// the largest, as of MeshLab's Hausdorff Distance, where that is no rounding.
    /// \param change may remove vertices and add copies of others \pre the current mesh is the original or a
    /// copy of it \return a line for the log
    template <class Host, class Change>
    std::string StoreAfter(const Change& change, Host& host) const
    {
        auto& mesh = host.Mesh();
        using Allocator = vcg::tri::Allocator<typename Host::MeshType>;
        host.Require(kVertexQuality | kVertexColor);
        // An attribute, as the mesh keeps those up where it compacts and copies vertices.
        auto distance = Allocator::template AddPerVertexAttribute<double>(mesh);
        std::size_t next = 0;
        for (auto& vertex : mesh.vert)
            if (!vertex.IsD()) distance[vertex] = distances_[next++];
        change();
        ColorRange colors{std::numeric_limits<double>::max(), 0};
        for (const auto& vertex : mesh.vert) {
            if (vertex.IsD()) continue;
            colors = {std::min(colors.red, distance[vertex]), std::max(colors.blue, distance[vertex])};
        }
        const std::string range = "from " + RoundedText(colors.red, 4) + " to " + RoundedText(colors.blue, 4);
        colors.blue = std::max(colors.blue, colors.red + visible_);
        for (auto& vertex : mesh.vert)
            if (!vertex.IsD()) StoreAsQuality(vertex, distance[vertex], colors);
        Allocator::DeletePerVertexAttribute(mesh, distance);
        return "Distance of the vertices to the original, as quality: " + range + " in the unit of the mesh";
    }
};

/// Measures results of a mesh before they are put into it.
template <class Mesh>
class VertexErrors
{
    using Scalar = typename Mesh::ScalarType;
    using Point = std::array<double, 3>;

    const Mesh& original_;
    vcg_ext::MeshArrays<Mesh> arrays_;
    vcg_ext::SurfaceDistance surface_;

    static constexpr std::uint32_t kGone = UINT32_MAX;

    /// For each element of mesh.vert, where the result has it.
    std::vector<std::uint32_t> IndicesIn(const vcg_ext::DecimatedMesh& result) const
    {
        std::vector<std::uint32_t> indices(original_.vert.size(), kGone);
        for (std::size_t i = 0; i < result.vertexOrigin.size(); ++i)
            indices[result.vertexOrigin[i]] = static_cast<std::uint32_t>(i);
        return indices;
    }
    std::vector<bool> OnAFace() const
    {
        const vcg_ext::MeshView& view = arrays_.View();
        std::vector<bool> used(view.vertexCount);
        for (std::size_t k = 0; k < 3 * view.faceCount; ++k) used[view.triangles[k]] = true;
        return used;
    }

    /// As the mesh will have it.
    static Point Stored(const Point& p)
    {
        const auto stored = [](double x) { return static_cast<double>(static_cast<Scalar>(x)); };
        return {stored(p[0]), stored(p[1]), stored(p[2])};
    }

    /// Of the part of the diagonal that is a few roundings of single precision.
    double Visible() const
    {
        constexpr double kRounding = 1e-6;
        return kRounding * vcg_ext::kFrameDiagonal * vcg_ext::FrameOf(arrays_.View()).unit;
    }

  public:
    VertexErrors(const VertexErrors&) = delete;
    VertexErrors& operator=(const VertexErrors&) = delete;
    /// \pre a face; finite positions; \p original outlives this object and does not change meanwhile
    VertexErrors(const Mesh& original, int threads)
        : original_(original), arrays_(original), surface_(arrays_.View(), threads)
    {
    }

    /// \param result nullptr: the mesh stays as it is \throws vcg_ext::Cancelled
    ErrorAsQuality Of(const vcg_ext::DecimatedMesh* result, const vcg_ext::Progress& progress) const
    {
        const std::vector<std::uint32_t> indices =
            result ? IndicesIn(*result) : std::vector<std::uint32_t>(original_.vert.size(), kGone);
        const std::vector<bool> onAFace = OnAFace();
        std::vector<double> distances;
        std::vector<std::size_t> measured;
        std::vector<Point> points;
        for (std::size_t v = 0; v < indices.size(); ++v) {
            if (original_.vert[v].IsD()) continue;
            distances.push_back(0);
            const bool moved = indices[v] != kGone;
            if (!moved && onAFace[v]) continue; // goes, or stays where it is
            measured.push_back(distances.size() - 1);
            points.push_back(moved ? Stored(result->positions[indices[v]]) : arrays_.View().Position(v));
        }
        const std::vector<double> found = surface_.Of(points, progress);
        for (std::size_t i = 0; i < measured.size(); ++i) distances[measured[i]] = found[i];
        return {std::move(distances), Visible()};
    }
};

} // namespace laplacian_simplify
