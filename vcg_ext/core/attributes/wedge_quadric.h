// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The attribute error of a wedge as a quadric, in the squared length of the geometric cost, so that both add
// up. With every channel k linear on a face, s_k(p) = g_k.p + const, and the face's weight a = 2 area
// sigma^2, the sum over the faces that a wedge stands for is
//
//     E(d, t) = d^T M d + 2 b.d + c + sum_k [ t_k^2 W_k - 2 t_k (G_k.d + D_k) ]
//     M = sum a g g^T    G_k = sum a g_k    W_k = sum a
//
// of the offset d from the wedge's vertex and the difference t from the wedge's own values. Of a wedge that
// has not moved b, c and D are 0, so single precision is enough.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/mesh/channels.h"
#include "vcg_ext/core/geometry/symmetric_matrix.h"
#include "vcg_ext/core/geometry/vector.h"

namespace vcg_ext
{

/// Where the numbers of a wedge lie in its record: first its values, then its quadric.
struct WedgeLayout {
    std::size_t channels = 0, groups = 0;

    static constexpr std::size_t kMatrix = 0, kLinear = 6, kConstant = 9, kWeights = 10;

    std::size_t QuadricSize() const { return kWeights + groups + 4 * channels; }
    std::size_t RecordSize() const { return channels + QuadricSize(); }
    std::size_t Slope(std::size_t channel) const { return kWeights + groups + 4 * channel; }
};

/// The quadric at \p q. \tparam Number float, or const float where it is only read
template <class Number>
class WedgeQuadric
{
    const Channels& channels_;
    WedgeLayout layout_;
    Number* q_;

  public:
    WedgeQuadric(const Channels& channels, const WedgeLayout& layout, Number* q)
        : channels_(channels), layout_(layout), q_(q)
    {
    }

    SymmetricMatrix3<float> Matrix() const { return {q_[0], q_[1], q_[2], q_[3], q_[4], q_[5]}; }
    Vector3<float> Linear() const { return {q_[6], q_[7], q_[8]}; }
    float Constant() const { return q_[WedgeLayout::kConstant]; }
    float Weight(std::size_t channel) const { return q_[WedgeLayout::kWeights + channels_.group[channel]]; }
    Vector3<float> Slope(std::size_t channel) const
    {
        const Number* g = q_ + layout_.Slope(channel);
        return {g[0], g[1], g[2]};
    }
    float Offset(std::size_t channel) const { return q_[layout_.Slope(channel) + 3]; }

    /// G.d + D: W times the best value of the channel, seen from the wedge's own.
    float Wanted(std::size_t channel, const Vector3<float>& d) const
    {
        return Dot(Slope(channel), d) + Offset(channel);
    }

    /// E. What is below the rounding of its parts counts as nothing, so that an attribute that is linear all
    /// over a plane costs nothing on it.
    /// \param t t(channel): the difference from the wedge's own value
    template <class Difference>
    float operator()(const Vector3<float>& d, const Difference& t) const
    {
        constexpr float kRounding = 2e-6f; // some ten operations
        const float bent = QuadraticForm(Matrix(), d);
        float sum = bent + 2 * Dot(Linear(), d) + Constant(), size = bent + Constant();
        for (std::size_t k = 0; k < layout_.channels; ++k) {
            const float s = t(k), square = s * s * Weight(k);
            sum += square - 2 * s * Wanted(k, d);
            size += square;
        }
        return sum > kRounding * size ? sum : 0;
    }

    /// Adds \p from, moved to the offset \p d from its vertex and to values that differ by t(channel).
    template <class Other, class Difference>
    void AddMoved(const WedgeQuadric<Other>& from, const Vector3<float>& d, const Difference& t)
    {
        const SymmetricMatrix3<float> matrix = from.Matrix();
        Vector3<float> linear = from.Linear() + matrix * d;
        for (std::size_t k = 0; k < layout_.channels; ++k) {
            const Vector3<float> slope = from.Slope(k);
            linear = linear - t(k) * slope;
            Number* g = q_ + layout_.Slope(k);
            g[0] += slope.x;
            g[1] += slope.y;
            g[2] += slope.z;
            g[3] += from.Wanted(k, d) - t(k) * from.Weight(k);
        }
        AddGeometry(matrix, linear, from(d, t));
        for (std::size_t g = 0; g < layout_.groups; ++g)
            q_[WedgeLayout::kWeights + g] += from.q_[WedgeLayout::kWeights + g];
    }

    /// Adds a face on which a channel of the group has the gradient \p slope.
    void AddSlope(std::size_t channel, float weight, const Vector3<float>& slope)
    {
        AddGeometry(weight * OuterProduct(slope), {0, 0, 0}, 0);
        Number* g = q_ + layout_.Slope(channel);
        g[0] += weight * slope.x;
        g[1] += weight * slope.y;
        g[2] += weight * slope.z;
    }
    void AddWeight(std::size_t group, float weight) { q_[WedgeLayout::kWeights + group] += weight; }

    /// What is left for the placement where all values are the best ones: d^T matrix d + 2 linear.d.
    void BestForPlacement(SymmetricMatrix3<float>& matrix, Vector3<float>& linear) const
    {
        matrix = Matrix();
        linear = Linear();
        for (std::size_t k = 0; k < layout_.channels; ++k) {
            const float weight = Weight(k);
            if (!(weight > 0)) continue;
            const Vector3<float> slope = Slope(k);
            matrix = matrix - (1 / weight) * OuterProduct(slope);
            linear = linear - (Offset(k) / weight) * slope;
        }
    }

  private:
    template <class>
    friend class WedgeQuadric;

    void AddGeometry(const SymmetricMatrix3<float>& m, const Vector3<float>& linear, float constant)
    {
        const float values[10] = {m.xx, m.xy, m.xz, m.yy, m.yz, m.zz, linear.x, linear.y, linear.z, constant};
        for (std::size_t i = 0; i < 10; ++i) q_[i] += values[i];
    }
};

} // namespace vcg_ext
