# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The textured sample with colors and quality as well, and what they are at any point of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pymeshlab

SIDES = np.array([1.2, 1.0, 0.8])
"""Half of the box, as sample_meshes/generate.py makes it."""


def write_painted_box(sample: Path, output: Path) -> Path:
    """The sample as PLY, which every host reads, with a color and a quality that are linear in the position."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(sample))
    mesh = meshes.current_mesh()
    positions = mesh.vertex_matrix()
    painted = pymeshlab.Mesh(
        vertex_matrix=positions,
        face_matrix=mesh.face_matrix(),
        v_color_matrix=np.column_stack([colors_at(positions) / 255, np.ones(len(positions))]),
        v_scalar_array=quality_at(positions),
        w_tex_coords_matrix=mesh.wedge_tex_coord_matrix(),
    )
    meshes.add_mesh(painted)
    meshes.save_current_mesh(str(output), save_wedge_texcoord=True, save_vertex_quality=True, save_vertex_color=True)
    return output


def colors_at(positions: np.ndarray) -> np.ndarray:
    return 128 + np.array([70.0, -60, 50]) * positions


def quality_at(positions: np.ndarray) -> np.ndarray:
    return 1000 + positions @ [1.0, 2.0, 3.0]


def texture_at(corners: np.ndarray) -> np.ndarray:
    """Of the corners of faces, (n, 3, 3), their texture coordinates: those of the side that the face lies on."""
    cube = corners / SIDES
    center = cube.mean(axis=1)
    axis = np.abs(center).argmax(axis=1)
    rows = np.arange(len(corners))
    sign = np.sign(center[rows, axis])
    cell = np.column_stack([(2 * axis + (sign < 0)) % 3, (2 * axis + (sign < 0)) // 3])
    of_side = cube / np.abs(cube[rows, :, axis])[:, :, None]
    u, v = of_side[rows, :, (axis + 1) % 3], of_side[rows, :, (axis + 2) % 3] * sign[:, None]
    return (cell[:, None] + 0.5 + 0.45 * np.stack([u, v], axis=2)) / np.array([3, 2])


def check_painted_box(file: Path, faces: int) -> None:
    """That a simplified box has its texture, colors and quality where they were."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(file))
    mesh = meshes.current_mesh()
    assert 0.95 * faces <= mesh.face_number() <= faces
    assert mesh.has_wedge_tex_coord()
    positions = mesh.vertex_matrix()
    texture = mesh.wedge_tex_coord_matrix().reshape(-1, 3, 2)
    expected = texture_at(positions[mesh.face_matrix()])
    cells = np.floor(texture * [3, 2])
    assert (cells == np.floor(expected.mean(axis=1) * [3, 2])[:, None]).all(), "every face shows its own side"
    assert np.abs(texture - expected).max() < 0.02, "a tenth of a square of the texture's checkers is .01"
    assert np.sqrt(((texture - expected) ** 2).mean()) < 0.003
    colors = 255 * mesh.vertex_color_matrix()[:, :3]
    assert np.abs(colors - colors_at(positions)).max() < 4
    assert np.abs(mesh.vertex_scalar_array() - quality_at(positions)).max() < 0.1
