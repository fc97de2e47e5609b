# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplifies the meshes of a folder: what the command batch and simplify_many do."""

import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..files.errors import printable
from ..files.staging import unwritable
from ..plugin import require_pymeshlab
from .inputs import MeshToDo, find_meshes
from .manifest import Manifest

_STAGING = ".laplacian-simplify-batch"

Began = Callable[[int, str], None]
"""Called with how many meshes there are to do, and the address of the dashboard, which may be empty."""
Finished = Callable[[Mapping[str, Any]], None]
"""Called with every new line of the manifest."""


@dataclass(frozen=True, kw_only=True)
class BatchRequest:
    """What is asked for."""

    source: str
    """A folder or a pattern."""
    output: Path
    values: Mapping[str, Any]
    """Options of simplify that were given, checked."""
    output_format: str | None = None
    workers: int | None = None
    scheduler: str | None = None
    memory: int | None = None
    """Bytes for all meshes that are worked on at a time."""
    seconds: float = 600
    """For each mesh."""
    retry_refused: bool = False


@dataclass(frozen=True, kw_only=True)
class BatchReport:
    """What became of the meshes."""

    meshes: list[dict[str, Any]] = field(repr=False)
    """Lines of the manifest about those that were worked on in this run."""
    skipped: list[dict[str, Any]] = field(repr=False)
    """Lines about those that were there already, and about those that will be refused again."""

    def count(self, status: str) -> int:
        """How many were done, refused or crashed in this run."""
        return sum(row["status"] == status for row in self.meshes)

    @property
    def all_done(self) -> bool:
        """Whether every mesh has its result."""
        return all(row["status"] == "done" for row in (*self.meshes, *self.skipped))

    def __str__(self) -> str:
        counts = ", ".join(f"{self.count(status):,} {status}" for status in ("done", "refused", "crashed"))
        return f"{counts}, {len(self.skipped):,} skipped"


def simplify_folder(request: BatchRequest, began: Began, finished: Finished) -> BatchReport:
    """Simplifies what is not done yet.

    Raises:
        ValueError: there are no meshes, or arguments do not fit together.
        OSError: nothing can be written, another run writes there, or the scheduler is missing or gone.
        KeyboardInterrupt: a signal came; what is done is kept, and nothing else is left.
    """
    output = request.output.absolute()
    found = find_meshes(request.source, output, request.output_format)
    _make(output)
    report = BatchReport(meshes=[], skipped=[])
    with Manifest(output, version("laplacian-simplify"), request.values) as manifest:
        waiting = []
        for mesh in found:
            if manifest.is_current(mesh, request.retry_refused):
                report.skipped.append(manifest.rows[mesh.name])
            else:
                waiting.append(mesh)

        def finish(mesh: MeshToDo, row: dict[str, Any]) -> None:
            report.meshes.append(manifest.add(mesh, row))
            finished(report.meshes[-1])

        if waiting:
            with _staging(output) as staging:
                _do(request, waiting, staging, lambda link: began(len(waiting), link), finish)
    return report


def _do(
    request: BatchRequest, waiting: list[MeshToDo], staging: str, began: Callable[[str], None], finish: Any
) -> None:
    try:
        from ..workers.cluster import local_workers, workers_of
        from .scheduling import Conditions, do_all
    except ModuleNotFoundError as missing:
        raise ImportError(
            f"batch needs Dask, of which {missing.name} is not installed: "
            "python -m pip install 'laplacian-simplify[batch]'"
        ) from None

    require_pymeshlab()
    with TemporaryDirectory(prefix="laplacian-simplify-", ignore_cleanup_errors=True) as scratch:
        address = request.scheduler
        with workers_of(address) if address else local_workers(request.workers, scratch) as workers:
            began(workers.dashboard)
            memory = request.memory or workers.memory
            do_all(waiting, workers, Conditions(request.values, staging, memory, request.seconds), finish)


def _make(output: Path) -> None:
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(printable(output), error, output.parent) from None


@contextmanager
def _staging(output: Path) -> Iterator[str]:
    """A folder for results that are not whole yet; one that a killed run has left is cleared."""
    folder = output / _STAGING
    shutil.rmtree(folder, ignore_errors=True)
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise unwritable(printable(output), error, output) from None
    try:
        yield str(folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
