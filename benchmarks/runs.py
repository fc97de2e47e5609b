# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of one tool on one mesh, each in a process of its own, and the store of what they gave."""

import json
import os
import resource
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mesh_topology import Mesh, without_unreferenced
from meshes import BenchmarkMesh

ONE_RUN = Path(__file__).with_name("one_run.py")
LAYOUT = 2  # of the stored figures
LONGEST_SECONDS = 1800
WAITING = 4  # elapsed seconds that a process has for one of a processor


@dataclass(frozen=True)
class Workshop:
    """Where a benchmark works: shared objects, prepared meshes, results."""

    folder: Path

    @property
    def peers(self) -> Path:
        return self.folder / "peers"

    @property
    def inputs(self) -> Path:
        return self.folder / "inputs"

    @property
    def results(self) -> Path:
        return self.folder / "results"

    def environment(self) -> dict:
        """What a run finds in its environment."""
        return dict(os.environ, BENCHMARK_PEERS=str(self.peers))


class Store:
    """Figures by section, kept in a JSON file after every change.

    Of a file in an older layout only the geometry is taken over.
    """

    def __init__(self, path: Path):
        self._path = path
        self.sections = json.loads(path.read_text()) if path.exists() else {}
        if self.sections.get("layout") != LAYOUT:
            self.sections = {"layout": LAYOUT, "quality": self.sections.get("quality", {})}

    def section(self, name: str) -> dict:
        return self.sections.setdefault(name, {})

    def save(self) -> None:
        self._path.parent.mkdir(parents=True, exist_ok=True)
        scratch = self._path.with_suffix(".part")
        scratch.write_text(json.dumps(self.sections, indent=1))
        scratch.replace(self._path)


def run_tool(
    workshop: Workshop, peer_id: str, mesh: BenchmarkMesh, jobs: list[tuple[int, Path]], limit: int = LONGEST_SECONDS
) -> list[dict]:
    """Runs a tool for each pair of faces to reach and place of the result (.npz), in one process.

    The process may use `limit` seconds of a processor; where others keep the machine busy it has longer to do so.
    Returns times and peak memory of each, or {"failure": why}.
    """
    command = [sys.executable, str(ONE_RUN), peer_id, str(mesh.arrays)]
    for faces, destination in jobs:
        destination.parent.mkdir(parents=True, exist_ok=True)
        command += [str(faces), str(destination)]
    stopped = {"failure": f"> {limit} s"}
    try:
        done = subprocess.run(
            command,
            env=workshop.environment(),
            capture_output=True,
            text=True,
            timeout=WAITING * limit,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 10)),
            check=False,
        )
    except subprocess.TimeoutExpired:
        return [stopped] * len(jobs)
    figures = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    crash = {"failure": (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]}
    missing = stopped if done.returncode == -signal.SIGXCPU else crash
    return figures + [missing] * (len(jobs) - len(figures))


def result_path(workshop: Workshop, peer_id: str, mesh: BenchmarkMesh, percent: float) -> Path:
    """Where the mesh of a run of the quality section lies."""
    return workshop.results / peer_id / f"{mesh.name}_{percent:g}.npz"


def load_result(path: Path) -> Mesh:
    """The mesh that a run left."""
    stored = np.load(path)
    return without_unreferenced(stored["vertices"].astype(np.float64), stored["faces"].astype(np.int64))
