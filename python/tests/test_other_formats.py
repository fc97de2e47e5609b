# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats that only MeshLab reads or writes: in a process of their own, whose end is a sentence."""

import subprocess
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES
from mesh_files import VOLUME, obj
from reading_checks import assert_refused, reading_of, refusal, volume, write

import laplacian_simplify as ls
from laplacian_simplify.child import Child, ChildCrashError
from laplacian_simplify.files import others
from laplacian_simplify.files.output_formats import OUTPUT_FORMATS
from laplacian_simplify.files.reading import read

READ_AGAIN = ("3ds", "3mf", "ctm", "dae", "wrl", "x3d")


@pytest.mark.parametrize("extension", [row.extension for row in OUTPUT_FORMATS])
def test_every_format_of_the_table_is_written(extension: str, tmp_path: Path) -> None:
    box = reading_of(tmp_path / "box.obj", obj())
    ls.write_mesh(box.mesh_set, tmp_path / f"out.{extension}")
    assert (tmp_path / f"out.{extension}").stat().st_size > 0
    if extension in (*READ_AGAIN, "ply", "obj", "off", "stl"):
        assert volume(read(tmp_path / f"out.{extension}")) == pytest.approx(VOLUME, rel=1e-5)


def test_a_reader_that_does_not_end_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "sample.ctm"
    ls.write_mesh(ls.read_mesh(SAMPLE_MESHES / "flange.ply"), path)
    monkeypatch.setattr(others, "_SECONDS", 0)
    monkeypatch.setattr(others, "_SECONDS_PER_MEGABYTE", 0)
    with pytest.raises(OSError, match=r"sample.ctm cannot be read: MeshLab's reader of .ctm did not end"):
        ls.read_mesh(path)


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (ChildCrashError("SIGSEGV", ""), "crashed (SIGSEGV)"),
        (ChildCrashError("SIGXCPU", ""), "did not end"),
        (subprocess.TimeoutExpired("", 1), "did not end"),
        (MemoryError(), "needs more memory than a file of this size can be worth"),
    ],
)
def test_how_a_reader_ends_is_named(
    error: Exception, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Ending:
        def __init__(self, *_: object) -> None: ...

        def answer(self, **_: object) -> None:
            raise error

    monkeypatch.setattr(others, "Child", Ending)
    remedy = "the file is damaged, or convert it to PLY"
    assert_refused(tmp_path / "mesh.ctm", "OCTM", f"MeshLab's reader of .ctm {said}; {remedy}")


@pytest.mark.parametrize("extension", READ_AGAIN)
def test_damage_is_one_line(extension: str, tmp_path: Path) -> None:
    path = tmp_path / f"box.{extension}"
    ls.write_mesh(reading_of(tmp_path / "box.obj", obj()).mesh_set, path)
    whole = path.read_bytes()
    write(path, whole[: len(whole) // 2])
    said = refusal(path)
    assert "\n" not in said
    assert said.startswith(str(path)) or not said  # MeshLab takes some as far as they go


def test_a_child_that_is_killed_is_a_crash() -> None:
    child = Child("files.others:convert", {"path": "/dev/null", "folder": "/", "seconds": 9, "memory": 2**40})
    child._process.kill()
    with pytest.raises(ChildCrashError) as raised:
        child.answer()
    assert raised.value.cause == "SIGKILL"


def test_what_a_child_raises_arrives() -> None:
    child = Child("files.others:convert", {"path": "/missing.ctm", "folder": "/", "seconds": 9, "memory": 2**40})
    with pytest.raises(OSError, match=r"missing.ctm"):
        child.answer()
    child = Child("files.others:convert", {"no such": "argument"})
    with pytest.raises(RuntimeError, match="internal error: TypeError"):
        child.answer()
