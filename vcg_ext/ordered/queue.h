// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/local_optimization.h>
#include <vcg/complex/algorithms/local_optimization/tri_edge_collapse.h>

#include "vcg_ext/core/base/loop_poll.h"
#include "vcg_ext/core/base/progress.h"
#include "vcg_ext/core/parameters.h"
#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

/// What a method says about the collapse of one vertex into another.
struct CollapseAssessment {
    double cost;
    Vector3d placement;        ///< in the method's own frame
    bool removedStays = false; ///< the placement is where the vertex that was to go is: that one survives
};

template <class Mesh, class Method>
class CollapseRun;

/// One entry of the queue: an edge, priced when it was queued.
///
/// vcg::tri::TriEdgeCollapse supplies the frame; what differs from it:
/// - no state in function statics, everything that lasts lives in the run. Of VCG's statics (the counters of
///   FailStat, GlobalMark, the text of Info, the user bits of vertices and faces) none is touched: what uses
///   them is overridden here or not called, and EdgeCollapser's table is never written. So runs over
///   different meshes may go on at the same time;
/// - a collapse changes the price of every edge around its ring. VCG either marks the ring, which loses its
///   outer edges, or leaves them stale; here the ring is stamped and an entry that is older than the stamp of
///   an end is priced again when it comes up, and waits on where it has become dearer;
/// - the full price is only computed for entries that come up, the queue starts with a cheap estimate;
/// - what is refused is kept by the run and tried again when its surroundings have changed.
template <class Mesh, class Method>
class QueuedCollapse
    : public vcg::tri::TriEdgeCollapse<Mesh, vcg::tri::BasicVertexPair<typename Mesh::VertexType>,
                                       QueuedCollapse<Mesh, Method>>
{
  public:
    using VertexType = typename Mesh::VertexType;
    using VertexPair = vcg::tri::BasicVertexPair<VertexType>;
    using Base = vcg::tri::TriEdgeCollapse<Mesh, VertexPair, QueuedCollapse>;
    using typename Base::HeapType;
    using Run = CollapseRun<Mesh, Method>;

    /// \param now the run's clock \param parameters the run
    QueuedCollapse(const VertexPair& pair, int now, vcg::BaseParameterClass* parameters)
    {
        this->mt = nullptr; // TriEdgeCollapse leaves its members to chance, and copies of an entry read them
        this->_priority = 0;
        this->pos = pair;
        this->localMark = now;
        Run& run = *static_cast<Run*>(parameters);
        priority_ = Run::Priority(run.method().Estimate(*this->pos.V(0), *this->pos.V(1)));
    }

    typename Mesh::ScalarType Priority() const override
    {
        return static_cast<typename Mesh::ScalarType>(priority_);
    }

    bool IsUpToDate() const override
    {
        const VertexType& removed = *this->pos.cV(0);
        const VertexType& kept = *this->pos.cV(1);
        return !removed.IsD() && !kept.IsD() && this->localMark >= removed.cIMark() &&
               this->localMark >= kept.cIMark();
    }

    bool IsFeasible(vcg::BaseParameterClass* parameters) override
    {
        Run& run = *static_cast<Run*>(parameters);
        VertexType& removed = *this->pos.V(0);
        VertexType& kept = *this->pos.V(1);
        const bool changed = run.HasChangedSince(removed, kept, this->localMark);
        if (!isAssessed_ || changed) {
            const auto assessment = run.method().Assess(removed, kept);
            isAssessed_ = true;
            if (!assessment) {
                run.Refuse(removed, kept);
                return false;
            }
            placement_ = assessment->placement;
            removedStays_ = assessment->removedStays;
            priority_ = std::max(priority_, Run::Priority(assessment->cost));
            if (priority_ > run.NextPriority()) {
                this->localMark = run.now();
                run.Requeue(*this);
                return false;
            }
        }
        if (run.method().IsLegal(removed, kept, placement_)) return true;
        run.Refuse(removed, kept);
        return false;
    }

    void Execute(Mesh& mesh, vcg::BaseParameterClass* parameters) override
    {
        Run& run = *static_cast<Run*>(parameters);
        if (removedStays_) this->pos = VertexPair(this->pos.V(1), this->pos.V(0));
        const auto position = run.method().Merge(*this->pos.V(0), *this->pos.V(1), placement_);
        vcg::tri::EdgeCollapser<Mesh, VertexPair>::Do(mesh, this->pos, position);
    }

    void UpdateHeap(HeapType&, vcg::BaseParameterClass* parameters) override
    {
        static_cast<Run*>(parameters)->QueueAround(*this->pos.V(1));
    }

    typename Mesh::ScalarType ComputePriority(vcg::BaseParameterClass*) override { return Priority(); }

    static void Init(Mesh&, HeapType&, vcg::BaseParameterClass* parameters)
    {
        static_cast<Run*>(parameters)->QueueAll();
    }

    /// Entries a face before outdated ones are thrown out of the heap.
    static float HeapSimplexRatio(vcg::BaseParameterClass* parameters)
    {
        return static_cast<Run*>(parameters)->method().IsDirected() ? 10.0F : 5.0F;
    }

  private:
    float priority_;
    Vector3d placement_{};
    bool removedStays_ = false;
    bool isAssessed_ = false;
};

/// A run of vcg::LocalOptimization over a mesh: its queue, clock and refused pairs.
///
/// \tparam Method decides everything about one collapse:
/// - `bool IsDirected()`: a into b and b into a differ;
/// - `bool MayGo(removed, kept)`: whether one may be merged into the other at all, whatever lies around them;
/// - `double Estimate(removed, kept)`: cheap, at most what Assess will say or not much more;
/// - `std::optional<CollapseAssessment> Assess(removed, kept)`: nothing where it is refused;
/// - `bool IsLegal(removed, kept, placement)`: topology, and whatever else must not happen;
/// - `bool BeginLastResort()`: no legal collapse is left; true if from now on more are;
/// - `CoordType Merge(removed, kept, placement)`: its books; returns the survivor's position in the mesh;
/// - `void Refresh(kept, ring)`: its books, after the collapse.
template <class Mesh, class Method>
class CollapseRun : public vcg::BaseParameterClass
{
    using VertexType = typename Mesh::VertexType;
    using Collapse = QueuedCollapse<Mesh, Method>;
    using Optimization = vcg::LocalOptimization<Mesh>;
    using HeapElement = typename Optimization::HeapElem;

    struct RefusedPair {
        VertexType* removed;
        VertexType* kept;
        int time;
    };

    Mesh& mesh_;
    Method& method_;
    Optimization optimization_;
    RingEdges<Mesh> ring_;
    std::vector<int> changed_; ///< when the surroundings of a vertex changed last
    std::vector<RefusedPair> refused_;
    int now_ = 0;

    /// Both directions of an edge where they differ, otherwise the one that is possible.
    void QueueEdge(VertexType& a, VertexType& b)
    {
        const bool queuedOneWay = method_.MayGo(a, b);
        if (queuedOneWay) Push(Collapse({&a, &b}, now_, this));
        if ((method_.IsDirected() || !queuedOneWay) && method_.MayGo(b, a))
            Push(Collapse({&b, &a}, now_, this));
    }

    void Push(const Collapse& collapse)
    {
        optimization_.h.push_back(HeapElement(std::make_unique<Collapse>(collapse).release()));
        std::push_heap(optimization_.h.begin(), optimization_.h.end());
    }

    /// Queues the refused pairs whose surroundings have changed since, or \p all that are still there.
    /// \return whether there were any
    bool RetryRefused(bool all)
    {
        std::vector<RefusedPair> waiting;
        waiting.swap(refused_);
        const std::size_t before = optimization_.h.size();
        for (const RefusedPair& refused : waiting) {
            VertexType& removed = *refused.removed;
            VertexType& kept = *refused.kept;
            if (removed.IsD() || kept.IsD() || refused.time < removed.cIMark() ||
                refused.time < kept.cIMark())
                continue; // gone, or queued anew around the survivor of a collapse
            if (all || HasChangedSince(removed, kept, refused.time))
                Push(Collapse({&removed, &kept}, now_, this));
            else
                refused_.push_back(refused);
        }
        return optimization_.h.size() > before;
    }

  public:
    /// \pre vertex-face adjacency and vertex marks are there; both arguments outlive the run
    CollapseRun(Mesh& mesh, Method& method)
        : mesh_(mesh), method_(method), optimization_(mesh, this), ring_(mesh), changed_(mesh.vert.size(), 0)
    {
    }
    CollapseRun(const CollapseRun&) = delete;
    CollapseRun& operator=(const CollapseRun&) = delete;

    Method& method() { return method_; }
    int now() const { return now_; }

    static float Priority(double cost)
    {
        return static_cast<float>(std::min(cost, static_cast<double>(FLT_MAX)));
    }

    /// The priority of the entry behind the one that has come up.
    float NextPriority() const { return optimization_.h.empty() ? FLT_MAX : optimization_.h.front().pri; }

    bool HasChangedSince(const VertexType& removed, const VertexType& kept, int time) const
    {
        return time < changed_[vcg::tri::Index(mesh_, &removed)] ||
               time < changed_[vcg::tri::Index(mesh_, &kept)];
    }

    void Refuse(VertexType& removed, VertexType& kept) { refused_.push_back({&removed, &kept, now_}); }
    void Requeue(const Collapse& collapse) { Push(collapse); }

    /// Queues every edge, once.
    void QueueAll()
    {
        optimization_.h.clear();
        constexpr std::size_t kBetweenQuestions = 4096; // vertices
        std::size_t seen = 0;
        for (VertexType& vertex : mesh_.vert) {
            if (++seen % kBetweenQuestions == 0) LoopPoll::Ask();
            if (vertex.IsD()) continue;
            for (const RingEdge<Mesh>& edge : ring_.Collect(vertex))
                if (&vertex < edge.neighbour) QueueEdge(*edge.neighbour, vertex);
        }
    }

    /// After a collapse: stamps the ring of the survivor and queues its edges anew.
    void QueueAround(VertexType& kept)
    {
        ++now_;
        kept.IMark() = now_;
        const auto& ring = ring_.Collect(kept);
        method_.Refresh(kept, ring);
        changed_[vcg::tri::Index(mesh_, &kept)] = now_;
        for (const RingEdge<Mesh>& edge : ring) {
            changed_[vcg::tri::Index(mesh_, edge.neighbour)] = now_;
            QueueEdge(*edge.neighbour, kept);
        }
    }

    /// Collapses until at most \p targetFaces faces are left or no legal collapse is. \throws Cancelled
    StopReason Decimate(std::size_t targetFaces, const StageProgress& progress)
    {
        vcg::tri::RequirePerVertexMark(mesh_);
        const auto Faces = [this] { return static_cast<std::size_t>(mesh_.fn); };
        const std::size_t before = Faces();
        if (before <= targetFaces) return StopReason::Target;
        optimization_.template Init<Collapse>();
        constexpr int kBetweenQuestions = 256; // collapses
        optimization_.SetTargetOperations(kBetweenQuestions);
        constexpr std::size_t kSteps = 100;
        const std::size_t step = std::max<std::size_t>(1, (before - targetFaces) / kSteps);
        while (Faces() > targetFaces) {
            const std::size_t next = Faces() - std::min(step, Faces() - targetFaces);
            optimization_.SetTargetSimplices(static_cast<int>(next));
            while (optimization_.DoOptimization() && Faces() > next) LoopPoll::Ask();
            const bool retrying = RetryRefused(false);
            if (Faces() > next && !retrying && !(method_.BeginLastResort() && RetryRefused(true)))
                return StopReason::NoLegalCollapse;
            const std::size_t done = before - std::max(Faces(), targetFaces);
            progress(static_cast<int>(100 * done / (before - targetFaces)), "Collapsing edges");
        }
        return StopReason::Target;
    }
};

} // namespace vcg_ext
