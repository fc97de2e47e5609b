# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh in blocks, when something goes wrong: nothing is lost, and the same command goes on to the same bytes."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import assert_one_line, run_command
from dask_cluster import has_workers, running_cluster
from huge_meshes import torus, write_ply

pytest.importorskip("distributed")

HOOKS = Path(__file__).parent / "huge_hooks"
OPTIONS = ("--percent", "4", "--block-faces", "4000", "--workers", "2", "--no-measure-error")
GOES_ON = "laplacian-simplify: error: stopped; what is done is kept, and the same command goes on\n"


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("faults") / "torus.ply"
    write_ply(path, *torus(120, 80))
    return path


@pytest.fixture(scope="module")
def result(source: Path) -> bytes:
    done = run_command("huge", source, source.with_name("small.ply"), *OPTIONS)
    assert done.returncode == 0, done.stderr
    return source.with_name("small.ply").read_bytes()


def _environment(hook: str) -> dict[str, str]:
    paths = os.pathsep.join([str(HOOKS), *filter(None, [os.environ.get("PYTHONPATH")])])
    return {**os.environ, "PYTHONPATH": paths, "HUGE_HOOK": hook}


def _words(source: Path, folder: Path, *more: object) -> list[str]:
    paths = (source, folder / "small.ply", *OPTIONS, "--work-folder", folder / "work", *more)
    return [sys.executable, "-P", "-m", "laplacian_simplify", "huge", *map(str, paths)]


def _wait_until(condition: Callable[[], object]) -> None:
    deadline = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < deadline, "it did not happen within a minute"
        time.sleep(0.01)


def _is_alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"


@pytest.fixture
def stopped(source: Path, tmp_path: Path) -> Iterator[Callable[[str, int], "subprocess.Popen[str]"]]:
    """Runs into a task that never ends, and ends the run there by a signal."""
    processes: list[subprocess.Popen[str]] = []

    def stop(task: str, number: int) -> "subprocess.Popen[str]":
        process = subprocess.Popen(
            _words(source, tmp_path),
            env=_environment(f"hang {task} {tmp_path}"),
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # background jobs of a shell ignore it
        )
        processes.append(process)
        _wait_until(lambda: (tmp_path / "began").exists() and (tmp_path / "began").read_text())
        if number:
            os.killpg(process.pid, number) if number == signal.SIGINT else process.send_signal(number)
        return process

    yield stop
    for process in processes:
        process.kill()
        process.communicate()


def _go_on(source: Path, folder: Path, result: bytes) -> None:
    done = subprocess.run(_words(source, folder), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert (folder / "small.ply").read_bytes() == result
    assert not (folder / "work").exists()


def _keys(folder: Path) -> set[str]:
    return {json.loads(line)["key"] for line in (folder / "work" / "journal.jsonl").read_text().splitlines()}


def test_a_worker_that_is_killed_costs_one_task(source: Path, result: bytes, tmp_path: Path) -> None:
    environment = _environment(f"kill collapse {tmp_path}")
    done = subprocess.run(_words(source, tmp_path), env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "began").exists()
    assert (tmp_path / "small.ply").read_bytes() == result


def test_ctrl_c_keeps_what_is_done(source: Path, result: bytes, tmp_path: Path, stopped: Any) -> None:
    process = stopped("collapse", signal.SIGINT)
    assert process.communicate(timeout=60)[1] == GOES_ON
    assert process.returncode == 130
    assert not _is_alive(int((tmp_path / "began").read_text()))
    assert not (tmp_path / "small.ply").exists()
    assert _keys(tmp_path) >= {"bounds.0", "count.0", "scatter-0.0", "pilot-0.0"}
    _go_on(source, tmp_path, result)


def test_a_run_that_is_killed_goes_on(source: Path, result: bytes, tmp_path: Path, stopped: Any) -> None:
    """While it is at work nobody else may be; what was damaged since is done again."""
    process = stopped("collapse", 0)
    second = subprocess.run(_words(source, tmp_path), capture_output=True, text=True, check=False)
    assert second.returncode == 1
    assert_one_line(second.stderr)
    assert "work is in use: another run works there" in second.stderr
    process.kill()
    process.wait()
    _wait_until(lambda: not _is_alive(int((tmp_path / "began").read_text())))
    assert "scatter-0.1" in _keys(tmp_path)
    first, *others = sorted((tmp_path / "work").glob("0.*.chunk"))
    data = bytearray(first.read_bytes())
    data[-1] ^= 1
    first.write_bytes(data)
    for chunk in others:
        chunk.unlink()
    with (tmp_path / "work" / "journal.jsonl").open("a") as file:
        file.write('{"key": "collapse-0.7", "va')  # it was killed while it wrote
    _go_on(source, tmp_path, result)


def test_a_folder_that_is_no_use_any_more_is_refused_by_name(source: Path, tmp_path: Path, stopped: Any) -> None:
    mine = tmp_path / "mine.ply"
    shutil.copy(source, mine)
    stopped("last_run", signal.SIGKILL).wait()
    (block, *_) = (tmp_path / "work").glob("*.block")
    block.write_bytes(block.read_bytes()[:-1])
    (tmp_path / "began").unlink()
    for words, said in (
        (_words(source, tmp_path), f"{block} is damaged or missing; remove the folder to begin anew"),
        (_words(source, tmp_path, "--feature-weight", "3"), "holds another run: feature_weight was 2 and is 3.0"),
        (_words(mine, tmp_path), "holds another run: input was"),
    ):
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        assert done.returncode == 1
        assert_one_line(done.stderr)
        assert said in done.stderr
    (tmp_path / "work" / "state.json").write_text("{")
    done = subprocess.run(_words(source, tmp_path), capture_output=True, text=True, check=False)
    assert "state.json is damaged; remove the folder to begin anew" in done.stderr


def test_an_input_with_another_time_is_read_again(source: Path, result: bytes, tmp_path: Path, stopped: Any) -> None:
    stopped("collapse", signal.SIGKILL).wait()
    before = source.stat()
    data = source.read_bytes()
    try:
        with source.open("r+b") as file:
            file.seek(data.index(b"end_header\n") + 11)
            file.write(b"\1")  # the last bits of a coordinate
        done = subprocess.run(_words(source, tmp_path), capture_output=True, text=True, check=False)
        assert done.returncode == 1
        assert "has changed since; remove the folder to begin anew" in done.stderr
    finally:
        source.write_bytes(data)
    os.utime(source, ns=(before.st_atime_ns, before.st_mtime_ns + 1))
    _go_on(source, tmp_path, result)


def test_a_disk_that_a_worker_finds_full_loses_nothing(source: Path, result: bytes, tmp_path: Path) -> None:
    environment = _environment(f"full collapse {tmp_path}")
    done = subprocess.run(_words(source, tmp_path), env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert_one_line(done.stderr)
    assert f"No space left on device; free space on the disk of {tmp_path / 'work'}" in done.stderr
    assert not list((tmp_path / "work").glob("*.part"))
    assert not (tmp_path / "small.ply").exists()
    assert _keys(tmp_path) >= {"bounds.0", "count.0", "scatter-0.0", "pilot-0.0"}
    _go_on(source, tmp_path, result)


def test_a_small_disk_is_named_before_and_while_it_fills(source: Path, result: bytes, tmp_path: Path) -> None:
    """The same with a real disk, which takes the right to mount one; the test above does without."""
    disk = tmp_path / "work"
    disk.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", disk], capture_output=True, check=False
    )
    if mounted.returncode:
        pytest.skip("mounting a small disk is not allowed here; the test above needs none")
    try:
        done = subprocess.run(_words(source, tmp_path), capture_output=True, text=True, check=False)
        assert done.returncode == 1
        assert_one_line(done.stderr)
        assert f"{disk} has not enough room: about 0.0" in done.stderr
        without_check = (
            "import sys; from laplacian_simplify.huge import work_folder, runs\n"
            "work_folder.WorkFolder.check_room = lambda *_: None\n"
            "from laplacian_simplify.command_line import main; sys.exit(main(sys.argv[1:]))"
        )
        subprocess.run(["mount", "-o", "remount,size=17000k", disk], check=True)
        words = _words(source, tmp_path)
        words[2:4] = ["-c", without_check]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        assert done.returncode == 1
        assert_one_line(done.stderr)
        assert f"No space left on device; free space on the disk of {disk}" in done.stderr
        assert "count.0" in _keys(tmp_path)
        subprocess.run(["mount", "-o", "remount,size=80m", disk], check=True)
        done = subprocess.run(_words(source, tmp_path), capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert (tmp_path / "small.ply").read_bytes() == result
    finally:
        subprocess.run(["umount", disk], check=True)


def test_a_scheduler_that_goes_away_loses_nothing(source: Path, result: bytes, tmp_path: Path) -> None:
    """The work goes on with workers of this machine."""
    with running_cluster(tmp_path / "dask", _environment(f"hang last_run {tmp_path}")) as (address, scheduler):
        _wait_until(lambda: has_workers(address))
        words = _words(source, tmp_path)
        words[words.index("--workers") : words.index("--workers") + 2] = ["--scheduler", address, "--memory", "1GiB"]
        process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
        _wait_until((tmp_path / "began").exists)
        scheduler.kill()
        said = process.communicate(timeout=120)[1]
        assert process.returncode == 1
        assert_one_line(said)
        assert "the scheduler is gone; what is done is kept in the work folder" in said
    assert "round-0" in _keys(tmp_path)
    _go_on(source, tmp_path, result)
