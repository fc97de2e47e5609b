# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compressed files, standard input and output, --in-place, and streams that are closed or full."""

import gzip
import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, assert_one_line, faces_in, run_command
from mesh_files import VOLUME, binary_stl, obj, off, ply
from reading_checks import assert_refused, names_in, reading_of, volume, write

FLANGE = SAMPLE_MESHES / "flange.ply"
COMMAND = [sys.executable, "-P", "-m", "laplacian_simplify"]


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("box.ply.gz", ply()),
        ("box.obj.GZ", obj()),
        ("box.off.gz", off()),
        ("box.stl.gz", binary_stl()),
        ("box.ply", ply()),
    ],
)
def test_compressed_files(name: str, content: bytes | str, tmp_path: Path) -> None:
    packed = gzip.compress(content if isinstance(content, bytes) else content.encode())
    assert volume(reading_of(tmp_path / name, packed)) == pytest.approx(VOLUME)
    assert_refused(tmp_path / name, packed[:-9], "it cannot be unpacked", "it is cut off or damaged")
    assert_refused(tmp_path / name, packed[:30] + b"?" + packed[31:])


def test_what_unpacks_to_more_than_a_mesh_can_be_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from laplacian_simplify.files import source

    monkeypatch.setattr(source, "_MOST_UNPACKED", 1 << 20)
    monkeypatch.setattr(source, "_MOST_GROWTH", 1)
    assert_refused(tmp_path / "zeros.ply.gz", gzip.compress(bytes(1 << 24)), "it unpacks to more than 1,048,576 bytes")


@pytest.mark.parametrize(
    ("name", "content"),
    [("a", ply()), ("a", binary_stl()), ("a", obj()), ("a", off()), ("mesh 1", ply(encoding="ascii"))],
)
def test_a_name_without_extension_is_read_by_its_content(name: str, content: bytes | str, tmp_path: Path) -> None:
    assert volume(reading_of(tmp_path / name, content)) == pytest.approx(VOLUME)


def test_a_name_without_extension_is_refused_by_name(tmp_path: Path) -> None:
    assert_refused(tmp_path / "mesh", "hello\n", f"{tmp_path}/mesh cannot be read: its name has no extension")


def _piped(content: bytes, *arguments: object, cwd: Path) -> "subprocess.CompletedProcess[bytes]":
    words = [*COMMAND, *map(str, arguments)]
    return subprocess.run(words, input=content, cwd=cwd, capture_output=True, timeout=300, check=False)


@pytest.mark.parametrize("output_format", [None, "ply", "stl"])
@pytest.mark.parametrize("content", [ply(), binary_stl(), gzip.compress(ply())], ids=["ply", "stl", "gz"])
def test_standard_input_and_output(content: bytes, output_format: str | None, tmp_path: Path) -> None:
    chosen = ["--output-format", output_format] if output_format else []
    done = _piped(content, "smooth", "-", "-", "--steps", "0", *chosen, cwd=tmp_path)
    if done.returncode == 2:  # the least number of steps is 1
        done = _piped(content, "simplify", "-", "-", "--faces", "12", *chosen, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stderr.startswith(b"standard input -> standard output in ")
    written = reading_of(tmp_path / f"out.{output_format or 'ply'}", done.stdout)
    assert volume(written) == pytest.approx(VOLUME)


def test_damage_on_standard_input_is_named(tmp_path: Path) -> None:
    done = _piped(ply()[:-1], "simplify", "-", "out.ply", "--percent", "50", cwd=tmp_path)
    assert done.returncode == 1
    assert_one_line(done.stderr.decode())
    assert b"standard input cannot be read: face 5: the file ends" in done.stderr
    done = _piped(b"hello", "simplify", "-", "out.ply", "--percent", "50", cwd=tmp_path)
    assert b"standard input cannot be read: it is none of PLY, STL" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("box.ply",), "OUTPUT is missing; --in-place writes to INPUT"),
        (("box.ply", "out.ply", "--in-place"), "--in-place writes to INPUT; leave OUTPUT out"),
        (("-", "--in-place"), "--in-place needs a file as INPUT"),
        (("box.ply", "-", "--json", "-"), "OUTPUT and --json are both -"),
        (("box.ply", "out.ply", "--json", "out.ply"), "--json out.ply is the file of OUTPUT"),
        (("box.ply", "out.ply", "--json", "./folder/../out.ply"), "is the file of OUTPUT"),
        (("box.ply", "out.ply", "--json", "link.ply"), "--json link.ply is the file of INPUT"),
        (("box.ply", "--in-place", "--json", "box.ply"), "is the file of OUTPUT"),
        (("box.ply", "out.ply", "--output-format", "stl"), "--output-format is for standard output"),
    ],
)
def test_files_that_do_not_go_together(arguments: tuple[str, ...], said: str, tmp_path: Path) -> None:
    write(tmp_path / "box.ply", ply())
    (tmp_path / "folder").mkdir()
    os.link(tmp_path / "box.ply", tmp_path / "link.ply")
    before = sorted(tmp_path.iterdir())
    done = run_command("simplify", *arguments, "--percent", "50", cwd=tmp_path)
    assert done.returncode == 2, done.stderr
    assert_one_line(done.stderr)
    assert said in done.stderr
    assert sorted(tmp_path.iterdir()) == before
    assert (tmp_path / "box.ply").read_bytes() == ply()


def test_in_place(tmp_path: Path) -> None:
    path = write(tmp_path / "mesh.ply", FLANGE.read_bytes())
    path.chmod(0o640)
    assert run_command("simplify", path, "--in-place", "--faces", 1000).returncode == 0
    assert faces_in(path) <= 1000
    assert path.stat().st_mode & 0o777 == 0o640
    assert list(tmp_path.iterdir()) == [path]


def test_in_place_of_what_cannot_be_written_is_refused(tmp_path: Path) -> None:
    write(tmp_path / "box.ply.gz", gzip.compress(ply()))
    done = run_command("simplify", "box.ply.gz", "--in-place", "--percent", "50", cwd=tmp_path)
    assert done.returncode == 1
    assert "box.ply.gz cannot be written: the format '.gz' is unknown" in done.stderr


@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&-", "<&- >&- 2>&-", ">/dev/full", "2>/dev/full"])
def test_closed_streams_change_nothing(closed: str, tmp_path: Path) -> None:
    words = ["sh", "-c", f'exec "$@" {closed}', "sh", *COMMAND, "simplify", str(FLANGE), "out.ply", "--faces", "1000"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert [path.name for path in tmp_path.iterdir()] == ["out.ply"]
    assert faces_in(tmp_path / "out.ply") <= 1000


def test_help_into_a_closed_pipe_ends_quietly() -> None:
    words = ["sh", "-c", '"$@" | true', "sh", *COMMAND, "simplify", "--help"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=300, check=False)
    assert done.stderr == ""


def test_names_that_are_not_utf8_are_written_as_they_are(tmp_path: Path) -> None:
    name = os.fsdecode(b"b\xf6x \x01.ply")
    write(tmp_path / name, ply())
    words = [*COMMAND, "simplify", name, os.fsdecode(b"kl\xe4in.obj"), "--faces", "12"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(b"b\xf6x \\x01.ply -> kl\xe4in.obj in ")
    assert names_in(tmp_path) == sorted(map(os.fsdecode, (b"b\xf6x \x01.ply", b"kl\xe4in.obj")))
    write(tmp_path / name, ply()[:-1])
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, timeout=300, check=False)
    assert done.stderr.startswith(b"laplacian-simplify: error: b\xf6x \\x01.ply cannot be read: face 5")


def test_a_pipe_and_a_device_are_no_files(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.ply")
    for path in (tmp_path / "pipe.ply", "/dev/zero"):
        done = run_command("simplify", path, tmp_path / "out.ply", "--percent", 50)
        assert done.returncode == 1
        assert_one_line(done.stderr)
        assert "is not a file but a device or a pipe; use - to read from standard input" in done.stderr
