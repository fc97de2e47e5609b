// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "vcg_ext/core/mesh/mesh_view.h"

/// Meshes whose truth is known by formula, as plain arrays. Closed ones are oriented outwards, flat ones
/// upwards (+z).
namespace test_meshes
{

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double kPi = 3.14159265358979323846;

struct IndexedMesh {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> fauxEdges; ///< a byte a face, bit k: the edge from vertex k to k + 1 is a
                                         ///< polygon's diagonal; empty: none

    void AddTriangle(std::size_t a, std::size_t b, std::size_t c)
    {
        triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    }
    /// The quad a b c d as two triangles; their common edge a c is faux where \p faux.
    void AddQuad(std::size_t a, std::size_t b, std::size_t c, std::size_t d, bool faux)
    {
        AddTriangle(a, b, c);
        AddTriangle(a, c, d);
        if (!faux) return;
        fauxEdges.resize(triangles.size() - 2, 0);
        fauxEdges.insert(fauxEdges.end(), {4, 1});
    }
};

/// The mesh as decimations and descriptors read it. \pre \p mesh outlives the view
inline vcg_ext::MeshView View(const IndexedMesh& mesh)
{
    vcg_ext::MeshView view;
    view.positions = mesh.points.data();
    view.positionStride = sizeof(Point);
    view.doublePositions = true;
    view.vertexCount = mesh.points.size();
    view.triangles = reinterpret_cast<const std::uint32_t*>(mesh.triangles.data());
    view.faceCount = mesh.triangles.size();
    return view;
}

/// columns x rows squares of side \p spacing in the plane z = 0; vertex (i, j) is i + j (columns + 1).
/// \param quads the diagonals are faux
inline IndexedMesh Grid(int columns, int rows, double spacing = 1, bool quads = false)
{
    IndexedMesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) mesh.points.push_back({i * spacing, j * spacing, 0});
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(i + j * (columns + 1)); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            mesh.AddQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), quads);
    return mesh;
}

/// The lateral faces of a regular pyramid: vertex 0 is the apex (0, 0, height), the others a regular polygon
/// of that radius in z = 0.
inline IndexedMesh Pyramid(int sides, double radius = 1, double height = 1)
{
    IndexedMesh mesh;
    mesh.points.push_back({0, 0, height});
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * kPi * i / sides;
        mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    for (int i = 0; i < sides; ++i)
        mesh.AddTriangle(0, static_cast<std::size_t>(1 + i), static_cast<std::size_t>(1 + (i + 1) % sides));
    return mesh;
}

/// The cube [0, side]^3, every side of it \p divisions x divisions squares, closed, with its sharp edges.
inline IndexedMesh Box(int divisions, double side = 1, bool quads = false)
{
    IndexedMesh mesh;
    std::map<std::array<int, 3>, std::size_t> index;
    const auto vertex = [&](std::array<int, 3> p) {
        const auto [at, fresh] = index.emplace(p, mesh.points.size());
        if (fresh)
            mesh.points.push_back(
                {p[0] * side / divisions, p[1] * side / divisions, p[2] * side / divisions});
        return at->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int level : {0, divisions})
            for (int i = 0; i < divisions; ++i)
                for (int j = 0; j < divisions; ++j) {
                    const auto corner = [&](int first, int second) {
                        std::array<int, 3> p{};
                        p[axis] = level; // the lower sides are wound the other way
                        p[(axis + 1) % 3] = level == 0 ? second : first;
                        p[(axis + 2) % 3] = level == 0 ? first : second;
                        return vertex(p);
                    };
                    const std::size_t a = corner(i, j), b = corner(i + 1, j);
                    const std::size_t c = corner(i + 1, j + 1), d = corner(i, j + 1);
                    mesh.AddQuad(a, b, c, d, quads);
                }
    return mesh;
}

/// Four faces from each, in its plane. \pre triangles only
inline IndexedMesh SubdividedAtMidpoints(IndexedMesh mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, fresh] = middles.emplace(std::minmax(a, b), mesh.points.size());
        const Point p = mesh.points[a], q = mesh.points[b];
        if (fresh) mesh.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
        return at->second;
    };
    const auto coarse = std::exchange(mesh.triangles, {});
    for (const auto& [a, b, c] : coarse) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        mesh.triangles.insert(mesh.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return mesh;
}

/// The icosahedron on the unit sphere, every face split in four \p levels times: 20 * 4^levels faces.
inline IndexedMesh Icosphere(int levels)
{
    const double t = (1 + std::sqrt(5.0)) / 2;
    IndexedMesh mesh;
    mesh.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                   {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        mesh = SubdividedAtMidpoints(mesh);
        for (Point& p : mesh.points) {
            const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            for (double& x : p) x /= length;
        }
    }
    return mesh;
}

/// A grid of squares bent into a surface of revolution about z; \p profile(j) is {radius, z}.
/// \param closed the last row of squares leads back to the first profile point
template <class Profile>
IndexedMesh Revolved(int around, int along, bool closed, bool quads, const Profile& profile)
{
    IndexedMesh mesh;
    const int rings = closed ? along : along + 1;
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * kPi * i / around;
            const std::array<double, 2> p = profile(j);
            mesh.points.push_back({p[0] * std::cos(angle), p[0] * std::sin(angle), p[1]});
        }
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(i % around + j % rings * around); };
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i)
            mesh.AddQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), quads);
    return mesh;
}

/// A torus about z, closed.
inline IndexedMesh Torus(int around, int along, double major = 1, double minor = 0.4, bool quads = false)
{
    return Revolved(around, along, true, quads, [=](int j) {
        const double angle = 2 * kPi * j / along;
        return std::array<double, 2>{major + minor * std::cos(angle), minor * std::sin(angle)};
    });
}

/// A cylinder about z without its lids: two open borders.
inline IndexedMesh OpenCylinder(int around, int along, double radius = 1, double height = 2)
{
    return Revolved(around, along, false, false, [=](int j) {
        return std::array<double, 2>{radius, height * j / along};
    });
}

/// \p pages triangles on the one edge 0 1 (the z axis): non-manifold from three pages on.
inline IndexedMesh Book(int pages)
{
    IndexedMesh mesh;
    mesh.points = {{0, 0, 0}, {0, 0, 1}};
    for (int i = 0; i < pages; ++i) {
        const double angle = 2 * kPi * i / pages;
        mesh.points.push_back({std::cos(angle), std::sin(angle), 0.5});
        mesh.AddTriangle(0, 1, static_cast<std::size_t>(2 + i));
    }
    return mesh;
}

/// Both meshes as components of one.
inline IndexedMesh Merged(IndexedMesh a, const IndexedMesh& b)
{
    const auto offset = static_cast<std::uint32_t>(a.points.size());
    a.fauxEdges.resize(a.triangles.size(), 0);
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    a.fauxEdges.insert(a.fauxEdges.end(), b.fauxEdges.begin(), b.fauxEdges.end());
    a.fauxEdges.resize(a.triangles.size(), 0);
    return a;
}

/// A sphere in a slightly larger one that looks the other way: a shell with an inside and an outside.
inline IndexedMesh Shell(int levels, double thickness)
{
    IndexedMesh inner = Icosphere(levels);
    for (auto& p : inner.points)
        for (double& x : p) x *= 1 - thickness;
    for (auto& t : inner.triangles) std::swap(t[1], t[2]);
    return Merged(Icosphere(levels), inner);
}

/// Two pyramids that share nothing but their apex: a non-manifold vertex (0).
inline IndexedMesh BowTie()
{
    IndexedMesh mesh = Pyramid(4);
    const IndexedMesh other = Pyramid(4, 1, -1);
    for (std::size_t v = 1; v < other.points.size(); ++v)
        mesh.points.push_back({other.points[v][0], other.points[v][1], 2});
    for (const Triangle& t : other.triangles) mesh.AddTriangle(0, t[2] + 4, t[1] + 4);
    return mesh;
}

/// \p count vertices that no face uses, behind the others.
inline IndexedMesh WithIsolatedVertices(IndexedMesh mesh, int count)
{
    for (int i = 0; i < count; ++i) mesh.points.push_back({10.0 + i, 10, 10});
    return mesh;
}

/// Every coordinate shifted by up to \p amplitude, the same on every run.
inline IndexedMesh Noisy(IndexedMesh mesh, double amplitude, unsigned seed = 1)
{
    std::mt19937 random(seed);
    for (Point& p : mesh.points)
        for (double& x : p) x += amplitude * (static_cast<double>(random()) / 2147483648.0 - 1);
    return mesh;
}

/// Rotated by the angle about the axis (1, 2, 3), then scaled, then shifted.
inline IndexedMesh Moved(IndexedMesh mesh, double angle, double scale, Point shift)
{
    const double n = std::sqrt(14.0);
    const Point axis{1 / n, 2 / n, 3 / n};
    const double c = std::cos(angle), s = std::sin(angle);
    for (Point& p : mesh.points) {
        const double along = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
        Point turned{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            turned[k] = c * p[k] + s * (axis[l] * p[m] - axis[m] * p[l]) + (1 - c) * along * axis[k];
        }
        for (std::size_t k = 0; k < 3; ++k) p[k] = scale * turned[k] + shift[k];
    }
    return mesh;
}

} // namespace test_meshes
