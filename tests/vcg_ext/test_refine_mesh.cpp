// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "analytic_meshes.h"
#include "test_meshes.h"
#include "vcg_ext/refine_mesh.h"

using namespace test_meshes;

class TestRefineMesh : public QObject
{
    Q_OBJECT

  private slots:
    void meshesOfAnyTypeAreRefined()
    {
        DoubleMesh original;
        Fill(original, Icosphere(3));
        FloatMesh simplified;
        Fill(simplified, WithIsolatedVertices(Noisy(Icosphere(2), 0.05), 2));
        vcg::tri::Allocator<FloatMesh>::DeleteFace(simplified,
                                                   simplified.face[7]); // a hole: its corners stay
        const std::size_t faces = static_cast<std::size_t>(simplified.fn);
        const vcg::Point3f corner = simplified.face[7].P(0), isolated = simplified.vert.back().P();
        std::vector<std::uint8_t> fixed(simplified.vert.size(), 0);
        fixed[100] = 1;
        const vcg::Point3f fixedPoint = simplified.vert[100].P();

        const auto error = [&] {
            double sum = 0;
            for (const auto& v : simplified.vert)
                if (&v < &simplified.vert[162]) sum += std::abs(static_cast<double>(v.cP().Norm()) - 1);
            return sum;
        };
        const double before = error();
        const vcg_ext::RefinementReport report = vcg_ext::RefineMesh(simplified, original, {}, fixed);
        QVERIFY(report.moves > 0 && report.rmsAfter < 0.8 * report.rmsBefore);
        QVERIFY(error() < 0.8 * before);
        QCOMPARE(static_cast<std::size_t>(simplified.fn), faces);
        QVERIFY(simplified.face[7].IsD());
        QVERIFY(simplified.face[7].P(0) == corner && simplified.vert.back().P() == isolated);
        QVERIFY(simplified.vert[100].P() == fixedPoint);
    }
};

QTEST_APPLESS_MAIN(TestRefineMesh)
#include "test_refine_mesh.moc"
