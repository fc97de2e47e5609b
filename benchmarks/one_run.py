#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One peer on one mesh, in a process of its own: one_run.py PEER INPUT.npz {TARGET_FACES OUTPUT.npz}...

Prints one line of JSON for each target, with the processor and elapsed seconds and the peak of memory of the
simplification alone, above the loaded mesh; a line with "failure" where the peer raised an error. Where time or
memory matters there is one target: later ones find a warm heap.

The process is held to as many cores as the peer may have threads, so that no library takes more than the others.
"""

import json
import os
import sys

import numpy as np

from peers import peer_named
from stopwatch import Stopwatch


def run(peer_id: str, mesh, target: int, destination: str) -> dict:
    """The figures of one simplification, or the failure."""
    stopwatch = Stopwatch()
    try:
        vertices, faces = peer_named(peer_id).simplify(mesh["vertices"], mesh["faces"], target, stopwatch)
    except Exception as error:  # whatever a peer raises is a result of the benchmark, not its end
        return {"failure": f"{type(error).__name__}: {error}"}
    np.savez(destination, vertices=np.asarray(vertices), faces=np.asarray(faces, dtype=np.int32))
    return {
        "cpu_seconds": stopwatch.cpu_seconds,
        "wall_seconds": stopwatch.wall_seconds,
        "peak_bytes": stopwatch.peak_bytes,
    }


def main() -> int:
    peer_id, source, *pairs = sys.argv[1:]
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[-peer_named(peer_id).threads :])
    mesh = np.load(source)
    for target, destination in zip(pairs[::2], pairs[1::2]):
        print("\n" + json.dumps(run(peer_id, mesh, int(target), destination)), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
