// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The filters on a host of the test's own, which can do what real hosts cannot be made to do: stop a run.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <QRegularExpression>
#include <QtTest>

#include <vcg/complex/complex.h>
#include <vcg/complex/append.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>

#include "test_meshes.h"
#include "filter_functions.h"

using namespace laplacian_simplify;

Q_DECLARE_METATYPE(laplacian_simplify::FilterId)

namespace
{

class PlainVertex;
class PlainFace;
struct PlainTypes : vcg::UsedTypes<vcg::Use<PlainVertex>::AsVertexType, vcg::Use<PlainFace>::AsFaceType> {
};
class PlainVertex
    : public vcg::Vertex<PlainTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::Qualityf,
                         vcg::vertex::Color4b, vcg::vertex::TexCoord2f, vcg::vertex::BitFlags>
{
};
class PlainFace : public vcg::Face<PlainTypes, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::BitFlags>
{
};
class PlainMesh : public vcg::tri::TriMesh<std::vector<PlainVertex>, std::vector<PlainFace>>
{
};

/// The smallest program that filters can run in.
class PlainHost
{
    std::vector<std::unique_ptr<PlainMesh>> layers_;
    PlainMesh* current_;

  public:
    using MeshType = PlainMesh;

    std::vector<std::string> log, suffixes;
    int progressCalls = 0;
    int stopAtCall = 0; ///< 0: never
    int geometryChanges = 0;

    explicit PlainHost(const test_meshes::IndexedMesh& mesh)
    {
        layers_.push_back(std::make_unique<PlainMesh>());
        current_ = layers_.front().get();
        test_meshes::Fill(Mesh(), mesh);
        for (auto& v : Mesh().vert) v.T() = {0, 0};
        GeometryChanged();
        geometryChanges = 0;
    }

    PlainMesh& Mesh() { return *current_; }
    PlainMesh& Original() { return *layers_.front(); }
    PlainMesh& Layer(std::size_t i) { return *layers_[i]; }
    std::size_t Layers() const { return layers_.size(); }
    void Require(std::uint32_t) {}
    void ContinueOnCopy(const std::string& suffix)
    {
        auto copy = std::make_unique<PlainMesh>();
        vcg::tri::Append<PlainMesh, PlainMesh>::MeshCopy(*copy, Original());
        current_ = copy.get();
        layers_.push_back(std::move(copy));
        suffixes.push_back(suffix);
    }
    void ReturnToOriginal() { current_ = layers_.front().get(); }
    void GeometryChanged()
    {
        ++geometryChanges;
        vcg::tri::UpdateBounding<PlainMesh>::Box(Mesh());
        vcg::tri::UpdateNormal<PlainMesh>::PerVertexNormalizedPerFaceNormalized(Mesh());
    }
    void Log(const std::string& line) { log.push_back(line); }
    bool Progress(int, const char*) { return ++progressCalls != stopAtCall; }

    Report Apply(FilterId filter, const std::map<std::string, GivenValue>& values = {})
    {
        return ApplyFilter(filter, *this, [&](const Parameter& row) -> std::optional<GivenValue> {
            const auto found = values.find(row.id);
            if (found == values.end()) return std::nullopt;
            return found->second;
        });
    }
};

/// Everything that a user could miss.
std::vector<double> Fingerprint(const PlainMesh& mesh)
{
    std::vector<double> all;
    for (const auto& v : mesh.vert) {
        all.push_back(v.IsD());
        if (v.IsD()) continue;
        for (int k = 0; k < 3; ++k) all.push_back(static_cast<double>(v.P()[k]));
        for (int k = 0; k < 4; ++k) all.push_back(v.C()[k]);
        all.push_back(static_cast<double>(v.Q()));
        all.push_back(v.IsS());
    }
    for (const auto& face : mesh.face) {
        all.push_back(face.IsD());
        if (face.IsD()) continue;
        for (int k = 0; k < 3; ++k) all.push_back(static_cast<double>(vcg::tri::Index(mesh, face.V(k))));
        all.push_back(face.IsS());
    }
    return all;
}

template <class T>
T Get(const Report& report, const std::string& id)
{
    for (const auto& [key, value] : report.Entries())
        if (key == id) return std::get<T>(value);
    throw std::logic_error("no result " + id);
}

QString FailureOf(PlainHost& host, FilterId filter, const std::map<std::string, GivenValue>& values = {})
{
    try {
        host.Apply(filter, values);
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

/// The same triangles with vertices of their own, as STL files store them.
test_meshes::IndexedMesh Soup(const test_meshes::IndexedMesh& mesh)
{
    test_meshes::IndexedMesh soup;
    for (const auto& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.points.size());
        for (const auto v : triangle) soup.points.push_back(mesh.points[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// Gives it a texture, colors and quality that follow the position.
void Paint(PlainMesh& mesh)
{
    for (auto& v : mesh.vert) {
        v.T() = {v.P()[0], v.P()[1]};
        v.C() = vcg::Color4b(static_cast<unsigned char>(128 + 100 * v.P()[2]), 1, 2, 255);
        v.Q() = v.P()[1];
    }
}

/// The faces whose centroid has a positive x.
void SelectHalf(PlainMesh& mesh)
{
    for (auto& face : mesh.face)
        if (face.P(0)[0] + face.P(1)[0] + face.P(2)[0] > 0) face.SetS();
}

std::size_t CountSelectedFaces(const PlainMesh& mesh)
{
    return FactsOf(mesh).selectedFaces;
}

} // namespace

/// Most tests leave the measurement out: with its many samples it is the slowest part under the sanitizers.
class TestFilters : public QObject
{
    Q_OBJECT

    static void EveryFilter()
    {
        QTest::addColumn<FilterId>("filter");
        for (const Filter& filter : Filters()) QTest::addRow("%s", filter.key) << filter.id;
    }

  private slots:
    void returnsExactlyTheResultsOfItsTable_data() { EveryFilter(); }
    void returnsExactlyTheResultsOfItsTable();
    void logLinesAreShort_data() { EveryFilter(); }
    void logLinesAreShort();
    void badParameterLeavesTheMeshAsItWas_data() { EveryFilter(); }
    void badParameterLeavesTheMeshAsItWas();
    void meshWithoutFacesIsRefused_data() { EveryFilter(); }
    void meshWithoutFacesIsRefused();
    void coordinatesThatAreNoNumbersAreRefusedWithTheirCount_data() { EveryFilter(); }
    void coordinatesThatAreNoNumbersAreRefusedWithTheirCount();
    void selectionIsAskedForWhereThereIsNone_data() { EveryFilter(); }
    void selectionIsAskedForWhereThereIsNone();
    void stoppedRunLeavesTheMeshAsItWas_data() { EveryFilter(); }
    void stoppedRunLeavesTheMeshAsItWas();
    void deletedElementsAreNotThere_data() { EveryFilter(); }
    void deletedElementsAreNotThere();
    void stoppedDecimationSaysSo();
    void logTellsWhatBecameOfTheFaces();
    void logTellsWhyTheTargetWasMissed();
    void soupIsWelded();
    void differentColorsStayApart();
    void logNamesTheAttributes();
    void storedQualityGuidesAndIsNoAttribute();
    void orderStrictTransfersAttributes();
    void progressIsThrottled();
    void percentilesAreThoseOfTheSortedValues();
    void descriptorChangesOnlyTheSelection();
    void selectionOfFacesSurvivesTheSelectionOfVertices();
    void decimationKeepsWhatIsNotSelected();
    void selectedVerticesCanBeLocked();
    void targetPercentIsOfTheSelection();
    void targetAboveTheFacesChangesNothing();
    void newLayerKeepsTheOriginal();
    void newLayerOfAMeshWithDeletedVertices();
    void newLayersHaveCustomAttributes();
    void edgesAreThoseOfTheMeshThatIsLeft();
    void levelOfAllFacesIsTheMesh();
    void levelsAreLayersAndTheOriginalStays();
    void levelsOfASelection();
    void levelsOfAMeshWithDeletedVertices();
    void badLevelsAreRefused();
    void smoothingMovesOnlyTheSelection();
    void qualityThatIsNoNumberIsRefused();
};

void TestFilters::returnsExactlyTheResultsOfItsTable()
{
    QFETCH(FilterId, filter);
    const test_meshes::IndexedMesh box = test_meshes::Box(4);
    PlainHost host(test_meshes::Merged(box, test_meshes::Moved(box, 0.3, 1, {0.4, 0.3, 0.2}))); // crossing
    for (auto& v : host.Mesh().vert) v.T() = {v.P()[0], v.P()[1]};
    QStringList expected, returned;
    for (const Result* row : ResultsOf(filter)) expected << row->id;
    std::map<std::string, GivenValue> values;
    for (const Parameter* row : ParametersOf(filter)) // what it takes that no result is missing
        if (row->id == std::string("max_error")) values["max_error"] = 10.0;
    const Report report = host.Apply(filter, values);
    for (const auto& entry : report.Entries()) returned << QString::fromStdString(entry.first);
    QCOMPARE(returned, expected);
}

void TestFilters::logLinesAreShort()
{
    QFETCH(FilterId, filter);
    PlainHost host(test_meshes::Box(4));
    host.Apply(filter);
    QVERIFY(!host.log.empty());
    for (const std::string& line : host.log) {
        QVERIFY2(line.size() < 400, line.c_str());
        QVERIFY2(line.find('\n') == std::string::npos, line.c_str());
    }
}

void TestFilters::badParameterLeavesTheMeshAsItWas()
{
    QFETCH(FilterId, filter);
    for (const Parameter* row : ParametersOf(filter)) {
        PlainHost host(test_meshes::Box(4));
        const auto before = Fingerprint(host.Mesh());
        const QString failure = FailureOf(host, filter, {{row->id, row->range.maximum + 1}});
        QVERIFY2(failure.startsWith(QString(row->id) + " = "), qPrintable(failure));
        QVERIFY(Fingerprint(host.Mesh()) == before);
        QCOMPARE(host.geometryChanges, 0);
    }
}

void TestFilters::meshWithoutFacesIsRefused()
{
    QFETCH(FilterId, filter);
    test_meshes::IndexedMesh cloud = test_meshes::Box(1);
    cloud.triangles.clear();
    PlainHost host(cloud);
    QCOMPARE(FailureOf(host, filter), "the mesh has no faces (8 vertices)");
    PlainHost empty(test_meshes::IndexedMesh{});
    QCOMPARE(FailureOf(empty, filter), "the mesh has no faces (0 vertices)");
}

void TestFilters::coordinatesThatAreNoNumbersAreRefusedWithTheirCount()
{
    QFETCH(FilterId, filter);
    PlainHost host(test_meshes::Box(4));
    host.Mesh().vert[3].P()[1] = std::numeric_limits<float>::quiet_NaN();
    host.Mesh().vert[5].P()[0] = std::numeric_limits<float>::infinity();
    host.Mesh().vert[7].P()[2] = 1e30F;
    QCOMPARE(FailureOf(host, filter),
             "the mesh is unusable: the coordinates of 3 of 98 vertices are not finite or larger than 1e18");
}

void TestFilters::selectionIsAskedForWhereThereIsNone()
{
    QFETCH(FilterId, filter);
    if (filter == FilterId::FeatureSelection) return; // works on all of the mesh
    PlainHost host(test_meshes::Box(4));
    const QString failure = FailureOf(host, filter, {{"selected_only", 1.0}});
    QVERIFY2(failure.startsWith("selected_only = true, but no"), qPrintable(failure));
}

void TestFilters::stoppedRunLeavesTheMeshAsItWas()
{
    QFETCH(FilterId, filter);
    PlainHost host(test_meshes::Icosphere(3));
    SelectHalf(host.Mesh());
    const auto before = Fingerprint(host.Mesh());
    host.stopAtCall = 1;
    const QString failure = FailureOf(host, filter);
    QVERIFY(host.progressCalls > 0);
    QVERIFY(Fingerprint(host.Mesh()) == before);
    QCOMPARE(host.Layers(), std::size_t{1});
    const QString said = failure.isEmpty() ? QString::fromStdString(host.log.back()) : failure;
    QCOMPARE(said, "canceled; the mesh is unchanged");
}

void TestFilters::deletedElementsAreNotThere()
{
    QFETCH(FilterId, filter);
    PlainHost host(
        test_meshes::Merged(test_meshes::Icosphere(2), test_meshes::Noisy(test_meshes::Box(3), .01)));
    PlainMesh& mesh = host.Mesh();
    const std::size_t sphere = test_meshes::Icosphere(2).points.size();
    for (auto& face : mesh.face)
        if (vcg::tri::Index(mesh, face.V(0)) < sphere) vcg::tri::Allocator<PlainMesh>::DeleteFace(mesh, face);
    for (std::size_t v = 0; v < sphere; ++v) {
        mesh.vert[v].P()[0] = std::numeric_limits<float>::quiet_NaN();
        vcg::tri::Allocator<PlainMesh>::DeleteVertex(mesh, mesh.vert[v]);
    }
    PlainHost clean(test_meshes::Noisy(test_meshes::Box(3), .01));
    const Report expected = clean.Apply(filter), report = host.Apply(filter);
    QCOMPARE(report.Entries().size(), expected.Entries().size());
    for (std::size_t i = 0; i < report.Entries().size(); ++i) {
        const auto& [id, value] = report.Entries()[i];
        if (id != "seconds") QVERIFY2(value == expected.Entries()[i].second, id.c_str());
    }
}

void TestFilters::stoppedDecimationSaysSo()
{
    PlainHost host(test_meshes::Icosphere(3));
    host.stopAtCall = 1;
    const Report report = host.Apply(FilterId::GuidedDecimation);
    QCOMPARE(Get<int>(report, "stop_reason"), 3);
    QCOMPARE(Get<bool>(report, "target_reached"), false);
    QCOMPARE(Get<int>(report, "faces"), 1280);
    QCOMPARE(Get<int>(report, "vertices"), 642);
}

void TestFilters::logTellsWhatBecameOfTheFaces()
{
    vcg_ext::DecimationReport report;
    report.facesBefore = 23680;
    report.faces = 2368;
    report.vertices = 1184;
    report.seconds = 0.5512;
    report.stopReason = vcg_ext::StopReason::Target;
    report.distances = {0.51234, 0.0123, 0.009, 1200};
    report.edges.boundary = 1500;
    const std::vector<std::string> expected = {
        "23,680 -> 2,368 faces (10 %), 1,184 vertices, 0.55 s; target reached",
        "Distances in percent of the bounding box diagonal: largest (Hausdorff) 0.5123, rms 0.0123, "
        "rms at features 0.009; folded faces: 1,200",
        "Non-manifold edges: 0, boundary edges: 1,500"};
    QCOMPARE(LogLines(report, 2368), expected);
}

void TestFilters::logTellsWhyTheTargetWasMissed()
{
    vcg_ext::DecimationReport report;
    report.faces = 1000;
    report.stopReason = vcg_ext::StopReason::NoLegalCollapse;
    report.edges.boundary =
        2000; // a strip of triangles has about one open edge a face, scattered pairs have two
    QCOMPARE(StopDescription(report, 1200),
             std::string("target of 1,200 faces not reached: no further collapse is possible without damage "
                         "(flipped faces, non-manifold edges, changes to locked parts)"));
    PlainHost soup(Soup(test_meshes::Icosphere(2)));
    soup.Apply(FilterId::GuidedDecimation,
               {{"target_percent", 10.0}, {"clean_input", 0.0}, {"measure_error", 0.0}});
    QCOMPARE(soup.log.front().substr(soup.log.front().find("target")),
             std::string("target of 32 faces not reached: most faces are not connected; "
                         "turn on \"Clean the input\", or set a \"Weld distance\""));
    report.stopReason = vcg_ext::StopReason::Seams;
    QCOMPARE(StopDescription(report, 500),
             std::string("target of 500 faces not reached: seams hold the last faces of their charts; set "
                         "\"Seams\" to ignore, or make a texture of fewer parts"));
    report.stopReason = vcg_ext::StopReason::ErrorBound;
    QCOMPARE(StopDescription(report, 500),
             std::string("error bound reached: every further collapse would exceed it"));
}

void TestFilters::soupIsWelded()
{
    PlainHost soup(Soup(test_meshes::Icosphere(2)));
    vcg::tri::Allocator<PlainMesh>::AddVertex(soup.Mesh(), vcg::Point3f(9, 9, 9)); // on no face
    const std::map<std::string, GivenValue> values = {{"target_percent", 10.0}, {"measure_error", 0.0}};
    const Report report = soup.Apply(FilterId::GuidedDecimation, values);
    PlainHost closed(test_meshes::Icosphere(2));
    closed.Apply(FilterId::GuidedDecimation, values);
    QCOMPARE(Get<int>(report, "welded_vertices"), 3 * 320 - 162);
    QCOMPARE(Get<int>(report, "dropped_faces"), 0);
    QCOMPARE(Get<int>(report, "boundary_edges"), 0);
    QVERIFY(Get<bool>(report, "target_reached"));
    QCOMPARE(soup.Mesh().vn, closed.Mesh().vn);
    QCOMPARE(soup.Mesh().fn, closed.Mesh().fn);
}

void TestFilters::differentColorsStayApart()
{
    PlainHost host(Soup(test_meshes::Icosphere(2)));
    host.Mesh().vert[0].C() = vcg::Color4b(1, 2, 3, 255);
    const Report report =
        host.Apply(FilterId::GuidedDecimation,
                   {{"target_percent", 10.0}, {"keep_attributes", 0.0}, {"measure_error", 0.0}});
    QCOMPARE(Get<int>(report, "welded_vertices"), 3 * 320 - 162 - 1);
}

void TestFilters::logNamesTheAttributes()
{
    test_meshes::IndexedMesh dome = test_meshes::Icosphere(3); // of a whole sphere each place has two points
    const auto isBelow = [&](const auto& t) {
        return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return dome.points[v][2] < 0.2; });
    };
    dome.triangles.erase(std::remove_if(dome.triangles.begin(), dome.triangles.end(), isBelow),
                         dome.triangles.end());
    PlainHost host(dome);
    Paint(host.Mesh());
    const Report report = host.Apply(FilterId::GuidedDecimation, {{"target_percent", 10.0}});
    const auto errors = Get<std::vector<double>>(report, "attribute_rms");
    QCOMPARE(errors.size(), std::size_t{3});
    // A color of 100 a unit of length is off by as many hundredths as one of its 255 parts.
    QVERIFY(errors[1] > 20 * errors[2] && errors[1] < 10);
    const QString line = QString::fromStdString(host.log[host.log.size() - 2]);
    const QRegularExpression named("^Attributes, rms difference: vertex texture coordinates [0-9.]+, "
                                   "vertex color [0-9.]+ of 255, vertex quality [0-9.]+$");
    QVERIFY2(named.match(line).hasMatch(), qPrintable(line));
    const QString texture = QString::fromStdString(host.log.back());
    const QRegularExpression small(
        "^Texture deviation in percent of the bounding box diagonal: rms [01]\\.[0-9]+, "
        "largest [0-9.]+; faces whose texture is turned over: 0$");
    QVERIFY2(small.match(texture).hasMatch(), qPrintable(texture));
    QCOMPARE(Get<int>(report, "faces_held_by_seams"), 0);
}

void TestFilters::storedQualityGuidesAndIsNoAttribute()
{
    PlainHost host(test_meshes::Icosphere(3));
    std::set<float> before;
    for (auto& v : host.Mesh().vert) before.insert(v.Q() = v.P()[1]);
    const Report report =
        host.Apply(FilterId::GuidedDecimation, {{"target_percent", 10.0}, {"descriptor", 5.0}});
    for (const auto& entry : report.Entries()) QVERIFY(entry.first != "attribute_rms");
    for (const auto& v : host.Mesh().vert) QVERIFY(before.count(v.cQ()) == 1);
}

void TestFilters::orderStrictTransfersAttributes()
{
    PlainHost host(test_meshes::Icosphere(3));
    Paint(host.Mesh());
    const Report report = host.Apply(FilterId::GuidedDecimation, {{"target_percent", 10.0}, {"order", 1.0}});
    bool told = false;
    for (const auto& entry : report.Entries()) told = told || entry.first == "attribute_rms";
    QVERIFY(told);
}

void TestFilters::progressIsThrottled()
{
    int calls = 0;
    ThrottledProgress::Clock::time_point now{std::chrono::hours(1)};
    ThrottledProgress progress([&](int, const char*) { return ++calls < 2; }, [&] { return now; });
    for (int i = 0; i < 1000; ++i) QVERIFY(progress(i / 10, "at once"));
    QCOMPARE(calls, 1);
    now += std::chrono::milliseconds(101); // ten times a second
    QVERIFY(!progress(100, "later"));
    QVERIFY2(!progress(100, "after the stop"), "a stop is final, and the host is not asked again");
    QCOMPARE(calls, 2);
}

void TestFilters::percentilesAreThoseOfTheSortedValues()
{
    std::vector<double> values;
    values.reserve(5000);
    for (int i = 0; i < 5000; ++i) values.push_back(std::pow(std::sin(i), 9)); // most of them near 0
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const Percentiles percentile(values);
    for (const double part : {0.0, 0.1, 0.5, 0.9, 0.999, 1.0})
        QCOMPARE(percentile(part), sorted[static_cast<std::size_t>(part * 4999)]);
    const std::vector<double> equal(7, 0.25);
    QCOMPARE(Percentiles(equal)(0.999), 0.25);
}

void TestFilters::descriptorChangesOnlyTheSelection()
{
    PlainHost host(test_meshes::Box(4));
    for (auto& v : host.Mesh().vert) v.Q() = -7;
    host.Mesh().vert[0].SetS();
    host.Mesh().vert[9].SetS();
    host.Apply(FilterId::ShapeDescriptor, {{"selected_only", 1.0}});
    for (std::size_t v = 0; v < host.Mesh().vert.size(); ++v)
        QCOMPARE(host.Mesh().vert[v].Q() == -7, v != 0 && v != 9);
}

void TestFilters::selectionOfFacesSurvivesTheSelectionOfVertices()
{
    PlainHost host(test_meshes::Noisy(test_meshes::Box(6), .005));
    SelectHalf(host.Mesh());
    const std::size_t faces = CountSelectedFaces(host.Mesh());
    for (auto& v : host.Mesh().vert) v.SetS();
    const Report report = host.Apply(FilterId::FeatureSelection);
    QCOMPARE(CountSelectedFaces(host.Mesh()), faces);
    int selected = 0;
    for (const auto& v : host.Mesh().vert) selected += v.IsS();
    QCOMPARE(selected, Get<int>(report, "selected"));
    QVERIFY2(selected > 0 && selected < host.Mesh().vn, "the former selection is replaced");
}

void TestFilters::decimationKeepsWhatIsNotSelected()
{
    PlainHost host(test_meshes::Icosphere(3));
    SelectHalf(host.Mesh());
    std::set<std::vector<float>> kept;
    const auto corners = [](const PlainFace& face) {
        std::vector<float> all;
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c) all.push_back(face.cP(k)[c]);
        return all;
    };
    for (const auto& face : host.Mesh().face)
        if (!face.IsS()) kept.insert(corners(face));
    host.Apply(FilterId::GuidedDecimation, {{"target_percent", 30.0}, {"measure_error", 0.0}});
    std::size_t found = 0;
    for (const auto& face : host.Mesh().face) found += !face.IsS() && kept.count(corners(face)) > 0;
    QCOMPARE(found, kept.size());
}

void TestFilters::selectedVerticesCanBeLocked()
{
    PlainHost host(test_meshes::Icosphere(3));
    const std::map<std::string, GivenValue> values = {{"target_percent", 10.0},
                                                      {"lock_selected_vertices", 1.0},
                                                      {"new_layer", 1.0},
                                                      {"measure_error", 0.0}};
    const auto before = Fingerprint(host.Mesh());
    QCOMPARE(FailureOf(host, FilterId::GuidedDecimation, values),
             QString("lock_selected_vertices = true, but no vertex is selected"));
    QVERIFY(Fingerprint(host.Mesh()) == before);
    std::set<std::vector<float>> locked;
    const auto position = [](const PlainVertex& v) {
        return std::vector<float>{v.cP()[0], v.cP()[1], v.cP()[2]};
    };
    for (std::size_t v = 0; v < host.Mesh().vert.size(); v += 20) {
        host.Mesh().vert[v].SetS();
        locked.insert(position(host.Mesh().vert[v]));
    }
    QVERIFY(Get<bool>(host.Apply(FilterId::GuidedDecimation, values), "target_reached"));
    std::size_t stayed = 0;
    for (const auto& v : host.Mesh().vert) stayed += locked.count(position(v));
    QCOMPARE(stayed, locked.size());
}

void TestFilters::targetPercentIsOfTheSelection()
{
    PlainHost host(test_meshes::Icosphere(3));
    SelectHalf(host.Mesh());
    const std::size_t selected = CountSelectedFaces(host.Mesh());
    const Report report =
        host.Apply(FilterId::GuidedDecimation, {{"target_percent", 50.0}, {"measure_error", 0.0}});
    QVERIFY(Get<bool>(report, "target_reached"));
    const double left = static_cast<double>(CountSelectedFaces(host.Mesh()));
    QVERIFY(std::abs(left - static_cast<double>(selected) / 2) <= 2);
    QCOMPARE(Get<int>(report, "faces"), host.Mesh().fn);
}

void TestFilters::targetAboveTheFacesChangesNothing()
{
    PlainHost host(test_meshes::Icosphere(2));
    const auto before = Fingerprint(host.Mesh());
    const Report report = host.Apply(FilterId::GuidedDecimation, {{"target_faces", 1000.0}});
    QVERIFY(Fingerprint(host.Mesh()) == before);
    QVERIFY(Get<bool>(report, "target_reached"));
    QCOMPARE(Get<double>(report, "hausdorff"), 0.0);
    QCOMPARE(Get<int>(report, "boundary_edges"), 0);
}

void TestFilters::newLayerKeepsTheOriginal()
{
    PlainHost host(test_meshes::Icosphere(3));
    const auto before = Fingerprint(host.Mesh());
    const Report report = host.Apply(FilterId::GuidedDecimation,
                                     {{"target_percent", 20.0}, {"new_layer", 1.0}, {"measure_error", 0.0}});
    QCOMPARE(host.Layers(), std::size_t{2});
    QVERIFY(host.suffixes == (std::vector<std::string>{"_simplified"}));
    QVERIFY(Fingerprint(host.Original()) == before);
    QCOMPARE(host.Mesh().fn, Get<int>(report, "faces"));
    QCOMPARE(host.Mesh().vn, Get<int>(report, "vertices"));
}

void TestFilters::newLayerOfAMeshWithDeletedVertices()
{
    PlainHost plain(test_meshes::Icosphere(3)), holes(test_meshes::Icosphere(3));
    auto vertex = vcg::tri::Allocator<PlainMesh>::AddVertices(holes.Mesh(), 1);
    std::swap(holes.Mesh().vert.front().P(), vertex->P()); // vertex 0 goes to the end
    for (auto& face : holes.Mesh().face)
        for (int k = 0; k < 3; ++k)
            if (face.V(k) == &holes.Mesh().vert.front()) face.V(k) = &*vertex;
    vcg::tri::Allocator<PlainMesh>::DeleteVertex(holes.Mesh(), holes.Mesh().vert.front());
    const std::map<std::string, GivenValue> values = {
        {"target_percent", 20.0}, {"new_layer", 1.0}, {"measure_error", 0.0}};
    holes.Apply(FilterId::GuidedDecimation, values);
    plain.Apply(FilterId::GuidedDecimation, values);
    QCOMPARE(holes.Mesh().fn, plain.Mesh().fn);
    for (const auto& v : holes.Mesh().vert) // a wrong vertex would be far from the sphere or torn off
        QVERIFY(std::abs(v.P().Norm() - 1) < 0.05F);
    for (const auto& face : holes.Mesh().face) QVERIFY(vcg::DoubleArea(face) < 1);
}

void TestFilters::levelsAreLayersAndTheOriginalStays()
{
    PlainHost host(test_meshes::Icosphere(3)), single(test_meshes::Icosphere(3));
    const auto before = Fingerprint(host.Mesh());
    const Report report =
        host.Apply(FilterId::LevelsOfDetail,
                   {{"percents", std::string("40,20,5")}, {"order", 0.0}, {"measure_error", 0.0}});
    single.Apply(FilterId::GuidedDecimation, {{"target_percent", 40.0}, {"measure_error", 0.0}});
    QCOMPARE(host.Layers(), std::size_t{4});
    QVERIFY(host.suffixes == (std::vector<std::string>{" 40%", " 20%", " 5%"}));
    QVERIFY(Fingerprint(host.Original()) == before);
    QVERIFY(Fingerprint(host.Layer(1)) == Fingerprint(single.Mesh()));
    const auto faces = Get<std::vector<double>>(report, "faces");
    const auto vertices = Get<std::vector<double>>(report, "vertices");
    const auto reached = Get<std::vector<double>>(report, "target_reached");
    QCOMPARE(faces.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(static_cast<int>(faces[i]), host.Layer(i + 1).fn);
        QCOMPARE(static_cast<int>(vertices[i]), host.Layer(i + 1).vn);
        QCOMPARE(reached[i], 1.0);
    }
    QVERIFY(host.log.front().find("40%: 1,280 -> 512 faces (40 %)") == 0);

    PlainHost errors(test_meshes::Icosphere(3)), strict(test_meshes::Icosphere(3));
    errors.Apply(FilterId::LevelsOfDetail, {{"max_errors", std::string("1,2.5")}, {"measure_error", 0.0}});
    QVERIFY(errors.suffixes == (std::vector<std::string>{" error 1%", " error 2.5%"}));
    QVERIFY(errors.Layer(2).fn < errors.Layer(1).fn);
    strict.Apply(FilterId::LevelsOfDetail,
                 {{"percents", std::string("40,20")}, {"order", 1.0}, {"measure_error", 0.0}});
    QCOMPARE(strict.Layer(2).fn, 256);
}

void TestFilters::levelsOfASelection()
{
    PlainHost host(test_meshes::Icosphere(3));
    SelectHalf(host.Mesh());
    const std::size_t selected = CountSelectedFaces(host.Mesh());
    host.Apply(FilterId::LevelsOfDetail, {{"percents", std::string("50,25")}, {"measure_error", 0.0}});
    for (const std::size_t i : {1U, 2U}) {
        const auto left = static_cast<double>(CountSelectedFaces(host.Layer(i)));
        QVERIFY(std::abs(left - static_cast<double>(selected) / (i == 1 ? 2 : 4)) <= 2);
    }
}

/// vcglib copies only those that the copy has already.
void TestFilters::newLayersHaveCustomAttributes()
{
    PlainHost host(test_meshes::Icosphere(3));
    PlainMesh& mesh = host.Mesh();
    auto vertex =
        vcg::tri::Allocator<PlainMesh>::AddVertices(mesh, 1); // and so the others are not all in order
    vcg::tri::Allocator<PlainMesh>::DeleteVertex(mesh, *vertex);
    auto number = vcg::tri::Allocator<PlainMesh>::AddPerVertexAttribute<float>(mesh, "number");
    for (const auto& v : mesh.vert) number[v] = static_cast<float>(v.cP()[2]);
    auto center = vcg::tri::Allocator<PlainMesh>::AddPerFaceAttribute<vcg::Point3d>(mesh, "center");
    for (auto& f : mesh.face) center[f] = vcg::Point3d(f.P(0)[0], f.P(0)[1], f.P(0)[2]);
    for (const double percent : {50.0, 100.0}) { // at 100 nothing is to be done
        host.ReturnToOriginal();
        host.Apply(FilterId::GuidedDecimation,
                   {{"target_percent", percent}, {"new_layer", 1.0}, {"measure_error", 0.0}});
        PlainMesh& copy = host.Mesh();
        QVERIFY(&copy != &host.Original());
        auto copied = vcg::tri::Allocator<PlainMesh>::FindPerVertexAttribute<float>(copy, "number");
        QVERIFY(vcg::tri::Allocator<PlainMesh>::IsValidHandle(copy, copied));
        // what is fitted is off by less than the height of a face over the sphere
        for (const auto& v : copy.vert) QVERIFY(std::abs(copied[v] - static_cast<float>(v.cP()[2])) < 0.05F);
        QVERIFY(vcg::tri::HasPerFaceAttribute(copy, "center"));
        copy.ClearAttributes();
    }
    host.Original().ClearAttributes();
}

/// Where vertices are doubled along a seam its edges are open, before and after.
void TestFilters::edgesAreThoseOfTheMeshThatIsLeft()
{
    const test_meshes::IndexedMesh half = test_meshes::Grid(12, 12);
    PlainHost host(test_meshes::Merged(half, test_meshes::Moved(half, 0, 1, {12, 0, 0})));
    for (std::size_t v = 0; v < host.Mesh().vert.size(); ++v) {
        auto& vertex = host.Mesh().vert[v];
        const bool right = v >= half.points.size();
        vertex.T() = {static_cast<float>(vertex.P()[0] / 48 + (right ? 0.5 : 0)),
                      static_cast<float>(vertex.P()[1] / 48)};
    }
    for (const bool newLayer : {true, false}) {
        const Report report = host.Apply(
            FilterId::GuidedDecimation,
            {{"target_percent", 25.0}, {"new_layer", newLayer ? 1.0 : 0.0}, {"measure_error", 0.0}});
        QVERIFY(Get<int>(report, "welded_vertices") > 0);
        const auto edges = EdgesOf(host.Mesh());
        QCOMPARE(Get<int>(report, "boundary_edges"), static_cast<int>(edges.boundary));
        host.ReturnToOriginal();
    }
}

/// As the other filter leaves a mesh that has no more faces than the target.
void TestFilters::levelOfAllFacesIsTheMesh()
{
    const test_meshes::IndexedMesh half = test_meshes::Grid(8, 8);
    PlainHost host(test_meshes::Merged(half, test_meshes::Moved(half, 0, 1, {8, 0, 0}))); // could be welded
    const auto before = Fingerprint(host.Mesh());
    const Report report =
        host.Apply(FilterId::LevelsOfDetail, {{"percents", std::string("100,50")}, {"measure_error", 0.0}});
    QVERIFY(Fingerprint(host.Layer(1)) == before);
    QCOMPARE(Get<std::vector<double>>(report, "faces"), (std::vector<double>{256, 128}));
}

/// Vertex 0 is deleted: every level has to be put into a copy whose vertices have other numbers.
void TestFilters::levelsOfAMeshWithDeletedVertices()
{
    PlainHost host(test_meshes::Merged(test_meshes::BowTie(), test_meshes::Icosphere(3)));
    PlainMesh& mesh = host.Mesh();
    const std::size_t others = test_meshes::BowTie().points.size();
    for (auto& face : mesh.face)
        if (vcg::tri::Index(mesh, face.V(0)) < others) vcg::tri::Allocator<PlainMesh>::DeleteFace(mesh, face);
    for (std::size_t v = 0; v < others; ++v) vcg::tri::Allocator<PlainMesh>::DeleteVertex(mesh, mesh.vert[v]);
    host.Apply(FilterId::LevelsOfDetail, {{"measure_error", 0.0}});
    for (const std::size_t i : {1U, 2U, 3U})
        for (const auto& v : host.Layer(i).vert) QVERIFY(std::abs(v.P().Norm() - 1) < 0.1F); // not torn off
}

void TestFilters::badLevelsAreRefused()
{
    PlainHost host(test_meshes::Icosphere(2));
    const std::pair<std::map<std::string, GivenValue>, const char*> refused[] = {
        {{{"percents", std::string("10,50")}}, "percents = 50 comes after 10: the finest level is the first"},
        {{{"percents", std::string()}}, "percents = \"\" has no level"},
        {{{"max_errors", std::string("2,1")}}, "max_errors = 1 comes after 2: the finest level is the first"},
        {{{"max_errors", std::string("1")}, {"max_error", 2.0}},
         "max_error = 2 and max_errors are two bounds: give one of them"},
        {{{"max_errors", std::string("1")}, {"order", 1.0}}, "max_errors = 1 needs order sweeps"}};
    for (const auto& [values, said] : refused)
        QCOMPARE(FailureOf(host, FilterId::LevelsOfDetail, values), QString(said));
    QCOMPARE(host.Layers(), std::size_t{1});
}

void TestFilters::smoothingMovesOnlyTheSelection()
{
    PlainHost host(test_meshes::Noisy(test_meshes::Icosphere(3), .02));
    for (std::size_t f = 0; f < 10; ++f) host.Mesh().face[f].SetS();
    std::vector<PlainMesh::CoordType> before;
    for (const auto& v : host.Mesh().vert) before.push_back(v.P());
    const auto inScope = VerticesInScope(host.Mesh(), true);
    const Report report = host.Apply(FilterId::UmbrellaSmooth);
    int moved = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
        const bool differs = host.Mesh().vert[v].P() != before[v];
        QVERIFY(inScope[v] || !differs);
        moved += differs;
    }
    QVERIFY(moved > 0);
    QCOMPARE(Get<int>(report, "moved"), moved);
}

void TestFilters::qualityThatIsNoNumberIsRefused()
{
    PlainHost host(test_meshes::Box(4));
    host.Mesh().vert[2].Q() = std::numeric_limits<float>::quiet_NaN();
    for (const FilterId filter :
         {FilterId::FeatureSelection, FilterId::GuidedDecimation, FilterId::WeightedDecimation})
        QCOMPARE(FailureOf(host, filter, {{"descriptor", 5.0}}),
                 "descriptor = vertex_quality, but the quality is not finite at 1 of 98 vertices");
}

QTEST_APPLESS_MAIN(TestFilters)
#include "test_filters.moc"
