# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error bound in Python and in the command."""

import json
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from conftest import SAMPLE_MESHES, positions_and_faces, run_command

import laplacian_simplify as ls

FLANGE = SAMPLE_MESHES / "flange.ply"


def diagonal(mesh_set: pymeshlab.MeshSet) -> float:
    positions, faces = positions_and_faces(mesh_set)
    return float(np.linalg.norm(np.ptp(positions[np.unique(faces)], axis=0)))


def largest_distance(original: pymeshlab.MeshSet, result: pymeshlab.MeshSet) -> float:
    """By the host's own filter, both ways, in percent of the original's diagonal."""
    both = pymeshlab.MeshSet()
    for mesh_set in (original, result):
        both.add_mesh(pymeshlab.Mesh(*positions_and_faces(mesh_set)))
    ways = [
        both.get_hausdorff_distance(
            sampledmesh=a, targetmesh=1 - a, samplenum=200_000, maxdist=pymeshlab.PercentageValue(100)
        )
        for a in (0, 1)
    ]
    return 100 * max(way["max"] for way in ways) / diagonal(original)


@pytest.mark.parametrize("effort", ["fast", "balanced"])
@pytest.mark.parametrize("bound", [0.5, 0.05])
def test_bound_alone(effort: str, bound: float, load_sample) -> None:
    """As few faces as the bound allows; a tool that shares no code with the filter finds no point beyond it."""
    mesh_set = load_sample("flange.ply")
    report = ls.simplify(mesh_set, max_error=bound, effort=effort)
    assert report.stop_reason_text == "error bound reached"
    assert 0.5 * bound < report.certified_error <= bound
    assert report.faces < report.faces_before / 4
    # a millionth for the coordinates in which the host measures
    assert largest_distance(load_sample("flange.ply"), mesh_set) <= report.certified_error * 1.000001
    assert report.hausdorff <= report.certified_error * 1.000001


def test_bound_with_a_target(load_sample) -> None:
    report = ls.simplify(load_sample("flange.ply"), max_error=5, target_percent=50)
    assert report.target_reached
    assert report.certified_error <= 5


def test_no_bound(load_sample) -> None:
    assert ls.simplify(load_sample("flange.ply"), target_percent=50).certified_error is None


def test_every_effort_keeps_a_bound(load_sample) -> None:
    for effort in ("fast", "balanced", "best"):
        report = ls.simplify(load_sample("flange.ply"), max_error=0.2, effort=effort)
        assert report.certified_error <= 0.2


def test_only_sweeps_keep_a_bound(load_sample) -> None:
    with pytest.raises(ValueError, match="max_error = 1 needs order sweeps") as refusal:
        ls.simplify(load_sample("flange.ply"), max_error=1, order="strict")
    assert "\n" not in str(refusal.value)


def test_percent_and_length_are_the_same(tmp_path: Path, load_sample) -> None:
    """--max-error 0.2% and the same as a length in the mesh's own units."""
    length = 0.002 * diagonal(load_sample("flange.ply"))
    faces = []
    for text in ("0.2%", f"{length!r}"):
        report = tmp_path / "report.json"
        done = run_command("simplify", FLANGE, tmp_path / "small.ply", "--max-error", text, "--json", report)
        assert done.returncode == 0, done.stderr
        assert "proven    within 0." in done.stdout
        numbers = json.loads(report.read_text())
        assert 0.1 < numbers["certified_error"] <= 0.2 * (1 + 1e-12)
        faces.append(numbers["faces"])
    assert faces[0] == faces[1]


def test_arrays_have_the_same_bound(load_sample) -> None:
    mesh_set = load_sample("flange.ply")
    vertices, faces = positions_and_faces(mesh_set)
    small = ls.simplify(vertices, faces, max_error=0.5)
    report = ls.simplify(mesh_set, max_error=0.5)
    assert small.report.certified_error == report.certified_error
    assert small.report.stop_reason == report.stop_reason == ls.StopReason.ERROR_BOUND
    assert len(small.faces) == report.faces
    with pytest.raises(ValueError, match="max_error"):
        ls.simplify(vertices, faces, max_error=101)
