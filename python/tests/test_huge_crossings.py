# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that cross in huge meshes: the guard within a block, and what is said of those that nobody has counted."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from array_meshes import wave
from huge_meshes import torus, write_ply

import laplacian_simplify as ls

pytest.importorskip("distributed")

from laplacian_simplify.huge.array_file import ArrayFile, save_arrays
from laplacian_simplify.huge.collapse import Engine, Wanted, collapse
from laplacian_simplify.huge.grid import SIDE, Grid, Layout
from laplacian_simplify.huge.rounds import Simplified
from laplacian_simplify.huge.runs import _crossings, _Run


def test_no_more_faces_of_a_block_cross_than_before(tmp_path: Path) -> None:
    """Two waves close to each other, which cross where nobody sees to it."""
    vertices, faces = wave(60)
    both = np.concatenate([vertices, vertices + np.array([0, 0, 0.005])])
    triangles = np.concatenate([faces, faces + len(vertices)]).astype(np.uint32)
    arrays = {"ids": np.arange(len(both)), "positions": both, "triangles": triangles, "foreign": np.empty(0, np.int64)}
    save_arrays(tmp_path / "both.block", arrays)
    Layout.save(tmp_path / "0.layout", [np.zeros(SIDE**3, np.int32)], [np.zeros(SIDE**3, np.int32)])
    parts = [["both.block", 0, len(both), 0, len(triangles), 0, 0]]
    grid = Grid.around(both.min(axis=0).tolist(), both.max(axis=0).tolist())
    found = {}
    for avoid in (True, False):
        wanted = Wanted(target=600, avoid_crossings=avoid)
        answer = collapse(tmp_path, 0, parts, grid, "0.layout", Engine(2, 1, 0), wanted, "both", "out.block")
        out = ArrayFile(tmp_path / "out.block")
        counted = ls.simplify(out.read("positions"), out.read("triangles"), target_percent=99, threads=1).report
        found[avoid] = counted.self_intersections
        assert answer["self_intersections"] == (0 if avoid else None)
    assert found[True] == 0 < found[False]


def test_a_report_says_which_crossings_nobody_has_counted() -> None:
    def doubts(rounds: int, crossings: int | None, *, avoid: bool = True) -> list[str]:
        report = None if crossings is None else {"self_intersections": crossings}
        aim = SimpleNamespace(avoid_crossings=avoid)
        return _Run(SimpleNamespace(chunk_faces=1), None, None, aim)._doubts(Simplified([], [{}] * rounds, report))

    assert doubts(1, 0) == doubts(0, 3) == doubts(1, None, avoid=False) == []
    unknown = SimpleNamespace(avoid_crossings=True)
    run = _Run(SimpleNamespace(chunk_faces=1), None, None, unknown)
    assert run._doubts(Simplified([], [{}], {})) == ["the faces of the result that cross were not counted"]
    assert doubts(1, 3) == ["3 pairs of faces cross; how many did in the input was not counted"]
    assert "faces of different blocks may cross" in doubts(2, None)[0]


def test_a_block_of_a_stray_face_is_no_trouble(tmp_path: Path) -> None:
    """It is small enough as it is, so nobody counts what crosses in it."""
    vertices, faces = torus(60, 40)
    stray = np.array([[100.0, 0, 0], [100, 1, 0], [100, 0, 1]])
    both = np.concatenate([0.002 * vertices, stray])
    write_ply(tmp_path / "both.ply", both, np.concatenate([faces, [np.arange(3) + len(vertices)]]))
    report = ls.simplify_huge(tmp_path / "both.ply", tmp_path / "small.ply", target_percent=4, block_faces=1000)
    assert report.faces <= 0.04 * (len(faces) + 1) + 1
    assert report.rounds[0]["self_intersections"] is None


def test_what_crossed_in_what_was_left_is_not_said_of_the_input() -> None:
    found = {"self_intersections": 3, "self_intersections_before": 2}
    assert _crossings(Simplified([], [], found)) == found
    assert _crossings(Simplified([], [{}], found)) == {"self_intersections": 3}
    assert _crossings(Simplified([], [{}, {}], None)) == {}
