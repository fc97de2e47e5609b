# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The metric tool against shapes whose distances are known on paper."""

import igl
import numpy as np
import pytest

from mesh_topology import Mesh, edges_of, read_mesh, sharp_vertices, topology_counts, welded
from metrics import Original, laplacian_descriptor, measure

SAMPLES = 20_000


def grid(steps: int) -> Mesh:
    """The unit square in the plane z = 0."""
    line = np.linspace(0, 1, steps + 1)
    x, y = np.meshgrid(line, line)
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    first = (np.arange(steps)[:, None] * (steps + 1) + np.arange(steps)).ravel()
    right, up = first + 1, first + steps + 1
    faces = np.concatenate([np.stack([first, right, up + 1], axis=1), np.stack([first, up + 1, up], axis=1)])
    return Mesh(vertices, faces)


def icosphere(levels: int) -> Mesh:
    """The unit sphere, from an icosahedron subdivided `levels` times."""
    vertices, faces = igl.icosahedron()
    for _ in range(levels):
        vertices, faces = igl.upsample(vertices, faces, 1)
        vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    return Mesh(np.asarray(vertices), np.asarray(faces, dtype=np.int64))


def cube() -> Mesh:
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    return Mesh(vertices, np.array(faces))


def test_a_mesh_is_at_no_distance_from_itself():
    sphere = icosphere(3)
    values = measure(Original(sphere, SAMPLES), sphere)
    for name in ("rms", "feature_rms", "hausdorff"):
        assert values[name] < 1e-6
    assert values["normal_deviation"] < 1e-3
    assert values["folded_faces"] == 0


def test_a_shifted_plane_is_at_the_shift():
    plane, shift = grid(10), 0.01
    shifted = Mesh(plane.vertices + [0, 0, shift], plane.faces)
    values = measure(Original(plane, SAMPLES), shifted)
    for name in ("rms", "feature_rms", "hausdorff"):
        assert values[name] == pytest.approx(100 * shift / np.sqrt(2), rel=1e-12)
    assert values["normal_deviation"] == pytest.approx(0, abs=1e-9)


def test_a_scaled_sphere_is_at_the_difference_of_the_radii():
    sphere, scale = icosphere(5), 1.02
    original = Original(sphere, SAMPLES)
    values = measure(original, Mesh(scale * sphere.vertices, sphere.faces))
    expected = 100 * (scale - 1) / sphere.diagonal
    assert values["rms"] == pytest.approx(expected, rel=2e-3)  # facets of 5 subdivisions: within 0.1 %
    assert values["hausdorff"] == pytest.approx(expected, rel=2e-3)


def test_a_tilted_plane_deviates_by_its_angle():
    plane = grid(10)
    tilt = np.radians(5)
    tilted = Mesh(plane.vertices @ np.array([[1, 0, np.tan(tilt)], [0, 1, 0], [0, 0, 1]]), plane.faces)
    assert measure(Original(plane, SAMPLES), tilted)["normal_deviation"] == pytest.approx(5, abs=1e-6)


def test_hausdorff_sees_one_vertex_that_samples_would_miss():
    plane = grid(100)
    vertices = plane.vertices.copy()
    vertices[5000, 2] = 0.3
    values = measure(Original(plane, 100), Mesh(vertices, plane.faces))
    assert values["hausdorff"] == pytest.approx(100 * 0.3 / np.sqrt(2), rel=1e-9)


def test_a_face_turned_over_is_counted():
    sphere = icosphere(3)
    faces = sphere.faces.copy()
    faces[7] = faces[7, ::-1]
    assert measure(Original(sphere, SAMPLES), Mesh(sphere.vertices, faces))["folded_faces"] == 1


def test_the_descriptor_is_zero_on_a_plane_and_closed_form_on_a_pyramid():
    plane = grid(4)
    assert laplacian_descriptor(plane).max() < 1e-12
    height, sides = 0.5, 6
    angle = 2 * np.pi * np.arange(sides) / sides
    base = np.stack([np.cos(angle), np.sin(angle), np.zeros(sides)], axis=1)
    apex = [[0, 0, height]]
    faces = np.array([[i, (i + 1) % sides, sides] for i in range(sides)])
    pyramid = Mesh(np.concatenate([base, apex]), faces)
    assert laplacian_descriptor(pyramid)[sides] == pytest.approx(height / np.hypot(1, height), rel=1e-12)


def test_every_vertex_of_a_cube_is_sharp_and_none_of_a_fine_sphere():
    box, sphere = cube(), icosphere(3)
    assert len(sharp_vertices(box, edges_of(box))) == 8
    assert len(sharp_vertices(sphere, edges_of(sphere))) == 0


def test_topology_of_a_closed_a_doubled_and_a_pinched_mesh():
    box = cube()
    clean = topology_counts(box)
    assert (clean["boundary_edges"], clean["non_manifold_edges"], clean["non_manifold_vertices"]) == (0, 0, 0)
    doubled = topology_counts(Mesh(box.vertices, np.concatenate([box.faces, box.faces[:1]])))
    assert (doubled["duplicate_faces"], doubled["non_manifold_edges"]) == (1, 3)
    # Two cubes that share one corner and nothing else.
    other = np.where(box.faces == 0, 7, box.faces + 8)
    vertices = np.concatenate([box.vertices, box.vertices + 1])
    pinched = topology_counts(Mesh(vertices, np.concatenate([box.faces, other])))
    assert (pinched["non_manifold_vertices"], pinched["non_manifold_edges"]) == (1, 0)
    collapsed = topology_counts(Mesh(box.vertices, np.concatenate([box.faces, [[0, 0, 1]]])))
    assert collapsed["degenerate_faces"] == 1


def test_welding_closes_a_triangle_soup():
    box = cube()
    soup = Mesh(box.vertices[box.faces.reshape(-1)], np.arange(36).reshape(-1, 3))
    assert topology_counts(soup)["boundary_edges"] == 36
    assert topology_counts(welded(soup)) == topology_counts(box)


@pytest.mark.parametrize("suffix", ["ply", "off", "obj"])
def test_all_formats_are_read(tmp_path, suffix):
    box = cube()
    path = tmp_path / f"cube.{suffix}"
    igl.write_triangle_mesh(str(path), box.vertices, box.faces)
    assert topology_counts(read_mesh(path)) == topology_counts(box)
