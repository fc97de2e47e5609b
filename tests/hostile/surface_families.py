# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces: not manifold, without an outside, in pieces, on top of each other, through each other."""

from collections.abc import Iterator

import numpy as np
from hostile_meshes import HostileMesh, mesh
from shapes import (
    Shape,
    book,
    fan,
    grid,
    joined,
    klein_bottle,
    moved,
    projective_plane,
    scaled,
    soup,
    sphere,
    strip,
    tetrahedron,
    torus,
)


def fans() -> Iterator[HostileMesh]:
    for valence in (3, 10, 100, 1000):
        yield mesh(f"fan_{valence}", fan(valence))
        yield mesh(f"open_fan_{valence}", fan(valence, closed=False))
        points, faces = fan(valence)
        both = np.concatenate([faces, np.where(faces[:, ::-1] == 0, len(points), faces[:, ::-1])])
        yield mesh(f"double_cone_{valence}", (np.concatenate([points, [[0, 0, -0.3]]]), both))


def bow_ties() -> Iterator[HostileMesh]:
    for count in (2, 5, 20):
        shape = joined(*(moved(scaled(fan(20), (1, 1, 1 + i)), (0, 0, i)) for i in range(count)))
        points, faces = shape
        yield mesh(f"bow_tie_of_{count}_fans", (points, np.where(faces % 21 == 0, 0, faces)))
    points, faces = joined(*(moved(grid(4), (i, i, 0)) for i in range(8)))
    last = np.arange(len(points))
    last[16::16] = last[15:-1:16]
    yield mesh("chain_of_bow_ties", (points, last[faces]))
    yield mesh("tetrahedra_at_one_vertex", _at_one_vertex(30))


def _at_one_vertex(count: int) -> Shape:
    chance = np.random.default_rng(1)
    points, faces = joined(
        *((tetrahedron()[0] @ chance.standard_normal((3, 3)), tetrahedron()[1]) for _ in range(count))
    )
    return points, np.where(faces % 4 == 0, 0, faces)


def books() -> Iterator[HostileMesh]:
    for pages in (3, 4, 7, 50, 300):
        yield mesh(f"book_of_{pages}", book(pages))
    for pages in (3, 9):
        yield mesh(f"long_book_of_{pages}", book(pages, 40))
    points, faces = joined(torus(), torus())
    half = len(points) // 2
    shared = np.where((np.arange(len(points)) >= half) & (np.arange(len(points)) % 3 == 0), -half, 0)
    yield mesh("two_tori_with_every_third_vertex", (points, faces + shared[faces]))


def one_sided() -> Iterator[HostileMesh]:
    for half_turns in (1, 2, 3, 7):
        yield mesh(f"strip_{half_turns}_half_turns", strip(30, half_turns))
    for around, across in ((3, 3), (8, 6), (24, 16)):
        yield mesh(f"klein_bottle_{around}_{across}", klein_bottle(around, across))
    yield mesh("projective_plane", projective_plane())
    yield mesh("projective_planes", joined(*(moved(projective_plane(), (3 * i, 0, 0)) for i in range(12))))


def smallest() -> Iterator[HostileMesh]:
    """Closed surfaces that can hardly become smaller."""
    yield mesh("torus_3_3", torus(3, 3))
    yield mesh("torus_of_seven_vertices", (np.random.default_rng(2).random((7, 3)), _seven()))
    yield mesh("octahedron", sphere(2, 4))
    yield mesh("pillow", sphere(2, 3))
    yield mesh("tube", strip(3, 0, 20))


def _seven() -> list[list[int]]:
    return [[i, (i + 1) % 7, (i + 3) % 7] for i in range(7)] + [[i, (i + 3) % 7, (i + 2) % 7] for i in range(7)]


def soups() -> Iterator[HostileMesh]:
    for count in (10, 100, 1000):
        points = np.random.default_rng(count).random((3 * count, 3))
        yield mesh(f"soup_of_{count}", (points, np.arange(3 * count)))
    for name, make in {"sphere": sphere, "grid": grid, "torus": torus}.items():
        yield mesh(f"unwelded_{name}", soup(make()))
    for exponent in (15, 9, 5, 2):
        points, faces = soup(sphere())
        points += 10.0**-exponent * np.random.default_rng(exponent).standard_normal(points.shape)
        yield mesh(f"unwelded_sphere_with_gaps_1e-{exponent}", (points, faces))
    yield mesh("soup_of_lines", (np.repeat(np.random.default_rng(3).random((100, 3)), 3, axis=0), np.arange(300)))


def components() -> Iterator[HostileMesh]:
    for count in (10, 300):
        yield mesh(f"{count}_tetrahedra", joined(*(moved(tetrahedron(), (2 * i, 0, 0)) for i in range(count))))
        yield mesh(
            f"{count}_faces_apart", joined(*(moved((np.eye(3), np.array([[0, 1, 2]])), i) for i in range(count)))
        )
    yield mesh("tetrahedra_touching", joined(*(moved(tetrahedron(), (i, 0, 0)) for i in range(30))))
    yield mesh("sphere_in_sphere", joined(sphere(), scaled(sphere(), 0.5)))
    yield mesh("speck_beside_a_torus", joined(torus(), scaled(tetrahedron(), 1e-12)))


def coincident() -> Iterator[HostileMesh]:
    for count in (2, 5, 20):
        yield mesh(f"{count}_grids_in_one_place", joined(*[grid()] * count))
        yield mesh(f"{count}_spheres_in_one_place", joined(*[sphere(6, 8)] * count))
        yield mesh(
            f"{count}_flat_sheets_shifted", joined(*(moved(grid(9, 0), (0.03 * i, 0.01 * i, 0)) for i in range(count)))
        )
    points, faces = sphere()
    yield mesh("sphere_and_its_inside", joined((points, faces), (points, faces[:, ::-1])))
    for exponent in (16, 12, 6):
        yield mesh(f"spheres_1e-{exponent}_apart", joined(sphere(), scaled(sphere(), 1 + 10.0**-exponent)))
        yield mesh(f"sheets_1e-{exponent}_apart", joined(grid(), moved(grid(), (0, 0, 10.0**-exponent))))


def through_each_other() -> Iterator[HostileMesh]:
    chance = np.random.default_rng(4)
    parts = ((tetrahedron()[0] + 0.3 * chance.standard_normal((1, 3)), tetrahedron()[1]) for _ in range(40))
    yield mesh("tetrahedra_through_each_other", joined(*parts))
    yield mesh("spheres_through_each_other", joined(*(moved(sphere(), (0.7 * i, 0, 0)) for i in range(4))))
    crossed = grid()[0][:, [0, 2, 1]] + [0, 0.1, 0]
    yield mesh("sheets_through_each_other", joined(grid(), (crossed, grid()[1])))
    yield mesh("rolled_paper", rolled(6))
    yield mesh("rolled_paper_that_touches", rolled(6, 0))
    points, faces = sphere()
    yield mesh("sphere_inside_out_by_half", (points * np.where(points[:, 2:] > 0, [1, 1, -2.5], 1), faces))


def rolled(turns: int, gap: float = 0.02) -> Shape:
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi * turns, 60), np.linspace(0, 1, 6), indexing="ij")
    radius = 0.3 + gap * u
    points = np.stack([radius * np.cos(u), radius * np.sin(u), v], axis=2).reshape(-1, 3)
    at = np.arange(360).reshape(60, 6)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    return points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def cracks() -> Iterator[HostileMesh]:
    points, faces = joined(grid(9, 0), moved(grid(17, 0), (1, 0, 0)))
    yield mesh("t_junctions", (points, faces))
    for seed, share in enumerate((0.05, 0.3, 0.7)):
        points, faces = grid(15)
        keep = np.random.default_rng(seed).random(len(faces)) > share
        yield mesh(f"{share:.0%}_of_faces_missing", (points, faces[keep]))
    points, faces = torus()
    yield mesh("checkered", (points, faces[::2]))


FAMILIES = (
    fans,
    bow_ties,
    books,
    one_sided,
    smallest,
    soups,
    components,
    coincident,
    through_each_other,
    cracks,
)
