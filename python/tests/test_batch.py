# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes: each is done, refused or crashed by itself; what is done is not done again; nothing is left behind."""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import SAMPLE_MESHES, assert_one_line, faces_in, run_command
from dask_cluster import has_workers, running_cluster

import laplacian_simplify as ls
from laplacian_simplify.batch.inputs import find_meshes
from laplacian_simplify.batch.worker import PROCESS
from laplacian_simplify.workers.arguments import bytes_of
from laplacian_simplify.workers.process import WorkerProcess

pytest.importorskip("distributed")

COMMAND = [sys.executable, "-P", "-m", "laplacian_simplify", "batch"]
HOOKS = Path(__file__).parent / "batch_hooks"
FAST = ("--percent", "25", "--effort", "fast", "--no-measure-error")


def _write_sheet(path: Path, side: int) -> None:
    """A wavy sheet of 2 side^2 faces, as text."""
    x, y = np.meshgrid(np.arange(side + 1), np.arange(side + 1))
    points = np.stack([x, y, np.sin(0.7 * x) * np.cos(0.9 * y)], axis=-1).reshape(-1, 3)
    index = np.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        np.savetxt(file, points, "%.6f")
        np.savetxt(file, np.insert(faces, 0, 3, axis=1), "%d")


def _fill(folder: Path) -> None:
    """Nine meshes and three that are broken, in three folders."""
    for k in range(7):
        _write_sheet(folder / ("a", "b/c")[k % 2] / f"sheet_{k}.off", 8 + k)
    for name in ("painted_box.obj", "painted_box.mtl", "painted_box.png", "bracket_quads.ply"):
        shutil.copy(SAMPLE_MESHES / name, folder)
    (folder / "garbage.ply").write_text("garbage\n")
    (folder / "a" / "cut.stl").write_bytes(bytes(80) + b"\x09\0\0\0" + bytes(60))
    (folder / "wrong_index.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    (folder / "notes.txt").write_text("no mesh")


def _rows(output: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (output / "laplacian-simplify.jsonl").read_text().splitlines()]


def _files(folder: Path) -> dict[str, bytes]:
    """Results and what lies beside them."""
    paths = [path for path in folder.rglob("*") if path.is_file() and path.suffix != ".jsonl"]
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def _run(*arguments: object, hooks: bool = False) -> "subprocess.CompletedProcess[str]":
    words = [*COMMAND, *map(str, arguments)]
    environment = _with_hooks() if hooks else None
    return subprocess.run(words, env=environment, capture_output=True, text=True, timeout=300, check=False)


def _with_hooks() -> dict[str, str]:
    paths = os.pathsep.join([str(HOOKS), *filter(None, [os.environ.get("PYTHONPATH")])])
    return {**os.environ, "PYTHONPATH": paths}


def _wait_until(condition: Callable[[], object]) -> Any:
    deadline = time.monotonic() + 60
    while not (found := condition()):
        assert time.monotonic() < deadline, "it did not happen within a minute"
        time.sleep(0.01)
    return found


def _is_alive(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path, "subprocess.CompletedProcess[str]"]:
    """The folder of the meshes, that of the results by two workers, and what was said."""
    folder = tmp_path_factory.mktemp("first")
    _fill(folder / "meshes")
    return folder / "meshes", folder / "results", _run(folder / "meshes", folder / "results", *FAST, "--workers", "2")


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
    rows = {row["input"]: row for row in _rows(results)}
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
    done = _run(meshes, results, *FAST, "--threads", "2")
    assert done.returncode == 3, done.stderr
    assert "skipped          12" in done.stdout
    assert "garbage.ply cannot be read" in done.stdout
    assert (results / "laplacian-simplify.jsonl").read_bytes() == before


def test_what_has_changed_is_done_again(copied: tuple[Path, Path]) -> None:
    meshes, results = copied
    _write_sheet(meshes / "a" / "sheet_0.off", 20)  # another mesh
    (results / "a" / "sheet_2.off").unlink()  # its result is gone
    with (results / "b/c/sheet_1.off").open("a") as file:  # something happened to its result
        file.write("# \n")
    with (results / "laplacian-simplify.jsonl").open("a") as file:  # a run was killed while it wrote
        file.write('{"input": "a/sheet_4.off", "sta')
    lines = len(_rows_that_are_whole(results))
    done = _run(meshes, results, *FAST)
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
    lines = len(_rows(results))
    _run(meshes, results, *FAST, "--retry-refused")
    assert [row["status"] for row in _rows(results)[lines:]] == ["refused"] * 3
    lines = len(_rows(results))
    _run(meshes, results, *FAST, "--feature-weight", "0")
    assert Counter(row["status"] for row in _rows(results)[lines:]) == {"done": 9, "refused": 3}


def test_bytes_are_those_of_one_worker_and_of_simplify(first: Any, tmp_path: Path) -> None:
    meshes, results, _ = first
    done = _run(meshes, tmp_path / "one", *FAST, "--workers", "1")
    assert done.returncode == 3, done.stderr
    assert _files(tmp_path / "one") == _files(results)
    (tmp_path / "alone").mkdir()
    for name in ("painted_box.obj", "bracket_quads.ply", "b/c/sheet_5.off"):
        alone = tmp_path / "alone" / Path(name).name
        done = run_command("simplify", meshes / name, alone, *FAST)
        assert done.returncode == 0, done.stderr
        assert alone.read_bytes() == (results / name).read_bytes()


def test_a_process_that_is_killed_or_hangs_costs_one_mesh(tmp_path: Path) -> None:
    for name, side in (("hangs", 12), ("killed", 11), ("killed_once", 10), ("sheet", 9)):
        _write_sheet(tmp_path / "meshes" / f"{name}.off", side)
    os.mkfifo(tmp_path / "meshes" / "pipe.ply")
    output = tmp_path / "results"
    words = (tmp_path / "meshes", output, *FAST, "--format", "ply", "--workers", "1", "--timeout", "10")
    done = _run(*words, hooks=True)
    assert done.returncode == 3, done.stderr
    assert [(row["input"], row["status"], row["tries"], row.get("reason")) for row in _rows(output)] == [
        ("hangs.off", "crashed", 1, "simplifying it took more than 10 s"),
        ("killed.off", "crashed", 2, "simplifying it crashed (SIGKILL, as happens where memory runs out)"),
        ("killed_once.off", "done", 2, None),
        ("sheet.off", "done", 1, None),
        ("pipe.ply", "refused", 1, "pipe.ply is not a file but a device or a pipe; use - to read from standard input"),
    ]
    assert sorted(_files(output)) == ["killed_once.ply", "sheet.ply"]
    assert [path for path in output.iterdir() if path.name[0] == "."] == []
    (tmp_path / "meshes" / "pipe.ply").unlink()
    done = _run(*words)  # what crashed is tried again
    assert done.returncode == 0, done.stderr
    assert "done              2" in done.stdout
    assert "skipped           2" in done.stdout


@pytest.fixture
def at_work(tmp_path: Path) -> Iterator["tuple[subprocess.Popen[str], int, Path]"]:
    """A run in the middle of a mesh that never ends, with one that is done: its process, that of the mesh, folders."""
    _write_sheet(tmp_path / "meshes" / "hangs.off", 12)
    _write_sheet(tmp_path / "meshes" / "sheet.off", 9)
    (tmp_path / "scratch").mkdir()
    process = subprocess.Popen(
        [*COMMAND, str(tmp_path / "meshes"), str(tmp_path / "results"), *FAST, "--workers", "2"],
        env={**_with_hooks(), "TMPDIR": str(tmp_path / "scratch")},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # the background jobs of a shell ignore it
    )
    try:
        manifest, began = tmp_path / "results" / "laplacian-simplify.jsonl", tmp_path / "meshes" / "hangs.began"
        _wait_until(lambda: manifest.exists() and manifest.read_text() and began.exists() and began.read_text())
        yield process, int(began.read_text()), tmp_path
    finally:
        process.kill()
        process.communicate()


def test_ctrl_c_leaves_nothing_and_the_next_run_goes_on(at_work: Any) -> None:
    process, of_mesh, folder = at_work
    second = _run(folder / "meshes", folder / "results", *FAST)
    assert second.returncode == 1
    assert_one_line(second.stderr)
    assert "results is in use: another batch writes into it" in second.stderr
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    shown, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert said == "laplacian-simplify: error: stopped; what is done is kept, and the same command goes on\n"
    assert shown == ""
    assert not _is_alive(of_mesh)
    assert list((folder / "scratch").iterdir()) == []
    assert sorted(path.name for path in (folder / "results").iterdir()) == ["laplacian-simplify.jsonl", "sheet.off"]
    third = _run(folder / "meshes", folder / "results", *FAST)
    assert third.returncode == 0, third.stderr
    assert [row["input"] for row in _rows(folder / "results")] == ["sheet.off", "hangs.off"]


def test_processes_end_with_a_run_that_is_killed(at_work: Any) -> None:
    process, of_mesh, folder = at_work
    process.kill()
    process.wait()
    _wait_until(lambda: not _is_alive(of_mesh))
    again = _run(folder / "meshes", folder / "results", *FAST)
    assert again.returncode == 0, again.stderr
    assert sorted(path.name for path in (folder / "results").iterdir()) == [
        "hangs.off",
        "laplacian-simplify.jsonl",
        "sheet.off",
    ]


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator["tuple[str, subprocess.Popen[bytes]]"]:
    """A scheduler on this machine with one worker: its address and process."""
    with running_cluster(tmp_path / "dask", _with_hooks()) as found:
        yield found


def test_workers_of_a_scheduler(cluster: Any, first: Any, tmp_path: Path) -> None:
    """Its only worker is killed in the middle, and comes back."""
    address, scheduler = cluster
    for name, side in (("ends_the_worker_once", 12), ("sheet_1", 9), ("sheet_3", 11)):
        _write_sheet(tmp_path / "meshes" / f"{name}.off", side)
    _wait_until(lambda: has_workers(address))
    done = _run(tmp_path / "meshes", tmp_path / "results", *FAST, "--scheduler", address)
    assert done.returncode == 0, done.stdout + done.stderr
    assert Counter(row["status"] for row in _rows(tmp_path / "results")) == {"done": 3}
    for name in ("sheet_1.off", "sheet_3.off"):
        assert (tmp_path / "results" / name).read_bytes() == (first[1] / "b/c" / name).read_bytes()
    assert [path for path in (tmp_path / "results").iterdir() if path.name[0] == "."] == []

    _write_sheet(tmp_path / "meshes" / "hangs.off", 12)
    words = [*COMMAND, str(tmp_path / "meshes"), str(tmp_path / "results"), *FAST, "--scheduler", address]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    _wait_until((tmp_path / "meshes" / "hangs.began").exists)
    scheduler.kill()
    _, said = process.communicate(timeout=120)
    assert process.returncode == 1
    assert (
        said == "laplacian-simplify: error: the scheduler is gone; what is done is kept, and the same command goes on\n"
    )


def test_simplify_many_in_a_thread(tmp_path: Path) -> None:
    _write_sheet(tmp_path / "meshes" / "large.off", 40)
    _write_sheet(tmp_path / "meshes" / "small.off", 8)
    (tmp_path / "meshes" / "other.stl").write_bytes(b"")
    reports: list[Any] = []
    seen: list[Any] = []

    def work() -> None:
        pattern = tmp_path / "meshes" / "*.off"
        reports.append(
            ls.simplify_many(pattern, tmp_path / "out", target_faces=10, memory="101MiB", progress=seen.append)
        )

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    (report,) = reports
    assert str(report) == "1 done, 1 refused, 0 crashed, 0 skipped"
    assert not report.all_done
    assert seen == report.meshes
    refused = next(row for row in report.meshes if row["status"] == "refused")
    assert refused["reason"].endswith("are allowed; see --memory")
    # The machine was too small, not the mesh wrong: it is tried again without being asked.
    again = ls.simplify_many(tmp_path / "meshes" / "*.off", tmp_path / "out", target_faces=10)
    assert str(again) == "1 done, 0 refused, 0 crashed, 1 skipped"
    assert again.all_done


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["no_such_folder", "out", "--percent", "10"], "no_such_folder holds no mesh that can be read"),
        ([".", "out"], "one of the arguments --faces --percent --max-error is required"),
        ([".", ".", "--percent", "10"], "is the folder of the inputs"),
        ([".", "out", "--percent", "10", "--workers", "0"], "0 is not 1 or more"),
        ([".", "out", "--percent", "10", "--memory", "much"], "much is not a size such as 500MiB or 4GiB"),
        ([".", "out", "--percent", "10", "--timeout", "0"], "0 is not a number of seconds above 0"),
        ([".", "out", "--percent", "10", "--workers", "2", "--scheduler", "tcp://x:1"], "not allowed with argument"),
        ([".", "out", "--percent", "10", "--format", "ply"], "a.obj and a.off would both become"),
    ],
)
def test_wrong_arguments(arguments: list[str], said: str, tmp_path: Path) -> None:
    (tmp_path / "a.off").write_text("")
    (tmp_path / "a.obj").write_text("")
    done = run_command("batch", *arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert_one_line(done.stderr)
    assert said in done.stderr
    assert not (tmp_path / "out").exists()


def test_wrong_keywords(tmp_path: Path) -> None:
    for error, keywords in (
        (ValueError, {}),
        (TypeError, {"target_percent": 10, "new_layer": True}),
        (ValueError, {"target_percent": 10, "workers": 0}),
        (ValueError, {"target_percent": 10, "timeout": float("nan")}),
        (ValueError, {"target_percent": 10, "output_format": "docx"}),
        (TypeError, {"target_percent": 10, "progress": 3}),
    ):
        with pytest.raises(error):
            ls.simplify_many(tmp_path, tmp_path / "out", **keywords)


def test_patterns_keep_the_folders_below_their_fixed_part(tmp_path: Path) -> None:
    for name in ("a/x.off", "a/b/y.stl.gz", "a/z.glb", ".hidden/w.off", "a/list.txt"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")

    def found(given: str, output: str, output_format: str | None = None) -> set[tuple[str, str]]:
        folder = tmp_path / output
        meshes = find_meshes(str(tmp_path / given), folder, output_format)
        return {(mesh.name, str(mesh.target.relative_to(folder))) for mesh in meshes}

    all_of_them = {("a/x.off", "a/x.off"), ("a/b/y.stl.gz", "a/b/y.stl"), ("a/z.glb", "a/z.ply")}
    assert found(".", "out") == all_of_them
    assert found("**/*", "out") >= all_of_them
    assert found("a/*.off", "out", "stl") == {("x.off", "x.stl")}
    assert found("a/x.off", "out") == {("x.off", "x.off")}
    (tmp_path / "a[b]").mkdir()
    (tmp_path / "a[b]" / "x[1].off").write_text("")
    assert found("a[b]/x[1].off", "out") == {("x[1].off", "x[1].off")}
    shutil.rmtree(tmp_path / "a[b]")
    assert found(".", "a/b") == all_of_them - {("a/b/y.stl.gz", "a/b/y.stl")}  # a result is no input
    assert found("a/*.txt", "out") == {("list.txt", "list.ply")}  # whoever names it means it


def test_what_needs_more_memory_than_it_may_have_is_refused(tmp_path: Path) -> None:
    """By the process, where the estimate was too low; which then does the next one."""
    _write_sheet(tmp_path / "sheet.off", 150)
    process = WorkerProcess(str(tmp_path), PROCESS)
    arguments = {
        "function": "simplify",
        "source": str(tmp_path / "sheet.off"),
        "staged": str(tmp_path / "mesh.off"),
        "shown_source": "sheet.off",
        "shown_target": "mesh.off",
        "values": {"target_percent": 10, "threads": 1},
    }
    try:
        answer = process.run({"function": "work:run", "arguments": arguments, "memory": 1 << 20}, 100)
        assert answer["status"] in ("refused", "crashed")
        assert answer["status"] == "crashed" or answer["again"]
    finally:
        process.end()


@pytest.mark.parametrize(
    ("text", "number"), [("4GiB", 4 << 30), ("500 MB", 500 << 20), ("1.5g", 3 << 29), ("7", 7), ("2TiB", 2 << 40)]
)
def test_sizes(text: str, number: int) -> None:
    assert bytes_of(text) == number
