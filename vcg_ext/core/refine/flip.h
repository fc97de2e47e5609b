// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/edge_flip.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/surface_walk.h"

namespace vcg_ext
{

/// Exchanges the diagonal of two faces where that is allowed and saves energy.
/// One object per thread; it holds nothing but scratch between two calls.
class EdgeFlipper
{
    /// Seen from a.
    struct Shape {
        Vector3<float> a, b, c, d; ///< a is absolute, the others are differences from it
        std::array<PreparedTriangle<float>, 2> before, after; ///< the second one after the flip seen from d
    };

    RefinementState& state_;
    PlaceSearch search_;
    FlippableEdge edge_{};
    Shape shape_;
    SampleGroups groups_;
    BackwardPoints points_;
    std::array<SurfacePlace, 3> hints_{}; ///< of the last Backward's points
    Scratch<std::uint32_t> neighbours_;

  public:
    explicit EdgeFlipper(RefinementState& state) : state_(state), search_(state.original) {}

    /// Tries the edges from \p v to neighbours of higher index; returns how many were flipped.
    std::size_t FlipAround(std::uint32_t v)
    {
        const SurfaceArrays& surface = state_.simplified;
        neighbours_.Clear();
        for (const Corner* c = BeginCorners(surface, v); c != EndCorners(surface, v); ++c)
            if (const std::uint32_t w = NextVertex(surface, *c); w > v) neighbours_.Append() = w;
        std::size_t flips = 0;
        for (std::size_t i = 0; i < neighbours_.size(); ++i) flips += Flip(v, neighbours_[i]) ? 1 : 0;
        return flips;
    }

  private:
    bool Flip(std::uint32_t v, std::uint32_t w)
    {
        const auto edge = FindFlippableEdge(state_.simplified, v, w);
        if (!edge) return false;
        edge_ = *edge;
        SampleSummary summary;
        summary.Add(state_.samples.faces[edge_.First()]);
        summary.Add(state_.samples.faces[edge_.Second()]);
        const float needed = state_.gainFactor * kMinFlipGainOfMean * state_.meanSquare * summary.weight;
        const float price = state_.valenceWeight * state_.meanSquare * summary.weight * ValenceChange();
        if (summary.count == 0 || summary.energy < needed + price) return false;
        if (!ShapeAllows() || AreNeighbours(state_.simplified, edge_.c, edge_.d)) return false;
        if (!SavesEnergy(static_cast<double>(needed), static_cast<double>(price))) return false;
        Accept();
        return true;
    }

    /// Of the sum of (faces - 6)^2, at a border 3, over the four vertices.
    float ValenceChange() const
    {
        constexpr float kRegular = 6, kRegularAtBorder = 3;
        const SurfaceArrays& s = state_.simplified;
        const auto excess = [&](std::uint32_t v) {
            return static_cast<float>(s.cornerCount[v]) -
                   (s.flags[v] & kBorderVertex ? kRegularAtBorder : kRegular);
        };
        return 2 * (excess(edge_.c) + excess(edge_.d) - excess(edge_.a) - excess(edge_.b)) + 4;
    }

    /// Fills shape_. Would the new faces be sound, and face where the old ones faced?
    bool ShapeAllows()
    {
        Shape& s = shape_;
        s.a = PositionOf(state_.simplified, edge_.a);
        s.b = PositionOf(state_.simplified, edge_.b) - s.a;
        s.c = PositionOf(state_.simplified, edge_.c) - s.a;
        s.d = PositionOf(state_.simplified, edge_.d) - s.a;
        s.before = {PrepareTriangle(s.b, s.c), PrepareTriangle(s.d, s.b)};
        s.after = {PrepareTriangle(s.d, s.c), PrepareTriangle(s.b - s.d, s.c - s.d)};
        const Vector3<float> old0 = NormalOf(s.before[0]), old1 = NormalOf(s.before[1]);
        const Vector3<float> new0 = NormalOf(s.after[0]), new1 = NormalOf(s.after[1]);
        if (!(s.after[0].doubleArea > 0 && s.after[1].doubleArea > 0)) return false;
        const Vector3<float> mean = s.before[0].doubleArea * old0 + s.before[1].doubleArea * old1;
        const float least = kMinTurnCosine * Norm(mean);
        if (!(Dot(new0, mean) > least && Dot(new1, mean) > least)) return false;
        const float fold = Dot(new0, new1);
        if (fold < kMinFoldCosine && fold < Dot(old0, old1)) return false;
        const float oldQuality = std::min(s.before[0].quality, s.before[1].quality);
        return std::min(s.after[0].quality, s.after[1].quality) >= std::min(kMinFlipQuality, oldQuality);
    }

    /// Leaves the samples' new distances and owners. \param price what must be saved beside; may be negative
    bool SavesEnergy(double needed, double price)
    {
        const float tolerable2 = state_.Tolerable2();
        groups_.Clear();
        CollectSamples(state_.samples, edge_.First(), 0, shape_.a, groups_);
        CollectSamples(state_.samples, edge_.Second(), 1, shape_.a, groups_);
        float old2 = 0, new2 = 0;
        double before = 0, after = 0;
        MeasureForward(before, after, old2, new2);
        if ((after > before && !(price < 0)) || new2 > std::max(old2, tolerable2)) return false;
        const BackwardEnergy oldBackward = Backward(
            Vector3<float>{}, shape_.b, shape_.c, shape_.d, shape_.before,
            kBackwardOutlier * std::max(old2, state_.meanSquare), std::numeric_limits<double>::max());
        before += oldBackward.energy;
        const double allowed =
            std::min(before * static_cast<double>(1 - state_.gainFactor * kMinFlipGain), before - needed) -
            price;
        if (after >= allowed) return false;
        const BackwardEnergy newBackward =
            Backward(shape_.c, shape_.d, Vector3<float>{}, shape_.b, shape_.after,
                     std::numeric_limits<float>::max(), allowed - after);
        return after + newBackward.energy < allowed &&
               newBackward.largest2 <= std::max(oldBackward.largest2, tolerable2) &&
               !FacesAwayFrom(state_.original, hints_[1], NormalOf(shape_.after[0])) &&
               !FacesAwayFrom(state_.original, hints_[2], NormalOf(shape_.after[1]));
    }
    void MeasureForward(double& before, double& after, float& old2, float& new2)
    {
        for (SampleGroup& group : groups_) {
            const Float4 first = ClosestOnTriangle(group.point, shape_.after[0]).distance2;
            const Vector3<Float4> fromD = group.point - Splat(shape_.d);
            const Float4 second = ClosestOnTriangle(fromD, shape_.after[1]).distance2;
            group.newOwner = (second < first) & Splat(1);
            group.newDistance2 = Min(first, second);
            before += static_cast<double>(SumLanes(group.weight * group.distance2));
            after += static_cast<double>(SumLanes(group.weight * group.newDistance2));
            old2 = std::max(old2, MaxLane(group.distance2));
            new2 = std::max(new2, MaxLane(group.newDistance2));
        }
    }
    /// Of the faces (u, v, x) and (v, u, y), at the midpoint of u v and at both centroids.
    BackwardEnergy Backward(const Vector3<float>& u, const Vector3<float>& v, const Vector3<float>& x,
                            const Vector3<float>& y, const std::array<PreparedTriangle<float>, 2>& faces,
                            float limit2, double stop)
    {
        const float area0 = kBackwardWeight * faces[0].doubleArea / 2;
        const float area1 = kBackwardWeight * faces[1].doubleArea / 2;
        std::size_t point = 0;
        points_.Clear();
        const auto add = [&](const Vector3<float>& position, float weight) {
            hints_[point] = NearestOrigin(state_.samples, groups_, {0, groups_.size()}, position);
            points_.Add(shape_.a + position, weight, 0, &hints_[point++]);
        };
        add(0.5F * (u + v), kFlippedEdgeShare * (area0 + area1));
        add((1.0F / 3) * (u + v + x), kFlippedCentroidShare * area0);
        add((1.0F / 3) * (u + v + y), kFlippedCentroidShare * area1);
        return MeasureBackward(search_, points_, Vector3<float>{}, limit2, stop, nullptr);
    }

    void Accept()
    {
        const std::array<std::uint32_t, 2> faces{edge_.First(), edge_.Second()};
        FlipEdge(state_.simplified, edge_);
        for (const std::uint32_t v : {edge_.a, edge_.b, edge_.c, edge_.d}) state_.MarkChanged(v, kNewFaces);
        for (const std::uint32_t face : faces) {
            state_.centroidHints[face] = kNone;
            for (int k = 0; k < 3; ++k) state_.edgeHints[EdgeHint(MakeCorner(face, k))] = kNone;
        }
        StoreSamples(state_.samples, groups_, 2, [&](std::size_t i) { return faces[i]; });
    }
};

} // namespace vcg_ext
