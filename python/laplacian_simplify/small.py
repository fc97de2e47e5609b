# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrays of a result, and the normals that follow from them."""

from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

Array: TypeAlias = np.ndarray[Any, Any]


@dataclass(frozen=True, eq=False)
class Small:
    """A result, from which normals are computed."""

    vertices: Array
    faces: Array
    sides: Array | None
    """(m, 3): of hard edges; None where there are none."""

    def corner_normals(self, vertex_origin: Array) -> Array:
        """Unit vectors, (m, 3, 3): of all faces on the same side of a vertex, weighted by area. Vertices that were
        split for other reasons count as one. Zero where those faces have no area."""
        corners = self.vertices[self.faces].astype(np.float64)
        edges = corners[:, 1:] - corners[:, :1]
        keys = vertex_origin[self.faces.astype(np.intp)].ravel().astype(np.int64)
        if self.sides is not None:
            keys = keys << 32 | self.sides.ravel()
        at = np.unique(keys, return_inverse=True)[1].reshape(-1)
        # Areas of very small and very large faces are no numbers: those of a side are measured by its longest edge.
        longest = np.zeros(at.max(initial=-1) + 1)
        np.maximum.at(longest, at, np.repeat(np.abs(edges).max(axis=(1, 2), initial=0), 3))
        scaled = _divided(np.repeat(edges, 3, axis=0), longest[at, None, None])
        weights = np.cross(scaled[:, 0], scaled[:, 1])
        sums = np.stack([np.bincount(at, weights[:, k]) for k in range(3)], axis=1)
        sums = _divided(sums, np.abs(sums).max(axis=1, initial=0, keepdims=True))
        return _divided(sums, np.linalg.norm(sums, axis=1, keepdims=True))[at].reshape(-1, 3, 3)


def _divided(values: Array, by: Array) -> Array:
    """Zero where they are divided by zero."""
    divided: Array = np.divide(values, by, out=np.zeros_like(values), where=by > 0)
    return divided
