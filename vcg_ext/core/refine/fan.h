// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/geometry/symmetric_matrix.h"
#include "vcg_ext/core/mesh/face_tree.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// A face of a fan: between its center and an edge of the rim.
struct FanFace {
    std::uint32_t face;                ///< of the simplified surface, where it is one of them already
    std::uint32_t next, previous;      ///< the edge of the rim
    Vector3<float> toNext, toPrevious; ///< its ends, seen from the fan's origin
    Vector3<float> normal;             ///< unit, of the face that it takes the place of
    PreparedTriangle<float> triangle;  ///< seen from the center that was measured last
};

/// The faces that would stand around one vertex, wherever that is put, and the samples that they would hold:
/// what a collapse, a new vertex on an edge or a large move leaves behind. Every sample is measured against
/// every face. One object per thread; it is filled anew for each trial.
class Fan
{
    RefinementState& state_;
    PlaceSearch search_;
    Vector3<float> origin_{};
    Scratch<FanFace> faces_;
    Scratch<std::uint32_t> held_; ///< the faces whose samples were collected
    SampleGroups groups_;
    SampleSummary summary_;
    float present2_ = 0; ///< largest squared distance of the samples as they are
    float forward2_ = 0; ///< and as MeasureForward found it last
    BackwardPoints points_;
    Scratch<SurfacePlace> hints_; ///< of the centroids, of the edges to the next vertices, of the center

  public:
    explicit Fan(RefinementState& state) : state_(state), search_(state.original) {}

    void Begin(const Vector3<float>& origin)
    {
        origin_ = origin;
        faces_.Clear();
        held_.Clear();
        groups_.Clear();
        hints_.Clear();
        summary_ = {};
        present2_ = 0;
    }
    /// \param normal of the face whose place it takes
    void AddFace(std::uint32_t face, std::uint32_t next, std::uint32_t previous, const Vector3<float>& normal)
    {
        FanFace& added = faces_.Append();
        added.face = face;
        added.next = next;
        added.previous = previous;
        added.toNext = PositionOf(state_.simplified, next) - origin_;
        added.toPrevious = PositionOf(state_.simplified, previous) - origin_;
        added.normal = normal;
    }
    /// The samples of a face that goes or changes.
    void HoldSamples(std::uint32_t face)
    {
        held_.Append() = face;
        const std::size_t first = groups_.size();
        CollectSamples(state_.samples, face, 0, origin_, groups_);
        summary_.Add(state_.samples.faces[face]);
        for (std::size_t i = first; i < groups_.size(); ++i)
            present2_ = std::max(present2_, MaxLane(groups_[i].distance2));
    }

    /// A vertex as it stands, with its faces and their samples.
    void FillWithStar(std::uint32_t v)
    {
        const SurfaceArrays& s = state_.simplified;
        Begin(PositionOf(s, v));
        for (const Corner* c = BeginCorners(s, v); c != EndCorners(s, v); ++c) {
            AddFace(FaceOf(*c), NextVertex(s, *c), PreviousVertex(s, *c), UnitNormal(FaceOf(*c)));
            HoldSamples(FaceOf(*c));
        }
    }

    const Scratch<FanFace>& faces() const { return faces_; }
    /// Of the samples as they are.
    const SampleSummary& summary() const { return summary_; }
    float present2() const { return present2_; }
    bool HasSamples() const { return groups_.size() > 0; }

    /// What is measured with the center at one place.
    struct Distances {
        double energy = 0;
        float largest2 = 0;
        Vector3<float> step{}; ///< of the center, that brings the farthest point to the other surface
    };

    /// Of the samples to the fan, and who owns them; without the step. \param x the center, seen from the
    /// origin \param equations of the step from there; may be null
    Distances MeasureForward(const Vector3<float>& x, EquationSums* equations)
    {
        for (FanFace& face : faces_) face.triangle = PrepareTriangle(face.toNext - x, face.toPrevious - x);
        Distances sum;
        Float4 energy = Splat(0.0F);
        for (SampleGroup& group : groups_) {
            const Vector3<Float4> point = group.point - Splat(x);
            if (equations)
                MeasureGroup(group, point, *equations);
            else
                MeasureGroup(group, point);
            energy += group.weight * group.newDistance2;
            sum.largest2 = std::max(sum.largest2, MaxLane(group.newDistance2));
        }
        sum.energy = static_cast<double>(SumLanes(energy));
        forward2_ = sum.largest2;
        return sum;
    }

    /// Of the center, the midpoints of its edges and the centroids of its faces to the original.
    /// \pre MeasureForward was asked about the same place, and there are samples
    /// \param tree of the original's faces, for points from where a walk may have got lost; may be null
    Distances MeasureBackward(const Vector3<float>& x, const FaceTree* tree)
    {
        CollectBackwardPoints(x);
        Distances sum;
        for (const BackwardGroup& group : points_) {
            const Float4 distance2 = BackwardDistances2(group, tree, sum);
            sum.energy += static_cast<double>(SumLanes(group.weight * distance2));
        }
        return sum;
    }

    /// For the farthest sample of the last MeasureForward.
    Vector3<float> StepForSamples(const Vector3<float>& x) const
    {
        constexpr float kMinLeverage = 0.1F;
        float largest2 = -1;
        Vector3<float> point{};
        std::size_t owner = 0;
        for (std::size_t i = 0; i < groups_.size(); ++i)
            for (int lane = 0; lane < kLanes; ++lane) {
                const SampleGroup& group = groups_[i];
                if (group.sample[lane] == kNone || !(group.newDistance2[lane] > largest2)) continue;
                largest2 = group.newDistance2[lane];
                point = Lane(group.point, lane) - x;
                owner = static_cast<std::size_t>(group.newOwner[lane]);
            }
        const FourClosestPoints closest = ClosestOnTriangle(Splat(point), faces_[owner].triangle);
        const float leverage = closest.originWeight[0];
        return leverage > kMinLeverage ? 1 / leverage * Lane(closest.difference, 0) : Vector3<float>{};
    }

    /// Do the faces of the last MeasureForward keep the limits of shape?
    bool KeepsFaces() const
    {
        return std::all_of(faces_.begin(), faces_.end(), [](const FanFace& face) {
            return face.triangle.doubleArea > 0 && face.triangle.quality >= kMinExchangeQuality &&
                   Dot(NormalOf(face.triangle), face.normal) >= kMinTurnCosine;
        });
    }
    /// Does one of them face away from the original below its centroid? \pre MeasureBackward was asked
    bool FacesAway() const
    {
        for (std::size_t i = 0; i < faces_.size(); ++i)
            if (FacesAwayFrom(state_.original, hints_[2 * i], NormalOf(faces_[i].triangle))) return true;
        return false;
    }

    /// Where the squared distances to the planes of the old faces are least, by area.
    Vector3<float> PlaneMinimum() const
    {
        NormalEquations equations{};
        for (const FanFace& face : faces_) {
            const float doubleArea = Norm(Cross(face.toNext, face.toPrevious));
            equations.matrix = equations.matrix + doubleArea * OuterProduct(face.normal);
            equations.right = equations.right + (doubleArea * Dot(face.normal, face.toNext)) * face.normal;
        }
        const float added = kPlaneRegularization / 3 * equations.matrix.Trace();
        return added > 0 ? SolveRegularized(equations.matrix, equations.right, added) : Vector3<float>{};
    }

    /// A center and the energy of the samples there.
    struct Fit {
        Vector3<float> x;
        double energy;
    };
    /// The best of \p start and what Gauss-Newton steps lead to.
    Fit BestCenter(const Vector3<float>& start)
    {
        Fit best{start, std::numeric_limits<double>::max()};
        Vector3<float> x = start;
        for (int step = 0;; ++step) {
            EquationSums sums;
            const bool last = step == kFitSteps;
            const Distances now = MeasureForward(x, last ? nullptr : &sums);
            if (now.energy < best.energy) best = {x, now.energy};
            if (last || now.energy > 2 * best.energy) return best;
            const auto next = SolveStep(sums.Total(), Regularization(now.energy));
            if (!next) return best;
            x = x + Clipped(*next);
        }
    }

    /// Puts \p center and the samples where the last measurements, at \p x, had them.
    /// \pre the faces of the fan are those around \p center, numbered as AddFace had it
    void Store(std::uint32_t center, const Vector3<float>& x)
    {
        const Vector3<float> p = origin_ + x;
        SurfacePoint& point = state_.simplified.points[center];
        point = {p.x, p.y, p.z, point.weight};
        auto& flags = state_.simplified.flags[center];
        flags = static_cast<std::uint8_t>(flags | kMovedVertex);
        for (const std::uint32_t face : held_) state_.samples.Clear(face);
        StoreSamples(state_.samples, groups_, faces_.size(), [&](std::size_t i) { return faces_[i].face; });
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const std::uint32_t face = faces_[i].face;
            state_.centroidHints[face] = hints_[2 * i];
            for (int k = 0; k < 3; ++k) state_.edgeHints[EdgeHint(MakeCorner(face, k))] = kNone;
        }
        state_.vertexHints[center] = hints_[2 * faces_.size()];
    }
    void SetFace(std::size_t i, std::uint32_t face) { faces_[i].face = face; }

    Vector3<float> UnitNormal(std::uint32_t face) const
    {
        const Vector3<float> n = AreaVector(state_.simplified, face);
        const float length = Norm(n);
        return length > 0 ? 1 / length * n : n;
    }

  private:
    void MeasureGroup(SampleGroup& group, const Vector3<Float4>& point) const
    {
        group.newDistance2 = Splat(std::numeric_limits<float>::max());
        group.newOwner = Splat(0);
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const Float4 distance2 = ClosestOnTriangle(point, faces_[i].triangle).distance2;
            const Int4 closer = distance2 < group.newDistance2;
            group.newDistance2 = Min(distance2, group.newDistance2);
            group.newOwner = Select(closer, Splat(static_cast<std::int32_t>(i)), group.newOwner);
        }
    }
    void MeasureGroup(SampleGroup& group, const Vector3<Float4>& point, EquationSums& equations) const
    {
        constexpr float kOnSurface2 = 1e-12F; // a sample this near to the surface has no direction of its own
        group.newDistance2 = Splat(std::numeric_limits<float>::max());
        group.newOwner = Splat(0);
        Float4 leverage = Splat(0.0F);
        Int4 inside = Splat(0);
        Vector3<Float4> difference{leverage, leverage, leverage}, normal = difference;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const PreparedTriangle<float>& triangle = faces_[i].triangle;
            const FourClosestPoints closest = ClosestOnTriangle(point, triangle);
            const Int4 closer = closest.distance2 < group.newDistance2;
            group.newDistance2 = Min(closest.distance2, group.newDistance2);
            group.newOwner = Select(closer, Splat(static_cast<std::int32_t>(i)), group.newOwner);
            leverage = Select(closer, closest.originWeight, leverage);
            inside = Select(closer, closest.inside, inside);
            difference = Select(closer, closest.difference, difference);
            normal = Select(closer, Splat(NormalOf(triangle)), normal);
        }
        const Float4 inverse = 1.0F / Sqrt(Max(group.newDistance2, Splat(kOnSurface2)));
        const Int4 alongNormal = inside | (group.newDistance2 < Splat(kOnSurface2));
        equations.Add(group.weight * leverage, leverage, Select(alongNormal, normal, inverse * difference),
                      difference);
    }
    void CollectBackwardPoints(const Vector3<float>& x)
    {
        const bool isFirst = hints_.size() == 0; // afterwards walks begin where the last ones ended
        hints_.Resize(2 * faces_.size() + 1);
        points_.Clear();
        std::size_t point = 0;
        const auto add = [&](const Vector3<float>& p, float area, float leverage) {
            SurfacePlace& hint = hints_[point++];
            if (isFirst) hint = NearestOrigin(state_.samples, groups_, {0, groups_.size()}, p);
            points_.Add(origin_ + p, kBackwardWeight * area, leverage, &hint);
        };
        float area = 0;
        for (const FanFace& face : faces_) {
            const float faceArea = face.triangle.doubleArea / 2;
            area += faceArea;
            add((1.0F / 3) * (x + face.toNext + face.toPrevious), kBackwardCentroidShare * faceArea,
                1.0F / 3);
            add(0.5F * (x + face.toNext), kBackwardEdgeShare * faceArea, 0.5F);
        }
        add(x, kBackwardVertexShare * area, 1);
    }
    /// Of one group; the largest one so far is noted in \p sum.
    Float4 BackwardDistances2(const BackwardGroup& group, const FaceTree* tree, Distances& sum) const
    {
        const PlaceSearch::FourHits hits = search_.Find(group.position, group.hint);
        Float4 distance2 = OrZero(hits.found, hits.distance2);
        const float doubtful2 = kDoubtful * std::max(forward2_, state_.meanSquare);
        for (int lane = 0; lane < kLanes; ++lane) {
            if (!(group.weight[lane] > 0 && distance2[lane] > sum.largest2)) continue;
            Vector3<float> residual = Lane(hits.residual, lane);
            if (tree && distance2[lane] > doubtful2) {
                const Vector3<float> point = Lane(group.position, lane);
                const Vector3<float> exact = tree->Closest(point) - point;
                if (const float exact2 = SquaredNorm(exact); exact2 < distance2[lane] * kMinProgress) {
                    distance2[lane] = exact2;
                    residual = exact;
                }
            }
            if (!(distance2[lane] > sum.largest2)) continue;
            sum.largest2 = distance2[lane];
            sum.step = 1 / group.leverage[lane] * residual;
        }
        return distance2;
    }
    float MeanSpoke2() const
    {
        float sum = 0;
        for (const FanFace& face : faces_) sum += face.triangle.bb;
        return std::max(sum / static_cast<float>(faces_.size()), kSmallestSquare);
    }
    float Regularization(double energy) const
    {
        return kStepRegularization * static_cast<float>(energy) / MeanSpoke2();
    }
    Vector3<float> Clipped(const Vector3<float>& step) const
    {
        float shortest2 = std::numeric_limits<float>::max();
        for (const FanFace& face : faces_) shortest2 = std::min(shortest2, face.triangle.bb);
        const float largest = kMaxStep * std::sqrt(shortest2), length = Norm(step);
        return length > largest ? (largest / length) * step : step;
    }
};

} // namespace vcg_ext
