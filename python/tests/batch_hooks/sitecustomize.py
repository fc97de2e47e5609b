# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python runs this at its start where the folder is in PYTHONPATH: meshes with certain names end their process."""

import os
import signal
import sys
import threading
from pathlib import Path

if "laplacian_simplify.workers.process" in " ".join(sys.orig_argv):
    from laplacian_simplify import work

    plain = work.run

    def run(stage, **job):
        source = Path(job["source"])
        marker = source.with_suffix(".began")
        is_first = not marker.exists()
        marker.write_text(str(os.getpid()))
        Path(job["staged"]).write_text("half of a mesh")
        stage("working")
        if source.stem == "killed" or (source.stem == "killed_once" and is_first):
            os.kill(os.getpid(), signal.SIGKILL)
        if source.stem == "ends_the_worker_once" and is_first:
            os.kill(os.getppid(), signal.SIGKILL)
        if source.stem == "hangs":
            threading.Event().wait()
        return plain(stage, **job)

    work.run = run
