// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/descriptor/feature_classes.h"
#include "vcg_ext/core/descriptor/kmeans_1d.h"
#include "vcg_ext/core/descriptor/laplacian.h"

using namespace vcg_ext;
using test_meshes::View;

namespace
{

double SquaredDistances(const std::vector<double>& values, const Clusters& clusters)
{
    double sum = 0;
    for (const double x : values) {
        const double d = x - clusters.centers[clusters.ClassOf(x)];
        sum += d * d;
    }
    return sum;
}

/// The least sum of squares over every way to cut the sorted values, by trying all of them.
double BruteForce(const std::vector<double>& sorted, std::size_t begin, int classes)
{
    const auto cost = [&](std::size_t end) {
        double mean = 0, sum = 0;
        for (std::size_t i = begin; i < end; ++i) mean += sorted[i];
        mean /= static_cast<double>(end - begin);
        for (std::size_t i = begin; i < end; ++i) sum += (sorted[i] - mean) * (sorted[i] - mean);
        return sum;
    };
    if (classes == 1) return cost(sorted.size());
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t end = begin + 1; end + static_cast<std::size_t>(classes) - 1 <= sorted.size(); ++end)
        best = std::min(best, cost(end) + BruteForce(sorted, end, classes - 1));
    return best;
}

std::vector<double> RandomValues(unsigned seed, std::size_t count, int distinct)
{
    std::mt19937 random(seed);
    std::vector<double> values(count);
    for (double& x : values)
        x = static_cast<double>(static_cast<int>(random() % 1000003u) % distinct) / distinct;
    return values;
}

std::string RefusalOf(const std::function<void()>& call)
{
    try {
        call();
    } catch (const std::invalid_argument& refusal) {
        return refusal.what();
    }
    return "accepted";
}

/// A plane grid with one row of vertices lifted: a crease of known course, whose ends the descriptor sees
/// less.
test_meshes::IndexedMesh Roof(int length)
{
    auto mesh = test_meshes::Grid(length, 4);
    for (auto& p : mesh.points)
        if (p[1] == 2) p[2] = 1;
    return mesh;
}

std::size_t FeatureNeighbours(const OneRings& rings, const std::vector<std::uint8_t>& isFeature,
                              std::size_t v)
{
    std::vector<std::uint32_t> room;
    std::size_t count = 0;
    for (const std::uint32_t w : rings.Neighbours(v, room)) count += isFeature[w];
    return count;
}

} // namespace

class TestClassification : public QObject
{
    Q_OBJECT

  private slots:
    void clustersAreOptimal();
    void manyDistinctValuesAreOptimalWithinABin();
    void sizesThresholdsAndCentersAgree();
    void refusesByName();
    void creaseOfARoofIsTheFeature();
    void isolatedVerticesAreNoFeatures();
    void refinementOnlyAddsNeighboursOfLonelyFeatures();
    void refinementTakesTheBestNeighbourAndStopsAtTheFloor();
};

void TestClassification::clustersAreOptimal()
{
    for (unsigned seed = 1; seed <= 60; ++seed)
        for (int classes = 1; classes <= 4; ++classes) {
            auto values = RandomValues(seed, 4 + seed % 9, seed % 3 == 0 ? 5 : 1000);
            std::sort(values.begin(), values.end());
            const auto distinct = std::set<double>(values.begin(), values.end()).size();
            if (static_cast<std::size_t>(classes) > distinct) continue;
            const double best = BruteForce(values, 0, classes);
            const double ours = SquaredDistances(values, KMeans1D(values, classes));
            QVERIFY2(std::fabs(ours - best) <= 1e-12 * (1 + best),
                     qPrintable(
                         QString("seed %1, %2 classes: %3 > %4").arg(seed).arg(classes).arg(ours).arg(best)));
        }
}

void TestClassification::manyDistinctValuesAreOptimalWithinABin()
{
    // Three groups of very different size: Lloyd's iteration from even starts splits the large one.
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, .01);
    std::vector<double> values;
    values.reserve(20400);
    for (int i = 0; i < 20000; ++i) values.push_back(.1 + noise(random));
    for (int i = 0; i < 300; ++i) values.push_back(.7 + noise(random));
    for (int i = 0; i < 100; ++i) values.push_back(1 + noise(random));
    const Clusters clusters = KMeans1D(values, 3);
    QCOMPARE(clusters.sizes, (std::vector<std::size_t>{20000, 300, 100}));
    QVERIFY(std::fabs(clusters.centers[0] - .1) < .001);
    QVERIFY(std::fabs(clusters.centers[1] - .7) < .005);
    QVERIFY(std::fabs(clusters.centers[2] - 1) < .005);
}

void TestClassification::sizesThresholdsAndCentersAgree()
{
    for (const int distinct : {7, 100000}) {
        const auto values = RandomValues(3, 5000, distinct);
        const Clusters clusters = KMeans1D(values, 5);
        QCOMPARE(clusters.centers.size(), std::size_t(5));
        QCOMPARE(clusters.thresholds.size(), std::size_t(4));
        QVERIFY(std::is_sorted(clusters.centers.begin(), clusters.centers.end()));
        std::vector<std::size_t> sizes(5);
        std::vector<double> sums(5);
        for (const double x : values) {
            ++sizes[clusters.ClassOf(x)];
            sums[clusters.ClassOf(x)] += x;
        }
        QCOMPARE(sizes, clusters.sizes);
        for (std::size_t c = 0; c < 5; ++c)
            QVERIFY(std::fabs(sums[c] / static_cast<double>(sizes[c]) - clusters.centers[c]) < 1e-12);
    }
}

void TestClassification::refusesByName()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(RefusalOf([] {
                 KMeans1D({1, 1, 2}, 3);
             }),
             std::string("classes = 3 exceeds the number of distinct values, 2"));
    QCOMPARE(RefusalOf([] {
                 KMeans1D({1, 1, 1}, 2);
             }),
             std::string("classes = 2 exceeds the number of distinct values, 1"));
    QCOMPARE(RefusalOf([] { KMeans1D({}, 1); }),
             std::string("classes = 1 exceeds the number of distinct values, 0"));
    QCOMPARE(RefusalOf([] { KMeans1D({1, 2}, 0); }), std::string("classes = 0 is less than 1"));
    QCOMPARE(RefusalOf([&] {
                 KMeans1D({1, nan, 2}, 2);
             }),
             std::string("1 of 3 values to classify are not finite"));

    const auto mesh = Roof(6);
    const auto descriptor = LaplacianDescriptor(View(mesh));
    const auto refusal = [&](FeatureParameters p) {
        return RefusalOf([&] { ClassifyFeatures(View(mesh), descriptor, p); });
    };
    FeatureParameters parameters;
    parameters.classes = 17;
    QCOMPARE(refusal(parameters), std::string("classes = 17 is outside [2, 16]"));
    parameters = {};
    parameters.selectedClasses = 2;
    QCOMPARE(refusal(parameters), std::string("selected_classes = 2 is outside [1, 1]"));
    parameters = {};
    parameters.minimumFeatureNeighbours = 0;
    QCOMPARE(refusal(parameters), std::string("minimum_feature_neighbours = 0 is outside [1, infinity)"));
    parameters = {};
    parameters.refinementFloor = nan;
    QVERIFY(refusal(parameters).find("refinement_floor") == 0);
}

void TestClassification::creaseOfARoofIsTheFeature()
{
    const auto mesh = Roof(20);
    const auto descriptor = LaplacianDescriptor(View(mesh));
    const FeatureClasses classes = ClassifyFeatures(View(mesh), descriptor, {});
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const bool inner = mesh.points[v][0] > 0 && mesh.points[v][0] < 20;
        if (mesh.points[v][1] == 2 && inner) QVERIFY(classes.isFeature[v]);
        if (mesh.points[v][1] == 0 || mesh.points[v][1] == 4) QVERIFY(!classes.isFeature[v]);
        QCOMPARE(int(classes.isFeature[v]), int(descriptor[v] > classes.clusters.thresholds[0]));
    }
    QVERIFY(classes.promoted.empty());
}

void TestClassification::isolatedVerticesAreNoFeatures()
{
    const auto mesh = test_meshes::WithIsolatedVertices(Roof(6), 3);
    std::vector<double> descriptor = LaplacianDescriptor(View(mesh));
    for (std::size_t v = mesh.points.size() - 3; v < mesh.points.size(); ++v)
        descriptor[v] = 1; // stale quality
    const FeatureClasses classes = ClassifyFeatures(View(mesh), descriptor, {});
    QCOMPARE(classes.clusters.sizes[0] + classes.clusters.sizes[1], mesh.points.size() - 3);
    for (std::size_t v = mesh.points.size() - 3; v < mesh.points.size(); ++v) QVERIFY(!classes.isFeature[v]);
}

void TestClassification::refinementOnlyAddsNeighboursOfLonelyFeatures()
{
    for (unsigned seed = 1; seed <= 5; ++seed)
        for (const int minimum : {1, 2, 3}) {
            const auto mesh = test_meshes::Noisy(test_meshes::Box(8), .02, seed);
            const auto descriptor = LaplacianDescriptor(View(mesh));
            FeatureParameters parameters;
            parameters.minimumFeatureNeighbours = minimum;
            const FeatureClasses before = ClassifyFeatures(View(mesh), descriptor, parameters);
            parameters.refine = true;
            const FeatureClasses after = ClassifyFeatures(View(mesh), descriptor, parameters);

            // replay: each promoted vertex had a feature neighbour that was lonely at that moment
            const OneRings rings(View(mesh));
            std::vector<std::uint8_t> isFeature = before.isFeature;
            std::vector<std::uint32_t> room;
            for (const std::uint32_t v : after.promoted) {
                QVERIFY(!isFeature[v]);
                const auto neighbours = rings.Neighbours(v, room);
                QVERIFY(std::any_of(neighbours.begin(), neighbours.end(), [&](std::uint32_t w) {
                    return isFeature[w] && FeatureNeighbours(rings, isFeature, w) < std::size_t(minimum);
                }));
                QVERIFY(descriptor[v] >= parameters.refinementFloor * before.clusters.thresholds[0]);
                isFeature[v] = 1;
            }
            QCOMPARE(isFeature, after.isFeature);
            if (seed == 1 && minimum == 3) QVERIFY(!after.promoted.empty());
        }
}

void TestClassification::refinementTakesTheBestNeighbourAndStopsAtTheFloor()
{
    // A strip of vertices 0..6 along y = 0 with one feature in the middle, and its neighbours' values known.
    const auto mesh = test_meshes::Grid(6, 1);
    std::vector<double> descriptor(mesh.points.size(), 0.01);
    descriptor[3] = 1;
    descriptor[2] = .4;
    descriptor[4] = .3;
    descriptor[1] = .26;
    FeatureParameters parameters;
    parameters.refine = true;
    const Clusters clusters = ClassifyFeatures(View(mesh), descriptor, {}).clusters;
    QVERIFY(clusters.thresholds[0] > .4 && clusters.thresholds[0] < 1);
    parameters.refinementFloor = .29 / clusters.thresholds[0];
    const FeatureClasses classes = ClassifyFeatures(View(mesh), descriptor, parameters);
    // 3 wants two: first 2 (the best), then 4; both are lonely then, but 1 is below the floor
    QCOMPARE(classes.promoted, (std::vector<std::uint32_t>{2, 4}));
}

QTEST_APPLESS_MAIN(TestClassification)
#include "test_feature_classes.moc"
