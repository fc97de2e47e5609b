# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the faces of cells, and hands faces to the blocks in which their centroids are."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from .array_file import Array, save_arrays
from .chunk import Chunk
from .colors import counted_area
from .gather import Item, load
from .grid import Grid, Layout, counted, paths_of

Toc = list[list[int]]
"""[block, vertices from, to, faces from, to, foreign ids from, to]; a pilot's number is -1 - that of its block."""


def count(folder: Path, item: Item, grid: Grid, level: int, inside: list[int], file: str) -> dict[str, Any]:
    """Faces a cell of a level; on deeper levels only within these cells of the level above."""
    chunk = load(folder, item)
    places = grid.centroid_places(chunk.positions, chunk.triangles)
    if level > 0:
        places = places[np.isin(paths_of(places, level - 1), np.array(inside, np.int64))]
    written = save_arrays(folder / file, counted(paths_of(places, level)))
    area = 0 if chunk.colors is None or level > 0 else counted_area(chunk.positions, chunk.triangles, grid.side)
    return {**written, "dropped": chunk.dropped, "read": chunk.checksum, "area": area}


def scatter(folder: Path, item: Item, grid: Grid, layout: str, pilots: bool, file: str) -> dict[str, Any]:
    """Writes a file with a part of the mesh sorted by blocks.

    The home of a vertex is the block of its own cell. Where a face of another block has it, its id is written for its
    home, too: so each block knows which of its vertices others have, without a table of all.
    """
    chunk = load(folder, item)
    tables = Layout.read(folder / layout, pilots=pilots)
    places = grid.centroid_places(chunk.positions, chunk.triangles)
    writer = _Writer(chunk, tables.blocks.at(grid.places(chunk.positions)))
    blocks = tables.blocks.at(places)
    order = np.argsort(blocks, kind="stable")
    borders = np.searchsorted(blocks[order], np.arange(int(blocks.max(initial=-1)) + 2))
    for block in np.unique(blocks):
        writer.add(int(block), order[borders[block] : borders[block + 1]])
    if pilots:
        of_pilot = tables.pilots.at(places)
        for block in np.unique(of_pilot[of_pilot >= 0]):
            writer.add_pilot(int(block), np.flatnonzero(of_pilot == block))
    return {**save_arrays(folder / file, writer.arrays()), "toc": writer.toc}


@dataclass
class _Writer:
    """Collects what blocks get."""

    chunk: Chunk
    home: Array
    toc: Toc = field(default_factory=list)
    _ids: list[Array] = field(default_factory=list)
    _positions: list[Array] = field(default_factory=list)
    _triangles: list[Array] = field(default_factory=list)
    _colors: list[Array] = field(default_factory=list)
    _foreign: dict[int, list[Array]] = field(default_factory=dict)

    def add(self, block: int, faces: Array) -> None:
        """Gives a block faces, and others the ids of vertices of theirs that it has now."""
        used = self._put(block, faces)
        away = used[self.home[used] != block]
        homes = self.home[away]
        for home in np.unique(homes):
            self._foreign.setdefault(int(home), []).append(self.chunk.ids[away[homes == home]])

    def add_pilot(self, block: int, faces: Array) -> None:
        self._put(-1 - block, faces)

    def arrays(self) -> dict[str, Array]:
        """What the file has; the table of contents is whole after that."""
        foreign, at = [np.empty(0, np.int64)], 0
        rows = {row[0]: row for row in self.toc}
        for block in sorted(self._foreign):
            ids = np.unique(np.concatenate(self._foreign[block]))
            if block not in rows:
                rows[block] = [block, 0, 0, 0, 0, 0, 0]
                self.toc.append(rows[block])
            rows[block][5:] = [at, at + len(ids)]
            at += len(ids)
            foreign.append(ids)
        none = self.chunk  # of which nothing is taken where there is no face
        parts = {
            "ids": [none.ids[:0], *self._ids],
            "positions": [none.positions[:0], *self._positions],
            "triangles": [none.triangles[:0], *self._triangles],
            "foreign": foreign,
        }
        if none.colors is not None:
            parts["colors"] = [none.colors[:0], *self._colors]
        return {name: np.concatenate(arrays) for name, arrays in parts.items()}

    def _put(self, number: int, faces: Array) -> Array:
        """Adds faces with their vertices, numbered anew, and returns which vertices they are."""
        triangles = self.chunk.triangles[faces]
        mark = np.zeros(len(self.chunk.ids), bool)
        mark[triangles.reshape(-1)] = True
        used = np.flatnonzero(mark)
        place = np.cumsum(mark, dtype=np.uint32) - np.uint32(1)
        v0 = self.toc[-1][2] if self.toc else 0
        f0 = self.toc[-1][4] if self.toc else 0
        self.toc.append([number, v0, v0 + len(used), f0, f0 + len(faces), 0, 0])
        self._ids.append(self.chunk.ids[used])
        self._positions.append(self.chunk.positions[used])
        self._triangles.append(place[triangles])
        if self.chunk.colors is not None:
            self._colors.append(self.chunk.colors[used])
        return used
