// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/bound/certificate.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/geometry/box.h"
#include "vcg_ext/core/measure/exact_surface.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/mesh/face_tree.h"

namespace vcg_ext
{

/// Both directions of the certificate, and what it says of a result.
struct BoundCertificate {
    OneWayCertificate ofOriginal, ofResult;

    bool Proven() const { return ofOriginal.Proven() && ofResult.Proven(); }
    double Reached() const { return std::max(ofOriginal.reached, ofResult.reached); }
};

/// Sees to it that a result stays within a bound of its original: certifies it, learns from what fails for
/// the next run, and takes back moves that a later stage has made.
///
/// Faces that name a vertex twice are no part of a surface.
class BoundKeeper
{
    const MeshView& original_;
    int threads_;
    std::vector<std::uint32_t> faces_;            ///< of the original that count
    std::vector<std::uint32_t> coveredBy_;        ///< as CollapsedSurface's
    std::optional<BoundCertificate> certificate_; ///< of what was accepted last
    std::vector<std::uint32_t> resultFaceOf_;     ///< the result's face that each input face became, or kNone

  public:
    BoundTask task;

    /// \param percent the bound, of the diagonal of the original's box \pre the view outlives this object
    BoundKeeper(const MeshView& original, double percent, int threads)
        : original_(original), threads_(threads)
    {
        task.bound = percent / 100 * kFrameDiagonal;
        for (std::uint32_t f = 0; f < original.faceCount; ++f) {
            const std::uint32_t* t = original.triangles + 3 * std::size_t{f};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) faces_.push_back(f);
        }
    }

    const FaceTree& Tree() const { return *task.tree; }

    /// Does what a collapse left keep the bound? If not, the next run will be more careful where it failed.
    /// \param coveredBy as CollapsedSurface's
    bool Accepts(std::vector<std::uint32_t> coveredBy, const DecimatedMesh& mesh)
    {
        if (mesh.triangles.empty()) return true;
        coveredBy_ = std::move(coveredBy);
        resultFaceOf_.assign(original_.faceCount, kNone);
        for (std::uint32_t f = 0; f < mesh.faceOrigin.size(); ++f) resultFaceOf_[mesh.faceOrigin[f]] = f;
        certificate_ = Certify(mesh);
        if (certificate_->Proven()) return true;
        Learn(*certificate_, mesh);
        return false;
    }

    /// What is proven of the result, in percent of the original's diagonal.
    std::optional<double> CertifiedError() const
    {
        if (!certificate_ || !certificate_->Proven()) return std::nullopt;
        return 100 / kFrameDiagonal * certificate_->Reached();
    }

    /// Takes vertices of \p moved back to where \p before had them until the bound holds again.
    /// \pre both have the same faces; \p before was accepted
    void TakeBack(DecimatedMesh& moved, const DecimatedMesh& before)
    {
        constexpr int kTakeBackRounds = 12;
        if (!certificate_->Proven()) return;
        BoundCertificate certificate = Certify(moved);
        for (int round = 0; round < kTakeBackRounds && !certificate.Proven(); ++round) {
            std::vector<std::uint32_t> back = CausesOf(certificate, moved, before);
            const auto stayed = [&](std::uint32_t v) { return moved.positions[v] == before.positions[v]; };
            back.erase(std::remove_if(back.begin(), back.end(), stayed), back.end());
            if (back.empty()) break;
            certificate = Recertify(moved, before, back, certificate.Reached());
        }
        if (certificate.Proven())
            certificate_ = certificate;
        else
            moved = before;
    }

    /// The same all or nothing, where faces may have changed their corners too.
    void TakeBackAll(DecimatedMesh& changed, const DecimatedMesh& before)
    {
        if (!certificate_->Proven() ||
            (changed.positions == before.positions && changed.triangles == before.triangles))
            return;
        const BoundCertificate certificate = Certify(changed);
        if (certificate.Proven())
            certificate_ = certificate;
        else
            changed = before;
    }

  private:
    /// Is the whole of both surfaces within the bound?
    BoundCertificate Certify(const DecimatedMesh& mesh) const
    {
        std::vector<std::uint32_t> all(mesh.triangles.size());
        for (std::uint32_t f = 0; f < all.size(); ++f) all[f] = f;
        return Certify(mesh, faces_, all);
    }

    /// Marks where the certificate failed.
    void Learn(const BoundCertificate& certificate, const DecimatedMesh& mesh)
    {
        const ExactSurface surface(original_, Tree(), 0);
        if (task.strictVertices.empty()) task.strictVertices.assign(original_.vertexCount, 0);
        for (const Counterexample& failed : certificate.ofOriginal.counterexamples) {
            const std::uint32_t f = failed.face;
            MarkFace(f);
            task.strictPoints.push_back({failed.point, f});
            task.strictPoints.push_back(
                {(1.0 / 3) * (surface.Corner(f, 0) + surface.Corner(f, 1) + surface.Corner(f, 2)), f});
        }
        std::vector<std::uint8_t> isBad(original_.faceCount, 0);
        for (const Counterexample& failed : certificate.ofResult.counterexamples) {
            isBad[mesh.faceOrigin[failed.face]] = 1;
            for (const std::uint32_t v : mesh.triangles[failed.face])
                task.strictVertices[mesh.vertexOrigin[v]] = 1;
            ExactSurface::Search search;
            surface.Distance2(failed.point, search);
            MarkFace(*search.last);
        }
        for (std::size_t v = 0; v < coveredBy_.size(); ++v)
            if (coveredBy_[v] != kNone && isBad[coveredBy_[v]]) task.strictVertices[v] = 1;
    }

    BoundCertificate Certify(const DecimatedMesh& mesh, const std::vector<std::uint32_t>& originalFaces,
                             const std::vector<std::uint32_t>& resultFaces) const
    {
        std::vector<std::uint8_t> fixed;
        const MeshView view = ViewOf(mesh, original_, fixed);
        const FaceTree resultTree(view, Tree().frame(), threads_);
        const float slack = RoundingOf(original_, view, Tree().frame());
        const ExactSurface original(original_, Tree(), slack), result(view, resultTree, slack);
        const auto coverOf = [&](std::uint32_t face, std::size_t k) {
            if (k == 3) return resultFaceOf_[face]; // what has not changed is where it was
            const std::uint32_t origin = coveredBy_[original_.triangles[3 * std::size_t{face} + k]];
            return origin == kNone ? kNone : resultFaceOf_[origin];
        };
        const auto originOf = [&](std::uint32_t face, std::size_t) { return mesh.faceOrigin[face]; };
        BoundCertificate certificate;
        certificate.ofOriginal = CertifyFaces(
            original, result, task.bound, originalFaces.size(),
            [&](std::size_t i) { return originalFaces[i]; }, coverOf, threads_);
        certificate.ofResult = CertifyFaces(
            result, original, task.bound, resultFaces.size(), [&](std::size_t i) { return resultFaces[i]; },
            originOf, threads_);
        return certificate;
    }

    void MarkFace(std::uint32_t face)
    {
        for (std::size_t k = 0; k < 3; ++k)
            task.strictVertices[original_.triangles[3 * std::size_t{face} + k]] = 1;
    }
    /// The vertices whose moves may be to blame: of the faces that stray, and of those that covered what is
    /// no longer covered.
    std::vector<std::uint32_t> CausesOf(const BoundCertificate& certificate, const DecimatedMesh& moved,
                                        const DecimatedMesh& before) const
    {
        std::vector<std::uint32_t> causes;
        const auto addFace = [&](std::uint32_t f) {
            causes.insert(causes.end(), moved.triangles[f].begin(), moved.triangles[f].end());
        };
        for (const Counterexample& failed : certificate.ofResult.counterexamples) addFace(failed.face);
        if (!certificate.ofOriginal.Proven()) {
            std::vector<std::uint8_t> fixed;
            const MeshView view = ViewOf(before, original_, fixed);
            const FaceTree tree(view, Tree().frame(), threads_);
            const ExactSurface surface(view, tree, 0);
            const double limit2 = task.bound * task.bound;
            for (const Counterexample& failed : certificate.ofOriginal.counterexamples) {
                const Vector3<float> point{static_cast<float>(failed.point.x),
                                           static_cast<float>(failed.point.y),
                                           static_cast<float>(failed.point.z)};
                const float reach2 = static_cast<float>(limit2 * 1.001 + 1e-6);
                tree.ForEachInReach(point, reach2, [&](std::uint32_t face) {
                    if (surface.Distance2ToFace(face, failed.point) <= limit2) addFace(face);
                    return reach2;
                });
            }
        }
        std::sort(causes.begin(), causes.end());
        causes.erase(std::unique(causes.begin(), causes.end()), causes.end());
        return causes;
    }

    /// Takes the vertices \p back and certifies what that may have changed.
    BoundCertificate Recertify(DecimatedMesh& moved, const DecimatedMesh& before,
                               const std::vector<std::uint32_t>& back, double reached) const
    {
        const Frame& frame = Tree().frame();
        std::vector<std::uint8_t> isBack(moved.positions.size(), 0);
        for (const std::uint32_t v : back) isBack[v] = 1;
        std::vector<std::uint32_t> faces, originalFaces;
        for (std::uint32_t f = 0; f < moved.triangles.size(); ++f) {
            const auto& t = moved.triangles[f];
            if (!isBack[t[0]] && !isBack[t[1]] && !isBack[t[2]]) continue;
            faces.push_back(f);
            Box3<float> box = EmptyBox<float>();
            for (const std::uint32_t v : t) {
                box.Add(frame.Into(moved.positions[v]));
                box.Add(frame.Into(before.positions[v]));
            }
            box.Grow(static_cast<float>(task.bound * 1.001 + 1e-3));
            Tree().ForEachNear(box,
                               [&](std::uint32_t face, const auto&...) { originalFaces.push_back(face); });
        }
        for (const std::uint32_t v : back) moved.positions[v] = before.positions[v];
        std::sort(originalFaces.begin(), originalFaces.end());
        originalFaces.erase(std::unique(originalFaces.begin(), originalFaces.end()), originalFaces.end());
        BoundCertificate certificate = Certify(moved, originalFaces, faces);
        certificate.ofResult.reached = std::max(certificate.ofResult.reached, reached);
        return certificate;
    }
};

} // namespace vcg_ext
