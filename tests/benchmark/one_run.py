#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One peer on one mesh, in a process of its own: one_run.py PEER INPUT.npz TARGET_FACES OUTPUT.npz

Prints one line of JSON with the processor and elapsed seconds and the peak of memory of the simplification
alone, above the loaded mesh.
"""

import json
import sys

import numpy as np

from peers import peer_named
from stopwatch import Stopwatch


def main() -> int:
    peer_id, source, target, destination = sys.argv[1:5]
    mesh = np.load(source)
    stopwatch = Stopwatch()
    vertices, faces = peer_named(peer_id).simplify(mesh["vertices"], mesh["faces"], int(target), stopwatch)
    np.savez(destination, vertices=np.asarray(vertices), faces=np.asarray(faces, dtype=np.int32))
    figures = {
        "cpu_seconds": stopwatch.cpu_seconds,
        "wall_seconds": stopwatch.wall_seconds,
        "peak_bytes": stopwatch.peak_bytes,
    }
    print("\n" + json.dumps(figures))
    return 0


if __name__ == "__main__":
    sys.exit(main())
