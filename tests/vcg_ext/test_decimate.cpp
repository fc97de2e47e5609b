// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cmath>
#include <limits>
#include <set>

#include "test_meshes.h"
#include "vcg_ext/core/crossings/crossing_keeper.h"
#include "vcg_ext/decimate.h"

using namespace vcg_ext;
using test_meshes::DoubleMesh;
using test_meshes::FloatMesh;
using test_meshes::OcfMesh;

Q_DECLARE_METATYPE(vcg_ext::Order)
Q_DECLARE_METATYPE(vcg_ext::Effort)

namespace
{

MeshDecimationParameters Target(std::size_t faces)
{
    MeshDecimationParameters parameters;
    parameters.targetFaces = faces;
    parameters.threads = 1;
    parameters.measureError = false; // with its many samples that is the slowest part under the sanitizers
    return parameters;
}

template <class Mesh>
DistanceReport Measured(const Mesh& original, const Simplification& result)
{
    constexpr std::size_t kSamples = 3000;
    const MeshArrays<Mesh> arrays(original);
    return MeasureDistances(arrays.View(), result.mesh, std::vector<float>(original.vert.size(), 0), kSamples,
                            1);
}

template <class Mesh>
std::string Refusal(const Mesh& mesh, const MeshDecimationParameters& parameters)
{
    try {
        Decimate(mesh, parameters);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

/// Two wavy sheets that meet at equal coordinates, not joined, and a vertex on no face.
test_meshes::IndexedMesh SheetsThatMeet()
{
    const test_meshes::IndexedMesh sheet = test_meshes::Grid(12, 12);
    auto mesh = test_meshes::Merged(sheet, test_meshes::Moved(sheet, 0, 1, {12, 0, 0}));
    for (auto& p : mesh.points) p[2] = std::sin(p[0]) * std::cos(0.7 * p[1]);
    return test_meshes::WithIsolatedVertices(mesh, 1);
}

/// How many of the vertices that are selected in \p original are not there, with the same bits, in what
/// Decimate and ApplyDecimation make of it.
template <class Mesh>
std::size_t SelectedThatChanged(const Mesh& original, Mesh& decimated, const Simplification& result)
{
    std::vector<std::uint8_t> stayed(original.vert.size(), 0);
    ApplyDecimation(decimated, result.mesh, true);
    for (std::size_t v = 0; v < decimated.vert.size(); ++v) {
        const auto& before = original.vert[result.mesh.vertexOrigin[v]];
        stayed[result.mesh.vertexOrigin[v]] = decimated.vert[v].cP() == before.cP();
    }
    std::size_t changed = 0;
    for (std::size_t v = 0; v < stayed.size(); ++v)
        changed += !original.vert[v].IsD() && original.vert[v].IsS() && !stayed[v];
    return changed;
}

template <class Mesh>
void CheckLocked(const MeshDecimationParameters& parameters)
{
    Mesh original, mesh;
    for (Mesh* copy : {&original, &mesh}) {
        test_meshes::Fill(*copy, SheetsThatMeet());
        for (std::size_t v = 0; v < copy->vert.size(); v += 7) copy->vert[v].SetS();
        copy->vert.back().SetS(); // of no face
        for (auto& face : copy->face)
            if (face.cP(0)[1] < 9) face.SetS(); // for selectedOnly
        vcg::tri::Allocator<Mesh>::AddVertex(*copy, typename Mesh::CoordType(1, 2, 3))->SetS();
        vcg::tri::Allocator<Mesh>::DeleteVertex(*copy, copy->vert.back()); // not there, though selected
    }
    const Simplification result = Decimate(mesh, parameters);
    QVERIFY(result.report.faces < 400); // of 576
    QVERIFY(result.report.stopReason != StopReason::Cancelled);
    QCOMPARE(SelectedThatChanged(original, mesh, result), std::size_t{0});
    QCOMPARE(mesh.vert.size(), result.mesh.vertexOrigin.size());
}

/// Every adjacency pointer leads to a live face that shares the edge.
template <class Mesh>
bool FaceAdjacencyIsRight(Mesh& mesh)
{
    for (auto& face : mesh.face) {
        for (int k = 0; k < 3; ++k) {
            const auto* other = face.FFp(k);
            if (other < &mesh.face.front() || other > &mesh.face.back()) return false;
            const auto j = static_cast<unsigned char>(face.FFi(k));
            const std::set<const void*> mine{face.V0(k), face.V1(k)}, theirs{other->cV0(j), other->cV1(j)};
            if (mine != theirs) return false;
        }
    }
    return true;
}

} // namespace

class TestDecimation : public QObject
{
    Q_OBJECT

  private slots:
    void everyOrderAndEffortReachesTheTarget_data()
    {
        QTest::addColumn<Order>("order");
        QTest::addColumn<Effort>("effort");
        const std::pair<const char*, Order> orders[] = {{"sweeps", Order::Sweeps}, {"strict", Order::Strict}};
        const std::pair<const char*, Effort> efforts[] = {
            {"fast", Effort::Fast}, {"balanced", Effort::Balanced}, {"best", Effort::Best}};
        for (const auto& [orderName, order] : orders)
            for (const auto& [effortName, effort] : efforts)
                QTest::addRow("%s %s", orderName, effortName) << order << effort;
    }
    void everyOrderAndEffortReachesTheTarget()
    {
        QFETCH(Order, order);
        QFETCH(Effort, effort);
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Torus(48, 24));
        auto parameters = Target(400);
        parameters.order = order;
        parameters.effort = effort;
        const Simplification result = Decimate(mesh, parameters);
        QVERIFY(result.report.targetReached);
        QCOMPARE(result.report.stopReason, StopReason::Target);
        QVERIFY(result.report.faces <= 400 && result.report.faces >= 398); // two faces a collapse
        QCOMPARE(result.report.facesBefore, std::size_t{2304});
        QCOMPARE(result.report.edges.nonManifold, std::size_t{0});
        QCOMPARE(result.report.edges.boundary, std::size_t{0});
        const DistanceReport distances = Measured(mesh, result);
        QCOMPARE(distances.folded, std::size_t{0});
        QVERIFY(distances.hausdorff < 3); // a regular torus of 400 faces is within 2.2 %
        QCOMPARE(mesh.fn, 2304);          // untouched
    }

    void refinementLowersTheErrorInBothOrders()
    {
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Noisy(test_meshes::Torus(64, 32), 0.003));
        for (const Order order : {Order::Sweeps, Order::Strict}) {
            auto parameters = Target(600);
            parameters.order = order;
            parameters.effort = Effort::Fast;
            const double collapsed = Measured(mesh, Decimate(mesh, parameters)).rms;
            parameters.effort = Effort::Balanced;
            QVERIFY(Measured(mesh, Decimate(mesh, parameters)).rms < collapsed);
        }
    }

    void reportsDistancesOnlyWhereAskedTo()
    {
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Torus(12, 8));
        auto parameters = Target(100);
        QVERIFY(!Decimate(mesh, parameters).report.distances);
        parameters.measureError = true;
        QVERIFY(Decimate(mesh, parameters).report.distances->rms > 0);
    }

    void appliedMeshIsTheResult()
    {
        DoubleMesh mesh;
        test_meshes::Fill(mesh, test_meshes::WithIsolatedVertices(test_meshes::Torus(24, 12), 2));
        for (auto& vertex : mesh.vert) vertex.Q() = static_cast<double>(vcg::tri::Index(mesh, vertex));
        vcg::tri::UpdateTopology<DoubleMesh>::FaceFace(mesh);
        const Simplification result = Decimate(mesh, Target(100));
        ApplyDecimation(mesh, result.mesh);
        QCOMPARE(static_cast<std::size_t>(mesh.fn), result.report.faces);
        QCOMPARE(mesh.face.size(), result.report.faces);                         // compact
        QCOMPARE(static_cast<std::size_t>(mesh.vn), result.report.vertices + 2); // what was on no face stays
        for (std::size_t v = 0; v < result.mesh.positions.size(); ++v) {
            const auto& p = result.mesh.positions[v];
            QCOMPARE(mesh.vert[v].P(), vcg::Point3d(p[0], p[1], p[2]));
            QCOMPARE(mesh.vert[v].Q(), static_cast<double>(result.mesh.vertexOrigin[v])); // attributes follow
        }
        for (std::size_t f = 0; f < mesh.face.size(); ++f)
            for (int k = 0; k < 3; ++k)
                QCOMPARE(vcg::tri::Index(mesh, mesh.face[f].V(k)),
                         static_cast<std::size_t>(result.mesh.triangles[f][static_cast<std::size_t>(k)]));
        QVERIFY(FaceAdjacencyIsRight(mesh));
    }

    void meshesWithOptionalComponentsWork()
    {
        OcfMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Torus(24, 12));
        ApplyDecimation(mesh, Decimate(mesh, Target(100)).mesh); // nothing enabled
        QVERIFY(mesh.fn <= 100);
        mesh.face.EnableFFAdjacency();
        mesh.face.EnableVFAdjacency();
        mesh.vert.EnableVFAdjacency();
        vcg::tri::UpdateTopology<OcfMesh>::FaceFace(mesh);
        vcg::tri::UpdateTopology<OcfMesh>::VertexFace(mesh);
        ApplyDecimation(mesh, Decimate(mesh, Target(50)).mesh);
        QVERIFY(mesh.fn <= 50);
        QVERIFY(FaceAdjacencyIsRight(mesh));
    }

    void deletedElementsAreSkipped()
    {
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Merged(test_meshes::Torus(24, 12), test_meshes::Box(2, 100)));
        const std::size_t torusFaces = 2 * 24 * 12;
        for (std::size_t f = torusFaces; f < mesh.face.size(); f++)
            vcg::tri::Allocator<FloatMesh>::DeleteFace(mesh, mesh.face[f]);
        for (std::size_t v = 24 * 12; v < mesh.vert.size(); ++v)
            vcg::tri::Allocator<FloatMesh>::DeleteVertex(mesh, mesh.vert[v]);
        FloatMesh clean;
        test_meshes::Fill(clean, test_meshes::Torus(24, 12));
        const Simplification ours = Decimate(mesh, Target(100)), expected = Decimate(clean, Target(100));
        QVERIFY(ours.mesh.positions == expected.mesh.positions); // the far box does not even scale the frame
        QVERIFY(ours.mesh.triangles == expected.mesh.triangles);
        ApplyDecimation(mesh, ours.mesh);
        QCOMPARE(static_cast<std::size_t>(mesh.fn), ours.report.faces);
        QCOMPARE(mesh.face.size(), ours.report.faces);
    }

    void unselectedFacesStayWhereTheyAre_data() { everyOrderAndEffortReachesTheTarget_data(); }
    void unselectedFacesStayWhereTheyAre()
    {
        QFETCH(Order, order);
        QFETCH(Effort, effort);
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Noisy(test_meshes::Grid(20, 20), 0.1));
        std::multiset<std::array<float, 9>> before, after;
        const auto corners = [](const test_meshes::FloatFace& face) {
            std::array<float, 9> xyz{};
            for (int k = 0; k < 9; ++k) xyz[static_cast<std::size_t>(k)] = face.cP(k / 3)[k % 3];
            return xyz;
        };
        for (auto& face : mesh.face) {
            if (face.cP(0)[0] < 10)
                face.SetS();
            else
                before.insert(corners(face));
        }
        const std::size_t selected = mesh.face.size() - before.size();
        auto parameters = Target(before.size() + selected / 4);
        parameters.selectedOnly = true;
        parameters.order = order;
        parameters.effort = effort;
        const Simplification result = Decimate(mesh, parameters);
        QVERIFY(result.report.targetReached);
        ApplyDecimation(mesh, result.mesh);
        for (const auto& face : mesh.face)
            if (!face.IsS()) after.insert(corners(face));
        QVERIFY(before == after);
    }

    void lockedVerticesStayToTheBit_data()
    {
        QTest::addColumn<Order>("order");
        QTest::addColumn<Effort>("effort");
        QTest::addColumn<double>("maxError");
        QTest::addColumn<bool>("selectedOnly");
        QTest::newRow("sweeps fast") << Order::Sweeps << Effort::Fast << 0.0 << false;
        QTest::newRow("sweeps balanced") << Order::Sweeps << Effort::Balanced << 0.0 << false;
        QTest::newRow("sweeps best") << Order::Sweeps << Effort::Best << 0.0 << false;
        QTest::newRow("strict fast") << Order::Strict << Effort::Fast << 0.0 << false;
        QTest::newRow("strict balanced") << Order::Strict << Effort::Balanced << 0.0 << false;
        QTest::newRow("strict best") << Order::Strict << Effort::Best << 0.0 << false;
        QTest::newRow("bound") << Order::Sweeps << Effort::Balanced << 2.0 << false;
        QTest::newRow("selection") << Order::Sweeps << Effort::Balanced << 0.0 << true;
        QTest::newRow("strict selection") << Order::Strict << Effort::Balanced << 0.0 << true;
    }
    void lockedVerticesStayToTheBit()
    {
        QFETCH(Order, order);
        QFETCH(Effort, effort);
        QFETCH(double, maxError);
        QFETCH(bool, selectedOnly);
        auto parameters = Target(200);
        parameters.lockSelectedVertices = true;
        parameters.boundary = Boundary::Free;
        parameters.order = order;
        parameters.effort = effort;
        parameters.maxError = maxError;
        parameters.selectedOnly = selectedOnly;
        for (const double weldDistance :
             {0.0, 1.0}) { // the diagonal is 26.8, so no more than the seam is welded
            parameters.weldDistance = weldDistance;
            CheckLocked<FloatMesh>(parameters);
            CheckLocked<DoubleMesh>(parameters);
        }
    }

    void polygonsThatAreLeftKeepTheirDiagonals()
    {
        DoubleMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Torus(24, 12, 1, 0.4, true));
        ApplyDecimation(mesh, Decimate(mesh, Target(300)).mesh);
        vcg::tri::UpdateTopology<DoubleMesh>::FaceFace(mesh);
        int faux = 0;
        for (auto& face : mesh.face) {
            for (int k = 0; k < 3; ++k) {
                if (!face.IsF(k)) continue;
                ++faux;
                QVERIFY(face.FFp(k) != &face);
                QVERIFY(face.FFp(k)->IsF(face.FFi(k))); // both sides or none
            }
        }
        QVERIFY(faux < 2 * 288);
    }

    /// The edge between two quads is flipped: its faces have no diagonal of theirs any more, and what is left
    /// of the quads are triangles.
    void flippedFacesAreNoLongerPartsOfPolygons()
    {
        const test_meshes::IndexedMesh quads = test_meshes::Grid(3, 1, 1, true);
        FloatMesh mesh;
        test_meshes::Fill(mesh, quads);
        vcg_ext::DecimatedMesh result;
        for (std::uint32_t v = 0; v < 8; ++v) result.vertexOrigin.push_back(v);
        for (std::uint32_t f = 0; f < 6; ++f) result.faceOrigin.push_back(f);
        result.positions = quads.points;
        result.triangles = quads.triangles;
        result.triangles[0] = {0, 1, 6}; // was 0 1 5, of the first quad
        result.triangles[3] = {0, 6, 5}; // was 1 6 5, of the second
        ApplyDecimation(mesh, result);
        for (std::size_t f = 0; f < 6; ++f)
            for (int k = 0; k < 3; ++k)
                QCOMPARE(mesh.face[f].IsF(k), f >= 4 && (quads.fauxEdges[f] >> k & 1) != 0);
    }

    void refusesWhatItCannotDecimate()
    {
        FloatMesh empty, cloud, bad;
        QCOMPARE(Refusal(empty, Target(10)), std::string("the mesh has no faces"));
        vcg::tri::Allocator<FloatMesh>::AddVertices(cloud, 5);
        QCOMPARE(Refusal(cloud, Target(10)), std::string("the mesh has no faces"));
        test_meshes::Fill(bad, test_meshes::Grid(3, 3));
        bad.vert[1].P()[2] = std::numeric_limits<float>::quiet_NaN();
        bad.vert[7].P()[0] = std::numeric_limits<float>::infinity();
        QCOMPARE(Refusal(bad, Target(10)), std::string("the coordinates of 2 of 16 vertices are not finite"));
    }

    void refusesParametersOutOfRange()
    {
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Grid(3, 3));
        QVERIFY(Refusal(mesh, Target(0)).find("target_faces = 0") == 0);
        auto parameters = Target(4);
        for (const double weight : {-0.5, 50.5, std::numeric_limits<double>::quiet_NaN()}) {
            parameters.featureWeight = weight;
            const std::string said = Refusal(mesh, parameters);
            QVERIFY2(said.find("feature_weight = ") == 0 && said.find("[0, 50]") != std::string::npos,
                     said.c_str());
        }
        parameters.featureWeight = 2;
        parameters.threads = -1;
        QVERIFY(Refusal(mesh, parameters).find("threads = -1") == 0);
    }

    void stopsWhenAskedTo_data()
    {
        QTest::addColumn<Order>("order");
        QTest::newRow("sweeps") << Order::Sweeps;
        QTest::newRow("strict") << Order::Strict;
    }
    void stopsWhenAskedTo()
    {
        QFETCH(Order, order);
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Torus(64, 32));
        auto parameters = Target(100);
        parameters.order = order;
        parameters.cleanInput = false; // which would ask first
        int calls = 0;
        parameters.progress = [&](int percent, const char* stage) {
            ++calls;
            return percent >= 0 && percent <= 100 && stage && false;
        };
        const Simplification result = Decimate(mesh, parameters);
        QCOMPARE(result.report.stopReason, StopReason::Cancelled);
        QVERIFY(!result.report.targetReached);
        QCOMPARE(calls, 1); // the first no is enough
    }

    void saysWhyATargetIsOutOfReach()
    {
        FloatMesh mesh;
        test_meshes::Fill(mesh, test_meshes::Icosphere(2));
        for (const Order order : {Order::Sweeps, Order::Strict}) {
            auto parameters = Target(1);
            parameters.order = order;
            const Simplification result = Decimate(mesh, parameters);
            QCOMPARE(result.report.stopReason, StopReason::NoLegalCollapse);
            QVERIFY(!result.report.targetReached);
            QVERIFY(result.report.faces >= 4); // a closed surface stays one
            QCOMPARE(result.report.edges.boundary, std::size_t{0});
        }
    }

    /// Two sheets so close to each other that coarse faces of one cut through the other, some of them locked.
    void queueMakesNoFacesCross_data()
    {
        QTest::addColumn<Order>("order");
        QTest::addColumn<Effort>("effort");
        QTest::newRow("strict, fast") << Order::Strict << Effort::Fast;
        QTest::newRow("strict, balanced") << Order::Strict << Effort::Balanced;
        QTest::newRow("best") << Order::Sweeps << Effort::Best;
    }
    void queueMakesNoFacesCross()
    {
        QFETCH(Order, order);
        QFETCH(Effort, effort);
        // Two sheets close to each other; equal ones would have equal faces, which do not cross.
        test_meshes::IndexedMesh sheet = test_meshes::Grid(40, 40), other = test_meshes::Grid(32, 32, 1.25);
        for (auto* grid : {&sheet, &other})
            for (auto& p : grid->points) p[2] = 3 * std::sin(p[0] / 5) * std::cos(p[1] / 6);
        const auto mesh = test_meshes::Merged(sheet, test_meshes::Moved(other, 0, 1, {0, 0, 0.2}));
        MeshDecimationParameters parameters = Target(96);
        parameters.order = order;
        parameters.effort = effort;
        const MeshView view = test_meshes::View(mesh);
        const auto crossings = [&] {
            const DecimationParameters& ofArrays = parameters;
            return CrossingKeeper(view, 1).Find(Decimate(view, ofArrays).mesh).size();
        };
        QCOMPARE(crossings(), std::size_t{0});
        parameters.avoidSelfIntersections = false;
        QVERIFY(crossings() > 0);
    }
};

QTEST_APPLESS_MAIN(TestDecimation)
#include "test_decimate.moc"
