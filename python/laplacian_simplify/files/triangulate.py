# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons of any number of corners as triangles, concave ones included."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError
from .mesh_data import Floats, Integers

_MOST_CORNERS_OF_A_CONCAVE_POLYGON = 5000
"""Ears are searched in quadratic time: this many take about a second."""


@dataclass
class Triangulation:
    """Triangles in the order of their polygons."""

    faux: NDArray[np.uint8] | None = None
    """As in MeshData; None where all polygons are triangles."""
    _corners: Integers | None = None
    """(n, 3): places in the list of all corners of all polygons; None where these are the triangles' own."""
    _polygon: Integers | None = None

    def of_corners(self, values: NDArray[Any]) -> NDArray[Any]:
        """What the corners of polygons have, for the three corners of every triangle."""
        if self._corners is None:
            return values.reshape(-1, 3, *values.shape[1:])
        return values[self._corners]

    def of_polygons(self, values: NDArray[Any]) -> NDArray[Any]:
        """What polygons have, for every triangle."""
        return values if self._polygon is None else values[self._polygon]


def triangulate(vertices: Floats, indices: Integers, counts: Integers) -> Triangulation:
    """Cuts polygons, given one after the other by their vertex indices, into fans or, where one is concave, by ears.

    Raises:
        DamageError: a concave polygon has too many corners.
    """
    if len(counts) == 0 or (counts.min() == 3 and counts.max() == 3):
        return Triangulation()
    starts = np.cumsum(counts) - counts
    first = np.cumsum(np.maximum(counts - 2, 0)) - np.maximum(counts - 2, 0)  # first triangle of every polygon
    total = int(np.maximum(counts - 2, 0).sum())
    local = np.empty((total, 3), dtype=np.int64)  # corners counted within the polygon
    polygon = np.repeat(np.arange(len(counts)), np.maximum(counts - 2, 0))
    twice = np.zeros(len(counts), dtype=bool)  # polygons that have a vertex twice, which are written as triangles
    for size in np.unique(counts[counts >= 3]):
        rows = np.flatnonzero(counts == size)
        corners = indices[starts[rows, None] + np.arange(size)]
        ordered = np.sort(corners, axis=1)
        twice[rows] = (ordered[:, 1:] == ordered[:, :-1]).any(axis=1)
        points = vertices[corners]
        local[first[rows, None] + np.arange(size - 2)] = _cut(points, rows)
    faux = np.where(twice[polygon], 0, _faux(local, counts[polygon])).astype(np.uint8)
    return Triangulation(faux, local + starts[polygon, None], polygon)


def _faux(local: Integers, size: Integers) -> NDArray[np.uint8]:
    """An edge is a side of the polygon where its corners follow each other in it."""
    bits = np.zeros(len(local), dtype=np.uint8)
    for k in range(3):
        inside = (local[:, k] + 1) % size != local[:, (k + 1) % 3]
        bits |= inside.astype(np.uint8) << k
    return bits


def _cut(points: Floats, names: Integers) -> Integers:
    """Triangles, by corners, of polygons with the same number of corners. points: (polygons, corners, 3)."""
    size = points.shape[1]
    fan = np.stack([np.zeros(size - 2, dtype=np.int64), np.arange(1, size - 1), np.arange(2, size)], axis=1)
    triangles: Integers = np.broadcast_to(fan, (len(points), size - 2, 3)).copy()
    if size == 3:
        return triangles
    normals = _newell(points)
    for row in np.flatnonzero(~_all_face(points, fan, normals)):
        if size == 4:
            triangles[row] = _other_diagonal(points[row], normals[row], triangles[row])
            continue
        if size > _MOST_CORNERS_OF_A_CONCAVE_POLYGON:
            most = _MOST_CORNERS_OF_A_CONCAVE_POLYGON
            raise DamageError(
                f"face {names[row]}", f"a concave polygon of {size} corners; at most {most} can be cut up"
            )
        triangles[row] = _ears(points[row], normals[row], triangles[row])
    return triangles


def _newell(points: Floats) -> Floats:
    """Normals of the polygons, as long as twice their areas."""
    centered = points - points[:, :1]
    normals: Floats = np.cross(centered, np.roll(centered, -1, axis=1)).sum(axis=1)
    return normals


def _all_face(points: Floats, triangles: Integers, normals: Floats) -> NDArray[np.bool_]:
    """Whether no triangle of a polygon looks against it."""
    a, b, c = (points[:, triangles[:, k]] for k in range(3))
    signs = np.einsum("ntk,nk->nt", np.cross(b - a, c - a), normals)
    return np.asarray((signs >= 0).all(axis=1))


def _other_diagonal(points: Floats, normal: Floats, fan: Integers) -> Integers:
    """The other two triangles of a quadrilateral, where they look the right way and the fan does not."""
    other = np.array([[1, 2, 3], [1, 3, 0]])
    return other if _all_face(points[None], other, normal[None])[0] else fan


def _ears(points: Floats, normal: Floats, fan: Integers) -> Integers:
    """Ear clipping in the plane of the polygon; the fan where the polygon crosses itself and has no ears left."""
    axis = int(np.abs(normal).argmax())
    plane = np.delete(points, axis, axis=1)
    if (normal[axis] < 0) != (axis == 1):  # without y the order of the other two turns
        plane = plane[:, ::-1]
    left = np.arange(len(points))
    triangles = []
    at, failures = 0, 0
    while len(left) > 3:
        at %= len(left)
        ear = left[[at - 1, at, (at + 1) % len(left)]]
        if _is_ear(plane, ear, left):
            triangles.append(ear)
            left = np.delete(left, at)
            failures = 0
        else:
            at, failures = at + 1, failures + 1
            if failures > len(left):
                return fan
    return np.array([*triangles, left])


def _is_ear(plane: Floats, ear: Integers, left: Integers) -> bool:
    """Whether the triangle turns left and no other corner lies in it."""
    corners = plane[ear]
    if _turn(*corners) <= 0:
        return False
    others = plane[left]
    inside = np.ones(len(others), dtype=bool)
    for start, end in ((0, 1), (1, 2), (2, 0)):
        inside &= _turn(corners[start], corners[end], others) >= 0
    for corner in corners:  # the triangle's own, or a place where the polygon touches itself
        inside &= (others != corner).any(axis=1)
    return not inside.any()


def _turn(a: Floats, b: Floats, c: Floats) -> Floats:
    """Twice the signed area of the triangle, positive where it turns left."""
    return np.asarray((b[0] - a[0]) * (c[..., 1] - a[1]) - (b[1] - a[1]) * (c[..., 0] - a[0]))
