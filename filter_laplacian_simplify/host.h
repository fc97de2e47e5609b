// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A filter function is a template on the program that it runs in. Such a Host is made for one run and offers:
//
//   using MeshType                 a VCG triangle mesh with vertex quality and color
//   MeshType& Mesh()               the current mesh
//   void Require(data)             makes sure that the mesh has the MeshData that is about to be written
//   void ContinueOnCopy(suffix)    makes a new layer with a copy of the original the current mesh; its name
//                                  is the original's and the suffix, and the layer that was shown is hidden
//   void ReturnToOriginal()        makes the mesh at the start the current one again
//   void GeometryChanged()         updates box and normals, of length 1; to be called after positions or
//                                  faces changed
//   void Log(line)                 shows a line of fewer than 4096 characters to the user
//   bool Progress(percent, stage)  false asks to stop; main thread only
//
// A filter function first checks, then computes, and only then changes the mesh. What it throws is a
// std::exception whose text is a sentence for the user; the mesh is then unchanged.

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <vcg/complex/complex.h>

#include "number_text.h"
#include "parameters.h"

namespace laplacian_simplify
{

/// Coordinates beyond this overflow when a host squares them in single precision.
constexpr double kMaxCoordinate = 1e18;

/// What the defaults of parameters depend on.
template <class Mesh>
MeshFacts FactsOf(const Mesh& mesh)
{
    MeshFacts facts;
    for (const auto& face : mesh.face) {
        if (face.IsD()) continue;
        ++facts.faces;
        if (face.IsS()) ++facts.selectedFaces;
    }
    return facts;
}

/// \throws std::invalid_argument if no filter can work on the mesh; it says why, with the count
template <class Mesh>
void RequireUsable(const Mesh& mesh)
{
    const std::string vertices = CountText(static_cast<std::size_t>(mesh.vn));
    if (mesh.fn == 0) throw std::invalid_argument("the mesh has no faces (" + vertices + " vertices)");
    std::size_t bad = 0;
    for (const auto& v : mesh.vert) {
        if (v.IsD()) continue;
        const auto usable = [](auto x) { return std::abs(static_cast<double>(x)) <= kMaxCoordinate; };
        bad += !(usable(v.cP()[0]) && usable(v.cP()[1]) && usable(v.cP()[2])); // NaN is not <= either
    }
    if (bad > 0)
        throw std::invalid_argument("the mesh is unusable: the coordinates of " + CountText(bad) + " of " +
                                    vertices + " vertices are not finite or larger than 1e18");
}

/// One flag for each element of mesh.vert: the vertices that a filter on vertices may change. With \p
/// selectedOnly these are the vertices of selected faces or, if no face is selected, the selected vertices.
/// \throws std::invalid_argument if there are none
template <class Mesh>
std::vector<bool> VerticesInScope(const Mesh& mesh, bool selectedOnly)
{
    if (!selectedOnly && mesh.vert.size() == static_cast<std::size_t>(mesh.vn))
        return std::vector<bool>(mesh.vert.size(), true);
    std::vector<bool> inScope(mesh.vert.size());
    bool any = false;
    if (selectedOnly) {
        for (const auto& face : mesh.face) {
            if (face.IsD() || !face.IsS()) continue;
            any = true;
            for (int k = 0; k < 3; ++k) inScope[vcg::tri::Index(mesh, face.cV(k))] = true;
        }
        if (any) return inScope;
    }
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        inScope[v] = !mesh.vert[v].IsD() && (!selectedOnly || mesh.vert[v].IsS());
        any = any || inScope[v];
    }
    if (!any) throw std::invalid_argument("selected_only = true, but no face or vertex is selected");
    return inScope;
}

} // namespace laplacian_simplify
