# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces: none, one, the same again, turned over, with a vertex twice, with vertices that are not there."""

from collections.abc import Iterator

import numpy as np
from hostile_meshes import HostileMesh, mesh
from shapes import Shape, grid, joined, moved, soup, sphere, tetrahedron, torus


def none() -> Iterator[HostileMesh]:
    for count in (0, 1, 3, 1000):
        points = np.random.default_rng(count).random((count, 3))
        yield mesh(f"no_faces_{count}_vertices", (points, np.empty((0, 3))))


def few() -> Iterator[HostileMesh]:
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, 0, 1.0]])
    faces = {
        "one": [[0, 1, 2]],
        "one_vertex_twice": [[0, 0, 1]],
        "one_vertex_three_times": [[2, 2, 2]],
        "two_at_an_edge": [[0, 1, 2], [0, 2, 3]],
        "two_at_an_edge_turned": [[0, 1, 2], [0, 3, 2]],
        "two_at_a_vertex": [[0, 1, 2], [0, 3, 4]],
        "two_apart": [[0, 1, 2], [3, 4, 5]],
        "two_the_same": [[0, 1, 2], [0, 1, 2]],
        "two_the_same_rotated": [[0, 1, 2], [1, 2, 0]],
        "front_and_back": [[0, 1, 2], [0, 2, 1]],
        "three_at_an_edge": [[0, 1, 2], [0, 1, 3], [0, 1, 4]],
        "one_sound_of_two": [[0, 1, 2], [3, 3, 4]],
    }
    for name, chosen in faces.items():
        yield mesh(f"few_{name}", (corner, chosen))
    yield mesh("few_one_on_a_line", ([[0, 0, 0], [1, 1, 1], [2, 2, 2]], [[0, 1, 2]]))
    yield mesh("few_one_in_a_point", ([[1, 1, 1]] * 3, [[0, 1, 2]]))
    yield mesh("tetrahedron", tetrahedron())


def identical() -> Iterator[HostileMesh]:
    for count in (2, 10, 200, 2000):
        points, faces = np.eye(3), np.tile([[0, 1, 2]], (count, 1))
        yield mesh(f"identical_{count}", (points, faces))
        yield mesh(f"identical_{count}_apart", soup((points, faces)))
        yield mesh(
            f"identical_{count}_any_order", (points, [np.roll([0, 1, 2], i)[:: 1 - 2 * (i % 2)] for i in range(count)])
        )


def repeated_index() -> Iterator[HostileMesh]:
    for share in (0.02, 0.1, 0.5, 0.9, 1.0):
        for name, make in {"grid": grid, "sphere": sphere}.items():
            points, faces = make()
            chosen = np.random.default_rng(7).random(len(faces)) < share
            faces[chosen, 2] = faces[chosen, 0]
            yield mesh(f"vertex_twice_in_{share:.0%}_of_{name}", (points, faces))


def duplicates() -> Iterator[HostileMesh]:
    for name, order in {"same": [0, 1, 2], "rotated": [1, 2, 0], "turned": [0, 2, 1]}.items():
        for every in (1, 5, 200):
            for base, make in {"torus": torus, "grid": grid}.items():
                points, faces = make()
                yield mesh(
                    f"{base}_every_{every}_again_{name}", (points, np.concatenate([faces, faces[::every][:, order]]))
                )


def turned() -> Iterator[HostileMesh]:
    for share in (0.01, 0.3, 0.5):
        for name, make in {"grid": grid, "torus": torus}.items():
            points, faces = make()
            chosen = np.random.default_rng(3).random(len(faces)) < share
            faces[chosen] = faces[chosen][:, ::-1]
            yield mesh(f"{share:.0%}_of_{name}_turned", (points, faces))


def out_of_range() -> Iterator[HostileMesh]:
    for name, value in {"one_past": 81, "minus_one": -1, "largest": 2**31 - 1, "smallest": -(2**31)}.items():
        points, faces = grid()
        faces[17, 1] = value
        yield mesh(f"index_{name}", (points, faces))
    yield mesh("index_without_vertices", (np.empty((0, 3)), [[0, 1, 2]]))
    yield mesh("every_index_out_of_range", (np.eye(3), grid()[1] + 3))


def deleted() -> Iterator[HostileMesh]:
    for share in (0.01, 0.5, 0.95, 1.0):
        points, faces = torus()
        chosen = np.random.default_rng(5).random(len(faces)) < share
        yield mesh(f"{share:.0%}_of_faces_deleted", (points, faces), deleted_faces=chosen)


def unreferenced() -> Iterator[HostileMesh]:
    for count in (1, 500):
        points, faces = sphere()
        more = 10 * np.random.default_rng(count).random((count, 3))
        yield mesh(f"{count}_unreferenced_last", (np.concatenate([points, more]), faces))
        yield mesh(f"{count}_unreferenced_first", (np.concatenate([more, points]), faces + count))
    points, faces = grid()
    yield mesh("unreferenced_at_vertices", (np.concatenate([points, points]), faces))


def random_gluing() -> Iterator[HostileMesh]:
    for seed in range(24):
        chance = np.random.default_rng(seed)
        vertices, count = int(chance.integers(3, 60)), int(chance.integers(4, 300))
        yield mesh(f"random_faces_{seed}", (chance.random((vertices, 3)), chance.integers(0, vertices, (count, 3))))


def pinched() -> Iterator[HostileMesh]:
    """Sound meshes of which vertices far from each other became one."""
    for seed in range(8):
        chance = np.random.default_rng(seed)
        points, faces = (grid, torus, sphere)[seed % 3]()
        onto = np.arange(len(points))
        for _ in range(1 + 3 * seed):
            a, b = chance.integers(len(points), size=2)
            onto[onto == onto[a]] = onto[b]
        yield mesh(f"pinched_{seed}", (points, onto[faces]))


def orders() -> Iterator[HostileMesh]:
    for seed, (name, make) in enumerate({"grid": grid, "torus": torus}.items()):
        yield mesh(f"shuffled_{name}", shuffled(make(), seed))
    shape = joined(*(moved(tetrahedron(), (2 * i, 0, 0)) for i in range(40)))
    yield mesh("shuffled_tetrahedra", shuffled(shape, 5))


def shuffled(shape: Shape, seed: int) -> Shape:
    chance = np.random.default_rng(seed)
    points, faces = shape
    to = chance.permutation(len(points))
    faces = to[chance.permutation(faces)]
    return points[np.argsort(to)], faces


FAMILIES = (
    none,
    few,
    identical,
    repeated_index,
    duplicates,
    turned,
    out_of_range,
    deleted,
    unreferenced,
    random_gluing,
    pinched,
    orders,
)
