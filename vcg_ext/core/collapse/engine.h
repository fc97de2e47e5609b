// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/compiled.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/bound/collapse_bound.h"
#include "vcg_ext/core/collapse/collapsed_surface.h"
#include "vcg_ext/core/collapse/crossing_check.h"
#include "vcg_ext/core/collapse/schedule.h"
#include "vcg_ext/core/collapse/state.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// Collapses edges in sweeps over arrays, each up to a threshold of the cost, on several threads:
///
///     CollapseEngine engine(view, parameters);        // reads and orders the mesh
///     engine.Collapse(parameters.targetFaces);
///     CollapsedSurface surface = engine.Copy();       // a level of detail
///     engine.Collapse(fewerFaces);                    // goes on where the last call stopped
///     CollapsedSurface last = std::move(engine).Extract();
///
/// In order strict they are collapsed one by one: StrictOrder. The result is bit-identical for any number of
/// threads. Faces that name a vertex twice are left out unless all their vertices are fixed; vertices without
/// faces are left out unless they are fixed. \pre the view outlives the object; coordinates are finite and
/// indices are below vertexCount
class CollapseEngine
{
    SweepState state_;
    int threads_;
    Order order_;
    StageProgress progress_;
    std::optional<CollapseBound> bound_;
    std::optional<CollapseCrossings> crossings_;
    std::optional<WedgeSet> wedges_;
    std::vector<std::uint32_t> inputCharts_;
    std::size_t inputVertices_ = 0;
    CollapsedSurface surface_; ///< what is known of it already
    SweepSchedule schedule_;

  public:
    /// Computes descriptor, quadrics and costs. \param progress of the calls of Collapse
    /// \throws std::length_error for 2^29 faces and more, std::bad_alloc
    VCG_EXT_INLINE CollapseEngine(const MeshView& view, const DecimationParameters& parameters,
                                  KeptForLater kept = {}, StageProgress progress = {});
    CollapseEngine(const CollapseEngine&) = delete; // the schedule holds on to the state
    CollapseEngine& operator=(const CollapseEngine&) = delete;

    /// From now on the calls of Collapse report to \p progress.
    void ReportTo(StageProgress progress) { progress_ = std::move(progress); }

    /// Collapses edges until at most \p targetFaces are left or none may be collapsed.
    /// \throws Cancelled
    VCG_EXT_INLINE StopReason Collapse(std::size_t targetFaces);

    /// What is left, as compact arrays; the engine is used up.
    VCG_EXT_INLINE CollapsedSurface Extract() &&;

    /// The same, and Collapse can be called again. It takes room for another original where that is kept.
    VCG_EXT_INLINE CollapsedSurface Copy();

  private:
    static constexpr std::size_t kGrain = 1 << 14;
    static constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

    VCG_EXT_INLINE SweepState& Start(const MeshView& view, const DecimationParameters& parameters,
                                     KeptForLater kept);
    VCG_EXT_INLINE void LoadWedges(const MeshView& view, const DecimationParameters& parameters);
    VCG_EXT_INLINE void KeepBound(const MeshView& view, BoundTask& task);
    VCG_EXT_INLINE void Guard(const std::vector<std::uint8_t>& guarded);

    /// The input's lists are the first of their pool, whichever that is by now.
    Buffer<Corner>& OriginalCorners()
    {
        return state_.originalCorners.empty() ? state_.corners : state_.originalCorners;
    }

    /// All of \p surface but what has been known since the start.
    VCG_EXT_INLINE void ExtractTo(CollapsedSurface& surface);
    VCG_EXT_INLINE void KeepCoverage(CollapsedSurface& surface) const;
    bool Survives(std::size_t v) const
    {
        return state_.cornerCount[v] > 0 || (state_.flags[v] & kFixedVertex) != 0;
    }

    VCG_EXT_INLINE void KeepOriginal();
    VCG_EXT_INLINE void KeepDescriptor(std::size_t inputVertices);
    /// \return where each of the state's vertices is in the simplified surface
    VCG_EXT_INLINE Buffer<std::uint32_t> ExtractVertices(CollapsedSurface& surface) const;
    VCG_EXT_INLINE void ExtractFaces(const Buffer<std::uint32_t>& place, CollapsedSurface& surface) const;
    VCG_EXT_INLINE void MakeRoots(const Buffer<std::uint32_t>& place, CollapsedSurface& surface);
};

} // namespace vcg_ext

#ifndef LAPLACIAN_SIMPLIFY_COMPILED
#include "vcg_ext/core/collapse/engine_inl.h"
#endif
