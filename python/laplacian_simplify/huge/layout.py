# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides space into blocks of at most so many faces: a k-d tree whose planes lie between cells.

Planes avoid places with many faces and, in later rounds, the seams of the round before.
"""

from dataclasses import dataclass, field

import numpy as np

from ..files.errors import MeshFileError
from .array_file import Array
from .grid import CELL_BITS, LEVELS, SIDE

_FILL = 0.9
"""Blocks are planned to be that full, as no plane halves exactly."""
_LEEWAY = 0.15
"""Share by which a plane may miss where it would halve exactly."""
_SEAM_WEIGHT = 5.0
"""What a seam vertex of the round before beside a plane costs, in faces beside it."""
_PILOT_FACES, _PILOT_SHARE = 20_000, 0.04

Corner = tuple[int, int, int]


class Histogram:
    """Faces and seam vertices a cell, on deeper levels only where that was asked for."""

    def __init__(self) -> None:
        self.faces = np.zeros((SIDE,) * 3, np.int64)
        self.seams = np.zeros((SIDE,) * 3, np.int64)
        self.inner: dict[tuple[int, int], Array] = {}
        """Faces within a divided cell, by its level and path."""

    @property
    def total(self) -> int:
        return int(self.faces.sum())

    def add(self, cells: Array, counts: Array, *, seams: bool = False) -> None:
        """Adds counts of the first level."""
        np.add.at((self.seams if seams else self.faces).reshape(-1), cells, counts)

    def add_inner(self, level: int, paths: Array, counts: Array) -> None:
        """Adds counts within divided cells of this level."""
        parents = paths >> CELL_BITS
        for parent in np.unique(parents):
            own = parents == parent
            table = self.inner.setdefault((level, int(parent)), np.zeros((SIDE,) * 3, np.int64))
            np.add.at(table.reshape(-1), paths[own] & ((1 << CELL_BITS) - 1), counts[own])

    def too_full(self, level: int, limit: int) -> list[int]:
        """Paths of the cells of a level that have more faces than a block may have."""
        if level == 0:
            return [int(cell) for cell in np.flatnonzero(self.faces.reshape(-1) > limit)]
        return [
            (parent << CELL_BITS) | int(cell)
            for (above, parent), table in sorted(self.inner.items())
            if above == level - 1
            for cell in np.flatnonzero(table.reshape(-1) > limit)
        ]


@dataclass
class Division:
    """Blocks, as tables of cells."""

    sizes: list[int] = field(default_factory=list)
    """Faces of each block."""
    blocks: list[Array] = field(default_factory=list)
    """As CellTable takes them."""
    pilots: list[Array] = field(default_factory=list)


def divide(histogram: Histogram, limit: int) -> Division:
    """Blocks of at most so many faces, each with cells around its middle as a pilot.

    Raises:
        MeshFileError: a cell of the last level has more faces.
    """
    division = Division()
    _Divider(histogram, limit, division).table(histogram.faces, 0, 0)
    return division


class _Divider:
    def __init__(self, histogram: Histogram, limit: int, division: Division) -> None:
        self._histogram, self.limit, self.division = histogram, limit, division

    def table(self, faces: Array, level: int, path: int) -> int:
        """Divides a level and returns the number of its table."""
        number = len(self.division.blocks)
        for tables in (self.division.blocks, self.division.pilots):
            tables.append(np.full(SIDE**3, -1, np.int32))
        seams = self._histogram.seams if level == 0 else None
        _Level(self, faces, seams, level, path, number).split((0, 0, 0), (SIDE,) * 3)
        return number

    def inner(self, level: int, path: int) -> int:
        """Divides a cell that has too many faces, and returns what its table has for it."""
        faces = self._histogram.inner.get((level, path))
        if faces is None or level + 1 >= LEVELS:
            raise MeshFileError(
                f"more than {self.limit:,} faces are at one place, less than a millionth of the mesh's size apart: "
                "they cannot be divided into blocks; give more by --memory"
            )
        return -2 - self.table(faces, level + 1, path)


class _Level:
    """The cells of one level within one cell of the level above."""

    def __init__(
        self, divider: _Divider, faces: Array, seams: Array | None, level: int, path: int, number: int
    ) -> None:
        self._divider, self._faces, self._seams, self._level, self._path = divider, faces, seams, level, path
        self._limit, self._sizes = divider.limit, divider.division.sizes
        shape = (SIDE,) * 3
        self._blocks = divider.division.blocks[number].reshape(shape)
        self._pilots = divider.division.pilots[number].reshape(shape)

    def split(self, low: Corner, high: Corner) -> None:
        """Makes blocks of a box of cells."""
        inside = tuple(slice(a, b) for a, b in zip(low, high, strict=True))
        faces = int(self._faces[inside].sum())
        if faces <= self._limit:
            self._make_block(low, inside, faces)
        elif (found := self._plane(inside, faces)) is None:
            # All are in one cell. What its table has is good for the empty ones around it, too.
            (cell,) = np.argwhere(self._faces[inside]) + np.array(low)
            number = int((cell[0] * SIDE + cell[1]) * SIDE + cell[2])
            self._blocks[inside] = self._pilots[inside] = self._divider.inner(
                self._level, (self._path << CELL_BITS) | number
            )
        else:
            axis, plane = found
            middle = [*high]
            middle[axis] = low[axis] + plane
            self.split(low, (middle[0], middle[1], middle[2]))
            middle = [*low]
            middle[axis] = low[axis] + plane
            self.split((middle[0], middle[1], middle[2]), high)

    def _plane(self, inside: tuple[slice, ...], faces: int) -> tuple[int, int] | None:
        """The axis, and how many layers of cells are before the plane; nothing where one cell has all faces."""
        parts = -(-faces // max(int(_FILL * self._limit), 1))
        wanted = (parts // 2) / parts
        best: tuple[float, float, int, int] | None = None
        for axis in range(3):
            others = tuple(k for k in range(3) if k != axis)
            layers = self._faces[inside].sum(axis=others).astype(np.float64)
            share = np.cumsum(layers)[:-1] / faces
            if not (divides := (share > 0) & (share < 1)).any():
                continue
            off = np.where(divides, np.abs(share - wanted), np.inf)
            price = np.minimum(layers[:-1], layers[1:]) + 0.25 * (layers[:-1] + layers[1:])
            if self._seams is not None:
                seams = self._seams[inside].sum(axis=others)
                price = price + _SEAM_WEIGHT * (seams[:-1] + seams[1:])
            # Those that miss by too much only where there are no others, and then the one that misses least.
            near = off <= _LEEWAY
            price = np.where(near, price, np.inf)
            k = int(np.lexsort((off, price))[0])
            found = (float(price[k]), float(off[k]), axis, k + 1)
            best = found if best is None or found[:2] < best[:2] else best
        return best[2:] if best else None

    def _make_block(self, low: Corner, inside: tuple[slice, ...], faces: int) -> None:
        block = len(self._sizes)
        self._sizes.append(faces)
        self._blocks[inside] = block
        counts = self._faces[inside]
        cells = np.argwhere(counts > 0)
        if len(cells) == 0:
            return
        weight = counts[tuple(cells.T)]
        middle = (cells * weight[:, None]).sum(axis=0) / weight.sum()
        start = cells[np.argmin(((cells - middle) ** 2).sum(axis=1))]
        order = np.argsort(((cells - start) ** 2).sum(axis=1), kind="stable")
        wanted = max(_PILOT_FACES, _PILOT_SHARE * faces)
        taken = cells[order[: int(np.searchsorted(np.cumsum(weight[order]), wanted)) + 1]] + np.array(low)
        self._pilots[tuple(taken.T)] = block
