# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes: each is done or refused by itself, what is done is not done again, and workers may be anybody's."""

import json
import os
import shutil
import subprocess
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from batch_runs import (
    COMMAND,
    FAST,
    files_in,
    fill,
    manifest_rows,
    run_batch,
    wait_until,
    with_hooks,
    write_sheet,
)
from conftest import faces_in, run_command
from dask_cluster import has_workers, running_cluster

pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path, "subprocess.CompletedProcess[str]"]:
    """The folder of the meshes, that of the results by two workers, and what was said."""
    folder = tmp_path_factory.mktemp("first")
    fill(folder / "meshes")
    return (
        folder / "meshes",
        folder / "results",
        run_batch(folder / "meshes", folder / "results", *FAST, "--workers", "2"),
    )


@pytest.fixture
def copied(first: Any, tmp_path: Path) -> tuple[Path, Path]:
    """A copy of both folders as the run left them, to be changed."""
    meshes, results, _ = first
    shutil.copytree(meshes, tmp_path / "meshes")
    _fake_moved(shutil.copytree(results, tmp_path / "results"), results)
    return tmp_path / "meshes", tmp_path / "results"


def _fake_moved(results: Path, before: Path) -> None:
    """Makes the manifest one of this folder."""
    path = results / "laplacian-simplify.jsonl"
    path.write_text(path.read_text().replace(str(before), str(results)))


def test_broken_meshes_cost_only_themselves(first: Any) -> None:
    _, results, done = first
    assert done.returncode == 3, done.stderr
    assert done.stderr == ""
    rows = {row["input"]: row for row in manifest_rows(results)}
    assert Counter(row["status"] for row in rows.values()) == {"done": 9, "refused": 3}
    for name, row in rows.items():
        if row["status"] == "done":
            assert faces_in(results / name) == row["report"]["faces"] < row["report"]["faces_before"] / 4 + 1
    for name, reason in (
        ("garbage.ply", "garbage.ply cannot be read: line 1: 'garbage' instead of 'ply'; this is no PLY file"),
        ("wrong_index.off", "vertex index 7 is outside 0..2"),
        ("a/cut.stl", "a/cut.stl cannot be read: "),
    ):
        assert reason in rows[name]["reason"]
        assert reason in done.stdout
        assert not (results / name).exists()
    assert [line.split()[:2] for line in done.stdout.splitlines()[:4]] == [
        ["done", "9"],
        ["refused", "3"],
        ["crashed", "0"],
        ["skipped", "0"],
    ]
    assert {path.name for path in results.iterdir()} == {
        "a", "b", "painted_box.obj", "painted_box.obj.mtl", "painted_box.png", "bracket_quads.ply",
        "laplacian-simplify.jsonl",
    }  # fmt: skip


def test_a_second_run_skips_what_is_done(copied: tuple[Path, Path]) -> None:
    meshes, results = copied
    before = (results / "laplacian-simplify.jsonl").read_bytes()
    for path in meshes.rglob("*.off"):
        os.utime(path)  # as a fresh checkout or a copy would: the bytes are the same
    done = run_batch(meshes, results, *FAST, "--threads", "2")
    assert done.returncode == 3, done.stderr
    assert "skipped          12" in done.stdout
    assert "garbage.ply cannot be read" in done.stdout
    assert (results / "laplacian-simplify.jsonl").read_bytes() == before


def test_what_has_changed_is_done_again(copied: tuple[Path, Path]) -> None:
    meshes, results = copied
    write_sheet(meshes / "a" / "sheet_0.off", 20)  # another mesh
    (results / "a" / "sheet_2.off").unlink()  # its result is gone
    with (results / "b/c/sheet_1.off").open("a") as file:  # something happened to its result
        file.write("# \n")
    with (results / "laplacian-simplify.jsonl").open("a") as file:  # a run was killed while it wrote
        file.write('{"input": "a/sheet_4.off", "sta')
    lines = len(_rows_that_are_whole(results))
    done = run_batch(meshes, results, *FAST)
    assert done.returncode == 3, done.stderr
    new = _rows_that_are_whole(results)[lines:]
    assert sorted((row["input"], row["status"]) for row in new) == [
        ("a/sheet_0.off", "done"),
        ("a/sheet_2.off", "done"),
        ("b/c/sheet_1.off", "done"),
    ]
    assert faces_in(results / "a" / "sheet_0.off") > 150  # of 800, where there were 128


def _rows_that_are_whole(output: Path) -> list[dict[str, Any]]:
    lines = (output / "laplacian-simplify.jsonl").read_text().splitlines()
    return [json.loads(line) for line in lines if line.endswith("}")]


def test_another_option_does_all_again_and_retry_refused_the_refused(copied: tuple[Path, Path]) -> None:
    meshes, results = copied
    lines = len(manifest_rows(results))
    run_batch(meshes, results, *FAST, "--retry-refused")
    assert [row["status"] for row in manifest_rows(results)[lines:]] == ["refused"] * 3
    lines = len(manifest_rows(results))
    run_batch(meshes, results, *FAST, "--feature-weight", "0")
    assert Counter(row["status"] for row in manifest_rows(results)[lines:]) == {"done": 9, "refused": 3}


def test_bytes_are_those_of_one_worker_and_of_simplify(first: Any, tmp_path: Path) -> None:
    meshes, results, _ = first
    done = run_batch(meshes, tmp_path / "one", *FAST, "--workers", "1")
    assert done.returncode == 3, done.stderr
    assert files_in(tmp_path / "one") == files_in(results)
    (tmp_path / "alone").mkdir()
    for name in ("painted_box.obj", "bracket_quads.ply", "b/c/sheet_5.off"):
        alone = tmp_path / "alone" / Path(name).name
        done = run_command("simplify", meshes / name, alone, *FAST)
        assert done.returncode == 0, done.stderr
        assert alone.read_bytes() == (results / name).read_bytes()


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator["tuple[str, subprocess.Popen[bytes]]"]:
    """A scheduler on this machine with one worker: its address and process."""
    with running_cluster(tmp_path / "dask", with_hooks()) as found:
        yield found


def test_workers_of_a_scheduler(cluster: Any, first: Any, tmp_path: Path) -> None:
    """Its only worker is killed in the middle, and comes back."""
    address, scheduler = cluster
    for name, side in (("ends_the_worker_once", 12), ("sheet_1", 9), ("sheet_3", 11)):
        write_sheet(tmp_path / "meshes" / f"{name}.off", side)
    wait_until(lambda: has_workers(address))
    done = run_batch(tmp_path / "meshes", tmp_path / "results", *FAST, "--scheduler", address)
    assert done.returncode == 0, done.stdout + done.stderr
    assert Counter(row["status"] for row in manifest_rows(tmp_path / "results")) == {"done": 3}
    for name in ("sheet_1.off", "sheet_3.off"):
        assert (tmp_path / "results" / name).read_bytes() == (first[1] / "b/c" / name).read_bytes()
    assert [path for path in (tmp_path / "results").iterdir() if path.name[0] == "."] == []

    write_sheet(tmp_path / "meshes" / "hangs.off", 12)
    words = [*COMMAND, str(tmp_path / "meshes"), str(tmp_path / "results"), *FAST, "--scheduler", address]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    wait_until((tmp_path / "meshes" / "hangs.began").exists)
    scheduler.kill()
    _, said = process.communicate(timeout=120)
    assert process.returncode == 1
    assert (
        said == "laplacian-simplify: error: the scheduler is gone; what is done is kept, and the same command goes on\n"
    )


def _has_workers(address: str) -> bool:
    from distributed import Client

    try:
        with Client(address, timeout=5, set_as_default=False) as client:
            return bool(client.scheduler_info(n_workers=-1)["workers"])
    except OSError:
        return False
