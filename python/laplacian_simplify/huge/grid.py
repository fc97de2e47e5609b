# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of space on three levels, each of 128^3 cells within one of the level above, and tables over them."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .array_file import Array, ArrayFile, save_arrays

SIDE = 128
LEVELS = 3
_BITS = 7
CELL_BITS = 3 * _BITS
"""Bits of a cell's number within its level."""


@dataclass(frozen=True)
class Grid:
    """A cube around the mesh."""

    low: tuple[float, float, float]
    step: float
    """Side of a cell of the last level."""

    @property
    def side(self) -> float:
        """Of the cube."""
        return self.step * float(SIDE**LEVELS)

    @classmethod
    def around(cls, low: list[float], high: list[float]) -> "Grid":
        """The smallest for this box."""
        longest = max(b - a for a, b in zip(low, high, strict=True))
        step = longest / SIDE**LEVELS * (1 + 1e-12)  # the far side is inside
        return cls((low[0], low[1], low[2]), step if step > 0 else 1.0)

    def places(self, positions: Array) -> Array:
        """int32, (n, 3): the cells of the last level along each axis."""
        cells = np.floor((positions - np.array(self.low)) / self.step)
        places: Array = np.clip(cells, 0, SIDE**LEVELS - 1).astype(np.int32)
        return places

    def centroid_places(self, positions: Array, triangles: Array) -> Array:
        """The same of the centroids of triangles."""
        centroids = positions[triangles[:, 0]]
        centroids += positions[triangles[:, 1]]
        centroids += positions[triangles[:, 2]]
        centroids /= 3
        return self.places(centroids)


def cells_of(places: Array, level: int) -> Array:
    """int64: numbers of cells of a level, 0 to 2, within their cell of the level above."""
    shift = _BITS * (LEVELS - 1 - level)
    at = (places >> shift) & (SIDE - 1)
    return (at[:, 0].astype(np.int64) << 2 * _BITS) | (at[:, 1] << _BITS) | at[:, 2]


def paths_of(places: Array, level: int) -> Array:
    """int64: numbers of cells of a level within the whole grid, the coarsest level first."""
    path = cells_of(places, 0)
    for deeper in range(1, level + 1):
        path = (path << CELL_BITS) | cells_of(places, deeper)
    return path


def counted(paths: Array) -> dict[str, Array]:
    """Ascending paths and how often each is there."""
    cells, counts = np.unique(paths, return_counts=True)
    return {"cells": cells, "counts": counts.astype(np.int64)}


class CellTable:
    """A number for every cell: that of the first level, or of a deeper one where the cell is divided."""

    def __init__(self, tables: Array) -> None:
        """Takes int32, (k, 128^3): that of the first level, and one of each divided cell. -2 - k stands for table k."""
        self._tables = tables

    def at(self, places: Array) -> Array:
        """int32: the number for each of these places."""
        found: Array = self._tables[0][cells_of(places, 0)]
        for level in range(1, LEVELS):
            divided = np.flatnonzero(found <= -2)
            if len(divided) == 0:
                break
            found[divided] = self._tables[-2 - found[divided], cells_of(places[divided], level)]
        return found


@dataclass(frozen=True)
class Layout:
    """Which block has which cells, and around which cells of each block its pilot is."""

    blocks: CellTable
    pilots: CellTable
    """-1 where there is none."""

    @staticmethod
    def save(path: Path, blocks: list[Array], pilots: list[Array]) -> dict[str, Any]:
        """Writes a file with tables."""
        return save_arrays(path, {"blocks": np.stack(blocks), "pilots": np.stack(pilots)})

    @classmethod
    def read(cls, path: Path, *, pilots: bool = False) -> "Layout":
        """Reads it, with the pilots only where they are wanted."""
        file = ArrayFile(path)
        blocks = CellTable(file.read("blocks"))
        return cls(blocks, CellTable(file.read("pilots")) if pilots else blocks)
