# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has tasks done by Dask workers, as many at a time as the memory allows, and each only once.

A task whose answer is in the work folder, with its file, is not done again. One whose process is killed is.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any
from uuid import uuid4

from distributed import Future, KilledWorker, as_completed, get_worker

from ..files.errors import MeshFileError, printable
from ..signals import signals_let_in
from ..workers.cluster import Workers
from ..workers.pool import Processes
from ..workers.process import Kind
from .plan import block_memory
from .report import Progress
from .work_folder import SchedulerGoneError, WorkFolder

Answer = dict[str, Any]

_TRIES = 2
_NO_LIMIT = 1e9  # seconds
_LOST = "the scheduler is gone; what is done is kept in the work folder, and the same command goes on"


@dataclass(frozen=True)
class Task:
    """What one process does at a time."""

    function: str
    """Its name among the tasks."""
    arguments: Mapping[str, Any]
    """Of its own, of plain types."""
    memory: int = block_memory(0)
    """Bytes that it takes, about."""


def do_task(task: Task, folder: str, limit: int, processes: str) -> Answer:
    """Called in a Dask worker; tries again where the process was killed. Returns a status, never an exception."""
    pool = get_worker().plugins[processes]
    assert isinstance(pool, Processes)
    arguments = {"task": task.function, "arguments": {"folder": folder, **task.arguments}}
    job = {"function": "huge.tasks:run", "arguments": arguments, "memory": limit}
    answer: Answer = {}
    for _ in range(_TRIES):
        answer = pool.run(job, _NO_LIMIT)
        if answer["status"] != "crashed":
            break
    return answer


@dataclass
class Stages:
    """Does stages, one after the other."""

    workers: Workers
    work: WorkFolder
    memory: int
    """Bytes for all tasks at a time, or for each where the workers are on machines of their own."""
    is_shared: bool
    """Whether the workers share that memory."""
    progress: Progress
    name: str = field(default_factory=lambda: f"laplacian-simplify-{uuid4()}")
    is_lost: bool = False

    def __enter__(self) -> "Stages":
        self.workers.client.register_plugin(Processes(self.name, Kind(threads=1)))
        return self

    def __exit__(self, *_: object) -> None:
        if not self.is_lost:
            self.workers.client.unregister_worker_plugin(self.name)

    def do(self, stage: str, key: str, tasks: list[Task]) -> list[Answer]:
        """Does tasks of a stage and returns their answers in their order.

        Args:
            stage: its name for people.
            key: what the work folder keeps the answers under, with the number of the task.
            tasks: each writes a file of its own, if any.

        Raises:
            MeshFileError: one cannot be done, or the scheduler is gone.
            KeyboardInterrupt: a signal came. What is done is kept.
        """
        answers = [self._kept(f"{key}.{k}") for k in range(len(tasks))]
        waiting = sorted((k for k, answer in enumerate(answers) if answer is None), key=lambda k: (-tasks[k].memory, k))
        at_work: dict[Future, int] = {}
        done = as_completed(loop=self.workers.client.loop)
        self.progress(stage, len(tasks) - len(waiting), len(tasks))
        self._hand_out(tasks, waiting, at_work, done)
        while at_work:
            with signals_let_in():
                future = next(done)
            k = at_work.pop(future)
            answers[k] = answer = self._answer(future, stage) | {"stage": stage}
            self.work.add(f"{key}.{k}", answer)
            self.progress(stage, len(tasks) - len(waiting) - len(at_work), len(tasks))
            self._hand_out(tasks, waiting, at_work, done)
        return [answer for answer in answers if answer is not None]

    def _kept(self, key: str) -> Answer | None:
        answer: Answer | None = self.work.get(key)
        if answer is None or all(
            self.work.has(part) for part in (answer, answer.get("original")) if part and "file" in part
        ):
            return answer
        return None

    def _hand_out(self, tasks: list[Task], waiting: list[int], at_work: dict[Future, int], done: Any) -> None:
        """Submits the largest that fit; the first of all in any case."""
        while waiting and len(at_work) < self.workers.slots:
            left = self.memory - (sum(tasks[k].memory for k in at_work.values()) if self.is_shared else 0)
            k = next((k for k in waiting if tasks[k].memory <= left), None)
            if k is None and at_work:
                return
            k = waiting[0] if k is None else k
            waiting.remove(k)
            limit = max(
                self.memory // self.workers.slots if self.is_shared else 0, min(self.memory, 2 * tasks[k].memory)
            )
            future = self.workers.client.submit(
                do_task, tasks[k], str(self.work.path), limit, self.name, key=f"{self.name}-{uuid4()}", pure=False
            )
            at_work[future] = k
            done.add(future)

    def _answer(self, future: Future, stage: str) -> Answer:
        if future.status not in ("finished", "error"):
            self.is_lost = True
            raise SchedulerGoneError(_LOST)
        if future.status == "error":
            error = future.exception()
            lost = isinstance(error, KilledWorker)
            reason = "workers were lost again and again" if lost else f"internal error: {type(error).__name__}: {error}"
            raise MeshFileError(f"{stage}: {reason}")
        answer: Answer = future.result()
        if answer.pop("status") != "done":
            raise MeshFileError(printable(answer["reason"]))
        return answer

    def took(self) -> tuple[dict[str, float], int]:
        """Seconds of the processor a stage, and bytes of the largest process, in runs that were stopped, too."""
        seconds: dict[str, float] = {}
        peak = 0
        for answer in self.work.values():
            if isinstance(answer, dict) and "stage" in answer:
                seconds[answer["stage"]] = seconds.get(answer["stage"], 0) + answer["processor_seconds"]
                peak = max(peak, answer["peak_memory"])
        return seconds, peak
