#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The descriptor's filter in pymeshlab beside MeshLab's own curvature: host_descriptor.py INPUT.npz ROUNDS

Prints one line of JSON: for each filter the processor seconds of every round. A filter that does nothing to the
mesh is there to show what a call costs.
"""

import json
import sys

import numpy as np
import pymeshlab

import laplacian_simplify
from stopwatch import Stopwatch

FILTERS = {
    "nothing": ("set_selection_none", {}),
    "descriptor": ("compute_scalar_by_laplacian_descriptor_per_vertex", {"colorize": False}),
    "curvature": ("compute_scalar_by_discrete_curvature_per_vertex", {"curvaturetype": "Mean Curvature"}),
}


def main() -> int:
    arrays, rounds = np.load(sys.argv[1]), int(sys.argv[2])
    laplacian_simplify.load()
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(arrays["vertices"].astype(np.float64), arrays["faces"]))
    seconds = {name: [] for name in FILTERS}
    for _ in range(rounds):
        for name, (filter_name, parameters) in FILTERS.items():
            with Stopwatch() as stopwatch:
                meshes.apply_filter(filter_name, **parameters)
            seconds[name].append(stopwatch.cpu_seconds)
    print("\n" + json.dumps(seconds))
    return 0


if __name__ == "__main__":
    sys.exit(main())
