# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a process for blocks does: one task, named and with arguments of plain types, and what it took."""

import ctypes
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..child import Stage
from .collapse import Engine, Wanted, collapse, pilot, survey
from .finish import last_run, write_mesh
from .grid import Grid
from .measure import nearest, sample_result
from .scatter import count, scatter
from .source import open_source

Answer = dict[str, Any]


def bounds(folder: Path, source: str, begin: int, end: int) -> Answer:  # noqa: ARG001
    """The box of some vertices of the input."""
    found = open_source(source).bounds(begin, end)
    return {"low": found.low, "high": found.high, "read": found.checksum, "brightest": found.brightest}


TASKS: dict[str, Callable[..., Answer]] = {
    "bounds": bounds,
    "count": count,
    "scatter": scatter,
    "pilot": pilot,
    "survey": survey,
    "collapse": collapse,
    "last_run": last_run,
    "sample_result": sample_result,
    "nearest": nearest,
    "write_mesh": write_mesh,
}
_TYPES: dict[str, Callable[[Any], Any]] = {
    "folder": Path,
    "grid": lambda given: Grid((given[0], given[1], given[2]), given[3]),
    "engine": lambda given: Engine(**given),
    "wanted": lambda given: Wanted(**given),
}


def run(_stage: Stage, task: str, arguments: dict[str, Any]) -> Answer:
    """Does a task. Returns its answer with seconds of the processor, and the most memory that was taken."""
    started = time.process_time()
    given = {name: _TYPES.get(name, lambda value: value)(value) for name, value in arguments.items()}
    try:
        answer = TASKS[task](**given)
    finally:
        ctypes.CDLL(None).malloc_trim(0)  # what is free now is not held on to
    answer["processor_seconds"] = time.process_time() - started
    answer["peak_memory"] = _peak_memory()
    return answer


def _peak_memory() -> int:
    """Bytes that this process has taken at most. That of getrusage begins with those of the process that started it."""
    status = Path("/proc/self/status").read_text(encoding="ascii", errors="replace")
    return 1024 * int(status.partition("VmHWM:")[2].split()[0])
