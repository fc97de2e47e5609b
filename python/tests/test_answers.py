# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a missed target and a small percentage are answered with, and options of the command for shells."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from array_meshes import wave
from conftest import SAMPLE_MESHES, assert_one_line, faces_in, run_command

import laplacian_simplify as ls
from laplacian_simplify.answers import fraction_note
from laplacian_simplify.options import as_option, commands
from laplacian_simplify.tables import filter_named

FLANGE, SHEET = SAMPLE_MESHES / "flange.ply", SAMPLE_MESHES / "folded_sheet.ply"


def soup() -> tuple[np.ndarray, np.ndarray]:
    vertices, faces = wave()
    return vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)


def test_open_edges_say_what_to_weld() -> None:
    apart = ls.simplify(*soup(), target_percent=10, clean_input=False).report
    assert apart.faces == 1682
    assert (
        "target NOT reached: 5,046 of 5,046 edges are open: the faces share no vertices; weld first (clean_input=True)"
    ) in str(apart)
    vertices, faces = soup()
    near = np.add(vertices, np.random.default_rng(1).uniform(-1e-6, 1e-6, vertices.shape))
    assert "weld first (weld_distance=0.01)" in str(ls.simplify(near, faces, target_percent=10).report)
    assert ls.simplify(near, faces, target_percent=10, weld_distance=0.01).report.target_reached


def test_borders_that_hold_are_named() -> None:
    report = ls.simplify(*wave(), target_faces=1, boundary="lock").report
    assert "target NOT reached: no further collapse possible without damage (116 open edges hold most faces; " in str(
        report
    )
    assert "boundary='free' lets borders shrink" in str(report)
    assert "NOT" not in str(ls.simplify(*wave(), max_error=0.1).report)


@pytest.mark.parametrize("percent", [0.5, 0.99, np.float32(0.25)])
def test_a_percentage_below_1_is_read_both_ways(percent: float) -> None:
    with pytest.warns(UserWarning, match="keeps 0.* % of the faces, one of") as caught:
        ls.simplify(*wave(), target_percent=percent)
    assert Path(caught[0].filename).name == "test_answers.py"
    with pytest.warns(UserWarning, match=r"target_percent=0\.5 keeps 0\.5 % of the faces, one of 200; to keep the "
                                         r"fraction 0\.5 of them, give target_percent=50\.0"):  # fmt: skip
        ls.simplify(*wave(), target_percent=0.5)


@pytest.mark.filterwarnings("error")
def test_other_percentages_warn_of_nothing() -> None:
    ls.simplify(*wave(), target_percent=1)
    assert fraction_note(0) is None
    assert fraction_note(100) is None


def test_the_command_reads_it_both_ways(tmp_path: Path) -> None:
    done = run_command("simplify", FLANGE, tmp_path / "small.ply", "--percent", 0.5)
    assert done.returncode == 0
    assert_one_line(done.stderr)
    assert "warning: --percent 0.5 keeps 0.5 % of the faces, one of 200; " in done.stderr
    assert "give --percent 50\n" in done.stderr


def test_a_target_that_has_to_be_reached(tmp_path: Path) -> None:
    words = ("simplify", SHEET, tmp_path / "small.ply", "--faces", 1, "--boundary", "lock")
    done = run_command(*words, "--strict", "--json", tmp_path / "report.json")
    assert done.returncode == 4
    assert_one_line(done.stderr)
    assert "folded_sheet.ply: target not reached: no further collapse possible without damage" in done.stderr
    assert "--boundary free" in done.stderr
    assert list(tmp_path.iterdir()) == []
    assert run_command(*words).returncode == 0
    within = ("simplify", SHEET, tmp_path / "within.ply", "--faces", 1, "--max-error", "0.1%", "--strict")
    assert run_command(*within).returncode == 0  # it went as far as it was allowed to


def test_quiet(tmp_path: Path) -> None:
    done = run_command("simplify", FLANGE, tmp_path / "small.ply", "--percent", 10, "-q")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert faces_in(tmp_path / "small.ply") <= 2368
    loud = run_command("simplify", FLANGE, tmp_path / "tiny.ply", "--percent", 0.5, "--quiet")
    assert_one_line(loud.stderr)  # warnings stay


def test_the_json_holds_what_is_needed_to_do_it_again(tmp_path: Path) -> None:
    report = tmp_path / "report.json"
    words = ("--percent", 10, "--boundary", "lock", "--no-measure-error", "--json", report)
    assert run_command("simplify", FLANGE, "small.ply", *words, cwd=tmp_path).returncode == 0
    found = json.loads(report.read_text())
    assert found["input"] == str(FLANGE)
    assert found["output"] == "small.ply"
    assert found["version"] == ls.__version__
    row = filter_named("meshing_decimation_laplacian_quadric_edge_collapse")
    given = found["parameters"]
    assert given["target_percent"] == 10
    assert given["boundary"] == "lock"
    assert given["measure_error"] is False
    assert given["feature_weight"] == row.parameter("feature_weight").default
    assert "target_faces" not in given
    for parameter in row.parameters:
        if parameter.id in given:
            parameter.number(given[parameter.id])
    units = {result.id: result.unit for result in row.results if result.unit}
    assert found["units"] == {name: unit for name, unit in units.items() if name in found}
    assert found["units"]["faces"] == "faces"


def test_the_json_of_a_length(tmp_path: Path) -> None:
    words = ("--max-error", 0.05, "--json", "-")
    done = run_command("simplify", SHEET, tmp_path / "small.ply", *words)
    assert json.loads(done.stdout)["parameters"]["max_error_length"] == 0.05


def test_ranges_speak_of_options() -> None:
    assert as_option("target_faces") == "--faces"
    assert as_option("weld_distance", 0.01) == "--weld-distance 0.01"
    assert as_option("clean_input", True) == "--clean-input"
    assert as_option("clean_input", False) == "--no-clean-input"
    done = run_command("simplify", FLANGE, "out.ply", "--percent", 10, "--weld-distance", 101)
    assert done.returncode == 2
    assert "--weld-distance 101 is outside [0, 100]" in done.stderr


@pytest.mark.parametrize("name", [*(command.name for command in commands()), "batch"])
def test_help_has_examples_that_are_commands(name: str) -> None:
    shown = run_command(name, "--help").stdout
    lines = [line.strip() for line in shown.partition("examples:\n")[2].splitlines()]
    assert lines
    assert all(line.startswith(f"laplacian-simplify {name} ") for line in lines)
    from laplacian_simplify.options import make_parser

    for line in lines:
        make_parser().parse_args(line.replace("'", "").split()[1:])


def test_a_script_is_named_as_it_was_called(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LAPLACIAN_SIMPLIFY_PROGRAM", "scripts/simplify")
    shown = run_command("simplify", "--help").stdout
    assert shown.startswith("usage: scripts/simplify [-h]")
    assert "  scripts/simplify bunny.ply small.ply --percent 10\n" in shown
    assert run_command("simplify", FLANGE).stderr.startswith("scripts/simplify: error: ") is False
    assert "(see scripts/simplify --help)" in run_command("simplify", "--no-such").stderr
    script = (Path(__file__).parents[2] / "scripts" / "simplify").read_text()
    assert "export LAPLACIAN_SIMPLIFY_PROGRAM=scripts/simplify" in script


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_completion(shell: str) -> None:
    pytest.importorskip("shtab")
    done = run_command("--print-completion", shell)
    assert done.returncode == 0, done.stderr
    assert "feature-weight" in done.stdout


def test_completion_without_its_package(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    from laplacian_simplify.options import make_parser

    monkeypatch.setitem(sys.modules, "shtab", None)
    with pytest.raises(SystemExit) as end:
        make_parser().parse_args(["--print-completion", "bash"])
    assert end.value.code == 2
    assert "pip install laplacian-simplify[completion]" in capsys.readouterr().err
