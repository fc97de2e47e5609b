// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Processor time of the descriptors per face, on plain arrays and on VCG meshes, beside VCG's mean curvature
// with the adjacency that it needs, all in turns in one run: descriptor_benchmark [FACES] [ROUNDS]
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "test_meshes.h"
#include "vcg_ext/descriptor.h"

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

/// A noisy torus, whose vertices are in no special order beyond that of a grid.
test_meshes::IndexedMesh Torus(std::size_t faces)
{
    const int around = std::max(3, static_cast<int>(std::sqrt(static_cast<double>(faces))));
    return test_meshes::Noisy(test_meshes::Torus(around, std::max(3, around / 2)), 1e-4);
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

} // namespace

int main(int count, char** arguments)
{
    const std::size_t faces = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1000000;
    const int rounds = count > 2 ? std::max(1, std::atoi(arguments[2])) : 9;
    const test_meshes::IndexedMesh source = Torus(faces);
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
    std::printf("%zu faces, %d rounds: nanoseconds a face (median, least), VCG's median over the median\n",
                source.triangles.size(), rounds);
    const auto median = [](std::vector<double>& seconds) {
        std::sort(seconds.begin(), seconds.end());
        return seconds[seconds.size() / 2];
    };
    const double reference = median(cases.front().seconds);
    const double perFace = 1e9 / static_cast<double>(source.triangles.size());
    for (Case& one : cases) {
        const double middle = median(one.seconds);
        std::printf("%-36s %8.1f %8.1f %8.1f x\n", one.name, middle * perFace, one.seconds.front() * perFace,
                    reference / middle);
    }
    return 0;
}
