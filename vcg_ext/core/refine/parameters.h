// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/base/progress.h"

namespace vcg_ext
{

/// What a caller may choose.
struct RefinementParameters {
    int moveSweeps = 2;     ///< passes over the vertices, fewer where nothing is gained; 0: none
    bool flip = true;       ///< one pass of edge flips before the first move
    int threads = 1;        ///< 0: all; the result does not depend on it
    StageProgress progress; ///< called between two passes
};

/// What was gained; distances in the unit of the arrays.
struct RefinementReport {
    std::size_t samples = 0;
    double rmsBefore = 0; ///< of the samples of the original to the simplified surface, weighted
    double rmsAfter = 0;
    std::size_t flips = 0;
    std::size_t moves = 0;
    int sweeps = 0; ///< passes of moves that were run
};

// The constants below were chosen on the meshes of the benchmark, by the geometric mean of rms, feature rms
// and Hausdorff distance against a peer; docs/refinement.md, "What was tried", has the alternatives. "rms" is
// the root of the weighted mean squared distance of the samples before the first change.

// The energy: weight x squared distance, summed over samples of both surfaces

/// Samples of the original for each simplified face; centroids are thinned towards it. 16 gain nothing.
constexpr float kSamplesPerFace = 8;
/// Of the original's area on its vertices, the rest is on face centroids.
constexpr float kVertexShare = 0.6F;
/// Of a point of the simplified surface against one of the original. A quarter lowers the rms at features by
/// 8 % and raises the rms by 2 %; 1 is worse nearly everywhere.
constexpr float kBackwardWeight = 0.5F;
/// Of the star's area on the vertex that moves, on the midpoints of its edges and on the centroids of its
/// faces.
constexpr float kBackwardVertexShare = 0.15F, kBackwardEdgeShare = 0.35F, kBackwardCentroidShare = 0.5F;
/// Of both faces' area on the midpoint of an edge that is flipped, and on their centroids.
constexpr float kFlippedEdgeShare = 0.4F, kFlippedCentroidShare = 0.6F;
/// Squared distances backward before a change count at most this many times the larger of rms^2 and the
/// largest squared distance forward: a walk that got stuck must not pay for a spike.
constexpr float kBackwardOutlier = 16;
/// x rms; what is farther must not get farther still. Below 4 all distances are worse, above it the Hausdorff
/// distance of technical parts is.
constexpr float kTolerableDistance = 4;

// Moves

/// Of the mean diagonal entry, added to the normal equations. .03 has a larger rms.
constexpr float kStepRegularization = 0.01F;
/// A step is not longer than this x the shortest edge at the vertex.
constexpr float kMaxStep = 1;
/// Lengths of a step that are tried, each half the one before.
constexpr int kStepTrials = 2;
/// A move must save this part of its star's energy, and this part of rms^2 x the weight of its samples. With
/// half of both there are more moves and the same error.
constexpr float kMinMoveGain = 0.001F, kMinMoveGainOfMean = 0.02F;
/// Cosine between a face's normal before and after a change: 73 degrees.
constexpr float kMinTurnCosine = 0.3F;
/// Double area / longest edge^2; a worse face may lose half of its quality.
constexpr float kMinMoveQuality = 0.1F;

// Flips

/// As the two of a move, of the energy of both faces.
constexpr float kMinFlipGain = 0.02F, kMinFlipGainOfMean = 0.05F;
/// As kMinMoveQuality; worse only where a face was worse before.
constexpr float kMinFlipQuality = 0.05F;
/// Cosine of the angle between the new normals; less only if it was less before.
constexpr float kMinFoldCosine = -0.2F;

/// Vertices that one thread works on at a time: few enough to share the work evenly, many enough that few
/// vertices lie between two blocks. The result depends on it.
constexpr std::uint32_t kBlockVertices = 2048;

} // namespace vcg_ext
