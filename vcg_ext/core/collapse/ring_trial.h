// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <optional>

#include "vcg_ext/core/collapse/workspace.h"
#include "vcg_ext/core/collapse/state.h"

namespace vcg_ext
{

/// Appends the star of \p centre, sorting its faces into those that stay and those on the edge to \p other.
/// \param collectDead is set for one of the two stars, as both have the same faces on the edge
/// \return false if a vertex lies outside \p range
inline bool AppendStar(const SweepState& state, std::uint32_t centre, std::uint32_t other, bool collectDead,
                       const VertexRange& range, StarScratch& star)
{
    const Corner* list = state.CornersOf(centre);
    std::uint32_t kept = star.kept, dead = star.dead;
    bool inside = true;
    for (std::uint32_t i = 0; i < state.cornerCount[centre]; ++i) {
        const std::uint32_t next = state.Next(list[i]), previous = state.Previous(list[i]);
        const bool dies = next == other || previous == other;
        inside &= range.Has(next);
        inside &= range.Has(previous);
        // Both places are written and one of the counts advances: the branch would not be predictable.
        star.deadFace[dead] = FaceOf(list[i]);
        star.wing[dead] = next == other ? previous : next;
        star.next[kept] = next;
        star.previous[kept] = previous;
        star.corner[kept] = list[i];
        dead += dies && collectDead;
        kept += !dies;
    }
    star.kept = kept;
    star.dead = dead;
    return inside;
}

/// Gathers both stars of the edge. \return false if a vertex of them lies outside \p range
inline bool GatherStars(const SweepState& state, std::uint32_t removed, std::uint32_t survivor,
                        const VertexRange& range, StarScratch& star)
{
    star.Reserve(std::size_t{state.cornerCount[removed]} + state.cornerCount[survivor]);
    star.kept = star.dead = 0;
    const bool first = AppendStar(state, removed, survivor, true, range, star);
    star.keptOfRemoved = star.kept;
    const bool second = AppendStar(state, survivor, removed, false, range, star);
    if (star.kept > 0)
        for (std::uint32_t i = star.kept; i < star.kept + kLanes; ++i) {
            star.next[i] = star.next[star.kept - 1];
            star.previous[i] = star.previous[star.kept - 1];
            star.corner[i] = star.corner[star.kept - 1];
        }
    return first && second;
}

/// The areas that the volume plane needs, from the gathered stars.
inline StarAreas<float> AreasOf(const SweepState& state, const StarScratch& star)
{
    StarAreas<float> areas;
    const auto normal = [&](std::uint32_t face) { return state.faces[face].Normal(); };
    for (std::uint32_t i = 0; i < star.keptOfRemoved; ++i) areas.Add(normal(FaceOf(star.corner[i])), areas.a);
    for (std::uint32_t i = star.keptOfRemoved; i < star.kept; ++i)
        areas.Add(normal(FaceOf(star.corner[i])), areas.b);
    for (std::uint32_t i = 0; i < star.dead; ++i) areas.Add(normal(star.deadFace[i]), areas.edge);
    return areas;
}

template <class Row>
inline void StoreColumns(Row* rows, int slot, Float4 a, Float4 b, Float4 c, Float4 d)
{
    StoreTransposed(rows[0].value + slot, rows[1].value + slot, rows[2].value + slot, rows[3].value + slot, a,
                    b, c, d);
}

/// Places the new vertex at \p placement: are the kept faces still sound, and what do their new normals,
/// quadrics and the descriptor come to?
/// \return the factor of the cost for the worst triangle, or nothing where a face would turn over
inline std::optional<float> EvaluateRing(const SweepState& state, const Vector3<float>& placement,
                                         StarScratch& star)
{
    const Vector3<Float4> x{Splat(placement.x), Splat(placement.y), Splat(placement.z)};
    StarSums<Float4> sums;
    Float4 worst2 = Splat(FLT_MAX);
    for (std::uint32_t i = 0; i < star.kept; i += kLanes) {
        const auto load = [&](auto rowOf, Vector3<Float4>& to) {
            Float4 unused;
            LoadTransposed(rowOf(i), rowOf(i + 1), rowOf(i + 2), rowOf(i + 3), to.x, to.y, to.z, unused);
        };
        Vector3<Float4> next, previous, before;
        load([&](std::uint32_t k) { return state.vertices[star.next[k]].value; }, next);
        load([&](std::uint32_t k) { return state.vertices[star.previous[k]].value; }, previous);
        load([&](std::uint32_t k) { return state.faces[FaceOf(star.corner[k])].scaledNormal; }, before);
        const Vector3<Float4> a = next - x, b = previous - x;
        const MovedFace<Float4> face = MoveFace(a, b);
        if (AnyLane(TurnedTooFar(face, before))) return std::nullopt;
        worst2 = Min(worst2, face.quality2);

        const Float4 mask = LaneWeights(star.kept - i);
        const Float4 inverse = mask / Max(Sqrt(face.normal2), Splat(1e-25f));
        const Float4 root = Sqrt(inverse);
        const Vector3<Float4> m = root * face.normal;
        sums.Add(mask * a, mask * b, mask * face.lengthA, mask * face.lengthB, m, root);
        const SymmetricMatrix3<Float4> change = OuterProduct(m) - OuterProduct(before);
        StoreColumns(&star.normal[i], 0, m.x, m.y, m.z, Float4{});
        StoreColumns(&star.change[i], 0, change.xx, change.xy, change.xz, change.yy);
        StoreColumns(&star.change[i], 4, change.yz, change.zz, Float4{}, Float4{});
    }
    star.sums = Summed(sums);
    return QualityPenalty(MinLane(worst2));
}

} // namespace vcg_ext
