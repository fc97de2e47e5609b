# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl+C, a killed run, and processes that end: nothing is left behind, and the next run goes on."""

import os
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from batch_runs import COMMAND, FAST, files_in, is_alive, manifest_rows, run_batch, wait_until, with_hooks, write_sheet
from conftest import assert_one_line

pytest.importorskip("distributed")


def test_a_process_that_is_killed_or_hangs_costs_one_mesh(tmp_path: Path) -> None:
    for name, side in (("hangs", 12), ("killed", 11), ("killed_once", 10), ("sheet", 9)):
        write_sheet(tmp_path / "meshes" / f"{name}.off", side)
    os.mkfifo(tmp_path / "meshes" / "pipe.ply")
    output = tmp_path / "results"
    words = (tmp_path / "meshes", output, *FAST, "--format", "ply", "--workers", "1", "--timeout", "10")
    done = run_batch(*words, hooks=True)
    assert done.returncode == 3, done.stderr
    assert [(row["input"], row["status"], row["tries"], row.get("reason")) for row in manifest_rows(output)] == [
        ("hangs.off", "crashed", 1, "simplifying it took more than 10 s"),
        ("killed.off", "crashed", 2, "simplifying it crashed (SIGKILL, as happens where memory runs out)"),
        ("killed_once.off", "done", 2, None),
        ("sheet.off", "done", 1, None),
        ("pipe.ply", "refused", 1, "pipe.ply is not a file but a device or a pipe; use - to read from standard input"),
    ]
    assert sorted(files_in(output)) == ["killed_once.ply", "sheet.ply"]
    assert [path for path in output.iterdir() if path.name[0] == "."] == []
    (tmp_path / "meshes" / "pipe.ply").unlink()
    done = run_batch(*words)  # what crashed is tried again
    assert done.returncode == 0, done.stderr
    assert "done              2" in done.stdout
    assert "skipped           2" in done.stdout


@pytest.fixture
def at_work(tmp_path: Path) -> Iterator["tuple[subprocess.Popen[str], int, Path]"]:
    """A run in the middle of a mesh that never ends, with one that is done: its process, that of the mesh, folders."""
    write_sheet(tmp_path / "meshes" / "hangs.off", 12)
    write_sheet(tmp_path / "meshes" / "sheet.off", 9)
    (tmp_path / "scratch").mkdir()
    process = subprocess.Popen(
        [*COMMAND, str(tmp_path / "meshes"), str(tmp_path / "results"), *FAST, "--workers", "2"],
        env={**with_hooks(), "TMPDIR": str(tmp_path / "scratch")},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # the background jobs of a shell ignore it
    )
    try:
        manifest, began = tmp_path / "results" / "laplacian-simplify.jsonl", tmp_path / "meshes" / "hangs.began"
        wait_until(lambda: manifest.exists() and manifest.read_text() and began.exists() and began.read_text())
        yield process, int(began.read_text()), tmp_path
    finally:
        process.kill()
        process.communicate()


def test_ctrl_c_leaves_nothing_and_the_next_run_goes_on(at_work: Any) -> None:
    process, of_mesh, folder = at_work
    second = run_batch(folder / "meshes", folder / "results", *FAST)
    assert second.returncode == 1
    assert_one_line(second.stderr)
    assert "results is in use: another batch writes into it" in second.stderr
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    shown, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert said == "laplacian-simplify: error: stopped; what is done is kept, and the same command goes on\n"
    assert shown == ""
    assert not is_alive(of_mesh)
    assert list((folder / "scratch").iterdir()) == []
    assert sorted(path.name for path in (folder / "results").iterdir()) == ["laplacian-simplify.jsonl", "sheet.off"]
    third = run_batch(folder / "meshes", folder / "results", *FAST)
    assert third.returncode == 0, third.stderr
    assert [row["input"] for row in manifest_rows(folder / "results")] == ["sheet.off", "hangs.off"]


def test_processes_end_with_a_run_that_is_killed(at_work: Any) -> None:
    process, of_mesh, folder = at_work
    process.kill()
    process.wait()
    wait_until(lambda: not is_alive(of_mesh))
    again = run_batch(folder / "meshes", folder / "results", *FAST)
    assert again.returncode == 0, again.stderr
    assert sorted(path.name for path in (folder / "results").iterdir()) == [
        "hangs.off",
        "laplacian-simplify.jsonl",
        "sheet.off",
    ]
