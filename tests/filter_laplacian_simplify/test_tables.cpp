// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The rows of the plugin's tables are promises to users: scripts and programs spell these names.

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include <QFile>
#include <QRegularExpression>
#include <QtTest>

#include "filters.h"
#include "filters_page.h"
#include "number_text.h"
#include "parameters.h"
#include "results.h"
#include "values.h"

using namespace laplacian_simplify;

Q_DECLARE_METATYPE(laplacian_simplify::FilterId)
Q_DECLARE_METATYPE(const laplacian_simplify::Parameter*)

namespace
{

constexpr double kFaceCountLimit = std::numeric_limits<int>::max();

const MeshFacts kMeshes[] = {{0, 0}, {1, 0}, {1, 1}, {12, 0}, {12, 5}, {2000000000, 0}};

bool IsSnakeCase(const char* id)
{
    static const QRegularExpression pattern("^[a-z][a-z0-9]*(_[a-z0-9]+)*$");
    return pattern.match(id).hasMatch();
}

/// What Check says about a value, "" where it is fine.
QString Complaint(const Parameter& parameter, const GivenValue& value)
{
    try {
        Check(parameter, value);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

const Parameter& Find(FilterId filter, const char* id)
{
    for (const Parameter* row : ParametersOf(filter))
        if (qstrcmp(row->id, id) == 0) return *row;
    throw std::logic_error(id);
}

} // namespace

class TestTables : public QObject
{
    Q_OBJECT

    static void EveryParameter()
    {
        QTest::addColumn<const Parameter*>("parameter");
        int number = 0;
        for (const Parameter& row : Parameters()) QTest::addRow("%d %s", number++, row.id) << &row;
    }

  private slots:
    void filtersStandAtThePlaceOfTheirId();
    void filterNamesAreThoseOfTheContract();
    void filterNamesFitIntoMenusAndPython();
    void descriptionsAreTwoLinesAtMost();
    void decimationsAreFoundByWhatPeopleCallThem();
    void advancedParametersAreTheLast();
    void slidersAreForNumbers();
    void labelsSayUnitAndRange_data() { EveryParameter(); }
    void labelsSayUnitAndRange();
    void parameterIdsAreThoseOfTheContract_data();
    void parameterIdsAreThoseOfTheContract();
    void returnedKeysAreThoseOfTheContract_data();
    void returnedKeysAreThoseOfTheContract();
    void idsAreSnakeCaseAndUniqueInAFilter();
    void defaultsAreThoseOfTheContract();
    void defaultLiesInTheRangeOnEveryMesh_data() { EveryParameter(); }
    void defaultLiesInTheRangeOnEveryMesh();
    void everyRowIsExplained_data() { EveryParameter(); }
    void everyRowIsExplained();
    void choicesHaveTextsForEveryValue_data() { EveryParameter(); }
    void choicesHaveTextsForEveryValue();
    void valueOutsideItsRangeIsRefusedByName_data() { EveryParameter(); }
    void valueOutsideItsRangeIsRefusedByName();
    void refusalsAreSentences();
    void numbersAreReadWithOrWithoutBlanks();
    void limitsOfTheRangeAreAccepted_data() { EveryParameter(); }
    void limitsOfTheRangeAreAccepted();
    void missingValuesAreTheDefaultOfTheMesh();
    void aBadValueIsFoundAmongGoodOnes();
    void numbersAreWrittenWithoutLocale();
    void floatsBecomeTheDecimalThatWasTyped();
    void committedPageIsUpToDate();
};

void TestTables::filtersStandAtThePlaceOfTheirId()
{
    for (std::size_t i = 0; i < Filters().size(); ++i) QCOMPARE(static_cast<std::size_t>(Filters()[i].id), i);
}

void TestTables::filterNamesAreThoseOfTheContract()
{
    const std::map<QString, QString> promised = {
        {"Laplacian Shape Descriptor", "compute_scalar_by_laplacian_descriptor_per_vertex"},
        {"Select Feature Vertices by Laplacian Descriptor",
         "compute_selection_by_laplacian_descriptor_per_vertex"},
        {"Simplification: Laplacian-Guided Quadric Edge Collapse",
         "meshing_decimation_laplacian_quadric_edge_collapse"},
        {"Simplification: Laplacian-Weighted Edge Collapse (Zhang et al. 2012)",
         "meshing_decimation_laplacian_weighted_edge_collapse"},
        {"Simplification: Laplacian-Guided Levels of Detail", "generate_laplacian_levels_of_detail"},
        {"Umbrella Smooth (Uniform, Scale- or Normal-Dependent)", "apply_coord_umbrella_smoothing"},
    };
    std::map<QString, QString> there;
    for (const Filter& filter : Filters()) there[filter.name] = filter.pythonName;
    QCOMPARE(there, promised);
}

void TestTables::filterNamesFitIntoMenusAndPython()
{
    for (const Filter& filter : Filters()) {
        QVERIFY2(!QString(filter.name).contains('&'), filter.name); // a menu would swallow it
        QVERIFY2(IsSnakeCase(filter.pythonName), filter.pythonName);
        QVERIFY2(IsSnakeCase(filter.key), filter.key);
        QVERIFY2(!filter.categories.empty() && filter.changes != 0, filter.name);
    }
}

/// MeshLab's dialogs show the description above the parameters, on screens of 768 lines: two of them are for
/// it.
void TestTables::descriptionsAreTwoLinesAtMost()
{
    constexpr int kLine = 140; // about what stands in 700 pixels, and the tags
    for (const Filter& filter : Filters()) {
        const QStringList lines = QString::fromStdString(Description(filter)).split("<br/>");
        QVERIFY(lines.size() <= 2);
        for (const QString& line : lines)
            QVERIFY2(line.size() > 40 && line.size() <= kLine, qPrintable(line));
    }
}

/// MeshLab's search ranks a filter by the words of its name and of its description.
void TestTables::decimationsAreFoundByWhatPeopleCallThem()
{
    for (const FilterId id :
         {FilterId::GuidedDecimation, FilterId::WeightedDecimation, FilterId::LevelsOfDetail}) {
        const QString description = QString::fromStdString(Description(Row(id))).toLower();
        QVERIFY2(description.contains("decimation"), Row(id).name);
        QVERIFY2(description.contains(QRegularExpression("\\bsimplif")), Row(id).name);
    }
}

/// Where a host has no button for them, as 2020.09, they are still out of the way.
void TestTables::advancedParametersAreTheLast()
{
    for (const Filter& filter : Filters()) {
        bool advanced = false;
        for (const Parameter* row : ParametersOf(filter.id)) {
            QVERIFY2(!advanced || (row->shown & kAdvanced) != 0, row->id);
            advanced = (row->shown & kAdvanced) != 0;
        }
    }
}

/// Over a range that reaches from end to end; of whole numbers no host has one.
void TestTables::slidersAreForNumbers()
{
    for (const Parameter& row : Parameters())
        QVERIFY2((row.shown & kSlider) == 0 || row.type == ParameterType::Real, row.id);
}

void TestTables::parameterIdsAreThoseOfTheContract_data()
{
    QTest::addColumn<FilterId>("filter");
    QTest::addColumn<QStringList>("ids");
    QTest::addRow("descriptor") << FilterId::ShapeDescriptor
                                << QStringList{"descriptor", "rescale", "colorize", "selected_only"};
    QTest::addRow("select") << FilterId::FeatureSelection << QStringList{"descriptor",
                                                                         "classes",
                                                                         "selected_classes",
                                                                         "refine",
                                                                         "minimum_feature_neighbours",
                                                                         "refinement_floor",
                                                                         "class_as_quality"};
    const QStringList ofBoth{"max_error", "feature_weight",  "effort",
                             "boundary",  "keep_attributes", "selected_only"};
    const QStringList lastOfBoth{"error_as_quality",
                                 "measure_error",
                                 "descriptor",
                                 "attribute_weight",
                                 "seams",
                                 "preserve_topology",
                                 "lock_selected_vertices",
                                 "avoid_self_intersections",
                                 "clean_input",
                                 "weld_distance",
                                 "order",
                                 "threads"};
    QTest::addRow("guided") << FilterId::GuidedDecimation
                            << QStringList{"target_faces", "target_percent"} + ofBoth +
                                   QStringList{"new_layer"} + lastOfBoth;
    QTest::addRow("levels") << FilterId::LevelsOfDetail
                            << QStringList{"percents", "max_errors"} + ofBoth + lastOfBoth;
    QTest::addRow("weighted") << FilterId::WeightedDecimation
                              << QStringList{"error_function", "target_faces", "target_percent",
                                             "feature_weight", "descriptor",   "class_aware",
                                             "classes",        "refine",       "selected_only"};
    QTest::addRow("smooth") << FilterId::UmbrellaSmooth
                            << QStringList{"operator", "steps", "step_size", "boundary", "selected_only"};
}

void TestTables::parameterIdsAreThoseOfTheContract()
{
    QFETCH(FilterId, filter);
    QFETCH(QStringList, ids);
    QStringList there;
    for (const Parameter* row : ParametersOf(filter)) there << row->id;
    QCOMPARE(there, ids);
}

void TestTables::returnedKeysAreThoseOfTheContract_data()
{
    QTest::addColumn<FilterId>("filter");
    QTest::addColumn<QStringList>("ids");
    QTest::addRow("descriptor") << FilterId::ShapeDescriptor
                                << QStringList{"minimum", "maximum", "mean", "percentile_99_9", "seconds"};
    QTest::addRow("select") << FilterId::FeatureSelection
                            << QStringList{"thresholds", "centers",  "class_sizes",
                                           "promoted",   "selected", "seconds"};
    QTest::addRow("guided") << FilterId::GuidedDecimation
                            << QStringList{"faces_before",
                                           "faces",
                                           "vertices",
                                           "target_reached",
                                           "stop_reason",
                                           "hausdorff",
                                           "rms",
                                           "feature_rms",
                                           "folded",
                                           "non_manifold_edges",
                                           "boundary_edges",
                                           "self_intersections",
                                           "self_intersections_before",
                                           "welded_vertices",
                                           "dropped_faces",
                                           "certified_error",
                                           "attribute_rms",
                                           "texture_deviation",
                                           "largest_texture_deviation",
                                           "turned_texture_faces",
                                           "faces_held_by_seams",
                                           "seconds"};
}

void TestTables::returnedKeysAreThoseOfTheContract()
{
    QFETCH(FilterId, filter);
    QFETCH(QStringList, ids);
    QStringList there;
    for (const Result* row : ResultsOf(filter)) there << row->id;
    QCOMPARE(there, ids);
}

void TestTables::idsAreSnakeCaseAndUniqueInAFilter()
{
    for (const Filter& filter : Filters()) {
        std::set<QString> ids;
        for (const Parameter* row : ParametersOf(filter.id)) {
            QVERIFY2(IsSnakeCase(row->id), row->id);
            QVERIFY2(ids.insert(row->id).second, row->id);
        }
        for (const Result* row : ResultsOf(filter.id)) {
            QVERIFY2(IsSnakeCase(row->id), row->id);
            QVERIFY2(ids.insert(row->id).second, row->id);
        }
    }
}

void TestTables::defaultsAreThoseOfTheContract()
{
    const auto text = [](FilterId filter, const char* id) {
        return QString::fromStdString(DefaultText(Find(filter, id)));
    };
    const auto guided = FilterId::GuidedDecimation;
    QCOMPARE(text(FilterId::WeightedDecimation, "feature_weight"), "10");
    QCOMPARE(text(guided, "feature_weight"), "2");
    QCOMPARE(text(guided, "max_error"), "0");
    QCOMPARE(text(guided, "effort"), "1 `balanced`");
    QCOMPARE(text(guided, "boundary"), "1 `preserve`");
    QCOMPARE(text(guided, "order"), "0 `sweeps`");
    QCOMPARE(text(FilterId::LevelsOfDetail, "percents"), "50,25,10");
    QCOMPARE(text(FilterId::LevelsOfDetail, "max_errors"), "");
    QCOMPARE(text(guided, "keep_attributes"), "true");
    QCOMPARE(text(guided, "attribute_weight"), "1");
    QCOMPARE(text(guided, "seams"), "0 `keep`");
    QCOMPARE(text(guided, "measure_error"), "true");
    QCOMPARE(Find(guided, "target_faces").Default({100, 0}), 50.0);
    QCOMPARE(Find(guided, "target_faces").Default({100, 30}), 15.0);
    QCOMPARE(Find(guided, "target_faces").Default({0, 0}), 1.0);
    QCOMPARE(Find(guided, "selected_only").Default({100, 0}), 0.0);
    QCOMPARE(Find(guided, "selected_only").Default({100, 30}), 1.0);
    QCOMPARE(text(FilterId::ShapeDescriptor, "colorize"), "true");
    QCOMPARE(text(FilterId::ShapeDescriptor, "rescale"), "false");
    QCOMPARE(text(FilterId::FeatureSelection, "classes"), "2");
    QCOMPARE(text(FilterId::FeatureSelection, "selected_classes"), "1");
    QCOMPARE(text(FilterId::FeatureSelection, "refinement_floor"), "0.5");
    QCOMPARE(text(FilterId::UmbrellaSmooth, "steps"), "10");
    QCOMPARE(text(FilterId::UmbrellaSmooth, "step_size"), "0.5");
}

void TestTables::defaultLiesInTheRangeOnEveryMesh()
{
    QFETCH(const Parameter*, parameter);
    for (const MeshFacts& facts : kMeshes) {
        GivenValue value = parameter->Default(facts);
        if (parameter->type == ParameterType::Numbers) value = std::string(parameter->defaultValue.numbers);
        QCOMPARE(Complaint(*parameter, value), QString());
    }
    QCOMPARE(parameter->defaultValue.onMesh != nullptr, *parameter->defaultValue.description != '\0');
}

void TestTables::everyRowIsExplained()
{
    QFETCH(const Parameter*, parameter);
    QVERIFY(!parameter->filters.empty());
    QVERIFY(qstrlen(parameter->label) > 0);
    QVERIFY2(QString(parameter->help).endsWith('.'), parameter->help);
    QVERIFY2(!QString(parameter->help).contains('|'), "it stands in a table of docs/filters.md");
    QVERIFY(parameter->range.minimum < parameter->range.maximum);
}

/// But for numbers of faces, which have no upper end.
void TestTables::labelsSayUnitAndRange()
{
    QFETCH(const Parameter*, parameter);
    const QString label = parameter->label;
    if (parameter->type == ParameterType::Boolean || parameter->type == ParameterType::Choice) return;
    if (parameter->range.maximum == kFaceCountLimit) return;
    if (QString(parameter->unit) == "percent of the bounding box diagonal")
        QVERIFY2(label.contains("% of diagonal"), parameter->label);
    else
        QVERIFY2(label.contains(QString("%1-%2").arg(parameter->range.minimum).arg(parameter->range.maximum)),
                 parameter->label);
}

void TestTables::choicesHaveTextsForEveryValue()
{
    QFETCH(const Parameter*, parameter);
    QCOMPARE(parameter->type == ParameterType::Choice, !parameter->options.empty());
    if (parameter->options.empty()) return;
    QCOMPARE(parameter->range.minimum, 0.0);
    QCOMPARE(parameter->range.maximum, static_cast<double>(parameter->options.size() - 1));
    std::set<std::string> ids, texts;
    for (const Option& option : parameter->options) {
        QVERIFY2(IsSnakeCase(option.id.c_str()), option.id.c_str());
        QVERIFY(ids.insert(option.id).second);
        QVERIFY(!option.text.empty() && texts.insert(option.text).second);
    }
}

void TestTables::valueOutsideItsRangeIsRefusedByName()
{
    QFETCH(const Parameter*, parameter);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<GivenValue> bad = {
        parameter->range.minimum - 1, parameter->range.maximum + 1, nan, infinity, -infinity,
        std::string("many")};
    const bool real = parameter->type == ParameterType::Real || parameter->type == ParameterType::Numbers;
    if (!real) bad.emplace_back(parameter->range.minimum + 0.5);
    if (!parameter->range.minimumIncluded) bad.emplace_back(parameter->range.minimum);
    for (const GivenValue& value : bad) {
        const QString complaint = Complaint(*parameter, value);
        QVERIFY2(complaint.startsWith(QString(parameter->id) + " = "), qPrintable(complaint));
        QVERIFY2(complaint.endsWith(QString::fromStdString(RangeText(*parameter))), qPrintable(complaint));
    }
}

void TestTables::refusalsAreSentences()
{
    const auto guided = FilterId::GuidedDecimation;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(Complaint(Find(guided, "feature_weight"), 50.5), "feature_weight = 50.5 is outside [0, 50]");
    QCOMPARE(Complaint(Find(guided, "feature_weight"), nan), "feature_weight = nan is outside [0, 50]");
    QCOMPARE(Complaint(Find(guided, "target_faces"), -5.0),
             "target_faces = -5 is outside [1, 2147483647] (faces)");
    QCOMPARE(Complaint(Find(guided, "effort"), 7.0),
             "effort = 7 is not one of fast (0), balanced (1), best (2)");
    QCOMPARE(Complaint(Find(guided, "effort"), 0.5),
             "effort = 0.5 is not one of fast (0), balanced (1), best (2)");
    QCOMPARE(Complaint(Find(guided, "effort"), std::string("Best")),
             "effort = \"Best\" is not one of fast (0), balanced (1), best (2)");
    QCOMPARE(Complaint(Find(guided, "new_layer"), 2.0), "new_layer = 2 is not true or false");
    QCOMPARE(Complaint(Find(guided, "target_percent"), 200.0),
             "target_percent = 200 is outside [0, 100] (percent of the faces)");
    QCOMPARE(Complaint(Find(guided, "threads"), 1.5), "threads = 1.5 is not a whole number in [0, 1024]");
    QCOMPARE(Complaint(Find(guided, "threads"), std::string("all")),
             "threads = \"all\" is not a number in [0, 1024]");
    QCOMPARE(Complaint(Find(FilterId::UmbrellaSmooth, "step_size"), 0.0), "step_size = 0 is outside (0, 1]");
    const Parameter& percents = Find(FilterId::LevelsOfDetail, "percents");
    const QString range = " is not a number in (0, 100] (percent of the faces)";
    QCOMPARE(Complaint(percents, std::string("50, x,10")), "percents = \"50, x,10\": \"x\"" + range);
    QCOMPARE(Complaint(percents, std::string("50,25%")), "percents = \"50,25%\": \"25%\"" + range);
    QCOMPARE(Complaint(percents, std::string("50,,10")), "percents = \"50,,10\": \"\"" + range);
    QCOMPARE(Complaint(percents, std::string("50,101")), "percents = \"50,101\": \"101\"" + range);
    QCOMPARE(Complaint(percents, std::string("nan")), "percents = \"nan\": \"nan\"" + range);
}

void TestTables::numbersAreReadWithOrWithoutBlanks()
{
    const Parameter& percents = Find(FilterId::LevelsOfDetail, "percents");
    QVERIFY(NumbersIn(percents, " 50,25 , 12.5") == (std::vector<double>{50, 25, 12.5}));
    QVERIFY(NumbersIn(percents, "1e1") == std::vector<double>{10});
    QVERIFY(NumbersIn(percents, "  ").empty());
}

void TestTables::limitsOfTheRangeAreAccepted()
{
    QFETCH(const Parameter*, parameter);
    QCOMPARE(Complaint(*parameter, parameter->range.maximum), QString());
    if (parameter->range.minimumIncluded)
        QCOMPARE(Complaint(*parameter, parameter->range.minimum), QString());
}

void TestTables::missingValuesAreTheDefaultOfTheMesh()
{
    const Values values(
        FilterId::GuidedDecimation,
        [] {
            return MeshFacts{1000, 100};
        },
        [](const Parameter&) { return std::nullopt; });
    QCOMPARE(values.Integer("target_faces"), 50);
    QCOMPARE(values.Boolean("selected_only"), true);
    QCOMPARE(values.Real("feature_weight"), 2.0);
    QVERIFY_EXCEPTION_THROWN(values.Real("no_such_parameter"), std::logic_error);
}

void TestTables::aBadValueIsFoundAmongGoodOnes()
{
    const auto given = [](const Parameter& row) -> std::optional<GivenValue> {
        if (qstrcmp(row.id, "threads") == 0) return -1.0;
        return std::nullopt;
    };
    const auto noMesh = [] { return MeshFacts{}; };
    QVERIFY_EXCEPTION_THROWN(Values(FilterId::GuidedDecimation, noMesh, given), std::invalid_argument);
    const Values fine(FilterId::ShapeDescriptor, noMesh, given); // has no such parameter
    QCOMPARE(fine.Integer("descriptor"), 0);
}

void TestTables::numbersAreWrittenWithoutLocale()
{
    QCOMPARE(NumberText(0.1), std::string("0.1"));
    QCOMPARE(NumberText(-5), std::string("-5"));
    QCOMPARE(NumberText(2147483647), std::string("2147483647"));
    QCOMPARE(RoundedText(0.0123456, 3), std::string("0.0123"));
    QCOMPARE(FixedText(0.005, 2), std::string("0.01")); // the double is just above 0.005
    QCOMPARE(FixedText(1234.5, 2), std::string("1234.50"));
    QCOMPARE(CountText(0), std::string("0"));
    QCOMPARE(CountText(999), std::string("999"));
    QCOMPARE(CountText(1000), std::string("1,000"));
    QCOMPARE(CountText(17834496), std::string("17,834,496"));
}

void TestTables::floatsBecomeTheDecimalThatWasTyped()
{
    QCOMPARE(ExactDecimal(33.3f), 33.3);
    QCOMPARE(ExactDecimal(0.1f), 0.1);
    QCOMPARE(ExactDecimal(0.1), 0.1);
    QVERIFY(std::isnan(ExactDecimal(std::numeric_limits<float>::quiet_NaN())));
    QVERIFY(std::isinf(ExactDecimal(std::numeric_limits<float>::infinity())));
}

void TestTables::committedPageIsUpToDate()
{
    QFile page(QString(SAMPLE_MESHES_DIR) + "/../docs/filters.md");
    QVERIFY2(page.open(QIODevice::ReadOnly), qPrintable(page.fileName()));
    QVERIFY2(page.readAll() == QByteArray::fromStdString(FiltersPage()),
             "docs/filters.md differs from the tables: run scripts/write-filters-page");
}

QTEST_APPLESS_MAIN(TestTables)
#include "test_tables.moc"
