#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the errors of two versions of the code, as their own reports have them.

    scripts/python benchmarks/report_ratios.py MESH... > old.jsonl          in the old version
    scripts/python benchmarks/report_ratios.py MESH... --compare old.jsonl  in the new one

Without meshes, the sample meshes. Each mesh is simplified to 50, 20, 10 and 2 % by efforts fast and balanced. Printed
are geometric means of the ratios new / old; lengths below .001 % of the diagonal count as .001 %. With --compare it
also lists where balanced is worse than fast: by more than 1 % and by more than 1e-5 of the diagonal.
"""

import argparse
import json
import math
import sys
from pathlib import Path

import laplacian_simplify as ls

SAMPLE_MESHES = Path(__file__).resolve().parents[1] / "sample_meshes"
PERCENTS = (50, 20, 10, 2)
EFFORTS = ("fast", "balanced")
METRICS = ("rms", "feature_rms", "hausdorff")
SMALLEST = 0.001  # percent of the diagonal: below, errors are equal


def measured(path: Path, percent: float, effort: str) -> dict:
    report = ls.simplify(ls.read_mesh(path), target_percent=percent, effort=effort)
    errors = {metric: float(getattr(report, metric)) for metric in (*METRICS, "folded")}
    return {"mesh": path.stem, "percent": percent, "effort": effort, **errors}


def mean_ratio(pairs: list[tuple[float, float]]) -> float:
    logs = [math.log(max(new, SMALLEST) / max(old, SMALLEST)) for new, old in pairs]
    return math.exp(sum(logs) / len(logs))


def key(row: dict) -> tuple:
    return row["mesh"], row["percent"], row["effort"]


def print_ratios(rows: list[dict], old: dict[tuple, dict]) -> None:
    for effort in EFFORTS:
        for percents in (PERCENTS, *((percent,) for percent in PERCENTS)):
            both = [
                (row, old[key(row)])
                for row in rows
                if row["effort"] == effort and row["percent"] in percents and key(row) in old
            ]
            if not both:
                continue
            ratios = "/".join(f"{mean_ratio([(new[m], was[m]) for new, was in both]):.3f}" for m in METRICS)
            name = "all" if len(percents) > 1 else f"{percents[0]} %"
            print(f"{effort} {name}: {ratios} ({len(both)} results)")


def print_worse_than_fast(rows: list[dict]) -> None:
    fast = {key(row)[:2]: row for row in rows if row["effort"] == "fast"}
    for row in rows:
        base = fast[key(row)[:2]]
        for metric in METRICS:
            if row[metric] > max(1.01 * base[metric], base[metric] + SMALLEST):
                name = f"{row['mesh']} {row['percent']} % {metric}"
                print(f"worse than fast: {name} {row[metric]:.5f} > {base[metric]:.5f}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="*", type=Path)
    parser.add_argument("--compare", type=Path, metavar="FILE", help="what the old version printed")
    arguments = parser.parse_args()
    meshes = arguments.meshes or sorted(p for p in SAMPLE_MESHES.iterdir() if p.suffix in {".ply", ".obj", ".off"})
    rows = []
    for path in meshes:
        for percent in PERCENTS:
            for effort in EFFORTS:
                rows.append(measured(path, percent, effort))
                if not arguments.compare:
                    print(json.dumps(rows[-1]), flush=True)
    if arguments.compare:
        lines = arguments.compare.read_text(encoding="utf-8").splitlines()
        print_ratios(rows, {key(row): row for row in map(json.loads, lines)})
        print_worse_than_fast(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
