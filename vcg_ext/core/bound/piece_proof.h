// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/geometry/vector.h"
#include "vcg_ext/core/measure/exact_surface.h"

namespace vcg_ext
{

/// Proves that whole triangles lie within a distance of a surface, or finds a point that does not. All in
/// double precision, in the frame of the surface.
///
/// A convex piece is proven where all of its corners are within the limit of the same face, because the
/// distance to a convex set is a convex function; or where it lies in a ball about a point that is close
/// enough. Other pieces are cut: where the nearest face of a corner ends, by the plane through that edge
/// perpendicular to the face, and where no such plane helps in the middle of their longest side.
class PieceProof
{
    static constexpr std::size_t kMaxCorners = 8; ///< more are cut in two
    static constexpr std::size_t kMaxPieces = 20000;

    struct PieceCorner {
        Vector3<double> position;
        std::uint32_t face = 0; ///< of the surface, within the limit
        double distance2 = 0;
    };
    using Piece = std::vector<PieceCorner>;
    struct Plane {
        Vector3<double> normal;
        double offset;
        double Height(const Vector3<double>& p) const { return Dot(normal, p) - offset; }
    };
    enum class Outcome { Proven, Refuted, Cut };

    const ExactSurface& surface_;
    double limit_, limit2_;
    ExactSurface::Search search_;
    std::vector<Piece> pieces_;
    Vector3<double> counterexample_{};
    double reached2_ = 0;

  public:
    enum class Result { Proven, Refuted, GaveUp };

    /// \param surface outlives this object \param limit in its frame
    PieceProof(const ExactSurface& surface, double limit)
        : surface_(surface), limit_(limit), limit2_(limit * limit)
    {
    }

    /// \param hints a face of the surface that may be close to each corner, or kNone \param hint to all of
    /// them
    Result Prove(const std::array<Vector3<double>, 3>& triangle,
                 const std::array<std::uint32_t, 3>& hints = {kNone, kNone, kNone},
                 std::uint32_t hint = kNone)
    {
        if (hint != kNone && CoversAll(hint, triangle)) return Result::Proven;
        for (std::size_t k = 0; k < 3; ++k)
            if (hints[k] != kNone && CoversAll(hints[k], triangle)) return Result::Proven;
        Piece piece(3);
        for (std::size_t k = 0; k < 3; ++k) {
            if (hints[k] != kNone && IsWithin(hints[k], triangle[k], piece[k])) continue;
            if (hints[k] != kNone) search_.last = hints[k];
            if (!FindCorner(triangle[k], piece[k])) return Result::Refuted;
        }
        pieces_.clear();
        pieces_.push_back(std::move(piece));
        for (std::size_t count = 0; !pieces_.empty(); ++count) {
            if (count == kMaxPieces) {
                counterexample_ = pieces_.back().front().position;
                return Result::GaveUp;
            }
            piece = std::move(pieces_.back());
            pieces_.pop_back();
            if (Settle(piece) == Outcome::Refuted) return Result::Refuted;
        }
        return Result::Proven;
    }

    /// After Refuted: a point of the triangle that is farther than the limit. After GaveUp: one in the part
    /// that is not proven.
    const Vector3<double>& Counterexample() const { return counterexample_; }
    /// Nothing of what was proven is farther from the surface.
    double Reached() const { return std::sqrt(reached2_); }

  private:
    bool CoversAll(std::uint32_t face, const std::array<Vector3<double>, 3>& triangle)
    {
        double farthest2 = 0;
        for (const Vector3<double>& corner : triangle) {
            farthest2 = std::max(farthest2, surface_.Distance2ToFace(face, corner));
            if (!(farthest2 <= limit2_)) return false;
        }
        reached2_ = std::max(reached2_, farthest2);
        return true;
    }
    bool IsWithin(std::uint32_t face, const Vector3<double>& p, PieceCorner& corner) const
    {
        const double distance2 = surface_.Distance2ToFace(face, p);
        if (!(distance2 <= limit2_)) return false;
        corner = {p, face, distance2};
        return true;
    }
    /// The closest face.
    bool FindCorner(const Vector3<double>& p, PieceCorner& corner)
    {
        const auto distance2 = surface_.Distance2Within(p, limit2_, search_);
        if (!distance2) {
            counterexample_ = p;
            return false;
        }
        corner = {p, *search_.last, *distance2};
        return true;
    }

    Outcome Settle(const Piece& piece)
    {
        if (IsNearOneFace(piece)) return Outcome::Proven;
        Vector3<double> center{};
        for (const PieceCorner& corner : piece)
            center = center + (1.0 / static_cast<double>(piece.size())) * corner.position;
        double radius2 = 0;
        for (const PieceCorner& corner : piece)
            radius2 = std::max(radius2, SquaredNorm(corner.position - center));
        const double radius = std::sqrt(radius2);
        if (radius < limit_) {
            const Outcome outcome = SettleByBall(piece, center, radius);
            if (outcome != Outcome::Cut) return outcome;
        }
        return Cut(piece, ChoosePlane(piece, radius)) ? Outcome::Cut : Outcome::Refuted;
    }

    bool IsNearOneFace(const Piece& piece)
    {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const std::uint32_t face = piece[i].face;
            const auto isSame = [&](const PieceCorner& c) { return c.face == face; };
            const auto end = piece.begin() + static_cast<std::ptrdiff_t>(i);
            if (std::any_of(piece.begin(), end, isSame)) continue;
            double farthest2 = 0;
            for (const PieceCorner& corner : piece) {
                farthest2 = std::max(farthest2, corner.face == face
                                                    ? corner.distance2
                                                    : surface_.Distance2ToFace(face, corner.position));
                if (!(farthest2 <= limit2_)) break;
            }
            if (!(farthest2 <= limit2_)) continue;
            reached2_ = std::max(reached2_, farthest2);
            return true;
        }
        return false;
    }

    Outcome SettleByBall(const Piece& piece, const Vector3<double>& center, double radius)
    {
        const auto isEnough = [&](double distance2) {
            const double reach = std::sqrt(distance2) + radius;
            if (!(reach <= limit_)) return false;
            reached2_ = std::max(reached2_, reach * reach);
            return true;
        };
        for (const PieceCorner& corner : piece)
            if (isEnough(surface_.Distance2ToFace(corner.face, center))) return Outcome::Proven;
        if (radius >= 0.5 * limit_) return Outcome::Cut;
        PieceCorner middle;
        search_.last = piece.front().face;
        if (!FindCorner(center, middle)) return Outcome::Refuted;
        return isEnough(middle.distance2) ? Outcome::Proven : Outcome::Cut;
    }

    /// The plane at which a corner's face ends that leaves most of the piece on both sides.
    Plane ChoosePlane(const Piece& piece, double radius) const
    {
        constexpr double kRounding = 1e-9, kLeastShare = 0.02; // of the radius
        Plane best{};
        double widest = 0;
        for (const PieceCorner& corner : piece)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector3<double> a = surface_.Corner(corner.face, k);
                const Vector3<double> edge = surface_.Corner(corner.face, (k + 1) % 3) - a;
                const Vector3<double> outwards = Cross(edge, surface_.AreaVector(corner.face));
                const double length = Norm(outwards);
                if (!(length > 0)) continue;
                Plane plane{(1 / length) * outwards, 0};
                plane.offset = Dot(plane.normal, a);
                if (plane.Height(corner.position) > kRounding * radius) continue;
                double above = 0, below = 0;
                for (const PieceCorner& c : piece) {
                    above = std::max(above, plane.Height(c.position));
                    below = std::max(below, -plane.Height(c.position));
                }
                if (std::min(above, below) <= widest) continue;
                widest = std::min(above, below);
                best = plane;
            }
        return widest >= kLeastShare * radius ? best : Bisector(piece);
    }
    static Plane Bisector(const Piece& piece)
    {
        Vector3<double> longest{}, middle{};
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (std::size_t j = i + 1; j < piece.size(); ++j) {
                const Vector3<double> side = piece[j].position - piece[i].position;
                if (SquaredNorm(side) <= SquaredNorm(longest)) continue;
                longest = side;
                middle = 0.5 * (piece[i].position + piece[j].position);
            }
        return {longest, Dot(longest, middle)};
    }

    /// Puts both parts of the piece on the stack. \return false if a new corner is beyond the limit
    bool Cut(const Piece& piece, const Plane& plane)
    {
        Piece below, above;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const PieceCorner &here = piece[i], &next = piece[(i + 1) % piece.size()];
            const double h = plane.Height(here.position), g = plane.Height(next.position);
            if (h <= 0) below.push_back(here);
            if (h >= 0) above.push_back(here);
            if (!((h < 0 && g > 0) || (h > 0 && g < 0))) continue;
            const double t = h / (h - g);
            PieceCorner cut;
            search_.last = t < 0.5 ? here.face : next.face;
            if (!FindCorner(here.position + t * (next.position - here.position), cut)) return false;
            below.push_back(cut);
            above.push_back(cut);
        }
        Push(std::move(below));
        Push(std::move(above));
        return true;
    }
    void Push(Piece piece)
    {
        if (piece.size() > kMaxCorners) {
            const auto middle = piece.begin() + static_cast<std::ptrdiff_t>(piece.size() / 2);
            Piece rest(middle, piece.end());
            rest.push_back(piece.front());
            piece.erase(middle + 1, piece.end());
            pieces_.push_back(std::move(rest));
        }
        if (piece.size() > 2) pieces_.push_back(std::move(piece)); // less is part of what was cut off
    }
};

} // namespace vcg_ext
