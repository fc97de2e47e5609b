// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analytic_meshes.h"
#include "test_meshes.h"
#include "vcg_ext/core/mesh/edge_counts.h"
#include "vcg_ext/refine_mesh.h"
#include "vcg_ext/core/refine/refine.h"

using namespace test_meshes;
using vcg_ext::Buffer;
using vcg_ext::RefinementParameters;
using vcg_ext::RefinementReport;
using vcg_ext::SurfaceArrays;
using vcg_ext::Vector3;

namespace
{

/// An original and a simplified surface in one frame, with the nearest vertices as the collapse map.
struct Pair {
    SurfaceArrays original, simplified;
    Buffer<std::uint32_t> root;
};

Pair MakePair(const IndexedMesh& original, const IndexedMesh& simplified,
              const std::vector<std::uint8_t>& fixed = {})
{
    const vcg_ext::SurfaceFrame frame = vcg_ext::FrameOf(View(original));
    vcg_ext::MeshView view = View(simplified);
    if (!fixed.empty()) view.fixedVertices = fixed.data();
    Pair pair{vcg_ext::BuildSurfaceArrays(View(original), frame), vcg_ext::BuildSurfaceArrays(view, frame),
              Buffer<std::uint32_t>(original.points.size())};
    for (std::uint32_t v = 0; v < original.points.size(); ++v) {
        float nearest = std::numeric_limits<float>::max();
        pair.root[v] = vcg_ext::refinement::kNone;
        for (std::uint32_t w = 0; w < simplified.points.size(); ++w) {
            const float d = SquaredNorm(PositionOf(pair.original, v) - PositionOf(pair.simplified, w));
            if (pair.simplified.cornerCount[w] == 0 || d >= nearest) continue;
            nearest = d;
            pair.root[v] = w;
        }
    }
    return pair;
}

RefinementReport Refine(Pair& pair, const RefinementParameters& parameters = {})
{
    return vcg_ext::Refine(pair.original, pair.simplified, pair.root, parameters);
}

std::vector<unsigned char> Bytes(const SurfaceArrays& surface)
{
    std::vector<unsigned char> bytes;
    const auto append = [&](const auto& buffer) {
        const auto* data = reinterpret_cast<const unsigned char*>(buffer.data());
        bytes.insert(bytes.end(), data, data + buffer.size() * sizeof(*buffer.data()));
    };
    append(surface.points);
    append(surface.triangles);
    return bytes;
}

float ExactSquaredDistance(const Vector3<float>& p, const SurfaceArrays& surface)
{
    float nearest = std::numeric_limits<float>::max();
    for (const vcg_ext::SurfaceTriangle& t : surface.triangles) {
        const Vector3<float> a = PositionOf(surface, t.v[0]);
        const Vector3<float> b = PositionOf(surface, t.v[1]) - a, c = PositionOf(surface, t.v[2]) - a;
        nearest = std::min(nearest, vcg_ext::ClosestOnTriangle(p - a, b, c).distance2);
    }
    return nearest;
}

/// Root of the mean squared distance of vertices and face centroids to the other surface, by all faces.
double ExactRms(const SurfaceArrays& from, const SurfaceArrays& to)
{
    double sum = 0;
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < from.VertexCount(); ++v) {
        if (from.cornerCount[v] == 0) continue;
        sum += static_cast<double>(ExactSquaredDistance(PositionOf(from, v), to));
        ++count;
    }
    for (std::uint32_t f = 0; f < from.FaceCount(); ++f, ++count)
        sum += static_cast<double>(ExactSquaredDistance(Centroid(from, f), to));
    return std::sqrt(sum / static_cast<double>(count));
}
double ExactRms(const Pair& pair)
{
    return ExactRms(pair.original, pair.simplified) + ExactRms(pair.simplified, pair.original);
}

vcg_ext::EdgeCounts Edges(const SurfaceArrays& surface)
{
    return vcg_ext::CountEdges(surface.FaceCount(), [&](std::size_t f) { return surface.triangles[f].v; });
}

std::size_t DifferentFaces(const SurfaceArrays& surface)
{
    std::set<std::array<std::uint32_t, 3>> faces;
    for (const vcg_ext::SurfaceTriangle& t : surface.triangles) {
        std::array<std::uint32_t, 3> face{t.v[0], t.v[1], t.v[2]};
        std::sort(face.begin(), face.end());
        faces.insert(face);
    }
    return faces.size();
}

/// Do the lists name every corner once, at the vertex it belongs to?
bool CornersAreConsistent(const SurfaceArrays& surface)
{
    std::size_t corners = 0;
    for (std::uint32_t v = 0; v < surface.VertexCount(); ++v)
        for (const auto* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c, ++corners)
            if (surface.triangles[vcg_ext::FaceOf(*c)].v[vcg_ext::IndexOf(*c)] != v) return false;
    return corners == 3 * surface.FaceCount();
}

/// Meshes with every kind of place that the refinement must cope with, coarse and perturbed against fine.
struct Family {
    const char* name;
    IndexedMesh original, simplified;
};
std::vector<Family> Families()
{
    std::vector<Family> families;
    families.push_back({"sphere", Icosphere(3), Noisy(Icosphere(2), 0.05)});
    families.push_back({"box", Box(8), Noisy(Box(3), 0.04)});
    families.push_back({"torus", Torus(32, 16), Noisy(Torus(16, 8), 0.04)});
    families.push_back({"open cylinder", OpenCylinder(32, 16), Noisy(OpenCylinder(12, 6), 0.04)});
    families.push_back({"grid", Grid(20, 20, 0.05), Noisy(Grid(6, 6, 1 / 6.0), 0.02)});
    families.push_back({"book", Book(5), Noisy(Book(5), 0.05)});
    families.push_back({"bow tie", BowTie(), Noisy(BowTie(), 0.05)});
    families.push_back(
        {"two components and isolated vertices",
         WithIsolatedVertices(Merged(Icosphere(2), Moved(Icosphere(2), 1, 1, {3, 0, 0})), 3),
         WithIsolatedVertices(Noisy(Merged(Icosphere(1), Moved(Icosphere(1), 1, 1, {3, 0, 0})), 0.05), 2)});
    return families;
}

Vector3<float> RandomVector(std::mt19937& random, float size)
{
    const auto number = [&] { return size * (static_cast<float>(random()) / 2147483648.0F - 1); };
    const float x = number(), y = number();
    return {x, y, number()};
}

bool Near(float a, float b, float scale)
{
    return std::abs(a - b) <= 1e-4F * scale;
}

} // namespace

class TestRefinement : public QObject
{
    Q_OBJECT

  private slots:
    void closestPointsInFoursAreThoseOfThePlainForm();
    void closestPointOfADegenerateTriangleIsThatOfItsLongestEdge();
    void samplesShareTheWholeArea();
    void everySampleKnowsItsFaceAndItsDistance();
    void perturbedVerticesMoveBack_data();
    void perturbedVerticesMoveBack();
    void theErrorNeverRises();
    void topologyStays_data();
    void topologyStays();
    void noFaceTurns_data();
    void noFaceTurns();
    void noFaceComesToLookInwards();
    void borderAndFixedVerticesStay();
    void facesBetweenFixedVerticesStay();
    void flipsFollowTheRidge();
    void aSecondRunGainsLittle();
    void theSameSurfaceStaysAsItIs();
    void threadsDoNotChangeAByte();
    void starsOfAnySize();
    void degenerateFacesOfTheOriginalAreHarmless();
    void emptySurfacesAndMissingRoots();
    void progressCanStopIt();
    void meshesOfAnyTypeAreRefined();
};

void TestRefinement::closestPointsInFoursAreThoseOfThePlainForm()
{
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const Vector3<float> b = RandomVector(random, 1), c = RandomVector(random, 1);
        const auto prepared = vcg_ext::PrepareTriangle(b, c);
        vcg_ext::Vector3<vcg_ext::Float4> points{};
        std::array<Vector3<float>, 4> p;
        for (int lane = 0; lane < 4; ++lane) {
            p[static_cast<std::size_t>(lane)] = RandomVector(random, 2);
            points.x[lane] = p[static_cast<std::size_t>(lane)].x;
            points.y[lane] = p[static_cast<std::size_t>(lane)].y;
            points.z[lane] = p[static_cast<std::size_t>(lane)].z;
        }
        const auto four = ClosestOnTriangle(points, prepared);
        for (int lane = 0; lane < 4; ++lane) {
            const Vector3<float> query = p[static_cast<std::size_t>(lane)];
            const auto one = vcg_ext::ClosestOnTriangle(query, b, c);
            QVERIFY(Near(four.distance2[lane], one.distance2, 10));
            const float* w = one.weights;
            const Vector3<float> difference = query - w[1] * b - w[2] * c;
            QVERIFY(Near(four.difference.x[lane], difference.x, 10));
            QVERIFY(Near(four.difference.y[lane], difference.y, 10));
            QVERIFY(Near(four.difference.z[lane], difference.z, 10));
            if (prepared.quality > 0.01F) QVERIFY(Near(four.originWeight[lane], w[0], 100));
            const bool inside = w[0] > 1e-3F && w[1] > 1e-3F && w[2] > 1e-3F;
            if (inside && prepared.quality > 0.01F) QVERIFY(four.inside[lane] != 0);
            const float far2 = vcg_ext::ClosestOnTriangle(query - b, c - b, c - b).distance2;
            if (w[0] == 0 && prepared.quality > 0.01F) QVERIFY(four.onFarEdge[lane] != 0);
            if (four.onFarEdge[lane]) QVERIFY(far2 < one.distance2 * 1.001F + 1e-4F);
        }
    }
}

void TestRefinement::closestPointOfADegenerateTriangleIsThatOfItsLongestEdge()
{
    const std::array<std::pair<Vector3<float>, Vector3<float>>, 4> triangles{
        {{{1, 0, 0}, {2, 0, 0}}, {{2, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {2, 0, 0}}, {{2, 0, 0}, {0, 0, 0}}}};
    for (const auto& [b, c] : triangles) {
        const auto plain = vcg_ext::ClosestOnTriangle({1.5F, 1, 0}, b, c);
        QCOMPARE(plain.distance2, 1.0F);
        const vcg_ext::Vector3<vcg_ext::Float4> p{vcg_ext::Splat(1.5F), vcg_ext::Splat(1.0F),
                                                  vcg_ext::Splat(0.0F)};
        const auto four = ClosestOnTriangle(p, vcg_ext::PrepareTriangle(b, c));
        QCOMPARE(four.distance2[0], 1.0F);
        QVERIFY(!four.inside[0]);
    }
}

void TestRefinement::samplesShareTheWholeArea()
{
    Pair pair = MakePair(Icosphere(3), Icosphere(1));
    double area = 0;
    for (std::uint32_t f = 0; f < pair.original.FaceCount(); ++f)
        area += 0.5 * static_cast<double>(Norm(AreaVector(pair.original, f)));
    for (const float perFace : {1000.0F, 8.0F}) {
        RefinementParameters parameters;
        parameters.samplesPerFace = perFace;
        const auto lists =
            vcg_ext::refinement::AttachSamples(pair.original, pair.simplified, pair.root, parameters);
        double weight = 0;
        for (const auto& sample : lists.samples) weight += static_cast<double>(sample.weight);
        QVERIFY(std::abs(weight / area - 1) < 0.03);
        QCOMPARE(lists.samples.size() == 642 + 1280, perFace == 1000.0F);
    }
}

void TestRefinement::everySampleKnowsItsFaceAndItsDistance()
{
    for (const Family& family : Families()) {
        using namespace vcg_ext::refinement;
        Pair pair = MakePair(family.original, family.simplified);
        SurfaceArrays& surface = pair.simplified;
        vcg_ext::MakeRoomForCorners(surface, vcg_ext::kFlipRoom);
        const RefinementParameters parameters;
        State state{pair.original,
                    surface,
                    parameters,
                    AttachSamples(pair.original, surface, pair.root, parameters),
                    NoHints(surface.VertexCount()),
                    NoHints(3 * surface.FaceCount()),
                    NoHints(surface.FaceCount())};
        state.meanSquare = static_cast<float>(MeanSquare(state.samples));
        FlipEdges(state, 1);
        MoveVertices(state, 1);
        std::vector<int> listed(state.samples.samples.size(), 0);
        for (std::uint32_t f = 0; f < surface.FaceCount(); ++f) {
            for (std::uint32_t i = state.samples.faces[f].first; i != kNone;
                 i = state.samples.samples[i].next) {
                const Sample& sample = state.samples.samples[i];
                QCOMPARE(sample.face, f);
                ++listed[i];
                const auto& t = surface.triangles[f];
                const Vector3<float> a = PositionOf(surface, t.v[0]);
                const auto closest = vcg_ext::ClosestOnTriangle(
                    PositionOf(sample) - a, PositionOf(surface, t.v[1]) - a, PositionOf(surface, t.v[2]) - a);
                QVERIFY(std::abs(std::sqrt(sample.distance2) - std::sqrt(closest.distance2)) < 0.05F);
            }
        }
        QVERIFY2(std::all_of(listed.begin(), listed.end(), [](int n) { return n == 1; }), family.name);
    }
}

void TestRefinement::perturbedVerticesMoveBack_data()
{
    QTest::addColumn<int>("family");
    QTest::addColumn<double>("atMost"); // of the error before
    QTest::newRow("sphere") << 0 << 0.75;
    QTest::newRow("box") << 1 << 0.6;
    QTest::newRow("torus") << 2 << 0.75;
    QTest::newRow("open cylinder") << 3 << 0.9;
    QTest::newRow("grid") << 4 << 0.8;
}

void TestRefinement::perturbedVerticesMoveBack()
{
    QFETCH(int, family);
    QFETCH(double, atMost);
    const Family meshes = Families()[static_cast<std::size_t>(family)];
    Pair pair = MakePair(meshes.original, meshes.simplified);
    const double before = ExactRms(pair);
    const RefinementReport report = Refine(pair);
    const double after = ExactRms(pair);
    QVERIFY(report.moves > 0);
    QVERIFY(report.rmsAfter < report.rmsBefore);
    QVERIFY2(after < atMost * before, qPrintable(QString("%1 of before").arg(after / before)));
}

void TestRefinement::theErrorNeverRises()
{
    for (const Family& family : Families()) {
        for (const bool flip : {false, true}) {
            Pair pair = MakePair(family.original, family.simplified);
            RefinementParameters parameters;
            parameters.flip = flip;
            parameters.moveSweeps = 1;
            double last = ExactRms(pair);
            for (int run = 0; run < 3; ++run) {
                Refine(pair, parameters);
                const double now = ExactRms(pair);
                QVERIFY2(now <= last, family.name);
                last = now;
            }
        }
    }
}

void TestRefinement::topologyStays_data()
{
    QTest::addColumn<int>("family");
    const auto families = Families();
    for (std::size_t i = 0; i < families.size(); ++i) QTest::newRow(families[i].name) << static_cast<int>(i);
}

void TestRefinement::topologyStays()
{
    QFETCH(int, family);
    const Family meshes = Families()[static_cast<std::size_t>(family)];
    Pair pair = MakePair(meshes.original, meshes.simplified);
    const auto before = Edges(pair.simplified);
    Refine(pair);
    const auto after = Edges(pair.simplified);
    QCOMPARE(after.boundary, before.boundary);
    QCOMPARE(after.nonManifold, before.nonManifold);
    QCOMPARE(DifferentFaces(pair.simplified), meshes.simplified.triangles.size());
    QVERIFY(CornersAreConsistent(pair.simplified));
    for (std::uint32_t f = 0; f < pair.simplified.FaceCount(); ++f)
        QVERIFY(Norm(AreaVector(pair.simplified, f)) > 0);
}

void TestRefinement::noFaceTurns_data()
{
    topologyStays_data();
}

void TestRefinement::noFaceTurns()
{
    QFETCH(int, family);
    const Family meshes = Families()[static_cast<std::size_t>(family)];
    Pair pair = MakePair(meshes.original, meshes.simplified);
    std::vector<Vector3<float>> before;
    for (std::uint32_t f = 0; f < pair.simplified.FaceCount(); ++f)
        before.push_back(AreaVector(pair.simplified, f));
    RefinementParameters parameters;
    parameters.flip = false;
    Refine(pair, parameters);
    for (std::uint32_t f = 0; f < pair.simplified.FaceCount(); ++f)
        QVERIFY(Dot(AreaVector(pair.simplified, f), before[f]) > 0);
}

void TestRefinement::noFaceComesToLookInwards()
{
    const auto inwards = [](const SurfaceArrays& sphere) {
        std::size_t count = 0;
        for (std::uint32_t f = 0; f < sphere.FaceCount(); ++f)
            count += Dot(AreaVector(sphere, f), Centroid(sphere, f)) < 0 ? 1 : 0;
        return count;
    };
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Pair pair = MakePair(Icosphere(3), Noisy(Icosphere(2), 0.2, seed)); // noise folds some faces
        const std::size_t before = inwards(pair.simplified);
        QVERIFY(Refine(pair).moves > 0);
        QVERIFY(inwards(pair.simplified) <= before);
    }
}

void TestRefinement::borderAndFixedVerticesStay()
{
    for (const Family& family : Families()) {
        std::vector<std::uint8_t> fixed(family.simplified.points.size(), 0);
        for (std::size_t v = 0; v < fixed.size(); v += 3) fixed[v] = 1;
        Pair pair = MakePair(family.original, family.simplified, fixed);
        std::vector<Vector3<float>> before;
        for (std::uint32_t v = 0; v < fixed.size(); ++v) before.push_back(PositionOf(pair.simplified, v));
        Refine(pair);
        for (std::uint32_t v = 0; v < fixed.size(); ++v) {
            const Vector3<float> now = PositionOf(pair.simplified, v);
            const bool same = now.x == before[v].x && now.y == before[v].y && now.z == before[v].z;
            const std::uint8_t flags = pair.simplified.flags[v];
            if (flags & (vcg_ext::kBorderVertex | vcg_ext::kFixedVertex)) QVERIFY(same);
            QCOMPARE((flags & vcg_ext::kMovedVertex) != 0, !same);
        }
    }
}

void TestRefinement::facesBetweenFixedVerticesStay()
{
    // The half x < 0 of the sphere is outside a selection: its faces' vertices are fixed.
    const IndexedMesh coarse = Noisy(Icosphere(2), 0.1);
    std::vector<std::uint8_t> fixed(coarse.points.size(), 0);
    std::vector<bool> outside;
    for (const Triangle& t : coarse.triangles) {
        outside.push_back(coarse.points[t[0]][0] + coarse.points[t[1]][0] + coarse.points[t[2]][0] < 0);
        if (outside.back())
            for (const std::uint32_t v : t) fixed[v] = 1;
    }
    Pair pair = MakePair(Icosphere(3), coarse, fixed);
    const RefinementReport report = Refine(pair);
    QVERIFY(report.flips > 0 && report.moves > 0);
    for (std::size_t f = 0; f < outside.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            if (outside[f]) QCOMPARE(pair.simplified.triangles[f].v[k], coarse.triangles[f][k]);
}

void TestRefinement::flipsFollowTheRidge()
{
    // A roof of slope 1 over y = 0.5; the coarse one has every diagonal of its middle row across the ridge.
    const auto roof = [](IndexedMesh mesh) {
        for (Point& p : mesh.points) p[2] = 0.5 - std::abs(p[1] - 0.5);
        return mesh;
    };
    IndexedMesh coarse = roof(Grid(6, 4, 0.25));
    for (Point& p : coarse.points) p[0] *= 2.0 / 3;
    for (Triangle& t : coarse.triangles)
        std::rotate(t.begin(), t.begin() + 1, t.end()); // another first corner must not matter
    // Flip the ridge's edges the wrong way: (a, b, c), (b, a, d) become (a, d, c), (b, c, d).
    std::size_t wrong = 0;
    for (std::size_t f = 0; f < coarse.triangles.size(); ++f)
        for (std::size_t g = f + 1; g < coarse.triangles.size(); ++g)
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t l = 0; l < 3; ++l) {
                    auto &s = coarse.triangles[f], &t = coarse.triangles[g];
                    const std::uint32_t a = s[k], b = s[(k + 1) % 3], c = s[(k + 2) % 3], d = t[(l + 2) % 3];
                    const bool common = t[l] == b && t[(l + 1) % 3] == a;
                    const bool ridge = coarse.points[a][1] == 0.5 && coarse.points[b][1] == 0.5;
                    const bool inner = coarse.points[a][0] > 0 && coarse.points[b][0] > 0;
                    if (!common || !ridge || !inner || wrong == 2) continue;
                    s = {a, d, c};
                    t = {b, c, d};
                    ++wrong;
                }
    QCOMPARE(wrong, std::size_t{2});
    Pair pair = MakePair(roof(Grid(40, 40, 0.025)), coarse);
    const RefinementReport report = Refine(pair);
    QVERIFY(report.flips >= 2);
    QVERIFY2(report.rmsAfter < 0.05 * report.rmsBefore,
             qPrintable(QString("%1 -> %2").arg(report.rmsBefore).arg(report.rmsAfter)));
}

void TestRefinement::aSecondRunGainsLittle()
{
    Pair pair = MakePair(Icosphere(3), Noisy(Icosphere(1), 0.1));
    RefinementParameters parameters;
    parameters.moveSweeps = 100;
    const RefinementReport first = Refine(pair, parameters);
    QVERIFY(first.sweeps < 100); // it stopped because nothing was gained any more
    const RefinementReport second = Refine(pair, parameters);
    QVERIFY(second.rmsAfter <= first.rmsAfter * 1.01);
    QVERIFY(second.rmsAfter > 0.8 * first.rmsAfter);
}

void TestRefinement::theSameSurfaceStaysAsItIs()
{
    for (const Family& family : Families()) {
        Pair pair = MakePair(family.original, family.original);
        const auto before = Bytes(pair.simplified);
        const RefinementReport report = Refine(pair);
        QCOMPARE(report.moves + report.flips, std::size_t{0});
        QVERIFY(Bytes(pair.simplified) == before);
    }
}

void TestRefinement::threadsDoNotChangeAByte()
{
    for (const Family& family : Families()) {
        std::vector<unsigned char> expected;
        for (const int threads : {1, 2, 3, 7}) {
            Pair pair = MakePair(family.original, family.simplified);
            RefinementParameters parameters;
            parameters.threads = threads;
            parameters.blockVertices = 20; // many seams
            Refine(pair, parameters);
            if (threads == 1) expected = Bytes(pair.simplified);
            QVERIFY2(Bytes(pair.simplified) == expected, family.name);
        }
    }
}

void TestRefinement::starsOfAnySize()
{
    const auto cone = [](int sides, double height) {
        IndexedMesh mesh = Pyramid(sides, 1, height); // and a lower tip that closes it
        mesh.points.push_back({0, 0, -1});
        const std::size_t tip = mesh.points.size() - 1;
        for (std::size_t i = 0; i < static_cast<std::size_t>(sides); ++i)
            mesh.AddTriangle(tip, 1 + (i + 1) % static_cast<std::size_t>(sides), 1 + i);
        return mesh;
    };
    Pair pair = MakePair(cone(700, 1), cone(650, 1.2));
    const double before = ExactRms(pair);
    const RefinementReport report = Refine(pair);
    QVERIFY(report.moves > 0);
    QVERIFY(ExactRms(pair) < before);
    QVERIFY(CornersAreConsistent(pair.simplified));
    QCOMPARE(Edges(pair.simplified).nonManifold, std::size_t{0});
}

void TestRefinement::degenerateFacesOfTheOriginalAreHarmless()
{
    IndexedMesh original = Icosphere(2);
    original.AddTriangle(0, 0, 1);
    original.AddTriangle(5, 5, 5);
    original.points.push_back(original.points[0]);
    original.AddTriangle(0, original.points.size() - 1, 11);
    Pair pair = MakePair(original, Noisy(Icosphere(1), 0.05));
    const RefinementReport report = Refine(pair);
    QVERIFY(report.rmsAfter < report.rmsBefore);
    for (const auto& p : pair.simplified.points) QVERIFY(std::isfinite(p.x + p.y + p.z));

    IndexedMesh simplified = Noisy(Icosphere(1), 0.05);
    simplified.AddTriangle(0, 1, 0);
    Pair other = MakePair(Icosphere(2), simplified);
    Refine(other);
    for (const auto& p : other.simplified.points) QVERIFY(std::isfinite(p.x + p.y + p.z));
}

void TestRefinement::emptySurfacesAndMissingRoots()
{
    Pair nothing = MakePair(Icosphere(1), IndexedMesh{});
    QCOMPARE(Refine(nothing).samples, std::size_t{0});
    Pair alone = MakePair(IndexedMesh{}, Icosphere(1));
    QCOMPARE(Refine(alone).moves, std::size_t{0});
    Pair rootless = MakePair(Icosphere(2), Noisy(Icosphere(1), 0.05));
    std::fill(rootless.root.begin(), rootless.root.end(), vcg_ext::refinement::kNone);
    const RefinementReport report = Refine(rootless);
    QCOMPARE(report.samples, std::size_t{0});
    QCOMPARE(report.moves, std::size_t{0});
}

void TestRefinement::progressCanStopIt()
{
    Pair pair = MakePair(Icosphere(2), Noisy(Icosphere(1), 0.05));
    int last = -1;
    RefinementParameters parameters;
    parameters.progress = [&](int percent, const char*) {
        const bool ascending = percent > last && percent <= 100;
        last = percent;
        return ascending && percent < 40;
    };
    const RefinementReport report = Refine(pair, parameters);
    QVERIFY(report.cancelled);
    QCOMPARE(report.moves, std::size_t{0});
    QVERIFY(CornersAreConsistent(pair.simplified));
}

void TestRefinement::meshesOfAnyTypeAreRefined()
{
    DoubleMesh original;
    Fill(original, Icosphere(3));
    FloatMesh simplified;
    Fill(simplified, WithIsolatedVertices(Noisy(Icosphere(2), 0.05), 2));
    vcg::tri::Allocator<FloatMesh>::DeleteFace(simplified, simplified.face[7]); // a hole: its corners stay
    const std::size_t faces = static_cast<std::size_t>(simplified.fn);
    const vcg::Point3f corner = simplified.face[7].P(0), isolated = simplified.vert.back().P();
    std::vector<std::uint8_t> fixed(simplified.vert.size(), 0);
    fixed[100] = 1;
    const vcg::Point3f fixedPoint = simplified.vert[100].P();

    const auto error = [&] {
        double sum = 0;
        for (const auto& v : simplified.vert)
            if (&v < &simplified.vert[162]) sum += std::abs(static_cast<double>(v.cP().Norm()) - 1);
        return sum;
    };
    const double before = error();
    const RefinementReport report = vcg_ext::RefineMesh(simplified, original, {}, fixed);
    QVERIFY(report.moves > 0 && report.rmsAfter < 0.8 * report.rmsBefore);
    QVERIFY(error() < 0.8 * before);
    QCOMPARE(static_cast<std::size_t>(simplified.fn), faces);
    QVERIFY(simplified.face[7].IsD());
    QVERIFY(simplified.face[7].P(0) == corner && simplified.vert.back().P() == isolated);
    QVERIFY(simplified.vert[100].P() == fixedPoint);
}

QTEST_APPLESS_MAIN(TestRefinement)
#include "test_refine.moc"
