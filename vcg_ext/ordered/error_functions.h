// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/core/collapse/cost.h"
#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

/// g of Eq. 6. The numbers are those of the filter's parameter.
enum class ErrorFunction { Quadric = 0, ShortestEdge = 1, Melax = 2 };

/// A face of the vertex that a half-edge collapse removes.
struct RemovedFace {
    Vector3d unitNormal; ///< zero where the face has no area
    bool isOnEdge;       ///< it goes with the edge
};

/// What an error function sees of an edge; points count from the removed vertex, in the engine's frame.
struct CollapseSurroundings {
    Vector3d kept;                         ///< the other end
    std::vector<RemovedFace> removedFaces; ///< every face of the removed vertex
    std::vector<StarFace> stayingFaces;    ///< of the removed vertex; of the kept one too where it moves
    CentredQuadric<double> quadric{};      ///< of both ends, accumulated
    bool keptStays = true;                 ///< the kept end may not move
};

/// The price of a collapse and where the survivor goes.
struct CollapseError {
    double value;
    Vector3d placement;
};

using ErrorFunctionBody = std::optional<CollapseError> (*)(const CollapseSurroundings&);

/// Decides between edges that cost nothing, as in planes: the shorter first.
constexpr double kErrorTieBreak = 1e-12;

/// Garland and Heckbert's quadric error as MeshLab's default has it: planes of the faces weighted by twice
/// their area and planes across border edges weighted by their squared length; the quadrics of merged
/// vertices are added; the survivor goes to the minimum; the value is divided by the worst quality, 2 area /
/// longest edge², that a face around it would have, where that is below .3.
/// Unlike there the system is solved with a pull to the edge's midpoint that decides only what the quadric
/// leaves open, and the border's weight scales with the mesh.
inline std::optional<CollapseError> QuadricError(const CollapseSurroundings& edge)
{
    constexpr double kWorstQuality = 1e-9, kQualityClamp = .3;
    const CentredQuadric<double>& quadric = edge.quadric;
    Vector3d x = edge.kept;
    if (!edge.keptStays) {
        const Vector3d middle = .5 * edge.kept;
        const Vector3d slope = -1.0 * (quadric.matrix * middle + quadric.linear);
        const double pull = MidpointPull(quadric.matrix);
        const Vector3d pulled = SolveRegularized(quadric.matrix, slope, pull);
        // One step of refinement: where the quadric decides, nothing is left of the pull but its square.
        x = middle + pulled + SolveRegularized(quadric.matrix, slope - quadric.matrix * pulled, pull);
    }
    const std::optional<double> worst2 = WorstQuality2(edge.stayingFaces, x);
    if (!worst2) return std::nullopt;
    const double quality = std::clamp(std::sqrt(*worst2), kWorstQuality, kQualityClamp);
    const double tieBreak = kErrorTieBreak * Dot(edge.kept, edge.kept) * quadric.matrix.Trace();
    return CollapseError{(std::max(quadric(x), 0.0) + tieBreak) / quality, x};
}

/// Eq. 7: the length of the edge. The cheapest edge of a vertex is its shortest, so the queue finds
/// g(v) = min |e_vj| by itself.
inline std::optional<CollapseError> ShortestEdgeError(const CollapseSurroundings& edge)
{
    if (!WorstQuality2(edge.stayingFaces, edge.kept)) return std::nullopt;
    return CollapseError{std::sqrt(Dot(edge.kept, edge.kept)), edge.kept};
}

/// Melax (1998): the length of the edge, times the largest over the removed vertex's faces of the smallest
/// (1 - n·n') / 2 to the faces at the edge.
inline std::optional<CollapseError> MelaxError(const CollapseSurroundings& edge)
{
    if (!WorstQuality2(edge.stayingFaces, edge.kept)) return std::nullopt;
    double curvature = 0;
    for (const RemovedFace& face : edge.removedFaces) {
        double smallest = 1;
        for (const RemovedFace& side : edge.removedFaces)
            if (side.isOnEdge) smallest = std::min(smallest, (1 - Dot(face.unitNormal, side.unitNormal)) / 2);
        curvature = std::max(curvature, smallest);
    }
    return CollapseError{std::sqrt(Dot(edge.kept, edge.kept)) * (curvature + kErrorTieBreak), edge.kept};
}

/// One error function of the filter.
struct ErrorFunctionRow {
    ErrorFunction kind;
    const char* id;
    const char* name;
    const char* help;
    bool isDirected;  ///< half-edge collapse: the survivor stays where it is, both directions are priced
    bool usesQuadric; ///< CollapseSurroundings::quadric is filled in
    ErrorFunctionBody body;
};

/// All error functions, in the order of their numbers. A further one is a function and a row.
constexpr ErrorFunctionRow kErrorFunctions[] = {
    {ErrorFunction::Quadric, "quadric", "Quadric error",
     "Squared distances to the planes accumulated at both ends (Garland and Heckbert 1997), optimal placement.",
     false, true, QuadricError},
    {ErrorFunction::ShortestEdge, "shortest_edge", "Shortest edge first",
     "Length of the edge (Eq. 7); a vertex moves onto its nearest neighbor.", true, false, ShortestEdgeError},
    {ErrorFunction::Melax, "melax", "Melax",
     "Length of the edge times how much the surface bends around the removed vertex (Melax 1998).", true,
     false, MelaxError},
};

inline const ErrorFunctionRow& RowOf(ErrorFunction kind)
{
    return *std::find_if(std::begin(kErrorFunctions), std::end(kErrorFunctions),
                         [kind](const ErrorFunctionRow& row) { return row.kind == kind; });
}

} // namespace vcg_ext
