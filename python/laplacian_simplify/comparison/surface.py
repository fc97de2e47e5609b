# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface as the C functions that measure take it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..huge.array_file import Array


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles that can be measured: there is a face, indices are in range, and coordinates are finite."""

    name: str
    """As messages show it."""
    positions: Array
    """float64, (n, 3)."""
    faces: Array
    """uint32, (m, 3)."""

    @cached_property
    def corners(self) -> Array:
        """The vertices on faces, ascending."""
        used = np.zeros(len(self.positions), dtype=bool)
        used[self.faces.ravel()] = True
        return np.flatnonzero(used)

    @cached_property
    def box(self) -> tuple[Array, Array]:
        """Lowest and highest corner of the bounding box of the faces."""
        points = self.positions[self.corners]
        return points.min(axis=0), points.max(axis=0)

    @property
    def diagonal(self) -> float:
        """Of that box."""
        low, high = self.box
        return float(np.linalg.norm(high - low))


def checked_surface(name: str, positions: Array, faces: Array) -> Surface:
    """The surface of arrays of any numbers.

    Raises:
        ValueError: they are no surface; the text says why.
    """
    if not len(faces):
        raise ValueError(f"{name} has no faces")
    lowest, highest = int(faces.min()), int(faces.max())
    if lowest < 0 or highest >= len(positions):
        at = lowest if lowest < 0 else highest
        raise ValueError(f"{name} has a face with the vertex {at}, which is outside 0..{len(positions) - 1}")
    surface = Surface(name, np.ascontiguousarray(positions, np.float64), np.ascontiguousarray(faces, np.uint32))
    bad = int(np.count_nonzero(~np.isfinite(surface.positions[surface.corners]).all(axis=1)))
    if bad:
        raise ValueError(f"{name} has coordinates that are not finite at {bad:,} of {len(positions):,} vertices")
    if not np.isfinite(surface.positions).all():  # at vertices of no face, which are no part of the surface
        surface = Surface(name, np.nan_to_num(surface.positions), surface.faces)
    return surface
