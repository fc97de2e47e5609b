# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The last run on what is left, and the result as a file."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from ..files.errors import printable
from ..files.staging import unwritable
from ..library import MeshArrays
from . import surface_library
from .array_file import Array, ArrayFile, save_arrays
from .collapse import Engine
from .colors import as_bytes
from .gather import Item, Part, gather, load

_ROWS = 1 << 20
_FACES_A_THREAD = 250_000
"""As in the engine's own passes. More threads gain little, and their stacks take address space, which is bounded."""


def last_run(
    folder: Path, parts: list[Part], item: Item | None, target: int, measure: bool,
    avoid_crossings: bool, engine: Engine, effort: int, shown: str, file: str,
) -> dict[str, Any]:  # fmt: skip
    """Simplifies what is left as simplify would, and writes it as a block.

    Args:
        folder: of the work.
        parts: of what is left; none where the input itself is small enough.
        item: that input.
        target: faces.
        measure: distances, too.
        avoid_crossings: no more faces cross than in what is left.
        engine: as for the blocks.
        effort: number of the filter's option.
        shown: name of the mesh.
        file: to write.
    """
    mesh, colors, before = _whole_mesh(folder, parts, item, shown)
    parameters = engine.parameters(target, effort, threads=_threads(len(mesh.faces))) | {
        "avoid_self_intersections": int(avoid_crossings),
        "clean_input": 1,
        "measure_error": int(measure),
    }
    outcome, colors = engine.run(mesh, colors, parameters)
    arrays = {
        "ids": np.arange(len(outcome.vertices)),
        "positions": outcome.vertices,
        "triangles": outcome.faces,
        "shared": np.zeros(len(outcome.vertices), bool),
    }
    if colors is not None:
        arrays["colors"] = colors
    counts = {"faces": len(outcome.faces), "vertices": len(outcome.vertices)}
    return {**save_arrays(folder / file, arrays), **counts, "report": outcome.report | before}


def _threads(faces: int) -> int:
    return min(len(os.sched_getaffinity(0)), 1 + faces // _FACES_A_THREAD)


def _whole_mesh(
    folder: Path, parts: list[Part], item: Item | None, shown: str
) -> tuple[MeshArrays, Array | None, dict[str, int]]:
    """What is left, its colors, and of an input as it is the edges that nobody has counted yet."""
    if item is None:
        block = gather(folder, parts, shown)
        return MeshArrays(block.positions, block.triangles), block.colors, {}
    chunk = load(folder, item)
    edges = surface_library.edges(chunk.positions, chunk.triangles, np.zeros(len(chunk.positions), bool))
    names = ("boundary_edges_before", "non_manifold_edges_before")
    return MeshArrays(chunk.positions, chunk.triangles), chunk.colors, dict(zip(names, edges, strict=True))


def write_mesh(folder: Path, files: list[str], output: str, shown: str, single: bool) -> dict[str, Any]:
    """Joins blocks to a binary PLY file, one block after the other.

    Raises:
        MeshFileError: it cannot be written.
    """
    blocks = [ArrayFile(folder / file) for file in files]
    numbering = _Numbering(blocks)
    faces = sum(block.rows("triangles") for block in blocks)
    row = [("position", "<f4" if single else "<f8", 3)]
    colors = blocks[0].columns("colors")
    if colors:
        row.append(("color", "u1", colors))
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {numbering.total}\n"
        + "".join(f"property {'float' if single else 'double'} {axis}\n" for axis in "xyz")
        + "".join(f"property uchar {name}\n" for name in ("red", "green", "blue", "alpha")[:colors])
        + f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    with _writing(output, shown) as file:
        file.write(header.encode())
        for block, first in zip(blocks, numbering.first, strict=True):
            vertices = np.empty(int(np.count_nonzero(first)), row)
            vertices["position"] = block.read("positions")[first]
            if colors:
                vertices["color"] = as_bytes(block.read("colors")[first])
            file.write(vertices.tobytes())
        for k, block in enumerate(blocks):
            corners = numbering.numbers(k)[block.read("triangles")]
            for begin in range(0, len(corners), _ROWS):
                rows = np.empty(min(_ROWS, len(corners) - begin), [("count", "u1"), ("corners", "<i4", 3)])
                rows["count"], rows["corners"] = 3, corners[begin : begin + _ROWS]
                file.write(rows.tobytes())
    return {"vertices": numbering.total, "faces": faces}


@contextmanager
def _writing(output: str, shown: str) -> Iterator[Any]:
    path = Path(output)
    try:
        with path.open("wb") as file:
            yield file
    except OSError as error:
        raise unwritable(printable(shown), error, path.parent) from None


class _Numbering:
    """Numbers vertices block by block; one that several blocks have gets its number in the first of them."""

    def __init__(self, blocks: list[ArrayFile]) -> None:
        self._blocks = blocks
        shared = [block.read("ids")[block.read("shared")] for block in blocks]
        self._seams = np.unique(np.concatenate(shared)) if shared else np.empty(0, np.int64)
        self._of_seam = np.full(len(self._seams), -1, np.int64)
        self.first: list[Array] = []
        """bool, of each block: the vertices that get their numbers there."""
        self._begins: list[int] = []
        self.total = 0
        for block, ids in zip(blocks, shared, strict=True):
            is_shared = block.read("shared")
            at = np.searchsorted(self._seams, ids)
            first = ~is_shared
            first[np.flatnonzero(is_shared)[self._of_seam[at] < 0]] = True
            number = self.total + np.cumsum(first) - 1
            new = first[is_shared]
            self._of_seam[at[new]] = number[is_shared][new]
            self.first.append(first)
            self._begins.append(self.total)
            self.total += int(np.count_nonzero(first))

    def numbers(self, k: int) -> Array:
        """Of the vertices of a block in the file."""
        numbers: Array = self._begins[k] + np.cumsum(self.first[k]) - 1
        is_shared = self._blocks[k].read("shared")
        ids = self._blocks[k].read("ids")[is_shared]
        numbers[is_shared] = self._of_seam[np.searchsorted(self._seams, ids)]
        return numbers
