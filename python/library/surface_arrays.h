// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What measuring a mesh in parts needs, as C functions beside those of simplify_arrays.h and in their way:
// the Python package loads them with ctypes. The layout of the structure is repeated in
// python/laplacian_simplify/huge/surface_library.py.

#include <cstdint>

extern "C" {

/// Triangles in the caller's arrays, which are only read. Precondition: indices are below vertex_count,
/// positions are finite.
struct laplacian_simplify_surface {
    const double* positions; ///< three coordinates a vertex
    const std::uint32_t* faces;
    std::uint64_t vertex_count;
    std::uint64_t face_count; ///< at least 1
};

/// The distance of each point to the closest point of the surface, in the unit of its coordinates.
/// \param points three coordinates a point, finite; those that follow each other should be close to each
/// other \param distances one a point \return 0; 1 where there is not enough memory
__attribute__((visibility("default"))) std::int32_t
laplacian_simplify_distances(const laplacian_simplify_surface* surface, const double* points,
                             std::uint64_t point_count, std::int32_t threads, double* distances);

/// The Laplacian descriptor (Eq. 5) of every vertex, 0 where it has no faces.
/// \param values one a vertex
/// \return 0; 1 where there is not enough memory
__attribute__((visibility("default"))) std::int32_t
laplacian_simplify_descriptor(const laplacian_simplify_surface* surface, std::int32_t threads,
                              double* values);

/// Counts the edges with one face and those with three or more, but for edges between two fixed vertices,
/// whose other faces may be elsewhere. \param fixed_vertices a byte a vertex \param boundary \param
/// non_manifold overwritten \return 0; 1 where there is not enough memory
__attribute__((visibility("default"))) std::int32_t
laplacian_simplify_edges(const laplacian_simplify_surface* surface, const std::uint8_t* fixed_vertices,
                         std::uint64_t* boundary, std::uint64_t* non_manifold);

} // extern "C"
