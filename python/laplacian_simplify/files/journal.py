# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A file to which a run adds a line of JSON for everything that is done, and which one run has at a time."""

import fcntl
import json
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from .errors import MeshFileError, printable
from .staging import unwritable


class Journal:
    """The file, locked as long as it is open. The lock is gone when the run ends, however that happens."""

    def __init__(self, path: Path, shown: str, busy: str) -> None:
        """Opens it, or makes it.

        Args:
            path: the file.
            shown: what cannot be written where it cannot be opened.
            busy: what to say where another run has it.

        Raises:
            MeshFileError: another run has it, or it cannot be written.
        """
        self.path = path
        try:
            self._file = path.open("a+b")
        except OSError as error:
            raise unwritable(shown, error, path.parent) from None
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self.close()
            raise MeshFileError(busy) from None
        except OSError as error:
            self.close()
            raise unwritable(shown, error, path.parent) from None

    def close(self) -> None:
        """Closes it. What could not be written was said before, and closing has nothing to add."""
        with suppress(OSError):
            self._file.close()

    def clear(self) -> None:
        """Removes all lines."""
        self._file.truncate(0)

    def rows(self) -> list[Any]:
        """What its lines hold, but for one of a run that was killed while it wrote."""
        self._file.seek(0)
        text = self._file.read()
        found = []
        for line in text.splitlines():
            with suppress(ValueError):
                found.append(json.loads(line))
        if text and not text.endswith(b"\n"):
            self._file.write(b"\n")
        return found

    def append(self, row: Mapping[str, Any]) -> None:
        """Adds a line.

        Raises:
            MeshFileError: it cannot be written.
        """
        try:
            self._file.write(json.dumps(row).encode() + b"\n")
            self._file.flush()
        except OSError as error:
            raise unwritable(printable(self.path), error, self.path.parent) from None
