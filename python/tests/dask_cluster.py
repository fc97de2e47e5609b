# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A scheduler on this machine with one worker, as somebody would start them by hand."""

import socket
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def running_cluster(folder: Path, environment: Mapping[str, str]) -> Iterator["tuple[str, subprocess.Popen[bytes]]"]:
    """Its address, and the process of the scheduler."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    port = address.rpartition(":")[2]
    dask = [sys.executable, "-P", "-m", "dask"]
    run = {"env": environment, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    scheduler = subprocess.Popen(
        [*dask, "scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard", "--dashboard-address", ":0"],
        **run,  # type: ignore[call-overload]
    )
    worker = subprocess.Popen(
        [*dask, "worker", address, "--nthreads", "1", "--no-dashboard", "--local-directory", str(folder)],
        **run,  # type: ignore[call-overload]
    )
    try:
        yield address, scheduler
    finally:
        for process in (worker, scheduler):
            process.terminate()
            process.wait(timeout=60)


def has_workers(address: str) -> bool:
    from distributed import Client

    try:
        with Client(address, timeout=5, set_as_default=False) as client:
            return bool(client.scheduler_info(n_workers=-1)["workers"])
    except OSError:
        return False
