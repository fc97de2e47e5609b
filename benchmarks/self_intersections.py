# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the crossing faces of results with CGAL, and prints what avoiding them costs.

    scripts/python benchmarks/self_intersections.py [--percents 50,20,10,5,2,1] [--efforts fast,balanced] MESH...

For every mesh, percentage and effort: the pairs of faces that cross in the original, in the result without
avoid_self_intersections, in that with it, and as the filter counts them; the ratios of rms and of the processor
time of both runs, on one thread. CGAL's predicates are exact (libigl's remesh_self_intersections); vertices with
equal coordinates are one to it, and duplicate faces are left out. Ends with 1 if a result has more pairs than its
original.
"""

import argparse
import sys
import time
from pathlib import Path
from typing import Any

import igl.copyleft.cgal
import numpy as np
import pymeshlab

import laplacian_simplify as ls


def crossing_pairs(mesh_set: pymeshlab.MeshSet) -> int:
    mesh = mesh_set.current_mesh()
    points, index = np.unique(mesh.vertex_matrix(), axis=0, return_inverse=True)
    faces = np.sort(index.reshape(-1)[mesh.face_matrix()], axis=1)
    faces = np.unique(faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2])], axis=0)
    edges = points[faces[:, 1:]] - points[faces[:, :1]]
    area = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    found = igl.copyleft.cgal.remesh_self_intersections(points, faces[area > 0].astype(np.int64), detect_only=True)
    return len(found[2])


def run(path: Path, percent: float, effort: str, avoid: bool) -> tuple[Any, float, pymeshlab.MeshSet]:
    mesh_set: pymeshlab.MeshSet = ls.read_mesh(path)
    start = time.process_time()
    options = {"target_percent": percent, "effort": effort, "threads": 1, "avoid_self_intersections": avoid}
    ls.simplify(mesh_set, measure_error=False, **options)
    seconds = time.process_time() - start
    measured: pymeshlab.MeshSet = ls.read_mesh(path)
    report = ls.simplify(measured, **options)
    return report, seconds, mesh_set


def check(path: Path, percent: float, effort: str, before: int) -> bool:
    plain, usual, plain_mesh = run(path, percent, effort, avoid=False)
    avoided, cost, mesh = run(path, percent, effort, avoid=True)
    after = crossing_pairs(mesh)
    print(
        f"{path.stem:16} {percent:4g} % {effort:8}  faces {avoided.faces:8,}  pairs before {before:5}  "
        f"without {crossing_pairs(plain_mesh):5}  with {after:5}  reported {avoided.self_intersections:5}  "
        f"rms {avoided.rms / plain.rms if plain.rms else 1:6.3f} x  cpu {cost:7.2f} s = {cost / usual:5.2f} x",
        flush=True,
    )
    return after <= before


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("meshes", nargs="+", type=Path)
    parser.add_argument("--percents", default="50,20,10,5,2,1")
    parser.add_argument("--efforts", default="fast,balanced")
    options = parser.parse_args()
    kept = True
    for path in options.meshes:
        mesh_set: pymeshlab.MeshSet = ls.read_mesh(path)
        before = crossing_pairs(mesh_set)
        for percent in options.percents.split(","):
            for effort in options.efforts.split(","):
                kept &= check(path, float(percent), effort, before)
    return int(not kept)


if __name__ == "__main__":
    sys.exit(main())
