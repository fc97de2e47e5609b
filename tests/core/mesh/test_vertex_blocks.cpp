// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "analytic_meshes.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/vertex_blocks.h"

using namespace test_meshes;
using namespace vcg_ext;

namespace
{

SurfaceArrays Surface(const IndexedMesh& mesh)
{
    return BuildSurfaceArrays(View(mesh), FrameOf(View(mesh)));
}

} // namespace

class TestVertexBlocks : public QObject
{
    Q_OBJECT

  private slots:
    void blocksCoverTheVertices()
    {
        for (const bool shifted : {false, true})
            for (const std::size_t vertices : {0, 1, 5, 20, 23}) {
                const auto blocks = VertexBlocks(vertices, 10, shifted);
                std::uint32_t end = 0;
                for (const VertexRange& block : blocks) {
                    QCOMPARE(block.begin, end);
                    QVERIFY(block.end > block.begin && block.end - block.begin <= 10);
                    end = block.end;
                }
                QCOMPARE(std::size_t{end}, vertices);
                if (shifted && vertices > 5) QCOMPARE(blocks.front().end, 5U);
            }
    }

    void noTwoVerticesOfAColorShareAFace()
    {
        const SurfaceArrays surface = Surface(Torus(16, 8));
        std::vector<std::uint32_t> all(surface.VertexCount());
        for (std::uint32_t v = 0; v < all.size(); ++v) all[v] = v;
        std::vector<int> colored(all.size(), 0);
        for (const auto& sameColor : ColorClasses(surface, all)) {
            for (const std::uint32_t v : sameColor) {
                ++colored[v];
                for (const std::uint32_t w : sameColor)
                    for (const SurfaceTriangle& t : surface.triangles)
                        QVERIFY(v == w || !HasVertex(t, v) || !HasVertex(t, w));
            }
        }
        QVERIFY(std::all_of(colored.begin(), colored.end(), [](int n) { return n == 1; }));
    }

    void everyWantedVertexIsVisitedOnce()
    {
        const SurfaceArrays surface = Surface(Torus(32, 16));
        const auto wanted = [](std::uint32_t v) { return v % 3 != 0; };
        for (const bool withEdges : {false, true}) {
            const auto visits = [&](int threads) {
                std::vector<int> count(surface.VertexCount(), 0);
                const auto visit = [&](std::uint32_t v, int) { ++count[v]; };
                if (withEdges)
                    ForEachStarWithEdges(surface, 50, threads, wanted, visit);
                else
                    ForEachStar(surface, 50, threads, wanted, visit);
                return count;
            };
            for (const int threads : {1, 4}) {
                const std::vector<int> count = visits(threads);
                for (std::uint32_t v = 0; v < count.size(); ++v) QCOMPARE(count[v], wanted(v) ? 1 : 0);
            }
        }
    }

    /// Of the visits that may be at the same time, none writes to a face that another reads.
    void aBlockVisitsOnlyStarsThatLieInIt()
    {
        const SurfaceArrays surface = Surface(Torus(32, 16));
        const auto blocks = VertexBlocks(surface.VertexCount(), 50, false);
        const auto all = [](std::uint32_t) { return true; };
        std::vector<std::uint32_t> visited;
        const auto rest =
            VisitInBlocks(surface, blocks, 1, all, [&](std::uint32_t v, int) { visited.push_back(v); });
        QCOMPARE(visited.size() + rest.size(), surface.VertexCount());
        QVERIFY(!rest.empty() && std::is_sorted(rest.begin(), rest.end()));
        for (const std::uint32_t v : visited)
            for (const SurfaceTriangle& t : surface.triangles)
                if (HasVertex(t, v))
                    for (const std::uint32_t w : t.v) QCOMPARE(w / 50, v / 50);
    }
};

QTEST_APPLESS_MAIN(TestVertexBlocks)
#include "test_vertex_blocks.moc"
