// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cstdint>
#include <vector>

#include "test_meshes.h"
#include "vcg_ext/apply_decimation.h"

using namespace vcg_ext;
using test_meshes::FloatMesh;
using test_meshes::IndexedMesh;

Q_DECLARE_METATYPE(test_meshes::IndexedMesh)

namespace
{

struct Face {
    std::size_t a, b, c;
    std::uint8_t faux; ///< bit k: edge k
};

IndexedMesh Faces(std::size_t vertices, const std::vector<Face>& faces)
{
    IndexedMesh mesh;
    for (std::size_t v = 0; v < vertices; ++v) // no two at one place, no three on one line
        mesh.points.push_back({static_cast<double>(v), static_cast<double>(v * v), 0});
    for (const Face& face : faces) {
        mesh.AddTriangle(face.a, face.b, face.c);
        mesh.fauxEdges.push_back(face.faux);
    }
    return mesh;
}

/// The decimation that keeps everything as it is.
DecimatedMesh Unchanged(const IndexedMesh& source)
{
    DecimatedMesh result;
    result.positions = source.points;
    result.triangles = source.triangles;
    for (std::uint32_t v = 0; v < source.points.size(); ++v) result.vertexOrigin.push_back(v);
    for (std::uint32_t f = 0; f < source.triangles.size(); ++f) result.faceOrigin.push_back(f);
    return result;
}

std::vector<std::uint8_t> FauxAfter(const IndexedMesh& source)
{
    FloatMesh mesh;
    test_meshes::Fill(mesh, source);
    ApplyDecimation(mesh, Unchanged(source));
    std::vector<std::uint8_t> bits;
    for (const auto& face : mesh.face)
        bits.push_back(
            static_cast<std::uint8_t>((face.IsF(0) ? 1 : 0) | (face.IsF(1) ? 2 : 0) | (face.IsF(2) ? 4 : 0)));
    return bits;
}

} // namespace

class TestApplyDecimation : public QObject
{
    Q_OBJECT

  private slots:
    void polygonsStay_data()
    {
        QTest::addColumn<IndexedMesh>("mesh");
        QTest::newRow("a quad") << Faces(4, {{0, 1, 2, 4}, {0, 2, 3, 1}});
        QTest::newRow("a pentagon as a fan") << Faces(5, {{0, 1, 2, 4}, {0, 2, 3, 5}, {0, 3, 4, 1}});
        QTest::newRow("a hexagon around a triangle")
            << Faces(6, {{0, 1, 2, 4}, {2, 3, 4, 4}, {4, 5, 0, 4}, {0, 2, 4, 7}});
        QTest::newRow("two quads with a common edge")
            << Faces(6, {{0, 1, 2, 4}, {0, 2, 3, 1}, {3, 2, 4, 4}, {3, 4, 5, 1}});
        QTest::newRow("a quad beside a triangle on both of its sides")
            << Faces(5, {{0, 1, 2, 4}, {0, 2, 3, 1}, {1, 0, 4, 0}, {3, 2, 4, 0}});
    }
    void polygonsStay()
    {
        QFETCH(IndexedMesh, mesh);
        QCOMPARE(FauxAfter(mesh), mesh.fauxEdges);
    }

    /// Around each of these a walk along the border of a polygon does not come back, or misses a part.
    void whatIsNoSimplePolygonBecomesTriangles_data()
    {
        QTest::addColumn<IndexedMesh>("mesh");
        QTest::newRow("the flag on one side only") << Faces(4, {{0, 1, 2, 4}, {0, 2, 3, 0}});
        QTest::newRow("a diagonal without a second face") << Faces(3, {{0, 1, 2, 4}});
        QTest::newRow("a quad twice") << Faces(4, {{0, 1, 2, 4}, {0, 2, 3, 1}, {0, 1, 2, 4}, {0, 2, 3, 1}});
        QTest::newRow("a third face at the diagonal") << Faces(5, {{0, 1, 2, 4}, {0, 2, 3, 1}, {0, 2, 4, 0}});
        QTest::newRow("two faces that run through the diagonal in the same direction")
            << Faces(4, {{0, 1, 2, 4}, {2, 0, 3, 1}});
        QTest::newRow("a vertex inside")
            << Faces(5, {{0, 1, 4, 6}, {1, 2, 4, 6}, {2, 3, 4, 6}, {3, 0, 4, 6}});
        QTest::newRow("a closed surface")
            << Faces(4, {{0, 1, 2, 7}, {0, 2, 3, 7}, {0, 3, 1, 7}, {1, 3, 2, 7}});
        QTest::newRow("a ring") << Faces(
            6, {{0, 1, 3, 6}, {1, 4, 3, 5}, {1, 2, 4, 6}, {2, 5, 4, 5}, {2, 0, 5, 6}, {0, 3, 5, 5}});
        QTest::newRow("a vertex twice on the border") << Faces(4, {{0, 1, 2, 2}, {2, 1, 3, 5}, {2, 3, 0, 1}});
        QTest::newRow("two triangles back to back along two sides") << Faces(3, {{0, 1, 2, 3}, {1, 0, 2, 5}});
    }
    void whatIsNoSimplePolygonBecomesTriangles()
    {
        QFETCH(IndexedMesh, mesh);
        QCOMPARE(FauxAfter(mesh), std::vector<std::uint8_t>(mesh.triangles.size(), 0));
    }

    void aBadPatchLeavesTheOthers()
    {
        const IndexedMesh mesh =
            Faces(9, {{0, 1, 4, 6}, {1, 2, 4, 6}, {2, 3, 4, 6}, {3, 0, 4, 6}, {5, 6, 7, 4}, {5, 7, 8, 1}});
        QCOMPARE(FauxAfter(mesh), (std::vector<std::uint8_t>{0, 0, 0, 0, 4, 1}));
    }
};

QTEST_GUILESS_MAIN(TestApplyDecimation)
#include "test_apply_decimation.moc"
