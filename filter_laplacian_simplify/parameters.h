// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "filters.h"

namespace laplacian_simplify
{

enum class ParameterType {
    Boolean,
    Integer,
    Real,
    Choice,
    Numbers ///< a text: numbers in the range, separated by commas
};

/// What the default of a parameter may depend on. All 0 while there is no mesh.
struct MeshFacts {
    std::size_t faces = 0;
    std::size_t selectedFaces = 0;
};

/// One value of a parameter that is a choice; its number is its index in the list.
struct Option {
    std::string id;   ///< snake_case, for the command line
    std::string text; ///< for dialogs
};

/// The values that a number may take; the maximum is included.
struct Range {
    double minimum;
    double maximum;
    bool minimumIncluded = true;
};

/// The value that a dialog starts with and that is used where none is given.
struct DefaultValue {
    double value;                                 ///< used if onMesh is null
    double (*onMesh)(const MeshFacts&) = nullptr; ///< computes the default from the mesh
    const char* description = "";                 ///< what onMesh computes
    const char* numbers = "";                     ///< of Numbers, in place of the value
};

/// How dialogs show a parameter; combined by bitwise or.
enum Shown : unsigned {
    kPlainly = 0,
    kAdvanced = 1, ///< rarely used: behind a button where the host has one
    kSlider = 2    ///< a number that is dragged over the whole range
};

/// Everything that hosts, commands and pages show of a parameter of some filters.
struct Parameter {
    const char* id; ///< snake_case, the same in dialogs, scripts, Python and commands; never changes
    std::vector<FilterId> filters;
    ParameterType type;
    DefaultValue defaultValue;
    Range range;
    const char* unit; ///< "" where there is none
    const char* label;
    const char* help;
    std::vector<Option> options; ///< of a choice, otherwise empty
    unsigned shown = kPlainly;   ///< of Shown

    /// The default on a mesh; always in the range.
    double Default(const MeshFacts& facts) const
    {
        return defaultValue.onMesh ? defaultValue.onMesh(facts) : defaultValue.value;
    }
};

/// The default on a mesh.
/// \param facts called only if the default depends on the mesh, because it visits every face
template <class Facts>
double DefaultOf(const Parameter& parameter, const Facts& facts)
{
    return parameter.Default(parameter.defaultValue.onMesh ? facts() : MeshFacts{});
}

/// The table of parameters, in the order of the dialogs: what is rarely used comes last. No filter has two of
/// the same id.
const std::vector<Parameter>& Parameters();

/// The rows of one filter.
std::vector<const Parameter*> ParametersOf(FilterId filter);

/// The allowed values: "[0, 50]", "(0, 1]", "[0, 100] (percent of the faces)", "fast (0), balanced (1), best
/// (2)", "true or false"; of Numbers those of each number.
std::string RangeText(const Parameter& parameter);

} // namespace laplacian_simplify
