# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What huge is asked for and what it reports."""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from ..answers import Spelling, as_keyword
from ..report import STOP_REASONS, StopReason
from ..summary import summary_lines

Progress = Callable[[str, int, int], object]
"""Called with the stage, tasks done, and tasks in all."""


@dataclass(frozen=True, kw_only=True)
class HugeRequest:
    """What is asked for."""

    source: str
    output: Path
    values: Mapping[str, Any]
    """Options of simplify that were given, checked."""
    workers: int | None = None
    scheduler: str | None = None
    memory: int | None = None
    """Bytes for all processes, or for each where a scheduler has workers on several machines."""
    work_folder: Path | None = None
    block_faces: int | None = None
    """In place of what the memory allows, for tests: the last run then has at most four times as many."""
    chunk_faces: int | None = None


@dataclass(frozen=True, kw_only=True)
class HugeReport:
    """What was done. Distances are percent of the bounding box's diagonal."""

    faces_before: int
    faces: int
    vertices: int
    target_reached: bool
    stop_reason: StopReason
    boundary_edges: int
    non_manifold_edges: int
    boundary_edges_before: int | None = None
    """None where nothing was to be measured, as those below."""
    non_manifold_edges_before: int | None = None
    hausdorff: float | None = None
    """The largest distance of the samples, in either direction."""
    rms: float | None = None
    feature_rms: float | None = None
    self_intersections: int | None = None
    """Pairs of faces that cross; None where they were not to be avoided, or the result was refined in blocks."""
    self_intersections_before: int | None = None
    """Counted only where the mesh fits into memory and some of the result cross."""
    dropped_faces: int
    """With the same vertex at two corners."""
    rounds: list[dict[str, Any]] = field(repr=False)
    """Of each: kind, before, after, goal (faces), blocks, largest (faces of a block), seams (vertices), cost, and
    self_intersections (pairs within blocks; None where a block was small enough as it was)."""
    processor_seconds: dict[str, float] = field(repr=False)
    """Of each stage."""
    peak_memory: int
    """Bytes of the largest process."""
    seconds: float
    """Since this run, which may have gone on with another, began."""
    notes: list[str] = field(repr=False)
    """What the result lacks."""

    def __post_init__(self) -> None:
        self.__dict__["stop_reason"] = StopReason(self.stop_reason)

    @property
    def stop_reason_text(self) -> str:
        """Why it ended, in words."""
        return STOP_REASONS[self.stop_reason]

    def to_dict(self) -> dict[str, Any]:
        """The numbers under their names; those that were not measured are absent."""
        values = {name: value for name, value in asdict(self).items() if value is not None}
        return values | {"stop_reason": int(self.stop_reason), "stop_reason_text": self.stop_reason_text}

    def __str__(self) -> str:
        return self.text()

    def text(self, spelled: Spelling = as_keyword) -> str:
        """For people; remedies spell parameters as the caller does."""
        numbers = self.to_dict()
        numbers.pop("dropped_faces")
        lines = summary_lines(numbers, spelled)
        if self.boundary_edges_before is not None:
            lines.append(
                f"before    {self.non_manifold_edges_before:,} non-manifold edges, "
                f"{self.boundary_edges_before:,} boundary edges"
            )
        counts = [row["after"] for row in self.rounds]
        in_blocks = ", ".join(f"{row['blocks']:,} to {row['after']:,} faces" for row in self.rounds)
        lines.append(f"blocks    {in_blocks}" if counts else "blocks    none: the mesh fits into the memory")
        total = sum(self.processor_seconds.values())
        lines.append(
            f"work      {total:.1f} processor seconds, largest process {self.peak_memory / (1 << 20):,.0f} MiB"
        )
        return "\n".join(lines)
