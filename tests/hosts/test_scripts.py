# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same script of filters does the same in every host that reads scripts."""

import math
from collections.abc import Callable
from pathlib import Path

import pytest

import script_hosts
from display import Display
from filter_scripts import values_of, write_script
from host_programs import HostProgram
from mesh_checks import EXPECTATIONS, MeshData
from painted_box import check_painted_box, write_painted_box
from script_hosts import ScriptHost

HOSTS = ["meshlab-2020.09", "meshlab-2022.02", "meshlab-2025.07", "pymeshlab-2025.7"]


@pytest.fixture(params=HOSTS)
def run_script(
    request: pytest.FixtureRequest, display: Display, installed_host: Callable[[str], HostProgram]
) -> ScriptHost:
    if request.param == "pymeshlab-2025.7":
        return script_hosts.pymeshlab
    host = installed_host(request.param.removeprefix("meshlab-"))
    start = script_hosts.meshlabserver if host.version == "2020.09" else script_hosts.script_runner
    return start(host, display.name)


def test_every_filter(filter_row: dict, run_script: ScriptHost, part: Path, tmp_path: Path) -> None:
    expected = EXPECTATIONS[filter_row["id"]]
    script = write_script(tmp_path / "script.mlx", (filter_row, values_of(filter_row, **expected.changes)))
    output = tmp_path / "output.ply"
    run = run_script(script, part, output)
    assert run.status == 0, run.output
    assert output.exists(), run.output
    expected.check(MeshData.read(part), MeshData.read(output))


def test_one_script_of_all_filters(filters: list[dict], run_script: ScriptHost, part: Path, tmp_path: Path) -> None:
    steps = [(row, values_of(row, **EXPECTATIONS[row["id"]].changes)) for row in filters]
    output = tmp_path / "output.ply"
    run = run_script(write_script(tmp_path / "script.mlx", *steps), part, output)
    assert run.status == 0, run.output
    faces = len(MeshData.read(output).faces)
    assert 0.1 * 0.2 * 23680 - 2 <= faces <= 0.1 * 0.2 * 23680 + 1


def test_every_choice(
    filters: list[dict], filter_row: dict, run_script: ScriptHost, part: Path, tmp_path: Path
) -> None:
    """One step for each option of each choice, after the descriptor, whose quality one of the options reads."""
    descriptor = next(row for row in filters if row["id"] == "descriptor")
    choices = [
        {row["id"]: place}
        for row in filter_row["parameters"]
        if row["type"] == "choice"
        for place in range(len(row["options"]))
    ]
    kept = {"target_percent": 80} if any(row["id"] == "target_percent" for row in filter_row["parameters"]) else {}
    steps = [(filter_row, values_of(filter_row, **kept, **choice)) for choice in choices]
    output = tmp_path / "output.ply"
    run = run_script(write_script(tmp_path / "s.mlx", (descriptor, values_of(descriptor)), *steps), part, output)
    assert run.status == 0, run.output
    before, after = len(MeshData.read(part).faces), len(MeshData.read(output).faces)
    expected = before * 0.8 ** len(steps) if kept else before
    assert abs(after - expected) <= 2 * len(steps), run.output  # a collapse may take two faces at once


def test_attributes_are_kept(filters: list[dict], run_script: ScriptHost, part: Path, tmp_path: Path) -> None:
    """Texture coordinates of wedges, vertex colors and quality, from one file to another."""
    row = next(row for row in filters if row["id"] == "simplify")
    box = write_painted_box(part.with_name("painted_box.obj"), tmp_path / "box.ply")
    script = write_script(tmp_path / "script.mlx", (row, values_of(row, target_percent=20)))
    output = tmp_path / "output.ply"
    run = run_script(script, box, output)
    assert "texture coordinates" in run.output, run.output
    assert "Texture deviation in percent" in run.output, run.output
    check_painted_box(output, faces=614)  # a fifth of 3,072


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("target_percent", 200, "target_percent = 200 is outside [0, 100]"),
        ("target_faces", -5, "target_faces = -5 is outside [1, 2147483647]"),
        ("feature_weight", math.nan, "feature_weight = nan is outside [0, 50]"),
        ("effort", 7, "effort = 7 is not one of fast (0), balanced (1), best (2)"),
    ],
)
def test_bad_value_is_refused_by_name(
    filters: list[dict], run_script: ScriptHost, part: Path, tmp_path: Path, name: str, value: float, said: str
) -> None:
    """A host may write the untouched mesh and end with 0, but the sentence must have been shown."""
    row = next(row for row in filters if row["id"] == "simplify")
    script = write_script(tmp_path / "script.mlx", (row, values_of(row, **{name: value})))
    output = tmp_path / "output.ply"
    run = run_script(script, part, output)
    assert said in run.output, run.output
    if output.exists():
        assert MeshData.read(output).near(MeshData.read(part))


def test_mesh_without_faces_is_refused(filter_row: dict, run_script: ScriptHost, tmp_path: Path) -> None:
    points = tmp_path / "points.ply"
    properties = "".join(f"property float {axis}\n" for axis in "xyz")
    header = f"ply\nformat ascii 1.0\nelement vertex 4\n{properties}end_header\n"
    points.write_text(header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
    script = write_script(tmp_path / "script.mlx", (filter_row, values_of(filter_row)))
    run = run_script(script, points, tmp_path / "output.ply")
    assert "the mesh has no faces (4 vertices)" in run.output, run.output


@pytest.mark.parametrize("version", ["2022.02", "2025.07"])
def test_cancelled_run_leaves_the_mesh(
    version: str,
    filter_row: dict,
    display: Display,
    installed_host: Callable[[str], HostProgram],
    part: Path,
    tmp_path: Path,
) -> None:
    """No host cancels today, but its progress callback may say so, and then nothing must have changed."""
    script = write_script(tmp_path / "script.mlx", (filter_row, values_of(filter_row)))
    output = tmp_path / "output.ply"
    run = script_hosts.script_runner(installed_host(version), display.name, "--cancel")(script, part, output)
    assert "cancel" in run.output, run.output
    if run.status == 0:
        assert MeshData.read(output).near(MeshData.read(part))
