# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Dask workers of a run: of this process, or those of a scheduler somewhere else."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import dask
from dask.system import CPU_COUNT
from distributed import Client, LocalCluster
from distributed.system import MEMORY_LIMIT

from ..files.errors import MeshFileError, printable

_SHARE_OF_MEMORY = 0.75
_SECONDS_TO_CONNECT = 10
_COMPARED = ("python", "distributed", "laplacian_simplify")
_QUIET = {  # what Dask looks at many times a second, which takes a twelfth of a processor as long as a run lasts
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500ms",
    "distributed.admin.system-monitor.interval": "2s",
    "distributed.admin.system-monitor.gil.enabled": False,
}


@dataclass(frozen=True)
class Workers:
    """Where tasks are sent."""

    client: Client
    slots: int
    """Jobs that are worked on at a time."""
    memory: int
    """Bytes for all of them, where nobody says how many."""
    memory_of_one: int
    """Bytes for one of them, where it is the only one at work."""
    threads: int
    """For each job, where nobody says how many."""
    dashboard: str
    """Address of a page that shows the work; empty without bokeh."""


@contextmanager
def local_workers(count: int | None, scratch: str) -> Iterator[Workers]:
    """Workers of this process, one a processor where no number is given.

    They are threads, as the jobs are done in processes of their own.
    """
    count = count or CPU_COUNT
    settings = {"temporary-directory": scratch, "distributed.scheduler.work-stealing": False, **_QUIET}
    with (
        _silence(),
        dask.config.set(settings),
        LocalCluster(
            n_workers=count,
            threads_per_worker=1,
            processes=False,
            memory_limit=0,  # each process has its own
            dashboard_address="127.0.0.1:0",  # without one it would take a certain port, and say so where it is taken
            silence_logs=logging.CRITICAL,
        ) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        memory = int(_SHARE_OF_MEMORY * MEMORY_LIMIT)
        dashboard = client.dashboard_link if find_spec("bokeh") else ""
        yield Workers(client, count, memory, memory, max(CPU_COUNT // count, 1), dashboard)


@contextmanager
def workers_of(address: str) -> Iterator[Workers]:
    """The workers of a scheduler, once they have turned out to have the versions of this process.

    Raises:
        MeshFileError: there is no scheduler, it has no workers, or one of them has another version.
    """
    with _silence():
        try:
            client = Client(address, set_as_default=False, timeout=_SECONDS_TO_CONNECT)
        except (OSError, ValueError) as error:
            raise MeshFileError(f"no scheduler answers at {printable(address)} ({error})") from None
        with client:
            _compare_versions(client, address)
            info = client.scheduler_info(n_workers=-1)["workers"].values()
            limits = [worker["memory_limit"] or MEMORY_LIMIT for worker in info]
            slots = sum(worker["nthreads"] for worker in info)
            link = client.dashboard_link or ""
            memory, memory_of_one = (int(_SHARE_OF_MEMORY * number) for number in (sum(limits), min(limits)))
            yield Workers(client, slots, memory, memory_of_one, 1, link)


def _compare_versions(client: Client, address: str) -> None:
    found = client.get_versions(check=False, packages=["laplacian_simplify"])
    if not found["workers"]:
        raise MeshFileError(f"the scheduler at {printable(address)} has no workers")
    own = _versions(found["client"])
    for worker, packages in found["workers"].items():
        theirs = _versions(packages)
        for name in _COMPARED:
            if theirs[name] != own[name]:
                raise MeshFileError(
                    f"the worker at {worker} has {name} {theirs[name] or 'not installed'}, this machine {own[name]}; "
                    "install the same versions everywhere"
                )


def _versions(found: dict[str, Any]) -> dict[str, str | None]:
    packages = found["packages"]
    versions = {name: packages.get(name) for name in _COMPARED}
    versions["python"] = ".".join(str(packages["python"]).split(".")[:2])
    return versions


@contextmanager
def _silence() -> Iterator[None]:
    """What Dask has to say goes into the result of the run, not onto the terminal."""
    logger = logging.getLogger("distributed")
    before = logger.level
    children = [logging.getLogger(name) for name in list(logging.root.manager.loggerDict) if "distributed." in name]
    levels = [(child, child.level) for child in children]
    for one in (logger, *children):
        one.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        logger.setLevel(before)
        for child, level in levels:
            child.setLevel(level)
