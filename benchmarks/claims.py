# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a newcomer gets: the project's command against MeshLab's defaults, and the descriptor's speed."""

import json
import subprocess
import sys
from pathlib import Path

from build_peers import descriptor_report
from mesh_topology import read_mesh
from meshes import BenchmarkMesh
from metrics import Original, measure, plain_numbers
from peers import HOST
from runs import Store, Workshop, load_result, run_tool
from stopwatch import Neighbours

COMMAND_FACES = 1000


def measure_command(workshop: Workshop, store: Store, source: Path, mesh: BenchmarkMesh) -> None:
    """Stores the section 'command': laplacian-simplify, the program behind scripts/simplify, and MeshLab's quadric
    decimation with defaults, both to 1,000 faces.
    """
    result = workshop.results / "command.ply"
    command = [sys.executable, "-m", "laplacian_simplify", "simplify", str(source), str(result)]
    subprocess.run([*command, "--faces", str(COMMAND_FACES)], check=True, capture_output=True)
    host_result = workshop.results / "command_host.npz"
    run_tool(workshop, HOST, mesh, [(COMMAND_FACES, host_result)])
    original = Original(mesh.load())
    store.sections["command"] = {
        "mesh": source.name,
        "faces": COMMAND_FACES,
        "project": plain_numbers(measure(original, read_mesh(result))),
        "host": plain_numbers(measure(original, load_result(host_result))),
    }
    store.save()


def measure_descriptor(workshop: Workshop, store: Store, mesh: BenchmarkMesh, vcglib: Path, rounds: int) -> None:
    """Stores the section 'descriptor': seconds of filters in the host, round by round, and figures on plain arrays."""
    script = Path(__file__).with_name("host_descriptor.py")
    with Neighbours() as neighbours:
        done = subprocess.run(
            [sys.executable, str(script), str(mesh.arrays), str(rounds)],
            env=dict(workshop.environment(), OMP_NUM_THREADS="1"),
            capture_output=True,
            text=True,
            check=True,
        )
    store.section("descriptor")["host"] = {
        "faces": mesh.face_count,
        "seconds": json.loads(done.stdout.strip().splitlines()[-1]),
        "others": neighbours.cores,
    }
    store.save()
    with Neighbours() as neighbours:
        report = descriptor_report(workshop.peers, vcglib, mesh.ply, rounds)
    store.section("descriptor")["arrays"] = {"report": report, "others": neighbours.cores}
    store.save()
