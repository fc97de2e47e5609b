// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/refine/refine.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/build_surface.h"
#include "vcg_ext/core/collapse/load.h"
#include "vcg_ext/core/collapse/schedule.h"
#include "vcg_ext/core/collapse/initialize.h"

namespace vcg_ext
{

/// Decimation by threshold sweeps over arrays, in stages:
///
///     SweepDecimation run(view, parameters);       // reads the mesh
///     run.Collapse(parameters.targetFaces);        // may be called again with lower targets
///     run.Extract();                               // what is left as SurfaceArrays, which may then be
///     refined DecimatedMesh result = run.Result();
///
/// The same bytes come out for every number of threads. Faces that name a vertex twice are left out unless
/// all their vertices are fixed; vertices without faces are left out unless they are fixed. \pre the view
/// outlives the object; coordinates are finite and indices are below vertexCount
class SweepDecimation
{
    MeshView view_;
    DecimationParameters parameters_;
    int threads_;
    SweepState state_;
    SurfaceArrays original_;
    SurfaceArrays simplified_;
    Buffer<std::uint32_t> root_, vertexOrigin_, faceOrigin_;
    std::vector<std::uint32_t> inputOrder_;
    StopReason stopReason_ = StopReason::Target;

  public:
    /// Reads and orders the mesh, computes descriptor and quadrics.
    /// \param keepOriginal is needed by Original and Root
    /// \throws std::length_error for 2^29 faces and more, std::bad_alloc
    SweepDecimation(const MeshView& view, const DecimationParameters& parameters, bool keepOriginal = false)
        : view_(view), parameters_(parameters), threads_(ResolveThreads(parameters.threads))
    {
        state_.featureWeight = static_cast<float>(parameters.featureWeight);
        state_.ratchetRecomputes = view.guidance == nullptr;
        state_.bordersCount = parameters.boundary != Boundary::Free;
        state_.preserveTopology = parameters.preserveTopology;
        state_.keepOriginal = keepOriginal;
        SweepLoader(view, state_, threads_).Load();
        SweepStarter(view, state_, threads_, parameters.boundary).Start();
        for (const std::uint8_t flags : state_.flags) state_.anyFixed |= (flags & kFixedVertex) != 0;
        if (keepOriginal) KeepOriginal();
    }

    /// Collapses edges until at most \p targetFaces are left or none may be collapsed.
    StopReason Collapse(std::size_t targetFaces)
    {
        const auto report = [&](double way) {
            return !parameters_.progress ||
                   parameters_.progress(static_cast<int>(way * 100), "Collapsing edges");
        };
        SweepSchedule schedule(state_, threads_);
        stopReason_ = schedule.Run(targetFaces, report);
        return stopReason_;
    }

    /// Writes what is left as compact arrays and drops everything that the collapses needed.
    void Extract()
    {
        const Buffer<std::uint32_t> place = ExtractVertices();
        ExtractFaces(place);
        if (!state_.mergedInto.empty()) MakeRoots(place);
        if (state_.keepOriginal) {
            original_.corners = state_.originalCorners.empty() ? std::move(state_.corners)
                                                               : std::move(state_.originalCorners);
            BuildCornerLists(simplified_);
        }
        state_.vertices.Release();
        state_.faces.Release();
        state_.corners.Release();
        state_.spareCorners.Release();
    }

    /// The input as the engine orders it, with weights e^{2 l}. \pre keepOriginal and Extract
    const SurfaceArrays& Original() const { return original_; }
    /// What is left; points and triangles may be changed before Result. Corner lists are filled with
    /// keepOriginal only. \pre Extract
    SurfaceArrays& Simplified() { return simplified_; }
    /// The simplified vertex that each original one was merged into. \pre keepOriginal and Extract
    const Buffer<std::uint32_t>& Root() const { return root_; }

    /// The mesh in input order. Vertices that never moved have the input's coordinates to the last bit.
    /// \pre Extract; may be called once
    DecimatedMesh Result()
    {
        DecimatedMesh mesh;
        mesh.stopReason = stopReason_;
        mesh.inputOrder = std::move(inputOrder_);
        const Buffer<std::uint32_t> place = WriteVertices(mesh);
        WriteFaces(mesh, place);
        return mesh;
    }

  private:
    static constexpr std::size_t kGrain = 1 << 14;
    static constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

    bool Survives(std::size_t v) const
    {
        return state_.cornerCount[v] > 0 || (state_.flags[v] & kFixedVertex) != 0;
    }

    void KeepOriginal()
    {
        constexpr float kSampleWeight = 2; // the refinement's samples weigh e^{2 l} whatever lambda is
        const std::size_t vertices = state_.vertices.size(), faces = state_.faces.size();
        original_.points.Allocate(vertices);
        original_.flags.Allocate(vertices);
        original_.cornerCount.Allocate(vertices);
        original_.cornerOffset.Allocate(vertices + 1);
        original_.triangles.Allocate(faces);
        state_.mergedInto.Allocate(vertices);
        ParallelRanges(threads_, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t v = begin; v < end; ++v) {
                const auto p = state_.Position(static_cast<std::uint32_t>(v));
                original_.points[v] = {p.x, p.y, p.z, std::exp(kSampleWeight * state_.descriptor[v])};
                original_.flags[v] = state_.flags[v] & (kBorderVertex | kFixedVertex);
                original_.cornerCount[v] = state_.cornerCount[v];
                original_.cornerOffset[v] = state_.cornerOffset[v];
                state_.mergedInto[v] = static_cast<std::uint32_t>(v);
            }
        });
        original_.cornerOffset[vertices] = static_cast<std::uint32_t>(3 * faces);
        ParallelRanges(threads_, faces, kGrain, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t f = begin; f < end; ++f)
                std::copy(state_.faces[f].v, state_.faces[f].v + 3, original_.triangles[f].v);
        });
    }

    /// \return where each of the state's vertices is in simplified_
    Buffer<std::uint32_t> ExtractVertices()
    {
        const std::size_t vertices = state_.vertices.size();
        Buffer<std::uint32_t> place(vertices);
        std::uint32_t count = 0;
        for (std::size_t v = 0; v < vertices; ++v) place[v] = Survives(v) ? count++ : kNowhere;
        simplified_.points.Allocate(count);
        simplified_.flags.Allocate(count);
        vertexOrigin_.Allocate(count);
        for (std::size_t v = 0; v < vertices; ++v) {
            const std::uint32_t to = place[v];
            if (to == kNowhere) continue;
            const auto p = state_.Position(static_cast<std::uint32_t>(v));
            simplified_.points[to] = {p.x, p.y, p.z, 1};
            simplified_.flags[to] = state_.flags[v] & (kBorderVertex | kFixedVertex | kMovedVertex);
            vertexOrigin_[to] = state_.origin[v];
        }
        return place;
    }

    void ExtractFaces(const Buffer<std::uint32_t>& place)
    {
        simplified_.triangles.Allocate(state_.aliveFaces);
        faceOrigin_.Allocate(state_.aliveFaces);
        inputOrder_.reserve(state_.faces.size());
        std::size_t to = 0;
        for (const FaceRecord& face : state_.faces) {
            inputOrder_.push_back(face.origin & ~FaceRecord::kDead);
            if (!face.Alive()) continue;
            simplified_.triangles[to] = {{place[face.v[0]], place[face.v[1]], place[face.v[2]]}};
            faceOrigin_[to++] = face.origin;
        }
    }

    void MakeRoots(const Buffer<std::uint32_t>& place)
    {
        Buffer<std::uint32_t>& into = state_.mergedInto;
        root_.Allocate(into.size());
        for (std::uint32_t v = 0; v < into.size(); ++v) {
            std::uint32_t root = v;
            while (into[root] != root) root = into[root];
            for (std::uint32_t at = v; into[at] != root;) at = std::exchange(into[at], root);
            root_[v] = place[root];
        }
        into.Release();
    }

    /// \return where each of the simplified vertices is in the result
    Buffer<std::uint32_t> WriteVertices(DecimatedMesh& mesh) const
    {
        const std::size_t count = vertexOrigin_.size();
        Buffer<std::uint32_t> atOrigin(view_.vertexCount), place(count);
        std::fill(atOrigin.begin(), atOrigin.end(), kNowhere);
        for (std::uint32_t v = 0; v < count; ++v) atOrigin[vertexOrigin_[v]] = v;
        mesh.positions.reserve(count);
        mesh.vertexOrigin.reserve(count);
        for (std::uint32_t origin = 0; origin < view_.vertexCount; ++origin) {
            const std::uint32_t v = atOrigin[origin];
            if (v == kNowhere) continue;
            place[v] = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(InputPosition(v));
            mesh.vertexOrigin.push_back(origin);
        }
        return place;
    }

    std::array<double, 3> InputPosition(std::uint32_t v) const
    {
        if ((simplified_.flags[v] & kMovedVertex) == 0) return view_.Position(vertexOrigin_[v]);
        const SurfacePoint& p = simplified_.points[v];
        return {p.x * state_.unit + state_.centre[0], p.y * state_.unit + state_.centre[1],
                p.z * state_.unit + state_.centre[2]};
    }

    void WriteFaces(DecimatedMesh& mesh, const Buffer<std::uint32_t>& place) const
    {
        const std::size_t count = faceOrigin_.size();
        Buffer<std::uint32_t> atOrigin(view_.faceCount);
        std::fill(atOrigin.begin(), atOrigin.end(), kNowhere);
        for (std::uint32_t f = 0; f < count; ++f) atOrigin[faceOrigin_[f]] = f;
        mesh.triangles.reserve(count);
        mesh.faceOrigin.reserve(count);
        for (std::uint32_t origin = 0; origin < view_.faceCount; ++origin) {
            const std::uint32_t f = atOrigin[origin];
            if (f == kNowhere) continue;
            const std::uint32_t* v = simplified_.triangles[f].v;
            mesh.triangles.push_back({place[v[0]], place[v[1]], place[v[2]]});
            mesh.faceOrigin.push_back(origin);
        }
    }
};

/// Collapses \p view to the target and, unless the effort is Fast, refines what is left.
/// \pre as SweepDecimation
inline DecimatedMesh DecimateSweeps(const MeshView& view, const DecimationParameters& parameters)
{
    constexpr int kCollapsePart = 55; // of the time, roughly
    const bool refined = parameters.effort != Effort::Fast;
    DecimationParameters collapse = parameters;
    if (refined) collapse.progress = ProgressPart(parameters.progress, 0, kCollapsePart);
    SweepDecimation run(view, collapse, refined);
    const StopReason reason = run.Collapse(parameters.targetFaces);
    run.Extract();
    if (!refined || reason == StopReason::Cancelled) return run.Result();

    RefinementParameters refinement;
    refinement.threads = parameters.threads;
    refinement.progress = ProgressPart(parameters.progress, kCollapsePart, 100);
    const bool cancelled = Refine(run.Original(), run.Simplified(), run.Root(), refinement).cancelled;
    DecimatedMesh mesh = run.Result();
    if (cancelled) mesh.stopReason = StopReason::Cancelled;
    return mesh;
}

} // namespace vcg_ext
