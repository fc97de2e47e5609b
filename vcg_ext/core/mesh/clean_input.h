// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/first_equal.h"
#include "vcg_ext/core/base/parallel.h"
#include "vcg_ext/core/mesh/corner_attributes.h"
#include "vcg_ext/core/mesh/mesh_view.h"
#include "vcg_ext/core/mesh/surface.h"
#include "vcg_ext/core/mesh/weld.h"
#include "vcg_ext/core/parameters.h"

namespace vcg_ext
{

/// What was wrong with a mesh, and was put right.
struct CleaningReport {
    std::size_t weldedVertices = 0;  ///< now one with another vertex
    std::size_t degenerateFaces = 0; ///< left out: the same vertex at two corners
    std::size_t duplicateFaces = 0;  ///< left out: the same corners in the same cyclic order as another face

    std::size_t DroppedFaces() const { return degenerateFaces + duplicateFaces; }
};

/// A mesh without degenerate and duplicate faces whose open borders are joined where they meet. Vertices keep
/// their indices: those that are welded are on no face anymore. What is clean is read in place.
class CleanedInput
{
    MeshView view_;
    CleaningReport report_;
    std::vector<std::uint32_t> triangles_;  // empty: those of the input
    std::vector<std::uint32_t> faceOrigin_; // of the faces that are left; empty: all are
    std::vector<std::uint8_t> fauxEdges_;
    CornerAttributes attributes_;
    std::vector<float> cornerValues_;
    std::vector<std::int32_t> labels_;

  public:
    /// \param weldDistance in the mesh's unit of length: border vertices no farther apart become one; 0:
    /// those
    ///        at equal coordinates
    CleanedInput(const MeshView& view, double weldDistance, int threads) : view_(view)
    {
        const auto weld = WeldedVertices(view, weldDistance, threads);
        if (!weld.empty()) {
            triangles_.assign(view.triangles, view.triangles + 3 * view.faceCount);
            for (std::uint32_t& v : triangles_) v = weld[v];
            for (std::uint32_t v = 0; v < weld.size(); ++v) report_.weldedVertices += weld[v] != v;
            view_.triangles = triangles_.data();
        }
        DropFaces(threads);
    }
    CleanedInput(const CleanedInput&) = delete;
    CleanedInput& operator=(const CleanedInput&) = delete;

    const MeshView& View() const { return view_; }
    const CleaningReport& Report() const { return report_; }

    /// The input's face that the view's face is.
    std::uint32_t FaceOrigin(std::uint32_t face) const
    {
        return faceOrigin_.empty() ? face : faceOrigin_[face];
    }

  private:
    std::array<std::uint32_t, 3> Corners(std::size_t face) const
    {
        const std::uint32_t* v = view_.triangles + 3 * face;
        return {v[0], v[1], v[2]};
    }

    /// Its corners, the lowest first, in the same cyclic order.
    std::array<std::uint32_t, 3> Key(std::size_t face) const
    {
        auto v = Corners(face);
        std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
        return v;
    }

    void DropFaces(int threads)
    {
        const auto hash = [&](std::size_t face) {
            const auto key = Key(face);
            return Mixed((std::uint64_t{key[0]} << 32U | key[1]) + Mixed(key[2]));
        };
        const auto first = FirstEqual(UsefulThreadCount(threads, view_.faceCount), view_.faceCount, hash,
                                      [&](std::size_t a, std::size_t b) { return Key(a) == Key(b); });
        std::vector<std::uint32_t> kept;
        for (std::uint32_t f = 0; f < view_.faceCount; ++f) {
            const auto v = Corners(f);
            const bool degenerate = v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
            const bool duplicate = !degenerate && !first.empty() && first[f] != f;
            report_.degenerateFaces += degenerate;
            report_.duplicateFaces += duplicate;
            if (report_.DroppedFaces() == 0) continue;
            if (kept.empty() && report_.DroppedFaces() == 1 && (degenerate || duplicate))
                for (std::uint32_t before = 0; before < f; ++before) kept.push_back(before);
            if (!degenerate && !duplicate) kept.push_back(f);
        }
        if (report_.DroppedFaces()) Keep(std::move(kept));
    }

    void Keep(std::vector<std::uint32_t> faces)
    {
        std::vector<std::uint32_t> triangles;
        triangles.reserve(3 * faces.size());
        for (const std::uint32_t f : faces) {
            for (const std::uint32_t v : Corners(f)) triangles.push_back(v);
            if (view_.fauxEdges) fauxEdges_.push_back(view_.fauxEdges[f]);
        }
        triangles_ = std::move(triangles);
        view_.triangles = triangles_.data();
        view_.faceCount = faces.size();
        if (view_.fauxEdges) view_.fauxEdges = fauxEdges_.data();
        if (view_.attributes) KeepAttributes(faces);
        faceOrigin_ = std::move(faces);
    }

    /// Values and labels go with their faces; corners keep theirs where vertices are welded.
    void KeepAttributes(const std::vector<std::uint32_t>& faces)
    {
        const CornerAttributes& input = *view_.attributes;
        attributes_ = input;
        const std::size_t size = 3 * input.Channels();
        if (input.values) cornerValues_.reserve(size * faces.size());
        for (const std::uint32_t f : faces) {
            if (input.values)
                cornerValues_.insert(cornerValues_.end(), input.Corner(f, 0), input.Corner(f, 0) + size);
            if (input.labels) labels_.push_back(input.labels[f]);
        }
        if (input.values) attributes_.values = cornerValues_.data();
        if (input.labels) attributes_.labels = labels_.data();
        view_.attributes = &attributes_;
    }
};

/// DecimationParameters::weldDistance in the mesh's unit of length.
inline double WeldDistance(const MeshView& view, const DecimationParameters& parameters)
{
    if (!(parameters.weldDistance > 0)) return 0;
    return parameters.weldDistance / 100 * kFrameDiagonal * FrameOf(view).unit;
}

} // namespace vcg_ext
