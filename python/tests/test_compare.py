# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances between any two meshes: surfaces whose distances are known, what is accepted, and the command."""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from array_meshes import UP, mesh_set_of, wave, write_off
from conftest import assert_one_line, run_command

import laplacian_simplify as ls

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
TWO = np.array([[0, 1, 2], [0, 2, 3]])
DIAGONAL = np.sqrt(2)


@pytest.fixture
def squares(tmp_path: Path) -> tuple[Path, Path]:
    """A square, and the same a quarter above it."""
    return write_off(tmp_path / "low.off", SQUARE, TWO), write_off(tmp_path / "high.off", SQUARE + UP, TWO)


def test_parallel_squares_are_as_far_apart_as_they_are() -> None:
    report = ls.compare((SQUARE, TWO), (SQUARE + UP, TWO))
    distance = 100 * 0.25 / DIAGONAL
    for name in ("hausdorff", "rms", "forward_hausdorff", "forward_rms", "forward_mean", "backward_rms"):
        assert getattr(report, name) == pytest.approx(distance, rel=1e-12), name
        assert report.in_units[name] == pytest.approx(0.25, rel=1e-12), name
    assert report.diagonal == pytest.approx(DIAGONAL, rel=1e-15)
    assert (report.faces_a, report.vertices_a) == (2, 4)
    assert report.feature_rms is None  # a plane has none
    assert "feature_rms" not in report.in_units


def test_a_part_of_a_surface_is_close_one_way_only() -> None:
    """And percent are of the first one's box, whichever is larger."""
    wide = np.concatenate([SQUARE, [[3.0, 0, 0], [3, 1, 0]]]), np.concatenate([TWO, [[1, 4, 5], [1, 5, 2]]])
    report = ls.compare((SQUARE, TWO), wide)
    assert report.forward_hausdorff == pytest.approx(0, abs=1e-12)
    assert report.in_units["backward_hausdorff"] == pytest.approx(2)
    assert report.hausdorff == pytest.approx(100 * 2 / DIAGONAL)
    back = ls.compare(wide, (SQUARE, TWO))
    assert back.in_units["forward_hausdorff"] == pytest.approx(2)
    assert back.hausdorff == pytest.approx(100 * 2 / np.sqrt(10))


def test_a_tilted_plane_has_the_rms_of_the_integral_within_the_error_that_is_stated() -> None:
    """From the square to a plane z = x / 4 that is wide enough the distance is |x| sin(angle)."""
    wide = (SQUARE - [0.5, 0.5, 0]) * 9
    plane = wide + np.array([0, 0, 0.25]) * wide[:, :1]
    report = ls.compare((SQUARE, TWO), (plane, TWO), samples=1000)
    expected = np.sin(np.arctan(0.25)) / np.sqrt(3)
    found = report.in_units["forward_rms"]
    assert found == pytest.approx(expected, rel=1e-3)  # points of low discrepancy: far better than 1 / sqrt(1000)
    assert report.in_units["forward_hausdorff"] == pytest.approx(np.sin(np.arctan(0.25)), rel=1e-12)  # at vertices
    larger = 81 * np.sqrt(1 + 1 / 16)  # the area
    assert report.in_units["spacing"] == pytest.approx(np.sqrt(larger / 1000), rel=1e-9)


def test_the_error_of_the_rms_is_that_of_random_points() -> None:
    """From a square to the same with a step of height 1 at half of it: squares are 0 or 1, half of each; s = 1 / 2."""
    from laplacian_simplify.comparison.distances import Distances, OneWay

    way = OneWay(np.repeat([0.0, 1.0], 50), np.zeros(1), 1.0)
    found = Distances(way, way, None)
    mean_square_error = 0.5 / 10  # of one direction
    assert found.rms == pytest.approx(np.sqrt(0.5))
    assert found.rms_error == pytest.approx(mean_square_error / np.sqrt(2) / (2 * np.sqrt(0.5)))


def test_a_vertex_between_all_samples_counts() -> None:
    """A needle over a square: hardly any area, and far away."""
    needle = np.concatenate([SQUARE, [[0.5, 0.5, 2], [0.5 + 1e-9, 0.5, 0]]])
    report = ls.compare((needle, np.concatenate([TWO, [[0, 4, 5]]])), (SQUARE, TWO), samples=10)
    assert report.in_units["forward_hausdorff"] == pytest.approx(2)


def test_numbers_are_those_that_simplify_reports() -> None:
    vertices, faces = wave()
    small = ls.simplify(vertices, faces, target_percent=10)
    report = ls.compare((vertices, faces), small)
    # All features, in another order of the sums; the others by other samples: three standard errors of 1 %.
    for name, error in (("hausdorff", 0.03), ("rms", 0.03), ("feature_rms", 1e-9)):
        assert getattr(report, name) == pytest.approx(getattr(small.report, name), rel=error), name


def test_every_kind_of_mesh_is_accepted(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    vertices, faces = wave(8)
    other = vertices + UP, faces
    small = ls.simplify(vertices, faces, target_percent=50)
    mesh_set = mesh_set_of(vertices, faces)
    kinds = [
        (vertices, faces.astype(np.int32)),
        [vertices.astype(np.float32).astype(np.float64), faces],
        write_off(tmp_path / "wave.off", vertices, faces),
        str(tmp_path / "wave.off"),
        mesh_set,
        mesh_set.current_mesh(),
        trimesh.Trimesh(vertices, faces, process=False),
    ]
    expected = ls.compare((vertices, faces), other).rms
    for mesh in kinds:
        assert ls.compare(mesh, other).rms == pytest.approx(expected, rel=1e-6)
    assert ls.compare(small, (small.vertices, small.faces)).hausdorff == pytest.approx(0, abs=1e-12)


def test_files_need_no_pymeshlab(squares: tuple[Path, Path]) -> None:
    program = (
        "import sys; sys.modules['pymeshlab'] = None; import laplacian_simplify as ls; "
        "print(f\"{ls.compare(sys.argv[1], sys.argv[2]).in_units['rms']:.9f}\")"
    )
    words = [sys.executable, "-P", "-c", program, *map(str, squares)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "0.250000000\n"), done.stderr


@pytest.mark.parametrize(
    ("mesh", "error", "text"),
    [
        ((SQUARE, TWO[:0]), ValueError, "A has no faces"),
        ((SQUARE, TWO + 2), ValueError, "A has a face with the vertex 5, which is outside 0..3"),
        ((SQUARE, TWO - 1), ValueError, "A has a face with the vertex -1, which is outside 0..3"),
        ((SQUARE * np.nan, TWO), ValueError, "A has coordinates that are not finite numbers up to 1e+18 at 4 of 4"),
        ((SQUARE * 1e19, TWO), ValueError, "A has coordinates that are not finite numbers up to 1e+18 at 3 of 4"),
        ((SQUARE * 1e-150, TWO), ValueError, "A has a bounding box with a diagonal of 1.41e-150, which is too small"),
        ((SQUARE * 0 + 1, TWO), ValueError, "A has all its faces in one point"),
        ((SQUARE[:, :2], TWO), ValueError, "the vertices of A have the shape (4, 2), not (n, 3)"),
        ((SQUARE.tolist(), TWO), TypeError, "the vertices of A must be a NumPy array of numbers, not list"),
        ((SQUARE, TWO * 1.0), TypeError, "the faces of A must be a NumPy array of integers, not ndarray"),
        (3, TypeError, "int cannot be compared; accepted are two NumPy arrays"),
        (pymeshlab.MeshSet(), ValueError, "A is a mesh set without a mesh"),
    ],
)
def test_what_is_no_surface_is_refused_with_the_reason(mesh: object, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=re.escape(text)):
        ls.compare(mesh, (SQUARE, TWO))


def test_a_loose_vertex_is_no_part_of_a_surface() -> None:
    loose = np.concatenate([SQUARE, [[np.nan, 0, 0]], [[9.0, 9, 9]]])
    report = ls.compare((loose, TWO), (SQUARE, TWO))
    assert report.hausdorff == pytest.approx(0, abs=1e-12)
    assert report.diagonal == pytest.approx(DIAGONAL)


@pytest.mark.parametrize("samples", [0, -5, 2 * 10**9])
def test_numbers_of_samples_have_a_range(samples: int) -> None:
    with pytest.raises(ValueError, match=r"samples = .* is outside"):
        ls.compare((SQUARE, TWO), (SQUARE, TWO), samples=samples)


@pytest.mark.parametrize("threads", [-1, 1025, 99999999999])
def test_numbers_of_threads_have_a_range(threads: int) -> None:
    with pytest.raises(ValueError, match=rf"threads = {threads:,} is outside \[0, 1,024\]"):
        ls.compare((SQUARE, TWO), (SQUARE, TWO), threads=threads)


@pytest.mark.parametrize("name", ["samples", "threads"])
def test_numbers_that_are_not_whole_are_refused(name: str) -> None:
    with pytest.raises(TypeError, match=f"{name} must be a whole number, not float"):
        ls.compare((SQUARE, TWO), (SQUARE, TWO), **{name: 1.5})
    ls.compare((SQUARE, TWO), (SQUARE, TWO), **{name: np.int64(2)})


def test_the_report_can_be_printed_and_kept() -> None:
    import pickle

    report = ls.compare((SQUARE, TWO), (SQUARE + UP, TWO))
    assert pickle.loads(pickle.dumps(report)) == report
    assert "length    rms 0.25, largest 0.25; the diagonal is 1.41421" in str(report)
    assert json.loads(report.to_json())["in_units"]["rms"] == pytest.approx(0.25)


def test_the_command_shows_and_writes_the_same(squares: tuple[Path, Path], tmp_path: Path) -> None:
    target = tmp_path / "report.json"
    done = run_command("compare", *squares, "--json", target, "--samples", 500)
    assert done.returncode == 0, done.stderr
    assert f"{squares[0]} | {squares[1]} in " in done.stdout
    assert "length    rms 0.25, largest 0.25; the diagonal is 1.41421\n" in done.stdout
    assert "at 500 points a side" in done.stdout
    report = json.loads(target.read_text())
    assert report["in_units"]["rms"] == pytest.approx(0.25)
    assert report["input"] == [str(squares[0]), str(squares[1])]
    assert report["parameters"] == {"samples": 500}
    assert report["units"]["rms"].startswith("% of the bounding box")
    assert report["version"] == ls.__version__
    quiet = run_command("compare", *squares, "--json", "-", "--quiet")
    assert json.loads(quiet.stdout)["hausdorff"] == report["hausdorff"]
    assert quiet.stderr == ""


@pytest.mark.parametrize(
    ("arguments", "code", "text"),
    [
        (["missing.off", "low.off"], 1, "missing.off"),
        (["low.off", "empty.off"], 1, "empty.off has no faces; it cannot be compared"),
        (["low.off", "high.off", "--samples", "0"], 2, "--samples 0 is outside [1, 1,000,000,000]"),
        (["low.off", "high.off", "--json", "low.off"], 2, "--json low.off is the file of A, which it would replace"),
        (["-", "-"], 2, "A and B are both -"),
    ],
)
def test_the_command_refuses_in_one_line(
    squares: tuple[Path, Path], tmp_path: Path, arguments: list[str], code: int, text: str
) -> None:
    before = squares[0].read_bytes()
    write_off(tmp_path / "empty.off", SQUARE, TWO[:0])
    done = run_command("compare", *arguments, cwd=tmp_path)
    assert done.returncode == code, done.stderr
    assert_one_line(done.stderr)
    assert text in done.stderr
    assert squares[0].read_bytes() == before
