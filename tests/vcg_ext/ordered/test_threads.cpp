// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <array>
#include <cstdint>
#include <functional>
#include <future>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/curvature.h"
#include "vcg_ext/decimate.h"

using namespace vcg_ext;
using namespace test_meshes;

namespace
{

struct Result {
    std::vector<std::array<double, 3>> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> vertexOrigin, faceOrigin;

    explicit Result(const DecimatedMesh& mesh)
        : positions(mesh.positions), triangles(mesh.triangles), vertexOrigin(mesh.vertexOrigin),
          faceOrigin(mesh.faceOrigin)
    {
    }
    bool operator==(const Result& other) const
    {
        return positions == other.positions && triangles == other.triangles &&
               vertexOrigin == other.vertexOrigin && faceOrigin == other.faceOrigin;
    }
};

Result Ordered(const IndexedMesh& mesh)
{
    DecimationParameters parameters;
    parameters.targetFaces = mesh.triangles.size() / 5;
    parameters.order = Order::Strict;
    parameters.threads = 1; // the threads are those of the test
    return Result(Decimate(View(mesh), parameters).mesh);
}

Result Weighted(const IndexedMesh& mesh)
{
    WeightedParameters parameters;
    parameters.targetFaces = mesh.triangles.size() / 5;
    const auto curvatures = ComputeDiscreteCurvatures(View(mesh));
    parameters.quadricWeights = AbsoluteCurvature(curvatures.mean, curvatures.gaussian);
    return Result(SimplifyWeighted(View(mesh), parameters).mesh);
}

} // namespace

class TestThreads : public QObject
{
    Q_OBJECT

  private slots:
    /// VCG keeps statistics, marks and scratch in statics of its functions. What several runs shared would
    /// show in their results now and then, and under ThreadSanitizer always.
    void runsAtTheSameTimeGiveTheSameBytesAsOneAfterTheOther()
    {
        const std::vector<IndexedMesh> meshes{Noisy(Icosphere(3), .02), Noisy(Torus(40, 20), .02)};
        std::vector<std::function<Result()>> runs;
        for (const IndexedMesh& mesh : meshes) {
            runs.emplace_back([&mesh] { return Ordered(mesh); });
            runs.emplace_back([&mesh] { return Weighted(mesh); });
        }
        std::vector<Result> expected;
        expected.reserve(runs.size());
        for (const auto& run : runs) expected.push_back(run());
        constexpr int kTimes = 4;
        for (int round = 0; round < kTimes; ++round) {
            std::vector<std::future<Result>> running;
            running.reserve(runs.size());
            for (const auto& run : runs) running.push_back(std::async(std::launch::async, run));
            for (std::size_t i = 0; i < runs.size(); ++i) QVERIFY(running[i].get() == expected[i]);
        }
    }
};

QTEST_APPLESS_MAIN(TestThreads)
#include "test_threads.moc"
