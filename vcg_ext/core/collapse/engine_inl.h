// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/crossing_check.h"
#include "vcg_ext/core/collapse/engine.h"
#include "vcg_ext/core/collapse/extract_wedges.h"
#include "vcg_ext/core/collapse/initialize.h"
#include "vcg_ext/core/collapse/load.h"
#include "vcg_ext/core/collapse/load_wedges.h"
#include "vcg_ext/core/collapse/schedule.h"
#include "vcg_ext/core/collapse/start_bound.h"
#include "vcg_ext/core/collapse/strict_order.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/mesh/surface.h"

namespace vcg_ext
{

/// Percent of a collapse's time, roughly, that go by before the first sweep.
constexpr int kReadingEnds = 20;

VCG_EXT_INLINE CollapseEngine::CollapseEngine(const MeshView& view, const DecimationParameters& parameters,
                                              KeptForLater kept, StageProgress progress)
    : threads_(ResolveThreads(parameters.threads)), order_(parameters.order), progress_(std::move(progress)),
      schedule_(Start(view, parameters, kept), threads_, parameters.costLimit)
{
}

VCG_EXT_INLINE CollapsedSurface CollapseEngine::Copy()
{
    CollapsedSurface surface;
    surface.frame = surface_.frame;
    surface.descriptor = surface_.descriptor;
    surface.stopReason = surface_.stopReason;
    surface.trace = surface_.trace;
    if (state_.keepOriginal) {
        surface.original = CopyOf(surface_.original);
        surface.original.corners = OriginalCorners().Copy(3 * surface_.original.FaceCount());
    }
    ExtractTo(surface);
    return surface;
}

VCG_EXT_INLINE CollapsedSurface CollapseEngine::Extract() &&
{
    CollapsedSurface surface = std::move(surface_);
    ExtractTo(surface);
    if (state_.keepOriginal) surface.original.corners = std::move(OriginalCorners());
    wedges_.reset();
    state_.mergedInto.Release();
    state_.vertices.Release();
    state_.faces.Release();
    state_.corners.Release();
    state_.spareCorners.Release();
    return surface;
}

VCG_EXT_INLINE StopReason CollapseEngine::Collapse(std::size_t targetFaces)
{
    const auto percent = [](double way) {
        return kReadingEnds + static_cast<int>(way * (100 - kReadingEnds));
    };
    double before = 0, step = 0.1; // of the way that a sweep goes; what the next one will go is a guess
    const auto report = [&](double way) {
        if (way > before) step = way - std::exchange(before, way);
        constexpr double kOfLast = 0.6;
        constexpr int kLoops = 2; // of a sweep that take their time
        progress_(percent(way), "Collapsing edges", percent(std::min(1.0, way + kOfLast * step)), kLoops);
    };
    surface_.stopReason = order_ == Order::Strict ? StrictOrder(state_).Run(targetFaces, report)
                                                  : schedule_.Run(targetFaces, report);
    surface_.trace = {schedule_.Steps(), static_cast<double>(state_.descriptorScale)};
    return surface_.stopReason;
}

VCG_EXT_INLINE SweepState& CollapseEngine::Start(const MeshView& view, const DecimationParameters& parameters,
                                                 KeptForLater kept)
{
    inputVertices_ = view.vertexCount;
    state_.featureWeight = static_cast<float>(parameters.featureWeight);
    state_.ratchetRecomputes = view.guidance == nullptr;
    state_.bordersCount = parameters.boundary != Boundary::Free;
    state_.preserveTopology = parameters.preserveTopology;
    state_.sharedSeams = view.sharedSeams;
    state_.keepOriginal = kept.original;
    progress_(0, "Reading the mesh", kReadingEnds / 2, 6);
    SweepLoader(view, state_, threads_).Load();
    progress_(kReadingEnds / 2, "Computing the descriptor", kReadingEnds * (view.attributes ? 3 : 4) / 4, 4);
    if (view.attributes != nullptr) {
        LoadWedges(view, parameters);
        progress_(kReadingEnds * 3 / 4, "Computing the descriptor", kReadingEnds, 4);
    }
    SweepStarter(view, state_, threads_, parameters.boundary, parameters.descriptorScale).Start();
    for (const std::uint8_t flags : state_.flags) state_.anyFixed |= (flags & kFixedVertex) != 0;
    surface_.frame = state_.frame;
    if (kept.bound && !state_.faces.empty()) KeepBound(view, *kept.bound);
    if (kept.guarded) Guard(*kept.guarded);
    if (kept.original) KeepOriginal();
    if (kept.descriptor && view.guidance == nullptr) KeepDescriptor(view.vertexCount);
    return state_;
}

VCG_EXT_INLINE void CollapseEngine::LoadWedges(const MeshView& view, const DecimationParameters& parameters)
{
    state_.wedges = &wedges_.emplace();
    WedgeLoader(*view.attributes, state_, *wedges_, threads_).Load(parameters, view.faceCount);
    inputCharts_ = ChartsOfInput(state_, *wedges_, view.faceCount);
}

VCG_EXT_INLINE void CollapseEngine::KeepBound(const MeshView& view, BoundTask& task)
{
    if (!task.tree) {
        std::vector<std::uint32_t> order;
        order.reserve(state_.faces.size());
        for (const FaceRecord& face : state_.faces) order.push_back(face.origin);
        task.tree = std::make_unique<FaceTree>(view, state_.frame, threads_, order);
    }
    bound_.emplace(view, *task.tree, CollapseBound::InnerLimit(task.bound));
    StartBound(state_, *bound_, task, threads_);
    state_.bound = &*bound_;
}

VCG_EXT_INLINE void CollapseEngine::Guard(const std::vector<std::uint8_t>& guarded)
{
    crossings_.emplace().guarded.Allocate(state_.vertices.size());
    for (std::size_t v = 0; v < state_.vertices.size(); ++v)
        crossings_->guarded[v] = guarded[state_.origin[v]];
    state_.crossings = &*crossings_;
}

VCG_EXT_INLINE void CollapseEngine::ExtractTo(CollapsedSurface& surface)
{
    const Buffer<std::uint32_t> place = ExtractVertices(surface);
    ExtractFaces(place, surface);
    if (!state_.mergedInto.empty()) MakeRoots(place, surface);
    if (state_.keepOriginal) BuildCornerLists(surface.simplified);
    if (bound_) KeepCoverage(surface);
    if (!wedges_) return;
    surface.wedges = ExtractWedges(state_, *wedges_);
    surface.wedges->inputChart = inputCharts_;
}

VCG_EXT_INLINE void CollapseEngine::KeepCoverage(CollapsedSurface& surface) const
{
    const CoveredPoints& covered = bound_->covered;
    surface.coveredBy.assign(inputVertices_, kNowhere);
    for (std::size_t v = 0; v < state_.vertices.size(); ++v)
        if (covered.face[v] != kNone)
            surface.coveredBy[state_.origin[v]] = state_.faces[covered.face[v]].origin & ~FaceRecord::kDead;
}

VCG_EXT_INLINE void CollapseEngine::KeepOriginal()
{
    constexpr float kSampleWeight = 2; // the refinement's samples weigh e^{2 l} whatever lambda is
    SurfaceArrays& original = surface_.original;
    const std::size_t vertices = state_.vertices.size(), faces = state_.faces.size();
    original.points.Allocate(vertices);
    original.flags.Allocate(vertices);
    original.cornerCount.Allocate(vertices);
    original.cornerOffset.Allocate(vertices + 1);
    original.triangles.Allocate(faces);
    state_.mergedInto.Allocate(vertices);
    ParallelRanges(threads_, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto p = state_.Position(static_cast<std::uint32_t>(v));
            original.points[v] = {p.x, p.y, p.z, std::exp(kSampleWeight * state_.descriptor[v])};
            original.flags[v] = state_.flags[v] & (kBorderVertex | kFixedVertex);
            original.cornerCount[v] = state_.cornerCount[v];
            original.cornerOffset[v] = state_.cornerOffset[v];
            state_.mergedInto[v] = static_cast<std::uint32_t>(v);
        }
    });
    original.cornerOffset[vertices] = static_cast<std::uint32_t>(3 * faces);
    ParallelRanges(threads_, faces, kGrain, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t f = begin; f < end; ++f)
            std::copy(state_.faces[f].v, state_.faces[f].v + 3, original.triangles[f].v);
    });
}

VCG_EXT_INLINE void CollapseEngine::KeepDescriptor(std::size_t inputVertices)
{
    surface_.descriptor.resize(inputVertices, 0);
    for (std::size_t v = 0; v < state_.vertices.size(); ++v)
        surface_.descriptor[state_.origin[v]] = state_.descriptor[v];
}

VCG_EXT_INLINE Buffer<std::uint32_t> CollapseEngine::ExtractVertices(CollapsedSurface& surface) const
{
    SurfaceArrays& simplified = surface.simplified;
    simplified.sharedSeams = state_.sharedSeams;
    const std::size_t vertices = state_.vertices.size();
    Buffer<std::uint32_t> place(vertices);
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < vertices; ++v) place[v] = Survives(v) ? count++ : kNowhere;
    simplified.points.Allocate(count);
    simplified.flags.Allocate(count);
    surface.vertexOrigin.Allocate(count);
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::uint32_t to = place[v];
        if (to == kNowhere) continue;
        const auto p = state_.Position(static_cast<std::uint32_t>(v));
        simplified.points[to] = {p.x, p.y, p.z, 1};
        simplified.flags[to] = static_cast<std::uint8_t>(state_.flags[v] & ~kMergedVertex);
        surface.vertexOrigin[to] = state_.origin[v];
    }
    return place;
}

VCG_EXT_INLINE void CollapseEngine::ExtractFaces(const Buffer<std::uint32_t>& place,
                                                 CollapsedSurface& surface) const
{
    surface.simplified.triangles.Allocate(state_.aliveFaces);
    surface.faceOrigin.Allocate(state_.aliveFaces);
    surface.faceOrder.reserve(state_.faces.size());
    std::size_t to = 0;
    for (const FaceRecord& face : state_.faces) {
        surface.faceOrder.push_back(face.origin & ~FaceRecord::kDead);
        if (!face.Alive()) continue;
        surface.simplified.triangles[to] = {{place[face.v[0]], place[face.v[1]], place[face.v[2]]}};
        surface.faceOrigin[to++] = face.origin;
    }
}

VCG_EXT_INLINE void CollapseEngine::MakeRoots(const Buffer<std::uint32_t>& place, CollapsedSurface& surface)
{
    Buffer<std::uint32_t>& into = state_.mergedInto;
    surface.root.Allocate(into.size());
    for (std::uint32_t v = 0; v < into.size(); ++v) {
        std::uint32_t root = v;
        while (into[root] != root) root = into[root];
        for (std::uint32_t at = v; into[at] != root;) at = std::exchange(into[at], root);
        surface.root[v] = place[root];
    }
}

} // namespace vcg_ext
