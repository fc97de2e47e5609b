// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Processor time of the descriptors per face, on plain arrays and on VCG meshes, beside VCG's mean curvature
// with the adjacency that it needs, all in turns in one run: descriptor_benchmark [MESH.ply] [ROUNDS]
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/test_meshes.h"
#include "vcg_ext/descriptors.h"

using namespace vcg_ext;

namespace
{

double ProcessorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Case {
    const char* name;
    std::function<void()> run;
    std::vector<double> seconds;
};

/// A noisy torus, whose vertices have the order of a grid.
test_meshes::IndexedMesh Torus()
{
    return test_meshes::Noisy(test_meshes::Torus(1000, 500), 1e-4);
}

template <class Value>
Value Next(std::istream& file)
{
    Value value{};
    file.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
}

/// Reads what the benchmark writes: binary PLY, little endian, x y z as float, faces as uchar and three ints.
/// \throws std::runtime_error where the file ends early or has other properties
test_meshes::IndexedMesh ReadPly(const char* path)
{
    std::ifstream file(path, std::ios::binary);
    std::size_t vertices = 0, faces = 0, properties = 0;
    for (std::string line; std::getline(file, line) && line.rfind("end_header", 0) != 0;) {
        if (line.rfind("element vertex ", 0) == 0) vertices = std::stoull(line.substr(15));
        if (line.rfind("element face ", 0) == 0) faces = std::stoull(line.substr(13));
        properties += line.rfind("property ", 0) == 0;
    }
    test_meshes::IndexedMesh mesh;
    for (std::size_t v = 0; v < vertices && file; ++v) {
        const float x = Next<float>(file), y = Next<float>(file), z = Next<float>(file);
        mesh.points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    }
    bool triangles = true;
    for (std::size_t f = 0; f < faces && file; ++f) {
        triangles = triangles && Next<std::uint8_t>(file) == 3;
        const std::uint32_t a = Next<std::uint32_t>(file), b = Next<std::uint32_t>(file);
        mesh.AddTriangle(a, b, Next<std::uint32_t>(file));
    }
    if (!file || properties != 4 || !triangles || faces == 0)
        throw std::runtime_error(std::string(path) + " is not a PLY file of the benchmark");
    return mesh;
}

/// Times a loop over cases, so that a busy moment meets all of them.
void RunInTurns(std::vector<Case>& cases, int rounds)
{
    for (int round = 0; round < rounds; ++round)
        for (Case& one : cases) {
            const double start = ProcessorSeconds();
            one.run();
            one.seconds.push_back(ProcessorSeconds() - start);
        }
}

double Median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double Least(const std::vector<double>& values)
{
    return *std::min_element(values.begin(), values.end());
}

/// Round by round, so that a busy stretch of the machine meets both.
std::vector<double> Ratios(const std::vector<double>& values, const std::vector<double>& others)
{
    std::vector<double> ratios(values.size());
    std::transform(values.begin(), values.end(), others.begin(), ratios.begin(), std::divides<>());
    return ratios;
}

} // namespace

int main(int count, char** arguments)
try {
    const int rounds = count > 2 ? std::max(1, std::atoi(arguments[2])) : 9;
    const test_meshes::IndexedMesh source = count > 1 ? ReadPly(arguments[1]) : Torus();
    test_meshes::FloatMesh single;
    test_meshes::DoubleMesh twice;
    Fill(single, source);
    Fill(twice, source);
    std::vector<float> positions;
    for (const auto& p : source.points)
        for (const double x : p) positions.push_back(static_cast<float>(x));
    MeshView view = test_meshes::View(source);
    view.positions = positions.data();
    view.positionStride = 3 * sizeof(float);
    view.doublePositions = false;

    std::vector<Case> cases{
        {"VCG mean curvature, double mesh",
         [&] { ComputeDiscreteCurvatures(test_meshes::View(source)); },
         {}},
        {"Laplacian, float arrays", [&] { LaplacianDescriptor(view); }, {}},
        {"Laplacian, double arrays", [&] { LaplacianDescriptor(test_meshes::View(source)); }, {}},
        {"Laplacian, float VCG mesh", [&] { ComputeDescriptor(single, Descriptor::Laplacian); }, {}},
        {"Laplacian, double VCG mesh", [&] { ComputeDescriptor(twice, Descriptor::Laplacian); }, {}},
        {"normalised umbrella, float arrays",
         [&] { ComputeDescriptor(view, Descriptor::NormalizedUmbrella); },
         {}},
        {"curvature estimation, float arrays",
         [&] { ComputeDescriptor(view, Descriptor::CurvatureEstimation); },
         {}},
    };
    RunInTurns(cases, rounds);
    std::printf("%zu faces, %d rounds: nanoseconds a face (median, least), VCG's mean curvature over it "
                "(median of the rounds, least over least)\n",
                source.triangles.size(), rounds);
    const double perFace = 1e9 / static_cast<double>(source.triangles.size());
    const std::vector<double>& reference = cases.front().seconds;
    for (const Case& one : cases)
        std::printf("%-36s %8.1f %8.1f %8.1f x %8.1f x\n", one.name, Median(one.seconds) * perFace,
                    Least(one.seconds) * perFace, Median(Ratios(reference, one.seconds)),
                    Least(reference) / Least(one.seconds));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "descriptor_benchmark: %s\n", error.what());
    return 1;
}
