// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/core/mesh/edge_flip.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/refine/energy.h"
#include "vcg_ext/core/refine/fan.h"
#include "vcg_ext/core/refine/parameters.h"

namespace vcg_ext
{

/// An edge that may collapse, or get a vertex, and what that changes.
struct ExchangeOffer {
    float energy;       ///< of the samples: what the collapse costs, or minus what the new vertex gains
    std::uint32_t a, b; ///< the ends of the edge
    Vector3<float> x;   ///< the vertex that is left or made, seen from the middle of the edge
    bool stands = true; ///< false: it may not be

    bool HasEdgeBefore(const ExchangeOffer& other) const { return a != other.a ? a < other.a : b < other.b; }
    bool IsBetterThan(const ExchangeOffer& other) const
    {
        return energy < other.energy || (!(other.energy < energy) && HasEdgeBefore(other));
    }
};

/// What a collapse leaves unused, for a new vertex.
struct FreedSlots {
    std::uint32_t vertex = kNone;
    std::array<std::uint32_t, 2> faces{kNone, kNone};
};

/// Collapses an edge into a vertex, or puts a vertex on an edge, where that is allowed. Border and fixed
/// vertices do not collapse, and no edge between two fixed vertices is divided.
/// One object per thread; it holds nothing but scratch between two calls.
class VertexExchanger
{
    RefinementState& state_;
    Fan fan_;
    Scratch<std::uint32_t> ringA_, ringB_;

  public:
    explicit VertexExchanger(RefinementState& state) : state_(state), fan_(state) {}

    /// What collapsing the edge costs, with the vertex where the samples want it.
    ExchangeOffer OfferCollapse(std::uint32_t a, std::uint32_t b)
    {
        if (!GatherCollapse(a, b)) return {0, a, b, {}, false};
        return Offer(a, b, fan_.PlaneMinimum());
    }
    /// What a new vertex on the edge gains.
    ExchangeOffer OfferDivision(std::uint32_t a, std::uint32_t b)
    {
        if (!GatherDivision(a, b)) return {0, a, b, {}, false};
        return Offer(a, b, Vector3<float>{});
    }
    /// The same as things are now, with all limits.
    ExchangeOffer ConfirmCollapse(const ExchangeOffer& offer)
    {
        return WithinDistances(OfferCollapse(offer.a, offer.b));
    }
    ExchangeOffer ConfirmDivision(const ExchangeOffer& offer)
    {
        return WithinDistances(OfferDivision(offer.a, offer.b));
    }

    /// \pre the offer is confirmed, and nothing near has changed since
    FreedSlots Collapse(const ExchangeOffer& offer);
    /// \pre the offer is confirmed, and nothing near has changed since
    void Divide(const ExchangeOffer& offer, const FreedSlots& freed);

  private:
    SurfaceArrays& surface() { return state_.simplified; }

    ExchangeOffer Offer(std::uint32_t a, std::uint32_t b, const Vector3<float>& start)
    {
        if (!fan_.HasSamples()) return {0, a, b, {}, false};
        const Fan::Fit fit = fan_.BestCenter(start);
        fan_.MeasureForward(fit.x, nullptr);
        const double change = fit.energy - static_cast<double>(fan_.summary().energy);
        return {static_cast<float>(change), a, b, fit.x, fan_.KeepsFaces()};
    }

    /// No point may get farther away than is tolerable, and no face look away from the original.
    /// \pre the fan is that of the offer, measured at its place
    ExchangeOffer WithinDistances(ExchangeOffer offer)
    {
        if (!offer.stands) return offer;
        const Fan::Distances forward = fan_.MeasureForward(offer.x, nullptr);
        const float allowed2 = std::max(fan_.present2(), state_.Tolerable2());
        const Fan::Distances backward = fan_.MeasureBackward(offer.x, nullptr);
        const double samples = forward.energy + static_cast<double>(fan_.summary().energy);
        offer.stands = forward.largest2 <= allowed2 && backward.largest2 <= allowed2 &&
                       backward.energy < kMaxBackwardRatio * samples && !fan_.FacesAway();
        return offer;
    }

    Vector3<float> Middle(std::uint32_t a, std::uint32_t b) const
    {
        const Vector3<float> p = PositionOf(state_.simplified, a);
        return p + 0.5F * (PositionOf(state_.simplified, b) - p);
    }
    void GatherRing(std::uint32_t v, Scratch<std::uint32_t>& ring) const
    {
        ring.Clear();
        const SurfaceArrays& s = state_.simplified;
        for (const Corner* c = BeginCorners(s, v); c != EndCorners(s, v); ++c)
            ring.Append() = NextVertex(s, *c);
    }

    /// Link condition: the ends have no common neighbour but the two across the edge, and these keep three
    /// faces. \pre neither end is on a border: every edge at them has two faces
    bool KeepsTopology(std::uint32_t a, std::uint32_t b)
    {
        constexpr std::uint32_t kMinFaces = 3;
        const SurfaceArrays& s = state_.simplified;
        GatherRing(a, ringA_);
        GatherRing(b, ringB_);
        std::size_t common = 0;
        for (const std::uint32_t w : ringA_) {
            if (std::find(ringB_.begin(), ringB_.end(), w) == ringB_.end()) continue;
            if (++common > 2 || s.cornerCount[w] <= kMinFaces) return false;
        }
        const std::size_t left = ringA_.size() + ringB_.size() - 4;
        const std::uint32_t room = std::max(CornerCapacity(s, a), CornerCapacity(s, b));
        return common == 2 && left >= kMinFaces && left <= room;
    }
    bool GatherCollapse(std::uint32_t a, std::uint32_t b)
    {
        const SurfaceArrays& s = state_.simplified;
        if ((s.flags[a] | s.flags[b]) & (kBorderVertex | kFixedVertex)) return false;
        if (s.cornerCount[a] + std::size_t{s.cornerCount[b]} > kMaxFanFaces || !KeepsTopology(a, b))
            return false;
        fan_.Begin(Middle(a, b));
        for (const Corner* c = BeginCorners(s, a); c != EndCorners(s, a); ++c) AddStarFace(*c, b, true);
        for (const Corner* c = BeginCorners(s, b); c != EndCorners(s, b); ++c) AddStarFace(*c, a, false);
        return true;
    }
    void AddStarFace(Corner corner, std::uint32_t other, bool holdShared)
    {
        const SurfaceArrays& s = state_.simplified;
        const std::uint32_t face = FaceOf(corner);
        const bool isShared = HasVertex(s.triangles[face], other);
        if (!isShared)
            fan_.AddFace(face, NextVertex(s, corner), PreviousVertex(s, corner), fan_.UnitNormal(face));
        if (!isShared || holdShared) fan_.HoldSamples(face);
    }
    bool GatherDivision(std::uint32_t a, std::uint32_t b)
    {
        const SurfaceArrays& s = state_.simplified;
        const auto edge = FindInnerEdge(s, a, b);
        if (!edge || edge->c == edge->d || (s.flags[a] & s.flags[b] & kFixedVertex)) return false;
        const auto full = [&](std::uint32_t v) { return s.cornerCount[v] >= CornerCapacity(s, v); };
        if (full(edge->c) || full(edge->d)) return false;
        fan_.Begin(Middle(a, b));
        const std::uint32_t first = edge->First(), second = edge->Second();
        const Vector3<float> n = fan_.UnitNormal(first), m = fan_.UnitNormal(second);
        fan_.AddFace(first, edge->b, edge->c, n);
        fan_.AddFace(kNone, edge->c, edge->a, n);
        fan_.AddFace(second, edge->a, edge->d, m);
        fan_.AddFace(kNone, edge->d, edge->b, m);
        fan_.HoldSamples(first);
        fan_.HoldSamples(second);
        return true;
    }

    /// Says of the fan and its rim that they have changed.
    void MarkChanged(std::uint32_t center)
    {
        state_.MarkChanged(center, kNewFaces);
        for (const FanFace& face : fan_.faces())
            for (const std::uint32_t v : {face.next, face.previous}) state_.MarkChanged(v, kNewFaces);
    }
    void SetTriangle(std::uint32_t face, std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        surface().triangles[face] = {{a, b, c}};
        AddCorner(surface(), a, MakeCorner(face, 0));
        AddCorner(surface(), b, MakeCorner(face, 1));
        AddCorner(surface(), c, MakeCorner(face, 2));
    }
};

inline FreedSlots VertexExchanger::Collapse(const ExchangeOffer& offer)
{
    SurfaceArrays& s = surface();
    GatherCollapse(offer.a, offer.b);
    fan_.MeasureForward(offer.x, nullptr);
    fan_.MeasureBackward(offer.x, nullptr);
    const bool intoB = CornerCapacity(s, offer.b) >= CornerCapacity(s, offer.a);
    const std::uint32_t gone = intoB ? offer.a : offer.b, kept = intoB ? offer.b : offer.a;
    FreedSlots freed;
    freed.vertex = gone;
    std::size_t shared = 0;
    for (const Corner* c = BeginCorners(s, gone); c != EndCorners(s, gone); ++c)
        if (HasVertex(s.triangles[FaceOf(*c)], kept)) freed.faces[shared++] = FaceOf(*c);
    for (const std::uint32_t face : freed.faces)
        for (int k = 0; k < 3; ++k) RemoveCorner(s, s.triangles[face].v[k], MakeCorner(face, k));
    for (const Corner* c = BeginCorners(s, gone); c != EndCorners(s, gone); ++c) {
        s.triangles[FaceOf(*c)].v[IndexOf(*c)] = kept;
        AddCorner(s, kept, *c);
    }
    s.cornerCount[gone] = 0;
    fan_.Store(kept, offer.x);
    MarkChanged(kept);
    return freed;
}

inline void VertexExchanger::Divide(const ExchangeOffer& offer, const FreedSlots& freed)
{
    SurfaceArrays& s = surface();
    GatherDivision(offer.a, offer.b);
    fan_.SetFace(1, freed.faces[0]);
    fan_.SetFace(3, freed.faces[1]);
    fan_.MeasureForward(offer.x, nullptr);
    fan_.MeasureBackward(offer.x, nullptr);
    s.cornerCount[freed.vertex] = 0;
    for (const std::size_t i : {0U, 2U}) {
        const std::uint32_t face = fan_.faces()[i].face;
        for (int k = 0; k < 3; ++k) RemoveCorner(s, s.triangles[face].v[k], MakeCorner(face, k));
    }
    for (const FanFace& face : fan_.faces()) SetTriangle(face.face, freed.vertex, face.next, face.previous);
    fan_.Store(freed.vertex, offer.x);
    MarkChanged(freed.vertex);
    state_.renewed.vertices[freed.vertex] = 1;
    for (const std::uint32_t face : freed.faces) state_.renewed.faces[face] = 1;
}

} // namespace vcg_ext
