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
