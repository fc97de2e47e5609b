# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the workers busy: a mesh is handed out when it fits into what the others leave of the memory."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any
from uuid import uuid4

from distributed import Future, KilledWorker, as_completed

from ..files.errors import MeshFileError
from ..signals import signals_let_in
from ..workers.cluster import Workers
from ..workers.pool import Processes
from .inputs import MeshToDo
from .worker import PROCESS, MeshTask, do_mesh

Row = dict[str, Any]
Finish = Callable[[MeshToDo, Row], None]


@dataclass(frozen=True)
class Conditions:
    """What holds for every mesh of a run."""

    values: Mapping[str, Any]
    """Options of simplify."""
    staging: str
    memory: int
    """Bytes for all meshes that are worked on."""
    seconds: float
    """For each mesh."""


def do_all(meshes: list[MeshToDo], workers: Workers, conditions: Conditions, finish: Finish) -> None:
    """Does the meshes, large ones first, and calls finish for each with its line of the manifest.

    Raises:
        MeshFileError: the scheduler is gone.
        KeyboardInterrupt: a signal came. Processes that were at work are gone.
    """
    values = {"threads": workers.threads, **conditions.values}
    name = f"laplacian-simplify-{uuid4()}"
    run = _Run(name, workers, values, conditions, meshes, finish)
    workers.client.register_plugin(Processes(name, replace(PROCESS, threads=values["threads"] or workers.threads)))
    try:
        run.to_the_end()
    finally:
        if not run.is_lost:
            workers.client.unregister_worker_plugin(name)


class _Run:
    def __init__(
        self,
        name: str,
        workers: Workers,
        values: Mapping[str, Any],
        conditions: Conditions,
        meshes: list[MeshToDo],
        finish: Finish,
    ) -> None:
        self._name, self._workers, self._values, self._conditions = name, workers, values, conditions
        self._finish = finish
        self._waiting = sorted(meshes, key=lambda mesh: (-mesh.memory, mesh.name))
        self._at_work: dict[Future, MeshToDo] = {}
        self._done = as_completed(loop=workers.client.loop)
        self.is_lost = False

    def to_the_end(self) -> None:
        self._refuse_too_large()
        self._hand_out()
        while self._at_work:
            with signals_let_in():
                future = next(self._done)
            mesh = self._at_work.pop(future)
            self._finish(mesh, self._row(future))
            self._hand_out()

    def _refuse_too_large(self) -> None:
        allowed = self._conditions.memory
        for mesh in [mesh for mesh in self._waiting if mesh.memory > allowed]:
            self._waiting.remove(mesh)
            reason = f"it needs about {mesh.memory >> 20:,} MiB, and {allowed >> 20:,} are allowed; see --memory"
            self._finish(mesh, {"status": "refused", "tries": 0, "reason": reason, "again": True})

    def _hand_out(self) -> None:
        """Submits the largest that fit."""
        while len(self._at_work) < self._workers.slots:
            left = self._conditions.memory - sum(mesh.memory for mesh in self._at_work.values())
            mesh = next((mesh for mesh in self._waiting if mesh.memory <= left), None)
            if mesh is None:
                return
            self._waiting.remove(mesh)
            key = f"{self._name}-{mesh.target.stem if mesh.target.stem.isascii() else 'mesh'}-{uuid4()}"
            future = self._workers.client.submit(do_mesh, self._task(mesh), key=key, pure=False)
            self._at_work[future] = mesh
            self._done.add(future)

    def _task(self, mesh: MeshToDo) -> MeshTask:
        share = self._conditions.memory // self._workers.slots
        return MeshTask(
            name=mesh.name,
            source=str(mesh.source),
            target=str(mesh.target),
            staging=self._conditions.staging,
            values=dict(self._values),
            memory=min(self._conditions.memory, max(share, 2 * mesh.memory)),
            seconds=self._conditions.seconds,
            processes=self._name,
        )

    def _row(self, future: Future) -> Row:
        """What the worker answered, or what became of it."""
        if future.status == "finished":
            row: Row = future.result()
            return row
        if future.status == "error":
            error = future.exception()
            if isinstance(error, KilledWorker):
                return {"status": "crashed", "reason": "workers were lost again and again while they did it"}
            return {"status": "crashed", "reason": f"internal error: {type(error).__name__}: {error}"}
        self.is_lost = True
        raise MeshFileError("the scheduler is gone; what is done is kept, and the same command goes on")
