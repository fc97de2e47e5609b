# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the result with the mesh before: distances both ways by sampling, edges by counting."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from .array_file import Array, ArrayFile, save_arrays
from .edges import edges_between_blocks
from .measure import is_near
from .plan import block_memory
from .prepare import Prepared
from .rounds import Aim, Parts, Row, Simplified
from .stages import Answer, Stages, Task

_FEATURE_SHARE = 0.1  # of the vertices, those with the largest descriptor, as in the reports of simplify
_WIDER = 4
_LEAST_REACH = 1e-6  # of the size of all, so that a reach of 0, as of a result without area, gets wider, too


@dataclass(frozen=True)
class Surface:
    """A part of one."""

    parts: list[Any]
    """Of a block before, or none."""
    block: str
    """A block of the result."""
    box: Answer
    faces: int


class Comparison:
    """Compares what a run began with and what it made."""

    def __init__(self, stages: Stages, mesh: Prepared, aim: Aim, done: Simplified, original: Parts) -> None:
        self._stages, self._mesh, self._aim, self._done, self._parts = stages, mesh, aim, done, original
        self._folder = stages.work.path
        self._before: list[Answer] = [block["original"] for block in done.rounds[0]["files"]]

    def edges(self) -> dict[str, int]:
        """Boundary and non-manifold edges before and after."""
        counts = _edges(self._before, [ArrayFile(self._folder / answer["file"]) for answer in self._before])
        row = {"boundary_edges_before": counts[0], "non_manifold_edges_before": counts[1]}
        return row | edges_after(self._stages, self._done)

    def distances(self) -> dict[str, float]:
        """In percent of the diagonal of the box before."""
        after = self._sample_result()
        faces = [block["before"] for block in self._done.rounds[0]["files"]]
        before = [Surface(self._parts[k], "", box, faces[k]) for k, box in enumerate(self._before)]
        result = [
            Surface([], block["file"], box, block["faces"]) for block, box in zip(self._done.blocks, after, strict=True)
        ]
        points, weights = self._points(self._before)
        corners = np.concatenate([self._read(answer, "corners") for answer in self._before])
        spacing = 2 * float(np.sqrt(sum(box["area"] for box in after) / sum(part.faces for part in result)))
        there = self._nearest("forward", result, np.concatenate([points, corners]), spacing)
        forward, at_corners = there[: len(points)], there[len(points) :]
        points_after, weights_after = self._points(after)
        back = self._nearest("backward", before, points_after, max(float(there.max(initial=0)), spacing))
        features = self._features(at_corners)
        squares = _mean(forward**2, weights), _mean(back**2, weights_after)
        percent = 100 / float(np.linalg.norm(np.array(self._mesh.high) - np.array(self._mesh.low)) or 1)
        return {
            "hausdorff": percent * float(max(there.max(initial=0), back.max(initial=0))),
            "rms": percent * float(np.sqrt(sum(squares) / 2)),
            "feature_rms": percent * float(np.sqrt(np.mean(features**2))) if len(features) else 0.0,
        }

    def _nearest(self, key: str, surfaces: list[Surface], points: Array, reach: float) -> Array:
        return nearest_in_parts(self._stages, key, surfaces, points, reach, self._mesh.path)

    def _features(self, distances: Array) -> Array:
        """Distances at those of the sampled vertices that have the largest descriptor."""
        descriptor = np.concatenate([self._read(answer, "descriptor") for answer in self._before])
        count = -(-len(descriptor) * _FEATURE_SHARE // 1)
        return distances[np.argsort(-descriptor, kind="stable")[: int(count)]]

    def _sample_result(self) -> list[Answer]:
        density = self._aim.samples / sum(block["faces"] for block in self._done.blocks)
        tasks = [
            Task(
                "sample_result",
                {"block": block["file"], "density": density, "file": f"after.{k}.points"},
                block_memory(self._aim.sizes.block),
            )
            for k, block in enumerate(self._done.blocks)
        ]
        return self._stages.do("measure", "sample", tasks)

    def _points(self, answers: list[Answer]) -> tuple[Array, Array]:
        points, weights = (
            np.concatenate([self._read(answer, name) for answer in answers]) for name in ("points", "weights")
        )
        return points, weights

    def _read(self, answer: Answer, name: str) -> Array:
        return ArrayFile(self._folder / answer["file"]).read(name)


def nearest_in_parts(
    stages: Stages, key: str, surfaces: list[Surface], points: Array, reach: float, shown: str
) -> Array:
    """Distances of points to a surface in parts: of each point to those parts that are near it.

    A distance up to the reach is right, as no other part is nearer. Points that have none yet are looked at again with
    a larger reach.
    """
    folder = stages.work.path
    best = np.full(len(points), np.inf)
    pending = np.arange(len(points))
    corners = [surface.box[side] for surface in surfaces for side in ("low", "high")]
    reach = max(reach, _LEAST_REACH * float(np.ptp(np.concatenate([points, corners]), axis=0).max()))
    turn = 0
    while len(pending):
        written = save_arrays(folder / f"{key}-{turn}.points", {"points": points[pending], "numbers": pending})
        tasks = [
            _task(surface, reach, written["file"], shown, f"{key}-{turn}.{k}.distances")
            for k, surface in enumerate(surfaces)
            if is_near(points[pending], surface.box["low"], surface.box["high"], reach).any()
        ]
        for answer in stages.do("measure", f"{key}-{turn}", tasks):
            file = ArrayFile(folder / answer["file"])
            np.minimum.at(best, file.read("numbers"), file.read("distances"))
        pending = pending[best[pending] > reach]
        reach *= _WIDER
        turn += 1
    return best


def _task(surface: Surface, reach: float, points: str, shown: str, file: str) -> Task:
    arguments = {
        "parts": surface.parts,
        "block": surface.block,
        "low": surface.box["low"],
        "high": surface.box["high"],
        "reach": reach,
        "points": points,
        "threads": 1,
        "shown": shown,
        "file": file,
    }
    return Task("nearest", arguments, block_memory(surface.faces))


def edges_after(stages: Stages, done: Simplified) -> dict[str, int]:
    """Boundary and non-manifold edges of the result."""
    if done.report is not None:
        counts = done.report["boundary_edges"], done.report["non_manifold_edges"]
    else:
        counts = _edges(done.blocks, [ArrayFile(stages.work.path / block["file"]) for block in done.blocks])
    return {"boundary_edges": counts[0], "non_manifold_edges": counts[1]}


def _edges(answers: list[Row], files: list[ArrayFile]) -> tuple[int, int]:
    between = edges_between_blocks(
        [file.read("edge_ends") for file in files], [file.read("edge_faces") for file in files]
    )
    return (
        between[0] + sum(answer["boundary_edges"] for answer in answers),
        between[1] + sum(answer["non_manifold_edges"] for answer in answers),
    )


def _mean(values: Array, weights: Array) -> float:
    return float(np.average(values, weights=weights)) if weights.sum() > 0 else 0.0
