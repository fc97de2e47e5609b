// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "analytic_meshes.h"

/// What can be wrong with a mesh, counted.
namespace test_meshes
{

struct Defects {
    int nonManifoldEdges = 0; ///< three faces or more
    int nonManifoldFans = 0;  ///< fans of faces at a vertex beyond the first
    int duplicateFaces = 0;
    int degenerateFaces = 0; ///< a vertex twice, or no area
    int eulerCharacteristic = 0;
    int borderEdges = 0;
};

inline double TriangleArea(const IndexedMesh& mesh, const Triangle& t)
{
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double n = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        squared += n * n;
    }
    return std::sqrt(squared) / 2;
}

/// Fans of faces around \p vertex that hang together by edges at it.
inline int CountFans(std::uint32_t vertex, const std::vector<Triangle>& star)
{
    std::vector<std::size_t> fan(star.size());
    std::iota(fan.begin(), fan.end(), 0);
    const auto shareEdge = [vertex](const Triangle& s, const Triangle& t) {
        return std::any_of(s.begin(), s.end(), [&](std::uint32_t v) {
            return v != vertex && std::find(t.begin(), t.end(), v) != t.end();
        });
    };
    for (std::size_t i = 0; i < star.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (shareEdge(star[i], star[j])) std::replace(fan.begin(), fan.end(), fan[i], fan[j]);
    return static_cast<int>(std::set<std::size_t>(fan.begin(), fan.end()).size());
}

inline Defects FindDefects(const IndexedMesh& mesh)
{
    Defects defects;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::set<Triangle> faces;
    std::map<std::uint32_t, std::vector<Triangle>> stars;
    for (const Triangle& t : mesh.triangles) {
        Triangle sorted = t;
        std::sort(sorted.begin(), sorted.end());
        defects.duplicateFaces += !faces.insert(sorted).second;
        defects.degenerateFaces += !(TriangleArea(mesh, t) > 0);
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[std::minmax(t[k], t[(k + 1) % 3])];
            stars[t[k]].push_back(t);
        }
    }
    for (const auto& [edge, count] : edges) {
        defects.nonManifoldEdges += count > 2;
        defects.borderEdges += count == 1;
    }
    for (const auto& [vertex, star] : stars) defects.nonManifoldFans += CountFans(vertex, star) - 1;
    defects.eulerCharacteristic = static_cast<int>(stars.size()) - static_cast<int>(edges.size()) +
                                  static_cast<int>(mesh.triangles.size());
    return defects;
}

} // namespace test_meshes
