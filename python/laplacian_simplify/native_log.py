# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What libraries below Python write to the standard streams, caught."""

import ctypes
import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

_C_LIBRARY = ctypes.CDLL(None)


class NativeLog:
    """Text that was written while caught_output was active."""

    text = ""


@contextmanager
def caught_output() -> Iterator[NativeLog]:
    """Keeps both standard streams of the process to itself; what was written is in the log afterwards.

    Works below Python, on the file descriptors, because pymeshlab writes there. Other threads that write
    meanwhile are caught too.
    """
    log = NativeLog()
    _flush()
    kept = os.dup(1), os.dup(2)
    with tempfile.TemporaryFile() as caught:
        os.dup2(caught.fileno(), 1)
        os.dup2(caught.fileno(), 2)
        try:
            yield log
        finally:
            _flush()
            os.dup2(kept[0], 1)
            os.dup2(kept[1], 2)
            os.close(kept[0])
            os.close(kept[1])
            caught.seek(0)
            log.text = caught.read().decode(errors="replace")


def _flush() -> None:
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.flush()
    _C_LIBRARY.fflush(None)
