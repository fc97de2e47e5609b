# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The corpus through the filters in pymeshlab, in processes that may crash or hang: the next job goes on."""

import contextlib
import json
import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from hostile_meshes import HostileMesh
from settings import Setting

_DEADLINE = 120.0
"""Seconds by the clock after which a process hangs for something other than the processor."""


@dataclass(frozen=True)
class Run:
    """How one mesh got through one setting."""

    mesh: str
    setting: str
    kind: str
    """done, refused, not made or fault."""
    said: str
    seconds: float


class _Process:
    """host_process.py, started again after it ended."""

    def __init__(self, program: list[str]) -> None:
        self._program = program
        self._child: subprocess.Popen[str] | None = None

    def answer(self, mesh: int, setting: int) -> tuple[str, str, float]:
        start = time.monotonic()
        child = self._child = self._child or self._started()
        assert child.stdin and child.stdout
        with contextlib.suppress(BrokenPipeError):  # it has ended: there is no answer below
            child.stdin.write(f"{mesh} {setting}\n")
            child.stdin.flush()
        hangs = not select.select([child.stdout], [], [], _DEADLINE)[0]
        if hangs:
            child.kill()
        line = child.stdout.readline()
        if line:
            return tuple(json.loads(line))
        self._child = None
        code = child.wait()
        said = f"it did not end within {_DEADLINE:.0f} s" if hangs else _end_in_words(code)
        return "fault", said, time.monotonic() - start

    def _started(self) -> "subprocess.Popen[str]":
        pipe = subprocess.PIPE
        # As much memory and processor time on every machine: both grow with the threads.
        few = {"OMP_NUM_THREADS": "2", "OPENBLAS_NUM_THREADS": "1"}
        child = subprocess.Popen(self._program, stdin=pipe, stdout=pipe, text=True, env=os.environ | few)
        if child.stdout.readline() != "ready\n":
            raise RuntimeError(f"{self._program} does not start")
        return child

    def close(self) -> None:
        if self._child:
            self._child.stdin.close()
            self._child.wait()


def _end_in_words(code: int) -> str:
    if code == -signal.SIGXCPU:
        return "it took more processor time than it may"
    return f"the process ended by {signal.Signals(-code).name}" if code < 0 else f"the process ended with {code}"


def host_runs(
    meshes: list[HostileMesh],
    settings: list[Setting],
    jobs: Iterable[tuple[int, int]],
    program: list[str] | None = None,
) -> Iterator[Run]:
    """One process for all jobs, which are numbers of a mesh and of a setting. Program: in place of host_process.py."""
    own = [sys.executable, str(Path(__file__).with_name("host_process.py"))]
    process = _Process(program or own)
    try:
        for mesh, setting in jobs:
            answer = process.answer(mesh, setting)
            yield Run(meshes[mesh].name, settings[setting].name, *answer)
    finally:
        process.close()
