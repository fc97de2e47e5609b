// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/simplify.h"

using namespace vcg_ext;
using test_meshes::IndexedMesh;
using test_meshes::Point;

namespace
{

/// A mesh with attributes that are functions of the place and of the face's label.
struct Painted {
    IndexedMesh mesh;
    std::vector<float> values;
    std::vector<std::int32_t> labels;
    CornerAttributes attributes;

    using Value = std::function<std::vector<double>(const Point&, std::int32_t)>;
    using Label = std::function<std::int32_t(const Point& centroid)>;

    Painted(IndexedMesh m, std::vector<ChannelKind> kinds, const Label& label, const Value& value)
        : mesh(std::move(m))
    {
        attributes.kinds = std::move(kinds);
        for (const auto& t : mesh.triangles) {
            Point centroid{0, 0, 0};
            for (const std::uint32_t v : t)
                for (std::size_t k = 0; k < 3; ++k) centroid[k] += mesh.points[v][k] / 3;
            labels.push_back(label(centroid));
            for (const std::uint32_t v : t)
                for (const double x : value(mesh.points[v], labels.back()))
                    values.push_back(static_cast<float>(x));
        }
    }
    MeshView View()
    {
        attributes.values = values.data();
        attributes.labels = labels.data();
        MeshView view = test_meshes::View(mesh);
        view.attributes = &attributes;
        return view;
    }
};

const std::vector<ChannelKind> kTexture{ChannelKind::Texture, ChannelKind::Texture};

DecimationParameters Target(std::size_t faces, Effort effort = Effort::Balanced, int threads = 1)
{
    DecimationParameters parameters;
    parameters.targetFaces = faces;
    parameters.effort = effort;
    parameters.threads = threads;
    parameters.measureError = false;
    return parameters;
}

std::int32_t OneLabel(const Point&)
{
    return 0;
}

double Area(const DecimatedMesh& mesh)
{
    IndexedMesh plain;
    plain.points = mesh.positions;
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Point &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        std::array<double, 3> n{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        }
        sum += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
    }
    return sum;
}

/// A bumpy sheet cut into four by four charts of two materials, each with its own cell of the texture. The
/// seams lie on edges of the grid.
Painted Patchwork(int size = 32)
{
    IndexedMesh sheet = test_meshes::Grid(size, size, 1.0 / size);
    for (Point& p : sheet.points) p[2] = 0.1 * std::sin(5 * p[0]) * std::cos(4 * p[1]);
    const auto cell = [](const Point& p) {
        return static_cast<std::int32_t>(4 * p[0]) + 4 * static_cast<std::int32_t>(4 * p[1]);
    };
    return {std::move(sheet), kTexture, cell, [](const Point& p, std::int32_t label) {
                // The cells of the texture lie apart, in reverse order, so that none continues another.
                const int i = label % 4, j = label / 4;
                return std::vector<double>{2.0 * (3 - i) + 4 * p[0] - i, 2.0 * (3 - j) + 4 * p[1] - j};
            }};
}

int TurnedFaces(const DecimatedMesh& mesh)
{
    int turned = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const float* v = mesh.cornerValues.data() + 6 * f;
        turned += !(DoubleTextureArea(v, v + 2, v + 4, 0) > 0);
    }
    return turned;
}

} // namespace

class TestAttributes : public QObject
{
    Q_OBJECT

  private slots:
    /// Texture coordinates that are linear in the place are so after any decimation. The tolerance is the
    /// rounding of single precision, some hundred times: coordinates of up to 8 and positions in a frame.
    void linearTextureOnAPlaneStaysExact()
    {
        const auto linear = [](const Point& p, std::int32_t) {
            return std::vector<double>{3 * p[0] + 2 * p[1] + 1, 4 * p[1] - p[0]};
        };
        IndexedMesh sheet = test_meshes::Grid(40, 40, 1.0 / 40);
        for (std::size_t v = 0; v < sheet.points.size(); ++v) { // of no regularity that would help
            Point& p = sheet.points[v];
            const bool border = p[0] < 1e-9 || p[1] < 1e-9 || p[0] > 1 - 1e-9 || p[1] > 1 - 1e-9;
            if (!border) p[0] += 0.004 * std::sin(37.0 * static_cast<double>(v));
        }
        Painted painted(sheet, kTexture, OneLabel, linear);
        for (const Effort effort : {Effort::Fast, Effort::Balanced, Effort::Best})
            for (const std::size_t target : {1600U, 200U, 10U}) {
                const DecimatedMesh mesh = Simplify(painted.View(), Target(target, effort)).mesh;
                QVERIFY(mesh.triangles.size() <= target);
                for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
                    for (std::size_t k = 0; k < 3; ++k) {
                        const auto wanted = linear(mesh.positions[mesh.triangles[f][k]], 0);
                        for (std::size_t j = 0; j < 2; ++j) {
                            const auto value = static_cast<double>(mesh.cornerValues[(3 * f + k) * 2 + j]);
                            QVERIFY2(std::fabs(value - wanted[j]) < 1e-4,
                                     qPrintable(QString("%1 instead of %2").arg(value).arg(wanted[j])));
                        }
                    }
            }
    }

    /// Where every chart has a cell of the texture to itself, every face shows its own cell and no other, its
    /// orientation stays, and no chart is lost.
    void everyFaceShowsItsOwnChart()
    {
        Painted painted = Patchwork();
        for (const Effort effort : {Effort::Fast, Effort::Balanced, Effort::Best})
            for (const std::size_t target : {1000U, 300U, 60U}) {
                const DecimatedMesh mesh = Simplify(painted.View(), Target(target, effort)).mesh;
                QVERIFY(mesh.triangles.size() <= target);
                std::set<std::int32_t> shown;
                for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
                    const std::int32_t label = painted.labels[mesh.faceOrigin[f]];
                    shown.insert(label);
                    for (std::size_t k = 0; k < 3; ++k) {
                        const float* uv = mesh.cornerValues.data() + 2 * (3 * f + k);
                        const auto column = 2 * (3 - label % 4), row = 2 * (3 - label / 4);
                        QVERIFY(uv[0] >= static_cast<float>(column) &&
                                uv[0] <= static_cast<float>(column + 1));
                        QVERIFY(uv[1] >= static_cast<float>(row) && uv[1] <= static_cast<float>(row + 1));
                    }
                }
                QCOMPARE(shown.size(), std::size_t{16});
                QCOMPARE(TurnedFaces(mesh), 0);
            }
    }

    /// Even where attributes guide nothing, no texture turns over: not on a texture that is bent everywhere.
    void noTextureTurnsOver()
    {
        IndexedMesh sheet = test_meshes::Grid(40, 40, 1.0 / 40);
        for (Point& p : sheet.points) p[2] = 0.05 * std::sin(20 * p[0]) * std::cos(17 * p[1]);
        Painted painted(std::move(sheet), kTexture, OneLabel, [](const Point& p, std::int32_t) {
            return std::vector<double>{p[0] + 0.045 * std::sin(20 * p[1]),
                                       p[1] + 0.045 * std::sin(20 * p[0])};
        });
        auto parameters = Target(100, Effort::Fast);
        parameters.attributeWeight = 0;
        for (const std::size_t target : {800U, 300U, 100U}) {
            parameters.targetFaces = target;
            QCOMPARE(TurnedFaces(Simplify(painted.View(), parameters).mesh), 0);
        }
    }

    /// The texture says where each of its points belongs. On a sheet that bends by a tenth, what a face shows
    /// is not farther from there than two edges of the result.
    void theTextureStaysInItsPlace()
    {
        Painted painted = Patchwork();
        const DecimatedMesh mesh = Simplify(painted.View(), Target(400)).mesh;
        const double edge = std::sqrt(2.3 * Area(mesh) / 400);
        double squares = 0;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t label = painted.labels[mesh.faceOrigin[f]];
                const float* uv = mesh.cornerValues.data() + 2 * (3 * f + k);
                const auto column = label % 4, row = label / 4;
                const double x = (static_cast<double>(uv[0]) - 2.0 * (3 - column) + column) / 4;
                const double y = (static_cast<double>(uv[1]) - 2.0 * (3 - row) + row) / 4;
                const Point& p = mesh.positions[mesh.triangles[f][k]];
                squares += (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y);
            }
        const double rms = std::sqrt(squares / static_cast<double>(3 * mesh.triangles.size()));
        QVERIFY2(rms < 0.05 * edge, qPrintable(QString("%1 of an edge").arg(rms / edge)));
    }

    /// Seams are no cracks: the border has the edges that it had without attributes, one closed curve.
    void seamsDoNotOpen()
    {
        Painted painted(
            test_meshes::Icosphere(4), kTexture, [](const Point& p) { return p[2] > 0 ? 1 : 0; },
            [](const Point& p, std::int32_t label) {
                return std::vector<double>{p[0] + 4 * label, p[1]};
            });
        for (const std::size_t target : {2000U, 400U, 60U}) {
            const DecimationReport report = Simplify(painted.View(), Target(target)).report;
            QCOMPARE(report.edges.boundary, std::size_t{0});
            QCOMPARE(report.edges.nonManifold, std::size_t{0});
        }
    }

    /// A hard border between two colors stays where it is: at 5 % of the faces it has moved by less than what
    /// a blind run loses.
    void hardColorsKeepTheirBorder()
    {
        IndexedMesh sheet = test_meshes::Grid(48, 48, 1.0 / 48);
        for (Point& p : sheet.points) p[2] = 0.02 * std::sin(9 * p[0] + 4 * p[1]);
        const auto inside = [](const Point& p) {
            return std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.3 ? 1.0 : 0.0;
        };
        Painted painted(sheet, {ChannelKind::Color}, OneLabel,
                        [&](const Point& p, std::int32_t) { return std::vector<double>{inside(p)}; });
        const auto error = [&](double weight) {
            auto parameters = Target(230);
            parameters.attributeWeight = weight;
            const DecimatedMesh mesh = Simplify(painted.View(), parameters).mesh;
            double sum = 0;
            for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
                const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[f][k]]; };
                const double area = (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
                                    (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]);
                const Point centroid{(at(0)[0] + at(1)[0] + at(2)[0]) / 3,
                                     (at(0)[1] + at(1)[1] + at(2)[1]) / 3, 0};
                double value = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    value += static_cast<double>(mesh.cornerValues[3 * f + k]) / 3;
                sum += area * std::fabs(value - inside(centroid));
            }
            return sum;
        };
        QVERIFY2(error(1) < 0.7 * error(0), qPrintable(QString("%1 %2").arg(error(1)).arg(error(0))));
    }

    /// The values at the vertices are those that fit the whole faces: what a face shows at its center is
    /// closer to the truth than with the true values at its corners, which lie on one side of every bend.
    void valuesFitWholeFaces()
    {
        const auto color = [](const Point& p) { return 0.5 + 0.2 * (p[0] * p[0] + p[1] * p[1]); };
        Painted painted(test_meshes::Grid(60, 60, 1.0 / 30), {ChannelKind::Color}, OneLabel,
                        [&](const Point& p, std::int32_t) { return std::vector<double>{color(p)}; });
        const DecimatedMesh mesh = Simplify(painted.View(), Target(300)).mesh;
        double fitted = 0, interpolated = 0;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            Point centroid{0, 0, 0};
            double values = 0, truth = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Point& p = mesh.positions[mesh.triangles[f][k]];
                for (std::size_t j = 0; j < 3; ++j) centroid[j] += p[j] / 3;
                values += static_cast<double>(mesh.cornerValues[3 * f + k]) / 3;
                truth += color(p) / 3;
            }
            fitted += std::pow(values - color(centroid), 2);
            interpolated += std::pow(truth - color(centroid), 2);
        }
        QVERIFY2(fitted < 0.4 * interpolated, qPrintable(QString("%1 %2").arg(fitted).arg(interpolated)));
    }

    /// Values never leave the range of the input, of colors and of scalars in their own unit.
    void valuesStayWithinTheirRange()
    {
        Painted painted(test_meshes::Noisy(test_meshes::Torus(40, 20), 0.01),
                        {ChannelKind::Color, ChannelKind::Scalar}, OneLabel,
                        [](const Point& p, std::int32_t) {
                            return std::vector<double>{p[0] > 0 ? 1.0 : 0.0, 5000 + 300 * std::sin(9 * p[1])};
                        });
        const auto range = [](const std::vector<float>& values, std::size_t channel) {
            std::pair<float, float> found{std::numeric_limits<float>::max(), -1};
            for (std::size_t i = channel; i < values.size(); i += 2)
                found = {std::min(found.first, values[i]), std::max(found.second, values[i])};
            return found;
        };
        const DecimatedMesh mesh = Simplify(painted.View(), Target(150)).mesh;
        for (const std::size_t channel : {0U, 1U}) {
            const auto before = range(painted.values, channel), after = range(mesh.cornerValues, channel);
            QVERIFY(after.first >= before.first && after.second <= before.second);
            QVERIFY(after.second - after.first > 0.8F * (before.second - before.first));
        }
    }

    /// A color that is not cut at the seam of the texture has one value on both sides of it.
    void uncutChannelsStayUncut()
    {
        Painted painted(
            test_meshes::Icosphere(4), {ChannelKind::Texture, ChannelKind::Texture, ChannelKind::Color},
            [](const Point& p) { return p[2] > 0 ? 1 : 0; },
            [](const Point& p, std::int32_t label) {
                return std::vector<double>{p[0] + 4 * label, p[1], 0.5 + 0.4 * std::sin(5 * p[0])};
            });
        const DecimatedMesh mesh = Simplify(painted.View(), Target(400)).mesh;
        std::map<std::uint32_t, std::set<float>> colors;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                colors[mesh.triangles[f][k]].insert(mesh.cornerValues[3 * (3 * f + k) + 2]);
        for (const auto& [vertex, values] : colors) QCOMPARE(values.size(), std::size_t{1});
    }

    void theBytesDoNotDependOnTheThreads()
    {
        Painted painted(
            test_meshes::Noisy(test_meshes::Torus(160, 80), 0.003),
            {ChannelKind::Texture, ChannelKind::Texture, ChannelKind::Color},
            [](const Point& p) { return (p[0] > 0 ? 1 : 0) + (p[1] > 0 ? 2 : 0); },
            [](const Point& p, std::int32_t label) {
                return std::vector<double>{std::atan2(p[1], p[0]) + 9 * label, p[2],
                                           0.5 + 0.5 * std::sin(7 * p[0])};
            });
        for (const Effort effort : {Effort::Fast, Effort::Balanced}) {
            const DecimatedMesh one = Simplify(painted.View(), Target(3000, effort, 1)).mesh;
            const DecimatedMesh four = Simplify(painted.View(), Target(3000, effort, 4)).mesh;
            QVERIFY(one.positions == four.positions);
            QVERIFY(one.triangles == four.triangles);
            QVERIFY(one.cornerValues == four.cornerValues);
        }
    }

    /// Faces of fixed vertices keep all their values, bit by bit.
    void fixedFacesKeepTheirValues()
    {
        Painted painted = Patchwork();
        std::vector<std::uint8_t> fixed;
        for (const Point& p : painted.mesh.points) fixed.push_back(p[0] < 0.4 ? 1 : 0);
        MeshView view = painted.View();
        view.fixedVertices = fixed.data();
        const DecimatedMesh mesh = Simplify(view, Target(900)).mesh;
        std::size_t untouched = 0;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            const auto& before = painted.mesh.triangles[mesh.faceOrigin[f]];
            if (!(fixed[before[0]] && fixed[before[1]] && fixed[before[2]])) continue;
            ++untouched;
            QVERIFY(std::equal(mesh.cornerValues.begin() + 6 * static_cast<std::ptrdiff_t>(f),
                               mesh.cornerValues.begin() + 6 * static_cast<std::ptrdiff_t>(f + 1),
                               painted.values.begin() + 6 * static_cast<std::ptrdiff_t>(mesh.faceOrigin[f])));
        }
        const auto isFixed = [&](const auto& t) { return fixed[t[0]] && fixed[t[1]] && fixed[t[2]]; };
        QCOMPARE(untouched, static_cast<std::size_t>(std::count_if(painted.mesh.triangles.begin(),
                                                                   painted.mesh.triangles.end(), isFixed)));
    }

    /// With a locked border and with a bound on the error the same rules hold.
    void seamsHoldBesideOtherLimits()
    {
        Painted painted = Patchwork(24);
        auto locked = Target(300);
        locked.boundary = Boundary::Lock;
        auto bounded = Target(100);
        bounded.maxError = 1;
        for (const auto& parameters : {locked, bounded}) {
            const Simplification result = Simplify(painted.View(), parameters);
            QVERIFY(result.mesh.triangles.size() < 800);
            QCOMPARE(TurnedFaces(result.mesh), 0);
            std::set<std::int32_t> shown;
            for (const std::uint32_t origin : result.mesh.faceOrigin) shown.insert(painted.labels[origin]);
            QCOMPARE(shown.size(), std::size_t{16});
        }
    }

    /// What is named is what held the run: a bound only where it has refused something.
    void stopReasonIsWhatHolds()
    {
        Painted painted = Patchwork(24);
        auto parameters = Target(1, Effort::Fast);
        parameters.maxError = 50;
        const Simplification loose = Simplify(painted.View(), parameters);
        QCOMPARE(loose.report.stopReason, StopReason::Seams);
        QCOMPARE(loose.report.attributes->heldFaces, loose.report.faces - 1);
        parameters.maxError = 0.2;
        const Simplification tight = Simplify(painted.View(), parameters);
        QCOMPARE(tight.report.stopReason, StopReason::ErrorBound);
        QCOMPARE(tight.report.attributes->heldFaces, std::size_t{0});
        QVERIFY(tight.report.faces > loose.report.faces);
    }

    /// And where faces may not cross, as coarse ones of two sheets do that lie close to each other. The run
    /// that is guarded tries other places for vertices and takes moves back; what corners show is no farther
    /// out of place than in theTextureStaysInItsPlace.
    void seamsHoldWhereFacesMayNotCross()
    {
        IndexedMesh sheet = test_meshes::Grid(40, 40, 1.0 / 40);
        for (Point& p : sheet.points) p[2] = 0.07 * std::sin(10 * p[0]) * std::cos(9 * p[1]);
        const auto linear = [](const Point& p, std::int32_t label) {
            return std::vector<double>{p[0] + 4 * label, p[1]};
        };
        Painted painted(
            test_meshes::Merged(sheet, test_meshes::Moved(sheet, 0, 1, {0, 0, 0.006})), kTexture,
            [](const Point& p) { return p[0] > 0.5 ? 1 : 0; }, linear);
        for (const Effort effort : {Effort::Fast, Effort::Balanced, Effort::Best}) {
            const Simplification result = Simplify(painted.View(), Target(200, effort));
            QCOMPARE(*result.report.selfIntersections, std::size_t{0});
            QVERIFY(result.report.selfIntersectionsBefore); // they were counted: an earlier run had some
            QCOMPARE(result.mesh.cornerValues.size(), 6 * result.mesh.triangles.size());
            QCOMPARE(TurnedFaces(result.mesh), 0);
            double squares = 0;
            for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto wanted = linear(result.mesh.positions[result.mesh.triangles[f][k]],
                                               painted.labels[result.mesh.faceOrigin[f]]);
                    const float* uv = result.mesh.cornerValues.data() + 2 * (3 * f + k);
                    const double u = static_cast<double>(uv[0]) - wanted[0];
                    const double v = static_cast<double>(uv[1]) - wanted[1];
                    squares += u * u + v * v;
                }
            const double edge = std::sqrt(2.3 * Area(result.mesh) / 200);
            const double rms = std::sqrt(squares / static_cast<double>(3 * result.mesh.triangles.size()));
            QVERIFY2(rms < 0.05 * edge, qPrintable(QString("%1 of an edge").arg(rms / edge)));
        }
    }

    /// A target below a face a chart is out of reach while charts are kept, and says so.
    void seamsHoldUpATarget()
    {
        Painted painted = Patchwork(16);
        auto parameters = Target(8, Effort::Fast);
        const Simplification kept = Simplify(painted.View(), parameters);
        QCOMPARE(kept.report.stopReason, StopReason::Seams);
        QVERIFY(!kept.report.targetReached && kept.report.faces >= 16);
        QCOMPARE(kept.report.attributes->charts, std::size_t{16});
        QCOMPARE(kept.report.attributes->heldFaces, kept.report.faces - 8);
        parameters.seams = Seams::Ignore;
        const Simplification ignored = Simplify(painted.View(), parameters);
        QCOMPARE(ignored.report.stopReason, StopReason::Target);
        QVERIFY(ignored.report.faces <= 8);
    }

    /// On a plane where everything is linear nothing differs: no texture is out of place, no value is wrong.
    /// The tolerance is single precision in the frame of the measurement.
    void theReportOfALinearMapIsZero()
    {
        Painted painted(test_meshes::Grid(20, 20, 0.05),
                        {ChannelKind::Texture, ChannelKind::Texture, ChannelKind::Scalar}, OneLabel,
                        [](const Point& p, std::int32_t) {
                            return std::vector<double>{p[0], p[1], 100 * p[0] + 50 * p[1]};
                        });
        auto parameters = Target(40);
        parameters.measureError = true;
        const auto report = Simplify(painted.View(), parameters).report;
        QVERIFY(report.attributes);
        QCOMPARE(report.attributes->charts, std::size_t{1});
        QCOMPARE(report.attributes->turnedFaces, std::size_t{0});
        QCOMPARE(report.attributes->heldFaces, std::size_t{0});
        QCOMPARE(report.attributes->rms.size(), std::size_t{3});
        QVERIFY(report.attributes->rms[0] < 1e-4 && report.attributes->rms[2] < 1e-2);
        QCOMPARE(report.attributes->textures.size(), std::size_t{1});
        QVERIFY(report.attributes->textures[0].largest < 0.01);
    }

    /// A texture that bends on a plane is out of place where it does not guide, and less where it does.
    void theReportSeesATextureOutOfPlace()
    {
        Painted painted(test_meshes::Grid(8, 8, 0.125), kTexture, OneLabel, [](const Point& p, std::int32_t) {
            return std::vector<double>{p[0], p[1]};
        });
        auto parameters = Target(20);
        parameters.measureError = true;
        parameters.attributeWeight = 0;
        std::vector<float>& values = painted.values;
        for (std::size_t i = 0; i < values.size(); i += 2)
            values[i] *= values[i]; // u = x^2: no line any more
        const auto blind = Simplify(painted.View(), parameters).report;
        parameters.attributeWeight = 1;
        const auto guided = Simplify(painted.View(), parameters).report;
        const TextureDeviation far = blind.attributes->textures[0], near = guided.attributes->textures[0];
        QVERIFY(far.rms > 0.01 && far.largest > far.rms);
        QVERIFY2(near.rms < 0.5 * far.rms, qPrintable(QString("%1 %2").arg(near.rms).arg(far.rms)));
    }

    void refusesWhatItCannotRead()
    {
        Painted painted = Patchwork(4);
        const auto refusal = [&](double weight) {
            auto parameters = Target(10);
            parameters.attributeWeight = weight;
            try {
                Simplify(painted.View(), parameters);
            } catch (const std::invalid_argument& error) {
                return std::string(error.what());
            }
            return std::string("accepted");
        };
        QVERIFY(refusal(101).find("attribute_weight = 101") == 0);
        painted.values[7] = std::numeric_limits<float>::quiet_NaN();
        QCOMPARE(refusal(1), std::string("the attributes of 1 of 32 faces are not finite"));
        painted.values[7] = 0;
        painted.attributes.kinds = {ChannelKind::Color, ChannelKind::Texture};
        QVERIFY(refusal(1).find("channel 1 is a texture coordinate without a second one") == 0);
    }

    /// Labels by themselves make seams: their border on a plane stays straight, whatever it costs.
    void labelsAloneMakeSeams()
    {
        Painted painted(
            test_meshes::Grid(20, 20, 0.05), {}, [](const Point& p) { return p[0] > 0.5 ? 1 : 0; },
            [](const Point&, std::int32_t) { return std::vector<double>{}; });
        auto parameters = Target(20);
        parameters.measureError = true;
        const Simplification result = Simplify(painted.View(), parameters);
        QVERIFY(result.mesh.triangles.size() <= 20);
        QCOMPARE(result.report.attributes->charts, std::size_t{2});
        QVERIFY(result.mesh.cornerValues.empty() && result.report.attributes->rms.empty());
        for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
            for (const std::uint32_t v : result.mesh.triangles[f]) {
                const double side = painted.labels[result.mesh.faceOrigin[f]] == 1 ? 1 : -1;
                QVERIFY(side * (result.mesh.positions[v][0] - 0.5) > -1e-4); // single precision in the frame
            }
    }

    /// A seam keeps its curve on a plane, where its shape is all that there is to lose: with forty faces the
    /// middle of every edge is within .002 of the curve, three times nearer than where the planes of seams
    /// are not kept up to date, and ten times nearer than without them.
    void seamsKeepTheirShape()
    {
        const auto curve = [](double y) { return 0.5 + 0.15 * std::sin(6.283185 * y); };
        Painted painted(
            test_meshes::Grid(40, 40, 1.0 / 40), {}, [](const Point& p) { return p[0] > 0.5 ? 1 : 0; },
            [](const Point&, std::int32_t) { return std::vector<double>{}; });
        for (Point& p : painted.mesh.points) {
            const double share = p[0] < 0.5 ? p[0] / 0.5 : (1 - p[0]) / 0.5;
            p[0] += share * (curve(p[1]) - 0.5);
        }
        for (const Effort effort : {Effort::Fast, Effort::Balanced}) {
            const DecimatedMesh mesh = Simplify(painted.View(), Target(40, effort)).mesh;
            QVERIFY(mesh.triangles.size() <= 40);
            for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Point& a = mesh.positions[mesh.triangles[f][k]];
                    const Point& b = mesh.positions[mesh.triangles[f][(k + 1) % 3]];
                    const double side = painted.labels[mesh.faceOrigin[f]] == 1 ? 1 : -1;
                    QVERIFY(side * ((a[0] + b[0]) / 2 - curve((a[1] + b[1]) / 2)) > -0.002);
                }
        }
    }

    /// Nothing is carried where there is nothing.
    void withoutAttributesThereAreNone()
    {
        const Simplification plain = Simplify(test_meshes::View(test_meshes::Icosphere(3)), Target(200));
        QVERIFY(plain.mesh.cornerValues.empty());
        QVERIFY(!plain.mesh.wedges);
    }
};

QTEST_APPLESS_MAIN(TestAttributes)
#include "test_attributes.moc"
