// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A program with a VCG mesh of its own type: makes a sphere of 20,480 faces and simplifies it to 1,000.
// With CMake, link laplacian_simplify::vcg_ext and put vcglib on the include path.

#include <exception>
#include <iostream>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/create/platonic.h>

#include "vcg_ext/decimate.h"

namespace
{

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {
};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::BitFlags>
{
};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::FFAdj, vcg::face::BitFlags>
{
};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>>
{
};

void Simplify()
{
    Mesh mesh;
    vcg::tri::Sphere(mesh, 5);

    vcg_ext::MeshDecimationParameters parameters;
    parameters.targetFaces = 1000;
    const vcg_ext::MeshSimplification result = vcg_ext::Decimate(mesh, parameters); // reads the mesh
    vcg_ext::ApplyDecimation(mesh, result);                                         // changes it

    std::cout << result.report.facesBefore << " faces became " << mesh.FN() << '\n';
}

} // namespace

int main()
{
    try {
        Simplify();
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
