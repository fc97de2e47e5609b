# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Textures, colors, quality and custom attributes of meshes in pymeshlab guide and are kept."""

import numpy as np
import pymeshlab
import pytest
from conftest import SAMPLE_MESHES

import laplacian_simplify as ls

BOX = SAMPLE_MESHES / "painted_box.obj"


def linear(positions: np.ndarray) -> np.ndarray:
    return 1e5 + positions @ [1.0, 2.0, 3.0]


def painted() -> pymeshlab.MeshSet:
    """The textured sample with vertex colors, quality and custom attributes that are linear in the position."""
    mesh_set = ls.read_mesh(BOX)
    mesh = mesh_set.current_mesh()
    positions = mesh.vertex_matrix()
    colors = np.column_stack([0.5 + 0.3 * positions, np.ones(len(positions))])
    with_colors = pymeshlab.Mesh(
        vertex_matrix=positions,
        face_matrix=mesh.face_matrix(),
        v_color_matrix=colors,
        v_scalar_array=linear(positions),
        w_tex_coords_matrix=mesh.wedge_tex_coord_matrix(),
    )
    mesh_set.add_mesh(with_colors)
    mesh = mesh_set.current_mesh()
    mesh.add_vertex_custom_scalar_attribute(linear(positions), "height")
    mesh.add_vertex_custom_point_attribute(positions, "place")
    return mesh_set


def check(mesh: pymeshlab.Mesh) -> None:
    positions = mesh.vertex_matrix()
    assert np.abs(255 * (mesh.vertex_color_matrix()[:, :3] - 0.5 - 0.3 * positions)).max() < 4
    assert (mesh.vertex_color_matrix()[:, 3] == 1).all()
    # Between the original's vertices the values are linear, too, but the result is not on the original's surface.
    assert np.abs(mesh.vertex_scalar_array() - linear(positions)).max() < 0.1
    assert np.abs(mesh.vertex_custom_scalar_attribute_array("height") - linear(positions)).max() < 0.1
    assert np.abs(mesh.vertex_custom_point_attribute_matrix("place") - positions).max() < 0.05


def test_attributes_follow_the_surface() -> None:
    mesh_set = painted()
    report = ls.simplify(mesh_set, target_percent=20)
    check(mesh_set.current_mesh())
    assert report.attribute_rms is not None
    assert len(report.attribute_rms) == 5
    texture, color, quality, height, place = report.attribute_rms
    assert 0 < texture < 0.01
    assert 0 < color < 2
    assert max(quality, height) < 0.05
    assert place < 0.05
    assert report.texture_deviation is not None
    assert report.largest_texture_deviation is not None
    assert 0 < report.texture_deviation < report.largest_texture_deviation < 3
    assert report.turned_texture_faces == 0
    assert report.faces_held_by_seams == 0


def test_a_new_layer_has_them_and_the_original_stays() -> None:
    mesh_set = painted()
    mesh_set.current_mesh()
    original = mesh_set.current_mesh_id()
    before = mesh_set.current_mesh().wedge_tex_coord_matrix().copy()
    ls.simplify(mesh_set, target_percent=20, new_layer=True)
    assert mesh_set.current_mesh_id() != original
    assert mesh_set.current_mesh().face_number() <= 0.2 * 3072
    positions = mesh_set.current_mesh().vertex_matrix()
    assert np.abs(mesh_set.current_mesh().vertex_scalar_array() - linear(positions)).max() < 0.1
    assert (mesh_set.mesh(original).wedge_tex_coord_matrix() == before).all()


def test_without_them_vertices_keep_their_values() -> None:
    mesh_set = painted()
    before = set(mesh_set.current_mesh().vertex_scalar_array())
    report = ls.simplify(mesh_set, target_percent=20, keep_attributes=False)
    assert report.attribute_rms is None
    assert report.texture_deviation is None
    assert set(mesh_set.current_mesh().vertex_scalar_array()) <= before
    assert (
        np.abs(mesh_set.current_mesh().vertex_scalar_array() - linear(mesh_set.current_mesh().vertex_matrix())).max()
        > 0.1
    )


def test_vertices_doubled_along_seams_are_doubled_again() -> None:
    """Texture coordinates of vertices have nothing but doubled vertices to hold a seam."""
    mesh_set = ls.read_mesh(BOX)
    mesh_set.apply_filter("compute_texcoord_transfer_wedge_to_vertex")
    mesh = mesh_set.current_mesh()
    mesh_set.add_mesh(
        pymeshlab.Mesh(
            vertex_matrix=mesh.vertex_matrix(),
            face_matrix=mesh.face_matrix(),
            v_tex_coords_matrix=mesh.vertex_tex_coord_matrix(),
        )
    )
    report = ls.simplify(mesh_set, target_percent=20)
    mesh = mesh_set.current_mesh()
    topology = mesh_set.apply_filter("get_topological_measures")
    assert report.boundary_edges == topology["boundary_edges"] > 0, "the edges of what is returned: its seams are open"
    cells = np.floor(mesh.vertex_tex_coord_matrix()[mesh.face_matrix()] * [3, 2])
    assert (cells == cells[:, :1]).all(), "no face shows two sides of the box"
    mesh_set.apply_filter("meshing_merge_close_vertices", threshold=pymeshlab.PercentageValue(0))
    topology = mesh_set.apply_filter("get_topological_measures")
    assert topology["boundary_edges"] == 0, "both sides of every seam meet"


def test_seams_hold_up_a_target() -> None:
    held = ls.simplify(BOX, target_faces=4)
    assert held.stop_reason is ls.StopReason.SEAMS
    assert held.faces_held_by_seams == held.faces - 4
    assert ls.simplify(BOX, target_faces=4, seams="ignore").faces <= 4


@pytest.mark.parametrize("effort", ["fast", "balanced", "best"])
def test_a_selection_leaves_the_rest(effort: str) -> None:
    mesh_set = painted()
    mesh_set.apply_filter("compute_selection_by_condition_per_face", condselect="x0 > 0 && x1 > 0 && x2 > 0")
    mesh = mesh_set.current_mesh()
    outside = ~mesh.face_selection_array()
    texture = mesh.wedge_tex_coord_matrix().reshape(-1, 6)[outside].copy()
    ls.simplify(mesh_set, target_percent=30, effort=effort)  # type: ignore[arg-type]
    mesh = mesh_set.current_mesh()
    assert (mesh.wedge_tex_coord_matrix().reshape(-1, 6)[~mesh.face_selection_array()] == texture).all()
    check(mesh)
