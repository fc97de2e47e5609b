# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a mesh is simplified in the memory that there is: sizes of blocks, rounds, and the one cost for all blocks."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..files.errors import MeshFileError

_MIB = 1 << 20
_PROCESS = 75 * _MIB
"""What a process takes before it has read anything."""
_BLOCK_FACE, _REFINED_FACE, _LAST_FACE = 220, 400, 400
"""Bytes a face: of a block that is collapsed, of one that is refined, too, and in the last run."""
_COLORED_FACE = 180
"""More of them where vertices have colors."""
_SHARE_OF_BLOCK = 4
"""Blocks that fit into memory at a time."""
_LARGEST_BLOCK, _LEAST_BLOCK = 2_000_000, 20_000
_BLOCKS_IN_LAST = 4
"""The last run's faces in blocks, where the size of a block is given in place of the memory."""

_BEST_LEFT, _LEAST_LEFT = 12.0, 2.5
"""Faces before the last run, as a multiple of the target: what is planned, and the least. It sees no other original."""
_ROOM = 0.8
"""Of what fits into memory: a round ends up to 17 % above what was planned."""
_SEAM_FACES = 10
"""Faces to keep in a round, a seam vertex: seams cannot shrink in their own round."""
_LEAST_PROGRESS = 0.9
_LEFT_BEFORE_BLOCKS, _FIRST_BLOCKS, _FACES_AT_SEAM = 3.0, 1.1, 4
"""Where the result is refined in blocks: faces before, and after the first of two rounds, as multiples of the target;
and the faces that a seam vertex keeps in it."""


@dataclass(frozen=True)
class Sizes:
    """What fits where, in faces."""

    block: int
    last: int
    """In the last run, which has the whole mesh in one process."""
    colored: bool = False
    """Whether vertices have colors."""

    def block_memory(self, faces: int, *, refined: bool = False) -> int:
        """Bytes that a process takes for a block that is simplified."""
        return block_memory(faces, refined=refined) + faces * _of_colors(self.colored)

    def last_memory(self, faces: int) -> int:
        """Bytes that the last run takes."""
        return _PROCESS + faces * (_LAST_FACE + _of_colors(self.colored))

    def in_memory(self, target: int) -> bool:
        """Whether enough faces fit into the last run."""
        return _LEAST_LEFT * target <= _ROOM * self.last


def sizes_for(memory: int, block: int | None, *, colored: bool = False) -> Sizes:
    """What fits into this many bytes; where a block's size is given, in multiples of it.

    Raises:
        ValueError: it is too little.
    """
    if block is not None:
        return Sizes(block, _BLOCKS_IN_LAST * block, colored)
    block_face, last_face = (face + _of_colors(colored) for face in (_BLOCK_FACE, _LAST_FACE))
    fits = (memory // _SHARE_OF_BLOCK - _PROCESS) // block_face
    if fits < _LEAST_BLOCK:
        least = -(-_SHARE_OF_BLOCK * (_PROCESS + _LEAST_BLOCK * block_face) // _MIB)
        raise ValueError(f"memory = {memory // _MIB}MiB is too little: at least {least}MiB")
    return Sizes(min(fits, _LARGEST_BLOCK), (memory - 2 * _PROCESS) // last_face, colored)


def _of_colors(colored: bool) -> int:
    return _COLORED_FACE if colored else 0


def block_memory(faces: int, *, refined: bool = False) -> int:
    """Bytes that a process takes for a block, without the colors of one that is simplified."""
    return _PROCESS + faces * (_REFINED_FACE if refined else _BLOCK_FACE)


@dataclass(frozen=True)
class Round:
    """What a round is for."""

    kind: str
    """collapse, or, where the result is refined in blocks, first and second."""
    goal: int
    """Faces that should remain."""


def next_round(faces: int, target: int, sizes: Sizes, done: list[dict[str, Any]]) -> Round | None:
    """The round after those that are done; nothing where the last run follows.

    Raises:
        MeshFileError: the mesh does not get smaller, as seams between blocks hold it.
    """
    stuck = bool(done) and done[-1]["after"] > 0.97 * done[-1]["before"]
    if sizes.in_memory(target) or (faces <= sizes.last and not done):
        if faces <= sizes.last:
            return None
        if stuck:
            raise MeshFileError(
                f"{faces:,} faces are left between seams of blocks, and {sizes.last:,} fit into the memory: "
                "give more by --memory"
            )
        return Round("collapse", int(min(_ROOM * sizes.last, _BEST_LEFT * target)))
    kinds = [row["kind"] for row in done]
    if "second" in kinds:
        return None
    if "first" in kinds:
        return Round("second", target)
    if faces > 4 / 3 * _LEFT_BEFORE_BLOCKS * target and not stuck:
        return Round("collapse", int(_LEFT_BEFORE_BLOCKS * target))
    return Round("first", int(_FIRST_BLOCKS * target))


def held_back(plan: Round, faces: int, seams: int) -> int:
    """The goal of a round with so many seam vertices."""
    kept = plan.goal + _FACES_AT_SEAM * seams if plan.kind == "first" else max(plan.goal, _SEAM_FACES * seams)
    return int(min(kept, _LEAST_PROGRESS * faces)) if plan.kind == "collapse" else min(kept, faces)


def common_cost(pilots: list[dict[str, Any]], sizes: list[int], goal: int) -> float:
    """The cost at which so many faces remain in all blocks together, by the curves of their pilots."""
    curves = []
    for row in pilots:
        if row["curve"]:
            cost, left = np.log(np.array(row["curve"], np.float64)).T
            first = cost[0] - np.log(1e3)  # below that nothing has gone
            curves.append((sizes[row["block"]], np.append(first, cost), np.append(0.0, left)))
    if not curves:
        return 0.0
    at = sum(sizes) - sum(size for size, _, _ in curves)  # of blocks without a curve all stays

    def remaining(cost: float) -> float:
        return float(at + sum(size * np.exp(np.interp(cost, x, y)) for size, x, y in curves))

    return float(np.exp(_solved(remaining, curves, goal)))


def shares(surveys: list[dict[str, Any]], target: int) -> list[int]:
    """Faces that each block keeps, so that they are as many as wanted together, at one cost."""
    curves = []
    for row in surveys:
        cost, faces = np.array(row["curve"] or [[1.0, row["faces"]]], np.float64).T
        cost = np.log(cost)
        curves.append((0, np.append(cost[0] - np.log(1e3), cost), np.append(float(row["faces"]), faces)))

    def remaining(cost: float) -> float:
        return sum(float(np.interp(cost, x, y)) for _, x, y in curves)

    cost = _solved(remaining, curves, target)
    exact = np.array([np.interp(cost, x, y) for _, x, y in curves])
    whole = np.floor(exact).astype(np.int64)
    missing = target - int(whole.sum())
    for block in np.argsort(whole - exact, kind="stable")[: max(missing, 0)]:
        whole[block] += 1
    return [max(int(faces), 1) for faces in whole]


def _solved(remaining: Any, curves: list[Any], goal: int) -> float:
    """The logarithm of the cost at which so many remain."""
    low, high = min(x[0] for _, x, _ in curves), max(x[-1] for _, x, _ in curves)
    for _ in range(100):
        middle = (low + high) / 2
        if remaining(middle) > goal:
            low = middle
        else:
            high = middle
    return float(high)


def common_scale(pilots: list[dict[str, Any]], sizes: list[int]) -> float:
    """The descriptor's scale for all blocks: that above which a fifth of the faces have theirs."""
    rows = sorted((1 / row["scale"], sizes[row["block"]]) for row in pilots if row["scale"] > 0)
    if not rows:
        return 0.0
    up_to = np.cumsum([size for _, size in rows])
    k = int(np.searchsorted(up_to, 0.8 * up_to[-1]))
    return float(1 / rows[min(k, len(rows) - 1)][0])
