// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/bound/piece_proof.h"
#include "vcg_ext/core/measure/exact_surface.h"

namespace vcg_ext
{

/// A place where a surface is farther from another than a bound, or not proven to be closer.
struct Counterexample {
    std::uint32_t face;
    Vector3<double> point; ///< of the face, in the frame
};

/// What is known of the faces of one surface.
struct OneWayCertificate {
    std::vector<Counterexample> counterexamples; ///< one of each face that failed, in the order asked
    double reached = 0;                          ///< the others are no farther, in the frame

    bool Proven() const { return counterexamples.empty(); }
};

/// Is every point of the faces of \p from within \p limit of \p to? Proven over whole triangles, in double
/// precision, up to its rounding.
/// \param faceCount how many faces are asked about \param faceAt faceAt(i), the i-th of them
/// \param hintAt hintAt(face, k): a face of \p to that may be close to the k-th corner, with k = 3 to
///        the whole face, or kNone
template <class FaceAt, class HintAt>
OneWayCertificate CertifyFaces(const ExactSurface& from, const ExactSurface& to, double limit,
                               std::size_t faceCount, const FaceAt& faceAt, const HintAt& hintAt, int threads)
{
    constexpr std::size_t kGrain = 1024;
    std::vector<OneWayCertificate> parts((faceCount + kGrain - 1) / kGrain);
    ParallelRanges(threads, faceCount, kGrain, [&](std::size_t begin, std::size_t end, int) {
        OneWayCertificate& part = parts[begin / kGrain];
        PieceProof proof(to, limit);
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t face = faceAt(i);
            const auto result =
                proof.Prove({from.Corner(face, 0), from.Corner(face, 1), from.Corner(face, 2)},
                            {hintAt(face, 0), hintAt(face, 1), hintAt(face, 2)}, hintAt(face, 3));
            if (result != PieceProof::Result::Proven)
                part.counterexamples.push_back({face, proof.Counterexample()});
        }
        part.reached = proof.Reached();
    });
    OneWayCertificate all;
    for (const OneWayCertificate& part : parts) { // in this order, whatever the threads
        all.counterexamples.insert(all.counterexamples.end(), part.counterexamples.begin(),
                                   part.counterexamples.end());
        all.reached = std::max(all.reached, part.reached);
    }
    return all;
}

} // namespace vcg_ext
