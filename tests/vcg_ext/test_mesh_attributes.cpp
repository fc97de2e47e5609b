// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From what a VCG mesh carries to what it carries afterwards.

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>

#include "mesh_checks.h"
#include "test_meshes.h"
#include "vcg_ext/decimate.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::Point;

namespace
{

class PaintedVertex;
class PaintedFace;
struct PaintedTypes
    : vcg::UsedTypes<vcg::Use<PaintedVertex>::AsVertexType, vcg::Use<PaintedFace>::AsFaceType> {
};
class PaintedVertex : public vcg::Vertex<PaintedTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                                         vcg::vertex::Qualityf, vcg::vertex::Color4b, vcg::vertex::TexCoord2f,
                                         vcg::vertex::Radiusf, vcg::vertex::BitFlags>
{
};
class PaintedFace : public vcg::Face<PaintedTypes, vcg::face::VertexRef, vcg::face::WedgeTexCoord2f,
                                     vcg::face::WedgeColor4b, vcg::face::Color4b, vcg::face::Qualityf,
                                     vcg::face::FFAdj, vcg::face::BitFlags>
{
};
/// Single precision, with everything from the start.
class FloatPainted : public vcg::tri::TriMesh<std::vector<PaintedVertex>, std::vector<PaintedFace>>
{
  public:
    ~FloatPainted() override { ClearAttributes(); } // vcglib leaves that to the owner
};

class OptionalVertex;
class OptionalFace;
struct OptionalTypes
    : vcg::UsedTypes<vcg::Use<OptionalVertex>::AsVertexType, vcg::Use<OptionalFace>::AsFaceType> {
};
class OptionalVertex : public vcg::Vertex<OptionalTypes, vcg::vertex::InfoOcf, vcg::vertex::Coord3d,
                                          vcg::vertex::Normal3d, vcg::vertex::Qualityd, vcg::vertex::Color4b,
                                          vcg::vertex::TexCoordfOcf, vcg::vertex::BitFlags>
{
};
class OptionalFace
    : public vcg::Face<OptionalTypes, vcg::face::InfoOcf, vcg::face::VertexRef, vcg::face::WedgeTexCoordfOcf,
                       vcg::face::Color4bOcf, vcg::face::FFAdjOcf, vcg::face::BitFlags>
{
};
/// Double precision, with components that can be switched on, as pymeshlab's.
class DoublePainted
    : public vcg::tri::TriMesh<vcg::vertex::vector_ocf<OptionalVertex>, vcg::face::vector_ocf<OptionalFace>>
{
  public:
    ~DoublePainted() override { ClearAttributes(); }
};

void SwitchOn(FloatPainted& mesh)
{
    for (auto& v : mesh.vert) v.R() = 1;
    for (auto& f : mesh.face) {
        f.Q() = 0;
        for (int k = 0; k < 3; ++k) f.WC(k) = vcg::Color4b(9, 9, 9, 9);
    }
}
void SwitchOn(DoublePainted& mesh)
{
    mesh.vert.EnableTexCoord();
    mesh.face.EnableWedgeTexCoord();
    mesh.face.EnableColor();
}

/// A mesh on which everything is the same everywhere.
template <class Mesh>
void FillPlain(Mesh& mesh, const IndexedMesh& source)
{
    test_meshes::Fill(mesh, source);
    SwitchOn(mesh);
    for (auto& v : mesh.vert) {
        v.C() = vcg::Color4b(7, 77, 177, 255);
        v.Q() = 3;
        v.T().U() = v.T().V() = 0;
        v.T().N() = 0;
    }
    for (auto& f : mesh.face) {
        f.C() = vcg::Color4b(1, 2, 3, 4);
        for (int k = 0; k < 3; ++k) {
            f.WT(k).U() = f.WT(k).V() = 0;
            f.WT(k).N() = 0;
        }
    }
}

MeshDecimationParameters Target(std::size_t faces, Effort effort = Effort::Balanced)
{
    MeshDecimationParameters parameters;
    parameters.targetFaces = faces;
    parameters.effort = effort;
    parameters.threads = 1;
    parameters.measureError = false;
    return parameters;
}

template <class Mesh>
MeshSimplification Decimated(Mesh& mesh, const MeshDecimationParameters& parameters)
{
    MeshSimplification result = Decimate(mesh, parameters);
    ApplyDecimation(mesh, result, true);
    return result;
}

/// A sheet in the unit square of no regularity that would help.
IndexedMesh Sheet(int size = 24)
{
    IndexedMesh sheet = test_meshes::Grid(size, size, 1.0 / size);
    for (std::size_t v = 0; v < sheet.points.size(); ++v) {
        Point& p = sheet.points[v];
        const bool border = p[0] < 1e-9 || p[1] < 1e-9 || p[0] > 1 - 1e-9 || p[1] > 1 - 1e-9;
        if (!border) p[0] += 0.1 / size * std::sin(37.0 * static_cast<double>(v));
    }
    return sheet;
}

/// The same, cut along x = 1/2: the left half and the right half have vertices of their own there.
IndexedMesh CutSheet(int size = 24)
{
    IndexedMesh sheet = test_meshes::Grid(size, size, 1.0 / size), cut;
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> index;
    for (const auto& t : sheet.triangles) {
        double x = 0;
        for (const std::uint32_t v : t) x += sheet.points[v][0];
        std::array<std::size_t, 3> corner{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [place, isNew] =
                index.emplace(std::make_pair(t[k], x > 1.5), static_cast<std::uint32_t>(cut.points.size()));
            if (isNew) cut.points.push_back(sheet.points[t[k]]);
            corner[k] = place->second;
        }
        cut.AddTriangle(corner[0], corner[1], corner[2]);
    }
    return cut;
}

template <class Mesh>
double CentroidX(const Mesh& mesh, std::size_t f)
{
    double x = 0;
    for (int k = 0; k < 3; ++k) x += static_cast<double>(mesh.face[f].cV(k)->P()[0]) / 3;
    return x;
}

constexpr double kSinglePrecision = 1e-5; ///< some hundred times the rounding of numbers about 1

template <class Mesh>
void CheckLinearAttributesOnAPlane(Order order)
{
    Mesh mesh;
    FillPlain(mesh, Sheet());
    auto number = vcg::tri::Allocator<Mesh>::template AddPerVertexAttribute<double>(mesh, "number");
    auto point = vcg::tri::Allocator<Mesh>::template AddPerVertexAttribute<vcg::Point3f>(mesh, "point");
    const auto linear = [](const auto& p) {
        return 1 + 3 * static_cast<double>(p[0]) - 2 * static_cast<double>(p[1]);
    };
    const auto other = [](const auto& p) {
        return static_cast<double>(p[0]) + 4 * static_cast<double>(p[1]);
    };
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        const auto& p = mesh.vert[v].P();
        mesh.vert[v].Q() = static_cast<typename Mesh::ScalarType>(linear(p));
        number[v] = 1e6 + other(p);
        point[v] = vcg::Point3f(static_cast<float>(linear(p)), 5, static_cast<float>(other(p)));
        mesh.vert[v].T().U() = static_cast<float>(other(p));
        mesh.vert[v].T().V() = static_cast<float>(linear(p));
    }
    for (auto& f : mesh.face)
        for (int k = 0; k < 3; ++k) {
            f.WT(k).U() = static_cast<float>(linear(f.V(k)->P()));
            f.WT(k).V() = static_cast<float>(other(f.V(k)->P()));
        }
    const std::size_t target = 60;
    auto parameters = Target(target);
    parameters.order = order;
    Decimated(mesh, parameters);
    QVERIFY(static_cast<std::size_t>(mesh.fn) <= target);
    const auto near = [](double value, double wanted, double tolerance = 10 * kSinglePrecision) {
        QVERIFY2(std::fabs(value - wanted) < tolerance, qPrintable(QString("%1 %2").arg(value).arg(wanted)));
    };
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        const auto& p = mesh.vert[v].P();
        near(static_cast<double>(mesh.vert[v].Q()), linear(p));
        near(number[v], 1e6 + other(p));
        near(static_cast<double>(point[v][0]), linear(p));
        near(static_cast<double>(point[v][1]), 5, 1e-30); // the same everywhere: not touched
        near(static_cast<double>(point[v][2]), other(p));
        near(static_cast<double>(mesh.vert[v].T().U()), other(p));
        near(static_cast<double>(mesh.vert[v].T().V()), linear(p));
    }
    for (auto& f : mesh.face)
        for (int k = 0; k < 3; ++k) {
            near(static_cast<double>(f.WT(k).U()), linear(f.V(k)->P()));
            near(static_cast<double>(f.WT(k).V()), other(f.V(k)->P()));
        }
}

template <class Mesh>
void CheckUniformAttributesCostNothing()
{
    Mesh mesh;
    FillPlain(mesh, test_meshes::Noisy(test_meshes::Icosphere(3), 0.01));
    const MeshArrays<Mesh> arrays(mesh);
    const MeshAttributes<Mesh> attributes(mesh, arrays, arrays.View(), {});
    QVERIFY(attributes.Corners() == nullptr);
    auto without = Target(200);
    without.keepAttributes = false;
    const MeshSimplification blind = Decimate(mesh, without), result = Decimated(mesh, Target(200));
    QVERIFY(!result.report.attributes && result.mesh.cornerValues.empty());
    QVERIFY(result.mesh.positions == blind.mesh.positions && result.mesh.triangles == blind.mesh.triangles);
    for (auto& v : mesh.vert) QVERIFY(v.C() == vcg::Color4b(7, 77, 177, 255) && v.Q() == 3);
    for (auto& f : mesh.face) QVERIFY(f.C() == vcg::Color4b(1, 2, 3, 4));
}

} // namespace

class TestMeshAttributes : public QObject
{
    Q_OBJECT

  private slots:
    void linearAttributesOnAPlaneStayExact()
    {
        for (const Order order : {Order::Sweeps, Order::Strict}) {
            CheckLinearAttributesOnAPlane<FloatPainted>(order);
            CheckLinearAttributesOnAPlane<DoublePainted>(order);
        }
    }

    void uniformAttributesCostNothing()
    {
        CheckUniformAttributesCostNothing<FloatPainted>();
        CheckUniformAttributesCostNothing<DoublePainted>();
    }

    /// Components that are switched off are not asked for.
    void whatIsSwitchedOffIsNotRead()
    {
        DoublePainted mesh;
        test_meshes::Fill(mesh, test_meshes::Icosphere(2));
        for (auto& v : mesh.vert) v.Q() = v.P()[2];
        const MeshSimplification result = Decimated(mesh, Target(100));
        QCOMPARE(result.attributes.channels, std::size_t{1});
        QCOMPARE(result.attributes.attributes.front().name, std::string("vertex quality"));
    }

    /// A face has the texture of its side, at all three corners, and the border between both stays straight.
    void materialsKeepTheirFaces()
    {
        FloatPainted mesh;
        FillPlain(mesh, test_meshes::Grid(20, 20, 0.05));
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k) mesh.face[f].WT(k).N() = CentroidX(mesh, f) > 0.5 ? 1 : 0;
        const MeshSimplification result = Decimated(mesh, Target(20));
        QVERIFY(mesh.fn <= 20);
        QCOMPARE(result.report.attributes->charts, std::size_t{2});
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k) {
                const double side = mesh.face[f].WT(k).N() == 1 ? 1 : -1;
                QVERIFY(side * (static_cast<double>(mesh.face[f].V(k)->P()[0]) - 0.5) > -kSinglePrecision);
            }
    }

    /// Vertices that were doubled along a seam are doubled again: at the same points, each with the texture
    /// of its side. The texture is linear on either side, and so it is afterwards.
    void doubledVerticesMeetAgain()
    {
        FloatPainted mesh;
        const IndexedMesh sheet = CutSheet();
        FillPlain(mesh, sheet);
        auto name = vcg::tri::Allocator<FloatPainted>::AddPerVertexAttribute<int>(mesh, "name");
        for (std::size_t v = 0; v < mesh.vert.size(); ++v) name[v] = 5;
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            const bool right = CentroidX(mesh, f) > 0.5;
            for (int k = 0; k < 3; ++k) {
                auto* v = mesh.face[f].V(k);
                v->T().U() = v->P()[0] + (right ? 4.0f : 0.0f);
                v->T().V() = v->P()[1];
                v->T().N() = right ? 1 : 0;
                v->C() = vcg::Color4b(right ? 255 : 0, 100, 100, 255);
            }
        }
        for (const std::size_t target : {300U, 40U}) {
            Decimated(mesh, Target(target));
            QVERIFY(static_cast<std::size_t>(mesh.fn) <= target);
            std::map<std::pair<float, float>, std::set<int>> sides; // of points on the seam
            for (std::size_t f = 0; f < mesh.face.size(); ++f) {
                const bool right = CentroidX(mesh, f) > 0.5;
                for (int k = 0; k < 3; ++k) {
                    auto* v = mesh.face[f].V(k);
                    const float u = v->P()[0] + (right ? 4.0f : 0.0f);
                    QVERIFY(std::fabs(v->T().U() - u) < 1e-4f && std::fabs(v->T().V() - v->P()[1]) < 1e-4f);
                    QCOMPARE(static_cast<int>(v->T().N()), right ? 1 : 0);
                    QCOMPARE(static_cast<int>(v->C()[0]), right ? 255 : 0);
                    if (std::fabs(v->P()[0] - 0.5f) < 1e-5f)
                        sides[{v->P()[0], v->P()[1]}].insert(right ? 1 : 0);
                }
            }
            for (std::size_t v = 0; v < mesh.vert.size(); ++v) // the new ones, too
                QVERIFY(name[v] == 5 && mesh.vert[v].Q() == 3);
            QVERIFY(sides.size() >= 2);
            for (const auto& [point, both] : sides) QCOMPARE(both.size(), std::size_t{2});
            // Two halves: a disk each, with vertices of its own.
            QCOMPARE(test_meshes::FindDefects(test_meshes::Arrays(mesh)).eulerCharacteristic, 2);
        }
    }

    /// Vertices that were not doubled have one value, also where wedges are cut.
    void aVertexKeepsOneValue()
    {
        FloatPainted mesh;
        FillPlain(mesh, test_meshes::Icosphere(3));
        for (auto& v : mesh.vert)
            v.C() = vcg::Color4b(static_cast<unsigned char>(120 + 100 * v.P()[0]), 40, 60, 255);
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k) {
                mesh.face[f].WT(k).U() = mesh.face[f].V(k)->P()[1] + (CentroidX(mesh, f) > 0 ? 3.0f : 0.0f);
                mesh.face[f].WT(k).V() = mesh.face[f].V(k)->P()[2];
            }
        const MeshSimplification result = Decimated(mesh, Target(200));
        QCOMPARE(static_cast<std::size_t>(mesh.vn), result.mesh.positions.size());
        QCOMPARE(result.report.edges.boundary, std::size_t{0});
        for (auto& v : mesh.vert) { // 25: what an edge of the result is long, times the slope
            const double wanted = 120 + 100 * static_cast<double>(v.P()[0]);
            QVERIFY(std::fabs(v.C()[0] - wanted) < 25);
            QCOMPARE(static_cast<int>(v.C()[1]), 40);
        }
    }

    /// Colors are rounded and stay within the range of the input, also where the fit leaves it.
    void colorsStayInRange()
    {
        FloatPainted mesh;
        FillPlain(mesh, Sheet(30));
        for (auto& v : mesh.vert) {
            const bool inside = std::hypot(v.P()[0] - 0.5f, v.P()[1] - 0.5f) < 0.3f;
            v.C() = inside ? vcg::Color4b(255, 0, 100, 255) : vcg::Color4b(0, 255, 90, 128);
        }
        Decimated(mesh, Target(150));
        std::set<int> alphas;
        for (auto& v : mesh.vert) {
            QVERIFY(v.C()[2] >= 90 && v.C()[2] <= 100);
            QVERIFY(v.C()[3] >= 128);
            alphas.insert(v.C()[3]);
        }
        QVERIFY(alphas.count(255) && alphas.count(128));
        QCOMPARE(attribute_access_detail::ToByte(99.5 / 255), static_cast<unsigned char>(100));
        QCOMPARE(attribute_access_detail::ToByte(1.5), static_cast<unsigned char>(255));
        QCOMPARE(attribute_access_detail::ToByte(-0.1), static_cast<unsigned char>(0));
    }

    /// Hard colors of faces are theirs: none is mixed, and their border stays. Smooth ones are means of what
    /// the corners have become.
    void colorsOfFacesAreHardOrSmooth()
    {
        FloatPainted hard;
        FillPlain(hard, test_meshes::Grid(20, 20, 0.05));
        const auto side = [](bool right) { return vcg::Color4b(right ? 200 : 100, 0, 0, 255); };
        for (std::size_t f = 0; f < hard.face.size(); ++f) hard.face[f].C() = side(CentroidX(hard, f) > 0.5);
        Decimated(hard, Target(40));
        for (std::size_t f = 0; f < hard.face.size(); ++f)
            QVERIFY(hard.face[f].C() == side(CentroidX(hard, f) > 0.5));
        FloatPainted smooth;
        FillPlain(smooth, Sheet());
        const auto color = [&](std::size_t f) { return 20 + 200 * CentroidX(smooth, f); };
        for (std::size_t f = 0; f < smooth.face.size(); ++f)
            smooth.face[f].C() = vcg::Color4b(static_cast<unsigned char>(color(f)), 9, 9, 255);
        Decimated(smooth, Target(100));
        for (std::size_t f = 0; f < smooth.face.size(); ++f) { // 6: half a face of the input, and rounding
            QVERIFY2(std::fabs(smooth.face[f].C()[0] - color(f)) < 6, qPrintable(QString::number(f)));
            QCOMPARE(static_cast<int>(smooth.face[f].C()[1]), 9);
        }
    }

    /// The same of their quality and of custom attributes; a number that is a name is never mixed.
    void numbersOfFacesAreHardOrSmooth()
    {
        FloatPainted mesh;
        FillPlain(mesh, Sheet());
        auto part = vcg::tri::Allocator<FloatPainted>::AddPerFaceAttribute<double>(mesh, "part");
        auto place = vcg::tri::Allocator<FloatPainted>::AddPerFaceAttribute<vcg::Point3d>(mesh, "place");
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            part[f] =
                mesh.face[f].P(0)[1] + mesh.face[f].P(1)[1] + mesh.face[f].P(2)[1] > 1.5f ? 1e9 + 1 : 0.1;
            place[f] = {CentroidX(mesh, f), 2, -CentroidX(mesh, f)};
            mesh.face[f].Q() = static_cast<float>(1000 * CentroidX(mesh, f));
        }
        for (auto& v : mesh.vert) v.R() = 5 + v.P()[0];
        const MeshSimplification result = Decimated(mesh, Target(100));
        QCOMPARE(result.attributes.attributes.size(), std::size_t{3}); // without the parts
        for (auto& v : mesh.vert) QVERIFY(std::fabs(v.R() - 5 - v.P()[0]) < 1e-4f);
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            const auto& p = mesh.face[f];
            QCOMPARE(part[f], p.cP(0)[1] + p.cP(1)[1] + p.cP(2)[1] > 1.5f ? 1e9 + 1 : 0.1);
            const double x = CentroidX(mesh, f); // 0.02: half a face of the input
            QVERIFY(std::fabs(place[f][0] - x) < 0.02 && std::fabs(place[f][2] + x) < 0.02);
            QCOMPARE(place[f][1], 2.0);
            QVERIFY(std::fabs(static_cast<double>(p.cQ()) - 1000 * x) < 20);
        }
    }

    void colorsOfWedgesKeepTheirSeam()
    {
        FloatPainted mesh;
        FillPlain(mesh, test_meshes::Grid(16, 16, 1.0 / 16));
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k)
                mesh.face[f].WC(k) = vcg::Color4b(CentroidX(mesh, f) > 0.5, 0, 0, 255);
        Decimated(mesh, Target(30));
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k)
                QCOMPARE(static_cast<int>(mesh.face[f].WC(k)[0]), CentroidX(mesh, f) > 0.5 ? 1 : 0);
    }

    /// Deleted elements lie between the others, with numbers that are none.
    void deletedElementsAreNotRead()
    {
        FloatPainted mesh, clean;
        const IndexedMesh sphere = test_meshes::Icosphere(2), sheet = Sheet(12);
        FillPlain(mesh, test_meshes::Merged(sphere, sheet));
        FillPlain(clean, sheet);
        const auto paint = [](FloatPainted& painted) {
            for (auto& v : painted.vert) v.Q() = v.P()[0] + v.P()[1];
            for (auto& f : painted.face)
                for (int k = 0; k < 3; ++k) {
                    f.WT(k).U() = f.V(k)->P()[0];
                    f.WT(k).V() = f.V(k)->P()[1];
                }
        };
        paint(mesh);
        paint(clean);
        for (std::size_t f = 0; f < sphere.triangles.size(); ++f) {
            mesh.face[f].WT(1).U() = std::numeric_limits<float>::quiet_NaN();
            vcg::tri::Allocator<FloatPainted>::DeleteFace(mesh, mesh.face[f]);
        }
        for (std::size_t v = 0; v < sphere.points.size(); ++v) {
            mesh.vert[v].Q() = std::numeric_limits<float>::quiet_NaN();
            vcg::tri::Allocator<FloatPainted>::DeleteVertex(mesh, mesh.vert[v]);
        }
        const MeshSimplification result = Decimated(mesh, Target(50)),
                                 expected = Decimated(clean, Target(50));
        QCOMPARE(result.attributes.channels, std::size_t{3});
        QCOMPARE(expected.attributes.channels, std::size_t{3});
        QCOMPARE(mesh.fn, clean.fn);
        QCOMPARE(mesh.vn, clean.vn);
        for (std::size_t v = 0; v < clean.vert.size(); ++v) QCOMPARE(mesh.vert[v].Q(), clean.vert[v].Q());
        for (std::size_t f = 0; f < clean.face.size(); ++f)
            for (int k = 0; k < 3; ++k) QCOMPARE(mesh.face[f].WT(k).U(), clean.face[f].WT(k).U());
    }

    /// What is not selected keeps every bit: doubles that no float holds, and colors of faces.
    /// A vertex that is not selected stands for selected ones that are welded to it, but not with their
    /// values.
    void whatIsNotSelectedIsNoMean()
    {
        FloatPainted mesh;
        FillPlain(mesh, CutSheet());
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            const bool right = CentroidX(mesh, f) > 0.5;
            for (int k = 0; k < 3; ++k) mesh.face[f].V(k)->Q() = right ? 3 : 1;
            if (right) mesh.face[f].SetS();
        }
        auto parameters = Target(800);
        parameters.selectedOnly = true;
        const MeshSimplification result = Decimated(mesh, parameters);
        QVERIFY(result.report.cleaning && result.report.cleaning->weldedVertices > 0);
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k)
                if (!mesh.face[f].IsS()) QCOMPARE(mesh.face[f].V(k)->Q(), 1.0f);
    }

    void verticesOfNoFaceSayNothing()
    {
        FloatPainted mesh;
        IndexedMesh sheet = Sheet(12);
        sheet.points.push_back({0, 0, 0});
        FillPlain(mesh, sheet);
        for (auto& v : mesh.vert) v.Q() = v.P()[0];
        mesh.vert.back().Q() = std::numeric_limits<float>::quiet_NaN();
        QCOMPARE(Decimated(mesh, Target(50)).attributes.channels, std::size_t{1});
        for (const auto& v : mesh.vert) QVERIFY(std::fabs(v.cQ() - v.cP()[0]) < 1e-4f);
    }

    void whatIsNotSelectedKeepsItsBits()
    {
        DoublePainted mesh;
        FillPlain(mesh, test_meshes::Grid(20, 20, 0.05));
        const auto quality = [](const auto& p) { return 1 / (3 + p[0] + 7 * p[1]); };
        const auto color = [](const auto& p) {
            return vcg::Color4b(static_cast<unsigned char>(250 * p[0]),
                                static_cast<unsigned char>(250 * p[1]), 0, 255);
        };
        const auto centroid = [](auto& f) { return (f.V(0)->P() + f.V(1)->P() + f.V(2)->P()) / 3; };
        for (auto& v : mesh.vert) v.Q() = quality(v.P());
        for (auto& f : mesh.face) {
            f.C() = color(centroid(f));
            if (centroid(f)[0] > 0.5) f.SetS();
        }
        auto parameters = Target(500);
        parameters.selectedOnly = true;
        Decimated(mesh, parameters);
        QVERIFY(mesh.fn <= 500);
        int untouched = 0;
        for (auto& f : mesh.face) {
            if (f.IsS()) continue;
            ++untouched;
            QVERIFY(f.C() == color(centroid(f)));
            for (int k = 0; k < 3; ++k) QCOMPARE(f.V(k)->Q(), quality(f.V(k)->P()));
        }
        QCOMPARE(untouched, 400);
    }

    /// Quality that differs a little where vertices are doubled, as in files of triangles of their own, makes
    /// no seam: it would leave nothing to collapse.
    void qualityOfWeldedVerticesMakesNoSeam()
    {
        FloatPainted mesh;
        IndexedMesh soup;
        for (const auto& t : test_meshes::Icosphere(2).triangles) {
            const std::size_t first = soup.points.size();
            for (const std::uint32_t v : t) soup.points.push_back(test_meshes::Icosphere(2).points[v]);
            soup.AddTriangle(first, first + 1, first + 2);
        }
        FillPlain(mesh, soup);
        for (std::size_t v = 0; v < mesh.vert.size(); ++v) mesh.vert[v].Q() = static_cast<float>(v);
        const MeshSimplification result = Decimated(mesh, Target(60));
        QCOMPARE(result.report.stopReason, StopReason::Target);
        QCOMPARE(result.report.attributes->charts, std::size_t{1});
        QCOMPARE(static_cast<std::size_t>(mesh.vn), result.mesh.positions.size());
    }

    /// Texture coordinates of vertices that repeat those of the wedges are no second texture, and follow
    /// them.
    void texturesThatAreEqualAreOne()
    {
        FloatPainted mesh;
        FillPlain(mesh, Sheet());
        for (auto& v : mesh.vert) {
            v.T().U() = v.P()[0] * v.P()[0];
            v.T().V() = v.P()[1];
        }
        for (auto& f : mesh.face)
            for (int k = 0; k < 3; ++k) f.WT(k) = f.V(k)->T();
        const MeshSimplification result = Decimated(mesh, Target(80));
        QCOMPARE(result.attributes.channels, std::size_t{2});
        for (auto& f : mesh.face)
            for (int k = 0; k < 3; ++k) QCOMPARE(f.WT(k).U(), f.V(k)->T().U());
    }

    /// A quality that is no number guides nothing and stays; texture coordinates that are none are refused.
    void whatIsNoNumberIsLeftOutOrRefused()
    {
        FloatPainted mesh;
        FillPlain(mesh, Sheet(8));
        mesh.vert[5].Q() = std::numeric_limits<float>::infinity();
        QVERIFY(!Decimate(mesh, Target(50)).report.attributes);
        mesh.face[7].WT(2).V() = std::numeric_limits<float>::quiet_NaN();
        try {
            Decimate(mesh, Target(50));
            QFAIL("accepted");
        } catch (const std::invalid_argument& error) {
            QCOMPARE(QString(error.what()), QString("the attributes of 1 of 128 faces are not finite"));
        }
        auto without = Target(50);
        without.keepAttributes = false;
        QVERIFY(Decimate(mesh, without).report.faces <= 50);
    }
};

QTEST_GUILESS_MAIN(TestMeshAttributes)
#include "test_mesh_attributes.moc"
