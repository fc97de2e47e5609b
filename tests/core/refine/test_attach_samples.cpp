// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "surface_pairs.h"
#include "vcg_ext/core/refine/attach_samples.h"
#include "vcg_ext/core/refine/refine.h"

using namespace test_meshes;
using vcg_ext::Vector3;

class TestAttachSamples : public QObject
{
    Q_OBJECT

  private slots:
    /// Where there are more than eight for each simplified face, centroids are left out and the others have
    /// their share; where there are fewer than four, midpoints of edges have a part of it.
    void samplesShareTheWholeArea()
    {
        for (const int levels : {1, 3}) {
            SurfacePair pair = MakePair(Icosphere(3), Icosphere(levels));
            double area = 0;
            for (std::uint32_t f = 0; f < pair.original.FaceCount(); ++f)
                area += 0.5 * static_cast<double>(Norm(AreaVector(pair.original, f)));
            const auto lists = vcg_ext::AttachSamples(pair.original, pair.simplified, pair.root, 1);
            double weight = 0;
            for (const auto& sample : lists.samples) weight += static_cast<double>(sample.weight);
            // every second centroid stands for two: the faces of the sphere differ by a few percent
            QVERIFY(std::abs(weight / area - 1) < 0.03);
            QCOMPARE(lists.samples.size() == 642 + 1280 + 1920, levels == 3);
        }
    }

    /// A centroid that stands for a hundred faces would be fitted like a hundred vertices.
    void noSampleStandsForMuchMoreThanAnother()
    {
        SurfacePair pair = MakePair(Icosphere(3), Icosphere(0));
        const auto lists = vcg_ext::AttachSamples(pair.original, pair.simplified, pair.root, 1);
        const auto [least, most] =
            std::minmax_element(lists.samples.begin(), lists.samples.end(),
                                [](const auto& a, const auto& b) { return a.weight < b.weight; });
        QVERIFY(most->weight < 3 * least->weight); // areas of the faces differ by a factor below 2
    }

    /// Two parallel squares; one sample is looked for on the wrong one first, where a walk finds no way out.
    void aSampleFromTheWrongSheetIsSearchedForEverywhere()
    {
        const auto squares = [](int cells) {
            IndexedMesh mesh = Grid(cells, cells, 1.0 / cells);
            const IndexedMesh lower = mesh;
            const std::size_t v = mesh.points.size();
            for (Point p : lower.points) {
                p[2] += 0.25;
                mesh.points.push_back(p);
            }
            for (const Triangle& t : lower.triangles) mesh.AddTriangle(v + t[0], v + t[1], v + t[2]);
            return mesh;
        };
        const IndexedMesh coarse = squares(4);
        SurfacePair pair = MakePair(squares(16), coarse);
        pair.root[20] = static_cast<std::uint32_t>(coarse.points.size() - 1);
        const auto lists = vcg_ext::AttachSamples(pair.original, pair.simplified, pair.root, 1);
        for (const auto& sample : lists.samples) QVERIFY(sample.distance2 < 1e-6F);
    }

    void everySampleKnowsItsFaceAndItsDistance()
    {
        for (const Family& family : Families()) {
            SurfacePair pair = MakePair(family.original, family.simplified);
            vcg_ext::SurfaceArrays& surface = pair.simplified;
            vcg_ext::MakeRoomForCorners(surface, vcg_ext::kFlipRoom);
            vcg_ext::RefinementState state = vcg_ext::BeginRefinement(pair.original, surface, pair.root, 1);
            state.meanSquare = static_cast<float>(MeanSquare(state.samples));
            FlipEdges(state, 1);
            MoveVertices(state, 1);
            std::vector<int> listed(state.samples.samples.size(), 0);
            for (std::uint32_t f = 0; f < surface.FaceCount(); ++f) {
                for (std::uint32_t i = state.samples.faces[f].first; i != vcg_ext::kNone;
                     i = state.samples.samples[i].next) {
                    const vcg_ext::Sample& sample = state.samples.samples[i];
                    QCOMPARE(sample.face, f);
                    ++listed[i];
                    const auto& t = surface.triangles[f];
                    const Vector3<float> a = PositionOf(surface, t.v[0]);
                    const auto closest =
                        vcg_ext::ClosestOnTriangle(PositionOf(sample) - a, PositionOf(surface, t.v[1]) - a,
                                                   PositionOf(surface, t.v[2]) - a);
                    QVERIFY(std::abs(std::sqrt(sample.distance2) - std::sqrt(closest.distance2)) < 0.05F);
                }
            }
            QVERIFY2(std::all_of(listed.begin(), listed.end(), [](int n) { return n == 1; }), family.name);
        }
    }
};

QTEST_APPLESS_MAIN(TestAttachSamples)
#include "test_attach_samples.moc"
