// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <map>
#include <string>

#include "mesh_checks.h"
#include "test_meshes.h"
#include "vcg_ext/ordered/decimate.h"
#include "vcg_ext/ordered/guided.h"

using namespace vcg_ext;
using namespace test_meshes;

namespace
{

/// A collapse that looks at every face around an edge before and after.
template <class Mesh, class Base>
class WatchedCollapse : public Base
{
    using VertexType = typename Mesh::VertexType;
    using FaceType = typename Mesh::FaceType;
    std::map<const FaceType*, vcg::Point3d> normals_;

    static vcg::Point3d Normal(const FaceType& face)
    {
        const auto p = vcg::Point3d::Construct(face.cP(0));
        return (vcg::Point3d::Construct(face.cP(1)) - p) ^ (vcg::Point3d::Construct(face.cP(2)) - p);
    }

  public:
    double smallestCosine = 1;
    int collapses = 0;

    using Base::Base;

    typename Mesh::CoordType Merge(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        normals_.clear();
        for (VertexType* end : {&removed, &kept})
            for (vcg::face::VFIterator<FaceType> corner(end); !corner.End(); ++corner)
                normals_[corner.F()] = Normal(*corner.F());
        ++collapses;
        return Base::Merge(removed, kept, placement);
    }

    void Refresh(VertexType& kept, const std::vector<RingEdge<Mesh>>& ring)
    {
        for (vcg::face::VFIterator<FaceType> corner(&kept); !corner.End(); ++corner) {
            const vcg::Point3d before = normals_.at(corner.F()), after = Normal(*corner.F());
            if (before.Norm() > 0)
                smallestCosine = std::min(smallestCosine,
                                          before.dot(after) / std::max(before.Norm() * after.Norm(), 1e-300));
        }
        Base::Refresh(kept, ring);
    }
};

IndexedMesh ResultOf(const OrderedDecimation& decimation)
{
    IndexedMesh mesh;
    mesh.points = decimation.mesh.positions;
    mesh.triangles = decimation.mesh.triangles;
    return mesh;
}

OrderedDecimation Decimated(const IndexedMesh& mesh, std::size_t faces, DecimationParameters parameters = {})
{
    parameters.targetFaces = faces;
    return DecimateOrdered(View(mesh), parameters);
}

std::map<std::string, IndexedMesh> Families()
{
    return {{"grid", Grid(12, 9)},
            {"noisy grid", Noisy(Grid(16, 16), .2)},
            {"box", Box(7)},
            {"icosphere", Icosphere(3)},
            {"noisy icosphere", Noisy(Icosphere(3), .05)},
            {"torus", Torus(24, 12)},
            {"open cylinder", OpenCylinder(20, 9)},
            {"book", Book(4)},
            {"bow tie", BowTie()},
            {"two components", Merged(Icosphere(2), Box(4))},
            {"pyramid", Pyramid(40)},
            {"thin torus", Noisy(Torus(60, 6, 1, .03), .01)}};
}

double DistanceToUnitSphere(const IndexedMesh& mesh)
{
    double sum = 0;
    for (const Point& p : mesh.points) sum += std::abs(std::hypot(p[0], p[1], p[2]) - 1);
    return sum / static_cast<double>(mesh.points.size());
}

} // namespace

Q_DECLARE_METATYPE(test_meshes::IndexedMesh)

class TestOrdered : public QObject
{
    Q_OBJECT

    template <class Mesh>
    void runsInPlaceOn();

    template <class Method>
    static double smallestTurnCosine(const IndexedMesh& mesh, std::size_t target)
    {
        DoubleMesh work;
        Fill(work, mesh);
        vcg::tri::UpdateTopology<DoubleMesh>::VertexFace(work);
        using Watched = WatchedCollapse<DoubleMesh, Method>;
        Watched method(work, GuidedParameters());
        CollapseRun<DoubleMesh, Watched>(work, method).Decimate(target, {});
        return method.smallestCosine;
    }

    static void addFamilies()
    {
        QTest::addColumn<IndexedMesh>("mesh");
        QTest::addColumn<int>("percent");
        for (const auto& [name, mesh] : Families())
            for (const int percent : {50, 10, 2})
                QTest::newRow((name + " " + std::to_string(percent) + " %").c_str()) << mesh << percent;
    }

  private slots:
    void turnsNoFaceByMoreThan78Degrees_data() { addFamilies(); }
    void turnsNoFaceByMoreThan78Degrees();
    void addsNoDefect_data() { addFamilies(); }
    void addsNoDefect();
    void linkConditionKeepsTheTopology_data() { addFamilies(); }
    void linkConditionKeepsTheTopology();
    void reachesTargetsThatCanBeReached();
    void saysWhyATargetIsOutOfReach();
    void closesHolesOnlyWhereTheTargetNeedsIt();
    void planeStaysExact();
    void boxKeepsItsCorners();
    void flatPartsAndStraightCreasesKeepTheirPlaces();
    void doesNotDependOnSizeAndPlace();
    void keepsFixedVerticesAndLockedBorders();
    void preservedBorderKeepsItsCourse();
    void rootsLeadToSurvivors();
    void twoRunsGiveTheSameBytes();
    void weightMovesFacesToFeatures();
    void theTipOfAFoldKnowsItsOutline();
    void stopsWhenProgressSaysSo();
    void ignoresDegenerateFacesAndIsolatedVertices();
    void runsOnFloatMeshes() { runsInPlaceOn<FloatMesh>(); }
    void runsOnDoubleMeshes() { runsInPlaceOn<DoubleMesh>(); }
    void runsOnMeshesWithOptionalComponents() { runsInPlaceOn<OcfMesh>(); }
};

void TestOrdered::turnsNoFaceByMoreThan78Degrees()
{
    QFETCH(IndexedMesh, mesh);
    QFETCH(int, percent);
    const std::size_t target =
        std::max<std::size_t>(1, mesh.triangles.size() * static_cast<std::size_t>(percent) / 100);
    QVERIFY((smallestTurnCosine<GuidedCollapse<DoubleMesh>>(mesh, target) >= double{kTurnCosine} - 1e-9));
}

void TestOrdered::addsNoDefect()
{
    QFETCH(IndexedMesh, mesh);
    QFETCH(int, percent);
    const std::size_t target =
        std::max<std::size_t>(1, mesh.triangles.size() * static_cast<std::size_t>(percent) / 100);
    const Defects before = FindDefects(mesh);
    const OrderedDecimation decimation = Decimated(mesh, target);
    const Defects after = FindDefects(ResultOf(decimation));
    QVERIFY(after.nonManifoldEdges <= before.nonManifoldEdges);
    QVERIFY(after.nonManifoldFans <= before.nonManifoldFans);
    QCOMPARE(after.duplicateFaces, 0);
    QCOMPARE(after.degenerateFaces, 0);
    QCOMPARE(decimation.mesh.stopReason == StopReason::Target, decimation.mesh.triangles.size() <= target);
}

void TestOrdered::linkConditionKeepsTheTopology()
{
    QFETCH(IndexedMesh, mesh);
    QFETCH(int, percent);
    DecimationParameters parameters;
    parameters.preserveTopology = true;
    const auto result = ResultOf(Decimated(
        mesh, std::max<std::size_t>(1, mesh.triangles.size() * static_cast<std::size_t>(percent) / 100),
        parameters));
    QCOMPARE(FindDefects(result).eulerCharacteristic, FindDefects(mesh).eulerCharacteristic);
}

void TestOrdered::reachesTargetsThatCanBeReached()
{
    QCOMPARE(Decimated(Grid(20, 20), 2).mesh.triangles.size(), std::size_t(2));
    QCOMPARE(Decimated(Box(6), 12).mesh.triangles.size(), std::size_t(12));
    QVERIFY(Decimated(Icosphere(4), 20).mesh.triangles.size() <= 20);
    QVERIFY(Decimated(Torus(40, 20), 60).mesh.triangles.size() <= 60);
    QCOMPARE(Decimated(Icosphere(1), 1000).mesh.triangles.size(), Icosphere(1).triangles.size());
}

void TestOrdered::saysWhyATargetIsOutOfReach()
{
    const OrderedDecimation closed = Decimated(Icosphere(2), 1);
    QCOMPARE(closed.mesh.stopReason, StopReason::NoLegalCollapse);
    QVERIFY(closed.mesh.triangles.size() >= 4);
    DecimationParameters parameters;
    parameters.boundary = Boundary::Lock;
    const OrderedDecimation locked = Decimated(Grid(1, 10), 2, parameters);
    QCOMPARE(locked.mesh.stopReason, StopReason::NoLegalCollapse);
    QCOMPARE(locked.mesh.triangles.size(), std::size_t(20));
}

void TestOrdered::planeStaysExact()
{
    IndexedMesh tilted = Moved(Grid(15, 15), .7, 3, {100, -20, 5});
    const Point origin = tilted.points[0], a = tilted.points[1], b = tilted.points[16];
    const auto height = [&](const Point& p) {
        vcg::Point3d n = vcg::Point3d(a[0] - origin[0], a[1] - origin[1], a[2] - origin[2]) ^
                         vcg::Point3d(b[0] - origin[0], b[1] - origin[1], b[2] - origin[2]);
        n.Normalize();
        return std::abs(n.dot(vcg::Point3d(p[0] - origin[0], p[1] - origin[1], p[2] - origin[2])));
    };
    const IndexedMesh result = ResultOf(Decimated(tilted, 40));
    double area = 0;
    for (const Triangle& t : result.triangles) area += TriangleArea(result, t);
    for (const Point& p : result.points) QVERIFY(height(p) < 1e-10);
    QVERIFY(std::abs(area - 15. * 15 * 9) < 1e-6);
}

void TestOrdered::boxKeepsItsCorners()
{
    const IndexedMesh result = ResultOf(Decimated(Box(10, 2.5), 12));
    QCOMPARE(result.points.size(), std::size_t(8));
    for (const Point& p : result.points)
        for (const double x : p) QVERIFY(std::min(std::abs(x), std::abs(x - 2.5)) < 1e-9);
}

void TestOrdered::flatPartsAndStraightCreasesKeepTheirPlaces()
{
    const IndexedMesh box = Moved(Box(12), 1, .3, {.1, .2, .3});
    const DecimatedMesh result = Decimated(box, 1200).mesh; // of 1728
    std::size_t kept = 0;
    for (std::size_t v = 0; v < result.positions.size(); ++v) {
        const auto there = std::find(box.points.begin(), box.points.end(), result.positions[v]);
        if (there == box.points.end()) continue;
        ++kept;
        // The vertex that was there is the one that has survived.
        QCOMPARE(result.vertexOrigin[v], static_cast<std::uint32_t>(there - box.points.begin()));
    }
    // Few edges have no end at which all faces of the ring, which are in rows, keep an area.
    QVERIFY(kept > result.positions.size() * 95 / 100);
}

void TestOrdered::doesNotDependOnSizeAndPlace()
{
    const IndexedMesh mesh = Noisy(Icosphere(4), .01);
    const auto expected = Decimated(mesh, 500);
    // A power of two scales every number of the run without rounding.
    QVERIFY(Decimated(Moved(mesh, 0, 1024, {0, 0, 0}), 500).mesh.triangles == expected.mesh.triangles);
    const double error = DistanceToUnitSphere(ResultOf(expected));
    for (const double scale : {1e-3, 1e6})
        for (const double offset : {0., 1e5}) {
            const Point shift{offset * scale, -offset * scale, offset * scale};
            IndexedMesh result = ResultOf(Decimated(Moved(mesh, 0, scale, shift), 500));
            for (Point& p : result.points)
                for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] - shift[k]) / scale;
            QCOMPARE(result.triangles.size(), std::size_t(500));
            QVERIFY(std::abs(DistanceToUnitSphere(result) - error) < .1 * error);
        }
}

void TestOrdered::keepsFixedVerticesAndLockedBorders()
{
    const IndexedMesh mesh = Noisy(Grid(20, 20), .2);
    std::vector<std::uint8_t> fixed(mesh.points.size(), 0);
    for (std::size_t v = 200; v < 240; ++v) fixed[v] = 1;
    MeshView view = View(mesh);
    view.fixedVertices = fixed.data();
    DecimationParameters parameters;
    parameters.boundary = Boundary::Lock;
    parameters.targetFaces = 160;
    const OrderedDecimation decimation = DecimateOrdered(view, parameters);
    QVERIFY(decimation.mesh.triangles.size() <= 170);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const bool onBorder = v % 21 == 0 || v % 21 == 20 || v < 21 || v >= 420;
        if (!onBorder && fixed[v] == 0) continue;
        const std::uint32_t root = decimation.root[v];
        QVERIFY(root != OrderedDecimation::kNoVertex);
        QCOMPARE(std::size_t(decimation.mesh.vertexOrigin[root]), v);
        QVERIFY(decimation.mesh.positions[root] == mesh.points[v]);
    }
}

void TestOrdered::preservedBorderKeepsItsCourse()
{
    // Border planes hold the straight sides; without them the sheet may shrink, never grow.
    DecimationParameters parameters;
    const IndexedMesh sheet = Grid(30, 30, 1. / 30);
    const auto area = [](const IndexedMesh& mesh) {
        double sum = 0;
        for (const Triangle& t : mesh.triangles) sum += TriangleArea(mesh, t);
        return sum;
    };
    QVERIFY(std::abs(area(ResultOf(Decimated(sheet, 60, parameters))) - 1) < 1e-9);
    parameters.boundary = Boundary::Free;
    const double freeArea = area(ResultOf(Decimated(sheet, 60, parameters)));
    QVERIFY(freeArea > 0 && freeArea < 1 + 1e-9);
}

void TestOrdered::rootsLeadToSurvivors()
{
    const IndexedMesh mesh = Noisy(Icosphere(3), .02);
    const OrderedDecimation decimation = Decimated(mesh, 200);
    for (const std::uint32_t root : decimation.root) QVERIFY(root < decimation.mesh.positions.size());
    for (std::size_t v = 0; v < decimation.mesh.positions.size(); ++v)
        QCOMPARE(std::size_t(decimation.root[decimation.mesh.vertexOrigin[v]]), v);
    QVERIFY(std::is_sorted(decimation.mesh.vertexOrigin.begin(), decimation.mesh.vertexOrigin.end()));
    QVERIFY(std::is_sorted(decimation.mesh.faceOrigin.begin(), decimation.mesh.faceOrigin.end()));
}

void TestOrdered::closesHolesOnlyWhereTheTargetNeedsIt()
{
    IndexedMesh mesh = Icosphere(3);
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4); // two holes: with both of them
    mesh.triangles.resize(mesh.triangles.size() - 4);                         // six faces are the fewest
    DecimationParameters parameters;
    QVERIFY(FindDefects(ResultOf(Decimated(mesh, 100, parameters))).borderEdges > 0);
    const OrderedDecimation closed = Decimated(mesh, 4, parameters);
    QCOMPARE(closed.mesh.stopReason, StopReason::Target);
    const auto defects = FindDefects(ResultOf(closed));
    QVERIFY(defects.borderEdges <= 3);
    QCOMPARE(defects.nonManifoldEdges + defects.nonManifoldFans + defects.duplicateFaces, 0);
    parameters.preserveTopology = true;
    const OrderedDecimation open = Decimated(mesh, 1, parameters);
    QCOMPARE(open.mesh.stopReason, StopReason::NoLegalCollapse);
    QVERIFY(FindDefects(ResultOf(open)).borderEdges > 0);
}

void TestOrdered::twoRunsGiveTheSameBytes()
{
    const IndexedMesh mesh = Noisy(Torus(40, 20), .02);
    const OrderedDecimation first = Decimated(mesh, 300);
    Decimated(Noisy(Icosphere(3), .1), 100);
    const OrderedDecimation second = Decimated(mesh, 300);
    QVERIFY(first.mesh.positions == second.mesh.positions);
    QVERIFY(first.mesh.triangles == second.mesh.triangles);
    QVERIFY(first.root == second.root);
}

void TestOrdered::weightMovesFacesToFeatures()
{
    // Half of a bumpy sheet is called important: with lambda it keeps more of the vertices.
    const IndexedMesh mesh = Noisy(Grid(40, 40), .2);
    std::vector<float> guidance(mesh.points.size());
    for (std::size_t v = 0; v < guidance.size(); ++v) guidance[v] = mesh.points[v][0] > 20 ? 1.F : 0.F;
    MeshView view = View(mesh);
    view.guidance = guidance.data();
    const auto share = [&](double lambda) {
        DecimationParameters parameters;
        parameters.featureWeight = lambda;
        parameters.targetFaces = 320;
        const auto result = DecimateOrdered(view, parameters).mesh;
        const auto right = std::count_if(result.positions.begin(), result.positions.end(),
                                         [](const Point& p) { return p[0] > 20; });
        return static_cast<double>(right) / static_cast<double>(result.positions.size());
    };
    const double plain = share(0), guided = share(2), strong = share(6);
    QVERIFY(plain < .6);
    QVERIFY(guided > plain + .05);
    QVERIFY(strong > guided + .05);
}

void TestOrdered::theTipOfAFoldKnowsItsOutline()
{
    // A tetrahedron pressed flat: around its square the faces turn by 180 degrees.
    const IndexedMesh flat{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, {}};
    const MeshView view = View(flat);
    CollapsibleMesh mesh(view);
    Guidance plain;
    plain.featureWeight = 0;
    const GuidedStars<OrderedMesh> stars(mesh.mesh(), plain, Boundary::Preserve);
    constexpr double kSide2 = 1024. * 1024 / 2; // in the frame, whose diagonal is 1024
    for (std::size_t v = 0; v < 4; ++v) {
        const auto& planes = stars.end(v).history.matrix;
        for (const double inPlane : {planes.xx, planes.yy}) // two faces, one edge; the weight is a float
            QVERIFY(std::abs(inPlane / (.7 * 2 * kSide2) - 1) < 1e-6);
    }
}

void TestOrdered::stopsWhenProgressSaysSo()
{
    DecimationParameters parameters;
    parameters.targetFaces = 100;
    int calls = 0, last = 0;
    const StageProgress progress([&](int percent, const char*) {
        if (percent < last || percent > 100) calls = 1000;
        last = percent;
        return ++calls < 10;
    });
    const IndexedMesh mesh = Icosphere(4);
    QVERIFY_EXCEPTION_THROWN(DecimateOrdered(View(mesh), parameters, progress), Cancelled);
    QCOMPARE(calls, 10);
}

void TestOrdered::ignoresDegenerateFacesAndIsolatedVertices()
{
    IndexedMesh mesh = WithIsolatedVertices(Icosphere(2), 3);
    mesh.triangles.push_back({1, 1, 2});
    mesh.triangles.push_back({5, 5, 5});
    const OrderedDecimation decimation = Decimated(mesh, 100);
    QCOMPARE(FindDefects(ResultOf(decimation)).degenerateFaces, 0);
    QVERIFY(decimation.root.back() == OrderedDecimation::kNoVertex);
    QVERIFY(decimation.mesh.triangles.size() <= 100);

    IndexedMesh point; // all vertices in one place
    point.points.assign(4, {3, 3, 3});
    point.triangles = {{0, 1, 2}, {0, 2, 3}};
    QVERIFY(Decimated(point, 1).mesh.triangles.size() <= 2);
}

template <class Mesh>
void TestOrdered::runsInPlaceOn()
{
    Mesh mesh;
    if constexpr (std::is_same_v<Mesh, OcfMesh>) {
        mesh.vert.EnableVFAdjacency();
        mesh.vert.EnableMark();
        mesh.face.EnableVFAdjacency();
    }
    Fill(mesh, Noisy(Icosphere(3), .02));
    vcg::tri::UpdateTopology<Mesh>::VertexFace(mesh);
    GuidedCollapse<Mesh> method(mesh, GuidedParameters());
    CollapseRun<Mesh, GuidedCollapse<Mesh>> run(mesh, method);
    QCOMPARE(run.Decimate(200, {}), StopReason::Target);
    QCOMPARE(mesh.fn, 200);
    const IndexedMesh result = Arrays(mesh);
    const Defects defects = FindDefects(result);
    QCOMPARE(defects.borderEdges + defects.nonManifoldEdges + defects.nonManifoldFans, 0);
    QCOMPARE(defects.eulerCharacteristic, 2);
    QVERIFY(DistanceToUnitSphere(result) < .05);
}

QTEST_APPLESS_MAIN(TestOrdered)
#include "test_ordered.moc"
