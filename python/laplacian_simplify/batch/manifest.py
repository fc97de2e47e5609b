# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What was made of which file with which options: a line of JSON for every mesh, in the folder of the results.

Its lines are only ever added; of several about one input the last one counts. While a run goes on it holds a lock on
the file, so that there is one run in a folder at a time, and it is gone when the run ends, however that happens.
"""

import hashlib
import json
import os
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

from ..files.errors import printable
from ..files.journal import Journal
from .inputs import MeshToDo

if TYPE_CHECKING:
    from typing_extensions import Self  # in typing from Python 3.11 on

MANIFEST = "laplacian-simplify.jsonl"

_AT_ONCE = 1 << 20
"""Bytes of a file that are read at a time."""
# They change nothing in a result.
_WITHOUT_EFFECT = ("threads",)


class Manifest:
    """The manifest of a folder, locked as long as it is open."""

    def __init__(self, folder: Path, version: str, values: Mapping[str, Any]) -> None:
        """Opens it.

        Args:
            version: of this package.
            values: options of simplify that were given.

        Raises:
            MeshFileError: another run has it, or it cannot be written.
        """
        self.path = folder / MANIFEST
        asked = {name: value for name, value in values.items() if name not in _WITHOUT_EFFECT}
        self.options = hashlib.sha256(json.dumps([version, asked], sort_keys=True).encode()).hexdigest()[:16]
        self._journal = Journal(
            self.path,
            printable(self.path),
            f"{printable(folder)} is in use: another batch writes into it; wait for its end, or write elsewhere",
        )
        self.rows: dict[str, dict[str, Any]] = {}
        for row in self._journal.rows():
            with suppress(KeyError, TypeError):
                self.rows[row["input"]] = row

    def __enter__(self) -> "Self":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._journal.close()

    def is_current(self, mesh: MeshToDo, retry_refused: bool) -> bool:
        """Whether what the manifest says of the mesh would be said again."""
        row = self.rows.get(mesh.name)
        if row is None or row.get("options") != self.options:
            return False
        if row.get("status") == "refused":
            return not retry_refused and not row.get("again") and _is_unchanged(mesh.source, row)
        return row.get("status") == "done" and _has_its_output(mesh.target, row) and _is_unchanged(mesh.source, row)

    def add(self, mesh: MeshToDo, row: Mapping[str, Any]) -> dict[str, Any]:
        """Writes the line of a mesh and returns what is in it.

        Raises:
            MeshFileError: it cannot be written.
        """
        line = {"input": mesh.name, "options": self.options, **row}
        self._journal.append(line)
        self.rows[mesh.name] = line
        return line


def state_of(path: str | os.PathLike[str]) -> dict[str, Any]:
    """What tells a file from its later versions.

    Raises:
        OSError: it cannot be read, or is a pipe, which would never end.
    """
    status = Path(path).stat()
    if not stat.S_ISREG(status.st_mode):
        raise OSError(f"{path} is not a file")
    with Path(path).open("rb") as file:
        digest = hashlib.sha256()
        while part := file.read(_AT_ONCE):
            digest.update(part)
    return {"size": status.st_size, "mtime_ns": status.st_mtime_ns, "sha256": digest.hexdigest()}


def _is_unchanged(path: Path, row: Mapping[str, Any]) -> bool:
    """By size and time, else by its bytes."""
    try:
        status = path.stat()
        if status.st_size != row.get("size"):
            return False
        return status.st_mtime_ns == row.get("mtime_ns") or state_of(path)["sha256"] == row.get("sha256")
    except OSError:
        return False


def _has_its_output(path: Path, row: Mapping[str, Any]) -> bool:
    try:
        return row.get("output") == str(path) and path.stat().st_size == row.get("output_size")
    except OSError:
        return False
