#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What feature weight and effort do to the error, for docs/choosing.md: prints its tables.

    scripts/python benchmarks/feature_weights.py [MESH...]

Each mesh, by default every sample mesh, is simplified to 50, 20, 10 and 2 % on one thread. Distances are those of the
report. Printed are geometric means of the ratios to the default (feature weight 2, effort balanced) over all meshes,
and how many results are better and worse than the default's; lengths below .001 % of the diagonal count as .001 %.
"""

import sys
import time
from pathlib import Path

import numpy as np
import pymeshlab

import laplacian_simplify as ls

SAMPLE_MESHES = Path(__file__).resolve().parents[1] / "sample_meshes"
PERCENTS = (50, 20, 10, 2)
SETTINGS = {
    "feature weight 0": {"feature_weight": 0},
    "feature weight 2": {},
    "feature weight 4": {"feature_weight": 4},
    "feature weight 8": {"feature_weight": 8},
    "effort fast": {"effort": "fast"},
    "effort best": {"effort": "best"},
}
DEFAULT = "feature weight 2"
METRICS = ("rms", "feature_rms", "hausdorff")
SMALLEST = 0.001  # percent of the diagonal


def measured(path: Path, percent: float, options: dict) -> list[float]:
    """The metrics, and the processor seconds of another run without measurement, the least of three."""
    report = ls.simplify(ls.read_mesh(path), target_percent=percent, threads=1, **options)
    seconds = min(seconds_of(ls.read_mesh(path), percent, options) for _ in range(3))
    return [*(max(getattr(report, metric), SMALLEST) for metric in METRICS), seconds]


def seconds_of(mesh_set: pymeshlab.MeshSet, percent: float, options: dict) -> float:
    start = time.process_time()
    ls.simplify(mesh_set, target_percent=percent, threads=1, measure_error=False, **options)
    return time.process_time() - start


def main() -> None:
    paths = [Path(name) for name in sys.argv[1:]] or sorted(
        path for path in SAMPLE_MESHES.iterdir() if path.suffix in (".ply", ".obj")
    )
    errors = {
        name: np.array([measured(path, percent, options) for path in paths for percent in PERCENTS])
        for name, options in SETTINGS.items()
    }
    print(f"{len(paths)} meshes: {', '.join(path.stem for path in paths)}; {len(errors[DEFAULT])} results each\n")
    print("| | rms | feature rms | largest distance | less/more rms | less/more feature rms |")
    print("|---|---|---|---|---|---|")
    for name, values in errors.items():
        ratios = values / errors[DEFAULT]
        means = " | ".join(f"{mean:.2f}" for mean in np.exp(np.log(ratios[:, :3]).mean(axis=0)))
        counts = " | ".join(f"{(ratios[:, k] < 1).sum()}/{(ratios[:, k] > 1).sum()}" for k in (0, 1))
        print(f"| {name} | {means} | {counts} |")
    for name, values in errors.items():
        print(f"{name}: {values[:, 3].sum() / errors[DEFAULT][:, 3].sum():.2f} times the processor seconds")


if __name__ == "__main__":
    main()
