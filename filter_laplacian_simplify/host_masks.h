// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "filters.h"

namespace laplacian_simplify
{

/// MeshData as MeshLab's bits, which have the same names in every version.
/// \tparam Model MeshLab's MeshModel
template <class Model>
int HostMask(std::uint32_t data)
{
    static constexpr std::pair<std::uint32_t, int> kTable[] = {
        {kVertexPosition, Model::MM_VERTCOORD},
        {kVertexNormal, Model::MM_VERTNORMAL},
        {kFaceNormal, Model::MM_FACENORMAL},
        {kVertexQuality, Model::MM_VERTQUALITY},
        {kVertexColor, Model::MM_VERTCOLOR},
        {kVertexSelection, Model::MM_VERTFLAGSELECT},
        {kFaceSelection, Model::MM_FACEFLAGSELECT},
        {kGeometryAndTopology, Model::MM_GEOMETRY_AND_TOPOLOGY_CHANGE},
    };
    int mask = Model::MM_NONE;
    for (const auto& [bit, hostBits] : kTable)
        if (data & bit) mask |= hostBits;
    return mask;
}

/// The categories of a filter as MeshLab's bits.
/// \tparam Interface the class that MeshLab's filter plugins derive from
template <class Interface>
typename Interface::FilterClass HostClass(const Filter& filter)
{
    const auto bits = [](Category category) {
        switch (category) {
        case Category::Selection:
            return Interface::Selection;
        case Category::Remeshing:
            return Interface::Remeshing;
        case Category::Smoothing:
            return Interface::Smoothing;
        case Category::Quality:
            return Interface::Quality;
        case Category::VertexColoring:
            return Interface::VertexColoring;
        }
        return Interface::Generic;
    };
    int all = Interface::Generic;
    for (const Category category : filter.categories) all |= bits(category);
    return static_cast<typename Interface::FilterClass>(all);
}

} // namespace laplacian_simplify
