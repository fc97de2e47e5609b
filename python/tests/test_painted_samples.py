# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the textured and colored samples carry survives every way of running: charts, materials, borders of colors."""

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pymeshlab
import pytest
from attribute_meshes import open_edges
from conftest import SAMPLE_MESHES

import laplacian_simplify as ls

SPACING = 0.12
"""Of neighbors in the samples, about."""

WAYS: list[dict[str, Any]] = [
    {"effort": "fast"},
    {"effort": "balanced"},
    {"effort": "best"},
    {"boundary": "free"},
    {"boundary": "lock"},
    {"selected_only": True},
    {"new_layer": True},
    {"max_error": 2.0},
    {"order": "strict"},
]


def run(name: str, percent: float, **options: Any) -> tuple[pymeshlab.MeshSet, ls.DecimationReport]:
    """A sample with so many of its faces; where its right half alone is selected, at least with a fifth of it: what is
    fixed around it takes many of them."""
    mesh_set = ls.read_mesh(SAMPLE_MESHES / name)
    if options.get("selected_only"):
        mesh_set.apply_filter("compute_selection_by_condition_per_face", condselect="x0 > 0 && x1 > 0 && x2 > 0")
    report = ls.simplify(mesh_set, target_percent=max(percent, 20 if options.get("selected_only") else 0), **options)
    assert report.boundary_edges == 0
    mesh = mesh_set.current_mesh()
    assert open_edges(mesh.vertex_matrix(), mesh.face_matrix()) == 0, "both sides of every seam meet"
    return mesh_set, report


def materials_of(mesh_set: pymeshlab.MeshSet) -> np.ndarray:
    """The number of the texture of every face of two."""
    mesh_set.apply_filter("compute_selection_by_condition_per_face", condselect="ti == 1")
    return mesh_set.current_mesh().face_selection_array().astype(int)


@dataclass
class Charts:
    """The faces of the box with mirrored charts."""

    corners: np.ndarray
    chart: np.ndarray
    """Of every face by what it shows: material, cell and orientation."""
    one_cell: bool
    """No face shows two."""


def charts_of(mesh_set: pymeshlab.MeshSet) -> Charts:
    mesh = mesh_set.current_mesh()
    texture = mesh.wedge_tex_coord_matrix().reshape(-1, 3, 2)
    edges = texture[:, 1:] - texture[:, :1]
    mirrored = edges[:, 0, 0] * edges[:, 1, 1] < edges[:, 0, 1] * edges[:, 1, 0]
    cells = np.floor(texture[..., 0] * 3) + 3 * materials_of(mesh_set)[:, None]
    inside = (np.abs(texture * [3, 1] % 1 - 0.5) < 0.45 + 1e-4).all()  # 5 digits in the file; a margin lies around
    one_cell = bool((cells == cells[:, :1]).all() and inside)
    chart = cells[:, 0].astype(int) * 2 + mirrored
    return Charts(mesh.vertex_matrix()[mesh.face_matrix()], chart, one_cell)


@cache
def original_charts() -> Charts:
    return charts_of(ls.read_mesh(SAMPLE_MESHES / "mirrored_box.obj"))


def test_the_mirrored_box_is_what_it_is_here_for() -> None:
    charts = original_charts()
    assert charts.one_cell
    assert np.array_equal(np.bincount(charts.chart), np.full(12, 14 * 14))
    mesh_set = ls.read_mesh(SAMPLE_MESHES / "mirrored_box.obj")
    assert len(mesh_set.current_mesh().textures()) == 2


@pytest.mark.parametrize("options", WAYS, ids=str)
def test_mirrored_charts_and_materials_stay(options: dict[str, Any]) -> None:
    mesh_set, report = run("mirrored_box.obj", 5, **options)
    assert report.turned_texture_faces == 0
    assert len(mesh_set.current_mesh().textures()) == 2
    found, original = charts_of(mesh_set), original_charts()
    assert found.one_cell
    assert set(found.chart) == set(range(12))
    for chart in range(12):
        places = original.corners[original.chart == chart].reshape(-1, 3)
        shown = found.corners[found.chart == chart].reshape(-1, 3)
        distance = np.linalg.norm(shown[:, None] - places[None], axis=2).min(axis=1)
        assert distance.max() < SPACING, "a face shows what is elsewhere"


@pytest.mark.parametrize("options", WAYS, ids=str)
def test_hard_and_smooth_colors_stay(options: dict[str, Any]) -> None:
    original_set = ls.read_mesh(SAMPLE_MESHES / "painted_egg.ply")
    original = original_set.current_mesh()
    mesh_set, report = run("painted_egg.ply", 20, **options)
    mesh = mesh_set.current_mesh()
    assert report.attribute_rms is not None
    assert max(report.attribute_rms) < 4, "of 255; it is 8 where colors do not guide"
    before, after = original.vertex_color_matrix(), mesh.vertex_color_matrix()
    assert (after.min(axis=0) >= before.min(axis=0)).all()
    assert (after.max(axis=0) <= before.max(axis=0)).all()


@pytest.mark.parametrize("options", WAYS, ids=str)
def test_colors_of_faces_stay(options: dict[str, Any]) -> None:
    original_set = ls.read_mesh(SAMPLE_MESHES / "parted_egg.ply")
    original = original_set.current_mesh()
    mesh_set, _ = run("parted_egg.ply", 5, **options)
    mesh = mesh_set.current_mesh()
    colors, number = np.unique(np.rint(255 * original.face_color_matrix()).astype(int), axis=0, return_inverse=True)
    found = np.rint(255 * mesh.face_color_matrix()).astype(int)
    same = (found[:, None] == colors[None]).all(axis=2)
    assert same.any(axis=1).all(), "a color that the original does not have"
    corners = original.vertex_matrix()[original.face_matrix()]
    for k in range(len(colors)):
        places = corners[number.reshape(-1) == k].reshape(-1, 3)
        shown = mesh.vertex_matrix()[mesh.face_matrix()][same[:, k]].reshape(-1, 3)
        assert len(shown)
        assert np.linalg.norm(shown[:, None] - places[None], axis=2).min(axis=1).max() < SPACING


@pytest.mark.parametrize("name", ["mirrored_box.obj", "painted_egg.ply", "parted_egg.ply"])
def test_threads_do_not_matter(name: str) -> None:
    def result(threads: int) -> list[bytes]:
        mesh_set, _ = run(name, 20, threads=threads)
        mesh = mesh_set.current_mesh()
        arrays = [mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_color_matrix()]
        if mesh.has_face_color():
            arrays.append(mesh.face_color_matrix())
        if mesh.has_wedge_tex_coord():
            arrays += [mesh.wedge_tex_coord_matrix(), materials_of(mesh_set)]
        return [array.tobytes() for array in arrays]

    assert result(1) == result(2) == result(3) == result(7)
