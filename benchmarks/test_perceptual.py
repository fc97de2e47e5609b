# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The perceptual difference: what it must not see, and what it must."""

import igl
import numpy as np
import pytest
from scipy.spatial import KDTree

from mesh_topology import Mesh
from metrics import Surface
from perceptual import Look, perceptual_difference
from test_metrics import cube, grid, icosphere


def difference(original: Mesh, other: Mesh) -> float:
    return perceptual_difference(Look(Surface(original), original.diagonal), Look(Surface(other), original.diagonal))


def noisy(mesh: Mesh, strength: float) -> Mesh:
    """Every vertex moved along a random direction, the same one for every strength."""
    directions = np.random.default_rng(1).normal(size=mesh.vertices.shape)
    return Mesh(mesh.vertices + strength * mesh.diagonal * directions, mesh.faces)


def test_a_mesh_looks_like_itself():
    for mesh in (icosphere(4), cube(), grid(20)):
        assert difference(mesh, mesh) < 1e-6


def test_more_noise_is_seen_more():
    sphere = icosphere(5)
    seen = [difference(sphere, noisy(sphere, strength)) for strength in (1e-5, 1e-4, 1e-3)]
    assert 0 < seen[0] < seen[1] < seen[2] < 1


def test_the_two_may_change_places():
    sphere = icosphere(5)
    rough = noisy(sphere, 1e-3)
    diagonal = sphere.diagonal
    one, other = Look(Surface(sphere), diagonal), Look(Surface(rough), diagonal)
    assert perceptual_difference(one, other) == perceptual_difference(other, one)


def test_position_turn_and_scale_do_not_matter():
    sphere = icosphere(4)
    rough = noisy(sphere, 1e-3)
    turn, _ = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))
    turn *= np.linalg.det(turn)  # a rotation, not a reflection
    # The unit of length is the diagonal of the box, which turns with the axes: that of the unturned original is kept.
    moved, moved_rough = (Mesh(7 * mesh.vertices @ turn.T + 3, mesh.faces) for mesh in (sphere, rough))
    turned = perceptual_difference(
        Look(Surface(moved), 7 * sphere.diagonal), Look(Surface(moved_rough), 7 * sphere.diagonal)
    )
    assert turned == pytest.approx(difference(sphere, rough), rel=1e-3)


def test_a_finer_tessellation_of_the_same_cube_looks_the_same():
    box = cube()
    vertices, faces = igl.upsample(box.vertices, box.faces, 4)
    assert difference(box, Mesh(np.asarray(vertices), np.asarray(faces, dtype=np.int64))) < 0.02


def test_curvature_of_a_sphere_is_that_of_its_radius():
    sphere = icosphere(6)
    look = Look(Surface(sphere), 1.0)
    for radius in (0.1, 0.2):
        values = look.curvature(KDTree(look.points[:500]), radius)
        assert np.median(values) == pytest.approx(1, rel=0.05)


def test_a_coarser_sphere_looks_less_like_a_fine_one():
    fine = icosphere(5)
    seen = [difference(fine, icosphere(levels)) for levels in (4, 3, 2)]
    assert seen[0] < seen[1] < seen[2]
