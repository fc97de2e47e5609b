// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The simplification of a mesh of plain arrays as a C function, for callers that cannot include C++ headers:
// the Python package loads it with ctypes, which lets other Python threads run in the meantime. It needs
// neither MeshLab nor VCG, has no state, and may run in several threads at the same time. The layouts of the
// structures are repeated in python/laplacian_simplify/library.py.

#include <cstdint>

extern "C" {

/// A triangle mesh in the caller's arrays, which are only read.
struct laplacian_simplify_mesh {
    const void* positions; ///< three coordinates a vertex
    const void* faces;     ///< three vertex indices a face
    std::uint64_t vertex_count;
    std::uint64_t face_count;
    std::int32_t double_positions; ///< 1: coordinates are double, 0: float
    std::int32_t index_bytes;      ///< of a vertex index: 4 or 8; a negative index is refused as any other
    const std::uint8_t* fixed_vertices; ///< a byte a vertex, not 0: never moves and stays; may be null
    std::int32_t shared_seams; ///< 1: those are of other meshes, too, and no new edge joins two of them
    /// A byte a face, 0: keeps its vertices and stays; null: all are selected.
    const std::uint8_t* selected_faces;
    const double* stored_quality; ///< a number a vertex for LAPLACIAN_SIMPLIFY_STORED_QUALITY, else null
    /// What the corners of faces carry, channel_count numbers a corner and three corners a face: they guide
    /// the collapse and are transferred. Null: nothing.
    const float* corner_values;
    const std::int32_t* channel_kinds; ///< one a channel; may be null where there are none
    std::uint64_t channel_count;
    const std::int32_t* face_labels; ///< one a face: seams run between different ones; may be null
    /// Normals that the surface is shaded with, three numbers a vertex or, which count more, a corner: seams
    /// run along hard edges, where they are apart. May be null.
    const float* vertex_normals;
    const float* corner_normals;
};

/// What a channel is.
enum {
    LAPLACIAN_SIMPLIFY_TEXTURE = 0, ///< a texture coordinate; always two in a row, u and v
    LAPLACIAN_SIMPLIFY_COLOR = 1,   ///< a part of a color, 0..1
    LAPLACIAN_SIMPLIFY_SCALAR = 2   ///< anything else, in its own unit
};

/// What guides the collapse; the numbers are those of the filter's parameter "descriptor". Mean and Gaussian
/// curvature (2 and 3) are computed by VCG and are refused here.
enum {
    LAPLACIAN_SIMPLIFY_LAPLACIAN = 0,
    LAPLACIAN_SIMPLIFY_NORMALIZED_UMBRELLA = 1,
    LAPLACIAN_SIMPLIFY_CURVATURE_ESTIMATION = 4,
    LAPLACIAN_SIMPLIFY_STORED_QUALITY = 5
};

/// What is asked for; every field is set by the caller. Choices have the numbers of the filter's.
struct laplacian_simplify_parameters {
    std::uint64_t target_faces; ///< of the whole mesh, at least 1
    double max_error;           ///< percent of the bounding box's diagonal, [0, 100]; 0: no bound
    double feature_weight;      ///< [0, 50]
    std::int32_t effort;        ///< 0 fast, 1 balanced, 2 best
    std::int32_t descriptor;
    std::int32_t boundary;   ///< 0 free, 1 preserve, 2 lock
    double attribute_weight; ///< [0, 100]; 0: attributes are transferred and guide nothing
    std::int32_t seams;      ///< 0 keep, 1 ignore
    std::int32_t preserve_topology;
    std::int32_t avoid_self_intersections; ///< 1: no more faces cross than before
    std::int32_t clean_input; ///< 1: weld open borders, drop degenerate and duplicate faces, loose vertices
    double weld_distance;     ///< percent of the bounding box's diagonal, [0, 100]; 0: equal coordinates
    std::int32_t measure_error;
    std::int32_t threads;    ///< 0: all; the result does not depend on it
    double cost_limit;       ///< no collapse costs more, in the mesh's unit of length^4; 0: no limit
    double descriptor_scale; ///< that of another result, for meshes that are parts of one; 0: the mesh's own
    /// Called on the calling thread with 0..100 and what is being done; 0 stops the run. May be null.
    std::int32_t (*progress)(std::int32_t percent, const char* stage);
};

/// How far one sweep of the collapse went.
struct laplacian_simplify_step {
    double cost;         ///< what a collapse cost at most, in the unit of cost_limit
    std::uint64_t faces; ///< that were left
};

/// How far points are from where the original has their texture coordinates, percent of the bounding box's
/// diagonal.
struct laplacian_simplify_texture {
    double rms;
    double largest;
};

/// The outcome. The arrays belong to \c storage: laplacian_simplify_release frees them.
struct laplacian_simplify_result {
    std::uint64_t vertex_count; ///< vertices of no face stay where they are, without clean_input
    std::uint64_t face_count;
    const double* positions;
    const std::uint32_t* faces;
    const std::uint32_t* vertex_origin; ///< the input vertex that each vertex was, ascending
    const std::uint32_t* face_origin;   ///< the input face that each face was, ascending
    std::int32_t target_reached;
    /// 0 target, 1 error bound, 2 no legal collapse, 3 canceled: there are no arrays, 4 seams
    std::int32_t stop_reason;
    std::uint64_t non_manifold_edges;
    std::uint64_t boundary_edges;
    std::int32_t has_distances; ///< 0: the four below were not measured
    double hausdorff;           ///< percent of the bounding box's diagonal, as the next two
    double rms;
    double feature_rms;
    std::uint64_t folded;
    std::int32_t has_self_intersections;        ///< 0: they were not to be avoided
    std::uint64_t self_intersections;           ///< pairs of faces that cross
    std::int32_t has_self_intersections_before; ///< 0: they were not counted, as no more of the result cross
    std::uint64_t self_intersections_before;
    std::int32_t has_cleaning; ///< 0: the input was taken as it is
    std::uint64_t welded_vertices;
    std::uint64_t dropped_faces;
    std::int32_t has_certificate; ///< 0: there was no bound, or it could not be proven
    double certified_error;       ///< percent of the bounding box's diagonal
    /// As those of the mesh. Null where it had none, and where nothing was simplified: then they are what
    /// face_origin had.
    const float* corner_values;
    /// One a corner: those of a vertex with different ones are on different sides of a hard edge. Null: there
    /// is no hard edge.
    const std::uint32_t* corner_sides;
    std::int32_t has_attributes; ///< 0: there were none, or nothing was simplified
    std::uint64_t charts;        ///< of the original
    std::uint64_t turned_faces;  ///< whose texture has turned over against what most of their chart has
    std::uint64_t held_faces;    ///< more than the target, because seams allow no further collapse
    std::uint64_t rms_count;     ///< 0: not measured
    const double* attribute_rms; ///< of every channel, in its own unit
    std::uint64_t texture_count; ///< pairs of texture coordinates; 0: not measured
    const laplacian_simplify_texture* textures;
    double seconds;
    std::uint64_t step_count; ///< 0 where nothing had to be done
    const laplacian_simplify_step* steps;
    double descriptor_scale; ///< 1 / the descriptor that counted as 1
    void* storage;
    char message[512]; ///< why the call failed, in UTF-8
};

/// What laplacian_simplify_arrays returns.
enum {
    LAPLACIAN_SIMPLIFY_DONE = 0,    ///< also where the target was not reached or the run was canceled
    LAPLACIAN_SIMPLIFY_REFUSED = 1, ///< mesh or parameters cannot be used; the message says why
    LAPLACIAN_SIMPLIFY_NO_MEMORY = 2,
    LAPLACIAN_SIMPLIFY_FAILED = 3
};

/// Simplifies a mesh as the filter does: where it has no more faces than the target it comes back as it is.
/// \param result overwritten; to be released whatever is returned
__attribute__((visibility("default"))) std::int32_t
laplacian_simplify_arrays(const laplacian_simplify_mesh* mesh,
                          const laplacian_simplify_parameters* parameters, laplacian_simplify_result* result);

/// Frees the arrays of a result.
__attribute__((visibility("default"))) void laplacian_simplify_release(laplacian_simplify_result* result);

} // extern "C"
