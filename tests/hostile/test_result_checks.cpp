// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the runs of the corpus and the fuzzers would miss if a check missed it.

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <QtTest>

#include "checked_run.h"
#include "result_checks.h"

namespace
{

/// A square of two faces that has lost one of them: sound, but for what a test does to it.
struct Square {
    hostile::Case given;
    std::vector<double> positions{0, 0, 0, 1, 0, 0, 1, 1, 0};
    std::vector<std::uint32_t> vertexOrigin{0, 1, 2}, faces{0, 1, 2}, faceOrigin{0};

    Square()
    {
        given.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        given.faces = {0, 1, 2, 0, 2, 3};
        given.parameters.target_faces = 1;
    }
    std::string Fault() const
    {
        return FaultOfAMesh(given, {positions.data(), vertexOrigin.data(), vertexOrigin.size(), faces.data(),
                                    faceOrigin.data(), faceOrigin.size()});
    }
};

laplacian_simplify_result SoundResult()
{
    laplacian_simplify_result result{};
    result.face_count = 1;
    result.target_reached = 1;
    return result;
}

} // namespace

class TestResultChecks : public QObject
{
    Q_OBJECT

  private slots:
    void everyFaultOfAMeshIsSeen()
    {
        const auto faultAfter = [](const std::function<void(Square&)>& change) {
            Square square;
            change(square);
            return square.Fault();
        };
        using S = Square;
        QCOMPARE(faultAfter([](S&) {}), std::string());
        QVERIFY(!faultAfter([](S& s) { s.faces[1] = 3; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.faces[1] = 0; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.positions[4] = NAN; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.vertexOrigin = {0, 2, 1}; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.vertexOrigin[2] = 4; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.faceOrigin[0] = 2; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.given.fixed = {0, 0, 0, 1}; }).empty());
        QCOMPARE(faultAfter([](S& s) { s.given.fixed = {1, 1, 1, 0}; }), std::string());
        QVERIFY(!faultAfter([](S& s) { s.given.fixed = {1, 0, 0, 0}, s.positions[0] = 0.5; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.given.selected = {1, 0}; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.given.selected = {0, 1}, s.positions[0] = 0.5; }).empty());
        QVERIFY(!faultAfter([](S& s) { s.given.faces = {}; }).empty());
    }
    void everyFaultOfAReportIsSeen()
    {
        const hostile::Case given = Square().given;
        const auto faultAfter = [&](const std::function<void(laplacian_simplify_result&)>& change) {
            laplacian_simplify_result result = SoundResult();
            change(result);
            return FaultOfAReport(given, result);
        };
        using R = laplacian_simplify_result;
        QCOMPARE(faultAfter([](R&) {}), std::string());
        QVERIFY(!faultAfter([](R& r) { r.target_reached = 0; }).empty());
        QVERIFY(!faultAfter([](R& r) { r.stop_reason = 5; }).empty());
        QVERIFY(!faultAfter([](R& r) { r.has_distances = 1, r.rms = NAN; }).empty());
        QVERIFY(!faultAfter([](R& r) { r.has_certificate = 1, r.certified_error = 1; }).empty());
        QVERIFY(!faultAfter([](R& r) { r.folded = 2; }).empty());
    }
    void anyBytesAreACase()
    {
        const std::vector<std::uint8_t> bytes(100, 0xFF);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const hostile::Case given = hostile::CaseOf(bytes.data(), size);
            QVERIFY(hostile::CheckedRun(given).kind != hostile::Ending::Fault);
        }
    }
};

QTEST_APPLESS_MAIN(TestResultChecks)
#include "test_result_checks.moc"
