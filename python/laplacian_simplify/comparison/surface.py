# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface as the C functions that measure take it."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from ..files.mesh_data import LARGEST_COORDINATE
from ..huge.array_file import Array

SMALLEST_DIAGONAL = 1e-140
"""Squares of smaller lengths are not numbers of their own."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles that can be measured: there is a face, indices are in range, and coordinates are finite."""

    name: str
    """As messages show it: of a file its path."""
    positions: Array
    """float64, (n, 3): of the vertices on faces, in their order."""
    faces: Array
    """uint32, (m, 3)."""

    @property
    def title(self) -> str:
        """Without the folder of a file."""
        return Path(self.name).name

    @cached_property
    def box(self) -> tuple[Array, Array]:
        """Lowest and highest corner of the bounding box of the faces."""
        return self.positions.min(axis=0), self.positions.max(axis=0)

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
    used = np.zeros(len(positions), dtype=bool)
    used[faces.ravel()] = True
    corners = np.ascontiguousarray(positions[used], np.float64)
    bad = int(np.count_nonzero(~(np.abs(corners) <= LARGEST_COORDINATE).all(axis=1)))
    if bad:
        raise ValueError(
            f"{name} has coordinates that are not finite numbers up to {LARGEST_COORDINATE:g} at {bad:,} of "
            f"{len(positions):,} vertices"
        )
    number = np.cumsum(used) - 1  # vertices of no face are no part of the surface
    surface = Surface(name, corners, np.ascontiguousarray(number[faces], np.uint32))
    if 0 < surface.diagonal < SMALLEST_DIAGONAL:
        raise ValueError(f"{name} has a bounding box with a diagonal of {surface.diagonal:.3g}, which is too small")
    return surface
