// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh_bytes.h"

namespace hostile
{

/// A result as plain arrays.
struct Produced {
    const double* positions;
    const std::uint32_t* vertexOrigin;
    std::size_t vertexCount;
    const std::uint32_t* faces;
    const std::uint32_t* faceOrigin;
    std::size_t faceCount;
};

/// Whether a coordinate is none that the library takes: not finite, or larger than 1e18.
bool HasTooLarge(const std::vector<double>& numbers);

/// As a float: infinite beyond its range, which is not defined for a plain conversion.
float Narrowed(double number);

/// What is wrong with the result as a mesh, against what it was made of; empty where nothing is.
std::string FaultOfAMesh(const Case& given, const Produced& result);

/// What of the report does not go with the result.
std::string FaultOfAReport(const Case& given, const laplacian_simplify_result& result);

} // namespace hostile
