// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/geometry/point_triangle.h"
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

} // namespace vcg_ext
