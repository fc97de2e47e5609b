# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What runs in a Dask worker: a task for every mesh, and the process that does them.

The worker itself reads no mesh, so none can end it. Tasks answer with a status, never with an exception: Dask would
log it, and a remote one may not be known here.
"""

import contextlib
from dataclasses import dataclass
from pathlib import Path
from socket import gethostname
from tempfile import TemporaryDirectory
from typing import Any

from distributed import Worker, WorkerPlugin, get_worker

from ..files.errors import MeshFileError
from ..files.staging import staged_output
from .manifest import state_of
from .mesh_process import MeshProcess

_TRIES = 2


@dataclass(frozen=True)
class MeshTask:
    """What a worker is told of a mesh: only paths travel."""

    name: str
    source: str
    target: str
    staging: str
    """A folder on the disk of the target, for what is not whole yet."""
    values: dict[str, Any]
    memory: int
    """Bytes that the process may take for it."""
    seconds: float
    processes: str
    """Name of the plugin that has the processes."""


class MeshProcesses(WorkerPlugin):  # type: ignore[misc]
    """The processes of a worker, one for every thread of it."""

    def __init__(self, name: str, threads: int) -> None:
        self.name = name
        self._threads = threads

    def setup(self, worker: Worker) -> None:
        """Called in the worker when the run begins or the worker joins it."""
        self._scratch = TemporaryDirectory(prefix="meshes-", dir=worker.local_directory, ignore_cleanup_errors=True)
        self._idle: list[MeshProcess] = []
        self._busy: set[MeshProcess] = set()
        self._is_over = False

    def teardown(self, worker: Worker) -> None:  # noqa: ARG002
        """Called in the worker when the run ends: ends its processes, in the middle of a mesh, too."""
        self._is_over = True
        for process in self._idle:
            process.end()
        for process in list(self._busy):
            process.kill()
        self._idle.clear()
        self._scratch.cleanup()

    def run(self, job: dict[str, Any], seconds: float) -> dict[str, Any]:
        """Does a mesh in a process that is free, or in a new one."""
        if self._is_over:
            return {"status": "crashed", "reason": "the run was stopped"}
        process = self._idle.pop() if self._idle else MeshProcess(self._scratch.name, self._threads)
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


def do_mesh(task: MeshTask) -> dict[str, Any]:
    """One mesh, from its file to its result. Returns its line of the manifest."""
    processes = get_worker().plugins[task.processes]
    assert isinstance(processes, MeshProcesses)
    row: dict[str, Any] = {"status": "crashed", "tries": 0}
    while row["status"] == "crashed" and row["tries"] < _TRIES:
        row = {"tries": row["tries"] + 1, **_tried(task, processes)}
        if "cause" not in row:  # it took too long, and would again
            break
        row.pop("cause")
    return row


def _tried(task: MeshTask, processes: MeshProcesses) -> dict[str, Any]:
    state: dict[str, Any] = {}
    try:
        with contextlib.suppress(OSError):  # the process will say it better
            state = state_of(task.source)
        if not Path(task.staging).is_dir():
            raise MeshFileError(f"{task.staging} is not there on {gethostname()}: all workers need the same folders")
        Path(task.target).parent.mkdir(parents=True, exist_ok=True)
        with staged_output(task.target, source=task.source, folder=Path(task.staging)) as staged:
            answer = processes.run(_job(task, staged), task.seconds)
            if answer["status"] != "done":
                raise _NotDoneError(answer)
        return state | answer | {"output": task.target, "output_size": Path(task.target).stat().st_size}
    except _NotDoneError as failed:
        reason = str(failed.answer["reason"]).replace(task.source, task.name)
        return state | failed.answer | {"reason": reason}
    except Exception as error:  # the result could not be put into its place
        return state | {"status": "refused", "reason": str(error) or type(error).__name__, "again": True}


class _NotDoneError(Exception):
    def __init__(self, answer: dict[str, Any]) -> None:
        super().__init__()
        self.answer = answer


def _job(task: MeshTask, staged: Path) -> dict[str, Any]:
    return {
        "function": "simplify",
        "source": task.source,
        "staged": str(staged),
        "shown_source": task.name,
        "shown_target": task.target,
        "values": task.values,
        "memory": task.memory,
    }
