// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The distance to the original as vertex quality, on hosts of either precision.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <QtTest>

#include <vcg/complex/complex.h>
#include <vcg/complex/append.h>

#include "filter_decimate.h"
#include "filter_levels.h"
#include "test_meshes.h"
#include "vcg_ext/core/geometry/point_triangle.h"

using namespace laplacian_simplify;

namespace
{

class SingleVertex;
class SingleFace;
struct SingleTypes : vcg::UsedTypes<vcg::Use<SingleVertex>::AsVertexType, vcg::Use<SingleFace>::AsFaceType> {
};
class SingleVertex : public vcg::Vertex<SingleTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                                        vcg::vertex::Qualityf, vcg::vertex::Color4b, vcg::vertex::BitFlags>
{
};
class SingleFace
    : public vcg::Face<SingleTypes, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::BitFlags>
{
};
class SingleMesh : public vcg::tri::TriMesh<std::vector<SingleVertex>, std::vector<SingleFace>>
{
};

class DoubleVertex;
class DoubleFace;
struct DoubleTypes : vcg::UsedTypes<vcg::Use<DoubleVertex>::AsVertexType, vcg::Use<DoubleFace>::AsFaceType> {
};
class DoubleVertex : public vcg::Vertex<DoubleTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d,
                                        vcg::vertex::Qualityd, vcg::vertex::Color4b, vcg::vertex::BitFlags>
{
};
class DoubleFace
    : public vcg::Face<DoubleTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::BitFlags>
{
};
class DoubleMesh : public vcg::tri::TriMesh<std::vector<DoubleVertex>, std::vector<DoubleFace>>
{
};

/// What the filters need of a program.
template <class Mesh_>
class LayerHost
{
    std::vector<std::unique_ptr<Mesh_>> layers_;
    Mesh_* current_;

  public:
    using MeshType = Mesh_;

    std::vector<std::string> log;
    bool stops = false;

    explicit LayerHost(const test_meshes::IndexedMesh& mesh)
    {
        layers_.push_back(std::make_unique<Mesh_>());
        current_ = layers_.front().get();
        test_meshes::Fill(*current_, mesh);
    }

    Mesh_& Mesh() { return *current_; }
    Mesh_& Layer(std::size_t i) { return *layers_.at(i); }
    void Require(std::uint32_t) {}
    void ContinueOnCopy(const std::string&)
    {
        layers_.push_back(std::make_unique<Mesh_>());
        current_ = layers_.back().get();
        vcg::tri::Append<Mesh_, Mesh_>::MeshCopy(*current_, *layers_.front());
    }
    void ReturnToOriginal() { current_ = layers_.front().get(); }
    void GeometryChanged() {}
    void Log(const std::string& line) { log.push_back(line); }
    bool Progress(int, const char*) const { return !stops; }
};

using Given = std::map<std::string, GivenValue>;

template <class Host>
Values ValuesFor(FilterId filter, Host& host, const Given& given)
{
    return {filter, [&] { return FactsOf(host.Mesh()); },
            [&](const Parameter& row) -> std::optional<GivenValue> {
                const auto found = given.find(row.id);
                if (found == given.end()) return std::nullopt;
                return found->second;
            }};
}

/// The guided decimation.
template <class Host>
void Apply(Host& host, const Given& given)
{
    ApplyGuidedDecimation(host, ValuesFor(FilterId::GuidedDecimation, host, given));
}

/// A sheet with bumps of many heights and an open border.
test_meshes::IndexedMesh Bumps()
{
    auto mesh = test_meshes::Moved(test_meshes::Grid(24, 24), 0.4, 1, {3, 2, 1});
    for (auto& p : mesh.points) p[2] += 0.7 * std::sin(0.9 * p[0]) * std::cos(0.7 * p[1]);
    return mesh;
}

template <class Point>
vcg_ext::Vector3<double> Exact(const Point& p)
{
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// By trying all faces.
template <class Mesh>
double Distance(const Mesh& surface, const typename Mesh::CoordType& point)
{
    double least2 = std::numeric_limits<double>::max();
    for (const auto& face : surface.face) {
        if (face.IsD()) continue;
        const auto a = Exact(face.cP(0));
        const auto closest =
            vcg_ext::ClosestOnTriangle(Exact(point) - a, Exact(face.cP(1)) - a, Exact(face.cP(2)) - a);
        least2 = std::min(least2, closest.distance2);
    }
    return std::sqrt(least2);
}

template <class Mesh>
double LargestQuality(const Mesh& mesh)
{
    double largest = 0;
    for (const auto& v : mesh.vert) largest = std::max(largest, static_cast<double>(v.cQ()));
    return largest;
}

/// The quality of every vertex is its distance to \p original, but for how precisely a mesh stores it and how
/// precisely the distance of a point at coordinates up to 30 can be known.
template <class Mesh>
void CompareWithDistances(const Mesh& mesh, const Mesh& original)
{
    const double stored = static_cast<double>(std::numeric_limits<typename Mesh::ScalarType>::epsilon());
    constexpr double kComputed = 1e-13;
    QVERIFY(LargestQuality(mesh) > 0.01); // the meshes of this test are not flat
    for (const auto& v : mesh.vert) {
        const double distance = Distance(original, v.cP());
        QVERIFY(std::abs(static_cast<double>(v.cQ()) - distance) <= stored * distance + kComputed);
    }
}

/// Coordinates and faces, without quality and color.
template <class Mesh>
std::vector<double> Shape(const Mesh& mesh)
{
    std::vector<double> all;
    for (const auto& v : mesh.vert)
        for (int k = 0; k < 3; ++k) all.push_back(static_cast<double>(v.cP()[k]));
    for (const auto& face : mesh.face)
        for (int k = 0; k < 3; ++k) all.push_back(static_cast<double>(vcg::tri::Index(mesh, face.cV(k))));
    return all;
}

template <class Mesh>
std::vector<double> QualityAndColor(const Mesh& mesh)
{
    std::vector<double> all;
    for (const auto& v : mesh.vert) {
        all.push_back(static_cast<double>(v.cQ()));
        for (int k = 0; k < 4; ++k) all.push_back(v.cC()[k]);
    }
    return all;
}

/// Without the measurement of a run, which is not what is tested here.
const Given kAsQuality = {{"target_percent", 15.0}, {"error_as_quality", 1.0}, {"measure_error", 0.0}};

Given Also(Given values, const std::string& id, double value)
{
    values[id] = value;
    return values;
}

template <class Mesh>
void QualityIsTheDistance(const Given& values)
{
    LayerHost<Mesh> host(Bumps()), before(Bumps());
    if (values.count("selected_only") > 0)
        for (auto& face : host.Mesh().face)
            if (face.cP(0)[0] > 6) face.SetS();
    Apply(host, values);
    CompareWithDistances(host.Mesh(), before.Mesh());
}

} // namespace

class TestErrorAsQuality : public QObject
{
    Q_OBJECT

    static void EveryWay()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<double>("value");
        QTest::addRow("sweeps") << "order" << 0.0;
        QTest::addRow("strict") << "order" << 1.0;
        QTest::addRow("new layer") << "new_layer" << 1.0;
        QTest::addRow("selection") << "selected_only" << 1.0;
        QTest::addRow("without attributes") << "keep_attributes" << 0.0;
        QTest::addRow("best") << "effort" << 2.0;
        QTest::addRow("error bound") << "max_error" << 5.0;
    }

  private slots:
    void isTheDistanceOfEveryVertex_data() { EveryWay(); }
    void isTheDistanceOfEveryVertex();
    void isTheDistanceInAHostOfDoublePrecision_data() { EveryWay(); }
    void isTheDistanceInAHostOfDoublePrecision();
    void isColoredFromRedToBlue();
    void roundingIsNotShown();
    void doesNotChangeTheShape();
    void leavesQualityAndColorWhereItIsOff();
    void replacesTheQualityOfTheOriginal();
    void isZeroOutsideTheSelection();
    void isZeroAndRedWhereNothingIsToBeDone();
    void isNotThereAfterAStop();
    void measuresBeforeTheMeshChanges();
    void leavesNoAttributeBehind();
    void doesNotDependOnThreads();
    void isToldWithItsRange();
    void ofLevelsIsToTheOriginal();
};

void TestErrorAsQuality::isTheDistanceOfEveryVertex()
{
    QFETCH(QString, id);
    QFETCH(double, value);
    QualityIsTheDistance<SingleMesh>(Also(kAsQuality, id.toStdString(), value));
}

void TestErrorAsQuality::isTheDistanceInAHostOfDoublePrecision()
{
    QFETCH(QString, id);
    QFETCH(double, value);
    QualityIsTheDistance<DoubleMesh>(Also(kAsQuality, id.toStdString(), value));
}

void TestErrorAsQuality::isColoredFromRedToBlue()
{
    LayerHost<SingleMesh> host(Bumps());
    Apply(host, kAsQuality);
    const auto& vertices = host.Mesh().vert;
    const auto [least, largest] = std::minmax_element(
        vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.cQ() < b.cQ(); });
    QVERIFY(least->cC() == vcg::Color4b(vcg::Color4b::Red));
    QVERIFY(largest->cC() == vcg::Color4b(vcg::Color4b::Blue));
    for (const auto& v : vertices) { // as MeshLab's Hausdorff Distance colors its samples
        vcg::Color4b color;
        color.SetColorRamp(least->cQ(), largest->cQ(), v.cQ());
        for (int k = 0; k < 4; ++k) QVERIFY(std::abs(int{v.cC()[k]} - int{color[k]}) <= 1); // it is rounded
    }
}

void TestErrorAsQuality::doesNotChangeTheShape()
{
    LayerHost<SingleMesh> with(Bumps()), without(Bumps());
    Apply(with, kAsQuality);
    Apply(without, Also(kAsQuality, "error_as_quality", 0));
    QVERIFY(Shape(with.Mesh()) == Shape(without.Mesh()));
}

void TestErrorAsQuality::leavesQualityAndColorWhereItIsOff()
{
    LayerHost<SingleMesh> host(Bumps());
    for (auto& v : host.Mesh().vert) {
        v.Q() = 5;
        v.C() = vcg::Color4b(1, 2, 3, 255);
    }
    Apply(host, {{"target_percent", 15.0}});
    for (const auto& v : host.Mesh().vert) {
        QCOMPARE(v.cQ(), 5.0F);
        QVERIFY(v.cC() == vcg::Color4b(1, 2, 3, 255));
    }
}

/// A plane stays one, but for rounding: nothing of that is shown as an error.
void TestErrorAsQuality::roundingIsNotShown()
{
    LayerHost<SingleMesh> host(test_meshes::Moved(test_meshes::Grid(24, 24), 0.4, 1, {3, 2, 1}));
    Apply(host, kAsQuality);
    for (const auto& v : host.Mesh().vert) {
        QVERIFY(v.cQ() < 1e-5F); // of coordinates up to 30
        QVERIFY(v.cC()[2] == 0); // the redder half of the ramp
    }
}

/// What was there before guides the decimation as ever.
void TestErrorAsQuality::replacesTheQualityOfTheOriginal()
{
    LayerHost<SingleMesh> host(Bumps()), original(Bumps());
    for (auto& v : host.Mesh().vert) v.Q() = v.P()[0] * v.P()[1];
    Apply(host, Also(kAsQuality, "measure_error", 1)); // which tells of the attributes
    CompareWithDistances(host.Mesh(), original.Mesh());
    bool guided = false;
    for (const std::string& line : host.log) guided |= line.find("Attributes, rms difference: ") == 0;
    QVERIFY(guided);
}

void TestErrorAsQuality::isZeroOutsideTheSelection()
{
    LayerHost<SingleMesh> host(Bumps());
    std::vector<bool> outside(host.Mesh().vert.size());
    for (auto& face : host.Mesh().face) {
        if (face.cP(0)[0] > 6) {
            face.SetS();
            continue;
        }
        for (int k = 0; k < 3; ++k) outside[vcg::tri::Index(host.Mesh(), face.cV(k))] = true;
    }
    for (std::size_t v = 0; v < outside.size(); ++v)
        if (outside[v]) host.Mesh().vert[v].SetS(); // survivors keep the flag
    Apply(host, kAsQuality);
    int found = 0;
    for (const auto& v : host.Mesh().vert) {
        if (!v.IsS()) continue;
        QCOMPARE(v.cQ(), 0.0F);
        ++found;
    }
    QVERIFY(found > 100);
}

void TestErrorAsQuality::isZeroAndRedWhereNothingIsToBeDone()
{
    LayerHost<SingleMesh> host(Bumps());
    vcg::tri::Allocator<SingleMesh>::AddVertices(host.Mesh(), 1);
    host.Mesh().vert.back().P()[0] = std::numeric_limits<float>::quiet_NaN(); // of a deleted vertex
    vcg::tri::Allocator<SingleMesh>::DeleteVertex(host.Mesh(), host.Mesh().vert.back());
    for (auto& v : host.Mesh().vert) v.Q() = 5;
    Apply(host, Also(kAsQuality, "target_percent", 100));
    for (const auto& v : host.Mesh().vert) {
        if (v.IsD()) continue;
        QCOMPARE(v.cQ(), 0.0F);
        QVERIFY(v.cC() == vcg::Color4b(vcg::Color4b::Red));
    }
}

void TestErrorAsQuality::isNotThereAfterAStop()
{
    LayerHost<SingleMesh> host(Bumps());
    for (auto& v : host.Mesh().vert) v.Q() = 5;
    host.stops = true;
    const auto before = QualityAndColor(host.Mesh());
    Apply(host, kAsQuality);
    QVERIFY(QualityAndColor(host.Mesh()) == before);
    QCOMPARE(host.log.size(), std::size_t{1}); // canceled, and no range
}

/// What may be stopped or lack memory leaves the mesh as it was.
void TestErrorAsQuality::measuresBeforeTheMeshChanges()
{
    LayerHost<SingleMesh> host(Bumps());
    const vcg_ext::Progress stopsWhereItMeasures = [](int, const char* stage) {
        return stage != std::string("Distances to the original");
    };
    DecimationWishes wishes;
    const auto decimate = [&](const vcg_ext::Progress& progress) {
        return DecimateValue(host.Mesh(), 100, wishes, progress,
                             [&](std::size_t target, const vcg_ext::Progress& itsProgress) {
                                 vcg_ext::MeshDecimationParameters parameters;
                                 parameters.targetFaces = target;
                                 parameters.progress = itsProgress;
                                 return vcg_ext::Decimate<SingleMesh>(host.Mesh(), parameters);
                             });
    };
    QVERIFY(!decimate(stopsWhereItMeasures).error); // nothing is measured
    wishes.errorAsQuality = true;
    const auto before = Shape(host.Mesh());
    QVERIFY_EXCEPTION_THROWN(decimate(stopsWhereItMeasures), vcg_ext::Cancelled);
    QVERIFY(decimate({}).error);
    QVERIFY(Shape(host.Mesh()) == before);
}

/// The distances are kept in an attribute while the mesh changes.
void TestErrorAsQuality::leavesNoAttributeBehind()
{
    LayerHost<SingleMesh> host(Bumps());
    Apply(host, Also(kAsQuality, "new_layer", 1));
    for (const std::size_t i : {0U, 1U}) QVERIFY(host.Layer(i).vert_attr.empty());
}

void TestErrorAsQuality::doesNotDependOnThreads()
{
    LayerHost<DoubleMesh> one(Bumps()), three(Bumps());
    Apply(one, Also(kAsQuality, "threads", 1));
    Apply(three, Also(kAsQuality, "threads", 3));
    QVERIFY(Shape(one.Mesh()) == Shape(three.Mesh()));
    QVERIFY(QualityAndColor(one.Mesh()) == QualityAndColor(three.Mesh()));
}

void TestErrorAsQuality::isToldWithItsRange()
{
    LayerHost<DoubleMesh> host(Bumps());
    Apply(host, Also(kAsQuality, "boundary", 2)); // the border stays: the least distance is 0
    QCOMPARE(
        QString::fromStdString(host.log.back()),
        QString("Distance of the vertices to the original, as quality: from 0 to %1 in the unit of the mesh")
            .arg(QString::fromStdString(RoundedText(LargestQuality(host.Mesh()), 4))));
}

void TestErrorAsQuality::ofLevelsIsToTheOriginal()
{
    LayerHost<SingleMesh> host(Bumps());
    const Given given = {{"percents", std::string("40,10")}, {"error_as_quality", 1.0}};
    ApplyLevelsOfDetail(host, ValuesFor(FilterId::LevelsOfDetail, host, given));
    for (const std::size_t i : {1U, 2U}) CompareWithDistances(host.Layer(i), host.Layer(0));
    QVERIFY(host.log.back().find("10%: Distance of the vertices to the original") == 0);
}

QTEST_APPLESS_MAIN(TestErrorAsQuality)
#include "test_error_as_quality.moc"
