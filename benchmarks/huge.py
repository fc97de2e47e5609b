# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh larger than memory: the command huge, with bounded memory, against simplify without a bound.

scripts/python benchmarks/huge.py [--faces N] [--scene scan|beside] [--percent P ...] [--memory SIZE] [--workers N]
    [--no-limit] [--guard]

The scan is a torus with fractal relief; beside it there is, in the scene of that name, one as large and as finely
divided that has flat sides like a machined part. With --guard faces that cross are avoided, as is the default of both
commands. Every process of huge has an address space of that size (RLIMIT_AS); what simplify takes is printed beside it.
Prints processor seconds, largest process, distances, edges, and ratios to simplify. A busy machine changes no ratio
but that of processor seconds, by caches and by what the threads of simplify wait for each other.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from laplacian_simplify.workers.arguments import bytes_of

Array: TypeAlias = np.ndarray[Any, Any]
IN_MEMORY = """
import json, sys
import numpy as np
import laplacian_simplify as ls
from laplacian_simplify.huge.source import open_source

source = open_source(sys.argv[1])
chunk = source.chunk(0, source.faces)
options = {"target_percent": float(sys.argv[2]), "avoid_self_intersections": sys.argv[3] == "guard"}
result = ls.simplify(chunk.positions, chunk.triangles, **options)
print(json.dumps(result.report.to_dict()))
"""
ROWS = 256


def scan(u: Array, v: Array) -> Array:
    """A torus with fractal relief, rough on one side and smooth on the other."""
    relief = np.zeros(u.shape)
    for octave, (a, b, c, d) in enumerate(np.random.default_rng(5).uniform(1, 2, (7, 4))):
        k = 2**octave
        relief += 0.1 / 1.9**octave * np.sin(round(3 * a * k) * u + b) * np.sin(round(3 * c * k) * v + d)
    return on_torus(u, v, 0.4 + relief * np.clip(0.55 - 0.6 * np.cos(u), 0.02, 1))


def part(u: Array, v: Array) -> Array:
    """A ring of twelve flat sides whose section is a square, beside the scan."""
    side = np.pi / 6
    ring = np.cos(side / 2) / np.cos(np.mod(u, side) - side / 2)
    section = 0.35 / np.maximum(np.abs(np.cos(v)), np.abs(np.sin(v)))
    points = on_torus(u, v, section)
    points[..., :2] *= ring[..., None]
    return points + np.array([4, 0, 0])


def on_torus(u: Array, v: Array, radius: Array) -> Array:
    ring = 1 + radius * np.cos(v)
    return np.stack([ring * np.cos(u), ring * np.sin(u), radius * np.sin(v)], axis=-1)


SCENES = {"scan": (scan,), "beside": (scan, part)}


def write_mesh(path: Path, scene: str, faces: int) -> int:
    """Closed surfaces, some rows at a time. Returns how many faces they have together."""
    surfaces = SCENES[scene]
    each = faces / len(surfaces)
    around, across = max(round((each / 2) ** 0.5 * 1.4), 3), max(round((each / 2) ** 0.5 / 1.4), 3)
    vertices = around * across
    total = 2 * vertices * len(surfaces)
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {vertices * len(surfaces)}\nproperty float x\n"
        f"property float y\nproperty float z\nelement face {total}\nproperty list uchar int vertex_indices\n"
        "end_header\n"
    )
    pieces = [np.arange(begin, min(begin + ROWS, around)) for begin in range(0, around, ROWS)]
    with path.open("wb") as file:
        file.write(header.encode())
        for surface in surfaces:
            for rows in pieces:
                u, v = np.meshgrid(2 * np.pi * rows / around, 2 * np.pi * np.arange(across) / across, indexing="ij")
                file.write(surface(u, v).astype("<f4").tobytes())
        for k in range(len(surfaces)):
            for rows in pieces:
                file.write(faces_of_rows(rows, around, across, k * vertices).tobytes())
    return total


def faces_of_rows(rows: Array, around: int, across: int, first: int) -> Array:
    """As the file has them, of vertices that are numbered from the first one on."""
    index = first + rows[:, None] * across + np.arange(across)
    right = first + (rows[:, None] + 1) % around * across + np.arange(across)
    below, corner = np.roll(index, -1, axis=1), np.roll(right, -1, axis=1)
    faces = np.empty((len(rows), across, 2), [("n", "u1"), ("v", "<i4", 3)])
    faces["n"] = 3
    faces["v"][:, :, 0] = np.stack([index, right, corner], axis=-1)
    faces["v"][:, :, 1] = np.stack([index, corner, below], axis=-1)
    return faces


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
        f"{report['boundary_edges']} boundary  {report.get('self_intersections', '-')} crossings  "
        f"{seconds:7.1f} processor s  {largest:6,.0f} MiB",
        flush=True,
    )


def compare(source: Path, percent: float, given: argparse.Namespace) -> None:
    """Both ways to one target."""
    limit = None if given.no_limit else bytes_of(given.memory)
    result = source.with_name("small.ply")
    words = ["-m", "laplacian_simplify", "huge", str(source), str(result), "--percent", str(percent), "--json", "-"]
    if not given.guard:  # which starts anew where faces cross: by chance in one or the other
        words.append("--no-avoid-self-intersections")
    shown, seconds, _ = measured([*words, "--memory", given.memory, "--workers", str(given.workers)], limit)
    report = json.loads(shown)
    show("huge", report, seconds, report["peak_memory"] / (1 << 20))
    for row in report["rounds"]:
        print("  ", {name: value for name, value in row.items() if name != "descriptor_scale"})
    print("  ", {stage: round(value, 1) for stage, value in report["processor_seconds"].items()}, flush=True)
    shown, seconds_in_memory, largest = measured(
        ["-c", IN_MEMORY, str(source), str(percent), "guard" if given.guard else "none"], None
    )
    in_memory = json.loads(shown)
    show("in memory", in_memory, seconds_in_memory, largest)
    ratios = {name: report[name] / in_memory[name] for name in ("rms", "feature_rms", "hausdorff")}
    ratios["processor seconds"] = seconds / seconds_in_memory
    print("ratios    ", {name: round(value, 3) for name, value in ratios.items()}, flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--faces", type=int, default=17_000_000)
    parser.add_argument("--scene", choices=SCENES, default="scan")
    parser.add_argument("--percent", type=float, nargs="+", default=[2, 10])
    parser.add_argument("--memory", default="2GiB")
    parser.add_argument("--workers", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--no-limit", action="store_true", help="of the address space")
    parser.add_argument("--guard", action="store_true", help="avoid faces that cross")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="huge-benchmark-") as name:
        source = Path(name) / "scan.ply"
        print(
            f"{write_mesh(source, given.scene, given.faces):,} faces, {source.stat().st_size / 1e6:,.0f} MB", flush=True
        )
        for percent in given.percent:
            compare(source, percent, given)
    return 0


if __name__ == "__main__":
    sys.exit(main())
