# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of detail: the function, and the command with a file for every level."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from conftest import SAMPLE_MESHES, assert_one_line, faces_in, non_manifold_edges, positions_and_faces, run_command

import laplacian_simplify as ls

BOX = SAMPLE_MESHES / "painted_box.obj"
FAST = {"effort": "fast", "measure_error": False}
QUICK = ("--effort", "fast", "--no-measure-error")


def test_levels_are_new_meshes_of_the_set(load_sample) -> None:
    mesh_set = load_sample("flange.ply")
    before = positions_and_faces(mesh_set)
    mesh_set.current_mesh().set_label("part")
    levels = ls.levels_of_detail(mesh_set, percents=[40, 12.5])
    assert mesh_set.mesh_number() == 3
    for level, percent in zip(levels, (40, 12.5), strict=True):
        assert level.mesh_set is mesh_set
        assert level.target_reached
        assert level.rms is not None
        mesh_set.set_current_mesh(level.mesh_id)
        assert mesh_set.current_mesh().label() == f"part {percent:g}%"
        assert mesh_set.current_mesh().is_visible() == (percent == 12.5)  # the last one is shown
        positions, faces = positions_and_faces(mesh_set)
        assert (level.faces, level.vertices) == (len(faces), len(positions))
        assert level.faces == pytest.approx(percent / 100 * len(before[1]), abs=2)
        assert level.non_manifold_edges == non_manifold_edges(faces) == 0
    assert levels[0].rms < levels[1].rms
    mesh_set.set_current_mesh(0)
    for kept, was in zip(positions_and_faces(mesh_set), before, strict=True):
        assert np.array_equal(kept, was)


@pytest.mark.parametrize("effort", ["fast", "balanced"])
def test_the_first_level_is_the_single_run(effort: str, load_sample) -> None:
    chain, single = load_sample("relief_scan.ply"), load_sample("relief_scan.ply")
    options = {"effort": effort, "measure_error": False}
    level = ls.levels_of_detail(chain, percents="30,10", **options)[0]
    chain.set_current_mesh(level.mesh_id)
    ls.simplify(single, target_percent=30, **options)
    for one, other in zip(positions_and_faces(chain), positions_and_faces(single), strict=True):
        assert np.array_equal(one, other)


def test_levels_by_error_are_certified(load_sample) -> None:
    mesh_set = load_sample("painted_box.obj")
    levels = ls.levels_of_detail(mesh_set, max_errors=[0.2, 1])
    for level, bound in zip(levels, (0.2, 1), strict=True):
        assert level.stop_reason is ls.StopReason.ERROR_BOUND
        assert level.certified_error is not None
        assert level.hausdorff is not None
        assert level.hausdorff <= level.certified_error <= bound
    assert levels[1].faces < levels[0].faces
    mesh_set.set_current_mesh(levels[1].mesh_id)
    assert mesh_set.current_mesh().label() == "painted_box error 1%.obj"  # MeshLab lists it without the ending


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"percents": "50,x,10"}, r'percents = "50,x,10": "x" is not a number in \(0, 100\]'),
        ({"percents": [50, 0]}, r'"0.0" is not a number|percents = 0 is outside \(0, 100\]'),
        ({"percents": "50,200"}, '"200" is not a number in'),
        ({"percents": "50,,10"}, '"" is not a number in'),
        ({"percents": ""}, "percents = .* has no level"),
        ({"percents": "10,50"}, "percents = 50 comes after 10: the finest level is the first"),
        ({"max_errors": "0.5,0.1"}, "max_errors = 0.1 comes after 0.5"),
        ({"max_errors": "0.5", "max_error": 1.0}, "are two bounds"),
        ({"max_errors": "0.5", "order": "strict"}, "needs order sweeps"),
    ],
)
def test_bad_levels_are_refused_by_name(values, said: str, load_sample) -> None:
    mesh_set = load_sample("painted_box.obj")
    with pytest.raises(ValueError, match=said):
        ls.levels_of_detail(mesh_set, **values)
    assert mesh_set.mesh_number() == 1


def test_a_list_of_arrays_is_no_mesh_source() -> None:
    with pytest.raises(TypeError, match=r"must be a pymeshlab\.MeshSet or the path of a mesh file"):
        ls.levels_of_detail(np.zeros((3, 3)))


def test_the_command_writes_a_file_for_every_level(tmp_path: Path) -> None:
    report = tmp_path / "report.json"
    words = ("--percents", "50,25", "--json", report, *QUICK)
    done = run_command("lod", BOX, tmp_path / "out_{percent}_{level}.ply", *words)
    assert done.returncode == 0, done.stderr
    levels = json.loads(report.read_text())
    assert len(levels) == 2
    for name, level in zip(("out_50_1.ply", "out_25_2.ply"), levels, strict=True):
        assert faces_in(tmp_path / name) == level["faces"]
        assert level["stop_reason_text"] == "target reached"
        assert name in done.stdout
    assert len(list(tmp_path.glob("*.ply"))) == 2
    again = tmp_path / "again"
    again.mkdir()
    run_command("lod", BOX, again / "out_{percent}_{level}.ply", "--percents", "50,25", *QUICK, "--threads", "1")
    for file in tmp_path.glob("*.ply"):
        assert (again / file.name).read_bytes() == file.read_bytes()


def test_errors_are_percent_or_lengths(tmp_path: Path) -> None:
    """The box has a diagonal; the same bound in both ways gives the same file."""
    mesh_set = ls.read_mesh(BOX)  # the mesh lives as long as it
    vertices = mesh_set.current_mesh().vertex_matrix()
    length = math.dist(vertices.max(axis=0), vertices.min(axis=0)) / 100
    report = tmp_path / "report.json"
    for words in ("1%", repr(length)):
        more = ("--max-errors", words, "--effort", "fast", "--json", report)
        done = run_command("lod", BOX, tmp_path / "{level}_{error}.ply", *more)
        assert done.returncode == 0, done.stderr
        (level,) = json.loads(report.read_text())
        assert "max_errors" in level["parameters"]
        assert "percents" not in level["parameters"]  # their default has no part in it
    assert (tmp_path / "1_1%.ply").read_bytes() == (tmp_path / f"1_{length!r}.ply").read_bytes()


@pytest.mark.parametrize(
    ("output", "words", "code", "said"),
    [
        ("out.ply", ("--percents", "50,25"), 2, "levels 1 and 2 have the same file"),
        ("out_{error}.ply", ("--percents", "50,25"), 2, "OUTPUT has {error}; here it can have {percent} and {level}"),
        ("out_{x}.ply", ("--percents", "50"), 2, "OUTPUT has {x}"),
        ("out_{percent}.ply", ("--percents", "50,x"), 2, '--percents "50,x": "x" is not a number in (0, 100]'),
        ("out_{error}.ply", ("--max-errors", "1%,x"), 2, '--max-errors "1%,x": "x" is neither'),
        ("out_{percent}.ply", ("--percents", "25,50"), 2, "50 comes after 25"),
        ("out_{percent}.ply", (), 2, "--percents --max-errors is required"),
        ("out_{percent}.txt", ("--percents", "50"), 1, "the format '.txt' is unknown"),
        ("none/out_{percent}.ply", ("--percents", "50"), 1, "is not a folder"),
    ],
)
def test_wrong_words_write_nothing(output: str, words: tuple[str, ...], code: int, said: str, tmp_path: Path) -> None:
    done = run_command("lod", BOX, tmp_path / output, *words)
    assert done.returncode == code, done.stderr
    assert_one_line(done.stderr)
    assert said in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_no_level_appears_where_one_cannot_be_written(tmp_path: Path) -> None:
    """The file of the last level is a folder, which is found before the work."""
    (tmp_path / "out_25.ply").mkdir()
    done = run_command("lod", BOX, tmp_path / "out_{percent}.ply", "--percents", "50,25", *QUICK)
    assert done.returncode == 1
    assert "is a folder" in done.stderr
    assert [file.name for file in tmp_path.iterdir()] == ["out_25.ply"]
