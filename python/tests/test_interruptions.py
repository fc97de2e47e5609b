# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals, an end by force, and disks that take no more: nothing is left behind, and what it was is said."""

import errno
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, assert_one_line

from laplacian_simplify.files.staging import unwritable

SCAN = SAMPLE_MESHES / "relief_scan.ply"
LONG = ["simplify", str(SCAN), "out.ply", "--percent", "1", "--effort", "best", "--threads", "1"]
COMMAND = [sys.executable, "-P", "-m", "laplacian_simplify"]

# Ctrl+C while the command is still being imported.
EARLY = """
import os, signal, sys
from importlib.abc import MetaPathFinder

module = sys.argv[1]

class Interrupter(MetaPathFinder):
    def find_spec(self, name, path, target=None):
        if name == module:
            os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Interrupter())
sys.argv = ["laplacian-simplify", "--version"]
from laplacian_simplify.__main__ import main
main()
"""


def _wait_until(condition: Callable[[], object]) -> object:
    deadline = time.monotonic() + 60
    while not (found := condition()):
        assert time.monotonic() < deadline, "it did not happen within a minute"
        time.sleep(0.01)
    return found


def _children(parent: int) -> list[int]:
    found = []
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                fields = (folder / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if int(fields[1]) == parent and fields[0] != "Z":
                found.append(int(folder.name))
    return found


@pytest.mark.parametrize(
    "module", ["argparse", "laplacian_simplify.command_line", "laplacian_simplify.options", "json"]
)
def test_ctrl_c_during_the_start_says_nothing(module: str) -> None:
    words = [sys.executable, "-P", "-c", EARLY, module]
    done = subprocess.run(
        words,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # the background jobs of a shell ignore it
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == -signal.SIGINT
    assert done.stderr == ""
    assert done.stdout == ""


def test_a_signal_that_is_ignored_stays_so(tmp_path: Path) -> None:
    """As under nohup."""
    process = subprocess.Popen(
        [*COMMAND, "simplify", str(SCAN), "out.ply", "--percent", "10"],
        cwd=tmp_path,
        stdout=subprocess.DEVNULL,
        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN),
    )
    _wait_until(lambda: list(tmp_path.iterdir()))
    process.send_signal(signal.SIGHUP)
    assert process.wait(timeout=300) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["out.ply"]


def test_the_worker_ends_with_the_command(tmp_path: Path) -> None:
    environment = {**os.environ, "TMPDIR": str(tmp_path)}  # nobody is left to clean up
    process = subprocess.Popen([*COMMAND, *LONG], cwd=tmp_path, env=environment, stderr=subprocess.DEVNULL)
    _wait_until(lambda: list(tmp_path.iterdir()))
    (worker,) = _wait_until(lambda: _children(process.pid))  # type: ignore[misc]
    process.kill()
    process.wait()
    _wait_until(lambda: not Path(f"/proc/{worker}").exists() or "Z" in _state(worker))


def _state(process: int) -> str:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return "Z"


def test_a_worker_that_is_killed_is_named_with_the_file(tmp_path: Path) -> None:
    process = subprocess.Popen([*COMMAND, *LONG], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    _wait_until(lambda: list(tmp_path.iterdir()))
    (worker,) = _wait_until(lambda: _children(process.pid))  # type: ignore[misc]
    os.kill(worker, signal.SIGKILL)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 1
    assert_one_line(said)
    assert f"{SCAN} cannot be" in said
    assert "was killed (SIGKILL), as happens where memory runs out" in said
    assert list(tmp_path.iterdir()) == []


def test_a_limit_on_file_size_is_named(tmp_path: Path) -> None:
    (tmp_path / "out.ply").write_text("old")
    done = subprocess.run(
        [*COMMAND, "simplify", str(SCAN), "out.ply", "--percent", "50"],
        cwd=tmp_path,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000)),
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 1, done.stderr
    assert_one_line(done.stderr)
    assert (
        "out.ply cannot be written: File too large; files may have at most 50,000 bytes here (ulimit -f)" in done.stderr
    )
    assert (tmp_path / "out.ply").read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["out.ply"]


@pytest.mark.parametrize(
    ("number", "said"),
    [
        (errno.ENOSPC, "No space left on device; free space on the disk of /there, or write elsewhere"),
        (errno.EDQUOT, "Disk quota exceeded; your quota is used up; free space, or write elsewhere"),
        (errno.EROFS, "Read-only file system; /there can only be read; write elsewhere"),
        (errno.EACCES, "Permission denied; you may not write into /there; write elsewhere"),
    ],
)
def test_what_the_disk_says_is_said(number: int, said: str) -> None:
    error = unwritable("out.ply", OSError(number, os.strerror(number)), Path("/there"))
    assert str(error) == f"out.ply cannot be written: {said}"


@pytest.mark.parametrize("mode", [0o640, 0o600, 0o664])
def test_permissions_of_an_output_that_is_there_are_kept(mode: int, tmp_path: Path) -> None:
    (tmp_path / "out.ply").write_text("old")
    (tmp_path / "out.ply").chmod(mode)
    words = [*COMMAND, "simplify", str(SAMPLE_MESHES / "painted_box.obj"), "out.ply", "--percent", "50"]
    subprocess.run(words, cwd=tmp_path, check=True, capture_output=True)
    assert (tmp_path / "out.ply").stat().st_mode & 0o7777 == mode
