// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <vcg/complex/complex.h>

#include "host.h"
#include "number_text.h"
#include "progress.h"
#include "results.h"
#include "stopwatch.h"
#include "values.h"
#include "vcg_ext/smoothing.h"
#include "vcg_ext/mesh_arrays.h"

namespace laplacian_simplify
{

/// How far the vertices of a mesh have moved.
struct Movement {
    std::size_t moved = 0;
    double largest = 0;  ///< distance
    double diagonal = 0; ///< of the bounding box before
};

/// Gives every live element of mesh.vert its new position. \pre as many positions as elements
template <class Mesh>
Movement MoveVertices(Mesh& mesh, const std::vector<vcg_ext::Coordinates>& positions)
{
    using Scalar = typename Mesh::ScalarType;
    Movement movement;
    vcg::Box3d box;
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        auto& vertex = mesh.vert[v];
        if (vertex.IsD()) continue;
        const vcg::Point3d before = vcg::Point3d::Construct(vertex.P());
        box.Add(before);
        for (int k = 0; k < 3; ++k)
            vertex.P()[k] = static_cast<Scalar>(positions[v][static_cast<std::size_t>(k)]);
        const double distance = (vcg::Point3d::Construct(vertex.P()) - before).Norm();
        movement.moved += distance > 0;
        movement.largest = std::max(movement.largest, distance);
    }
    movement.diagonal = box.Diag();
    return movement;
}

/// Filter "Umbrella Smooth".
template <class Host>
Report ApplyUmbrellaSmooth(Host& host, const Values& values)
{
    const Stopwatch stopwatch;
    auto& mesh = host.Mesh();
    ThrottledProgress progress([&](int percent, const char* stage) { return host.Progress(percent, stage); });
    const std::vector<bool> inScope = VerticesInScope(mesh, values.Boolean("selected_only"));
    const std::vector<std::uint8_t> movable(inScope.begin(), inScope.end());
    vcg_ext::SmoothingParameters parameters;
    parameters.umbrella = values.Choice<vcg_ext::UmbrellaOperator>("operator");
    parameters.steps = values.Integer("steps");
    parameters.stepSize = values.Real("step_size");
    parameters.boundary = values.Choice<vcg_ext::SmoothingBoundary>("boundary");
    parameters.movable = movable.data();
    parameters.progress = std::ref(progress);
    const vcg_ext::MeshArrays arrays(mesh);
    const auto positions = vcg_ext::SmoothedPositions(arrays.View(), parameters);

    const Movement movement = MoveVertices(mesh, positions);
    host.GeometryChanged();
    const double percent = movement.diagonal > 0 ? 100 * movement.largest / movement.diagonal : 0;
    Report report;
    report.SetCount("moved", movement.moved);
    report.Set("largest_movement", percent);
    report.Set("seconds", stopwatch.Seconds());
    host.Log(CountText(movement.moved) + " of " + CountText(static_cast<std::size_t>(mesh.vn)) +
             " vertices moved, by at most " + RoundedText(percent, 4) +
             " percent of the bounding box diagonal");
    return report;
}

} // namespace laplacian_simplify
