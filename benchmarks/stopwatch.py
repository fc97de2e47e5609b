# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time, elapsed time and peak memory of one stretch of this process, and what else the machine did."""

import os
import resource
import time


def resident_bytes(key: str) -> int:
    """Linux's VmRSS (now) or VmHWM (peak) of this process."""
    with open("/proc/self/status", encoding="ascii") as status:
        for line in status:
            if line.startswith(key + ":"):
                return int(line.split()[1]) * 1024
    raise KeyError(key)


class Stopwatch:
    """Measures the block under `with`; the peak is counted above what was resident at its start."""

    def __init__(self):
        self.cpu_seconds = self.wall_seconds = 0.0
        self.peak_bytes = 0

    def __enter__(self):
        with open("/proc/self/clear_refs", "w", encoding="ascii") as references:
            references.write("5")  # resets the peak
        self._resident = resident_bytes("VmRSS")
        self._cpu, self._wall = time.process_time(), time.perf_counter()
        return self

    def __exit__(self, *_):
        self.cpu_seconds = time.process_time() - self._cpu
        self.wall_seconds = time.perf_counter() - self._wall
        self.peak_bytes = max(0, resident_bytes("VmHWM") - self._resident)


class Neighbours:
    """Measures under `with` how many cores others kept busy: all that Linux counts beyond this process's children."""

    def __init__(self):
        self.cores = 0.0

    def __enter__(self):
        self._busy, self._own, self._wall = _machine_seconds(), _children_seconds(), time.perf_counter()
        return self

    def __exit__(self, *_):
        others = (_machine_seconds() - self._busy) - (_children_seconds() - self._own)
        self.cores = max(0.0, others / (time.perf_counter() - self._wall))


def _machine_seconds() -> float:
    """Processor seconds of everything since the machine started: user, nice, system, interrupts, stolen."""
    with open("/proc/stat", encoding="ascii") as stat:
        counts = [int(count) for count in stat.readline().split()[1:9]]
    idle, waiting = counts[3:5]
    return (sum(counts) - idle - waiting) / os.sysconf("SC_CLK_TCK")


def _children_seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
