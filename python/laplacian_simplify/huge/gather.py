# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what a task works on: faces of the input, a block of the round before, or a block out of many chunks."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..files.errors import printable
from .array_file import Array, ArrayFile
from .chunk import Chunk
from .source import open_source
from .welding import check_collisions

Item = list[Any]
"""["input", path, first face, last, brightest of each part of its colors] or ["block", file]: what a round starts
with. The fourth may be missing."""
Part = list[Any]
"""[file, vertices from, to, faces from, to, foreign ids from, to]: what a block has of a file."""


@dataclass(frozen=True, eq=False)
class Block:
    """The faces of a block, each vertex once."""

    ids: Array
    """int64, ascending."""
    positions: Array
    triangles: Array
    foreign: Array
    """int64, ascending: vertices whose home this block is, and that faces of other blocks have."""
    colors: Array | None = None
    """As of chunks."""


def load(folder: Path, item: Item) -> Chunk:
    """A part of the mesh as it is before a round."""
    if item[0] == "input":
        return open_source(item[1]).chunk(item[2], item[3], *item[4:])
    file = ArrayFile(folder / item[1])
    colors = file.read("colors") if "colors" in file else None
    return Chunk(file.read("ids"), file.read("positions"), file.read("triangles"), colors=colors)


def whole(file: str, vertices: int, faces: int) -> Part:
    """All of a file."""
    return [file, 0, vertices, 0, faces, 0, 0]


def gather(folder: Path, parts: list[Part], shown: str) -> Block:
    """Joins what several files have of a block, in the order of the files.

    Raises:
        MeshFileError: a file is damaged, or two vertices have the same id.
    """
    ids, positions, triangles, colors, foreign = _read(folder, parts)
    all_ids = np.concatenate(ids)
    ids.clear()
    once, first, place = np.unique(all_ids, return_index=True, return_inverse=True)
    del all_ids
    corners = place.astype(np.uint32)[np.concatenate(triangles)]
    triangles.clear()
    everywhere = np.concatenate(positions)
    positions.clear()
    picked = everywhere[first]
    check_collisions(picked[place], everywhere, printable(shown))
    found = np.unique(np.concatenate(foreign)) if foreign else np.empty(0, np.int64)
    return Block(once, picked, corners, found, np.concatenate(colors)[first] if colors else None)


def count_foreign(folder: Path, parts: list[Part]) -> int:
    """How many vertices whose home is a block are used by others."""
    foreign = [ArrayFile(folder / part[0]).read("foreign", part[5], part[6]) for part in parts if part[6] > part[5]]
    return len(np.unique(np.concatenate(foreign))) if foreign else 0


def _read(folder: Path, parts: list[Part]) -> tuple[list[Array], list[Array], list[Array], list[Array], list[Array]]:
    ids: list[Array] = []
    positions: list[Array] = []
    triangles: list[Array] = []
    colors: list[Array] = []
    foreign: list[Array] = []
    at = 0
    for name, v0, v1, f0, f1, g0, g1 in parts:
        file = ArrayFile(folder / name)
        if f1 > f0:
            ids.append(file.read("ids", v0, v1))
            positions.append(file.read("positions", v0, v1))
            triangles.append(file.read("triangles", f0, f1) + np.uint32(at))
            if "colors" in file:
                colors.append(file.read("colors", v0, v1))
            at += v1 - v0
        if g1 > g0:
            foreign.append(file.read("foreign", g0, g1))
    return ids, positions, triangles, colors, foreign
