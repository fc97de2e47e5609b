# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The processes of a Dask worker, which itself reads no mesh, so none can end it."""

from tempfile import TemporaryDirectory
from typing import Any

from distributed import Worker, WorkerPlugin

from .process import Kind, WorkerProcess


class Processes(WorkerPlugin):  # type: ignore[misc]
    """The processes of a worker, one for every thread of it."""

    def __init__(self, name: str, kind: Kind) -> None:
        self.name = name
        self._kind = kind

    def setup(self, worker: Worker) -> None:
        """Called in the worker when the run begins or the worker joins it."""
        self._scratch = TemporaryDirectory(prefix="jobs-", dir=worker.local_directory, ignore_cleanup_errors=True)
        self._idle: list[WorkerProcess] = []
        self._busy: set[WorkerProcess] = set()
        self._is_over = False

    def teardown(self, worker: Worker) -> None:  # noqa: ARG002
        """Called in the worker when the run ends: ends its processes, in the middle of a job, too."""
        self._is_over = True
        for process in self._idle:
            process.end()
        for process in list(self._busy):
            process.kill()
        self._idle.clear()
        self._scratch.cleanup()

    def run(self, job: dict[str, Any], seconds: float) -> dict[str, Any]:
        """Does a job in a process that is free, or in a new one."""
        if self._is_over:
            return {"status": "crashed", "reason": "the run was stopped"}
        process = self._idle.pop() if self._idle else WorkerProcess(self._scratch.name, self._kind)
        self._busy.add(process)
        if self._is_over:  # the end may have come before it was among the busy ones
            process.kill()
        try:
            answer = process.run(job, seconds)
        finally:
            self._busy.discard(process)
        if answer["status"] == "crashed" or process.is_worn or self._is_over:
            process.end()
        else:
            self._idle.append(process)
        return answer
