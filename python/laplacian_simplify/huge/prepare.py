# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the input once: the box of its vertices, and how many faces are in which cell."""

from dataclasses import dataclass
from pathlib import Path

from ..files.errors import MeshFileError, printable
from .array_file import ArrayFile
from .colors import whole_area
from .gather import Item
from .grid import LEVELS, Grid
from .layout import Histogram
from .plan import block_memory
from .source import Source
from .stages import Answer, Stages, Task


@dataclass(frozen=True)
class Prepared:
    """The mesh as the first round takes it."""

    path: str
    single: bool
    """Whether coordinates have single precision."""
    items: list[Item]
    """Its chunks."""
    chunk: int
    """Faces of each but the last."""
    grid: Grid
    low: list[float]
    high: list[float]
    counts: list[Answer]
    faces: int
    dropped: int
    """Faces with the same vertex at two corners, which are left out."""
    colors: int
    """Bytes that the color of a vertex has."""
    area: float
    """Of all faces, where vertices have colors."""

    def whole(self) -> Item:
        """All of it in one chunk."""
        name, path, _, _, *colors = self.items[0]
        return [name, path, 0, self.faces + self.dropped, *colors]

    @property
    def plain_grid(self) -> list[float]:
        """As tasks take it."""
        return [*self.grid.low, self.grid.step]


def prepare(stages: Stages, path: str, source: Source, chunk: int) -> Prepared:
    """Looks at every vertex and face.

    Raises:
        MeshFileError: one cannot be used, or the file has changed since the work folder was begun.
    """
    _forget_what_has_changed(stages, path)
    rows = [(begin, min(begin + 2 * chunk, source.vertices)) for begin in range(0, source.vertices, 2 * chunk)]
    boxes = stages.do(
        "bounds",
        "bounds",
        [Task("bounds", {"source": path, "begin": a, "end": b}, block_memory(chunk)) for a, b in rows],
    )
    low = [min(box["low"][k] for box in boxes) for k in range(3)]
    high = [max(box["high"][k] for box in boxes) for k in range(3)]
    grid = Grid.around(low, high)
    brightest = [max(parts) for parts in zip(*(box["brightest"] for box in boxes), strict=True)]
    items: list[Item] = [
        ["input", path, begin, min(begin + chunk, source.faces), brightest] for begin in range(0, source.faces, chunk)
    ]
    counts = count_faces(stages, items, [*grid.low, grid.step], "count", chunk)
    _compare([answer["read"] for answer in (*boxes, *counts)], stages, path)
    dropped = sum(answer["dropped"] for answer in counts)
    area = whole_area([answer["area"] for answer in counts], grid.side)
    return Prepared(
        path, source.single, items, chunk, grid, low, high, counts, source.faces - dropped, dropped,
        source.colors, area,
    )  # fmt: skip


def count_faces(
    stages: Stages, items: list[Item], grid: list[float], key: str, faces: int, level: int = 0,
    inside: list[int] | None = None,
) -> list[Answer]:  # fmt: skip
    """Counts faces a cell of a level in every item, which have at most so many."""
    tasks = [
        Task(
            "count",
            {"item": item, "grid": grid, "level": level, "inside": inside or [], "file": f"{key}.{k}.counts"},
            block_memory(faces),
        )
        for k, item in enumerate(items)
    ]
    return stages.do("scan", key, tasks)


def divided_further(
    stages: Stages, histogram: Histogram, items: list[Item], grid: list[float], key: str, faces: int, limit: int
) -> None:
    """Counts within cells that have more faces than a block may have, level by level."""
    for level in range(LEVELS - 1):
        cells = histogram.too_full(level, limit)
        if not cells:
            return
        deeper = f"{key}-{level + 1}"
        for answer in count_faces(stages, items, grid, deeper, faces, level + 1, cells):
            file = ArrayFile(stages.work.path / answer["file"])
            histogram.add_inner(level, file.read("cells"), file.read("counts"))


def _forget_what_has_changed(stages: Stages, path: str) -> None:
    """Has the file read again where it has another time since."""
    work, now = stages.work, Path(path).stat().st_mtime_ns
    if work.get("input_time") is None:
        work.add("input_time", now)
    elif work.get("input_time") != now:
        work.forget("bounds.")
        work.forget("count.")


def _compare(checksums: list[int], stages: Stages, path: str) -> None:
    """Refuses a file whose bytes are not those that were read before."""
    work = stages.work
    if work.get("checksums") is None:
        work.add("checksums", checksums)
    elif work.get("checksums") != checksums:
        raise MeshFileError(
            f"{printable(work.path)} holds another run: {printable(path)} has changed since; "
            "remove the folder to begin anew, or give another --work-folder"
        )
    work.add("input_time", Path(path).stat().st_mtime_ns)
