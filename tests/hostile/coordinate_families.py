# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coordinates: no numbers, too large, too small, far away, equal, and in a wrong proportion."""

from collections.abc import Iterator

import numpy as np
from hostile_meshes import HostileMesh, mesh
from shapes import Shape, fan, grid, joined, moved, scaled, sphere, tetrahedron, torus

_BASES = {"grid": grid, "tetrahedron": tetrahedron}
_VALUES = {
    "nan": np.nan,
    "inf": np.inf,
    "minus_inf": -np.inf,
    "1e308": 1e308,
    "1e100": -1e100,
    "1e39": 1e39,  # no float
    "just_over_1e18": 1.0001e18,
    "1e18": 1e18,  # the largest that is allowed
    "1e12": 1e12,
    "denormal": 5e-324,
    "float_denormal": 1e-42,
    "minus_zero": -0.0,
}


def one_coordinate() -> Iterator[HostileMesh]:
    for base, make in _BASES.items():
        for name, value in _VALUES.items():
            points, faces = make()
            points[len(points) // 2, 1] = value
            yield mesh(f"one_{name}_in_{base}", (points, faces))


def all_coordinates() -> Iterator[HostileMesh]:
    for name, value in _VALUES.items():
        points, faces = grid()
        yield mesh(f"all_{name}", (np.full_like(points, value), faces))
        points[:, 2] = value
        yield mesh(f"every_z_{name}", (points, faces))


def coordinate_of_no_face() -> Iterator[HostileMesh]:
    for name in ("nan", "inf", "1e308", "1e18"):
        points, faces = grid()
        yield mesh(f"unreferenced_{name}", (np.concatenate([points, [[0, _VALUES[name], 0]]]), faces))


def scales() -> Iterator[HostileMesh]:
    for exponent in (-320, -300, -150, -60, -45, -38, -30, -24, -18, -12, -6, 6, 12, 15, 17, 18, 24, 30, 38, 150, 300):
        yield mesh(f"grid_times_1e{exponent}", scaled(grid(), 10.0**exponent))
        if exponent % 4 == 0 or exponent in (-30, 18):
            yield mesh(f"torus_times_1e{exponent}", scaled(torus(), 10.0**exponent))


def offsets() -> Iterator[HostileMesh]:
    for exponent in (3, 6, 7, 8, 12, 15, 16, 17):
        for name, make in {"sphere": sphere, "grid": grid}.items():
            yield mesh(f"{name}_at_1e{exponent}", moved(make(), (10.0**exponent, -(10.0**exponent), 0)))


def proportions() -> Iterator[HostileMesh]:
    for exponent in (-3, -6, -9, -15, -30, -200):
        yield mesh(f"grid_flattened_1e{exponent}", scaled(grid(), (1, 1, 10.0**exponent)))
        yield mesh(f"grid_drawn_1e{exponent}", scaled(grid(), (1, 10.0**exponent, 10.0**exponent)))
        yield mesh(f"sphere_drawn_1e{exponent}", scaled(sphere(), (10.0**-exponent, 1, 1) if exponent > -18 else 1))


def equal_points() -> Iterator[HostileMesh]:
    for name, make in {"grid": grid, "torus": torus, "fan": lambda: fan(30)}.items():
        points, faces = make()
        yield mesh(f"{name}_in_one_point", (np.full_like(points, 0.5), faces))
        parity = np.arange(len(points)) % 2.0
        yield mesh(f"{name}_in_two_points", (np.repeat(parity[:, None], 3, axis=1), faces))
        yield mesh(f"{name}_on_a_line", (points * [1, 0, 0], faces))
        yield mesh(f"{name}_on_a_skew_line", (points[:, :1] * [1, 2, 3], faces))
        yield mesh(f"{name}_in_a_plane", (points * [1, 1, 0], faces))
        yield mesh(f"{name}_in_a_skew_plane", (points @ np.array([[1, 0, 0.3], [0, 1, 0.7], [0, 0, 0]]), faces))


def noise() -> Iterator[HostileMesh]:
    for seed, height in enumerate((1e-16, 1e-8, 1.0, 100.0, 1e9)):
        points, faces = grid()
        chance = np.random.default_rng(seed)
        points[:, 2] += height * chance.standard_normal(len(points))
        yield mesh(f"noise_{height:g}", (points, faces))
    for seed in range(5):
        _, faces = torus()
        points = np.random.default_rng(seed).random((faces.max() + 1, 3))
        yield mesh(f"crumpled_torus_{seed}", (points, faces))
    for exponent in (2, 5, 15):
        points = 10.0 ** np.random.default_rng(exponent).uniform(-exponent, exponent, (81, 3))
        yield mesh(f"magnitudes_up_to_1e{exponent}", (points, grid()[1]))


def slivers() -> Iterator[HostileMesh]:
    for exponent in (3, 6, 9, 12, 15):
        yield mesh(f"needles_1e{exponent}", scaled(grid(), (10.0**exponent, 1, 1)))
        yield mesh(f"caps_1e-{exponent}", caps(10.0**-exponent))
    sectors = sphere(6, 120)
    yield mesh("needles_at_poles", sectors)


def caps(height: float) -> Shape:
    """Triangles whose third corner nearly lies on the opposite edge, back to back."""
    points, faces = [(float(i), 0.0, 0.0) for i in range(11)], []
    for i in range(10):
        points += [(i + 0.5, height, 0), (i + 0.5, -height, height)]
        faces += [[i, i + 1, 11 + 2 * i], [i + 1, i, 12 + 2 * i]]
    return np.array(points), np.array(faces)


def spread() -> Iterator[HostileMesh]:
    """Parts of one mesh whose sizes have nothing to do with each other."""
    for exponent in (3, 6, 9, 14):
        parts = grid(), scaled(moved(sphere(), (2, 0, 0)), 10.0**-exponent), scaled(torus(), 10.0**exponent)
        yield mesh(f"sizes_1e{exponent}_apart", joined(*parts))


FAMILIES = (
    one_coordinate,
    all_coordinates,
    coordinate_of_no_face,
    scales,
    offsets,
    proportions,
    equal_points,
    noise,
    slivers,
    spread,
)
