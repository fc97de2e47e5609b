// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/float4.h"
#include "vcg_ext/core/geometry/symmetric_matrix.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/border_samples.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/samples.h"
#include "vcg_ext/core/refine/surface_walk.h"

// What all passes share: the state, the distances of points of the simplified surface to the original, and
// the equations of a vertex's step.

namespace vcg_ext
{

/// What has happened to a vertex lately.
enum VertexChange : std::uint8_t {
    kMovedLately = 1,
    kNewFaces = 2 ///< by a flip or an exchange
};

/// What all passes share. Hints are places of the original, kNone where nothing is known yet.
struct RefinementState {
    const SurfaceArrays& original;
    SurfaceArrays& simplified;
    SampleLists samples;
    BorderSamples border;
    Buffer<SurfacePlace> vertexHints, centroidHints;
    Buffer<SurfacePlace> edgeHints;                      ///< 3 face + index, from vertex index to the next
    float meanSquare = 0;                                ///< rms^2 before the first change
    float farthest2 = std::numeric_limits<float>::max(); ///< of the samples, before the first change
    std::uint32_t blockVertices = kBlockVertices;

    float gainFactor = 1;           ///< of what flips and moves must gain
    float valenceWeight = 0;        ///< kValenceWeight of now
    Buffer<std::uint8_t> changed{}; ///< VertexChange of every vertex; empty: nobody asks
    Buffer<float>
        backward2{}; ///< largest squared distance backward of each star when it was measured last; or empty
    struct Renewed {
        Buffer<std::uint8_t> vertices{}, faces{};
    } renewed{}; ///< not 0: an exchange has put them to another place

    void MarkChanged(std::uint32_t v, VertexChange change)
    {
        if (!changed.empty()) changed[v] = static_cast<std::uint8_t>(changed[v] | change);
    }
    /// No change may bring a point farther than this, squared, unless it was before.
    float Tolerable2() const
    {
        return std::min(kTolerableDistance * kTolerableDistance * meanSquare,
                        kTolerableOfFarthest * kTolerableOfFarthest * farthest2);
    }
};

inline std::uint32_t EdgeHint(Corner corner)
{
    return 3 * FaceOf(corner) + static_cast<std::uint32_t>(IndexOf(corner));
}

/// The least-squares step of a vertex: (sum w b^2 n n^T) x = sum w b d. A point of weight w makes the part b
/// of the step, is away from its target by d, and resists along the direction n of d only.
struct NormalEquations {
    SymmetricMatrix3<float> matrix;
    Vector3<float> right;
};

/// The sums of the equations, four points at a time.
class EquationSums
{
    SymmetricMatrix3<Float4> matrix_{};
    Vector3<Float4> right_{};

  public:
    /// \param weighted w b
    void Add(Float4 weighted, Float4 leverage, const Vector3<Float4>& direction,
             const Vector3<Float4>& residual)
    {
        right_ = right_ + weighted * residual;
        const Float4 s = weighted * leverage, sx = s * direction.x, sy = s * direction.y;
        matrix_ = matrix_ + SymmetricMatrix3<Float4>{sx * direction.x, sx * direction.y,
                                                     sx * direction.z, sy * direction.y,
                                                     sy * direction.z, s * direction.z * direction.z};
    }
    NormalEquations Total() const { return {SumLanes(matrix_), SumLanes(right_)}; }
};

/// The step that solves \p e with \p regularization added to the diagonal, within its limits, by a
/// decomposition LDL^T whose pivots stay positive; nothing where the equations are empty or have no solution.
inline std::optional<Vector3<float>> SolveStep(const NormalEquations& e, float regularization)
{
    constexpr float kNoStep2 = 1e30F; // a squared step from here on comes from equations without a solution
    const SymmetricMatrix3<float>& m = e.matrix;
    const float added =
        std::min(m.Trace() * (kMaxRegularization / 3), regularization + m.Trace() * kMinRegularization);
    if (!(added > 0)) return std::nullopt;
    const float inverse0 = 1 / (m.xx + added);
    const float l1 = m.xy * inverse0, l2 = m.xz * inverse0;
    const float pivot1 = std::max(m.yy + added - l1 * m.xy, added / 2);
    const float mixed = m.yz - l2 * m.xy, l21 = mixed / pivot1;
    const float pivot2 = std::max(m.zz + added - l2 * m.xz - l21 * mixed, added / 2);
    const float z1 = e.right.y - l1 * e.right.x;
    const float z2 = e.right.z - l2 * e.right.x - l21 * z1;
    Vector3<float> step{};
    step.z = z2 / pivot2;
    step.y = z1 / pivot1 - l21 * step.z;
    step.x = e.right.x * inverse0 - l1 * step.y - l2 * step.z;
    if (!(SquaredNorm(step) < kNoStep2)) return std::nullopt;
    return step;
}

/// Four points of the simplified surface whose distances to the original count. Lanes behind the last repeat
/// it with weight 0.
struct BackwardGroup {
    Vector3<Float4> position; ///< in the frame of the arrays
    Float4 weight;            ///< area, times the weight of the backward term
    Float4 leverage;          ///< part of the vertex's step that the point makes
    SurfacePlace* hint[4];    ///< face of the original found last, or where to look first
};

class BackwardPoints
{
    Scratch<BackwardGroup> groups_;
    std::size_t count_ = 0;

  public:
    void Clear()
    {
        groups_.Clear();
        count_ = 0;
    }
    void Add(const Vector3<float>& position, float weight, float leverage, SurfacePlace* hint)
    {
        const int lane = static_cast<int>(count_++ % kLanes);
        BackwardGroup& group = lane == 0 ? groups_.Append() : groups_[groups_.size() - 1];
        for (int i = lane; i < kLanes; ++i) {
            SetLane(group.position, i, position);
            group.weight[i] = i == lane ? weight : 0;
            group.leverage[i] = leverage;
            group.hint[i] = hint;
        }
    }
    const BackwardGroup* begin() { return groups_.begin(); }
    const BackwardGroup* end() { return groups_.end(); }
};

/// The energy of some backward points and their largest squared distance.
struct BackwardEnergy {
    double energy = 0;
    float largest2 = 0;
};

/// Sum of weight x squared distance, the points moved by their part of \p step.
/// \param limit2 squared distances count at most this much, and such points do not enter \p equations
/// \param stop the sum ends where it is larger
/// \param equations may be null
inline BackwardEnergy MeasureBackward(const PlaceSearch& search, BackwardPoints& points,
                                      const Vector3<float>& step, float limit2, double stop,
                                      EquationSums* equations)
{
    constexpr float kSmallestResidual2 = 1e-14F; // below, a residual has no direction
    BackwardEnergy sum;
    Float4 largest = Splat(0.0F);
    for (const BackwardGroup& group : points) {
        const Vector3<Float4> position = group.position + group.leverage * Splat(step);
        const PlaceSearch::FourHits hits = search.Find(position, group.hint);
        const Float4 distance2 = OrZero(hits.found, Min(hits.distance2, Splat(limit2)));
        largest = Max(largest, distance2);
        sum.energy += static_cast<double>(SumLanes(group.weight * distance2));
        if (equations) {
            const Float4 length2 = SquaredNorm(hits.residual);
            const Int4 counts =
                hits.found & (hits.distance2 <= Splat(limit2)) & (length2 > Splat(kSmallestResidual2));
            const Float4 inverse = 1.0F / Sqrt(Max(length2, Splat(kSmallestResidual2)));
            const Vector3<Float4> r{OrZero(counts, hits.residual.x), OrZero(counts, hits.residual.y),
                                    OrZero(counts, hits.residual.z)};
            equations->Add(OrZero(counts, group.weight * group.leverage), group.leverage,
                           {inverse * r.x, inverse * r.y, inverse * r.z}, r);
        }
        if (sum.energy > stop) break;
    }
    sum.largest2 = MaxLane(largest);
    return sum;
}

} // namespace vcg_ext
