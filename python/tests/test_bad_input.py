# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are no usable mesh end with exit code 1, one line that says why, and no output."""

from pathlib import Path

import pytest
from bad_files import bad_files, write_bad_file
from conftest import assert_one_line, faces_in, run_command

import laplacian_simplify as ls


@pytest.mark.parametrize("name", sorted(bad_files()))
def test_bad_file_is_named_and_leaves_nothing(name: str, tmp_path: Path) -> None:
    source = write_bad_file(name, tmp_path)
    target = tmp_path / "output" / "small.ply"
    target.parent.mkdir()
    done = run_command("simplify", source, target, "--percent", 50)
    assert done.returncode == 1, done.stderr
    assert_one_line(done.stderr)
    assert bad_files()[name][1] in done.stderr
    assert done.stdout == ""
    assert list(target.parent.iterdir()) == []


def test_missing_file(tmp_path: Path) -> None:
    done = run_command("simplify", tmp_path / "missing.ply", tmp_path / "small.ply", "--percent", 50)
    assert done.returncode == 1
    assert_one_line(done.stderr)
    assert f"{tmp_path / 'missing.ply'} does not exist" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_folder_as_input(tmp_path: Path) -> None:
    done = run_command("simplify", tmp_path, tmp_path / "small.ply", "--percent", 50)
    assert done.returncode == 1
    assert "is not a file" in done.stderr


@pytest.mark.parametrize("name", ["cut_in_faces.ply", "nan.ply", "wrong_index.off", "cut.off", "wrong_index.obj"])
def test_the_function_raises_what_the_command_says(name: str, tmp_path: Path) -> None:
    with pytest.raises(OSError, match=bad_files()[name][1]):
        ls.simplify(write_bad_file(name, tmp_path), target_percent=50)


def test_usable_rarities_are_read(tmp_path: Path) -> None:
    """What looks like a fault but is none: comments, counts on the first line, a missing material file."""
    off = tmp_path / "comments.off"
    off.write_text("OFF 4 2 0 # counts\n\n0 0 0\n1 0 0 # corner\n1 1 0\n0 1 0\n3 0 1 2\n\n3 0 2 3\n")
    assert faces_in(off) == 2
    obj = tmp_path / "no_material.obj"
    obj.write_text("mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -4 -3 -2\n")
    assert faces_in(obj) == 3
