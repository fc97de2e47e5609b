// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "test_meshes.h"
#include "vcg_ext/smoothing.h"

using namespace vcg_ext;
using namespace test_meshes;

namespace
{

const std::vector<UmbrellaOperator> kAll{UmbrellaOperator::Uniform, UmbrellaOperator::ScaleDependent,
                                         UmbrellaOperator::NormalDependent};

double Distance(const Coordinates& a, const Coordinates& b)
{
    return std::hypot(a[0] - b[0], std::hypot(a[1] - b[1], a[2] - b[2]));
}

Coordinates DeltaAt(const IndexedMesh& mesh, std::size_t v, UmbrellaOperator umbrella)
{
    MeshView view = View(mesh);
    if (!mesh.fauxEdges.empty()) view.fauxEdges = mesh.fauxEdges.data();
    return UmbrellaRings(view, SmoothingBoundary::Free).Delta(mesh.points, v, umbrella);
}

std::vector<Coordinates> Smoothed(const IndexedMesh& mesh, const SmoothingParameters& parameters)
{
    return SmoothedPositions(View(mesh), parameters);
}

double LargestMovement(const std::vector<Coordinates>& before, const std::vector<Coordinates>& after)
{
    double largest = 0;
    for (std::size_t v = 0; v < before.size(); ++v)
        largest = std::max(largest, Distance(before[v], after[v]));
    return largest;
}

/// A box with rows of unlike width, so that centroids of neighbours are not where the vertices are.
IndexedMesh UnevenBox()
{
    IndexedMesh box = Box(6);
    for (Point& p : box.points)
        for (double& x : p) x = x * x;
    return box;
}

/// Over the vertices inside the straight edges of a box: how far they went, and how far along their edge.
std::pair<double, double> MovementOfSharpEdges(const IndexedMesh& box, const std::vector<Coordinates>& after)
{
    double whole = 0, along = 0;
    for (std::size_t v = 0; v < box.points.size(); ++v) {
        std::vector<std::size_t> free;
        for (std::size_t k = 0; k < 3; ++k)
            if (box.points[v][k] > 0 && box.points[v][k] < 1) free.push_back(k);
        if (free.size() != 1) continue;
        whole += Distance(box.points[v], after[v]);
        along += std::fabs(box.points[v][free[0]] - after[v][free[0]]);
    }
    return {whole, along};
}

} // namespace

class TestLaplacianOperators : public QObject
{
    Q_OBJECT

  private slots:
    void rowsAreInTheOrderOfTheEnum();
    void uniformPointsToTheCentroid();
    void scaleDependentWeighsByInverseLength();
    void normalDependentIsTheProjection();
    void normalDependentLeavesPlanesExact();
    void normalDependentDoesNotSlideAlongSharpEdges();
    void everyNeighbourCountsOnceAtNonManifoldEdges();
    void diagonalsDoNotPull();
    void bordersFollowTheRule();
    void maskedAndIsolatedVerticesStay();
    void sphereShrinksByTheClosedForm();
    void stepsComposeAndStepSizeScales();
    void sameBytesForEveryNumberOfThreads();
    void meshesOfBothScalarsAreSmoothedInPlace();
    void stopsUntouchedWhenTold();
    void refusesByName();
};

void TestLaplacianOperators::rowsAreInTheOrderOfTheEnum()
{
    for (std::size_t i = 0; i < std::size(kUmbrellaOperators); ++i)
        QCOMPARE(static_cast<std::size_t>(kUmbrellaOperators[i].kind), i);
}

void TestLaplacianOperators::uniformPointsToTheCentroid()
{
    IndexedMesh mesh = Pyramid(4, 1, 2);
    mesh.points[0] = {.25, -.5, 2};
    QVERIFY(Distance(DeltaAt(mesh, 0, UmbrellaOperator::Uniform), {-.25, .5, -2}) < 1e-15);
    // a base vertex has three neighbours, two of them by border edges
    const Coordinates delta = DeltaAt(mesh, 1, UmbrellaOperator::Uniform);
    QVERIFY(Distance(delta, {(.25 + 0 + 0) / 3 - 1, (-.5 + 1 - 1) / 3, 2. / 3}) < 1e-15);
}

void TestLaplacianOperators::scaleDependentWeighsByInverseLength()
{
    // edges of length 1 and 3 to either side: sum of unit vectors 0, and two across that cancel
    IndexedMesh mesh = Pyramid(4, 1, 0);
    mesh.points[1] = {3, 0, 0};
    QVERIFY(Distance(DeltaAt(mesh, 0, UmbrellaOperator::ScaleDependent), {0, 0, 0}) < 1e-15);
    QVERIFY(Distance(DeltaAt(mesh, 0, UmbrellaOperator::Uniform), {.5, 0, 0}) < 1e-15);
    mesh.points[0] = {0, 0, 1};
    // weights 1 / |e| = 1 / sqrt 10 and three times 1 / sqrt 2
    const double a = 1 / std::sqrt(10.0), b = 1 / std::sqrt(2.0);
    QVERIFY(Distance(DeltaAt(mesh, 0, UmbrellaOperator::ScaleDependent), {(3 * a - b) / (a + 3 * b), 0, -1}) <
            1e-15);
}

void TestLaplacianOperators::normalDependentIsTheProjection()
{
    const IndexedMesh regular = Moved(Pyramid(7, 1, .5), 1, 1, {1, 2, 3});
    // regular: the normal is the axis, so all three agree
    for (const UmbrellaOperator umbrella : kAll)
        QVERIFY(std::fabs(Distance(DeltaAt(regular, 0, umbrella), {0, 0, 0}) - .5) < 1e-14);
    const IndexedMesh noisy = Noisy(Icosphere(1), .1);
    for (std::size_t v = 0; v < noisy.points.size(); ++v) {
        const Coordinates full = DeltaAt(noisy, v, UmbrellaOperator::Uniform);
        const Coordinates along = DeltaAt(noisy, v, UmbrellaOperator::NormalDependent);
        const double product = full[0] * along[0] + full[1] * along[1] + full[2] * along[2];
        const double squared = along[0] * along[0] + along[1] * along[1] + along[2] * along[2];
        QVERIFY(std::fabs(product - squared) < 1e-15); // what was taken away is perpendicular
        QVERIFY(squared > 0);
    }
}

void TestLaplacianOperators::normalDependentLeavesPlanesExact()
{
    IndexedMesh plane = Noisy(Grid(8, 8), .3);
    for (Point& p : plane.points) p[2] = 0;
    SmoothingParameters parameters;
    parameters.umbrella = UmbrellaOperator::NormalDependent;
    QCOMPARE(Smoothed(plane, parameters), plane.points);
    const IndexedMesh tilted = Moved(plane, 1, 1, {5, 5, 5});
    QVERIFY(LargestMovement(tilted.points, Smoothed(tilted, parameters)) < 1e-14);
    parameters.umbrella = UmbrellaOperator::Uniform;
    QVERIFY(LargestMovement(plane.points, Smoothed(plane, parameters)) > .1);
}

void TestLaplacianOperators::normalDependentDoesNotSlideAlongSharpEdges()
{
    const IndexedMesh box = UnevenBox();
    std::vector<double> whole, along;
    for (const UmbrellaOperator umbrella : kAll) {
        SmoothingParameters parameters;
        parameters.umbrella = umbrella;
        parameters.steps = 1;
        const auto [movement, part] = MovementOfSharpEdges(box, Smoothed(box, parameters));
        whole.push_back(movement);
        along.push_back(part);
    }
    QVERIFY(along[2] < 1e-13); // the normal of a crease is perpendicular to it
    QVERIFY(along[0] > .5 && along[1] > .5);
    QVERIFY(whole[2] < .9 * whole[0]);
}

void TestLaplacianOperators::everyNeighbourCountsOnceAtNonManifoldEdges()
{
    for (const int pages : {3, 4, 5}) {
        const IndexedMesh book = Book(pages);
        // the spine's other end once, the page tips, whose centroid is on the axis at height .5
        const double height = (1 + .5 * pages) / (pages + 1);
        QVERIFY(Distance(DeltaAt(book, 0, UmbrellaOperator::Uniform), {0, 0, height}) < 1e-15);
    }
}

void TestLaplacianOperators::diagonalsDoNotPull()
{
    IndexedMesh quads = Grid(2, 2, 1, true);
    QVERIFY(Distance(DeltaAt(quads, 4, UmbrellaOperator::Uniform), {0, 0, 0}) < 1e-15);
    quads.points[8] = {9, 9, 9}; // across a diagonal of the middle vertex
    QVERIFY(Distance(DeltaAt(quads, 4, UmbrellaOperator::Uniform), {0, 0, 0}) < 1e-15);
    quads.fauxEdges.clear();
    QVERIFY(Distance(DeltaAt(quads, 4, UmbrellaOperator::Uniform), {0, 0, 0}) > 1);
}

void TestLaplacianOperators::bordersFollowTheRule()
{
    IndexedMesh mesh = Noisy(Grid(6, 6), .2);
    const auto onBorder = [&](std::size_t v) { return v % 7 == 0 || v % 7 == 6 || v < 7 || v >= 42; };
    SmoothingParameters parameters;
    parameters.boundary = SmoothingBoundary::Fixed;
    const auto fixed = Smoothed(mesh, parameters);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) QCOMPARE(fixed[v] == mesh.points[v], onBorder(v));

    // along the border: inner vertices have no influence on it
    parameters.boundary = SmoothingBoundary::AlongBorder;
    parameters.steps = 1;
    const auto along = Smoothed(mesh, parameters);
    for (std::size_t k = 0; k < 3; ++k) {
        const double middle = (mesh.points[2][k] + mesh.points[4][k]) / 2;
        QVERIFY(std::fabs(along[3][k] - (mesh.points[3][k] + middle) / 2) < 1e-15);
    }
    parameters.boundary = SmoothingBoundary::Free;
    QVERIFY(Distance(Smoothed(mesh, parameters)[3], along[3]) > .01);
    QVERIFY(Distance(Smoothed(mesh, parameters)[24], along[24]) < 1e-15); // an inner vertex does not care
}

void TestLaplacianOperators::maskedAndIsolatedVerticesStay()
{
    const IndexedMesh mesh = WithIsolatedVertices(Noisy(Icosphere(1), .2), 2);
    std::vector<std::uint8_t> movable(mesh.points.size(), 1);
    for (std::size_t v = 0; v < 20; ++v) movable[v] = 0;
    SmoothingParameters parameters;
    parameters.movable = movable.data();
    for (const UmbrellaOperator umbrella : kAll) {
        parameters.umbrella = umbrella;
        const auto after = Smoothed(mesh, parameters);
        for (std::size_t v = 0; v < mesh.points.size(); ++v)
            QCOMPARE(after[v] == mesh.points[v], v < 20 || v >= mesh.points.size() - 2);
    }
}

void TestLaplacianOperators::sphereShrinksByTheClosedForm()
{
    // the neighbours of an icosahedron's vertex lie 1 - 1 / sqrt 5 below it: a full step keeps 1 / sqrt 5
    SmoothingParameters parameters;
    parameters.steps = 3;
    parameters.stepSize = 1;
    for (const UmbrellaOperator umbrella : kAll) {
        parameters.umbrella = umbrella;
        for (const Coordinates& p : Smoothed(Icosphere(0), parameters)) {
            const double radius = Distance(p, {0, 0, 0}) / Distance(Icosphere(0).points[0], {0, 0, 0});
            QVERIFY(std::fabs(radius - std::pow(5, -1.5)) < 1e-14);
        }
    }
}

void TestLaplacianOperators::stepsComposeAndStepSizeScales()
{
    const IndexedMesh mesh = Noisy(Torus(12, 8), .05);
    SmoothingParameters one;
    one.steps = 1;
    IndexedMesh twice = mesh;
    for (int i = 0; i < 2; ++i) twice.points = Smoothed(twice, one);
    SmoothingParameters two;
    two.steps = 2;
    QCOMPARE(Smoothed(mesh, two), twice.points);
    SmoothingParameters quarter = one;
    quarter.stepSize = .125;
    const auto half = Smoothed(mesh, one), eighth = Smoothed(mesh, quarter);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        QVERIFY(std::fabs(Distance(half[v], mesh.points[v]) - 4 * Distance(eighth[v], mesh.points[v])) <
                1e-14);
}

void TestLaplacianOperators::sameBytesForEveryNumberOfThreads()
{
    const IndexedMesh mesh = Noisy(Torus(600, 450), 1e-4); // enough faces for three threads
    for (const UmbrellaOperator umbrella : kAll) {
        SmoothingParameters parameters;
        parameters.umbrella = umbrella;
        parameters.steps = 1;
        parameters.threads = 1;
        const auto alone = Smoothed(mesh, parameters);
        for (const int threads : {2, 3}) {
            parameters.threads = threads;
            QVERIFY(Smoothed(mesh, parameters) == alone);
        }
    }
}

void TestLaplacianOperators::meshesOfBothScalarsAreSmoothedInPlace()
{
    const IndexedMesh source = Noisy(Box(3, 1, true), .1);
    FloatMesh single;
    DoubleMesh twice;
    Fill(single, source);
    Fill(twice, source);
    UmbrellaSmooth(single, {});
    UmbrellaSmooth(twice, {});
    QVERIFY(LargestMovement(Arrays(single).points, Arrays(twice).points) < 1e-6);
    QVERIFY(LargestMovement(source.points, Arrays(twice).points) > .1);
    MeshView view = View(source);
    view.fauxEdges = source.fauxEdges.data();
    QCOMPARE(Arrays(twice).points, SmoothedPositions(view, {}));
}

void TestLaplacianOperators::stopsUntouchedWhenTold()
{
    DoubleMesh mesh;
    Fill(mesh, Icosphere(1));
    SmoothingParameters parameters;
    int calls = 0;
    parameters.progress = [&](int percent, const char*) {
        ++calls;
        return percent < 50;
    };
    QVERIFY_EXCEPTION_THROWN(UmbrellaSmooth(mesh, parameters), Cancelled);
    QCOMPARE(calls, 6);
    QCOMPARE(Arrays(mesh).points, Icosphere(1).points);
}

void TestLaplacianOperators::refusesByName()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refusal = [](int steps, double stepSize) -> std::string {
        SmoothingParameters parameters;
        parameters.steps = steps;
        parameters.stepSize = stepSize;
        try {
            Smoothed(Grid(1, 1), parameters);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    QCOMPARE(refusal(0, .5), std::string("steps = 0 is outside [1, 10000]"));
    QCOMPARE(refusal(10, 0), std::string("step_size = 0.000000 is outside (0, 1]"));
    QVERIFY(refusal(10, 1.5).find("step_size") == 0);
    QVERIFY(refusal(10, nan).find("step_size") == 0);
    QCOMPARE(refusal(1, 1), std::string("accepted"));
}

QTEST_APPLESS_MAIN(TestLaplacianOperators)
#include "test_smoothing.moc"
