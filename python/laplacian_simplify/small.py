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
        split for other reasons count as one."""
        corners = self.vertices[self.faces].astype(np.float64)
        of_faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        keys = vertex_origin[self.faces.astype(np.intp)].ravel().astype(np.int64)
        if self.sides is not None:
            keys = keys << 32 | self.sides.ravel()
        at = np.unique(keys, return_inverse=True)[1].reshape(-1)
        weights = np.repeat(of_faces, 3, axis=0)
        sums = np.stack([np.bincount(at, weights[:, k]) for k in range(3)], axis=1)
        lengths = np.linalg.norm(sums, axis=1, keepdims=True)
        unit: Array = np.divide(sums, lengths, out=np.zeros_like(sums), where=lengths > 0)
        return unit[at].reshape(-1, 3, 3)
