# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What runs in a Dask worker: a task for every mesh.

The worker itself reads no mesh, so none can end it. Tasks answer with a status, never with an exception: Dask would
log it, and a remote one may not be known here.
"""

import contextlib
from dataclasses import dataclass
from pathlib import Path
from socket import gethostname
from typing import Any

from distributed import get_worker

from ..files.errors import MeshFileError
from ..files.staging import staged_output
from ..workers.pool import Processes
from ..workers.process import Kind
from .manifest import state_of

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


PROCESS = Kind(
    threads=1,
    prepare="plugin:load",
    doing={"reading": "reading it", "working": "simplifying it", "writing": "writing its result"},
)


def do_mesh(task: MeshTask) -> dict[str, Any]:
    """One mesh, from its file to its result. Returns its line of the manifest."""
    processes = get_worker().plugins[task.processes]
    assert isinstance(processes, Processes)
    row: dict[str, Any] = {"status": "crashed", "tries": 0}
    while row["status"] == "crashed" and row["tries"] < _TRIES:
        row = {"tries": row["tries"] + 1, **_tried(task, processes)}
        if "cause" not in row:  # it took too long, and would again
            break
        row.pop("cause")
    return row


def _tried(task: MeshTask, processes: Processes) -> dict[str, Any]:
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
    arguments = {
        "function": "simplify",
        "source": task.source,
        "staged": str(staged),
        "shown_source": task.name,
        "shown_target": task.target,
        "values": task.values,
    }
    return {"function": "work:run", "arguments": arguments, "memory": task.memory}
