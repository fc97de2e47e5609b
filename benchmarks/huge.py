# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh larger than memory: the command huge, with bounded memory, against simplify without a bound.

scripts/python benchmarks/huge.py [--faces N] [--percent P ...] [--memory SIZE] [--workers N] [--no-limit]

Every process of huge has an address space of that size (RLIMIT_AS); what simplify takes is printed beside it. Prints
processor seconds, largest process, distances, edges, and ratios to simplify. A busy machine changes no ratio but that
of processor seconds, by caches and by what the threads of simplify wait for each other.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from laplacian_simplify.workers.arguments import bytes_of

IN_MEMORY = """
import json, sys
import numpy as np
import laplacian_simplify as ls
from laplacian_simplify.huge.source import open_source

source = open_source(sys.argv[1])
chunk = source.chunk(0, source.faces)
options = {"target_percent": float(sys.argv[2]), "avoid_self_intersections": False}
result = ls.simplify(chunk.positions, chunk.triangles, **options)
print(json.dumps(result.report.to_dict()))
"""
ROWS = 256


def write_scan(path: Path, faces: int) -> int:
    """A closed torus with fractal relief, rough on one side and smooth on the other; in pieces. Returns its faces."""
    around, across = max(round((faces / 2) ** 0.5 * 1.4), 3), max(round((faces / 2) ** 0.5 / 1.4), 3)
    waves = np.random.default_rng(5).uniform(1, 2, (7, 4))
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {around * across}\nproperty float x\nproperty float y\n"
        f"property float z\nelement face {2 * around * across}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    with path.open("wb") as file:
        file.write(header.encode())
        for begin in range(0, around, ROWS):
            number = np.arange(begin, min(begin + ROWS, around))
            u, v = np.meshgrid(2 * np.pi * number / around, 2 * np.pi * np.arange(across) / across, indexing="ij")
            relief = 0.0
            for octave, (a, b, c, d) in enumerate(waves):
                k = 2**octave
                relief += 0.1 / 1.9**octave * np.sin(round(3 * a * k) * u + b) * np.sin(round(3 * c * k) * v + d)
            radius = 0.4 + relief * np.clip(0.55 - 0.6 * np.cos(u), 0.02, 1)
            ring = 1 + radius * np.cos(v)
            points = np.stack([ring * np.cos(u), ring * np.sin(u), radius * np.sin(v)], axis=-1)
            file.write(points.astype("<f4").tobytes())
        for begin in range(0, around, ROWS):
            number = np.arange(begin, min(begin + ROWS, around))
            index = number[:, None] * across + np.arange(across)
            right = (number[:, None] + 1) % around * across + np.arange(across)
            below, corner = np.roll(index, -1, axis=1), np.roll(right, -1, axis=1)
            rows = np.empty((len(number), across, 2), [("n", "u1"), ("v", "<i4", 3)])
            rows["n"] = 3
            rows["v"][:, :, 0] = np.stack([index, right, corner], axis=-1)
            rows["v"][:, :, 1] = np.stack([index, corner, below], axis=-1)
            file.write(rows.tobytes())
    return 2 * around * across


def measured(words: list[str], limit: int | None) -> tuple[str, float, float]:
    """What a command printed, its processor seconds, and MiB of its largest process."""

    def bound() -> None:
        if limit:
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen([sys.executable, "-P", *words], stdout=subprocess.PIPE, text=True, preexec_fn=bound)
    shown = process.communicate()[0]
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode:
        raise SystemExit(f"{' '.join(words)}: exit code {process.returncode}")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return shown, seconds, after.ru_maxrss / 1024


def show(name: str, report: dict[str, Any], seconds: float, largest: float) -> None:
    print(
        f"{name:<10} {report['faces']:>10,} faces  rms {report['rms']:.6f}  features {report['feature_rms']:.6f}  "
        f"largest {report['hausdorff']:.5f}  {report['non_manifold_edges']} non-manifold  "
        f"{report['boundary_edges']} boundary  {seconds:7.1f} processor s  {largest:6,.0f} MiB",
        flush=True,
    )


def compare(source: Path, percent: float, given: argparse.Namespace) -> None:
    """Both ways to one target."""
    limit = None if given.no_limit else bytes_of(given.memory)
    result = source.with_name("small.ply")
    words = ["-m", "laplacian_simplify", "huge", str(source), str(result), "--percent", str(percent), "--json", "-"]
    words.append("--no-avoid-self-intersections")  # which starts anew where faces cross: by chance in one or the other
    shown, seconds, _ = measured([*words, "--memory", given.memory, "--workers", str(given.workers)], limit)
    report = json.loads(shown)
    show("huge", report, seconds, report["peak_memory"] / (1 << 20))
    for row in report["rounds"]:
        print("  ", {name: value for name, value in row.items() if name != "descriptor_scale"})
    print("  ", {stage: round(value, 1) for stage, value in report["processor_seconds"].items()}, flush=True)
    shown, seconds_in_memory, largest = measured(["-c", IN_MEMORY, str(source), str(percent)], None)
    in_memory = json.loads(shown)
    show("in memory", in_memory, seconds_in_memory, largest)
    ratios = {name: report[name] / in_memory[name] for name in ("rms", "feature_rms", "hausdorff")}
    ratios["processor seconds"] = seconds / seconds_in_memory
    print("ratios    ", {name: round(value, 3) for name, value in ratios.items()}, flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--faces", type=int, default=17_000_000)
    parser.add_argument("--percent", type=float, nargs="+", default=[2, 10])
    parser.add_argument("--memory", default="2GiB")
    parser.add_argument("--workers", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--no-limit", action="store_true", help="of the address space")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="huge-benchmark-") as name:
        source = Path(name) / "scan.ply"
        print(f"{write_scan(source, given.faces):,} faces, {source.stat().st_size / 1e6:,.0f} MB", flush=True)
        for percent in given.percent:
            compare(source, percent, given)
    return 0


if __name__ == "__main__":
    sys.exit(main())
