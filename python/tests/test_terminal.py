# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress is shown on a terminal only; a run that is stopped leaves nothing."""

import os
import pty
import signal
import subprocess
import sys
import termios
import time
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, run_command

SCAN = SAMPLE_MESHES / "relief_scan.ply"


def _on_terminal(*arguments: object) -> str:
    """What the command writes to a terminal."""
    ours, theirs = pty.openpty()
    termios.tcsetwinsize(theirs, (24, 80))
    words = [sys.executable, "-P", "-m", "laplacian_simplify", *map(str, arguments)]
    process = subprocess.Popen(words, stdout=theirs, stderr=theirs, stdin=subprocess.DEVNULL)
    os.close(theirs)
    written = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:  # the other end is closed
            break
        written += piece
    os.close(ours)
    assert process.wait() == 0
    return written.decode()


def test_progress_on_a_terminal(tmp_path: Path) -> None:
    written = _on_terminal("simplify", SCAN, tmp_path / "small.ply", "--percent", 10)
    assert " 0 %" in written
    assert "50,000 -> " in written


def test_no_progress_elsewhere(tmp_path: Path) -> None:
    done = run_command("simplify", SCAN, tmp_path / "small.ply", "--percent", 10)
    assert done.stderr == ""
    assert "\r" not in done.stdout


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_stopped_run_leaves_nothing(stop: signal.Signals, tmp_path: Path) -> None:
    words = [sys.executable, "-P", "-m", "laplacian_simplify", "simplify", SCAN, tmp_path / "output" / "out.ply"]
    words += ["--percent", "1", "--effort", "best", "--threads", "1"]
    output, scratch = tmp_path / "output", tmp_path / "scratch"
    output.mkdir()
    scratch.mkdir()
    # A shell starts its background jobs with Ctrl+C ignored, and what is ignored stays so in their children.
    process = subprocess.Popen(
        list(map(str, words)),
        env={**os.environ, "TMPDIR": str(scratch)},
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(stop, signal.SIG_DFL),
    )
    deadline = time.monotonic() + 60
    while not list(output.iterdir()) and time.monotonic() < deadline:
        time.sleep(0.01)
    process.send_signal(stop)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert said == "laplacian-simplify: error: stopped; nothing was written\n"
    assert list(output.iterdir()) == []
    assert list(scratch.iterdir()) == []
