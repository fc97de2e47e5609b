// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplification in a program that has its own arrays, without MeshLab and without vcglib:
//
//     simplify_arrays FACES [OUTPUT.off]
//
// makes a relief of 180,000 triangles, simplifies it to FACES and writes the result as OFF.
// With CMake, link laplacian_simplify::core. Without:
// c++ -std=c++17 -O3 -fopenmp -ffp-contract=off -fno-math-errno -I <top of the project> simplify_arrays.cpp

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/core/simplify.h"

namespace
{

struct Mesh {
    std::vector<std::array<float, 3>> points;
    std::vector<std::uint32_t> triangles; // three indices of points each
};

/// Two waves across a square of side x side points.
Mesh MakeRelief(std::uint32_t side)
{
    Mesh mesh;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const float x = static_cast<float>(i) / 20, y = static_cast<float>(j) / 20;
            mesh.points.push_back({x, y, std::sin(x) + std::fabs(std::sin(0.4F * (x + y)))});
        }
    for (std::uint32_t j = 0; j + 1 < side; ++j)
        for (std::uint32_t i = 0; i + 1 < side; ++i) {
            const std::uint32_t v = j * side + i;
            for (const std::uint32_t corner : {v, v + 1, v + side + 1, v, v + side + 1, v + side})
                mesh.triangles.push_back(corner);
        }
    return mesh;
}

vcg_ext::MeshView ViewOf(const Mesh& mesh)
{
    vcg_ext::MeshView view; // reads the program's own arrays in place
    view.positions = mesh.points.data();
    view.positionStride = sizeof mesh.points[0];
    view.vertexCount = mesh.points.size();
    view.triangles = mesh.triangles.data();
    view.faceCount = mesh.triangles.size() / 3;
    return view;
}

void WriteOff(const vcg_ext::DecimatedMesh& mesh, const std::string& path)
{
    std::ofstream file(path);
    file.precision(std::numeric_limits<double>::max_digits10);
    file << "OFF\n" << mesh.positions.size() << ' ' << mesh.triangles.size() << " 0\n";
    for (const auto& p : mesh.positions) file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& t : mesh.triangles) file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

int Simplify(int argc, char** argv)
{
    if (argc < 2 || std::atol(argv[1]) < 1) {
        std::cerr << "usage: simplify_arrays FACES [OUTPUT.off], FACES at least 1\n";
        return 2;
    }
    const Mesh mesh = MakeRelief(301);

    vcg_ext::DecimationParameters parameters;
    parameters.targetFaces = static_cast<std::size_t>(std::atol(argv[1]));
    parameters.effort = vcg_ext::Effort::Fast; // Balanced also refines what is left
    parameters.measureError = false;           // otherwise the report has the distances
    const vcg_ext::Simplification result = vcg_ext::Simplify(ViewOf(mesh), parameters);

    std::cout << result.report.facesBefore << " faces became " << result.report.faces << '\n';
    if (result.report.stopReason == vcg_ext::StopReason::NoLegalCollapse)
        std::cout << "no further collapse is possible without damage\n";
    if (argc > 2) WriteOff(result.mesh, argv[2]);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return Simplify(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
