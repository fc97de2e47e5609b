# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What batch and simplify_many take, refuse and find."""

import shutil
import threading
from pathlib import Path
from typing import Any

import pytest
from batch_runs import write_sheet
from conftest import assert_one_line, run_command

import laplacian_simplify as ls
from laplacian_simplify.batch.inputs import find_meshes
from laplacian_simplify.batch.worker import PROCESS
from laplacian_simplify.workers.arguments import bytes_of
from laplacian_simplify.workers.process import WorkerProcess

pytest.importorskip("distributed")


def test_simplify_many_in_a_thread(tmp_path: Path) -> None:
    write_sheet(tmp_path / "meshes" / "large.off", 40)
    write_sheet(tmp_path / "meshes" / "small.off", 8)
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


def test_a_bound_that_ends_a_run_misses_no_target(tmp_path: Path) -> None:
    """A percentage beside it, which would have been below, is no more than a wish."""
    write_sheet(tmp_path / "meshes" / "sheet.off", 12)
    for words in (("--max-error", "0.01%"), ("--percent", "2", "--max-error", "0.01%")):
        done = run_command("batch", tmp_path / "meshes", tmp_path / "out", *words)
        assert done.returncode == 0, done.stderr
        assert done.stdout.startswith("done              1 ")
        assert "NOT reached" not in done.stdout


def test_a_warning_that_was_said_ends_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_sheet(tmp_path / "meshes" / "sheet.off", 20)
    monkeypatch.setenv("PYTHONWARNINGS", "error::UserWarning")
    for command, source, output in (
        ("simplify", tmp_path / "meshes" / "sheet.off", tmp_path / "out.off"),
        ("batch", tmp_path / "meshes", tmp_path / "out"),
    ):
        done = run_command(command, source, output, "--percent", "0.5")
        assert done.returncode == 0, done.stdout + done.stderr
        assert done.stderr.count("to keep the fraction 0.5 of them") == 1


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
    write_sheet(tmp_path / "sheet.off", 150)
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
