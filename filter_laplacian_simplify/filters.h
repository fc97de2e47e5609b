// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace laplacian_simplify
{

/// The filters. The value is the index of the row in Filters() and the id that the host uses.
enum class FilterId {
    ShapeDescriptor,
    FeatureSelection,
    GuidedDecimation,
    WeightedDecimation,
    LevelsOfDetail,
    UmbrellaSmooth
};

/// The kinds of mesh data that a filter can change; combined by bitwise or.
enum MeshData : std::uint32_t {
    kVertexPosition = 1,
    kVertexNormal = 2,
    kFaceNormal = 4,
    kVertexQuality = 8,
    kVertexColor = 16,
    kVertexSelection = 32,
    kFaceSelection = 64,
    kGeometryAndTopology = 128 ///< elements are removed, so a host cannot offer a live preview
};

/// The menu of the host that lists a filter.
enum class Category { Selection, Remeshing, Smoothing, Quality, VertexColoring };

/// Everything that hosts, commands and pages show of a filter. Every filter works on the current mesh.
struct Filter {
    FilterId id;
    const char* key;        ///< short name in snake_case, for the command line and for tests
    const char* name;       ///< in menus and .mlx scripts; never changes after a release
    const char* pythonName; ///< in pymeshlab; never changes after a release
    const char* summary;    ///< one sentence
    const char* note; ///< what else its dialog says: a line, or nothing, as it must fit on small screens
    const char* help; ///< the rest, for pages, in simple HTML
    std::vector<const char*> references; ///< literature, each entry in simple HTML
    std::vector<Category> categories;
    std::uint32_t changes; ///< MeshData that may differ afterward
};

/// The table of filters, in the order of FilterId.
const std::vector<Filter>& Filters();

/// The row of \p id.
const Filter& Row(FilterId id);

/// The literature as one text in simple HTML.
std::string References(const Filter& filter);

/// What a host shows above the parameters and searches for words: summary and note, in lines that do not
/// break, as hosts leave space for shorter lines than there are then.
std::string Description(const Filter& filter);

} // namespace laplacian_simplify
