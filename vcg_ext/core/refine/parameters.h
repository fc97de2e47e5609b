// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/progress.h"

namespace vcg_ext
{

/// What a caller may choose.
struct RefinementParameters {
    int moveSweeps = 2;     ///< passes over the vertices, fewer where nothing is gained; 0: none
    bool flip = true;       ///< one pass of edge flips before the first move
    bool exchange = false;  ///< rounds of exchanges, flips and moves instead, and a pass over the worst stars
    int threads = 1;        ///< 0: all; the result does not depend on it
    StageProgress progress; ///< called between two passes
};

/// A vertex or face of the simplified surface that an exchange has put to another place, and a place of the
/// original near it, or kNone.
struct RenewedPlace {
    std::uint32_t element;
    std::uint32_t place; ///< SurfacePlace
};
struct RenewedPlaces {
    std::vector<RenewedPlace> vertices, faces; ///< ascending
};

/// What was gained; distances in the unit of the arrays.
struct RefinementReport {
    std::size_t samples = 0;
    double rmsBefore = 0; ///< of the samples of the original to the simplified surface, weighted
    double rmsAfter = 0;  ///< the same after all moves and flips, before the check takes any of them back
    std::size_t exchanges = 0;
    std::size_t flips = 0;
    std::size_t moves = 0;
    std::size_t worst = 0;     ///< moves of the last pass
    std::size_t takenBack = 0; ///< vertices and diagonals that the check at the end has put back
    RenewedPlaces renewed;
    int sweeps = 0; ///< passes of moves that were run
};

// The constants below were chosen on bunny, cow, elephant, fandisk, rocker arm, screwdriver and block, by the
// geometric means of rms, feature rms and Hausdorff distance; docs/refinement.md, "What was tried", has the
// alternatives. "rms" is
// the root of the weighted mean squared distance of the samples before the first change.

// The energy: weight x squared distance, summed over samples of both surfaces

/// Samples of the original for each simplified face; centroids are thinned towards it. 16 gain nothing.
constexpr float kSamplesPerFace = 8;
/// Where all centroids make fewer for each simplified face, the midpoints of edges are samples too: three of
/// them are fitted better than the surface between them.
constexpr float kMinSamplesPerFace = 4;
/// Which part of a face's area is on its corners, on the midpoints of its edges and on its centroid. The sum
/// is 1.
struct SampleShares {
    float vertices, midpoints, centroids;
};
/// Without midpoints the squared distance is integrated exactly where the distance is linear over the face.
constexpr SampleShares kShares{0.25F, 0, 0.75F}, kSharesWithMidpoints{0.15F, 0.4F, 0.45F};
/// What a vertex has beside its share, as part of its area, where its descriptor is at least that which this
/// quantile of the vertices has; below, it falls with the square. Without it the rms at features is 17 %
/// larger; .3 lowers the rms by .6 % and raises that at features by 5 %.
constexpr float kFeatureShare = 0.5F;
/// The same with exchanges, which hold features by themselves: .5 has .7 % more rms and 6 % less at features.
constexpr float kFeatureShareOfBest = 0.3F;
constexpr double kFeatureQuantile = 0.9;
/// x rms; what is farther is attached by a search over all faces. Walks that end on the wrong sheet are few,
/// but a sample there hides how far the surface is, and drags it along.
constexpr float kFarSample = 3;
/// Of a point of the simplified surface against one of the original. A quarter lowers the rms at features by
/// 8 % and raises the rms by 2 %; 1 is worse nearly everywhere.
constexpr float kBackwardWeight = 0.5F;
/// Of the star's area on the vertex that moves, on the midpoints of its edges and on the centroids of its
/// faces.
constexpr float kBackwardVertexShare = 0.15F, kBackwardEdgeShare = 0.35F, kBackwardCentroidShare = 0.5F;
/// Of both faces' area on the midpoint of an edge that is flipped, and on their centroids.
constexpr float kFlippedEdgeShare = 0.4F, kFlippedCentroidShare = 0.6F;
/// Of a sample of the original's border, beside its length x that of the border edge it is attached to.
constexpr float kBorderWeight = 0.5F;
/// x rms^2; where the original's border is nearer than that, squared, to the simplified one, or to a plane
/// through it, that counts as straight, or flat, and stays so.
constexpr float kStraightBorder = 1e-4F;
/// Border edges that a walk passes in each direction.
constexpr std::size_t kMaxBorderWalk = 12;
/// Squared distances backward before a change count at most this many times the larger of rms^2 and the
/// largest squared distance forward: a walk that got stuck must not pay for a spike.
constexpr float kBackwardOutlier = 16;
/// x rms; what is farther must not get farther still. Below 4 all distances are worse; 8 gains nothing.
constexpr float kTolerableDistance = 6;
/// x the distance of the farthest sample: the same.
constexpr float kTolerableOfFarthest = 0.9F;

// Moves

/// x the star's energy / its mean squared spoke, added to the diagonal of the normal equations: what pulls a
/// vertex along the surface is of that order, whatever the size of the faces. 1 and 4 do the same, 8 is
/// worse.
constexpr float kStepRegularization = 2;
/// At most and at least, of the mean and the sum of the diagonal's entries. Alone, the first is too much for
/// small faces.
constexpr float kMaxRegularization = 0.01F, kMinRegularization = 1e-5F;
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
constexpr float kMinMoveQuality = 0.02F; // the best faces of cylinders are long

// Flips

/// As the two of a move, of the energy of both faces.
constexpr float kMinFlipGain = 0.02F, kMinFlipGainOfMean = 0.05F;
/// As kMinMoveQuality; worse only where a face was worse before.
constexpr float kMinFlipQuality = 0.01F;
/// Cosine of the angle between the new normals; less only if it was less before.
constexpr float kMinFoldCosine = -0.2F;

// Exchanges: an edge collapses where that costs least, and pays for a new vertex where that gains most

/// Rounds of [exchanges; flips; two passes of moves]; exchanges are in the first ones only. Four rounds of
/// them gain 3.6 %, six nearly all of the 3.8 % of twelve.
constexpr int kRounds = 8, kExchangeRounds = 6;
/// A round that lowers the mean squared distance by less than this part is the last one.
constexpr double kMinRoundGain = 0.006;
/// x what flips and moves must gain, after each round.
constexpr float kGainDecay = 0.7F;
/// The part of the edges that is measured as a collapse, and as a place for a new vertex; a quarter takes
/// four times as long and gains nothing.
constexpr double kMeasuredEdges = 0.06;
/// The new vertex must gain this x what the collapse costs, in energy of the samples; moves earn the rest. .8
/// to 1.05 do the same.
constexpr float kMinExchangeRatio = 0.9F;
/// Exchanges in one round, as part of the vertices.
constexpr double kMaxExchanges = 0.05;
/// Faces around an edge that may collapse: measuring takes the square of their number.
constexpr std::size_t kMaxFanFaces = 24;
/// As kMinMoveQuality, for every face that an exchange makes.
constexpr float kMinExchangeQuality = 0.01F;
/// Squared distances backward of an exchange, by weight, may be this many times those of the samples before
/// and after: a spike shows there.
constexpr double kMaxBackwardRatio = 3;
/// Steps from the minimum of the planes; and what pulls that to the middle of the edge, of the mean of the
/// diagonal.
constexpr int kFitSteps = 2;
constexpr float kPlaneRegularization = 1e-3F;
/// In flips between exchanges: x rms^2 x the weight of both faces' samples, for each unit that the sum of
/// (faces - 6)^2 over the four vertices rises. It falls as the gains do and is 0 in the last rounds.
constexpr float kValenceWeight = 0.05F;
constexpr int kRoundsWithoutValence = 2;
/// Corners that a vertex may gain by flips and exchanges.
constexpr std::uint32_t kExchangeRoom = 8;

// The last pass: the stars with the largest distances

/// Stars that are tried, as part of the vertices, and in how many turns. A tenth gains some 8 % more in the
/// largest distance and costs up to 3 % of the rms.
constexpr double kWorstStars = 0.02;
constexpr int kWorstTurns = 16;
/// x rms; stars nearer than this are good enough.
constexpr float kWorstDistance = 2;
/// By how much the largest distance must fall, and how much the star's energy may rise: of itself, and of
/// rms^2 x the weight of its samples.
constexpr float kMinWorstGain = 0.005F;
constexpr double kWorstPrice = 0.03;
/// A step is this part of what would bring the farthest point to the other surface; it is halved until it is
/// shorter than the second part of it.
constexpr float kWorstStep = 0.5F, kSmallestWorstStep = 0.025F;
constexpr int kWorstTrials = 12;
/// Squared distances backward of more than this x the larger of rms^2 and the largest one forward are
/// searched for among all faces of the original: a walk can end at a hole or in a fold.
constexpr float kDoubtful = 2;

// The check by points that no pass has looked at

/// Steps along an edge from one such point to the next.
constexpr int kHeldOutGrid = 8;
/// x the limit; points may be farther than that where one of a few, or a sample, is farther than this.
constexpr float kSuspect = 0.5F, kSuspectSample = 0.33F;
/// What goes back can make its neighbours worse.
constexpr int kTakeBackRounds = 8;

/// Vertices that one thread works on at a time: few enough to share the work evenly, many enough that few
/// vertices lie between two blocks. The result depends on it.
constexpr std::uint32_t kBlockVertices = 2048;

} // namespace vcg_ext
