// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What parameters cost, as ratios to the same run without them, and how the engine scales with threads, on
// plain arrays and a generated mesh: parameter_costs [ROUNDS [AROUND ALONG [ONLY]]], where ONLY is part of
// the cases' names Build: g++ -std=c++17 -O2 -fopenmp -ffp-contract=off -fno-math-errno -I. -Itests/support
// FILE
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/simplify.h"

using namespace vcg_ext;

namespace
{

struct Times {
    double wall = 0, processor = 0; ///< seconds
};

struct Case {
    std::string name;
    DecimationParameters parameters;
    bool textured = false;
    std::size_t baseline = 0; ///< the case that it is compared with
    std::vector<Times> times;
    std::size_t faces = 0;
};

/// A noisy torus whose texture has eight by four charts, each in its own cell.
struct TexturedTorus {
    static constexpr int kChartsAround = 8, kChartsAlong = 4;
    test_meshes::IndexedMesh mesh;
    std::vector<float> uv;
    std::vector<std::int32_t> charts;
    CornerAttributes attributes;

    TexturedTorus(int around, int along)
        : mesh(test_meshes::Noisy(test_meshes::Torus(around, along), 0.1 / around))
    {
        for (const auto& t : mesh.triangles) {
            double u = Turn(t, &TexturedTorus::Around), v = Turn(t, &TexturedTorus::Along);
            const int chart =
                static_cast<int>(u * kChartsAround) * kChartsAlong + static_cast<int>(v * kChartsAlong);
            charts.push_back(chart);
            for (const std::uint32_t corner : t) {
                uv.push_back(static_cast<float>(Near(Around(mesh.points[corner]), u)));
                uv.push_back(static_cast<float>(Near(Along(mesh.points[corner]), v)));
            }
        }
        attributes.kinds = {ChannelKind::Texture, ChannelKind::Texture};
        attributes.values = uv.data();
        attributes.labels = charts.data();
    }

    MeshView View(bool textured) const
    {
        MeshView view = test_meshes::View(mesh);
        if (textured) view.attributes = &attributes;
        return view;
    }

  private:
    using Angle = double (*)(const test_meshes::Point&);

    static double Around(const test_meshes::Point& p) { return Fraction(std::atan2(p[1], p[0])); }
    static double Along(const test_meshes::Point& p)
    {
        return Fraction(std::atan2(p[2], std::hypot(p[0], p[1]) - 1));
    }
    static double Fraction(double angle)
    {
        const double turn = angle / (2 * 3.14159265358979323846);
        return std::min(turn - std::floor(turn), 1 - 1e-9);
    }
    /// The one of x + k that is nearest to \p to.
    static double Near(double x, double to) { return x + std::round(to - x); }
    double Turn(const test_meshes::Triangle& t, Angle angle) const
    {
        const double first = angle(mesh.points[t[0]]);
        const double mean =
            (first + Near(angle(mesh.points[t[1]]), first) + Near(angle(mesh.points[t[2]]), first)) / 3;
        return std::min(mean - std::floor(mean), 1 - 1e-9);
    }
};

double ProcessorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void Run(const TexturedTorus& torus, Case& test)
{
    using Clock = std::chrono::steady_clock;
    const auto wall = Clock::now();
    const double processor = ProcessorSeconds();
    const Simplification result = Simplify(torus.View(test.textured), test.parameters);
    Times times;
    times.wall = std::chrono::duration<double>(Clock::now() - wall).count();
    times.processor = ProcessorSeconds() - processor;
    test.times.push_back(times);
    test.faces = result.report.faces;
}

double Median(std::vector<Times> times, double Times::*value)
{
    std::sort(times.begin(), times.end(),
              [&](const Times& a, const Times& b) { return a.*value < b.*value; });
    return times[times.size() / 2].*value;
}

const char* NameOf(Effort effort)
{
    return effort == Effort::Fast ? "fast" : effort == Effort::Balanced ? "balanced" : "best";
}

/// Every parameter by itself, with one thread, against the run with none of them.
void AddParameters(std::size_t faces, double percent, Effort effort, std::vector<Case>& cases)
{
    DecimationParameters plain;
    plain.targetFaces = static_cast<std::size_t>(percent / 100 * static_cast<double>(faces));
    plain.effort = effort;
    plain.measureError = plain.avoidSelfIntersections = plain.cleanInput = false;
    plain.threads = 1;
    const std::size_t baseline = cases.size();
    const std::string name =
        std::string(NameOf(effort)) + ", " + std::to_string(static_cast<int>(percent)) + " %";
    const auto add = [&](const char* what, const DecimationParameters& parameters, bool textured) {
        cases.push_back({name + ", " + what, parameters, textured, baseline, {}, 0});
    };
    add("plain", plain, false);
    DecimationParameters changed = plain;
    changed.measureError = true;
    add("measure_error", changed, false);
    changed = plain;
    changed.avoidSelfIntersections = true;
    add("avoid_self_intersections", changed, false);
    changed = plain;
    changed.cleanInput = true;
    add("clean_input", changed, false);
    add("texture", plain, true);
    if (effort == Effort::Best) return;
    changed = plain;
    changed.maxError = percent > 5 ? 0.03 : 0.1;
    add("max_error", changed, false);
}

/// The defaults of the filter, by the number of threads.
void AddThreads(std::size_t faces, Effort effort, std::vector<Case>& cases)
{
    const std::size_t baseline = cases.size();
    const int most = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
    for (int threads = 1; threads <= most; threads *= 2) {
        DecimationParameters parameters;
        parameters.targetFaces = faces / 10;
        parameters.effort = effort;
        parameters.threads = threads;
        const std::string name =
            std::string(NameOf(effort)) + ", 10 %, " + std::to_string(threads) + " threads";
        cases.push_back({name, parameters, false, baseline, {}, 0});
    }
}

void Print(const std::vector<Case>& cases)
{
    std::printf("%-44s %9s %9s %9s %9s %9s\n", "", "wall s", "CPU s", "wall", "CPU", "faces");
    for (const Case& test : cases) {
        if (test.times.empty()) continue;
        const Case& base = cases[test.baseline].times.empty() ? test : cases[test.baseline];
        const double wall = Median(test.times, &Times::wall),
                     processor = Median(test.times, &Times::processor);
        std::printf("%-44s %9.3f %9.3f %8.2fx %8.2fx %9zu\n", test.name.c_str(), wall, processor,
                    wall / Median(base.times, &Times::wall),
                    processor / Median(base.times, &Times::processor), test.faces);
    }
}

} // namespace

int main(int count, char** words)
try {
    const int rounds = count > 1 ? std::stoi(words[1]) : 3;
    const int around = count > 3 ? std::stoi(words[2]) : 1000, along = count > 3 ? std::stoi(words[3]) : 500;
    const TexturedTorus torus(around, along);
    std::vector<Case> cases;
    for (const double percent : {50.0, 2.0})
        for (const Effort effort : {Effort::Fast, Effort::Balanced})
            AddParameters(torus.mesh.triangles.size(), percent, effort, cases);
    for (const Effort effort : {Effort::Fast, Effort::Balanced, Effort::Best})
        AddThreads(torus.mesh.triangles.size(), effort, cases);
    const std::string only = count > 4 ? words[4] : "";
    std::printf("torus of %zu faces, medians of %d rounds in turns, %u processors\n",
                torus.mesh.triangles.size(), rounds, std::thread::hardware_concurrency());
    for (int round = 0; round < rounds; ++round)
        for (Case& test : cases)
            if (test.name.find(only) != std::string::npos) Run(torus, test);
    Print(cases);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "parameter_costs: %s\n", error.what());
    return 1;
}
