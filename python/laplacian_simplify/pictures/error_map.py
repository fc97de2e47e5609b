# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface with its distance to another one at enough points to be shown as colors."""

from dataclasses import dataclass

import numpy as np

from ..comparison.distances import Distances
from ..comparison.surface import Surface
from ..huge.array_file import Array
from ..huge.surface_library import distances

COLORS = ("#eef0ee", "#fbdf8d", "#f59a4c", "#dc4b3e", "#8f1d5c", "#2b0a3d")
"""From no distance to the limit of the scale: ever darker, so that it reads in grey and with any color vision."""
_EDGES_IN_DIAGONAL = 150
"""Longest edges are this part of the diagonal: a few points of a picture."""
_MOST_PARTS = 64
_SHARE = 0.995
_LEAST = 1e-4  # percent: below, rounding would be all that is seen
_STEPS = (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)


@dataclass(frozen=True, eq=False)
class ErrorMap:
    """The surface, and the same with large faces divided, whose further vertices come last."""

    positions: Array
    """float64, (n, 3): of both."""
    faces: Array
    """uint32, (m, 3): of the surface."""
    divided: Array
    """uint32, (k, 3): of the one with divided faces."""
    errors: Array
    """float64, (n,): distance of every vertex to the other surface."""


def error_map(of: Surface, to: Surface, most: int, threads: int = 0) -> ErrorMap:
    """
    Args:
        of: the surface that is shown.
        to: the other one.
        most: faces; where the surface has fewer, as many are divided as this allows.
        threads: 0 all.
    """
    positions, divided = divide(of.positions, of.faces, of.diagonal / _EDGES_IN_DIAGONAL, most)
    return ErrorMap(positions, of.faces, divided, distances(to.positions, to.faces, positions, threads))


def divide(positions: Array, faces: Array, longest: float, most: int) -> tuple[Array, Array]:
    """Divides faces with longer edges into as many rows as they need, as long as there are not too many.

    Returns:
        The positions with further ones behind them, and the faces.
    """
    a, b, c = (positions[faces[:, k]] for k in range(3))
    edge = np.sqrt(np.max([((b - a) ** 2).sum(1), ((c - b) ** 2).sum(1), ((a - c) ** 2).sum(1)], axis=0))
    if len(faces) >= most or not longest > 0:
        return positions, faces
    parts = _parts(edge, longest)
    while int((parts**2).sum()) > most:
        longest *= 1.1
        parts = _parts(edge, longest)
    all_positions, all_faces, count = [positions], [faces[parts == 1]], len(positions)
    for k in np.unique(parts[parts > 1]).tolist():
        weights, corners = _grid(k)
        which = parts == k
        points = np.einsum("gw,wfx->fgx", weights, np.stack([a[which], b[which], c[which]]))
        first = count + len(weights) * np.arange(len(points))
        all_positions.append(points.reshape(-1, 3))
        all_faces.append((first[:, None, None] + corners).reshape(-1, 3).astype(np.uint32))
        count += len(all_positions[-1])
    return np.concatenate(all_positions), np.concatenate(all_faces)


def _parts(edge: Array, longest: float) -> Array:
    return np.clip(np.ceil(edge / longest), 1, _MOST_PARTS).astype(np.int64)


def _grid(parts: int) -> tuple[Array, Array]:
    """Barycentric coordinates of a triangle with so many parts a side, and its small triangles."""
    row, column = (array.ravel() for array in np.meshgrid(np.arange(parts + 1), np.arange(parts + 1), indexing="ij"))
    inside = row + column <= parts
    number = np.full((parts + 2, parts + 2), -1)
    number[row[inside], column[inside]] = np.arange(int(inside.sum()))
    i, j = row[inside], column[inside]
    weights = np.stack([parts - i - j, i, j], axis=1) / parts
    up = np.stack([number[i, j], number[i + 1, j], number[i, j + 1]], axis=1)[i + j < parts]
    down = np.stack([number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]], axis=1)[i + j < parts - 1]
    return weights, np.concatenate([up, down])


def color_limit(found: Distances, diagonal: float) -> float:
    """Where the scale of colors ends, in the unit of the distances: a round percentage of the diagonal. At most half a
    percent of both surfaces is beyond it."""
    at_points = np.concatenate([found.forward.at_points, found.backward.at_points])
    share = float(np.quantile(at_points, _SHARE)) if len(at_points) else 0.0
    unit = diagonal / 100 or 1.0
    limit = max(share / unit, found.largest / unit / 1000, _LEAST)
    power = 10 ** np.floor(np.log10(limit))
    return unit * float(next(step * power for step in _STEPS if step * power >= limit * (1 - 1e-9)))
