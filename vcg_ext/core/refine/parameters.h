// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/mesh/decimation_types.h"

namespace vcg_ext
{

/// Constants of the refinement. The defaults are measured (docs/refinement.md); "rms" is the root of the
/// weighted mean squared distance of the samples before the first change.
struct RefinementParameters {
    int moveSweeps = 2; ///< passes over the vertices, fewer where nothing is gained; 0: none
    bool flip = true;   ///< one pass of edge flips before the first move

    // The energy: weight x squared distance, summed over samples of both surfaces.
    float samplesPerFace = 8;          ///< of the simplified surface; centroids are thinned towards it, > 0
    float vertexShare = 0.6F;          ///< of the original's area on its vertices, the rest on face centroids
    float backwardWeight = 0.5F;       ///< of a point of the simplified surface against one of the original
    float backwardVertex = 0.15F;      ///< of a face's area on the vertex that moves ...
    float backwardEdge = 0.35F;        ///< ... on the midpoints of its edges ...
    float backwardCentroid = 0.5F;     ///< ... and on the face centroids of its star
    float backwardFlippedEdge = 0.4F;  ///< of both faces' area on the midpoint of the edge between them ...
    float backwardFlippedFaces = 0.6F; ///< ... and on their centroids
    float backwardOutlier = 16;        ///< old squared distances backward count at most this many times the
                                       ///< larger of rms^2 and the largest forward one: a walk that got
                                       ///< stuck must not pay for a spike
    float tolerableDistance = 4;       ///< x rms; what is farther must not get farther still

    // Moves
    float regularisation = 0.01F; ///< of the mean diagonal entry, added to the normal equations
    float largestStep = 1;        ///< x the shortest edge at the vertex
    int trials = 2;               ///< lengths tried, each half the one before
    float moveGain = 0.001F;      ///< part of the star's energy that a move must save ...
    float moveGainOfMean = 0.02F; ///< ... and part of rms^2 x weight of the star's samples
    float smallestCosine = 0.3F;  ///< between a face's normal before and after
    float moveQuality = 0.1F;     ///< double area / longest edge^2; a worse face may lose half of its quality

    // Flips
    float flipGain = 0.02F;       ///< as moveGain, of the two faces' energy
    float flipGainOfMean = 0.05F; ///< as moveGainOfMean
    float flipQuality = 0.05F;    ///< as moveQuality; worse only where a face was worse before
    float sharpestFold = -0.2F;   ///< cosine of the angle between the new normals; less only if it was less

    std::uint32_t blockVertices =
        2048;               ///< vertices that one thread treats at a time; the result depends on it
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

} // namespace vcg_ext
