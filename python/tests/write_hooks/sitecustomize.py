# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python runs this at its start where the folder is in PYTHONPATH: a process ends in the middle of a write, or before
it does something to a folder that is watched."""

import os
import signal
import sys
from pathlib import Path

# Only the process that the command starts: the limit on the size of files ends it, as no Python does by itself.
if "KILLED_WRITING" in os.environ and "laplacian_simplify.child" in " ".join(sys.orig_argv):
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)

# Only the command itself: what it asks of the system in a folder is counted, and at a number it is killed.
if "KILLED_AT" in os.environ and "laplacian_simplify.child" not in " ".join(sys.orig_argv):
    watched, last = os.environ["WATCHED"], int(os.environ["KILLED_AT"])
    asked = 0

    def count(event: str, arguments: tuple) -> None:
        global asked
        changes = event.startswith(("os.", "shutil.")) or (event == "open" and arguments[2] & (os.O_WRONLY | os.O_RDWR))
        if not changes or event in ("os.listdir", "os.scandir"):
            return
        paths = [str(argument) for argument in arguments if str(argument).startswith(watched + os.sep)]
        if not paths:
            return
        if asked == last:
            os.kill(os.getpid(), signal.SIGKILL)
        asked += 1
        if "ASKED" in os.environ:
            with Path(os.environ["ASKED"]).open("a") as file:
                print(event, *paths, sep="\t", file=file)

    sys.addaudithook(count)
