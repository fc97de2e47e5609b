// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/measure/report.h"
#include "vcg_ext/core/mesh/clean_input.h"

using namespace test_meshes;
using namespace vcg_ext;

namespace
{

/// Every face with vertices of its own, as STL files have them.
IndexedMesh Soup(const IndexedMesh& mesh)
{
    IndexedMesh soup;
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t) soup.points.push_back(mesh.points[v]);
        soup.AddTriangle(soup.points.size() - 3, soup.points.size() - 2, soup.points.size() - 1);
    }
    return soup;
}

IndexedMesh Both(IndexedMesh a, const IndexedMesh& b)
{
    const std::size_t shift = a.points.size();
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const Triangle& t : b.triangles) a.AddTriangle(t[0] + shift, t[1] + shift, t[2] + shift);
    return a;
}

EdgeCounts EdgesOf(const CleanedInput& clean)
{
    return CountEdges(clean.View().faceCount, [&](std::size_t f) { return clean.View().triangles + 3 * f; });
}

std::vector<std::uint32_t> TrianglesOf(const CleanedInput& clean)
{
    return {clean.View().triangles, clean.View().triangles + 3 * clean.View().faceCount};
}

} // namespace

class TestCleanInput : public QObject
{
    Q_OBJECT

  private slots:
    void cleanMeshIsReadInPlace()
    {
        const IndexedMesh mesh = Box(3);
        const MeshView view = View(mesh);
        const CleanedInput clean(view, 0, 1);
        QVERIFY(clean.View().triangles == view.triangles);
        QCOMPARE(clean.View().faceCount, view.faceCount);
        QCOMPARE(clean.Report().weldedVertices + clean.Report().DroppedFaces(), std::size_t{0});
        QCOMPARE(clean.FaceOrigin(7), 7U);
    }

    void soupOfAClosedMeshIsClosed()
    {
        const IndexedMesh box = Box(3), soup = Soup(box);
        const CleanedInput clean(View(soup), 0, 1);
        QCOMPARE(EdgesOf(clean).boundary, std::size_t{0});
        QCOMPARE(EdgesOf(clean).nonManifold, std::size_t{0});
        QCOMPARE(clean.Report().weldedVertices, soup.points.size() - box.points.size());
        QCOMPARE(clean.View().faceCount, soup.triangles.size());
    }

    void negativeZeroIsZero()
    {
        IndexedMesh mesh;
        mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {0, -1, 0}, {1, -0.0, 0}};
        mesh.AddTriangle(0, 1, 2);
        mesh.AddTriangle(3, 4, 5);
        QCOMPARE(CleanedInput(View(mesh), 0, 1).Report().weldedVertices, std::size_t{2});
    }

    void closedSurfacesThatTouchStayApart()
    {
        IndexedMesh other = Box(2);
        for (Point& p : other.points) p[0] += 1; // a side of each lies in the plane x = 1
        const IndexedMesh mesh = Both(Box(2), other);
        const CleanedInput clean(View(mesh), 0, 1);
        QCOMPARE(clean.Report().weldedVertices, std::size_t{0});
        QCOMPARE(EdgesOf(clean).nonManifold, std::size_t{0});
    }

    void bordersOfThreeSheetsBecomeOneEdge()
    {
        IndexedMesh mesh; // three faces around the edge from 0 to 1 along x, each with vertices of its own
        for (const Point& tip : {Point{0, 1, 0}, Point{0, -1, 1}, Point{0, -1, -1}}) {
            const std::size_t first = mesh.points.size();
            for (const Point& p : {Point{0, 0, 0}, Point{1, 0, 0}, tip}) mesh.points.push_back(p);
            mesh.AddTriangle(first, first + 1, first + 2);
        }
        const CleanedInput clean(View(mesh), 0, 1);
        QCOMPARE(clean.Report().weldedVertices, std::size_t{4});
        QCOMPARE(EdgesOf(clean).nonManifold, std::size_t{1});
        QCOMPARE(EdgesOf(clean).boundary, std::size_t{6});
    }

    void unreferencedVerticesWeldNothing()
    {
        IndexedMesh mesh;
        mesh.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.AddTriangle(1, 2, 3); // the first vertex is on no face
        QCOMPARE(CleanedInput(View(mesh), 0, 1).Report().weldedVertices, std::size_t{0});
    }

    void fixedVerticesStay()
    {
        const IndexedMesh soup = Soup(Grid(1, 1)); // two faces; the diagonal's ends are there twice
        MeshView view = View(soup);
        std::vector<std::uint8_t> fixed(soup.points.size(), 0);
        fixed[3] = 1; // of the second face, at the same place as vertex 0
        view.fixedVertices = fixed.data();
        const CleanedInput clean(view, 0, 1);
        QCOMPARE(soup.points[0], soup.points[3]);
        QCOMPARE(TrianglesOf(clean), (std::vector<std::uint32_t>{3, 1, 2, 3, 2, 5}));
        fixed[0] = 1; // both: nothing is done with either
        const CleanedInput both(view, 0, 1);
        QCOMPARE(TrianglesOf(both), (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 5}));
    }

    void degenerateAndDuplicateFacesAreLeftOut()
    {
        IndexedMesh mesh = Grid(1, 1, 1, true);
        mesh.AddTriangle(0, 1, 1); // degenerate
        mesh.AddTriangle(1, 3, 0); // the first face again, turned
        mesh.AddTriangle(1, 0, 3); // its back: another face
        mesh.AddTriangle(2, 2, 2); // degenerate, and twice so
        mesh.AddTriangle(2, 2, 2);
        mesh.fauxEdges = {4, 1, 0, 2, 2, 0, 0};
        MeshView view = View(mesh);
        view.fauxEdges = mesh.fauxEdges.data();
        const CleanedInput clean(view, 0, 1);
        QCOMPARE(mesh.triangles[0], (Triangle{0, 1, 3}));
        QCOMPARE(clean.Report().degenerateFaces, std::size_t{3});
        QCOMPARE(clean.Report().duplicateFaces, std::size_t{1});
        QCOMPARE(TrianglesOf(clean), (std::vector<std::uint32_t>{0, 1, 3, 0, 3, 2, 1, 0, 3}));
        QCOMPARE(clean.FaceOrigin(1), 1U);
        QCOMPARE(clean.FaceOrigin(2), 4U);
        QCOMPARE(int{clean.View().fauxEdges[2]}, 2);
    }

    void attributesOfDroppedFacesGoWithThem()
    {
        IndexedMesh mesh = Grid(1, 1); // two faces
        const Triangle first = mesh.triangles[0];
        mesh.triangles.insert(mesh.triangles.begin() + 1, Triangle{0, 1, 1});
        mesh.triangles.insert(mesh.triangles.begin(), Triangle{first[1], first[2], first[0]}); // the next one
        std::vector<float> values; // of corner k of face f: 10 f + k, and -1 minus that
        const std::vector<std::int32_t> labels{5, 6, 7, 8};
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto value = static_cast<float>(10 * f + k);
                values.insert(values.end(), {value, -1 - value});
            }
        const std::vector<ChannelKind> kinds(2, ChannelKind::Scalar);
        const CornerAttributes attributes{values.data(), kinds, labels.data()};
        MeshView view = View(mesh);
        view.attributes = &attributes;
        const CleanedInput clean(view, 0, 1);
        QCOMPARE(clean.View().faceCount, std::size_t{2});
        const CornerAttributes& kept = *clean.View().attributes;
        QCOMPARE(kept.kinds, kinds);
        for (std::uint32_t f = 0; f < 2; ++f) {
            const std::uint32_t origin = clean.FaceOrigin(f);
            QCOMPARE(origin, 3 * f); // the first and the last
            QCOMPARE(kept.Label(f), labels[origin]);
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t j = 0; j < 2; ++j)
                    QCOMPARE(kept.Corner(f, k)[j], attributes.Corner(origin, k)[j]);
        }
    }

    void attributesMayBeLabelsAlone()
    {
        IndexedMesh mesh = Grid(1, 1);
        mesh.triangles.insert(mesh.triangles.begin(), Triangle{0, 1, 1});
        const std::vector<std::int32_t> labels{5, 6, 7};
        CornerAttributes attributes;
        attributes.labels = labels.data();
        MeshView view = View(mesh);
        view.attributes = &attributes;
        const CleanedInput clean(view, 0, 1);
        QVERIFY(clean.View().attributes->values == nullptr);
        QCOMPARE(clean.View().attributes->Label(1), 7);
    }

    void bordersWithinTheDistanceAreWelded_data()
    {
        QTest::addColumn<double>("gap");
        QTest::addColumn<bool>("welded");
        QTest::newRow("closer") << .009 << true;
        QTest::newRow("as far") << .0078125 << true; // a power of two: nothing is rounded
        QTest::newRow("farther") << .011 << false;
    }
    void bordersWithinTheDistanceAreWelded()
    {
        QFETCH(double, gap);
        QFETCH(bool, welded);
        IndexedMesh right = Grid(2, 2);
        for (Point& p : right.points) p[0] += 2 + gap;
        const IndexedMesh mesh = Both(Grid(2, 2), right);
        const double distance = gap < .008 ? gap : .01;
        const CleanedInput clean(View(mesh), distance, 1);
        QCOMPARE(clean.Report().weldedVertices, std::size_t{welded ? 3U : 0U});
        QCOMPARE(EdgesOf(clean).boundary, std::size_t{welded ? 12U : 16U});
        QCOMPARE(CleanedInput(View(mesh), 0, 1).Report().weldedVertices, std::size_t{0});
    }
};

QTEST_APPLESS_MAIN(TestCleanInput)

#include "test_clean_input.moc"
