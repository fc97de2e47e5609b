// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/ordered/guided.h"
#include "vcg_ext/ordered/measured_samples.h"

namespace vcg_ext
{

/// The guided collapse in the order of measured error, as a Method of CollapseRun.
///
/// Quadrics only estimate what a collapse does to the surface. Here samples of the original, its vertices
/// and face centroids, stay attached to the nearest present faces. Placement and refusals are those of the
/// guided collapse with its cost g; the order is that of
///
///     E    = sum of area e^{2 l} distance² over the samples around the edge, after minus before
///     cost = max(60 E sqrt(w_u w_v), .1 g)
///
/// where E is measured for an edge whose .1 g has come up.
template <class Mesh>
class MeasuredCollapse : public GuidedCollapse<Mesh>
{
    using Base = GuidedCollapse<Mesh>;
    using typename Base::CoordType;
    using typename Base::FaceType;
    using typename Base::Point;
    using typename Base::VertexType;
    using Corner = vcg::face::VFIterator<FaceType>;

    static constexpr double kMeasuredWeight = 60;
    /// Part of the guided cost that counts where the measurement sees less.
    static constexpr double kGuidedFloor = .1;
    static constexpr double kImportance = 2;

    MeasuredSamples samples_;
    std::vector<std::uint32_t> edgeFaces_;        ///< scratch: all faces around the edge
    const VertexType* measuredRemoved_ = nullptr; ///< the pair that samples_ was gathered for last
    const VertexType* measuredKept_ = nullptr;
    Point measuredPlacement_{0, 0, 0};

    /// e^{2 l}: what a sample counts beside its area.
    double Importance(const VertexType& vertex) const
    {
        return std::exp(kImportance * this->stars_.vertex(this->IndexOf(vertex)).descriptor);
    }

    void AddFaces(VertexType& vertex, const VertexType* notWith)
    {
        for (Corner corner(&vertex); !corner.End(); ++corner)
            if (notWith == nullptr || (corner.V1() != notWith && corner.V2() != notWith))
                edgeFaces_.push_back(static_cast<std::uint32_t>(vcg::tri::Index(this->mesh_, corner.F())));
    }

    /// What the error of the samples around the edge becomes minus what it is. \pre starFaces_ are those of
    /// the edge, seen from \p origin
    double Measure(VertexType& removed, VertexType& kept, const Point& origin, const Point& placement)
    {
        edgeFaces_.clear();
        AddFaces(removed, nullptr);
        AddFaces(kept, &removed);
        samples_.Gather(edgeFaces_, placement);
        measuredRemoved_ = &removed;
        measuredKept_ = &kept;
        measuredPlacement_ = placement;
        return samples_.ChangeOfError(this->starFaces_, placement - origin);
    }

  public:
    /// \pre as GuidedCollapse
    MeasuredCollapse(Mesh& mesh, GuidedParameters parameters)
        : Base(mesh, std::move(parameters)), samples_(mesh.face.size())
    {
        for (std::size_t f = 0; f < mesh.face.size(); ++f) {
            const FaceType& face = mesh.face[f];
            if (face.IsD()) continue;
            const auto corner = [&](int k) {
                return this->stars_.vertex(this->IndexOf(*face.cV(k))).position;
            };
            const double importance =
                (Importance(*face.cV(0)) + Importance(*face.cV(1)) + Importance(*face.cV(2))) / 3;
            samples_.AddCentroid(static_cast<std::uint32_t>(f), corner(0), corner(1), corner(2), importance);
        }
        for (VertexType& vertex : mesh.vert) {
            if (vertex.IsD()) continue;
            double area = 0;
            for (Corner corner(&vertex); !corner.End(); ++corner)
                area += this->stars_.DoubleArea(*corner.F()) / 6;
            if (vertex.VFp() != nullptr)
                samples_.AddVertex(static_cast<std::uint32_t>(vcg::tri::Index(mesh, vertex.VFp())),
                                   this->stars_.vertex(this->IndexOf(vertex)).position,
                                   area * Importance(vertex));
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
        const GuidedVertex& from = this->stars_.vertex(this->IndexOf(removed));
        const GuidedVertex& into = this->stars_.vertex(this->IndexOf(kept));
        const double change =
            Measure(removed, kept, (from.position + into.position) / 2, assessment->placement);
        assessment->cost =
            std::max(assessment->cost, kMeasuredWeight * change * std::sqrt(from.weight * into.weight));
        return assessment;
    }

    CoordType Merge(VertexType& removed, VertexType& kept, const Point& placement)
    {
        if (measuredRemoved_ != &removed || measuredKept_ != &kept || measuredPlacement_ != placement) {
            const Point origin = this->stars_.vertex(this->IndexOf(removed)).position;
            this->stars_.Gather(removed, kept, origin, this->starFaces_);
            Measure(removed, kept, origin, placement);
        }
        measuredRemoved_ = nullptr;
        samples_.Attach(edgeFaces_, this->starFaces_);
        return Base::Merge(removed, kept, placement);
    }
};

} // namespace vcg_ext
