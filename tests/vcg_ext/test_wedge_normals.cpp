// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Hard edges of a VCG mesh: normals of wedges, and those of vertices that are doubled for their sake.

#include <QtTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/normal.h>

#include "mesh_checks.h"
#include "test_meshes.h"
#include "vcg_ext/decimate.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::Point;

namespace
{

class ShadedVertex;
class ShadedFace;
struct ShadedTypes : vcg::UsedTypes<vcg::Use<ShadedVertex>::AsVertexType, vcg::Use<ShadedFace>::AsFaceType> {
};
class ShadedVertex
    : public vcg::Vertex<ShadedTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::BitFlags>
{
};
class ShadedFace : public vcg::Face<ShadedTypes, vcg::face::VertexRef, vcg::face::Normal3f,
                                    vcg::face::WedgeNormal, vcg::face::BitFlags>
{
};
class Shaded : public vcg::tri::TriMesh<std::vector<ShadedVertex>, std::vector<ShadedFace>>
{
};

class PlainVertex;
class PlainFace;
struct PlainTypes : vcg::UsedTypes<vcg::Use<PlainVertex>::AsVertexType, vcg::Use<PlainFace>::AsFaceType> {
};
class PlainVertex
    : public vcg::Vertex<PlainTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::BitFlags>
{
};
class PlainFace : public vcg::Face<PlainTypes, vcg::face::VertexRef, vcg::face::BitFlags>
{
};
/// As MeshLab's, which has no normals of wedges.
class Plain : public vcg::tri::TriMesh<std::vector<PlainVertex>, std::vector<PlainFace>>
{
};

MeshDecimationParameters Target(std::size_t faces)
{
    MeshDecimationParameters parameters;
    parameters.targetFaces = faces;
    parameters.threads = 1;
    parameters.measureError = false;
    return parameters;
}

/// A roof: two squares that meet at x = 0, either falling away at 45 degrees.
IndexedMesh Roof(int size = 16)
{
    IndexedMesh roof = test_meshes::Grid(2 * size, size, 1.0 / size);
    for (Point& p : roof.points) {
        p[0] -= 1;
        p[2] = -std::fabs(p[0]);
    }
    return roof;
}

/// The same with vertices of its own for either side.
IndexedMesh CutRoof()
{
    const IndexedMesh roof = Roof();
    IndexedMesh cut;
    std::map<std::pair<std::uint32_t, bool>, std::size_t> index;
    for (const auto& t : roof.triangles) {
        double x = 0;
        for (const std::uint32_t v : t) x += roof.points[v][0];
        std::size_t corner[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [place, isNew] = index.emplace(std::make_pair(t[k], x > 0), cut.points.size());
            if (isNew) cut.points.push_back(roof.points[t[k]]);
            corner[k] = place->second;
        }
        cut.AddTriangle(corner[0], corner[1], corner[2]);
    }
    return cut;
}

constexpr double kTenthOfADegree = 1e-6; ///< of a cosine, less than 1

/// Whether it is the unit normal of that side of the roof.
template <class Normal>
bool IsOfSide(const Normal& n, bool right)
{
    const double half = std::sqrt(0.5), cosine = static_cast<double>(n[2]) * half +
                                                 static_cast<double>(n[0]) * (right ? half : -half);
    return std::fabs(cosine - 1) < kTenthOfADegree;
}

template <class Mesh>
bool IsRight(const Mesh& mesh, std::size_t f)
{
    double x = 0;
    for (int k = 0; k < 3; ++k) x += static_cast<double>(mesh.face[f].cP(k)[0]);
    return x > 0;
}

} // namespace

class TestWedgeNormals : public QObject
{
    Q_OBJECT

  private slots:
    /// Normals of wedges that differ at the ridge make a seam of it, and are those of either side afterwards.
    void hardNormalsOfWedgesStayHard()
    {
        Shaded mesh;
        test_meshes::Fill(mesh, Roof());
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k) mesh.face[f].WN(k) = {IsRight(mesh, f) ? 1.F : -1.F, 0, 1}; // no unit
        const MeshSimplification result = Decimate(mesh, Target(20));
        QCOMPARE(result.report.attributes->charts, std::size_t{2});
        ApplyDecimation(mesh, result, true);
        QVERIFY(mesh.fn <= 20);
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k) QVERIFY(IsOfSide(mesh.face[f].cWN(k), IsRight(mesh, f)));
    }

    /// Where they are smooth they are no seam, and what a vertex has is the mean over all its faces.
    void smoothNormalsOfWedgesStaySmooth()
    {
        Shaded mesh;
        test_meshes::Fill(mesh, Roof());
        for (auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) face.WN(k) = {face.cP(k)[0], 0, 1};
        const MeshSimplification result = Decimate(mesh, Target(20));
        QVERIFY(!result.report.attributes);
        ApplyDecimation(mesh, result, true);
        std::map<const void*, std::set<float>> normals;
        for (const auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) {
                QVERIFY(std::fabs(face.cWN(k).Norm() - 1) < 1e-5F);
                normals[face.cV(k)].insert(face.cWN(k)[0]);
            }
        for (const auto& [vertex, x] : normals) QCOMPARE(x.size(), std::size_t{1});
    }

    /// A vertex has one, too, where but some of its faces have changed; where none has, those that it had,
    /// which here are longer than computed ones.
    void aVertexHasOneNormalWhereFewFacesChange()
    {
        Shaded mesh;
        test_meshes::Fill(mesh, Roof());
        for (auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) face.WN(k) = {face.cP(k)[0] / 8, 0, 2};
        const auto faces = static_cast<std::size_t>(mesh.fn);
        ApplyDecimation(mesh, Decimate(mesh, Target(faces * 8 / 10)), true);
        std::map<const void*, std::set<std::pair<float, float>>> normals;
        for (const auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) normals[face.cV(k)].insert({face.cWN(k)[0], face.cWN(k)[2]});
        std::size_t old = 0;
        for (const auto& [vertex, n] : normals) {
            QCOMPARE(n.size(), std::size_t{1});
            old += n.begin()->second == 2;
        }
        QVERIFY(old > 0 && old < normals.size());
    }

    /// Areas whose squares are no numbers have normals, and what has no area keeps those that it had.
    void normalsOfAnySizeAndOfNone()
    {
        for (const double size : {1e-160, 1.0, 1e160}) {
            DecimatedMesh mesh;
            mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
            mesh.triangles = {{0, 1, 2}, {1, 1, 1}};
            mesh.cornerSides = {0, 0, 0, 1, 1, 1};
            const auto normals = CornerNormals(mesh, FirstCornersOfSides(mesh));
            for (std::size_t i = 0; i < 6; ++i) {
                QCOMPARE(normals[i].x, 0.0);
                QCOMPARE(normals[i].z, i < 3 ? 1.0 : 0.0);
            }
        }
        Shaded mesh;
        test_meshes::Fill(mesh, Roof());
        for (auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) face.WN(k) = {0, 0, 2};
        MeshSimplification result = Decimate(mesh, Target(20));
        for (auto& p : result.mesh.positions) p = {7, 7, 7};
        ApplyDecimation(mesh, result, true);
        for (const auto& face : mesh.face)
            for (int k = 0; k < 3; ++k) QCOMPARE(face.cWN(k)[2], 2.F);
    }

    /// Vertices that were doubled along a hard edge meet for the run and are doubled again, with a normal of
    /// their side, where the caller says that normals are the author's. Where they are alike on both sides,
    /// and where they were only computed, as MeshLab does for every mesh, vertices are one afterwards.
    void doubledVerticesStayDoubledAlongHardEdges()
    {
        for (const auto& [authors, apart] : {std::pair{true, true}, {true, false}, {false, true}}) {
            const bool hard = authors && apart;
            Plain mesh;
            test_meshes::Fill(mesh, CutRoof());
            vcg::tri::UpdateNormal<Plain>::PerVertexNormalized(mesh);
            if (!apart)
                for (auto& vertex : mesh.vert) vertex.N() = {0, 0, 1};
            auto parameters = Target(20);
            parameters.vertexNormalsAreShading = authors;
            const MeshSimplification result = Decimate(mesh, parameters);
            QCOMPARE(result.report.cleaning->weldedVertices, std::size_t{17});
            QCOMPARE(result.report.attributes.has_value(), hard);
            ApplyDecimation(mesh, result, true);
            vcg::tri::UpdateNormal<Plain>::PerVertexNormalized(mesh);
            std::map<std::pair<double, double>, int> ridge;
            for (const auto& vertex : mesh.vert)
                if (std::fabs(vertex.cP()[0]) < 1e-6) ++ridge[{vertex.cP()[1], vertex.cP()[2]}];
            QVERIFY(ridge.size() >= 2);
            for (const auto& [place, count] : ridge) QCOMPARE(count, hard ? 2 : 1);
            for (std::size_t f = 0; hard && f < mesh.face.size(); ++f)
                for (int k = 0; k < 3; ++k) QVERIFY(IsOfSide(mesh.face[f].cV(k)->cN(), IsRight(mesh, f)));
        }
    }

    /// Without keepAttributes, and in a mesh where every face has vertices of its own, they say nothing.
    void normalsMayBeIgnored()
    {
        Plain mesh;
        test_meshes::Fill(mesh, CutRoof());
        vcg::tri::UpdateNormal<Plain>::PerVertexNormalized(mesh);
        auto parameters = Target(20);
        parameters.vertexNormalsAreShading = true;
        parameters.keepAttributes = false;
        QVERIFY(!Decimate(mesh, parameters).report.attributes);
        IndexedMesh soup;
        const IndexedMesh roof = Roof();
        for (const auto& t : roof.triangles) {
            for (const std::uint32_t v : t) soup.points.push_back(roof.points[v]);
            soup.AddTriangle(soup.points.size() - 3, soup.points.size() - 2, soup.points.size() - 1);
        }
        Plain single;
        test_meshes::Fill(single, soup);
        vcg::tri::UpdateNormal<Plain>::PerVertexNormalized(single);
        parameters.keepAttributes = true;
        const MeshSimplification result = Decimate(single, parameters);
        QVERIFY(result.report.cleaning->weldedVertices > 0 && !result.report.attributes);
    }
};

QTEST_APPLESS_MAIN(TestWedgeNormals)
#include "test_wedge_normals.moc"
