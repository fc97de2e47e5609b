// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "test_meshes.h"
#include "vcg_ext/core/descriptor/laplacian_passes.h"
#include "vcg_ext/descriptors.h"

using namespace vcg_ext;
using namespace test_meshes;

namespace
{

// Sums of at most a dozen edges in float, each with a few roundings of 6e-8 of its length.
constexpr double kRounding = 1e-6;

/// The descriptors by definition: every pair of vertices is looked at, in double.
/// \returns Laplacian, normalised umbrella, curvature estimation
std::array<std::vector<double>, 3> ByDefinition(const IndexedMesh& mesh)
{
    std::array<std::vector<double>, 3> values;
    for (auto& v : values) v.assign(mesh.points.size(), 0);
    std::vector<std::map<std::size_t, bool>> neighbours(mesh.points.size()); // false: only by faux edges
    std::vector<vcg::Point3d> normals(mesh.points.size(), vcg::Point3d(0, 0, 0));
    const auto point = [&](std::size_t v) {
        return vcg::Point3d(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
    };
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t v = t[k], next = t[(k + 1) % 3], previous = t[(k + 2) % 3];
            const bool faux = !mesh.fauxEdges.empty() && (mesh.fauxEdges[f] >> k & 1);
            neighbours[v][next] = neighbours[v][next] || !faux;
            neighbours[next][v] = neighbours[next][v] || !faux;
            const vcg::Point3d a = (point(next) - point(v)).normalized(),
                               b = (point(previous) - point(v)).normalized();
            if ((a ^ b).Norm() > 1e-6) normals[v] += (a ^ b).normalized() * (a - b).Norm();
        }
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        double height = 0, length = 0, sine = 0, curvature = 0, count = 0;
        const bool cancelled = normals[v].Norm() < 1e-5;
        const vcg::Point3d n = cancelled ? vcg::Point3d(0, 0, 0) : normals[v].normalized();
        for (const auto& [w, real] : neighbours[v]) {
            if (!real) continue;
            const vcg::Point3d e = point(w) - point(v);
            height += e * n;
            length += e.Norm();
            sine += e.normalized() * n;
            curvature += std::fabs(2 * (e * n)) / e.SquaredNorm();
            ++count;
        }
        if (count == 0) continue;
        values[0][v] = std::fabs(height) / length;
        values[1][v] = std::fabs(sine) / count;
        values[2][v] = curvature / count;
    }
    return values;
}

/// Two cubes that share nothing but an edge: four faces on it, as many one way as the other.
IndexedMesh CubesAtAnEdge()
{
    IndexedMesh mesh = Box(2);
    const IndexedMesh other = Box(2);
    std::vector<std::uint32_t> place;
    for (const Point& p : other.points) {
        const Point shifted{p[0] + 1, p[1] + 1, p[2]};
        auto at = std::find(mesh.points.begin(), mesh.points.end(), shifted);
        if (at == mesh.points.end()) at = mesh.points.insert(at, shifted);
        place.push_back(static_cast<std::uint32_t>(at - mesh.points.begin()));
    }
    for (const Triangle& t : other.triangles) mesh.AddTriangle(place[t[0]], place[t[1]], place[t[2]]);
    return mesh;
}

IndexedMesh WithDegenerateFaces(IndexedMesh mesh)
{
    mesh.AddTriangle(0, 0, 1);
    mesh.AddTriangle(1, 2, 1);
    return mesh;
}

/// Two spheres that share nothing but one edge of each: its four faces are balanced at every vertex.
IndexedMesh SpheresAtAnEdge(std::size_t face, std::size_t otherFace)
{
    const IndexedMesh sphere = Noisy(Icosphere(2), .03);
    IndexedMesh mesh = Merged(sphere, Moved(sphere, .4, 1.5, {2, 1, 0}));
    const Triangle edge = mesh.triangles[face], other = mesh.triangles[sphere.triangles.size() + otherFace];
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            for (const std::size_t end : {0, 1})
                if (v == other[end]) v = edge[end];
    return mesh;
}

/// A pyramid on either side of a polygon: closed, with two vertices of any valence.
IndexedMesh Bipyramid(int sides)
{
    IndexedMesh mesh = Pyramid(sides, 1, .8);
    const std::size_t faces = mesh.triangles.size(), below = mesh.points.size();
    mesh.points.push_back({.1, .2, -.5});
    for (std::size_t f = 0; f < faces; ++f) {
        const Triangle t = mesh.triangles[f];
        mesh.AddTriangle(below, t[2], t[1]);
    }
    return mesh;
}

/// A sphere drawn out to a needle, and faces without area: all vertices on a line, or some of them in one
/// place.
IndexedMesh Slivers(double stretch)
{
    IndexedMesh mesh = Merged(Noisy(Icosphere(3), .01), Noisy(Grid(6, 6), .05));
    for (Point& p : mesh.points) p[0] *= stretch;
    const std::size_t first = mesh.points.size();
    for (const Point& p :
         {Point{0, 0, 9}, Point{1, 0, 9}, Point{2, 0, 9}, Point{1, 1, 9.5}, Point{1, 1, 9.5}})
        mesh.points.push_back(p);
    mesh.AddTriangle(first, first + 2, first + 1);
    mesh.AddTriangle(first, first + 1, first + 3);
    mesh.AddTriangle(first + 1, first + 2, first + 4);
    mesh.AddTriangle(first + 3, first + 1, first + 4);
    return mesh;
}

/// Every topology that a file may hold, by name.
std::vector<std::pair<const char*, IndexedMesh>> Families()
{
    IndexedMesh flipped = Noisy(Box(3), .05);
    for (std::size_t f = 0; f < flipped.triangles.size(); f += 3)
        std::swap(flipped.triangles[f][0], flipped.triangles[f][1]);
    IndexedMesh twice = Noisy(Icosphere(1), .1);
    for (std::size_t f = twice.triangles.size(); f-- > 0;) twice.triangles.push_back(twice.triangles[f]);
    return {{"icosphere", Icosphere(2)},
            {"noisy torus", Noisy(Torus(20, 12), .03)},
            {"noisy grid with borders", Noisy(Grid(9, 7), .2)},
            {"open cylinder", Noisy(OpenCylinder(11, 5), .1)},
            {"pyramid of many sides", Pyramid(100)},
            {"box", Box(3)},
            {"book of 3", Book(3)},
            {"noisy book of 4", Noisy(Book(4), .2)},
            {"book of 4", Book(4)},
            {"cubes at an edge", CubesAtAnEdge()},
            {"spheres at an edge", SpheresAtAnEdge(7, 100)},
            {"every face twice", twice},
            {"bow tie", BowTie()},
            {"quads", Noisy(Box(4, 1, true), .05)},
            {"quads and triangles", Merged(Noisy(Torus(12, 8, 1, .4, true), .02), Noisy(Icosphere(1), .1))},
            {"inconsistent orientation", flipped},
            {"isolated vertices", WithIsolatedVertices(Noisy(Icosphere(1), .1), 3)},
            {"degenerate faces", WithDegenerateFaces(Noisy(Icosphere(1), .1))},
            {"one triangle", [] {
                 IndexedMesh m = Grid(1, 1);
                 m.triangles.pop_back();
                 return m;
             }()}};
}

std::vector<double> Values(const IndexedMesh& source, Descriptor kind, bool single)
{
    if (single) {
        FloatMesh mesh;
        Fill(mesh, source);
        return ComputeDescriptor(mesh, kind);
    }
    DoubleMesh mesh;
    Fill(mesh, source);
    return ComputeDescriptor(mesh, kind);
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::isfinite(a[i] - b[i])
                                        ? std::fabs(a[i] - b[i]) / std::max(1.0, std::fabs(a[i]))
                                        : std::numeric_limits<double>::infinity());
    return largest;
}

/// A mesh in single precision; nothing follows the last coordinate.
struct SingleMesh {
    std::vector<std::array<float, 3>> positions;
    MeshView view;

    explicit SingleMesh(const IndexedMesh& mesh) : view(View(mesh))
    {
        for (const Point& p : mesh.points)
            positions.push_back(
                {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
        positions.shrink_to_fit();
        view.positions = positions.data();
        view.positionStride = sizeof(positions.front());
        view.doublePositions = false;
    }
};

/// The largest difference of the one pass over the faces from the walk around every vertex, in double
/// precision and in single.
double DifferenceFromTheRings(const IndexedMesh& mesh)
{
    const MeshView view = View(mesh);
    const SingleMesh single(mesh);
    return std::max(
        LargestDifference(OneRingDescriptor<LaplacianFold>(view), LaplacianDescriptor(view)),
        LargestDifference(OneRingDescriptor<LaplacianFold>(single.view), LaplacianDescriptor(single.view)));
}

const std::vector<Descriptor> kOneRingKinds{Descriptor::Laplacian, Descriptor::NormalizedUmbrella,
                                            Descriptor::CurvatureEstimation};

} // namespace

class TestDescriptor : public QObject
{
    Q_OBJECT

  private slots:
    void everyFamilyAsDefined();
    void onePassIsWhatTheRingsGive();
    void edgesOfTwicePairedFacesAreFound();
    void valenceMayBeAny();
    void sliversAndUnitsMayBeAny();
    void normalsThatNearlyCancelAreAddedUpByTheirRings();
    void rowsAreInTheOrderOfTheEnum();
    void flatIsZero();
    void pyramidHasItsClosedForm();
    void sphereHasCurvatureOne();
    void boxKnowsCornersEdgesAndSides();
    void nonManifoldEdgesCountTheirNeighbourOnce();
    void diagonalsAreNoNeighbours();
    void sameAtEveryPlaceAndScale();
    void sameOnEveryKindOfMesh();
    void sameBytesForEveryNumberOfThreadsAndLanes();
    void deletedElementsDoNotCount();
    void emptyMeshHasNone();
    void rescalingMapsThePercentileToOne();
    void rescalingRefusesByName();
};

void TestDescriptor::everyFamilyAsDefined()
{
    for (const auto& [name, mesh] : Families()) {
        const auto expected = ByDefinition(mesh);
        for (std::size_t i = 0; i < kOneRingKinds.size(); ++i) {
            const double difference = LargestDifference(expected[i], Values(mesh, kOneRingKinds[i], false));
            QVERIFY2(difference < kRounding,
                     qPrintable(QString("%1, %2: %3").arg(name).arg(i).arg(difference)));
        }
    }
}

void TestDescriptor::onePassIsWhatTheRingsGive()
{
    for (const auto& [name, mesh] : Families()) {
        const double difference = DifferenceFromTheRings(mesh);
        QVERIFY2(difference < kRounding, qPrintable(QString("%1: %2").arg(name).arg(difference)));
    }
}

void TestDescriptor::edgesOfTwicePairedFacesAreFound()
{
    // Counted by its faces the other end of the edge would weigh twice: that is far more than rounding.
    for (std::size_t face = 0; face < 320; face += 3) {
        const IndexedMesh mesh = SpheresAtAnEdge(face, (7 * face + 11) % 320);
        QVERIFY2(DifferenceFromTheRings(mesh) < kRounding, qPrintable(QString::number(face)));
    }
}

void TestDescriptor::valenceMayBeAny()
{
    for (const int sides : {3, 4, 5, 6, 7, 8, 9, 12, 16, 24, 40, 63, 64, 65, 100, 1000})
        for (const IndexedMesh& mesh : {Bipyramid(sides), Noisy(Pyramid(sides), 1e-4)})
            QVERIFY2(DifferenceFromTheRings(mesh) < kRounding, qPrintable(QString::number(sides)));
}

void TestDescriptor::sliversAndUnitsMayBeAny()
{
    // A face's normal is rounded by 6e-8 over the sine of the corner that it is taken from; below .01 the
    // rings decide.
    for (const double stretch : {1.0, 3.0, 30.0, 1e3, 1e5})
        for (const double scale : {1e-15, 1e-11, 1e-8, 1e-3, 1.0, 1e6, 1e8, 1e9, 1e10, 1e15}) {
            const IndexedMesh mesh = Moved(Slivers(stretch), 0, scale, {0, 0, 0});
            const double difference = DifferenceFromTheRings(mesh);
            QVERIFY2(difference < 20 * kRounding,
                     qPrintable(QString("%1 times, unit %2: %3").arg(stretch).arg(scale).arg(difference)));
        }
}

void TestDescriptor::normalsThatNearlyCancelAreAddedUpByTheirRings()
{
    // Around an apex of a narrow bipyramid next to nothing is left of the normals' sum.
    for (const double narrow : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        IndexedMesh mesh = Bipyramid(7);
        for (Point& p : mesh.points) p = {narrow * p[0], narrow * p[1], p[2] < 0 ? .5 * p[2] : p[2]};
        const double difference = DifferenceFromTheRings(Moved(mesh, .7, 1, {.1, .2, .3}));
        QVERIFY2(difference < kRounding, qPrintable(QString("%1: %2").arg(narrow).arg(difference)));
    }
}

void TestDescriptor::rowsAreInTheOrderOfTheEnum()
{
    for (std::size_t i = 0; i < std::size(kDescriptors); ++i)
        QCOMPARE(static_cast<std::size_t>(kDescriptors[i].kind), i);
}

void TestDescriptor::flatIsZero()
{
    // exactly in the plane z = 0, within rounding in any other; the border is flat, too (Gaussian aside)
    for (const bool quads : {false, true})
        for (const auto& row : kDescriptors) {
            const IndexedMesh grid = Grid(8, 6, .5, quads);
            const auto flat = Values(grid, row.kind, false);
            const auto tilted = Values(Moved(grid, 1, 1, {0, 0, 0}), row.kind, false);
            for (int j = 0; j <= 6; ++j)
                for (int i = 0; i <= 8; ++i) {
                    const bool border = i == 0 || j == 0 || i == 8 || j == 6;
                    const bool gaussian = row.kind == Descriptor::GaussianCurvature;
                    const bool mean = row.kind == Descriptor::MeanCurvature;
                    if (border && (gaussian || mean)) continue; // VCG: cotangent sums do not close there
                    const auto v = static_cast<std::size_t>(i) + 9 * static_cast<std::size_t>(j);
                    // angle sums of VCG pass through single precision: 2 pi * 6e-8 over an area of .25
                    QVERIFY2(flat[v] <= (gaussian ? 5e-6 : mean ? 1e-12 : 0), row.id);
                    QVERIFY2(tilted[v] <= (gaussian ? 5e-6 : kRounding), row.id);
                }
        }
}

void TestDescriptor::pyramidHasItsClosedForm()
{
    for (const int sides : {3, 4, 5, 6, 7, 8, 9, 12, 64}) {
        const double radius = 1.5, height = .75;
        const IndexedMesh mesh = Pyramid(sides, radius, height);
        const double edge =
            std::hypot(radius, height); // all edges at the apex, which lies height above their ends
        for (const bool single : {true, false}) {
            const auto at = [&](Descriptor kind) { return Values(mesh, kind, single).front(); };
            QVERIFY(std::fabs(at(Descriptor::Laplacian) - height / edge) < kRounding);
            QVERIFY(std::fabs(at(Descriptor::NormalizedUmbrella) - height / edge) < kRounding);
            QVERIFY(std::fabs(at(Descriptor::CurvatureEstimation) - 2 * height / (edge * edge)) < kRounding);
        }
    }
}

void TestDescriptor::sphereHasCurvatureOne()
{
    // On the unit sphere a chord e to a neighbour has height |e|^2 / 2 below the tangent plane, so curvature
    // estimation is 1 exactly but for the tilt of the normal; the others differ by the square of the edge
    // length (.07 at level 4, where the angle is 4 degrees).
    const IndexedMesh sphere = Icosphere(4);
    for (const double k : Values(sphere, Descriptor::CurvatureEstimation, false))
        QVERIFY(std::fabs(k - 1) < 2e-3);
    for (const double h : Values(sphere, Descriptor::MeanCurvature, false)) QVERIFY(std::fabs(h - 1) < 5e-3);
    for (const double k : Values(sphere, Descriptor::GaussianCurvature, false))
        QVERIFY(std::fabs(k - 1) < 2e-2);
    for (const double h : Values(Moved(sphere, 1, 4, {9, 9, 9}), Descriptor::MeanCurvature, true))
        QVERIFY(std::fabs(h - .25) < 2e-3);
    for (const double k : Values(Moved(sphere, 1, 4, {9, 9, 9}), Descriptor::GaussianCurvature, false))
        QVERIFY(std::fabs(k - 1. / 16) < 2e-3);
}

void TestDescriptor::boxKnowsCornersEdgesAndSides()
{
    const IndexedMesh box = Box(6, 2, true);
    const auto l = Values(box, Descriptor::Laplacian, false);
    for (std::size_t v = 0; v < box.points.size(); ++v) {
        int extremes = 0;
        for (const double x : box.points[v]) extremes += x == 0 || x == 2;
        // quads: the neighbours of a corner lie 1 / sqrt 3 below it, two of an edge's four 1 / sqrt 2
        const double expected = extremes == 3 ? 1 / std::sqrt(3.0) : extremes == 2 ? 1 / std::sqrt(8.0) : 0;
        // the normal of a corner leans a little to the sides that its diagonals cut: chords of angles do not
        // add
        QVERIFY(std::fabs(l[v] - expected) < (extremes == 3 ? 1e-3 : kRounding));
    }
}

void TestDescriptor::nonManifoldEdgesCountTheirNeighbourOnce()
{
    for (const int pages : {3, 4, 5, 6, 8}) {
        const IndexedMesh book = Noisy(Book(pages), .3);
        const auto expected = ByDefinition(book)[0];
        QVERIFY(expected[0] > .01 && expected[1] > .01); // the ends of the spine
        QVERIFY(LargestDifference(expected, Values(book, Descriptor::Laplacian, false)) < kRounding);
    }
}

void TestDescriptor::diagonalsAreNoNeighbours()
{
    const IndexedMesh quads = Noisy(Torus(16, 10, 1, .4, true), .03);
    IndexedMesh triangles = quads;
    triangles.fauxEdges.clear();
    // the same surface: only who is a neighbour differs
    QVERIFY(LargestDifference(Values(quads, Descriptor::Laplacian, false), ByDefinition(quads)[0]) <
            kRounding);
    QVERIFY(LargestDifference(Values(triangles, Descriptor::Laplacian, false), ByDefinition(quads)[0]) > .01);
}

void TestDescriptor::sameAtEveryPlaceAndScale()
{
    const IndexedMesh mesh = Noisy(Merged(Torus(24, 16), Grid(5, 5, .2)), .02);
    const double diagonal = 3; // of the box, about
    for (const bool single : {true, false}) {
        // A coordinate is rounded by eps * distance; edges are at least .02 long, so their directions, and
        // with them l, move by no more than a few times this over .02.
        const double eps = single ? std::ldexp(1, -24) : std::ldexp(1, -53);
        for (const double scale : {1e-3, 1.0, 1e6})
            for (const double distance : {0.0, single ? 1e3 : 1e6}) {
                const double shift = distance * diagonal * scale;
                const double tolerance = kRounding + 8 * eps * (distance + 1) * diagonal / .02;
                const IndexedMesh moved = Moved(mesh, .7, scale, {shift, -shift, shift});
                for (const Descriptor kind : {Descriptor::Laplacian, Descriptor::NormalizedUmbrella}) {
                    const double difference =
                        LargestDifference(Values(mesh, kind, false), Values(moved, kind, single));
                    QVERIFY2(difference < tolerance, qPrintable(QString("scale %1, distance %2: %3 > %4")
                                                                    .arg(scale)
                                                                    .arg(distance)
                                                                    .arg(difference)
                                                                    .arg(tolerance)));
                }
            }
    }
    auto curvature = Values(Moved(mesh, .7, 1e6, {0, 0, 0}), Descriptor::CurvatureEstimation, false);
    for (double& k : curvature) k *= 1e6;
    QVERIFY(LargestDifference(Values(mesh, Descriptor::CurvatureEstimation, false), curvature) <
            10 * kRounding);
}

void TestDescriptor::sameOnEveryKindOfMesh()
{
    const IndexedMesh source = Noisy(Box(4, 1, true), .05);
    OcfMesh mesh;
    Fill(mesh, source);
    for (const auto& row : kDescriptors) {
        const auto reference = ComputeDescriptor(View(source), row.kind);
        if (row.kind == Descriptor::Laplacian || row.kind == Descriptor::NormalizedUmbrella)
            QVERIFY(LargestDifference(reference, ByDefinition(source)[0]) > 1e-3); // a view knows no polygons
        const double tolerance = row.kind == Descriptor::GaussianCurvature ? 1e-4 : 1e-5; // single precision
        QVERIFY2(LargestDifference(Values(source, row.kind, false), ComputeDescriptor(mesh, row.kind)) <
                     tolerance,
                 row.id);
    }
}

void TestDescriptor::sameBytesForEveryNumberOfThreadsAndLanes()
{
    for (const auto& [name, source] : Families()) {
        const MeshView view = View(source);
        const SingleMesh single(source);
        const auto inDouble = LaplacianDescriptorOf<double>(view, 1, false);
        const auto inSingle = LaplacianDescriptorOf<float>(single.view, 1, false);
        QVERIFY2(LaplacianDescriptorOf<double>(view, 1, HasAvx2()) == inDouble, name);
        QVERIFY2(LaplacianDescriptorOf<float>(single.view, 1, HasAvx2()) == inSingle, name);
        for (const int threads : {2, 3, 7}) {
            QVERIFY2(LaplacianDescriptorOf<double>(view, threads, HasAvx2()) == inDouble, name);
            QVERIFY2(LaplacianDescriptorOf<float>(single.view, threads, HasAvx2()) == inSingle, name);
            const OneRings rings(view), together(view, threads);
            for (std::size_t v = 0; v < source.points.size(); ++v)
                QVERIFY2(std::equal(rings.Corners(v).begin(), rings.Corners(v).end(),
                                    together.Corners(v).begin(), together.Corners(v).end(),
                                    [](const RingCorner& a, const RingCorner& b) {
                                        return a.next == b.next && a.previous == b.previous;
                                    }),
                         name);
        }
    }
    const IndexedMesh large = Noisy(Torus(600, 450), 1e-4); // enough faces for three threads
    for (const Descriptor kind : kOneRingKinds)
        QVERIFY(ComputeDescriptor(View(large), kind, 1) == ComputeDescriptor(View(large), kind, 3));
}

void TestDescriptor::deletedElementsDoNotCount()
{
    const IndexedMesh source = Merged(Noisy(Icosphere(1), .1), Noisy(Grid(4, 4, 1, true), .1));
    DoubleMesh mesh;
    Fill(mesh, source);
    const std::size_t kept = Icosphere(1).points.size();
    for (auto& face : mesh.face)
        if (vcg::tri::Index(mesh, face.V(0)) >= kept) vcg::tri::Allocator<DoubleMesh>::DeleteFace(mesh, face);
    for (std::size_t v = kept; v < mesh.vert.size(); ++v)
        vcg::tri::Allocator<DoubleMesh>::DeleteVertex(mesh, mesh.vert[v]);
    for (const auto& row : kDescriptors) {
        auto expected = Values(Noisy(Icosphere(1), .1), row.kind, false);
        expected.resize(source.points.size(), 0);
        QVERIFY2(LargestDifference(expected, ComputeDescriptor(mesh, row.kind)) < 1e-9, row.id);
    }
}

void TestDescriptor::emptyMeshHasNone()
{
    for (const auto& row : kDescriptors) {
        QVERIFY(Values({}, row.kind, false).empty());
        QCOMPARE(Values(WithIsolatedVertices({}, 2), row.kind, true), (std::vector<double>{0, 0}));
        IndexedMesh point = Icosphere(0); // all vertices coincide
        for (auto& p : point.points) p = {1, 2, 3};
        for (const double value : Values(point, row.kind, true)) QCOMPARE(value, 0.0);
    }
}

void TestDescriptor::rescalingMapsThePercentileToOne()
{
    std::vector<double> values(10001);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 2 + .5 * static_cast<double>(i);
    std::shuffle(values.begin(), values.end(), std::mt19937(1));
    values[17] = 1e9;
    const auto unit = RescaledToUnit(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double expected = std::min(1.0, (values[i] - 2) / (.5 * 9990));
        QVERIFY(std::fabs(unit[i] - expected) < 2e-4); // one value was lost to the outlier
    }
    QCOMPARE(*std::max_element(unit.begin(), unit.end()), 1.0);
    QCOMPARE(*std::min_element(unit.begin(), unit.end()), 0.0);
    QCOMPARE(RescaledToUnit({3, 3, 3}), (std::vector<double>{0, 0, 0}));
    QCOMPARE(RescaledToUnit({}), std::vector<double>{});
    std::vector<double> rare(5000, 1);
    rare[9] = 2; // rarer than one in a thousand, and still the only feature
    QCOMPARE(RescaledToUnit(rare)[9], 1.0);
    QCOMPARE(RescaledToUnit(rare)[8], 0.0);
    QCOMPARE(RescaledToUnit({0, 1, 4}, 50), (std::vector<double>{0, 1, 1}));
}

void TestDescriptor::rescalingRefusesByName()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_EXCEPTION_THROWN(RescaledToUnit({1, 2}, 0), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(RescaledToUnit({1, 2}, nan), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(RescaledToUnit({1, nan}), std::invalid_argument);
}

QTEST_APPLESS_MAIN(TestDescriptor)
#include "test_descriptors.moc"
