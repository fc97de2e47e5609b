# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The best possible rms is what mathematics says, and the page shows who is behind."""

from math import pi

import numpy as np
import pytest

from mesh_topology import Mesh, area_vectors
from optimum import SHAPES, cylinder_mesh, ellipsoid_least_rms, sphere_mesh, strip_rms, torus_unit_rms
from page_optimum import optimum_lines


def test_on_a_sphere_it_is_its_area_times_a_constant():
    assert ellipsoid_least_rms(1, 1, 1)(1000) == pytest.approx(0.9366 / 1000, rel=1e-4)
    assert ellipsoid_least_rms(2, 2, 2)(1000) == pytest.approx(2 * 0.9366 / 1000, rel=1e-4)
    assert ellipsoid_least_rms(1, 0.7, 0.4)(500) == pytest.approx(ellipsoid_least_rms(0.4, 1, 0.7)(500), rel=1e-4)


def test_a_strip_is_a_chord_with_its_mean_taken_off():
    """The height of an arc over its chord is (L²/4 - s²)/2 on a unit circle."""
    half = pi / 100  # of the angle of one of 100 strips
    s = np.linspace(-half, half, 100_001)
    height = (half**2 - s**2) / 2
    assert strip_rms(200) == pytest.approx(height.std(), rel=1e-3)


def test_a_thin_torus_is_nearly_a_cylinder_of_its_length():
    """∫ |K|^⅓ dS vanishes with the curvature along it."""
    assert torus_unit_rms(0.01)(500) < torus_unit_rms(0.1)(500) < torus_unit_rms(0.4)(500)


def test_meshes_are_closed_and_look_outward():
    for mesh in (sphere_mesh(2), sphere_mesh(3, (1, 0.7, 0.4))):
        assert _volume(mesh) > 0
        assert len(mesh.vertices) - len(mesh.faces) / 2 == 2
    assert _area(sphere_mesh(4)) == pytest.approx(4 * pi, rel=1e-2)
    assert _area(cylinder_mesh(1)) == pytest.approx(2 * pi, rel=1e-3)


def test_who_is_behind_another_tool_is_bold():
    shape = SHAPES[0]
    factors = {"fast": {shape.name: {"2000": 1.4}}, "best": {shape.name: {"2000": 1.2}}}
    factors["cgal_lt"] = {shape.name: {"2000": 1.3}}
    lines = optimum_lines({"date": "today", "sizes": {shape.name: 10}, "factors": factors})
    assert f"| {shape.title} | 2,000 | **1.40** | 1.20 | 1.30 |" in lines
    assert optimum_lines({}) == []


def _volume(mesh: Mesh) -> float:
    corners = mesh.vertices[mesh.faces]
    return float(np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6)


def _area(mesh: Mesh) -> float:
    return float(np.linalg.norm(area_vectors(mesh), axis=1).sum())
