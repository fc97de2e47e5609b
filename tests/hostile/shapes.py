# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sound meshes, of which the families of bad ones are made: vertices (n, 3) and faces (m, 3)."""

import numpy as np

Shape = tuple[np.ndarray, np.ndarray]


def grid(side: int = 9, height: float = 0.3) -> Shape:
    """A wavy square with an open border, 2 (side - 1)^2 faces."""
    x, y = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    z = height * np.sin(5 * x) * np.cos(4 * y)
    at = np.arange(side * side).reshape(side, side)
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1), _halves(at)


def sphere(rings: int = 8, sectors: int = 10) -> Shape:
    """A closed surface of 2 sectors (rings - 1) faces."""
    polar = np.pi * np.arange(1, rings)[:, None] / rings
    around = 2 * np.pi * np.arange(sectors)[None, :] / sectors
    ring = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar) + 0 * around], 2)
    at = 2 + np.arange((rings - 1) * sectors).reshape(rings - 1, sectors)
    at = np.concatenate([at, at[:, :1]], axis=1)
    top = [[0, a, b] for a, b in zip(at[0], at[0, 1:], strict=False)]
    bottom = [[1, b, a] for a, b in zip(at[-1], at[-1, 1:], strict=False)]
    faces = np.concatenate([np.array(top), _halves(at)[:, ::-1][:, [0, 2, 1]], np.array(bottom)])
    return np.concatenate([[[0, 0, 1.0], [0, 0, -1.0]], ring.reshape(-1, 3)]), faces


def torus(around: int = 12, across: int = 8) -> Shape:
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across)
    radius = 1 + 0.4 * np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), 0.4 * np.sin(v)], axis=2).reshape(-1, 3)
    at = np.arange(around * across).reshape(across, around)
    at = np.concatenate([at, at[:1]])
    return points, _halves(np.concatenate([at, at[:, :1]], axis=1))


def tetrahedron() -> Shape:
    return np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]), np.array(
        [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    )


def fan(valence: int, closed: bool = True) -> Shape:
    """Faces around one vertex, which stands a little above the others."""
    angle = 2 * np.pi * np.arange(valence) / valence
    rim = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    last = valence if closed else valence - 1
    faces = [[0, 1 + i, 1 + (i + 1) % valence] for i in range(last)]
    return np.concatenate([[[0, 0, 0.3]], rim]), np.array(faces)


def strip(length: int, half_turns: int, across: int = 3) -> Shape:
    """A band that closes after so many half turns: a Moebius strip where they are odd."""
    u, v = np.meshgrid(np.arange(length) * 2 * np.pi / length, np.linspace(-0.4, 0.4, across), indexing="ij")
    radius = 1 + v * np.cos(half_turns * u / 2)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), v * np.sin(half_turns * u / 2)], axis=2)
    at = np.arange(length * across).reshape(length, across)
    end = at[:1, ::-1] if half_turns % 2 else at[:1]
    return points.reshape(-1, 3), _halves(np.concatenate([at, end]))


def klein_bottle(around: int, across: int) -> Shape:
    """The figure-8 immersion: closed, crosses itself, has no outside."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    radius = 1 + 0.5 * (np.cos(u / 2) * np.sin(v) - np.sin(u / 2) * np.sin(2 * v))
    height = 0.5 * (np.sin(u / 2) * np.sin(v) + np.cos(u / 2) * np.sin(2 * v))
    points = np.stack([radius * np.cos(u), radius * np.sin(u), height], axis=2).reshape(-1, 3)
    at = np.arange(around * across).reshape(around, across)
    at = np.concatenate([at, at[:1, -np.arange(across) % across]])
    return points, _halves(np.concatenate([at, at[:, :1]], axis=1))


def projective_plane() -> Shape:
    """The smallest one: six vertices, each of ten faces, closed and without an outside."""
    faces = "012 023 034 045 051 124 235 341 452 513".split()
    angle = 2 * np.pi * np.arange(5) / 5
    rim = np.stack([np.cos(angle), np.sin(angle), 0.2 * np.cos(2 * angle)], axis=1)
    return np.concatenate([[[0, 0, 1.0]], rim]), np.array([[int(v) for v in face] for face in faces])


def book(pages: int, rows: int = 3) -> Shape:
    """Sheets that meet at one line: edges of so many faces."""
    points, faces = [(0.0, 0.0, z) for z in range(rows)], []
    for page in range(pages):
        angle, first = 2 * np.pi * page / pages, len(points)
        points += [(np.cos(angle), np.sin(angle), float(z)) for z in range(rows)]
        for z in range(rows - 1):
            faces += [[z, first + z, first + z + 1], [z, first + z + 1, z + 1]]
    return np.array(points), np.array(faces)


def joined(*shapes: Shape) -> Shape:
    """One mesh of many; no vertices are shared."""
    first = np.cumsum([0, *(len(points) for points, _ in shapes)])
    faces = [mesh + start for (_, mesh), start in zip(shapes, first, strict=False)]
    return np.concatenate([points for points, _ in shapes]), np.concatenate(faces)


def moved(shape: Shape, by: object) -> Shape:
    return shape[0] + np.asarray(by, float), shape[1]


def scaled(shape: Shape, by: object) -> Shape:
    return shape[0] * np.asarray(by, float), shape[1]


def soup(shape: Shape) -> Shape:
    """Every face with vertices of its own."""
    points, faces = shape
    return points[faces.ravel()], np.arange(faces.size).reshape(-1, 3)


def _halves(at: np.ndarray) -> np.ndarray:
    """Two faces for each four of a table of vertices."""
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
