// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
#include "vcg_ext/ordered/guided.h"
#include "vcg_ext/ordered/ring.h"

namespace vcg_ext
{

/// Points of the original surface, each attached to the nearest of the faces that were around it when it was
/// last looked at. Positions are in the engine's frame; weights are areas in it times an importance.
/// Distances are taken in single precision, from the point where the faces meet.
class MeasuredSamples
{
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    static constexpr double kVertexShare = .4; ///< of the surface's area; centroids have the rest

    struct Sample {
        Vector3d position;
        float weight;
        float distance2;
        std::uint32_t next;
    };

    /// Samples around one edge, four at a time.
    struct Group {
        Vector3<Float4> points;
        Float4 weight, distance2, newDistance2;
        Int4 nearest; ///< place in the list of faces
    };

    std::vector<Sample> samples_;
    std::vector<std::uint32_t> first_; ///< of a face; kNone where it has none
    std::vector<std::uint32_t> gathered_;
    std::vector<Group> groups_;
    std::vector<PreparedTriangle<float>> triangles_;

    void Add(std::uint32_t face, const Vector3d& position, double weight)
    {
        samples_.push_back({position, static_cast<float>(weight), 0, first_[face]});
        first_[face] = static_cast<std::uint32_t>(samples_.size() - 1);
    }

    static void SetLane(Group& group, std::size_t lane, const Vector3d& offset, const Sample& sample)
    {
        group.points.x[lane] = static_cast<float>(offset.x);
        group.points.y[lane] = static_cast<float>(offset.y);
        group.points.z[lane] = static_cast<float>(offset.z);
        group.weight[lane] = sample.weight;
        group.distance2[lane] = sample.distance2;
    }

    void PrepareTriangles(const std::vector<StarFace>& faces, const Vector3d& x)
    {
        triangles_.clear();
        const auto single = [](const Vector3d& p) {
            return Vector3<float>{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
        };
        for (const StarFace& face : faces)
            triangles_.push_back(PrepareTriangle(single(face.next - x), single(face.previous - x)));
    }

    void FindNearest(Group& group) const
    {
        Float4 best = ClosestOnTriangle(group.points, triangles_[0]).distance2;
        Int4 nearest = Splat(std::int32_t{0});
        for (std::size_t t = 1; t < triangles_.size(); ++t) {
            const Float4 distance2 = ClosestOnTriangle(group.points, triangles_[t]).distance2;
            const Int4 nearer = distance2 < best;
            best = Select(nearer, distance2, best);
            nearest = Select(nearer, Splat(static_cast<std::int32_t>(t)), nearest);
        }
        group.newDistance2 = best;
        group.nearest = nearest;
    }

  public:
    explicit MeasuredSamples(std::size_t faces) : first_(faces, kNone) {}

    /// The centroid of a face with corners \p a, \p b, \p c; its area counts \p importance times.
    void AddCentroid(std::uint32_t face, const Vector3d& a, const Vector3d& b, const Vector3d& c,
                     double importance)
    {
        const Vector3d normal = Cross(b - a, c - a);
        const double area = std::sqrt(Dot(normal, normal)) / 2;
        Add(face, 1.0 / 3 * (a + b + c), (1 - kVertexShare) * area * importance);
    }

    /// A vertex of \p face, for which \p area of the surface counts.
    void AddVertex(std::uint32_t face, const Vector3d& position, double area)
    {
        Add(face, position, kVertexShare * area);
    }

    /// Takes the samples of \p faces for the following calls, seen from \p origin.
    void Gather(const std::vector<std::uint32_t>& faces, const Vector3d& origin)
    {
        gathered_.clear();
        for (const std::uint32_t face : faces)
            for (std::uint32_t s = first_[face]; s != kNone; s = samples_[s].next) gathered_.push_back(s);
        groups_.resize((gathered_.size() + kLanes - 1) / kLanes);
        for (std::size_t i = 0; i < gathered_.size(); ++i) {
            const Sample& sample = samples_[gathered_[i]];
            SetLane(groups_[i / kLanes], i % kLanes, sample.position - origin, sample);
        }
        for (std::size_t i = gathered_.size(); i < kLanes * groups_.size(); ++i) {
            Group& last = groups_.back();
            last.points.x[i % kLanes] = last.points.y[i % kLanes] = last.points.z[i % kLanes] = 0;
            last.weight[i % kLanes] = last.distance2[i % kLanes] = 0;
        }
    }

    /// Sum of weight distance² of the gathered samples to \p faces minus that to the faces they are on.
    /// \param x where the faces' common corner goes \pre Gather was called with it as origin
    double ChangeOfError(const std::vector<StarFace>& faces, const Vector3d& x)
    {
        if (faces.empty()) return 0;
        PrepareTriangles(faces, x);
        double change = 0;
        for (Group& group : groups_) {
            FindNearest(group);
            change += static_cast<double>(SumLanes(group.weight * (group.newDistance2 - group.distance2)));
        }
        return change;
    }

    /// Puts the gathered samples, which were on \p before, where ChangeOfError found them nearest.
    void Attach(const std::vector<std::uint32_t>& before, const std::vector<StarFace>& faces)
    {
        if (faces.empty()) return;
        for (const std::uint32_t face : before) first_[face] = kNone;
        for (std::size_t i = 0; i < gathered_.size(); ++i) {
            const Group& group = groups_[i / kLanes];
            const std::uint32_t face = faces[static_cast<std::size_t>(group.nearest[i % kLanes])].face;
            Sample& sample = samples_[gathered_[i]];
            sample.distance2 = group.newDistance2[i % kLanes];
            sample.next = std::exchange(first_[face], gathered_[i]);
        }
    }
};

/// The guided collapse in the order of measured error, as a Method of CollapseRun.
///
/// Quadrics only estimate what a collapse does to the surface. Here samples of the original, its vertices
/// and face centroids, stay attached to the nearest present faces. Placement and refusals are those of the
/// guided collapse with its cost g; the order is that of
///
///     E    = sum of area e^{2 l} distance² over the samples around the edge, after minus before
///     cost = max(1.8 E sqrt(w_u w_v), .1 g)
///
/// where E is measured for an edge whose .1 g has come up.
template <class Mesh>
class MeasuredCollapse : public GuidedCollapse<Mesh>
{
    using Base = GuidedCollapse<Mesh>;
    using typename Base::CoordType;
    using typename Base::FaceType;
    using typename Base::VertexType;
    using Corner = vcg::face::VFIterator<FaceType>;

    static constexpr double kMeasuredWeight = 1.8;
    /// Part of the guided cost that counts where the measurement sees less.
    static constexpr double kGuidedFloor = .1;
    static constexpr double kImportance = 2;

    MeasuredSamples samples_;
    std::vector<std::uint32_t> edgeFaces_;        ///< scratch: all faces around the edge
    const VertexType* measuredRemoved_ = nullptr; ///< the pair that samples_ was gathered for last
    const VertexType* measuredKept_ = nullptr;
    Vector3d measuredPlacement_{};

    /// e^{2 l}: what a sample counts beside its area.
    double SampleImportance(const VertexType& vertex) const
    {
        return std::exp(kImportance * this->stars_.descriptor(this->IndexOf(vertex)));
    }

    void AddFaces(VertexType& vertex, const VertexType* notWith)
    {
        for (Corner corner(&vertex); !corner.End(); ++corner)
            if (notWith == nullptr || (corner.V1() != notWith && corner.V2() != notWith))
                edgeFaces_.push_back(static_cast<std::uint32_t>(vcg::tri::Index(this->mesh_, corner.F())));
    }

    /// What the error of the samples around the edge becomes minus what it is. \pre starFaces_ are those of
    /// the edge
    double Measure(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        edgeFaces_.clear();
        AddFaces(removed, nullptr);
        AddFaces(kept, &removed);
        samples_.Gather(edgeFaces_, placement);
        measuredRemoved_ = &removed;
        measuredKept_ = &kept;
        measuredPlacement_ = placement;
        return samples_.ChangeOfError(this->starFaces_, placement);
    }

    /// Whether Measure was asked last about this edge, whichever of its ends goes, and this place.
    bool IsMeasured(const VertexType& removed, const VertexType& kept, const Vector3d& placement) const
    {
        const Vector3d apart = measuredPlacement_ - placement;
        return std::minmax(measuredRemoved_, measuredKept_) == std::minmax(&removed, &kept) &&
               !(Dot(apart, apart) > 0);
    }

  public:
    /// \pre as GuidedCollapse
    MeasuredCollapse(Mesh& mesh, GuidedParameters parameters)
        : Base(mesh, std::move(parameters)), samples_(mesh.face.size())
    {
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            const FaceType& face = mesh.face[f];
            if (face.IsD()) continue;
            const auto corner = [&](int k) { return this->EndOf(*face.cV(k)).position; };
            const double importance = (SampleImportance(*face.cV(0)) + SampleImportance(*face.cV(1)) +
                                       SampleImportance(*face.cV(2))) /
                                      3;
            samples_.AddCentroid(static_cast<std::uint32_t>(f), corner(0), corner(1), corner(2), importance);
        }
        for (VertexType& vertex : mesh.vert) {
            if (vertex.IsD()) continue;
            double area = 0;
            for (Corner corner(&vertex); !corner.End(); ++corner)
                area += this->stars_.DoubleArea(*corner.F()) / 6;
            if (vertex.VFp() != nullptr)
                samples_.AddVertex(static_cast<std::uint32_t>(vcg::tri::Index(mesh, vertex.VFp())),
                                   this->EndOf(vertex).position, area * SampleImportance(vertex));
        }
    }

    double Estimate(VertexType& removed, VertexType& kept) const
    {
        return kGuidedFloor * Base::Estimate(removed, kept);
    }

    std::optional<CollapseAssessment> Assess(VertexType& removed, VertexType& kept, double affordable)
    {
        measuredRemoved_ = nullptr; // starFaces_ is about to change
        std::optional<CollapseAssessment> assessment = Base::Assess(removed, kept, affordable);
        if (!assessment) return std::nullopt;
        assessment->cost *= kGuidedFloor;
        assessment->isFinal = assessment->cost <= affordable;
        if (!assessment->isFinal) return assessment;
        const double change = Measure(removed, kept, assessment->placement);
        const double weight = std::sqrt(this->EndOf(removed).weight * this->EndOf(kept).weight);
        assessment->cost = std::max(assessment->cost, kMeasuredWeight * change * weight);
        return assessment;
    }

    CoordType Merge(VertexType& removed, VertexType& kept, const Vector3d& placement)
    {
        if (!IsMeasured(removed, kept, placement)) {
            this->stars_.Gather(removed, kept, this->starFaces_);
            Measure(removed, kept, placement);
        }
        measuredRemoved_ = nullptr;
        samples_.Attach(edgeFaces_, this->starFaces_);
        return Base::Merge(removed, kept, placement);
    }
};

} // namespace vcg_ext
