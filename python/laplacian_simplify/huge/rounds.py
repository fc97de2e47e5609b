# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rounds of a run: blocks are simplified with their seams held, then divided anew, so that these are inside."""

from dataclasses import dataclass, replace
from typing import Any

from ..files.errors import MeshFileError, printable
from .array_file import ArrayFile
from .collapse import Engine
from .colors import expected_face
from .gather import Part, whole
from .grid import Layout
from .layout import Division, Histogram, divide
from .plan import (
    Round,
    Sizes,
    block_memory,
    common_cost,
    common_scale,
    held_back,
    next_round,
    shares,
)
from .prepare import Prepared, divided_further
from .stages import Answer, Stages, Task

_SURVEYED = 0.4
"""How far pilots go beyond what all are to keep, as no two blocks are alike."""

Row = dict[str, Any]
Parts = dict[int, list[Part]]


@dataclass(frozen=True)
class Aim:
    """What is asked for."""

    target: int
    engine: Engine
    effort: int
    sizes: Sizes
    avoid_crossings: bool
    """In each block, and in the last run."""
    samples: int
    """Points by which the result is compared; 0: it is not."""


@dataclass(frozen=True)
class Simplified:
    """The result, in the work folder."""

    blocks: list[Answer]
    """Files, with what is known of each."""
    rounds: list[Row]
    report: Row | None = None
    """Of the last run, where there was one."""


class Rounds:
    """Does them."""

    def __init__(self, stages: Stages, mesh: Prepared, aim: Aim) -> None:
        self._stages, self._mesh, self._work = stages, mesh, stages.work
        face_area = expected_face(mesh.area, aim.target, mesh.faces)
        self._aim = replace(aim, engine=replace(aim.engine, face_area=face_area))
        self._done: list[Row] = []
        self._items, self._largest, self._faces = mesh.items, mesh.chunk, mesh.faces

    def run(self) -> Simplified:
        """Simplifies the mesh.

        Raises:
            MeshFileError: it does not fit into the memory, something cannot be written, or is damaged.
            KeyboardInterrupt: a signal came. What is done is kept.
        """
        kept = 0
        while plan := next_round(self._faces, self._aim.target, self._aim.sizes, self._done):
            number = len(self._done)
            row: Row | None = self._work.get(f"round-{number}")
            if row is None:
                self._check(kept)
                kept = 0
                row = _OneRound(self, number, plan).run()
                self._work.add(f"round-{number}", row)
            else:
                kept += 1
            self._done.append(row)
            self._clear(number)
            self._items = [["block", block["file"]] for block in row["files"]]
            self._largest = max(block["faces"] for block in row["files"])
            self._faces = row["after"]
        self._check(kept)
        if self._done and self._done[-1]["kind"] == "second":
            return Simplified(self._done[-1]["files"], self._done)
        return self._last_run()

    def original_parts(self) -> Parts:
        """Of the blocks of the first round, as they were before."""
        answers = (self._work.get(f"scatter-0.{k}") for k in range(len(self._mesh.items)))
        return parts_of(list(answers))

    def _check(self, kept: int) -> None:
        """Refuses a work folder that was damaged since rounds were done that an earlier run did."""
        if kept == 0:
            return
        files = list(self._done[-1]["files"])
        if self._aim.samples > 0:
            files += [block["original"] for block in self._done[0]["files"]]
            files += [self._work.get(f"scatter-0.{k}") for k in range(len(self._mesh.items))]
        for written in files:
            if not self._work.has(written):
                raise MeshFileError(
                    f"{printable(self._work.path / written['file'])} is damaged or missing; "
                    "remove the folder to begin anew"
                )

    def _last_run(self) -> Simplified:
        blocks = self._done[-1]["files"] if self._done else []
        arguments = {
            "parts": [whole(block["file"], block["vertices"], block["faces"]) for block in blocks],
            "item": None if blocks else self._mesh.whole(),
            "target": self._aim.target,
            "engine": vars(self._aim.engine if blocks else replace(self._aim.engine, face_area=0)),
            "effort": self._aim.effort,
            "avoid_crossings": self._aim.avoid_crossings,
            "measure": not blocks and self._aim.samples > 0,
            "shown": self._mesh.path,
            "file": "last.block",
        }
        memory = self._aim.sizes.last_memory(self._faces)
        (answer,) = self._stages.do("last run", "last", [Task("last_run", arguments, memory)])
        return Simplified([answer], self._done, answer["report"])

    def _clear(self, number: int) -> None:
        """Removes what the round has read, but for what is compared with the result."""
        keep = number == 0 and self._aim.samples > 0
        folder = self._work.path
        chunks = [] if keep else [path.name for path in folder.glob(f"{number}.*.chunk")]
        blocks = [path.name for path in folder.glob(f"{number - 1}.*.block")]
        self._work.drop(f"{number}.layout", *chunks, *blocks)


class _OneRound:
    def __init__(self, rounds: Rounds, number: int, plan: Round) -> None:
        self._stages, self._mesh, self._aim = rounds._stages, rounds._mesh, rounds._aim
        self._items, self._largest, self._faces = rounds._items, rounds._largest, rounds._faces
        self._done, self._number, self._plan = rounds._done, number, plan
        self._grid, self._work = self._mesh.plain_grid, self._stages.work
        self._engine = self._aim.engine
        if self._done:
            self._engine = replace(self._engine, descriptor_scale=self._done[0]["descriptor_scale"])

    def run(self) -> Row:
        """Does the round and returns what there is to say about it, with its files."""
        division = divide(self._histogram(), self._aim.sizes.block)
        layout = f"{self._number}.layout"
        Layout.save(self._work.path / layout, division.blocks, division.pilots)
        parts = self._scatter(layout)
        if self._plan.kind == "second":
            row, wanted = self._share_out(division, parts, layout)
        else:
            row, wanted = self._find_cost(division, parts)
        files = self._collapse(division, parts, layout, wanted)
        if self._aim.avoid_crossings:
            counts = [answer["self_intersections"] for answer in files]  # None: a block that was small enough as it was
            row["self_intersections"] = None if None in counts else sum(counts)
        return {
            "kind": self._plan.kind,
            "before": self._faces,
            "after": sum(answer["faces"] for answer in files),
            "blocks": len(files),
            "largest": max(division.sizes),
            **row,
            "descriptor_scale": self._engine.descriptor_scale,
            "files": files,
        }

    def _histogram(self) -> Histogram:
        histogram = Histogram()
        for written in self._mesh.counts if self._number == 0 else self._done[-1]["files"]:
            file = ArrayFile(self._work.path / written["file"])
            histogram.add(file.read("cells"), file.read("counts"))
            if "seam_cells" in file:
                histogram.add(file.read("seam_cells"), file.read("seam_counts"), seams=True)
        limit = self._aim.sizes.block
        key = f"count-{self._number}"
        divided_further(self._stages, histogram, self._items, self._grid, key, self._largest, limit)
        return histogram

    def _scatter(self, layout: str) -> Parts:
        tasks = [
            Task(
                "scatter",
                {
                    "item": item,
                    "grid": self._grid,
                    "layout": layout,
                    "pilots": self._plan.kind != "second",
                    "file": f"{self._number}.{k}.chunk",
                },
                block_memory(self._largest),
            )
            for k, item in enumerate(self._items)
        ]
        return parts_of(self._stages.do("scatter", f"scatter-{self._number}", tasks))

    def _find_cost(self, division: Division, parts: Parts) -> tuple[Row, list[Row]]:
        """The cost for all blocks, by their pilots."""
        tasks = [
            Task(
                "pilot",
                {
                    "block": block,
                    "parts": parts[-1 - block],
                    "toc": parts[block],
                    "engine": vars(self._engine),
                    "share": _SURVEYED * self._plan.goal / self._faces,
                    "shown": self._mesh.path,
                },
                self._aim.sizes.block_memory(size // 4),
            )
            for block, size in enumerate(division.sizes)
        ]
        pilots = self._stages.do("pilots", f"pilot-{self._number}", tasks)
        seams = sum(pilot["seams"] for pilot in pilots)
        goal = held_back(self._plan, self._faces, seams)
        if not self._done:
            self._engine = replace(self._engine, descriptor_scale=common_scale(pilots, division.sizes))
        cost = common_cost(pilots, division.sizes, goal)
        effort = self._aim.effort if self._plan.kind == "first" else 0
        return {"goal": goal, "seams": seams, "cost": cost}, [{"effort": effort, "cost_limit": cost}] * len(pilots)

    def _share_out(self, division: Division, parts: Parts, layout: str) -> tuple[Row, list[Row]]:
        """The faces that each block keeps, at one cost."""
        share = _SURVEYED * self._plan.goal / self._faces
        tasks = [
            Task("survey", {**self._of_block(block, parts, layout), "share": share}, self._aim.sizes.block_memory(size))
            for block, size in enumerate(division.sizes)
        ]
        surveys = self._stages.do("pilots", f"survey-{self._number}", tasks)
        targets = shares(surveys, self._plan.goal)
        seams = sum(survey["seams"] for survey in surveys)
        wanted = [{"effort": self._aim.effort, "target": target} for target in targets]
        return {"goal": self._plan.goal, "seams": seams}, wanted

    def _collapse(self, division: Division, parts: Parts, layout: str, wanted: list[Row]) -> list[Answer]:
        sampled = self._number == 0 and self._aim.samples > 0
        tasks = []
        for block, size in enumerate(division.sizes):
            asked = wanted[block] | {"avoid_crossings": self._aim.avoid_crossings}
            if sampled:
                asked |= {"sampled": f"{block}.points", "density": self._aim.samples / self._mesh.faces}
            arguments = self._of_block(block, parts, layout)
            arguments |= {"wanted": asked, "file": f"{self._number}.{block}.block"}
            memory = self._aim.sizes.block_memory(size, refined=asked["effort"] > 0)
            tasks.append(Task("collapse", arguments, memory))
        return self._stages.do("refine" if wanted[0]["effort"] else "collapse", f"collapse-{self._number}", tasks)

    def _of_block(self, block: int, parts: Parts, layout: str) -> dict[str, Any]:
        return {
            "block": block,
            "parts": parts[block],
            "grid": self._grid,
            "layout": layout,
            "engine": vars(self._engine),
            "shown": self._mesh.path,
        }


def parts_of(answers: list[Answer]) -> Parts:
    """What every block, and every pilot by its negative number, has in which file."""
    parts: Parts = {}
    for answer in answers:
        for number, *rows in answer["toc"]:
            parts.setdefault(number, []).append([answer["file"], *rows])
    return parts
