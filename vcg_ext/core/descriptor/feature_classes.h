// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/descriptor/kmeans_1d.h"
#include "vcg_ext/core/mesh/one_ring.h"

namespace vcg_ext
{

/// How vertices are told apart. The defaults are those of the filter.
struct FeatureParameters {
    int classes = 2;                  ///< k of Eq. 8, [2, 16]
    int selectedClasses = 1;          ///< how many of the highest are features, [1, classes - 1]
    bool refine = false;              ///< Section 4.4
    int minimumFeatureNeighbours = 2; ///< the refinement looks after features with fewer, >= 1
    double refinementFloor = 0.5;     ///< part of the threshold below which no vertex is promoted, [0, 1]
};

/// The outcome; one entry a vertex where nothing else is said.
struct FeatureClasses {
    Clusters clusters;                   ///< of the descriptor of the vertices on faces
    std::vector<std::uint8_t> classOf;   ///< 0 is the lowest; 0 for vertices without faces
    std::vector<std::uint8_t> isFeature; ///< 1 in one of the selected classes, or promoted
    std::vector<std::uint32_t> promoted; ///< by the refinement, in the order in which it happened
};

namespace feature_detail
{

inline void Check(const MeshView& mesh, const std::vector<double>& descriptor,
                  const FeatureParameters& parameters)
{
    const auto refuse = [](const std::string& name, const std::string& value, const std::string& range) {
        throw std::invalid_argument(name + " = " + value + " is outside " + range);
    };
    const int k = parameters.classes;
    if (descriptor.size() != mesh.vertexCount)
        throw std::invalid_argument(std::to_string(descriptor.size()) + " descriptor values for " +
                                    std::to_string(mesh.vertexCount) + " vertices");
    if (k < 2 || k > 16) refuse("classes", std::to_string(k), "[2, 16]");
    if (parameters.selectedClasses < 1 || parameters.selectedClasses >= k)
        refuse("selected_classes", std::to_string(parameters.selectedClasses),
               "[1, " + std::to_string(k - 1) + "]");
    if (parameters.minimumFeatureNeighbours < 1)
        refuse("minimum_feature_neighbours", std::to_string(parameters.minimumFeatureNeighbours),
               "[1, infinity)");
    if (!(parameters.refinementFloor >= 0 && parameters.refinementFloor <= 1))
        refuse("refinement_floor", std::to_string(parameters.refinementFloor), "[0, 1]");
}

/// Section 4.4: promotes neighbours of features that have fewer feature neighbours than they should.
class Refinement
{
    const OneRings& rings_;
    const std::vector<double>& descriptor_;
    std::vector<std::uint8_t>& isFeature_;
    const std::size_t minimum_;
    const double floor_;
    std::vector<std::uint32_t> room_;

    /// A candidate and the feature that it would be promoted for; the largest descriptor comes first, of
    /// equal ones that of the smaller indices.
    struct Candidate {
        double descriptor;
        std::uint32_t vertex, feature;

        bool operator<(const Candidate& other) const
        {
            return std::tie(descriptor, other.vertex, other.feature) <
                   std::tie(other.descriptor, vertex, feature);
        }
    };
    std::priority_queue<Candidate> candidates_;

    bool IsLonely(std::size_t feature)
    {
        const auto neighbours = rings_.Neighbours(feature, room_);
        const auto count = std::count_if(neighbours.begin(), neighbours.end(),
                                         [&](std::uint32_t v) { return isFeature_[v] != 0; });
        return static_cast<std::size_t>(count) < minimum_;
    }
    void Propose(std::size_t feature)
    {
        if (!IsLonely(feature)) return;
        for (const std::uint32_t v : rings_.Neighbours(feature, room_))
            if (!isFeature_[v] && descriptor_[v] >= floor_)
                candidates_.push({descriptor_[v], v, static_cast<std::uint32_t>(feature)});
    }

  public:
    Refinement(const OneRings& rings, const std::vector<double>& descriptor,
               std::vector<std::uint8_t>& isFeature, int minimumFeatureNeighbours, double floor)
        : rings_(rings), descriptor_(descriptor), isFeature_(isFeature),
          minimum_(static_cast<std::size_t>(minimumFeatureNeighbours)), floor_(floor)
    {
    }

    /// The promoted vertices. Stops when every feature has its neighbours or no candidate reaches the floor.
    std::vector<std::uint32_t> Run()
    {
        std::vector<std::uint32_t> promoted;
        for (std::size_t v = 0; v < isFeature_.size(); ++v)
            if (isFeature_[v]) Propose(v);
        while (!candidates_.empty()) {
            const Candidate best = candidates_.top();
            candidates_.pop();
            if (isFeature_[best.vertex] || !IsLonely(best.feature)) continue;
            isFeature_[best.vertex] = 1;
            promoted.push_back(best.vertex);
            Propose(best.vertex);
        }
        return promoted;
    }
};

} // namespace feature_detail

/// Tells features from the rest by a descriptor: optimal k-means (Eq. 8), and the refinement of Section 4.4
/// where asked for. The refinement only ever adds vertices; each was, when it was added, the neighbour with
/// the largest descriptor of a feature with too few feature neighbours.
/// \param descriptor one value a vertex \pre as OneRings
/// \throws std::invalid_argument where a parameter is outside its range, a value is not finite, or there are
///         fewer distinct values than classes
inline FeatureClasses ClassifyFeatures(const MeshView& mesh, const std::vector<double>& descriptor,
                                       const FeatureParameters& parameters)
{
    feature_detail::Check(mesh, descriptor, parameters);
    const OneRings rings(mesh);
    std::vector<double> onFaces;
    for (std::size_t v = 0; v < mesh.vertexCount; ++v)
        if (rings.Corners(v).size() > 0) onFaces.push_back(descriptor[v]);

    FeatureClasses result;
    result.clusters = KMeans1D(onFaces, parameters.classes);
    result.classOf.resize(mesh.vertexCount, 0);
    result.isFeature.resize(mesh.vertexCount, 0);
    const auto lowestFeatureClass = static_cast<std::size_t>(parameters.classes - parameters.selectedClasses);
    for (std::size_t v = 0; v < mesh.vertexCount; ++v) {
        if (rings.Corners(v).size() == 0) continue;
        const std::size_t c = result.clusters.ClassOf(descriptor[v]);
        result.classOf[v] = static_cast<std::uint8_t>(c);
        result.isFeature[v] = c >= lowestFeatureClass;
    }
    if (!parameters.refine) return result;
    const double floor = parameters.refinementFloor * result.clusters.thresholds[lowestFeatureClass - 1];
    result.promoted = feature_detail::Refinement(rings, descriptor, result.isFeature,
                                                 parameters.minimumFeatureNeighbours, floor)
                          .Run();
    return result;
}

} // namespace vcg_ext
