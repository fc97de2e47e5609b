# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory that a run takes beside the caller's arrays: the lists that there are at a time, and what they sum up to."""

import re
import subprocess
import sys
from math import ceil
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "docs" / "guarantees.md"

# Bytes a face; a closed surface has half as many vertices as faces. Lists of the faces of a vertex have 4 bytes a
# corner, and room for those that a sweep makes: CornerArena::PoolSize.
POOL = 3 * 4 * 15 / 7
# Of a face of the input, while edges collapse.
COLLAPSE = {
    "records of vertices and faces": 80 / 2 + 32,
    "two pools of corners": 2 * POOL,
    "first corner, number, key, descriptor, input vertex and flags of a vertex": 21 / 2,
    "descriptor for the measurement, order of the faces, new places of the vertices": 4 / 2 + 4 + 4 / 2,
}
# With a refinement the input is kept.
KEPT = {
    "points, flags, first corner and number of a vertex, triangles": 25 / 2 + 12,
    "a third pool": POOL,
    "whom a vertex was merged into, twice": 8 / 2,
}
REFINEMENT = {
    **KEPT,
    "descriptor and order of the faces": 4 / 2 + 4,
    "the records are gone, and one of the lists of who was merged": -4 / 2,
    "three samples a face: vertices, centroids and midpoints": 3 * 32,
}
# Of a face that is left, while edges collapse.
RESULT = {"points, flags, input vertices; triangles and their input": 21 / 2 + 16}
RESULT_TO_REFINE = {**RESULT, "first corner and number of a vertex, corners": 8 / 2 + 12}
REFINED = {
    **RESULT_TO_REFINE,
    "places that were closest to vertices, centroids and edges": 4 / 2 + 4 + 3 * 4,
    "lists of samples": 16,
}
BY_BALANCED = {**REFINED, "room for flips": 3 * 4 / 2, "as it was before": 17 / 2 + 12}
BY_BEST = {
    **REFINED,
    "room for exchanges": 8 * 4 / 2,
    "marks and distances of a vertex": 10 / 2,
    "quadrics": 24 / 2,
    "guesses at 1.5 edges, collapse and division, and all of them in one list": 1.5 * 12 * 2 * 2,
}


def _sum(*lists: dict[str, float]) -> float:
    return sum(sum(of.values()) for of in lists)


def _line(*stages: tuple[float, float]) -> tuple[int, int]:
    """The least line, of a + b x share left, that is nowhere below one of the stages."""
    at_zero, at_one = max(a for a, _ in stages), max(a + b for a, b in stages)
    return ceil(at_zero), ceil(at_one - at_zero)


BOUNDS = {
    "fast": _line((_sum(COLLAPSE), _sum(RESULT))),
    "balanced": _line((_sum(COLLAPSE, KEPT), _sum(RESULT_TO_REFINE)), (_sum(REFINEMENT), _sum(BY_BALANCED))),
    "best": _line((_sum(COLLAPSE, KEPT), _sum(RESULT_TO_REFINE)), (_sum(REFINEMENT), _sum(BY_BEST))),
}

# A wavy sheet; a small one first, so that the program's own pages are there already.
PEAK = """
import ctypes
import sys
from pathlib import Path
import numpy as np
import laplacian_simplify as ls

def status(name):
    return 1024 * int(Path("/proc/self/status").read_text().partition(name + ":")[2].split()[0])

def sheet(side):
    x, y = np.meshgrid(*2 * [np.arange(side + 1, dtype=np.float32)], indexing="ij")
    z = 3 * np.sin(0.05 * x) * np.cos(0.07 * y) + 0.3 * np.sin(1.1 * x + 0.5 * y)
    index = np.arange((side + 1) ** 2, dtype=np.int32).reshape(side + 1, side + 1)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return np.stack([x, y, z], axis=-1).reshape(-1, 3), faces

effort, percent, side, THREADS = sys.argv[1], float(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
ls.simplify(*sheet(40), effort=effort, target_percent=percent, threads=THREADS)
vertices, faces = sheet(side)
ctypes.CDLL(None).malloc_trim(0)  # what is free already may not be used unseen
Path("/proc/self/clear_refs").write_text("5")  # forgets the peak
before = status("VmRSS")
ls.simplify(vertices, faces, effort=effort, target_percent=percent, threads=THREADS)
print(len(faces), status("VmHWM") - before)
"""
MILLION = 708  # squares along a side
THREADS = 2
PROGRAM = 4 << 20


@pytest.mark.parametrize("effort", BOUNDS)
def test_the_page_says_what_the_lists_sum_up_to(effort: str) -> None:
    found = re.search(rf"^\| {effort} \| (\d+) \| (\d+) \|$", PAGE.read_text(), re.MULTILINE)
    assert found
    assert tuple(map(int, found.groups())) == BOUNDS[effort]


@pytest.mark.parametrize(
    ("effort", "percent", "side"),
    [("fast", 10, MILLION), ("balanced", 90, MILLION), ("best", 10, MILLION), ("best", 90, 350)],
)
def test_a_run_takes_no_more_memory_than_its_lists(effort: str, percent: int, side: int) -> None:
    """Best is also tried where it takes most, on a quarter of a million faces: a million take half a minute."""
    words = [sys.executable, "-P", "-c", PEAK, effort, str(percent), str(side), str(THREADS)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=600, check=True)
    faces, used = map(int, done.stdout.split())
    of_input, of_result = BOUNDS[effort]
    bound = faces * (of_input + (of_result + 4 * THREADS) * percent / 100)
    assert used <= bound + PROGRAM, f"{used / faces:.1f} bytes a face"
    assert used > 0.7 * bound, f"{used / faces:.1f} bytes a face: the bound is not true to the lists"
