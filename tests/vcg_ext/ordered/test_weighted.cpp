// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <string>

#include "mesh_checks.h"
#include "test_meshes.h"
#include "vcg_ext/descriptors.h"
#include "vcg_ext/core/measure/surface_distance.h"
#include "vcg_ext/ordered/decimate.h"

using namespace vcg_ext;
using namespace test_meshes;

Q_DECLARE_METATYPE(vcg_ext::ErrorFunction)

namespace
{

/// A turned part: three diameters with sharp shoulders.
IndexedMesh Shaft()
{
    return Revolved(40, 36, false, false, [](int j) {
        const double radius = j < 12 ? 1 : j < 24 ? 1.6 : .7;
        return std::array<double, 2>{radius, .15 * (j - (j >= 12) - (j >= 24))};
    });
}

/// A sheet in folds with sharp ridges.
IndexedMesh FoldedSheet()
{
    IndexedMesh mesh = Grid(44, 36, .1);
    for (Point& p : mesh.points) p[2] = std::abs(std::fmod(p[0], 1.2) - .6) * (1 + .2 * std::sin(p[1]));
    return mesh;
}

/// A ball with ridges along meridians.
IndexedMesh RidgedBall()
{
    IndexedMesh mesh = Icosphere(4);
    for (Point& p : mesh.points) {
        const double swell =
            1 + .15 * std::abs(std::sin(3 * std::atan2(p[1], p[0]))) * std::hypot(p[0], p[1]);
        for (double& x : p) x *= swell;
    }
    return mesh;
}

std::vector<IndexedMesh> FeaturedMeshes()
{
    return {Box(14), Shaft(), FoldedSheet(), RidgedBall(), Noisy(Torus(48, 24), .004)};
}

IndexedMesh Decimated(const IndexedMesh& mesh, std::size_t faces, WeightedParameters parameters)
{
    parameters.targetFaces = faces;
    const OrderedDecimation decimation = DecimateWeighted(View(mesh), std::move(parameters));
    IndexedMesh result;
    result.points = decimation.mesh.positions;
    result.triangles = decimation.mesh.triangles;
    return result;
}

std::vector<double> DistancesTo(const IndexedMesh& mesh, const std::vector<Point>& points)
{
    const MeshView view = View(mesh);
    return SurfaceDistance(view, 1).Of(points);
}

/// Root mean square distance of the tenth of the vertices with the largest descriptor.
double FeatureRms(const IndexedMesh& mesh, const std::vector<double>& descriptor, const IndexedMesh& result)
{
    std::vector<std::size_t> order(mesh.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return descriptor[a] > descriptor[b]; });
    order.resize(order.size() / 10);
    std::vector<Point> points;
    for (const std::size_t v : order) points.push_back(mesh.points[v]);
    double sum = 0;
    for (const double distance : DistancesTo(result, points)) sum += distance * distance;
    return std::sqrt(sum / static_cast<double>(order.size()));
}

/// Feature rms of FeaturedMeshes at two reductions: ten cases for each of \p lambdas.
std::vector<std::vector<double>> FeatureErrors(ErrorFunction function, const std::vector<double>& lambdas)
{
    std::vector<std::vector<double>> errors(lambdas.size());
    for (const IndexedMesh& mesh : FeaturedMeshes()) {
        const auto descriptor = RescaledToUnit(LaplacianDescriptor(View(mesh)));
        for (const std::size_t divisor : {3, 8})
            for (std::size_t i = 0; i < lambdas.size(); ++i) {
                WeightedParameters parameters;
                parameters.errorFunction = function;
                parameters.featureWeight = lambdas[i];
                parameters.descriptor = descriptor;
                const auto result = Decimated(mesh, mesh.triangles.size() / divisor, parameters);
                errors[i].push_back(FeatureRms(mesh, descriptor, result));
            }
    }
    return errors;
}

/// A fold of two unit squares' halves around the edge from the removed vertex to (1, 0, 0).
CollapseSurroundings Fold(double angle)
{
    CollapseSurroundings edge;
    edge.kept = {2, 0, 0};
    edge.removedFaces = {{{0, 0, 1}, true}, {{0, std::sin(angle), std::cos(angle)}, false}};
    return edge;
}

} // namespace

class TestWeightedDecimation : public QObject
{
    Q_OBJECT

    static void addFunctions()
    {
        QTest::addColumn<ErrorFunction>("function");
        for (const ErrorFunctionRow& row : kErrorFunctions) QTest::newRow(row.id) << row.kind;
    }

  private slots:
    void rowsAreInTheOrderOfTheirNumbers();
    void errorsAreThoseOfTheFormulas();
    void guidanceKeepsFeatures_data() { addFunctions(); }
    void guidanceKeepsFeatures();
    void classesKeepStraightBorders();
    void addsNoDefect_data() { addFunctions(); }
    void addsNoDefect();
    void noFaceOfAFlatSheetLosesItsArea_data() { addFunctions(); }
    void noFaceOfAFlatSheetLosesItsArea();
    void fixedVerticesStay_data() { addFunctions(); }
    void fixedVerticesStay();
    void quadricWeightsAttractVertices();
    void absoluteCurvatureIsTheSumOfBoth();
    void refusesWhatDoesNotFit();
};

void TestWeightedDecimation::rowsAreInTheOrderOfTheirNumbers()
{
    std::set<std::string> ids;
    for (std::size_t i = 0; i < std::size(kErrorFunctions); ++i) {
        QCOMPARE(static_cast<std::size_t>(kErrorFunctions[i].kind), i);
        QCOMPARE(&RowOf(kErrorFunctions[i].kind), &kErrorFunctions[i]);
        QVERIFY(ids.insert(kErrorFunctions[i].id).second);
    }
}

void TestWeightedDecimation::errorsAreThoseOfTheFormulas()
{
    for (const double angle : {.3, 1.2}) {
        const auto melax = MelaxError(Fold(angle));
        QVERIFY(melax.has_value());
        QVERIFY(std::abs(melax->value - 2 * (1 - std::cos(angle)) / 2) < 1e-9);
        QCOMPARE(ShortestEdgeError(Fold(angle))->value, 2.);
        QVERIFY(melax->placement.x == 2 && melax->placement.y == 0 && melax->placement.z == 0);
    }
    // Planes x = 1 and z = .5 weigh 1 and 3; nothing holds y, so it stays in the middle.
    CollapseSurroundings edge;
    edge.kept = {2, 2, 0};
    edge.keptStays = false;
    edge.quadric = {{1, 0, 0, 0, 0, 3}, {-1, 0, 3 * -.5}, 1 + 3 * .25};
    const auto free = QuadricError(edge);
    const Vector3d away = free->placement - Vector3d{1, 1, .5};
    QVERIFY(Dot(away, away) < 1e-18);
    QVERIFY(free->value < 1e-9);
    edge.keptStays = true;
    QVERIFY(std::abs(QuadricError(edge)->value - (1 + 3 * .25) / .3) < 1e-9);
}

void TestWeightedDecimation::guidanceKeepsFeatures()
{
    QFETCH(ErrorFunction, function);
    const auto errors = FeatureErrors(function, {0, 1, 10});
    int wins = 0;
    double firstToLast = 0;
    for (std::size_t i = 0; i < errors[0].size(); ++i) {
        // Both exact, as on a box, is a tie that the plain form did not win.
        constexpr double kExact = 1e-6;
        wins += errors[2][i] < errors[0][i] || errors[2][i] < kExact;
        firstToLast += std::log((errors[2][i] + kExact) / (errors[1][i] + kExact));
    }
    QVERIFY2(wins >= 9, qPrintable(QString("%1 of 10").arg(wins)));
    QVERIFY(firstToLast < 0);
}

void TestWeightedDecimation::classesKeepStraightBorders()
{
    const int divisions = 16;
    const IndexedMesh box = Box(divisions);
    std::vector<std::uint8_t> classes;
    std::vector<Point> border;
    for (const Point& p : box.points) {
        const auto onSide = [](double x) { return x < 1e-9 || x > 1 - 1e-9; };
        const auto inMiddle = [](double x) { return x > .3 && x < .7; };
        const bool isFeature = onSide(p[0]) + onSide(p[1]) + onSide(p[2]) >= 2;
        classes.push_back(isFeature);
        // A corner may go along one of its borders; the straight parts must not bend.
        if (isFeature && (inMiddle(p[0]) || inMiddle(p[1]) || inMiddle(p[2]))) border.push_back(p);
    }
    const auto largestDistance = [&](bool classAware) {
        WeightedParameters parameters;
        parameters.errorFunction = ErrorFunction::ShortestEdge;
        parameters.featureWeight = 0;
        if (classAware) parameters.featureClass = classes;
        const IndexedMesh result = Decimated(box, box.triangles.size() / 10, parameters);
        const std::vector<double> distances = DistancesTo(result, border);
        return *std::max_element(distances.begin(), distances.end());
    };
    const double plain = largestDistance(false), aware = largestDistance(true);
    QVERIFY2(plain > .05, qPrintable(QString::number(plain)));
    QVERIFY2(aware < .5 * plain, qPrintable(QString("%1 instead of %2").arg(aware).arg(plain)));
}

void TestWeightedDecimation::addsNoDefect()
{
    QFETCH(ErrorFunction, function);
    for (const IndexedMesh& mesh : {Noisy(Grid(16, 16), .2), Shaft(), Noisy(Icosphere(3), .05), Book(4),
                                    BowTie(), Merged(Icosphere(2), Box(4)), Noisy(Torus(60, 6, 1, .03), .01)})
        for (const std::size_t percent : {50, 10, 2}) {
            const Defects before = FindDefects(mesh);
            WeightedParameters parameters;
            parameters.errorFunction = function;
            parameters.descriptor = RescaledToUnit(LaplacianDescriptor(View(mesh)));
            parameters.targetFaces = std::max<std::size_t>(1, mesh.triangles.size() * percent / 100);
            const OrderedDecimation decimation = DecimateWeighted(View(mesh), parameters);
            IndexedMesh result;
            result.points = decimation.mesh.positions;
            result.triangles = decimation.mesh.triangles;
            const Defects after = FindDefects(result);
            QVERIFY(after.nonManifoldEdges <= before.nonManifoldEdges);
            QVERIFY(after.nonManifoldFans <= before.nonManifoldFans);
            QCOMPARE(after.duplicateFaces + after.degenerateFaces, 0);
            QCOMPARE(decimation.mesh.stopReason == StopReason::Target,
                     result.triangles.size() <= parameters.targetFaces);
        }
}

void TestWeightedDecimation::noFaceOfAFlatSheetLosesItsArea()
{
    // In rows and columns most vertices could go onto the far side of a face.
    QFETCH(ErrorFunction, function);
    const IndexedMesh sheet = Grid(90, 90, 1);
    WeightedParameters parameters;
    parameters.errorFunction = function;
    const IndexedMesh result = Decimated(sheet, sheet.triangles.size() * 3 / 10, parameters);
    QCOMPARE(FindDefects(result).degenerateFaces, std::size_t{0});
}

void TestWeightedDecimation::fixedVerticesStay()
{
    QFETCH(ErrorFunction, function);
    const IndexedMesh mesh = Noisy(Icosphere(3), .02);
    std::vector<std::uint8_t> fixed(mesh.points.size(), 0);
    for (std::size_t v = 0; v < 60; ++v) fixed[v] = 1;
    MeshView view = View(mesh);
    view.fixedVertices = fixed.data();
    WeightedParameters parameters;
    parameters.errorFunction = function;
    parameters.targetFaces = 300;
    const OrderedDecimation decimation = DecimateWeighted(view, parameters);
    for (std::size_t v = 0; v < 60; ++v) {
        const std::uint32_t root = decimation.root[v];
        QCOMPARE(static_cast<std::size_t>(decimation.mesh.vertexOrigin[root]), v);
        QVERIFY(decimation.mesh.positions[root] == mesh.points[v]);
    }
}

void TestWeightedDecimation::quadricWeightsAttractVertices()
{
    const IndexedMesh mesh = Noisy(Grid(40, 40), .2);
    std::vector<double> weights(mesh.points.size());
    for (std::size_t v = 0; v < weights.size(); ++v) weights[v] = mesh.points[v][0] > 20 ? 30 : 1;
    const auto shareOfRight = [&](const std::vector<double>& quadricWeights) {
        WeightedParameters parameters;
        parameters.quadricWeights = quadricWeights;
        const IndexedMesh result = Decimated(mesh, 320, parameters);
        const auto right = std::count_if(result.points.begin(), result.points.end(),
                                         [](const Point& p) { return p[0] > 20; });
        return static_cast<double>(right) / static_cast<double>(result.points.size());
    };
    QVERIFY(shareOfRight(weights) > shareOfRight({}) + .1);
}

void TestWeightedDecimation::absoluteCurvatureIsTheSumOfBoth()
{
    // k = (3, 2), (3, -2), (0, 0); mean (k1 + k2) / 2, Gaussian k1 k2.
    const auto sums = AbsoluteCurvature({2.5, .5, 0}, {6, -6, 0});
    QVERIFY(std::abs(sums[0] - 5) < 1e-12);
    QVERIFY(std::abs(sums[1] - 5) < 1e-12);
    QCOMPARE(sums[2], 0.);
}

void TestWeightedDecimation::refusesWhatDoesNotFit()
{
    const IndexedMesh mesh = Icosphere(1);
    const auto refusal = [&](const WeightedParameters& parameters) -> std::string {
        try {
            DecimateWeighted(View(mesh), parameters);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    WeightedParameters parameters;
    parameters.descriptor.assign(3, 0);
    QCOMPARE(refusal(parameters), std::string("descriptor has 3 values for 42 vertices"));
    parameters = {};
    parameters.featureWeight = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!refusal(parameters).empty());
}

QTEST_APPLESS_MAIN(TestWeightedDecimation)
#include "test_weighted.moc"
