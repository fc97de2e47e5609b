// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/edge_flip.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/vertex_blocks.h"
#include "vcg_ext/core/refine/attach_samples.h"
#include "vcg_ext/core/refine/check_stars.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/parameters.h"
#include "vcg_ext/core/refine/passes.h"
#include "vcg_ext/core/refine/rounds.h"
#include "vcg_ext/core/refine/take_back.h"
#include "vcg_ext/core/refine/worst_stars.h"

namespace vcg_ext
{

/// Where the rms is below this part of a face's size, faces are tilted by less than a three-hundredth of a
/// degree: moves would gain nothing and make flat parts uneven.
constexpr double kFlatTilt = 5e-5;
/// Unless some sample is farther than this part of a face's size.
constexpr double kFlatDistance = 1e-2;

/// Square root of the mean area of a face.
inline double FaceSize(const SurfaceArrays& surface)
{
    double doubleArea = 0;
    for (std::uint32_t f = 0; f < surface.FaceCount(); ++f)
        doubleArea += static_cast<double>(Norm(AreaVector(surface, f)));
    return std::sqrt(doubleArea / 2 / static_cast<double>(surface.FaceCount()));
}

inline Buffer<SurfacePlace> NoHints(std::size_t size)
{
    Buffer<SurfacePlace> hints(size);
    std::fill(hints.begin(), hints.end(), kNone);
    return hints;
}

/// The samples attached to the faces and how far they are, and no hints.
inline RefinementState BeginRefinement(const SurfaceArrays& original, SurfaceArrays& simplified,
                                       const Buffer<std::uint32_t>& root, int threads,
                                       float featureShare = kFeatureShare)
{
    RefinementState state{original,
                          simplified,
                          AttachSamples(original, simplified, root, threads, featureShare),
                          AttachBorderSamples(original, simplified, root, threads),
                          NoHints(simplified.VertexCount()),
                          NoHints(simplified.FaceCount()),
                          NoHints(3 * simplified.FaceCount())};
    state.meanSquare = static_cast<float>(MeanSquare(state.samples));
    state.farthest2 = 0;
    for (const Sample& sample : state.samples.samples)
        state.farthest2 = std::max(state.farthest2, sample.distance2);
    return state;
}

/// One pass of flips and a few of moves, and a check of what they have done.
/// \param reached called with the percentage that is done, and the one that the next loop leads to; may throw
template <class Reached>
void RefineInPasses(RefinementState& state, const RefinementParameters& parameters, int threads,
                    RefinementReport& report, const Reached& reached)
{
    constexpr int kMovesBegin = 32, kMovesEnd = 78; // percent of the time, roughly
    const SurfaceBefore before(state.simplified);
    if (parameters.flip) report.flips = FlipEdges(state, threads);
    for (int sweep = 0; sweep < parameters.moveSweeps; ++sweep) {
        reached(kMovesBegin + (kMovesEnd - kMovesBegin) * sweep / parameters.moveSweeps,
                kMovesBegin + (kMovesEnd - kMovesBegin) * (sweep + 1) / parameters.moveSweeps);
        const std::size_t moves = MoveVertices(state, threads);
        report.moves += moves;
        ++report.sweeps;
        if (moves == 0) break;
    }
    report.rmsAfter = std::sqrt(MeanSquare(state.samples));
    reached(kMovesEnd, 100, 4);
    report.takenBack = TakeBackWorse(state, before, threads);
}

/// Moves the vertices and flips the edges of a simplified surface so that the weighted squared distance
/// between it and the original falls, in both directions. Vertices, faces and their number stay.
///
/// No move or flip turns a face over, makes a degenerate or duplicate face or an edge with more than two
/// faces, or lets the energy of its star rise. Where points that were not looked at say that the largest
/// distance rose nevertheless, vertices and diagonals go back, unless parameters.exchange is set. The
/// vertices of open borders move, too; the distance of the original's border to theirs is part of the energy.
/// Fixed vertices, edges between two of them and vertices on another number of open edges than two stay. The
/// bytes of the result do not depend on the number of threads.
///
/// \param original weights of the points: e^{2 l}, > 0
/// \param simplified in the same frame; flags mark border and fixed vertices. Moved vertices get
///        kMovedVertex. Corner lists are copied to get room for flips.
/// \param root a vertex of \p simplified for each of \p original, where the search for the closest face
///        begins: the vertex that it was collapsed to, or the nearest one; kNone for none
/// \pre both surfaces' arrays are consistent, coordinates finite
/// \throws Cancelled, std::bad_alloc; \p simplified is then still a valid surface
inline RefinementReport Refine(const SurfaceArrays& original, SurfaceArrays& simplified,
                               const Buffer<std::uint32_t>& root, const RefinementParameters& parameters = {})
{
    RefinementReport report;
    if (original.FaceCount() == 0 || simplified.FaceCount() == 0) return report;
    const int threads = ResolveThreads(parameters.threads);
    const auto reached = [&](int percent, int until, int loops = 1) {
        parameters.progress(percent, "Refining", until, loops);
    };
    const int begins = parameters.exchange ? 3 : 20; // when the samples are there
    reached(0, begins, 3);
    if (parameters.exchange)
        MakeRoomForCorners(simplified, kExchangeRoom);
    else if (parameters.flip)
        MakeRoomForCorners(simplified, kFlipRoom);
    RefinementState state = BeginRefinement(original, simplified, root, threads,
                                            parameters.exchange ? kFeatureShareOfBest : kFeatureShare);
    report.samples = state.samples.samples.size();
    report.rmsBefore = report.rmsAfter = std::sqrt(MeanSquare(state.samples));
    const double faceSize = FaceSize(simplified);
    if (!(report.rmsBefore > kFlatTilt * faceSize) &&
        !(std::sqrt(static_cast<double>(state.farthest2)) > kFlatDistance * faceSize))
        return report;

    if (parameters.exchange) {
        constexpr int kRoundsEnd = 97;
        const auto inRounds = [&](double way) {
            return begins + static_cast<int>(way * (kRoundsEnd - begins));
        };
        RefineInRounds(state, threads, report, [&](double way, double until, int loops) {
            reached(inRounds(way), inRounds(until), loops);
        });
        reached(kRoundsEnd, 100, 3);
        report.worst = ImproveWorstStars(state, TreeOf(original, threads), threads);
        report.renewed = PlacesOfRenewed(state);
        report.rmsAfter = std::sqrt(MeanSquare(state.samples));
        return report;
    }
    reached(begins, 32);
    RefineInPasses(state, parameters, threads, report, reached);
    return report;
}

} // namespace vcg_ext
