# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes: the command batch with one and two workers against a loop over the same files in one process.

scripts/python benchmarks/batch.py [--meshes N] [--smallest FACES] [--largest FACES] [--broken N] [--effort EFFORT]

Prints meshes a second and processor seconds of each, and checks that every mesh is done or refused as it should be,
with the same bytes. Rates mean something on idle processors only; processor seconds do on a busy machine, too.
"""

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import numpy as np

LOOP = """
import sys
from pathlib import Path
import laplacian_simplify as ls

source, target, effort = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
for path in sorted(source.iterdir()):
    try:
        report = ls.simplify(path, target_percent=10, effort=effort, threads=1)
        ls.write_mesh(report.mesh_set, target / path.name)
    except (OSError, RuntimeError):
        pass
"""


def write_mesh(path: Path, faces: int, seed: int) -> None:
    """A closed torus with relief, as binary PLY in single precision."""
    around, across = max(round((faces / 2) ** 0.5 * 1.4), 3), max(round((faces / 2) ** 0.5 / 1.4), 3)
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    random = np.random.default_rng(seed)
    relief = sum(
        0.05 / k * np.sin(k * a * u + b) * np.sin(k * c * v + d)
        for k, (a, b, c, d) in enumerate(random.integers(1, 7, (5, 4)), 1)
    )
    radius = 0.4 + relief
    points = np.stack(
        [(1 + radius * np.cos(v)) * np.cos(u), (1 + radius * np.cos(v)) * np.sin(u), radius * np.sin(v)], axis=-1
    )
    index = np.arange(around * across).reshape(around, across)
    right, below = np.roll(index, -1, axis=0), np.roll(index, -1, axis=1)
    corner = np.roll(right, -1, axis=1)
    triangles = np.concatenate(
        [np.stack([index, right, corner], axis=-1), np.stack([index, corner, below], axis=-1)]
    ).reshape(-1, 3)
    rows = np.zeros(len(triangles), [("n", "u1"), ("v", "<i4", 3)])
    rows["n"], rows["v"] = 3, triangles
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {index.size}\nproperty float x\nproperty float y\n"
        f"property float z\nelement face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    path.write_bytes(header.encode() + points.reshape(-1, 3).astype("<f4").tobytes() + rows.tobytes())


def break_mesh(path: Path, how: int) -> None:
    """Damages a file in one of five ways."""
    data = bytearray(path.read_bytes())
    start = data.index(b"end_header\n") + len(b"end_header\n")
    if how == 0:
        data = data[: len(data) // 2]
    elif how == 1:
        data = bytearray()
    elif how == 2:
        data = bytearray(b"garbage" * 100)
    elif how == 3:
        data[start : start + 4] = np.float32(np.nan).tobytes()
    else:
        data[-4:] = np.int32(-5).tobytes()
    path.write_bytes(bytes(data))


def generate(folder: Path, meshes: int, smallest: int, largest: int, broken: int) -> None:
    """Sizes are spread evenly over their logarithms; every so many of them is broken."""
    folder.mkdir()
    for k, faces in enumerate(np.geomspace(smallest, largest, meshes).astype(int)):
        path = folder / f"{k:05}.ply"
        write_mesh(path, int(faces), k)
        if broken and k % max(meshes // broken, 1) == 0 and k // max(meshes // broken, 1) < broken:
            break_mesh(path, k // max(meshes // broken, 1) % 5)


def measured(words: list[str]) -> tuple[float, float]:
    """Seconds, and processor seconds of a command and its processes."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run([sys.executable, "-P", *words], stdout=subprocess.DEVNULL, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.perf_counter() - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--meshes", type=int, default=1000)
    parser.add_argument("--smallest", type=int, default=1_000)
    parser.add_argument("--largest", type=int, default=200_000)
    parser.add_argument("--broken", type=int, default=20)
    parser.add_argument("--effort", default="balanced")
    given = parser.parse_args()
    good = given.meshes - given.broken
    with tempfile.TemporaryDirectory(prefix="batch-benchmark-") as name:
        folder = Path(name)
        generate(folder / "meshes", given.meshes, given.smallest, given.largest, given.broken)
        (folder / "loop").mkdir()
        runs = {"loop": ["-c", LOOP, str(folder / "meshes"), str(folder / "loop"), given.effort]}
        for workers in (1, 2):
            target = folder / f"{workers} workers"
            runs[target.name] = [
                *("-m", "laplacian_simplify", "batch", str(folder / "meshes"), str(target), "--percent", "10"),
                *("--effort", given.effort, "--threads", "1", "--workers", str(workers)),
            ]
        as_it_should_be = True
        for run, words in runs.items():
            seconds, used = measured(words)
            results = {path.name: path.read_bytes() for path in (folder / run).glob("*.ply")}
            print(f"{run:<10} {good / seconds:7.2f} meshes/s  {used:8.1f} processor seconds", flush=True)
            if run == "loop":
                of_the_loop = results
                continue
            lines = (folder / run / "laplacian-simplify.jsonl").read_text().splitlines()
            statuses = Counter(json.loads(line)["status"] for line in lines)
            as_it_should_be &= statuses == {"done": good, "refused": given.broken} and results == of_the_loop
            print(f"{'':<10} {dict(statuses)}; bytes of the loop: {results == of_the_loop}", flush=True)
    return 0 if as_it_should_be else 1


if __name__ == "__main__":
    sys.exit(main())
