// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace laplacian_simplify
{

/// The filters; the value is the place of the row in Filters() and the id that the host knows.
enum class FilterId {
    ShapeDescriptor,
    FeatureSelection,
    GuidedDecimation,
    WeightedDecimation,
    UmbrellaSmooth
};

/// The kinds of data of a mesh that a filter can change; or-ed together.
enum MeshData : std::uint32_t {
    kVertexPosition = 1,
    kVertexNormal = 2,
    kFaceNormal = 4,
    kVertexQuality = 8,
    kVertexColor = 16,
    kVertexSelection = 32,
    kFaceSelection = 64,
    kGeometryAndTopology = 128 ///< elements go: a host cannot offer a live preview
};

/// Where a host's menus list a filter.
enum class Category { Selection, Remeshing, Smoothing, Quality, VertexColoring };

/// What everybody is told about a filter. All of them work on the current mesh.
struct Filter {
    FilterId id;
    const char* key;        ///< short name in snake_case, for commands and keys of our own
    const char* name;       ///< in menus and .mlx scripts; never changes after a release
    const char* pythonName; ///< in pymeshlab; never changes after a release
    const char* summary;    ///< one sentence
    const char* help;       ///< the rest, in the host's simple HTML
    const char* references; ///< literature, in the host's simple HTML
    std::vector<Category> categories;
    std::uint32_t changes; ///< of MeshData: what may differ afterwards
};

/// The table of filters, in the order of FilterId.
const std::vector<Filter>& Filters();

/// The row of \p id.
const Filter& Row(FilterId id);

/// What a host shows above the parameters: summary, help and references.
std::string Description(const Filter& filter);

} // namespace laplacian_simplify
