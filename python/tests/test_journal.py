# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The file of lines in which batch and huge write down what is done."""

import errno
import fcntl
import os
from pathlib import Path

import pytest

from laplacian_simplify.batch.inputs import MeshToDo
from laplacian_simplify.batch.manifest import Manifest
from laplacian_simplify.files.errors import MeshFileError
from laplacian_simplify.files.journal import Journal
from laplacian_simplify.huge.work_folder import WorkFolder


def test_a_line_that_is_not_whole_ends_where_the_next_begins(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    path.write_bytes(b'{"a": 1}\n\xff\n{"b')
    for expected in ([{"a": 1}], [{"a": 1}, {"c": 2}]):
        journal = Journal(path, "journal", "busy")
        assert journal.rows() == expected
        journal.append({"c": 2})
        journal.close()


def test_only_another_run_is_another_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Some file systems have no locks."""
    first = Journal(tmp_path / "journal", "journal", "another run has it")
    with pytest.raises(MeshFileError, match=r"^another run has it$"):
        Journal(tmp_path / "journal", "journal", "another run has it")
    first.close()

    def without_locks(*_: object) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", without_locks)
    with pytest.raises(MeshFileError, match=r"^journal cannot be written: No locks available"):
        Journal(tmp_path / "journal", "journal", "another run has it")


def _fill_up(folder: WorkFolder | Manifest) -> None:
    """Adds a line that finds the disk full."""
    with folder:
        folder._journal._file.close()
        folder._journal._file = Path("/dev/full").open("r+b")  # noqa: SIM115
        if isinstance(folder, WorkFolder):
            folder.add("count.0", {})
        else:
            folder.add(MeshToDo("mesh", Path("mesh"), Path("mesh"), 1), {"status": "done"})


@pytest.mark.parametrize("kind", ["huge", "batch"])
def test_a_full_disk_is_said_by_name(kind: str, tmp_path: Path) -> None:
    """Closing the file tries once more to write what could not be written, and fails again."""
    folder = WorkFolder(tmp_path, {}) if kind == "huge" else Manifest(tmp_path, "1", {})
    said = f"^{folder._journal.path} cannot be written: No space left on device; free space on the disk of {tmp_path}"
    with pytest.raises(MeshFileError, match=said):
        _fill_up(folder)
    assert folder._journal._file.closed
