# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder in which a run keeps what it has done, so that the same command goes on after it was stopped.

``state.json`` says of what and how. ``journal.jsonl`` has a line of JSON for each task and round that is done, with the
size and checksum of its file. Files appear whole or not at all.
"""

import json
import os
import shutil
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

from ..files.errors import MeshFileError, printable
from ..files.journal import Journal
from ..files.staging import unwritable
from .array_file import is_whole

if TYPE_CHECKING:
    from typing_extensions import Self  # in typing from Python 3.11 on

STATE, JOURNAL = "state.json", "journal.jsonl"
SUFFIXES = (".counts", ".layout", ".chunk", ".block", ".points", ".distances")
"""Of the files with arrays."""


class SchedulerGoneError(MeshFileError):
    """Nobody does the work any more; what is done is kept."""


class WorkFolder:
    """The folder, locked as long as it is open."""

    def __init__(self, path: Path, state: Mapping[str, Any]) -> None:
        """Opens it, or makes it.

        Args:
            path: the folder.
            state: what has to be the same for a run that goes on, by names for people.

        Raises:
            MeshFileError: another run is at work there, or it belongs to something else, or it cannot be written.
        """
        self.path, self._shown = path, printable(path)
        self._values: dict[str, Any] = {}
        try:
            path.mkdir(parents=True, exist_ok=True)
            self._refuse_what_is_none()
        except MeshFileError:
            raise
        except OSError as error:
            raise unwritable(self._shown, error, path) from None
        busy = f"{self._shown} is in use: another run works there; wait for its end, or give another --work-folder"
        self._journal = Journal(path / JOURNAL, self._shown, busy)
        try:
            self._begin(dict(state))
        except BaseException:
            self._journal.close()
            raise

    def __enter__(self) -> "Self":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._journal.close()

    def get(self, key: str) -> Any:
        """What was written down under this key, or nothing."""
        return self._values.get(key)

    def add(self, key: str, value: Any) -> None:
        """Writes down that something is done.

        Raises:
            MeshFileError: there is no room for it.
        """
        self._values[key] = value
        self._journal.append({"key": key, "value": value})

    def values(self) -> list[Any]:
        """All that was written down."""
        return list(self._values.values())

    def forget(self, begin: str) -> None:
        """Has everything done again whose key begins so."""
        for key in [key for key in self._values if key.startswith(begin)]:
            del self._values[key]

    def has(self, written: Mapping[str, Any]) -> bool:
        """Whether a file is there as it was written."""
        return is_whole(self.path, written)

    def drop(self, *names: str) -> None:
        """Removes files that nobody needs any more."""
        for name in names:
            (self.path / name).unlink(missing_ok=True)

    def taken(self) -> int:
        """Bytes that are in it."""
        return sum(file.stat().st_size for file in self.path.iterdir() if file.is_file())

    def check_room(self, needed: int) -> None:
        """Refuses a disk that would be full before the end.

        Raises:
            MeshFileError: names the folder.
        """
        free = shutil.disk_usage(self.path).free + self.taken()
        if free < needed:
            raise MeshFileError(
                f"{self._shown} has not enough room: about {needed / 1e9:.3g} GB are needed, and {free / 1e9:.3g} GB "
                "are free; free some, or give another --work-folder"
            )

    def remove(self) -> None:
        """Removes what the run has made, and the folder if nothing else is in it."""
        self.drop(STATE)  # without it a run begins anew, whatever else is left where this one is killed
        for file in list(self.path.iterdir()):
            if file.suffix in (*SUFFIXES, ".part"):
                file.unlink(missing_ok=True)
        self.drop(JOURNAL)
        with suppress(OSError):
            self.path.rmdir()

    def _refuse_what_is_none(self) -> None:
        if any(self.path.iterdir()) and not (self.path / JOURNAL).exists():
            raise MeshFileError(f"{self._shown} is not empty and no work folder of huge; give another --work-folder")

    def _begin(self, state: dict[str, Any]) -> None:
        """Compares the state, and reads what is done."""
        path = self.path / STATE
        before = self._read_state(path)
        if before is None:
            self._journal.clear()
            self._write_state(path, state)
        for name in state:
            if before is not None and before.get(name) != state[name]:
                raise MeshFileError(
                    f"{self._shown} holds another run: {name} was {before.get(name)} and is {state[name]}; "
                    "remove the folder to begin anew, or give another --work-folder"
                )
        for file in self.path.glob("*.part"):  # of processes that were killed
            file.unlink(missing_ok=True)
        for row in self._journal.rows():
            with suppress(KeyError, TypeError):
                self._values[row["key"]] = row["value"]

    def _read_state(self, path: Path) -> Any:
        if not path.exists():
            return None
        try:
            found = json.loads(path.read_bytes())
            assert isinstance(found, dict)
        except (ValueError, AssertionError):
            raise MeshFileError(f"{printable(path)} is damaged; remove the folder to begin anew") from None
        return found

    def _write_state(self, path: Path, state: Mapping[str, Any]) -> None:
        part = path.with_name(f"{path.name}.{os.getpid()}.part")
        try:
            part.write_text(json.dumps(state, indent=1), encoding="utf-8")
            part.replace(path)
        except OSError as error:
            part.unlink(missing_ok=True)
            raise unwritable(printable(path), error, self.path) from None
