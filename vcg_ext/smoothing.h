// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/mesh_arrays.h"
#include "vcg_ext/core/mesh/one_ring.h"
#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

using Coordinates = std::array<double, 3>;

/// How the edges around a vertex are averaged to the Laplacian delta. Rows of kUmbrellaOperators.
enum class UmbrellaOperator { Uniform, ScaleDependent, NormalDependent };

struct UmbrellaOperatorRow {
    UmbrellaOperator kind;
    const char* id;
    const char* name;
    const char* help;
};

inline constexpr UmbrellaOperatorRow kUmbrellaOperators[] = {
    {UmbrellaOperator::Uniform, "umbrella", "Umbrella",
     "Toward the centroid of the neighbors: every edge has the same weight (Eq. 1)"},
    {UmbrellaOperator::ScaleDependent, "scale_dependent", "Scale-dependent umbrella",
     "Edges have weight 1 / length (Eq. 2, after Fujiwara 1995), so long edges do not pull vertices along the "
     "surface"},
    {UmbrellaOperator::NormalDependent, "normal_dependent", "Normal-dependent umbrella",
     "The component of the umbrella vector along the vertex normal (Eq. 3): vertices in a plane do not move"},
};

/// What smoothing does at open borders: edges with one face.
enum class SmoothingBoundary {
    Free,        ///< as everywhere
    AlongBorder, ///< a border vertex has its border neighbours only, so the border is smoothed as a curve
    Fixed        ///< border vertices stay
};

/// The defaults are those of the filter.
struct SmoothingParameters {
    UmbrellaOperator umbrella = UmbrellaOperator::Uniform;
    int steps = 10;       ///< [1, 10000]; all vertices move at once in each
    double stepSize = .5; ///< part of delta that a vertex moves, (0, 1]
    SmoothingBoundary boundary = SmoothingBoundary::Free;
    const std::uint8_t* movable = nullptr; ///< one byte a vertex, 0: stays; null: all move
    int threads = 0;                       ///< 0: all; the result does not depend on it
    Progress progress;                     ///< may be empty
};

namespace operator_detail
{

inline Coordinates Difference(const Coordinates& a, const Coordinates& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double Dot(const Coordinates& a, const Coordinates& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline void AddScaled(Coordinates& sum, double scale, const Coordinates& a)
{
    for (std::size_t k = 0; k < 3; ++k) sum[k] += scale * a[k];
}
/// The unit vector, or zero.
inline Coordinates Normalized(const Coordinates& a)
{
    const double length = std::sqrt(Dot(a, a));
    return length > 0 ? Coordinates{a[0] / length, a[1] / length, a[2] / length} : Coordinates{};
}

/// As VertexNormal, in double: faces weigh the chord of their angle.
inline Coordinates UnitNormal(const std::vector<Coordinates>& positions, std::size_t v,
                              ArrayView<RingCorner> corners)
{
    Coordinates sum{};
    double chords = 0;
    for (const RingCorner& corner : corners) {
        const Coordinates a = Normalized(Difference(positions[corner.next], positions[v]));
        const Coordinates b = Normalized(Difference(positions[corner.previous], positions[v]));
        const Coordinates chord = Difference(a, b);
        const double weight = std::sqrt(Dot(chord, chord));
        AddScaled(
            sum, weight,
            Normalized({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}));
        chords += weight;
    }
    constexpr double kCancelled = 1e-12; // opposite normals leave rounding
    return Dot(sum, sum) > kCancelled * kCancelled * chords * chords ? Normalized(sum) : Coordinates{};
}

/// The ends of the edges with one face at a vertex.
inline std::vector<std::uint32_t> BorderNeighbours(ArrayView<RingCorner> corners)
{
    std::vector<std::uint32_t> ends, once;
    for (const RingCorner& corner : corners) {
        ends.push_back(corner.next);
        ends.push_back(corner.previous);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const bool before = i > 0 && ends[i - 1] == ends[i],
                   after = i + 1 < ends.size() && ends[i + 1] == ends[i];
        if (!before && !after) once.push_back(ends[i]);
    }
    return once;
}

} // namespace operator_detail

/// The umbrella operators on a mesh whose vertices move and whose faces stay. Neighbours are the ends of the
/// edges, each once, also at borders and non-manifold edges; polygons' diagonals are none.
class UmbrellaRings
{
    OneRings rings_;
    std::vector<std::size_t> offset_{0};
    std::vector<std::uint32_t> neighbours_;

  public:
    /// \param movable as SmoothingParameters \pre as OneRings
    UmbrellaRings(const MeshView& mesh, SmoothingBoundary boundary, const std::uint8_t* movable = nullptr)
        : rings_(mesh)
    {
        std::vector<std::uint32_t> room;
        for (std::size_t v = 0; v < mesh.vertexCount; ++v) {
            const auto corners = rings_.Corners(v);
            const auto all = rings_.Neighbours(v, room);
            const auto border = boundary == SmoothingBoundary::Free
                                    ? std::vector<std::uint32_t>{}
                                    : operator_detail::BorderNeighbours(corners);
            const bool stays = (movable != nullptr && !movable[v]) ||
                               (boundary == SmoothingBoundary::Fixed && !border.empty());
            if (!stays && border.empty()) neighbours_.insert(neighbours_.end(), all.begin(), all.end());
            if (!stays) neighbours_.insert(neighbours_.end(), border.begin(), border.end());
            offset_.push_back(neighbours_.size());
        }
    }

    ArrayView<std::uint32_t> Neighbours(std::size_t v) const
    {
        return {neighbours_.data() + offset_[v], offset_[v + 1] - offset_[v]};
    }

    /// delta of Eq. 1 with the weights of Eq. 2, or of Eq. 3; zero where the vertex has no neighbours.
    Coordinates Delta(const std::vector<Coordinates>& positions, std::size_t v,
                      UmbrellaOperator umbrella) const
    {
        using namespace operator_detail;
        Coordinates sum{};
        double weights = 0;
        for (const std::uint32_t w : Neighbours(v)) {
            const Coordinates edge = Difference(positions[w], positions[v]);
            const double length = std::sqrt(Dot(edge, edge));
            if (!(length > 0)) continue;
            const double weight = umbrella == UmbrellaOperator::ScaleDependent ? 1 / length : 1;
            AddScaled(sum, weight, edge);
            weights += weight;
        }
        if (!(weights > 0)) return {};
        Coordinates delta{};
        AddScaled(delta, 1 / weights, sum);
        if (umbrella != UmbrellaOperator::NormalDependent) return delta;
        const Coordinates normal = UnitNormal(positions, v, rings_.Corners(v));
        Coordinates along{};
        AddScaled(along, Dot(delta, normal), normal);
        return along;
    }
};

/// Positions after smoothing; those of vertices without faces, outside the mask or on a fixed border are the
/// input's.
/// \pre as OneRings \throws std::invalid_argument where a parameter is outside its range, Cancelled
inline std::vector<Coordinates> SmoothedPositions(const MeshView& mesh, const SmoothingParameters& parameters)
{
    if (parameters.steps < 1 || parameters.steps > 10000)
        throw std::invalid_argument("steps = " + std::to_string(parameters.steps) + " is outside [1, 10000]");
    if (!(parameters.stepSize > 0 && parameters.stepSize <= 1))
        throw std::invalid_argument("step_size = " + std::to_string(parameters.stepSize) +
                                    " is outside (0, 1]");
    const StageProgress progress(parameters.progress);
    const UmbrellaRings rings(mesh, parameters.boundary, parameters.movable);
    std::vector<Coordinates> now(mesh.vertexCount), next(mesh.vertexCount);
    for (std::size_t v = 0; v < mesh.vertexCount; ++v) now[v] = mesh.Position(v);
    const int threads = UsefulThreadCount(parameters.threads, mesh.faceCount);
    for (int step = 0; step < parameters.steps; ++step) {
        progress(100 * step / parameters.steps, "Umbrella smoothing");
        constexpr std::size_t kGrain = 2048;
        ParallelRanges(threads, mesh.vertexCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                next[v] = now[v];
                operator_detail::AddScaled(next[v], parameters.stepSize,
                                           rings.Delta(now, v, parameters.umbrella));
            }
        });
        std::swap(now, next);
    }
    return now;
}

/// Smooths any VCG triangle mesh in place: positions only; normals are the caller's.
/// \throws as SmoothedPositions; the mesh is untouched then
template <class Mesh>
void UmbrellaSmooth(Mesh& mesh, const SmoothingParameters& parameters)
{
    using Scalar = typename Mesh::ScalarType;
    const auto positions = SmoothedPositions(MeshArrays<Mesh>(mesh).View(), parameters);
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        if (mesh.vert[v].IsD()) continue;
        const Coordinates& p = positions[v];
        mesh.vert[v].P() = typename Mesh::CoordType(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]),
                                                    static_cast<Scalar>(p[2]));
    }
}

} // namespace vcg_ext
