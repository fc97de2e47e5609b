// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/base/morton.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/geometry/frame.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/face_tree_nodes.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// The faces of a mesh in a tree of boxes, for questions about the closest of them and which way it faces.
///
/// Faces are put in an order in which neighbours in space follow each other; four of them are a leaf, four
/// leaves a node, and so on: nothing is searched while the tree is built. A node knows the box of its points
/// and the box of its unit normals. Most leaves are never looked into, so they hold nothing of their own:
/// their corners are gathered when one is. Queries may run on several threads.
class FaceTree
{
    static constexpr std::size_t kGrain = 4096;
    static constexpr float kFar = std::numeric_limits<float>::max();
    /// Squared distances that differ by less than this factor are equal: to an edge that two faces share, and
    /// then either of them may be meant; or to faces that coincide, and then none faces away.
    static constexpr float kTie = 1.00002F;
    /// A face faces away from a direction where their cosine is below this: above, it may be rounding.
    static constexpr float kAway = -1e-6F;

    static constexpr std::size_t kFacesPerLeaf = LeafFaces::kMost;
    using FourIndices = std::array<std::uint32_t, kLanes>; ///< of faces

    const std::uint32_t* triangles_;
    Frame frame_;
    Buffer<SurfacePoint> points_;
    Buffer<std::uint32_t> faces_; ///< of leaf 0, leaf 1, ...
    std::vector<Buffer<FourNodes>>
        levels_; ///< levels_[k][i] holds the nodes 4 i .. 4 i + 3 of the level below

  public:
    /// Squared distances below it are rounding, and say nothing about sides: two millionths of the diagonal.
    static constexpr float kOnSurface2 = 4e-6F;

    /// \param frame in which all queries are \param order the faces in a good order, if one is known
    /// \pre at least one face; finite coordinates; the view's triangles outlive this object and do not change
    FaceTree(const MeshView& view, const Frame& frame, int threads,
             const std::vector<std::uint32_t>& order = {})
        : triangles_(view.triangles), frame_(frame), points_(view.vertexCount),
          faces_(order.empty() ? view.faceCount : order.size())
    {
        ParallelRanges(threads, view.vertexCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                const Vector3<float> p = frame.Into(view.Position(v));
                points_[v] = {p.x, p.y, p.z, 0};
            }
        });
        if (order.empty())
            SortFaces(threads);
        else
            std::copy(order.begin(), order.end(), faces_.begin());
        levels_.push_back(LevelAbove(LeafCount(), threads, [&](std::size_t leaf) {
            LeafBoxes boxes;
            ForEachFour(leaf, [&](const FourTriangles& faces, const auto&) { boxes.Add(faces); });
            return boxes.Boxes();
        }));
        while (levels_.back().size() > 1) {
            const Buffer<FourNodes>& below = levels_.back();
            auto above =
                LevelAbove(below.size(), threads, [&](std::size_t node) { return BoxesOf(below[node]); });
            levels_.push_back(std::move(above));
        }
    }

    /// In which points and directions of the queries are.
    const Frame& frame() const { return frame_; }

    /// Does the face closest to \p point, or one that shares the closest edge, face away from \p direction, a
    /// unit vector? \param along2 squared distance to some face that does not, if one is known: that saves
    /// most of the time
    bool FacesAwayFrom(const Vector3<float>& point, const Vector3<float>& direction,
                       float along2 = kFar) const
    {
        // Most often all faces around face along it. That is seen without finding the closest one: none that
        // faces away from it may be closer than some face that does not.
        Sides sides{along2, kFar};
        if (along2 < kFar) {
            const auto someFaceAway = [&](const FourNodes& nodes) {
                return nodes.normals.LeastDots(direction) < Splat(kAway);
            };
            const auto near2 = [&] { return std::min(kFar, sides.along2 * kTie); };
            Search(point, someFaceAway, near2(), [&](const FourTriangles& faces, const FourIndices&) {
                Closer(faces, point, direction, sides);
                return near2();
            });
            if (!IsAway(sides)) return false;
        }
        const auto nearest2 = [&] { return std::min(kFar, std::min(sides.along2, sides.away2) * kTie); };
        Search(point, AllNodes, nearest2(), [&](const FourTriangles& faces, const FourIndices&) {
            Closer(faces, point, direction, sides);
            return nearest2();
        });
        return IsAway(sides);
    }

    /// May some face that is not farther than the root of \p limit2 face away from \p direction, a unit
    /// vector? False only where none does.
    bool MayFaceAway(const Vector3<float>& point, const Vector3<float>& direction, float limit2) const
    {
        constexpr float kSafe = 2e-3F; // rounding of normals of faces that are not thin, and of the direction
        bool found = false;
        const auto someFaceAway = [&](const FourNodes& nodes) {
            return nodes.normals.LeastDots(direction) < Splat(kSafe);
        };
        Search(point, someFaceAway, limit2, [&](const FourTriangles& faces, const FourIndices&) {
            const PreparedTriangle<Float4> t = faces.Prepared();
            const Int4 away = (Dot(Splat(direction), {t.nx, t.ny, t.nz}) < Splat(kSafe)) | AreThin(t);
            const Int4 near = ClosestOnTriangle(faces.Seen(point), t).distance2 <= Splat(limit2);
            found |= AnyLane(away & near);
            return found ? -1.0F : limit2;
        });
        return found;
    }

    /// Squared distance to the nearest face that does not face away from \p direction; the largest float
    /// where all do.
    float DistanceAlong2(const Vector3<float>& point, const Vector3<float>& direction) const
    {
        Sides sides;
        const auto someFaceAlong = [&](const FourNodes& nodes) {
            return nodes.normals.GreatestDots(direction) >= Splat(kAway);
        };
        Search(point, someFaceAlong, kFar, [&](const FourTriangles& faces, const FourIndices&) {
            Closer(faces, point, direction, sides);
            return sides.along2;
        });
        return sides.along2;
    }

    /// The point of the surface that is closest to \p point.
    Vector3<float> Closest(const Vector3<float>& point) const
    {
        float best2 = kFar;
        Vector3<float> closest{};
        Search(point, AllNodes, kFar, [&](const FourTriangles& faces, const FourIndices&) {
            const FourClosestPoints hits = ClosestOnTriangle(faces.Seen(point), faces.Prepared());
            for (int lane = 0; lane < kLanes; ++lane) {
                if (!(hits.distance2[lane] < best2)) continue;
                best2 = hits.distance2[lane];
                closest = point - Lane(hits.difference, lane);
            }
            return best2;
        });
        return closest;
    }

    /// A face that may be the closest one.
    struct Candidate {
        float distance2;
        std::uint32_t face;
    };

    /// The faces that are at most \p slack farther from \p point than the closest one, among them that one;
    /// of many that are equally far the first kMaxCandidates.
    /// \param limit2 squared distance to some face of the surface, slack included, if one is known: that
    /// saves most of the time \param found is overwritten
    /// \return the squared distance to the closest face, as single precision sees it
    float FindClosest(const Vector3<float>& point, float slack, float limit2,
                      std::vector<Candidate>& found) const
    {
        found.clear();
        float nearest2 = kFar;
        Search(point, AllNodes, limit2, [&](const FourTriangles& faces, const FourIndices& indices) {
            const Float4 distance2 = ClosestOnTriangle(faces.Seen(point), faces.Prepared()).distance2;
            const float here2 = MinLane(distance2);
            if (here2 < nearest2) {
                nearest2 = here2;
                const float reach = std::sqrt(here2) + slack;
                limit2 = std::min(limit2, reach * reach);
                if (found.size() == kMaxCandidates) DropFar(found, limit2);
            }
            for (std::size_t lane = 0; lane < kLanes && found.size() < kMaxCandidates; ++lane)
                if (distance2[lane] <= limit2) found.push_back({distance2[lane], indices[lane]});
            if (found.size() < kMaxCandidates) return limit2;
            DropFar(found, limit2);
            // Too many are equally far, as around a vertex of high valence: only a nearer one counts any
            // more.
            constexpr float kNearer = 1 - 1e-6F, kNothing = 1e-12F;
            return found.size() < kMaxCandidates ? limit2 : nearest2 > kNothing ? kNearer * nearest2 : -1;
        });
        DropFar(found, limit2);
        return nearest2;
    }

    /// A face that is not farther from \p point than the root of \p limit2, the first that is found; nothing
    /// where there is none.
    std::optional<Candidate> FaceWithin(const Vector3<float>& point, float limit2) const
    {
        std::optional<Candidate> found;
        Search(point, AllNodes, limit2, [&](const FourTriangles& faces, const FourIndices& indices) {
            if (found) return -1.0F;
            const Vector3<Float4> p = faces.Seen(point);
            // In a fine mesh a corner is close enough, and found sooner.
            Float4 distance2 = Min(SquaredNorm(p), Min(SquaredNorm(p - faces.b), SquaredNorm(p - faces.c)));
            if (!AnyLane(distance2 <= Splat(limit2)))
                distance2 = ClosestOnTriangle(p, faces.Prepared()).distance2;
            const float near2 = MinLane(distance2);
            if (!(near2 <= limit2)) return limit2;
            std::size_t lane = 0;
            while (distance2[lane] != near2) ++lane;
            found = Candidate{std::min(near2, Distance2ToFace(indices[lane], point)), indices[lane]};
            return -1.0F;
        });
        return found;
    }

    /// The closest of the faces that are wanted(face), the first of those that are equally close; kFar where
    /// none is within the root of \p limit2.
    template <class Wanted>
    Candidate ClosestWanted(const Vector3<float>& point, float limit2, const Wanted& wanted) const
    {
        if (limit2 < kFar) return WantedWithin(point, limit2, wanted);
        // Everything in reach is looked at until a wanted face is found, so the reach grows step by step.
        constexpr float kWider2 = 16, kSizes2 = 4;
        const Candidate any = WantedWithin(point, kFar, [](std::uint32_t) { return true; });
        if (wanted(any.face)) return any;
        float reach2 = std::max(kWider2 * any.distance2, kSizes2 * Size2(any.face));
        while (reach2 > 0 && reach2 < kFar) {
            const Candidate best = WantedWithin(point, reach2, wanted);
            if (best.distance2 < kFar) return best;
            reach2 *= kWider2;
        }
        return WantedWithin(point, kFar, wanted);
    }

    /// Squared distance to one face.
    float Distance2ToFace(std::uint32_t face, const Vector3<float>& point) const
    {
        const auto corner = [&](std::size_t k) {
            const SurfacePoint& p = points_[triangles_[3 * std::size_t{face} + k]];
            return Vector3<float>{p.x, p.y, p.z};
        };
        const Vector3<float> a = corner(0);
        return ClosestOnTriangle(point - a, corner(1) - a, corner(2) - a).distance2;
    }

    /// Calls visit(face) for every face in a box whose squared distance from \p point is at most what the
    /// last call returned, some of them twice. Asks nothing of the faces themselves, so that needles cannot
    /// mislead it. \param limit2 for the first call
    template <class Visit>
    void ForEachInReach(const Vector3<float>& point, float limit2, const Visit& visit) const
    {
        Search(point, AllNodes, limit2, [&](const FourTriangles&, const FourIndices& indices) {
            for (const std::uint32_t face : indices) limit2 = visit(face);
            return limit2;
        });
    }

    /// The faces, those that are close in space close to each other.
    const Buffer<std::uint32_t>& Order() const { return faces_; }

    /// Twice the area of every face, in single precision, in this order.
    Buffer<float> DoubleAreas(int threads) const
    {
        constexpr std::size_t kLeafGrain = kGrain / kFacesPerLeaf;
        Buffer<float> areas(LeafCount() * kFacesPerLeaf);
        ParallelRanges(threads, LeafCount(), kLeafGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t leaf = begin; leaf < end; ++leaf) {
                float* here = areas.begin() + leaf * kFacesPerLeaf;
                ForEachFour(leaf, [&](const FourTriangles& faces, const FourIndices&) {
                    StoreUnaligned(here, Norm(Cross(faces.b, faces.c)));
                    here += kLanes;
                });
            }
        });
        return areas;
    }

    /// Calls visit(faces) for four faces at a time, near ones first, of every leaf whose box is not farther
    /// from \p point than the root of what the last call returned. \param limit2 for the first call
    template <class Visit>
    void ForEachFourNear(const Vector3<float>& point, float limit2, const Visit& visit) const
    {
        Search(point, AllNodes, limit2,
               [&](const FourTriangles& faces, const FourIndices&) { return visit(faces); });
    }

    /// Squared distance to the surface.
    float Distance2(const Vector3<float>& point) const
    {
        float best2 = kFar;
        Search(point, AllNodes, kFar, [&](const FourTriangles& faces, const FourIndices&) {
            best2 =
                std::min(best2, MinLane(ClosestOnTriangle(faces.Seen(point), faces.Prepared()).distance2));
            return best2;
        });
        return best2;
    }

    /// Calls visit(face, a, ab, ac) for the faces near \p box, all that touch it among them; a is the first
    /// corner, ab and ac lead to the others. In an order that depends on the mesh only.
    template <class Visit>
    void ForEachNear(const Box3<float>& box, const Visit& visit) const
    {
        ForEachNear(levels_.size(), 0, box, visit);
    }

    /// Faces that are close to each other in space share a leaf.
    std::size_t LeafCount() const { return (faces_.size() + kFacesPerLeaf - 1) / kFacesPerLeaf; }

    /// The faces of a leaf with their boxes.
    LeafFaces FacesOfLeaf(std::size_t leaf) const
    {
        LeafFaces all;
        ForEachFour(leaf, [&](const FourTriangles& faces, const FourIndices& indices) {
            const std::size_t left = faces_.size() - leaf * kFacesPerLeaf - all.count;
            all.boxes[all.fours] = {BoxesOf(faces)};
            std::copy(indices.begin(), indices.end(), all.faces.begin() + kLanes * all.fours++);
            all.count += std::min<std::size_t>(left, kLanes);
        });
        return all;
    }

    /// Calls visit(leaf) for every leaf from \p first on of which the box meets \p box, in ascending order.
    template <class Visit>
    void ForEachLeafNear(const Box3<float>& box, std::size_t first, const Visit& visit) const
    {
        ForEachLeafNear(levels_.size(), 0, box, first, visit);
    }

  private:
    static constexpr std::size_t kMaxCandidates = 64;

    template <class Wanted>
    Candidate WantedWithin(const Vector3<float>& point, float limit2, const Wanted& wanted) const
    {
        Candidate best{kFar, 0};
        Search(point, AllNodes, limit2, [&](const FourTriangles& faces, const FourIndices& indices) {
            const Float4 distance2 = ClosestOnTriangle(faces.Seen(point), faces.Prepared()).distance2;
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const Candidate here{distance2[lane], indices[lane]};
                const bool closer = here.distance2 < best.distance2 ||
                                    (here.distance2 == best.distance2 && here.face < best.face);
                if (here.distance2 <= limit2 && closer && wanted(here.face)) best = here;
            }
            return limit2 = std::min(limit2, best.distance2);
        });
        return best;
    }

    /// Squared length of the longest of two sides of a face.
    float Size2(std::uint32_t face) const
    {
        const auto corner = [&](std::size_t k) {
            const SurfacePoint& p = points_[triangles_[3 * std::size_t{face} + k]];
            return Vector3<float>{p.x, p.y, p.z};
        };
        return std::max(SquaredNorm(corner(1) - corner(0)), SquaredNorm(corner(2) - corner(0)));
    }

    static void DropFar(std::vector<Candidate>& found, float limit2)
    {
        const auto isFar = [&](const Candidate& c) { return !(c.distance2 <= limit2); };
        found.erase(std::remove_if(found.begin(), found.end(), isFar), found.end());
    }

    /// In Morton order of their first corners.
    void SortFaces(int threads)
    {
        constexpr double kHalf = kFrameDiagonal / 2;
        constexpr int kBitsPerAxis = 7; // two passes of sorting; what shares a cell stays in the mesh's order
        using Grid = MortonGrid<kBitsPerAxis>;
        const Grid grid({-kHalf, -kHalf, -kHalf}, {kHalf, kHalf, kHalf});
        Buffer<OrderedVertex> order(faces_.size());
        ParallelRanges(threads, faces_.size(), kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f) {
                const SurfacePoint& p = points_[triangles_[3 * f]];
                order[f] = {
                    grid.Code({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)}),
                    static_cast<std::uint32_t>(f)};
            }
        });
        SortByCode<Grid::kCodeBits>(order, threads);
        for (std::size_t i = 0; i < faces_.size(); ++i) faces_[i] = order[i].origin;
    }

    Float4 Corner(std::size_t face, std::size_t k) const
    {
        return LoadUnaligned(&points_[triangles_[3 * face + k]].x);
    }
    /// The faces of a leaf, the last one repeated to fill four.
    template <class Visit>
    void ForEachFour(std::size_t leaf, const Visit& visit) const
    {
        const std::size_t end = std::min(faces_.size(), (leaf + 1) * kFacesPerLeaf);
        for (std::size_t first = leaf * kFacesPerLeaf; first < end; first += kLanes) {
            Float4 a[kLanes], b[kLanes], c[kLanes];
            FourIndices indices;
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::uint32_t face = indices[lane] = faces_[std::min(first + lane, end - 1)];
                a[lane] = Corner(face, 0);
                b[lane] = Corner(face, 1) - a[lane];
                c[lane] = Corner(face, 2) - a[lane];
            }
            Transpose(a[0], a[1], a[2], a[3]);
            Transpose(b[0], b[1], b[2], b[3]);
            Transpose(c[0], c[1], c[2], c[3]);
            visit(FourTriangles{{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}}, indices);
        }
    }

    /// Squared distances to the nearest faces found that do not face away from a direction, and that do.
    struct Sides {
        float along2 = kFar, away2 = kFar;
    };
    static bool IsAway(const Sides& sides)
    {
        return sides.along2 > kOnSurface2 && sides.away2 <= sides.along2 * kTie;
    }
    static void Closer(const FourTriangles& faces, const Vector3<float>& point,
                       const Vector3<float>& direction, Sides& sides)
    {
        const PreparedTriangle<Float4> t = faces.Prepared();
        const FourClosestPoints closest = ClosestOnTriangle(faces.Seen(point), t);
        const Float4 distance2 = closest.distance2;
        const Float4 cosine = Dot(Splat(direction), {t.nx, t.ny, t.nz});
        const Int4 away = cosine < Splat(kAway);
        sides.along2 = std::min(sides.along2, MinLane(Select(away, Splat(kFar), distance2)));
        // inside a face there is no edge to share: it has to be closer
        const Float4 shared = Select(closest.inside, distance2 * (kTie * kTie), distance2);
        sides.away2 = std::min(sides.away2, MinLane(Select(away, shared, Splat(kFar))));
    }

    static Int4 AllNodes(const FourNodes&) { return Splat(-1); }

    /// Calls visit(faces), near ones first, for the faces of every leaf whose box is not farther than \p
    /// limit2, which the last call returned, as long as wanted(nodes) has its ancestors.
    template <class Wanted, class Visit>
    void Search(const Vector3<float>& point, const Wanted& wanted, float limit2, const Visit& visit) const
    {
        struct Entry {
            float distance2;
            std::uint32_t node;
            std::uint32_t level; ///< levels_[level - 1][node] has its children; 0: a leaf
        };
        constexpr std::size_t kDeepest = 16; // 4^16 leaves
        std::array<Entry, 3 * kDeepest + 1> stack;
        stack[0] = {0, 0, static_cast<std::uint32_t>(levels_.size())};
        for (std::size_t size = 1; size > 0;) {
            const Entry entry = stack[--size];
            if (!(entry.distance2 <= limit2)) continue;
            if (entry.level == 0) {
                ForEachFour(entry.node, [&](const FourTriangles& faces, const FourIndices& indices) {
                    limit2 = visit(faces, indices);
                });
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
    void ForEachLeafNear(std::size_t level, std::size_t node, const Box3<float>& box, std::size_t first,
                         const Visit& visit) const
    {
        if (level == 0) return visit(node);
        const int met = LaneBits(levels_[level - 1][node].points.Meet(box));
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::size_t child = kLanes * node + lane;
            const bool hasLater = (child + 1) << (2 * (level - 1)) > first; // four children a node
            if ((met >> lane & 1) != 0 && hasLater) ForEachLeafNear(level - 1, child, box, first, visit);
        }
    }

    /// \param level as Search's
    template <class Visit>
    void ForEachNear(std::size_t level, std::size_t node, const Box3<float>& box, const Visit& visit) const
    {
        if (level > 0) {
            for (int lane = 0; lane < kLanes; ++lane)
                if (box.Meets(levels_[level - 1][node].points.At(lane)))
                    ForEachNear(level - 1, kLanes * node + static_cast<std::size_t>(lane), box, visit);
            return;
        }
        const std::size_t end = std::min(faces_.size(), (node + 1) * kFacesPerLeaf);
        for (std::size_t place = node * kFacesPerLeaf; place < end; ++place) {
            const std::uint32_t face = faces_[place];
            const Float4 a = Corner(face, 0), b = Corner(face, 1) - a, c = Corner(face, 2) - a;
            const auto vector = [](Float4 p) { return Vector3<float>{p[0], p[1], p[2]}; };
            visit(face, vector(a), vector(b), vector(c));
        }
    }
};

} // namespace vcg_ext
