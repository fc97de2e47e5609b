# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""avoid_self_intersections: the option everywhere, what is reported, and CGAL's count of what crosses."""

import json
from pathlib import Path

import igl.copyleft.cgal
import numpy as np
import pymeshlab
import pytest
from conftest import run_command

import laplacian_simplify as ls

TARGET = 40
Arrays = tuple[np.ndarray, np.ndarray]


@pytest.fixture(scope="module")
def sheets() -> Arrays:
    """Two sheets so close to each other that coarse faces of one cut through the other."""
    n = 30
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij"))
    corner = np.arange((n + 1) * (n + 1)).reshape(n + 1, n + 1)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
    faces = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    points = np.column_stack([x, y, 3 * np.sin(x / 4) * np.cos(y / 5)])
    return np.vstack([points, np.add(points, [0, 0, 0.1])]), np.vstack([faces, faces + len(points)])


def crossing_pairs(vertices: np.ndarray, faces: np.ndarray) -> int:
    found = igl.copyleft.cgal.remesh_self_intersections(vertices, faces.astype(np.int64), detect_only=True)
    return len(found[2])


@pytest.mark.parametrize("effort", ["fast", "balanced"])
def test_no_faces_cross(effort: str, sheets: Arrays) -> None:
    small = ls.simplify(*sheets, target_faces=TARGET, effort=effort)
    assert crossing_pairs(*sheets) == crossing_pairs(small.vertices, small.faces) == 0
    assert small.report.self_intersections == 0
    assert len(small.faces) <= TARGET
    careless = ls.simplify(*sheets, target_faces=TARGET, effort=effort, avoid_self_intersections=False)
    assert careless.report.self_intersections is None
    assert crossing_pairs(careless.vertices, careless.faces) > 0


def test_both_counts_are_those_of_cgal(sheets: Arrays) -> None:
    vertices, faces = sheets
    crossed = np.vstack([vertices, vertices[:, [0, 2, 1]] + [0, 15, 0]])
    faces = np.vstack([faces, faces + len(vertices)])
    small = ls.simplify(crossed, faces, target_percent=20)
    assert small.report.self_intersections_before == crossing_pairs(crossed, faces)
    assert small.report.self_intersections == crossing_pairs(small.vertices, small.faces)
    assert 0 < small.report.self_intersections <= small.report.self_intersections_before
    assert f"crossings (before: {small.report.self_intersections_before:,})" in str(small.report)


def test_the_command_has_the_option(sheets: Arrays, tmp_path: Path) -> None:
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(*sheets))
    mesh_set.save_current_mesh(str(tmp_path / "in.ply"))
    for options in ([], ["--no-avoid-self-intersections"]):
        report = tmp_path / "report.json"
        done = run_command(
            "simplify", tmp_path / "in.ply", tmp_path / "out.ply", "--faces", str(TARGET), "--json", report, *options
        )
        assert done.returncode == 0, done.stderr
        assert ("0 crossings" in done.stdout) == (not options)
        assert ("self_intersections" in json.loads(report.read_text())) == (not options)
