# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python runs this at its start where the folder is in PYTHONPATH: a task ends its process once, never ends, or finds
the disk full.

HUGE_HOOK is "kill TASK FOLDER", "hang TASK FOLDER" or "full TASK FOLDER"; the folder tells what has happened already.
"""

import errno
import os
import signal
import sys
import threading
from pathlib import Path

if "laplacian_simplify.workers.process" in " ".join(sys.orig_argv) and "HUGE_HOOK" in os.environ:
    from laplacian_simplify.huge import tasks

    plain = tasks.run
    action, at_task, folder = os.environ["HUGE_HOOK"].split()

    def disk_is_full(path, _target):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    def run(stage, task, arguments):
        marker = Path(folder) / "began"
        # Not the first one: there is something to keep.
        if task == at_task and arguments.get("block", 1) == 1 and not marker.exists():
            marker.write_text(str(os.getpid()))
            if action == "kill":
                os.kill(os.getpid(), signal.SIGKILL)
            if action == "hang":
                threading.Event().wait()
            Path.replace = disk_is_full
        return plain(stage, task, arguments)

    tasks.run = run
