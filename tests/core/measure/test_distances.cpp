// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "analytic_meshes.h"
#include "vcg_ext/core/measure/distances.h"
#include "vcg_ext/core/measure/report.h"

using namespace vcg_ext;

namespace
{

/// The mesh as if it were the outcome of a decimation.
DecimatedMesh AsResult(const test_meshes::IndexedMesh& mesh)
{
    DecimatedMesh result;
    result.positions.assign(mesh.points.begin(), mesh.points.end());
    result.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    return result;
}

constexpr std::size_t kSamples = 2000;

DistanceReport Distances(const test_meshes::IndexedMesh& a, const test_meshes::IndexedMesh& b,
                         int threads = 1)
{
    return MeasureDistances(test_meshes::View(a), AsResult(b), std::vector<float>(a.points.size(), 0),
                            kSamples, threads);
}

} // namespace

class TestDistances : public QObject
{
    Q_OBJECT

  private slots:
    void isZeroBetweenAMeshAndItself()
    {
        const auto mesh = test_meshes::Torus(24, 12);
        const DistanceReport report = Distances(mesh, mesh);
        QVERIFY(report.hausdorff < 1e-10); // a few roundings of double, in percent
        QVERIFY(report.rms < 1e-10);
        QVERIFY(report.featureRms < 1e-10);
        QCOMPARE(report.folded, std::size_t{0});
    }

    /// Of the size of the rounding of its coordinates: the answer means little, but it comes.
    void endsFarFromTheOrigin()
    {
        const auto mesh =
            test_meshes::Moved(test_meshes::Noisy(test_meshes::Box(4), .05), 1, 1e-11, {1e5, 1e5, 1e5});
        const DistanceReport report = Distances(mesh, mesh);
        QVERIFY(report.hausdorff < 1e-6);
    }

    void ofAShiftedPlaneIsTheShift()
    {
        const auto plane = test_meshes::Grid(8, 8);
        const double shift = 0.25, diagonal = 8 * std::sqrt(2.0);
        auto moved = plane;
        for (auto& p : moved.points) p[2] += shift;
        const DistanceReport report = Distances(plane, moved);
        const double expected = 100 * shift / diagonal;
        QVERIFY(std::abs(report.hausdorff - expected) < 1e-9);
        QVERIFY(std::abs(report.rms - expected) < 1e-9);
        QVERIFY(std::abs(report.featureRms - expected) < 1e-9);
    }

    /// A missing half is seen one way only: the farthest point is at the far edge, the other way there is
    /// none.
    void looksBothWays()
    {
        const auto whole = test_meshes::Grid(8, 4), half = test_meshes::Grid(4, 4);
        const double diagonal = std::sqrt(80.0);
        const double expected = 100 * 4 / diagonal;
        QVERIFY(std::abs(Distances(whole, half).hausdorff - expected) < 1e-9);
        const double smallDiagonal = std::sqrt(32.0);
        QVERIFY(std::abs(Distances(half, whole).hausdorff - 100 * 4 / smallDiagonal) < 1e-9);
        // half of the samples at distance 0, half spread evenly over 0..4: mean square 16/3 / 2, other way 0
        const double rms = 100 / diagonal * std::sqrt(16.0 / 3 / 2 / 2);
        // stratified samples along the faces miss the integral by about one face in sixty-four
        QVERIFY(std::abs(Distances(whole, half).rms - rms) < 0.02 * rms);
    }

    /// A sheet of 40,000 faces of which one end is lifted: the distance rises from 0 to the lift at an even
    /// rate, both ways, so that the mean square is a third of its square (times a cosine of 1 - 2e-6).
    void rmsIsWithinThreeStandardErrorsOfTheTruth()
    {
        constexpr int kSide = 141;
        constexpr double kLift = 0.2;
        const auto plane = test_meshes::Grid(kSide, kSide);
        auto lifted = plane;
        for (auto& p : lifted.points) p[2] += kLift * p[0] / kSide;
        const auto report = MeasureDistances(test_meshes::View(plane), AsResult(lifted),
                                             std::vector<float>(plane.points.size(), 0), 100000, 1);
        const double percent = 100 / (kSide * std::sqrt(2.0)), rms = percent * kLift / std::sqrt(3.0);
        QVERIFY(std::abs(report.rms - rms) < 3 * 0.01 * rms);
        // The largest is at vertices, which are all measured, however few samples are.
        QVERIFY(std::abs(report.hausdorff - percent * kLift) < 1e-4 * percent * kLift);
    }

    /// A low spike on six of 125,000 faces is the only distance. That most samples have seen nothing does not
    /// end the measurement: with all of them, some five a side hit it.
    void samplesGoOnWhereLittleOfTheSurfaceIsFar()
    {
        constexpr int kSide = 250;
        const auto plane = test_meshes::Grid(kSide, kSide);
        auto spiked = plane;
        spiked.points[125 * (kSide + 1) + 125][2] += 0.2;
        const auto report = MeasureDistances(test_meshes::View(plane), AsResult(spiked),
                                             std::vector<float>(plane.points.size(), 0), 100000, 1);
        QVERIFY(report.rms > 0);
        QVERIFY(std::abs(report.hausdorff - 100 * 0.2 / (kSide * std::sqrt(2.0))) < 0.1 * report.hausdorff);
    }

    void everyVertexCounts_data()
    {
        QTest::addColumn<int>("vertex");
        for (const int v : {0, 9999, 20163}) QTest::addRow("%d", v) << v;
    }
    /// Each of 20,164 vertices can be the farthest, whichever group it is in and whatever is near it.
    void everyVertexCounts()
    {
        QFETCH(int, vertex);
        const auto plane = test_meshes::Grid(141, 141);
        auto spiked = test_meshes::Noisy(plane, 0.01);
        spiked.points[static_cast<std::size_t>(vertex)][2] = 1;
        const double percent = 100 / (141 * std::sqrt(2.0));
        QVERIFY(Distances(plane, spiked).hausdorff >= 0.9999 * percent);
        const double back = Distances(spiked, plane).hausdorff;
        QVERIFY(back > 0.99 * percent && back < 1.01 * percent); // of a diagonal of almost the same length
    }

    /// A vertex that is left where it was is taken for a distance of 0, but only if the other surface still
    /// has it on a face.
    void unmovedVerticesHaveNoDistance()
    {
        const auto plane = test_meshes::Grid(4, 4);
        auto result = AsResult(plane);
        for (std::uint32_t v = 0; v < plane.points.size(); ++v) result.vertexOrigin.push_back(v);
        const auto hausdorff = [&](const DecimatedMesh& mesh) {
            return MeasureDistances(test_meshes::View(plane), mesh, std::vector<float>(25, 0), kSamples, 1)
                .hausdorff;
        };
        QVERIFY(hausdorff(result) < 1e-10);
        auto without = result; // the faces around the first corner go, their vertices stay
        without.triangles.erase(without.triangles.begin(), without.triangles.begin() + 2);
        const double corner = 100 / (4 * std::sqrt(2.0)); // the side of a square
        QVERIFY(std::abs(hausdorff(without) - corner) < 1e-6);
        auto moved = result;
        moved.positions[24][2] = 1;
        QVERIFY(hausdorff(moved) > 10);
    }

    void featuresAreTheTenthWithTheLargestDescriptor()
    {
        const auto plane = test_meshes::Grid(9, 9); // 100 vertices
        auto bent = plane;
        std::vector<float> descriptor(plane.points.size(), 0);
        for (std::size_t v = 0; v < 10; ++v) { // the first row
            descriptor[v] = 1;
            bent.points[v][2] += 0.5;
        }
        const auto result = AsResult(bent);
        const auto report = MeasureDistances(test_meshes::View(plane), result, descriptor, kSamples, 1);
        // the first row went up by .5 while its face still reaches down to the second row at distance 1
        const double toTheSlope = 0.5 / std::sqrt(1 + 0.25), diagonal = 9 * std::sqrt(2.0);
        QVERIFY(std::abs(report.featureRms - 100 * toTheSlope / diagonal) < 1e-6);
    }

    void countsFacesThatAreTurnedOver()
    {
        const auto plane = test_meshes::Grid(3, 3);
        auto turned = plane;
        std::swap(turned.triangles[4][0], turned.triangles[4][1]);
        QCOMPARE(Distances(plane, turned).folded, std::size_t{1});
    }

    void survivesDegenerateFacesAndFlatBoxes()
    {
        auto plane = test_meshes::Grid(2, 2);
        plane.AddTriangle(0, 0, 1);
        plane.AddTriangle(0, 1, 2); // three points of one line
        const DistanceReport report = Distances(plane, test_meshes::Grid(2, 2));
        QVERIFY(report.hausdorff < 1e-9);
        QCOMPARE(report.folded, std::size_t{0});
    }

    void isTheSameOnAnyNumberOfThreads()
    {
        const auto mesh = test_meshes::Torus(24, 12), other = test_meshes::Torus(9, 7);
        const DistanceReport one = Distances(mesh, other, 1);
        for (int threads : {2, 3, 7}) {
            const DistanceReport many = Distances(mesh, other, threads);
            QCOMPARE(many.hausdorff, one.hausdorff);
            QCOMPARE(many.rms, one.rms);
            QCOMPARE(many.featureRms, one.featureRms);
            QCOMPARE(many.folded, one.folded);
        }
    }

    void edgesAreCountedByTheirFaces()
    {
        const auto count = [](const test_meshes::IndexedMesh& mesh) {
            return CountEdges(mesh.triangles.size(), [&](std::size_t f) { return mesh.triangles[f]; });
        };
        QCOMPARE(count(test_meshes::Torus(9, 7)).boundary, std::size_t{0});
        QCOMPARE(count(test_meshes::Grid(3, 2)).boundary, std::size_t{10});
        QCOMPARE(count(test_meshes::Grid(3, 2)).nonManifold, std::size_t{0});
        QCOMPARE(count(test_meshes::Book(3)).nonManifold, std::size_t{1});
        QCOMPARE(count(test_meshes::Book(2)).nonManifold, std::size_t{0});
    }
};

QTEST_APPLESS_MAIN(TestDistances)
#include "test_distances.moc"
