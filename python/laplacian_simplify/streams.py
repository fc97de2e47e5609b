# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The standard streams of the command, any of which may be closed or a full disk."""

import contextlib
import os
import sys
from typing import TextIO

from .files.errors import MeshFileError


def open_closed_streams() -> None:
    """Puts /dev/null in place of standard streams that are closed.

    Otherwise the next file that is opened gets the number of one of them, and what is meant for it.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # gets the lowest number, which is this one


def write_names_as_they_are() -> None:
    """Bytes of file names that are not UTF-8 are written as they came."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(AttributeError, OSError, ValueError):
            stream.reconfigure(errors="surrogateescape")  # type: ignore[union-attr]


def say(text: str) -> None:
    """A line on standard error; where that is closed there is nobody to tell."""
    _try_to_write(sys.stderr, text)


def show(text: str) -> None:
    """A line on standard output for people, who may have closed it."""
    _try_to_write(sys.stdout, text)


def write_out(data: bytes) -> None:
    """Bytes on standard output that were asked for.

    Raises:
        MeshFileError: they could not be written.
    """
    try:
        if sys.stdout is None:
            raise MeshFileError("standard output cannot be written: it is closed")
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()
    except (OSError, ValueError) as error:
        if isinstance(error, MeshFileError):
            raise
        raise MeshFileError(f"standard output cannot be written: {getattr(error, 'strerror', None) or error}") from None


def flush_or_drop() -> None:
    """Lets the process end without a complaint about what can no longer be written."""
    for number, stream in ((1, sys.stdout), (2, sys.stderr)):
        try:
            if stream is not None:
                stream.flush()
        except (OSError, ValueError):
            with contextlib.suppress(OSError):
                nowhere = os.open(os.devnull, os.O_WRONLY)
                os.dup2(nowhere, number)


def _try_to_write(stream: TextIO | None, text: str) -> None:
    if stream is None:
        return
    with contextlib.suppress(OSError, ValueError):
        print(text, file=stream, flush=True)
