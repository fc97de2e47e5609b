# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of an input file, as its readers return them."""

from dataclasses import dataclass

import numpy as np

from ..files.errors import MeshFileError
from .array_file import Array

# Coordinates beyond this are refused, as the filters refuse them.
MAX_COORDINATE = 1e18


@dataclass(frozen=True)
class Bounds:
    """Lowest and highest coordinates of some rows, and a checksum of their bytes."""

    low: list[float]
    high: list[float]
    checksum: int
    brightest: tuple[float, ...] = ()
    """The largest number of each part of their colors."""


@dataclass(frozen=True, eq=False)
class Chunk:
    """Some faces of a mesh, with their vertices."""

    ids: Array
    """int64, ascending: what tells a vertex from all others of the mesh."""
    positions: Array
    """(n, 3), float32 where the file has no more."""
    triangles: Array
    """uint32, (m, 3), rows of the arrays above."""
    dropped: int = 0
    """Faces with the same vertex at two corners, which are left out."""
    checksum: int = 0
    """Of the bytes that were read for the faces."""
    colors: Array | None = None
    """(n, 3) or (n, 4): bytes, or float32 from 0 to 1."""


def bounds_of(columns: list[Array], shown: str, checksum: int, brightest: tuple[float, ...] = ()) -> Bounds:
    """The box of coordinates.

    Raises:
        MeshFileError: some of them cannot be used.
    """
    with np.errstate(invalid="ignore"):
        usable = np.logical_and.reduce([np.abs(column) <= MAX_COORDINATE for column in columns])  # NaN is not
    if not usable.all():
        bad = int(np.count_nonzero(~usable))
        raise MeshFileError(
            f"{shown} cannot be used: coordinates of vertices are not finite or larger than 1e18 "
            f"({bad:,} of the {len(usable):,} that were looked at together)"
        )
    return Bounds([float(c.min()) for c in columns], [float(c.max()) for c in columns], checksum, brightest)


def without_degenerate(
    ids: Array, positions: Array, triangles: Array, checksum: int, colors: Array | None = None
) -> Chunk:
    """The chunk of these faces. Vertices of none stay: whoever takes faces takes theirs."""
    a, b, c = triangles.T
    sound = (a != b) & (b != c) & (c != a)
    dropped = len(sound) - int(np.count_nonzero(sound))
    return Chunk(ids, positions, triangles[sound] if dropped else triangles, dropped, checksum, colors)
