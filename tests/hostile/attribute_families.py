# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh carries: colors, quality, texture coordinates and selections that are random or no numbers."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from hostile_meshes import HostileMesh, mesh
from shapes import fan, grid, joined, sphere, tetrahedron, torus

_NUMBERS = {"nan": np.nan, "inf": np.inf, "1e300": 1e300, "1e30": 1e30, "denormal": 5e-324}


def _chance(seed: int) -> np.random.Generator:
    return np.random.default_rng(seed)


def _charts(faces: np.ndarray, corner: np.ndarray) -> np.ndarray:
    """Texture coordinates of the corners, from those of the vertices."""
    return np.ascontiguousarray(corner[faces.ravel()])


def colors() -> Iterator[HostileMesh]:
    for name, make in {"grid": grid, "torus": torus, "fan": lambda: fan(60), "tetrahedron": tetrahedron}.items():
        points, faces = make()
        yield mesh(
            f"random_vertex_colors_{name}",
            (points, faces),
            data={"v_color_matrix": _chance(1).random((len(points), 4))},
        )
        yield mesh(
            f"random_face_colors_{name}", (points, faces), data={"f_color_matrix": _chance(2).random((len(faces), 4))}
        )
    points, faces = grid()
    hard = np.repeat((_chance(3).random((len(faces), 1)) < 0.05).astype(float), 4, axis=1)
    yield mesh("speckled_face_colors", (points, faces), data={"f_color_matrix": hard})


def quality() -> Iterator[HostileMesh]:
    points, faces = grid()
    for name, value in {**_NUMBERS, "zero": 0.0}.items():
        one, every = _chance(4).random(len(points)), np.full(len(points), value)
        one[40] = value
        yield mesh(f"quality_one_{name}", (points, faces), data={"v_scalar_array": one})
        yield mesh(f"quality_all_{name}", (points, faces), data={"v_scalar_array": every})
    for_faces = _chance(5).standard_normal(len(faces)) * 1e200
    yield mesh("face_quality_huge", (points, faces), data={"f_scalar_array": for_faces})


def wedges() -> Iterator[HostileMesh]:
    for name, make in {"grid": grid, "torus": torus, "fan": lambda: fan(60), "tetrahedron": tetrahedron}.items():
        points, faces = make()
        yield from _wedges_of(name, points, faces)
    points, faces = grid()
    for name, value in _NUMBERS.items():
        one, every = _charts(faces, points[:, :2]), np.full((3 * len(faces), 2), value)
        one[77, 1] = value
        yield mesh(f"wedge_one_{name}", (points, faces), data={"w_tex_coords_matrix": one})
        yield mesh(f"wedge_all_{name}", (points, faces), data={"w_tex_coords_matrix": every})


def _wedges_of(name: str, points: np.ndarray, faces: np.ndarray) -> Iterator[HostileMesh]:
    plane = points[:, :2] + 0.1 * points[:, 2:]
    corner = _charts(faces, plane)
    mirrored = corner.reshape(-1, 3, 2).copy()
    mirrored[::2, :, 0] *= -1
    steps = np.repeat(np.arange(len(faces)), 3)[:, None] * 2.0
    layouts: dict[str, Any] = {
        "random": _chance(6).random(corner.shape),
        "mirrored": mirrored.reshape(-1, 2),
        "every_face_a_chart": corner + steps,
        "in_one_point": np.zeros_like(corner),
        "on_a_line": corner * [1, 0],
        "far_away": corner + 1e8,
        "mirrored_by_noise": corner + 0.2 * _chance(7).standard_normal(corner.shape),
    }
    for kind, layout in layouts.items():
        yield mesh(f"wedge_{kind}_{name}", (points, faces), data={"w_tex_coords_matrix": layout})


def vertex_textures() -> Iterator[HostileMesh]:
    points, faces = sphere()
    for name, value in _NUMBERS.items():
        layout = points[:, :2].copy()
        layout[5, 0] = value
        yield mesh(f"vertex_texture_one_{name}", (points, faces), data={"v_tex_coords_matrix": layout})
    yield mesh(
        "vertex_texture_random", (points, faces), data={"v_tex_coords_matrix": _chance(8).random((len(points), 2))}
    )


def everything() -> Iterator[HostileMesh]:
    for seed, make in enumerate((grid, torus, sphere)):
        points, faces = make()
        chance = _chance(seed)
        data = {
            "v_color_matrix": chance.random((len(points), 4)),
            "f_color_matrix": chance.random((len(faces), 4)),
            "v_scalar_array": chance.standard_normal(len(points)),
            "f_scalar_array": chance.standard_normal(len(faces)),
            "v_tex_coords_matrix": chance.random((len(points), 2)),
            "w_tex_coords_matrix": chance.random((3 * len(faces), 2)),
        }
        yield mesh(f"everything_{seed}", (points, faces), data=data)
        cracked = np.concatenate([faces, faces[::7], faces[::11][:, ::-1]])
        for_faces = {
            "f_color_matrix": chance.random((len(cracked), 4)),
            "f_scalar_array": chance.random(len(cracked)),
            "w_tex_coords_matrix": chance.random((3 * len(cracked), 2)),
        }
        yield mesh(f"everything_with_duplicates_{seed}", (points, cracked), data=data | for_faces)


def selections() -> Iterator[HostileMesh]:
    points, faces = joined(grid(), sphere())
    for name, share in {"none": 0.0, "one_in_ten": 0.1, "half": 0.5, "all": 1.1}.items():
        chosen_faces = _chance(9).random(len(faces)) < share
        chosen_vertices = _chance(10).random(len(points)) < share
        yield mesh(f"selected_faces_{name}", (points, faces), selected_faces=chosen_faces)
        yield mesh(f"selected_vertices_{name}", (points, faces), selected_vertices=chosen_vertices)
    chosen = np.arange(len(faces)) == 3
    yield mesh("selected_one_face", (points, faces), selected_faces=chosen)
    faces = faces.copy()
    faces[::3, 1] = faces[::3, 0]
    yield mesh("selected_faces_are_broken", (points, faces), selected_faces=np.arange(len(faces)) % 3 == 0)
    yield mesh("selected_faces_are_sound", (points, faces), selected_faces=np.arange(len(faces)) % 3 == 1)


FAMILIES = (colors, quality, wedges, vertex_textures, everything, selections)
