# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time, elapsed time and peak memory of one stretch of this process."""

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
