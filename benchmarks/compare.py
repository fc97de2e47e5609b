#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of a folder of results against stored metrics of the peers.

    compare.py RESULTS --inputs FOLDER --reference METRICS.json [--json OUT]

RESULTS holds NAME_PERCENT.ply for meshes of the benchmark, FOLDER their welded inputs NAME.npz, METRICS.json
{"cgal_lt": {"NAME_PERCENT": {...}}, "cgal_gh": ..., "pymeshlab": ...} as the benchmark writes it.
Cells are rms/feature rms/Hausdorff/normal deviation as geometric-mean ratios to CGAL Lindstrom-Turk;
! marks one of the first three that loses to Lindstrom-Turk or to Garland-Heckbert.
"""

import argparse
import json
import sys
from pathlib import Path

from mesh_topology import read_mesh
from meshes import GROUPS, PERCENTS, BenchmarkMesh, group_of, target_faces
from metrics import Original, measure, plain_numbers
from peers import HOST, REFERENCE, SECOND_REFERENCE
from ratio_tables import cell_text, cells, mean_of_distances, ratio


def keyed(stored: dict) -> dict:
    """{"cow_50": metrics} as {("cow", 50): metrics}."""
    return {(key.rsplit("_", 1)[0], int(key.rsplit("_", 1)[1])): values for key, values in stored.items()}


def measure_folder(results: Path, inputs: Path) -> dict:
    """Metrics of every NAME_PERCENT.ply whose input is there."""
    paths = {}
    for path in sorted(results.glob("*_*.ply")):
        name, percent = path.stem.rsplit("_", 1)
        paths.setdefault(name, []).append((int(percent), path))
    runs = {}
    for name, files in paths.items():
        mesh = BenchmarkMesh(name, group_of(name), inputs / f"{name}.npz", inputs / f"{name}.ply")
        if not mesh.arrays.exists():
            print(f"{name}: no input, left out", file=sys.stderr)
            continue
        original = Original(mesh.load())
        for percent, path in files:
            runs[name, percent] = plain_numbers(measure(original, read_mesh(path)))
            runs[name, percent]["target"] = target_faces(len(original.mesh.faces), percent)
    return runs


def print_table(runs: dict, reference: dict, second: dict) -> None:
    """The groups, one line for each percentage."""
    found = cells(runs, reference, second)
    for group in GROUPS:
        for percent in PERCENTS:
            print(f"{group:8}{percent:3} %  {cell_text(found, group, percent, lambda text: text + '!')}")
    if found:
        print(f"geometric mean of rms, feature rms and Hausdorff: {mean_of_distances(found):.3f}")


def print_faults(runs: dict, reference: dict, host: dict) -> None:
    """Everything that is not a ratio: topology, folded faces, missed targets, meshes lost to the host."""
    for key, run in runs.items():
        faults = [f"{fault} {run[fault]}" for fault in run if fault.startswith("new_") and run[fault]]
        if key in reference and run["folded_faces"] > reference[key]["folded_faces"]:
            faults.append(f"folded {run['folded_faces']} (reference {reference[key]['folded_faces']})")
        if run["faces"] > run["target"]:
            faults.append(f"{run['faces']} faces instead of {run['target']}")
        for axis in ("rms", "feature_rms"):
            if key in host and ratio(run[axis], host[key][axis], axis) > 1:
                faults.append(f"{axis} {run[axis]:.5f} % behind pymeshlab's {host[key][axis]:.5f} %")
        if faults:
            print(f"{key[0]} {key[1]} %: " + ", ".join(faults))
    print(f"folded faces {sum(run['folded_faces'] for run in runs.values())}, ", end="")
    print(f"reference {sum(reference[key]['folded_faces'] for key in runs if key in reference)}; ", end="")
    print(f"new non-manifold edges {sum(run['new_non_manifold_edges'] for run in runs.values())}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    parser.add_argument("--inputs", type=Path, required=True)
    parser.add_argument("--reference", type=Path, required=True)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    stored = {peer: keyed(runs) for peer, runs in json.loads(arguments.reference.read_text()).items()}
    runs = measure_folder(arguments.results, arguments.inputs)
    print_table(runs, stored[REFERENCE], stored[SECOND_REFERENCE])
    print_faults(runs, stored[REFERENCE], stored.get(HOST, {}))
    if arguments.json:
        arguments.json.write_text(json.dumps({f"{key[0]}_{key[1]}": run for key, run in runs.items()}, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
