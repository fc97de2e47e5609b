# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A part of the corpus through every filter and the core; scripts/hostile does all of it."""

import sys
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from core_runs import core_runs
from host_meshes import fault_of_a_mesh
from host_runs import host_runs
from hostile_meshes import corpus
from mesh_bytes import core_settings
from refusals import fault_of_a_refusal
from settings import settings

from run import jobs_of

PROGRAM = Path(__file__).parents[2] / "build/tests/tests/hostile/hostile_cases"
PARTS = 4

# Prints what it is asked to, as host_process.py does, but for what ends it.
_STAND_IN = """
import os, sys
print("ready", flush=True)
for line in sys.stdin:
    if line.startswith("1 "):
        os.kill(os.getpid(), 11)
    print('["done", "", 0.5]', flush=True)
"""


def test_corpus_is_large_and_the_same_each_time() -> None:
    meshes, again = corpus(), corpus()
    assert len(meshes) >= 250
    assert len({mesh.name for mesh in meshes}) == len(meshes)
    for one, other in zip(meshes, again, strict=True):
        assert one.vertices.tobytes() == other.vertices.tobytes()
        assert one.faces.tobytes() == other.faces.tobytes()
        assert [array.tobytes() for array in one.data.values()] == [array.tobytes() for array in other.data.values()]


@pytest.mark.parametrize("part", range(PARTS))
def test_no_filter_has_a_fault(part: int) -> None:
    meshes = corpus()
    jobs = jobs_of(meshes, len(settings()), every=53, valid_only=True)[part::PARTS]
    assert [run for run in host_runs(meshes, settings(), jobs) if run.kind not in ("done", "refused")] == []


def test_core_has_no_fault() -> None:
    assert PROGRAM.exists(), "scripts/test builds it: cmake --build --preset tests --target hostile_cases"
    meshes = corpus()
    jobs = jobs_of(meshes, len(core_settings()), every=181, valid_only=False)
    assert [run for run in core_runs(PROGRAM, meshes, core_settings(), jobs) if run.kind == "fault"] == []


def test_a_crash_is_named_and_the_next_job_goes_on(tmp_path: Path) -> None:
    stand_in = tmp_path / "process.py"
    stand_in.write_text(_STAND_IN)
    jobs = [(0, 0), (1, 0), (2, 0)]
    runs = list(host_runs(corpus(), settings(), jobs, [sys.executable, str(stand_in)]))
    assert [run.kind for run in runs] == ["done", "fault", "done"]
    assert runs[1].said == "the process ended by SIGSEGV"
    assert runs[1].mesh == corpus()[1].name


def test_what_is_no_result_is_a_fault() -> None:
    points = np.random.default_rng(1).random((4, 3))
    sound = pymeshlab.Mesh(points, np.array([[0, 1, 2], [0, 2, 3]], np.int32))
    assert fault_of_a_mesh(sound, sound) == ""
    more = pymeshlab.Mesh(points, np.array([[0, 1, 2], [0, 2, 3], [0, 1, 3]], np.int32))
    assert fault_of_a_mesh(sound, more) == "3 faces of 2"
    twice = pymeshlab.Mesh(points, np.array([[0, 1, 1]], np.int32))
    assert fault_of_a_mesh(sound, twice) == "faces with a vertex twice"
    infinite = pymeshlab.Mesh(np.where(points == points[0], np.inf, points), np.array([[0, 1, 2]], np.int32))
    assert fault_of_a_mesh(sound, infinite) == "coordinates are no numbers"


def test_a_refusal_names_the_culprit() -> None:
    assert fault_of_a_refusal("Failed to apply filter: x\nDetails: the mesh has no faces (3 vertices)") == ""
    assert fault_of_a_refusal("Failed to apply filter: x\nDetails: Missing Component") != ""
    assert fault_of_a_refusal("") != ""
