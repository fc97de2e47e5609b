// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/symmetric_matrix.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/border_samples.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/samples.h"

namespace vcg_ext
{

/// The two border edges at a vertex that moves, and the samples of the original's border on them. Empty
/// around other vertices.
class BorderStar
{
    struct Edge {
        std::uint32_t start;               ///< its number
        Vector3<float> toOther;            ///< from the vertex
        Vector3<float> normal, binormal;   ///< unit vectors perpendicular to it and to each other
        float weight;                      ///< of its samples
        SymmetricMatrix3<float> residuals; ///< sum of weight r r^T, r from the edge to a sample
    };
    std::array<Edge, 2> edges_{};
    SampleGroups groups_;

  public:
    struct Energy {
        double sum = 0;
        float largest2 = 0;
    };

    bool Empty() const { return groups_.size() == 0; }
    void Clear() { groups_.Clear(); }
    /// \pre \p v is on two open edges: border.loops has it
    void Gather(const SurfaceArrays& surface, const BorderSamples& border, std::uint32_t v)
    {
        groups_.Clear();
        const Vector3<float> origin = PositionOf(surface, v);
        const std::uint32_t from = border.loops.previous[v], to = border.loops.next[v];
        edges_[0] = MakeEdge(v, PositionOf(surface, to) - origin);
        edges_[1] = MakeEdge(from, PositionOf(surface, from) - origin);
        for (std::uint32_t i = 0; i < 2; ++i)
            CollectSamples(border.lists, edges_[i].start, i, origin, groups_);
    }
    /// Energy where the vertex is, and the equations of the step from there: a sample beside an edge resists
    /// in both directions across it.
    Energy Measure(EquationSums& equations)
    {
        constexpr float kOnEdge2 = 1e-12F; // a sample this near has no direction of its own
        Float4 sum = Splat(0.0F), largest = sum;
        for (const SampleGroup& group : groups_) {
            Edge& edge = edges_[group.owner];
            sum += group.weight * group.distance2;
            largest = Max(largest, group.distance2);
            const auto [difference, t, beside] = Closest(group.point, edge.toOther);
            edge.weight += SumLanes(group.weight);
            edge.residuals = edge.residuals + SumLanes(group.weight * OuterProduct(difference));
            const Float4 leverage = 1.0F - t,
                         inverse = 1.0F / Sqrt(Max(SquaredNorm(difference), Splat(kOnEdge2)));
            const Vector3<Float4> none = Splat(Vector3<float>{0, 0, 0});
            const Vector3<Float4> first = Select(beside, Splat(edge.normal), inverse * difference);
            equations.Add(group.weight * leverage, leverage, first, difference);
            equations.Add(group.weight * leverage, leverage, Select(beside, Splat(edge.binormal), none),
                          none);
        }
        return {static_cast<double>(SumLanes(sum)), MaxLane(largest)};
    }
    /// \p step without what would bend a straight border edge or lift a flat one out of its plane; a corner
    /// of two straight ones stays. \param negligible mean squared distance of an edge's samples in a
    /// direction in which it is straight \pre measured
    Vector3<float> KeepStraight(const Vector3<float>& step, float negligible) const
    {
        constexpr float kParallel2 = 1e-3F; // squared sine of two directions that count as one
        if (Empty()) return step;
        std::array<Vector3<float>, 4> held{};
        std::size_t count = 0;
        Vector3<float> left = step;
        const auto hold = [&](Vector3<float> direction) {
            for (std::size_t i = 0; i < count; ++i) direction = direction - Dot(direction, held[i]) * held[i];
            if (SquaredNorm(direction) < kParallel2) return;
            held[count++] = Unit(direction);
            left = left - Dot(left, held[count - 1]) * held[count - 1];
        };
        for (const Edge& edge : edges_) {
            const float limit = negligible * edge.weight;
            const SymmetricMatrix3<float>& r = edge.residuals;
            const bool isStraight = !(r.Trace() > limit);
            if (isStraight) hold(edge.normal);
            const Vector3<float> other =
                isStraight ? edge.binormal : Unit(Cross(edge.toOther, LargestColumn(r)));
            if (isStraight || !(QuadraticForm(r, other) > limit)) hold(other);
        }
        return left;
    }
    /// Adds the energy after \p step to \p sum. Is the sum below \p allowed, and no sample farther than
    /// \p limit2? Leaves the samples' new distances and edges.
    bool StaysBelow(const Vector3<float>& step, double& sum, double allowed, float limit2)
    {
        for (SampleGroup& group : groups_) {
            const Vector3<Float4> point = group.point - Splat(step);
            const Float4 first = SquaredNorm(Closest(point, edges_[0].toOther - step).difference);
            const Float4 second = SquaredNorm(Closest(point, edges_[1].toOther - step).difference);
            group.newDistance2 = Min(first, second);
            group.newOwner = Select(second < first, Splat(1), Splat(0));
            sum += static_cast<double>(SumLanes(group.weight * group.newDistance2));
            if (sum >= allowed || MaxLane(group.newDistance2) > limit2) return false;
        }
        return true;
    }
    /// Writes an accepted step back.
    void Store(BorderSamples& border)
    {
        if (!Empty()) StoreSamples(border.lists, groups_, 2, [&](std::size_t i) { return edges_[i].start; });
    }

  private:
    struct FourClosest {
        Vector3<Float4> difference; ///< from the closest point
        Float4 t;                   ///< where on the edge that is, 0 at the vertex
        Int4 beside;                ///< not at an end
    };

    static Vector3<float> LargestColumn(const SymmetricMatrix3<float>& m)
    {
        if (m.xx >= m.yy && m.xx >= m.zz) return {m.xx, m.xy, m.xz};
        return m.yy >= m.zz ? Vector3<float>{m.xy, m.yy, m.yz} : Vector3<float>{m.xz, m.yz, m.zz};
    }
    static Vector3<float> Unit(const Vector3<float>& v)
    {
        return (1 / std::sqrt(std::max(SquaredNorm(v), kSmallestSquare))) * v;
    }
    static Edge MakeEdge(std::uint32_t start, const Vector3<float>& toOther)
    {
        Edge edge{start, toOther, {}, {}, 0, {}};
        const float x = std::abs(toOther.x), y = std::abs(toOther.y), z = std::abs(toOther.z);
        Vector3<float> axis{0, 0, 0}; // the one that the edge is least along
        (x <= y && x <= z ? axis.x : y <= z ? axis.y : axis.z) = 1;
        edge.normal = Unit(Cross(toOther, axis));
        edge.binormal = Unit(Cross(toOther, edge.normal));
        return edge;
    }
    static FourClosest Closest(const Vector3<Float4>& p, const Vector3<float>& edge)
    {
        const Vector3<Float4> along = Splat(edge);
        const Float4 t = Dot(p, along) / std::max(SquaredNorm(edge), kSmallestSquare);
        const Float4 clamped = Min(Max(t, Splat(0.0F)), Splat(1.0F));
        return {p - clamped * along, clamped, (t > Splat(0.0F)) & (t < Splat(1.0F))};
    }
};

} // namespace vcg_ext
