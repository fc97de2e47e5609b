// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "buffer.h"
#include "decimation_types.h"
#include "face_tree_nodes.h"
#include "parallel.h"
#include "point_triangle.h"
#include "simd.h"
#include "surface_builder.h"
#include "sweep_order.h"

namespace vcg_ext
{

/// The faces of a mesh in a tree of boxes, for questions about the closest of them and where it looks.
///
/// Faces are put in Morton order of their first corners; four neighbours there are a leaf, four leaves a
/// node, and so on: nothing is searched while the tree is built. A node knows the box of its points and the
/// box of its unit normals. Queries may run on several threads.
class FaceTree
{
    using FourTriangles = face_tree::FourTriangles;
    using FourNodes = face_tree::FourNodes;
    using Box = face_tree::Box;

    static constexpr std::size_t kGrain = 4096;
    static constexpr float kFar = face_tree::kFar;
    /// Squared distances that differ by less than this factor are equal: to an edge that two faces share, and
    /// then either of them may be meant; or to faces that coincide, and then none is against.
    static constexpr float kTie = 1.00002F;
    /// Squared distances below it are rounding, and say nothing about sides: two millionths of the diagonal.
    static constexpr float kOnSurface2 = 4e-6F;
    /// A face looks against a direction where their cosine is below this: above, it may be rounding.
    static constexpr float kAgainst = -1e-6F;

    Buffer<FourTriangles> leaves_;
    Buffer<std::uint32_t> faces_; ///< those of the leaves
    std::vector<Buffer<FourNodes>>
        levels_; ///< levels_[k][i] holds the nodes 4 i .. 4 i + 3 of the level below

  public:
    /// \param frame in which all queries are \pre at least one face; finite coordinates
    FaceTree(const MeshView& view, const SurfaceFrame& frame, int threads)
    {
        Buffer<SurfacePoint> points(view.vertexCount);
        ParallelRanges(threads, view.vertexCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) points[v] = frame.ToFrame(view.Position(v), 0);
        });
        SortFaces(view, points, threads);
        MakeLeaves(view, points, threads);
        levels_.push_back(face_tree::LevelAbove(leaves_, threads));
        while (levels_.back().size() > 1) levels_.push_back(face_tree::LevelAbove(levels_.back(), threads));
    }

    /// Does the face closest to \p point, or one that shares the closest edge, look against \p direction, a
    /// unit vector? \param along2 squared distance to some face that does not, if one is known: that saves
    /// most of the time
    bool LooksAgainst(const Vector3& point, const Vector3& direction, float along2 = kFar) const
    {
        // Most often all faces around look along it. That is seen without finding the closest one: none that
        // looks against it may be closer than some face that does not.
        Sides sides{along2, kFar};
        if (along2 < kFar) {
            const auto someLookAgainst = [&](const FourNodes& nodes) {
                return nodes.normals.LeastDots(direction) < Splat(kAgainst);
            };
            const auto near2 = [&] { return std::min(kFar, sides.along2 * kTie); };
            Search(point, someLookAgainst, near2(), [&](const FourTriangles& leaf) {
                Closer(leaf, point, direction, sides);
                return near2();
            });
            if (!IsAgainst(sides)) return false;
        }
        const auto nearest2 = [&] { return std::min(kFar, std::min(sides.along2, sides.against2) * kTie); };
        Search(point, AllNodes, nearest2(), [&](const FourTriangles& leaf) {
            Closer(leaf, point, direction, sides);
            return nearest2();
        });
        return IsAgainst(sides);
    }

    /// Squared distance to the nearest face that does not look against \p direction; the largest float where
    /// all do.
    float DistanceAlong2(const Vector3& point, const Vector3& direction) const
    {
        Sides sides;
        const auto someLookAlong = [&](const FourNodes& nodes) {
            return nodes.normals.GreatestDots(direction) >= Splat(kAgainst);
        };
        Search(point, someLookAlong, kFar, [&](const FourTriangles& leaf) {
            Closer(leaf, point, direction, sides);
            return sides.along2;
        });
        return sides.along2;
    }

    /// The point of the surface that is closest to \p point.
    Vector3 Closest(const Vector3& point) const
    {
        float best2 = kFar;
        Vector3 closest;
        Search(point, AllNodes, kFar, [&](const FourTriangles& leaf) {
            const FourClosestPoints hits = ClosestOnTriangle(leaf.Seen(point), leaf.Prepared());
            for (int lane = 0; lane < kLanes; ++lane) {
                if (!(hits.distance2[lane] < best2)) continue;
                best2 = hits.distance2[lane];
                const FourPoints& away = hits.difference;
                closest = point - Vector3{away.x[lane], away.y[lane], away.z[lane]};
            }
            return best2;
        });
        return closest;
    }

    /// Squared distance to the surface.
    float Distance2(const Vector3& point) const
    {
        float best2 = kFar;
        Search(point, AllNodes, kFar, [&](const FourTriangles& leaf) {
            best2 = std::min(best2, MinLane(ClosestOnTriangle(leaf.Seen(point), leaf.Prepared()).distance2));
            return best2;
        });
        return best2;
    }

    /// Calls visit(face, a, ab, ac) for the faces near the box from \p low to \p high, all that touch it
    /// among them; a is the first corner, ab and ac lead to the others. In an order that depends on the mesh
    /// only.
    template <class Visit>
    void ForEachNear(const Vector3& low, const Vector3& high, const Visit& visit) const
    {
        ForEachNear(levels_.size(), 0, {{low.x, low.y, low.z}, {high.x, high.y, high.z}}, visit);
    }

  private:
    void SortFaces(const MeshView& view, const Buffer<SurfacePoint>& points, int threads)
    {
        constexpr double kHalf = kFrameDiagonal / 2;
        using Grid = sweeps::MortonGrid<10>;
        const Grid grid({-kHalf, -kHalf, -kHalf}, {kHalf, kHalf, kHalf});
        Buffer<sweeps::OrderedVertex> order(view.faceCount);
        ParallelRanges(threads, view.faceCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f) {
                const SurfacePoint& p = points[view.triangles[3 * f]];
                order[f] = {
                    grid.Code({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)}),
                    static_cast<std::uint32_t>(f)};
            }
        });
        sweeps::SortByCode<Grid::kCodeBits>(order, threads);
        faces_.Allocate(view.faceCount);
        for (std::size_t i = 0; i < faces_.size(); ++i) faces_[i] = order[i].origin;
    }
    void MakeLeaves(const MeshView& view, const Buffer<SurfacePoint>& points, int threads)
    {
        const std::size_t last = faces_.size() - 1;
        leaves_.Allocate(last / kLanes + 1);
        ParallelRanges(threads, leaves_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t lane = 0; lane < kLanes; ++lane) {
                    const std::size_t face = faces_[std::min(kLanes * i + lane, last)];
                    const auto corner = [&](std::size_t k) {
                        const SurfacePoint& p = points[view.triangles[3 * face + k]];
                        return Vector3{p.x, p.y, p.z};
                    };
                    const Vector3 a = corner(0);
                    leaves_[i].a.Put(lane, a);
                    leaves_[i].b.Put(lane, corner(1) - a);
                    leaves_[i].c.Put(lane, corner(2) - a);
                }
        });
    }

    /// Squared distances to the nearest faces found that look along a direction and against it.
    struct Sides {
        float along2 = kFar, against2 = kFar;
    };
    static bool IsAgainst(const Sides& sides)
    {
        return sides.along2 > kOnSurface2 && sides.against2 <= sides.along2 * kTie;
    }
    static void Closer(const FourTriangles& leaf, const Vector3& point, const Vector3& direction,
                       Sides& sides)
    {
        const PreparedTriangle<Float4> t = leaf.Prepared();
        const FourClosestPoints closest = ClosestOnTriangle(leaf.Seen(point), t);
        const Float4 distance2 = closest.distance2;
        const Float4 cosine = direction.x * t.nx + direction.y * t.ny + direction.z * t.nz;
        const Int4 against = cosine < Splat(kAgainst);
        sides.along2 = std::min(sides.along2, MinLane(Select(against, Splat(kFar), distance2)));
        // inside a face there is no edge to share: it has to be closer
        const Float4 shared = Select(closest.inside, distance2 * (kTie * kTie), distance2);
        sides.against2 = std::min(sides.against2, MinLane(Select(against, shared, Splat(kFar))));
    }

    static Int4 AllNodes(const FourNodes&) { return Splat(-1); }

    /// Calls visit(leaf), near ones first, for every leaf whose box is not farther than \p limit2, which the
    /// last call returned, as long as wanted(nodes) has its ancestors.
    template <class Wanted, class Visit>
    void Search(const Vector3& point, const Wanted& wanted, float limit2, const Visit& visit) const
    {
        struct Entry {
            float distance2;
            std::uint32_t node;
            std::size_t level; ///< levels_[level - 1][node] has its children; 0: a leaf
        };
        constexpr std::size_t kDeepest = 16; // 4^16 leaves
        std::array<Entry, 3 * kDeepest + 1> stack;
        stack[0] = {0, 0, levels_.size()};
        for (std::size_t size = 1; size > 0;) {
            const Entry entry = stack[--size];
            if (!(entry.distance2 <= limit2)) continue;
            if (entry.level == 0) {
                limit2 = visit(leaves_[entry.node]);
                continue;
            }
            const FourNodes& nodes = levels_[entry.level - 1][entry.node];
            const Float4 distance2 = nodes.points.Distances2(point);
            const int visited = LaneBits((distance2 <= Splat(limit2)) & wanted(nodes));
            const std::size_t first = size;
            for (int lane = 0; lane < kLanes; ++lane) {
                if (!(visited >> lane & 1)) continue;
                std::size_t at = size++;
                for (; at > first && stack[at - 1].distance2 < distance2[lane]; --at)
                    stack[at] = stack[at - 1];
                stack[at] = {distance2[lane], kLanes * entry.node + static_cast<std::uint32_t>(lane),
                             entry.level - 1};
            }
        }
    }

    /// \param level as Search's
    template <class Visit>
    void ForEachNear(std::size_t level, std::size_t node, const Box& box, const Visit& visit) const
    {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::size_t child = kLanes * node + lane;
            if (level > 0) {
                if (Overlap(box, levels_[level - 1][node].points.At(lane)))
                    ForEachNear(level - 1, child, box, visit);
            } else if (child < faces_.size()) {
                const FourTriangles& leaf = leaves_[node];
                visit(faces_[child], leaf.a.At(lane), leaf.b.At(lane), leaf.c.At(lane));
            }
        }
    }
};

} // namespace vcg_ext
