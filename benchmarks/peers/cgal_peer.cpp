// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// CGAL's edge collapse by Lindstrom-Turk and by Garland-Heckbert, both with bounded normal change.

#include "peer_interface.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <array>
#include <vector>

namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
namespace simplification = CGAL::Surface_mesh_simplification;
namespace processing = CGAL::Polygon_mesh_processing;

/// Stops where few enough faces are left; CGAL 5.5's own predicates count edges.
struct FaceCountStop {
    std::size_t targetFaces;

    template <class Profile>
    bool operator()(double /*cost*/, const Profile& profile, std::size_t /*initial*/,
                    std::size_t /*current*/) const
    {
        return profile.surface_mesh().number_of_faces() <= targetFaces;
    }
};

/// CGAL's meshes have no non-manifold vertices: they are split here, before the clock runs.
SurfaceMesh ToSurfaceMesh(const PeerMesh& mesh)
{
    std::vector<Point> points(mesh.pointCount);
    for (std::size_t v = 0; v < mesh.pointCount; ++v) {
        const float* point = mesh.points + 3 * v;
        points[v] = Point(point[0], point[1], point[2]);
    }
    std::vector<std::array<std::size_t, 3>> faces(mesh.faceCount);
    for (std::size_t f = 0; f < mesh.faceCount; ++f) {
        const std::uint32_t* corner = mesh.corners + 3 * f;
        faces[f] = {corner[0], corner[1], corner[2]};
    }
    if (!processing::is_polygon_soup_a_polygon_mesh(faces)) processing::orient_polygon_soup(points, faces);
    SurfaceMesh surface;
    processing::polygon_soup_to_polygon_mesh(points, faces, surface);
    return surface;
}

bool FromSurfaceMesh(SurfaceMesh& surface, PeerMesh& mesh)
{
    surface.collect_garbage();
    if (surface.number_of_vertices() > mesh.pointCount || surface.number_of_faces() > mesh.faceCount)
        return false;
    mesh.pointCount = surface.number_of_vertices();
    mesh.faceCount = surface.number_of_faces();
    float* coordinate = mesh.points;
    for (const auto v : surface.vertices()) {
        for (int axis = 0; axis < 3; ++axis) *coordinate++ = static_cast<float>(surface.point(v)[axis]);
    }
    std::uint32_t* corner = mesh.corners;
    for (const auto f : surface.faces()) {
        for (const auto v : surface.vertices_around_face(surface.halfedge(f))) *corner++ = v.idx();
    }
    return true;
}

} // namespace

extern "C" int LindstromTurk(PeerMesh* mesh)
{
    SurfaceMesh surface = ToSurfaceMesh(*mesh);
    {
        const PeerTimer timer(*mesh);
        simplification::edge_collapse(
            surface, FaceCountStop{mesh->targetFaces},
            CGAL::parameters::get_cost(simplification::LindstromTurk_cost<SurfaceMesh>())
                .get_placement(simplification::LindstromTurk_placement<SurfaceMesh>())
                .filter(simplification::Bounded_normal_change_filter<>()));
    }
    return FromSurfaceMesh(surface, *mesh) ? 0 : 1;
}

extern "C" int GarlandHeckbert(PeerMesh* mesh)
{
    SurfaceMesh surface = ToSurfaceMesh(*mesh);
    {
        const PeerTimer timer(*mesh);
        simplification::GarlandHeckbert_plane_policies<SurfaceMesh, Kernel> policies(surface);
        simplification::edge_collapse(surface, FaceCountStop{mesh->targetFaces},
                                      CGAL::parameters::get_cost(policies.get_cost())
                                          .get_placement(policies.get_placement())
                                          .filter(simplification::Bounded_normal_change_filter<>()));
    }
    return FromSurfaceMesh(surface, *mesh) ? 0 : 1;
}
