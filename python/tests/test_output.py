# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The output appears whole or not at all, with its companions, and standard output stays clean."""

import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, assert_one_line, faces_in, run_command

import laplacian_simplify as ls

FLANGE = SAMPLE_MESHES / "flange.ply"


@pytest.mark.parametrize("extension", ["ply", "obj", "off", "stl", "PLY"])
def test_formats(extension: str, tmp_path: Path) -> None:
    target = tmp_path / f"small.{extension}"
    done = run_command("simplify", FLANGE, target, "--faces", 2000)
    assert done.returncode == 0, done.stderr
    assert 1990 <= faces_in(target) <= 2000


@pytest.mark.parametrize("extension", ["ply", "obj", "off", "stl"])
def test_formats_are_read(extension: str, tmp_path: Path) -> None:
    source = tmp_path / f"input.{extension}"
    ls.write_mesh(ls.read_mesh(FLANGE), source)
    done = run_command("simplify", source, tmp_path / "small.ply", "--percent", 10)
    assert done.returncode == 0, done.stderr
    assert "23,680 -> 2,36" in done.stdout


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("small.foo", "the format '.foo' is unknown"),
        ("small", "its name has no extension"),
        ("points.xyz", "the format '.xyz' is unknown"),
        ("missing/small.ply", "is not a folder"),
        ("file/small.ply", "is not a folder"),
        ("folder.ply", "it is a folder"),
        ("/proc/small.ply", "cannot be written"),
        ("/dev/full", "it is a device or a pipe; write to - for standard output"),
    ],
)
def test_unwritable_output(target: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "folder.ply").mkdir()
    (tmp_path / "file").write_text("")
    done = run_command("simplify", FLANGE, tmp_path / target, "--percent", 10)
    assert done.returncode == 1, done.stderr
    assert_one_line(done.stderr)
    assert said in done.stderr
    assert done.stdout == ""
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "folder.ply"]


def test_full_disk_keeps_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "small.ply"
    target.write_text("old")
    words = [sys.executable, "-P", "-m", "laplacian_simplify", "simplify", str(FLANGE), str(target), "--percent", "50"]

    def allow_no_more_than_50_kilobytes() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))

    done = subprocess.run(
        words, preexec_fn=allow_no_more_than_50_kilobytes, capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 1, done.stderr
    assert_one_line(done.stderr)
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_format_without_quality_is_pointed_out(tmp_path: Path) -> None:
    done = run_command("descriptor", FLANGE, tmp_path / "out.off")
    assert done.returncode == 0
    assert_one_line(done.stderr)
    assert "which only PLY keeps" in done.stderr


def test_the_classes_are_in_the_file(tmp_path: Path) -> None:
    done = run_command("classify", FLANGE, tmp_path / "out.ply", "--classes", 3)
    assert done.returncode == 0, done.stderr
    mesh_set = ls.read_mesh(tmp_path / "out.ply")
    assert set(mesh_set.current_mesh().vertex_scalar_array()) == {0, 1, 2}


def test_input_may_be_the_output(tmp_path: Path) -> None:
    path = tmp_path / "mesh.ply"
    path.write_bytes(FLANGE.read_bytes())
    assert run_command("simplify", path, path, "--faces", 1000).returncode == 0
    assert faces_in(path) <= 1000
    assert list(tmp_path.iterdir()) == [path]


def test_names_with_spaces_and_umlauts(tmp_path: Path) -> None:
    folder = tmp_path / "Ümläute und Leerzeichen"
    folder.mkdir()
    source, target = folder / "große datei.ply", folder / "kleine datei.off"
    source.write_bytes(FLANGE.read_bytes())
    done = run_command("simplify", source.name, target.name, "--faces", 1000, cwd=folder)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("große datei.ply -> kleine datei.off in ")
    assert sorted(folder.iterdir()) == sorted([source, target])


def test_a_link_is_written_through(tmp_path: Path) -> None:
    link, real = tmp_path / "link.ply", tmp_path / "real.ply"
    link.symlink_to(real)
    assert run_command("simplify", FLANGE, link, "--faces", 1000).returncode == 0
    assert link.is_symlink()
    assert real.is_file()


def test_the_usual_permissions(tmp_path: Path) -> None:
    target = tmp_path / "small.ply"
    run_command("simplify", FLANGE, target, "--faces", 1000)
    mask = os.umask(0)
    os.umask(mask)
    assert target.stat().st_mode & 0o777 == 0o666 & ~mask


def test_texture_goes_with_the_mesh(tmp_path: Path) -> None:
    target = tmp_path / "small.obj"
    done = run_command("simplify", SAMPLE_MESHES / "painted_box.obj", target, "--percent", 50)
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["painted_box.png", "small.obj", "small.obj.mtl"]


def test_the_input_keeps_its_texture(tmp_path: Path) -> None:
    for name in ("painted_box.obj", "painted_box.mtl", "painted_box.png"):
        (tmp_path / name).write_bytes((SAMPLE_MESHES / name).read_bytes())
    done = run_command("simplify", "painted_box.obj", "small.obj", "--percent", 50, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "painted_box.png").read_bytes() == (SAMPLE_MESHES / "painted_box.png").read_bytes()


def test_json_on_standard_output_is_nothing_but_json(tmp_path: Path) -> None:
    done = run_command("simplify", FLANGE, tmp_path / "small.ply", "--faces", 1000, "--json", "-")
    assert json.loads(done.stdout)["faces_before"] == 23680
    assert "23,680 -> " in done.stderr


def test_json_file(tmp_path: Path) -> None:
    report = tmp_path / "report.json"
    done = run_command("descriptor", FLANGE, tmp_path / "out.ply", "--json", report)
    assert done.returncode == 0, done.stderr
    numbers = {"minimum", "maximum", "mean", "percentile_99_9", "seconds"}
    assert set(json.loads(report.read_text())) == numbers | {"input", "output", "parameters", "units", "version"}


def test_unwritable_report_leaves_no_mesh(tmp_path: Path) -> None:
    done = run_command("simplify", FLANGE, tmp_path / "out.ply", "--faces", 1000, "--json", tmp_path / "missing/r.json")
    assert done.returncode == 1
    assert_one_line(done.stderr)
    assert list(tmp_path.iterdir()) == []
