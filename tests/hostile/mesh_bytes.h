// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "python/library/simplify_arrays.h"

/// Any bytes as a mesh with parameters, so that a fuzzer can make meshes; tests/hostile/mesh_bytes.py writes
/// them.
namespace hostile
{

/// A mesh in arrays of its own, what is asked for, and how it is asked.
struct Case {
    std::vector<double> positions; ///< three a vertex
    std::vector<std::uint32_t> faces;
    std::vector<std::uint8_t> fixed;    ///< empty: none
    std::vector<std::uint8_t> selected; ///< empty: all
    std::vector<double> quality;        ///< empty: none
    std::vector<float> corners;         ///< channelKinds.size() numbers a corner
    std::vector<std::int32_t> channelKinds;
    std::vector<std::int32_t> labels; ///< empty: none
    laplacian_simplify_parameters parameters{};
    bool singlePrecision = false; ///< positions are handed over as floats
    bool longIndices = false;     ///< and indices with 64 bits
    bool forEveryThreads = false; ///< run with other numbers of threads as well
    std::size_t levelCount = 0;   ///< by the C++ core, as so many levels of detail; 0: by the C function

    std::size_t VertexCount() const { return positions.size() / 3; }
    std::size_t FaceCount() const { return faces.size() / 3; }
};

/// What the bytes mean; every sequence of them is a case, and what is missing at its end is 0. The layout is
/// in the function.
Case CaseOf(const std::uint8_t* bytes, std::size_t size);

} // namespace hostile
