# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that is there is replaced by a whole one or stays: kills, full disks, folders to read only, broken pipes."""

import os
import resource
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, assert_one_line, faces_in

from laplacian_simplify.files.errors import MeshFileError
from laplacian_simplify.files.staging import write_staged

FLANGE = SAMPLE_MESHES / "flange.ply"
BOX = ("painted_box.obj", "painted_box.mtl", "painted_box.png")
COMMAND = [sys.executable, "-P", "-m", "laplacian_simplify"]
HOOKS = Path(__file__).parent / "write_hooks"
FAST = ("--percent", "50", "--effort", "fast", "--no-measure-error")


def _run(
    *arguments: object, limit: int = 0, streams: str = "", pipe: int | None = None, **variables: object
) -> "subprocess.CompletedProcess[str]":
    """The command, with hooks where there are variables for them.

    Args:
        limit: bytes that a file may have; 0: no limit.
        streams: what a shell does to the standard streams.
        pipe: which of the streams that are open here it may name there.
    """
    paths = os.pathsep.join([str(HOOKS), *filter(None, [os.environ.get("PYTHONPATH")])])
    hooks = {"PYTHONPATH": paths, **{name: str(value) for name, value in variables.items()}} if variables else {}

    def begin() -> None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if limit:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run(
        ["bash", "-c", f'exec "$@" {streams}', "bash", *COMMAND, *map(str, arguments)],
        env={**os.environ, **hooks},
        preexec_fn=begin,
        pass_fds=() if pipe is None else (pipe,),
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def _contents(folder: Path) -> dict[str, bytes]:
    """Files, but for those in folders that nobody was left to remove."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def _painted_box(folder: Path) -> Path:
    folder.mkdir()
    for name in BOX:
        shutil.copy(SAMPLE_MESHES / name, folder)
    (folder / "painted_box.obj.mtl").write_bytes(b"# old\n" + (folder / "painted_box.mtl").read_bytes())
    return folder / "painted_box.obj"


def test_a_kill_at_any_step_leaves_the_old_mesh_or_the_new_one(tmp_path: Path) -> None:
    """In place, with materials and a texture beside the mesh: the command is cut off before every step it takes."""
    done = _painted_box(tmp_path / "whole")
    asked = tmp_path / "asked"
    words = ("--in-place", *FAST)
    assert _run("simplify", done, *words, WATCHED=done.parent, KILLED_AT=-1, ASKED=asked).returncode == 0
    new, steps = _contents(done.parent), asked.read_text().splitlines()
    for path in done.parent.iterdir():
        touched = [step.split("\t")[0] for step in steps if str(path) in step.split("\t")]
        assert set(touched) <= {"os.rename"}, f"{path.name} is not replaced by a whole file"
    seen = set()
    for step in range(len(steps)):
        mesh = _painted_box(tmp_path / f"at_{step}")
        old = _contents(mesh.parent)
        killed = _run("simplify", mesh, *words, WATCHED=mesh.parent, KILLED_AT=step)
        assert killed.returncode == -signal.SIGKILL, killed.stderr
        found = _contents(mesh.parent)
        assert found.keys() >= old.keys()
        for name, content in found.items():
            assert content in (old.get(name), new.get(name)), f"{name} is neither old nor new before {steps[step]}"
        is_new = found[mesh.name] != old[mesh.name]
        assert not is_new or found == new, f"the mesh came before a file that it names: {steps[step]}"
        seen.add(is_new)
    assert seen == {False, True}


def test_a_kill_in_the_middle_of_a_write_leaves_the_old_mesh(tmp_path: Path) -> None:
    target = tmp_path / "small.ply"
    target.write_text("old")
    done = _run("simplify", FLANGE, target, *FAST, limit=50_000, KILLED_WRITING=1)
    assert done.returncode == 1, done.stderr
    assert_one_line(done.stderr)
    assert f"{target} cannot be written: the writer crashed (SIGXFSZ); nothing was written" in done.stderr
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


@contextmanager
def _mounted(folder: Path, *options: str) -> Iterator[None]:
    """A small disk, which takes the right to mount one."""
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs", folder], capture_output=True, check=False
    )
    if mounted.returncode:
        pytest.skip(
            "mounting a disk is not allowed here; test_full_disk_keeps_the_old_file in test_output.py needs none"
        )
    try:
        yield
    finally:
        subprocess.run(["umount", folder], check=True)


@pytest.mark.parametrize("extension", ["ply", "obj", "3mf"])
def test_a_disk_that_fills_up_keeps_what_it_has(extension: str, tmp_path: Path) -> None:
    """Neither the mesh nor its report is half of a new one."""
    with _mounted(tmp_path, "size=200k"):
        target, report = tmp_path / f"small.{extension}", tmp_path / "report.json"
        target.write_text("old")
        report.write_text("old report")
        done = _run("simplify", FLANGE, target, *FAST, "--json", report)
        assert done.returncode == 1, done.stderr
        assert_one_line(done.stderr)
        assert f"{target} cannot be written: No space left on device; free space" in done.stderr
        assert _contents(tmp_path) == {target.name: b"old", report.name: b"old report"}
        assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("command", ["simplify", "lod", "compare"])
def test_a_disk_without_room_for_the_report_is_said(command: str, tmp_path: Path) -> None:
    """Nothing appears: neither the old report nor a mesh is replaced by what has no counterpart."""
    disk, target = tmp_path / "disk", tmp_path / "small.ply"
    disk.mkdir()
    target.write_text("old")
    words = {
        "simplify": (FLANGE, target, *FAST),
        "lod": (FLANGE, target, "--percents", "50", *FAST[2:]),
        "compare": (FLANGE, FLANGE, "--samples", "100"),
    }
    with _mounted(disk, "size=8k"):
        (disk / "report.json").write_bytes(bytes(8192))
        done = _run(command, *words[command], "--json", disk / "report.json")
        assert done.returncode == 1, done.stderr
        assert_one_line(done.stderr)
        assert f"{disk}/report.json cannot be written: No space left on device; free space" in done.stderr
        assert _contents(disk) == {"report.json": bytes(8192)}
        assert len(list(disk.iterdir())) == 1
    assert _contents(tmp_path) == {target.name: b"old"}


def test_what_a_full_disk_does_not_take_is_named() -> None:
    """As a picture, a page or a report; it takes no right to mount a disk."""
    with pytest.raises(MeshFileError, match=r"^the page cannot be written: No space left on device; free space on"):
        write_staged(Path("/dev/full"), "a page", "the page")


def test_a_full_disk_for_scratch_files_is_said(tmp_path: Path) -> None:
    """Where the input is not what MeshLab reads by itself, it is handed over in a file."""
    scratch, target = tmp_path / "scratch", tmp_path / "small.ply"
    scratch.mkdir()
    target.write_text("old")
    with _mounted(scratch, "size=20k"):
        done = _run("simplify", SAMPLE_MESHES / "bracket_quads.ply", target, *FAST, TMPDIR=scratch)
    assert done.returncode == 1, done.stderr
    assert_one_line(done.stderr)
    assert "No space left on device" in done.stderr
    assert _contents(tmp_path) == {target.name: b"old"}


def test_a_folder_to_read_only_keeps_its_file(tmp_path: Path) -> None:
    """That it is one is a matter of the disk here: modes do not stop everyone."""
    with _mounted(tmp_path, "size=400k"):
        target = tmp_path / "small.ply"
        target.write_text("old")
        subprocess.run(["mount", "-o", "remount,ro", tmp_path], check=True)
        done = _run("simplify", FLANGE, target, *FAST)
        assert done.returncode == 1, done.stderr
        assert_one_line(done.stderr)
        assert f"{target} cannot be written: Read-only file system; {tmp_path} can only be read" in done.stderr
        assert _contents(tmp_path) == {target.name: b"old"}


@pytest.fixture
def broken_pipe() -> Iterator[int]:
    """The end to write to of a pipe that nobody reads."""
    reading, writing = os.pipe()
    os.close(reading)
    yield writing
    os.close(writing)


@pytest.mark.parametrize("streams", [">&{pipe}", "2>&{pipe}", ">&{pipe} 2>&1", ">&- 2>&-"])
def test_nobody_who_listens_does_not_cost_the_mesh(streams: str, broken_pipe: int, tmp_path: Path) -> None:
    target = tmp_path / "small.ply"
    done = _run("simplify", FLANGE, target, *FAST, streams=streams.format(pipe=broken_pipe), pipe=broken_pipe)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert list(tmp_path.iterdir()) == [target]
    assert 0 < faces_in(target) <= 11840


@pytest.mark.parametrize("asked", [("-",), ("{folder}/small.ply", "--json", "-")])
@pytest.mark.parametrize(
    ("streams", "said"),
    [(">&{pipe}", "Broken pipe"), (">&-", "it is closed"), (">/dev/full", "No space left on device")],
)
def test_what_was_asked_for_and_reaches_nobody_is_an_error(
    streams: str, said: str, asked: tuple[str, ...], broken_pipe: int, tmp_path: Path
) -> None:
    words = [word.format(folder=tmp_path) for word in asked]
    done = _run("simplify", FLANGE, *words, *FAST, streams=streams.format(pipe=broken_pipe), pipe=broken_pipe)
    assert done.returncode == 1, done.stderr
    assert done.stderr.splitlines()[-1] == f"laplacian-simplify: error: standard output cannot be written: {said}"
