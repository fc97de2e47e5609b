# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every mesh of the corpus through every filter in pymeshlab, and through the core under sanitizers.

No run may crash, hang, change what it refuses, or leave what is no mesh. Prints a table; the status is 0 where no run
had a fault. As a program: scripts/hostile, which builds what is run.
"""

import argparse
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from core_runs import core_runs
from host_runs import Run, host_runs
from hostile_meshes import HostileMesh, corpus
from mesh_bytes import core_settings
from settings import settings


def jobs_of(meshes: list[HostileMesh], settings_count: int, every: int, valid_only: bool) -> list[tuple[int, int]]:
    """Pairs of mesh and setting, mesh by mesh; one of so many by chance, the same ones each time."""
    wanted = np.random.default_rng(0).random((len(meshes), settings_count)) * every < 1
    return [
        (int(mesh), int(setting))
        for mesh, setting in np.argwhere(wanted)
        if meshes[mesh].indices_are_valid or not valid_only
    ]


def all_runs(
    meshes: list[HostileMesh], every: int, programs: list[Path], hosts: bool = True
) -> Iterable[tuple[str, Run]]:
    """Runs with the place in which they ran."""
    if hosts:
        jobs = jobs_of(meshes, len(settings()), every, valid_only=True)
        yield from (("pymeshlab", run) for run in host_runs(meshes, settings(), jobs))
    for program in programs:
        place = f"core, {program.parents[2].name}"
        jobs = jobs_of(meshes, len(core_settings()), every, valid_only=False)
        yield from ((place, run) for run in core_runs(program, meshes, core_settings(), jobs))


class Table:
    """How the runs of every setting ended."""

    def __init__(self) -> None:
        self._kinds: dict[tuple[str, str], Counter[str]] = defaultdict(Counter)
        self._slowest: dict[tuple[str, str], Run] = {}

    def add(self, place: str, run: Run) -> None:
        row = place, run.setting
        self._kinds[row][run.kind] += 1
        self._slowest[row] = max(run, self._slowest.get(row, run), key=lambda other: other.seconds)

    def lines(self) -> list[str]:
        found = [f"{'':38} {'done':>6} {'refused':>8} {'not made':>9} {'faults':>7}   slowest"]
        for (place, setting), kinds in self._kinds.items():
            slowest = self._slowest[place, setting]
            numbers = f"{kinds['done']:6} {kinds['refused']:8} {kinds['not made']:9} {kinds['fault']:7}"
            found.append(f"{place + ': ' + setting:38} {numbers}   {slowest.seconds:.2f} s, {slowest.mesh}")
        return found

    def total(self) -> Counter[str]:
        return sum(self._kinds.values(), Counter())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every", type=int, default=1, help="only one run of so many")
    parser.add_argument("--program", type=Path, action="append", default=[], help="hostile_cases of a build")
    parser.add_argument("--core-only", action="store_true", help="nothing in pymeshlab")
    parser.add_argument("--mesh", default="", help="only meshes with this in their names")
    options = parser.parse_args()
    meshes = [mesh for mesh in corpus() if options.mesh in mesh.name]
    table = Table()
    for place, run in all_runs(meshes, options.every, options.program, not options.core_only):
        table.add(place, run)
        if run.kind == "fault":
            print(f"{place}: {run.mesh}, {run.setting}: {run.said}", flush=True)
    total = table.total()
    print("\n".join(table.lines()))
    print(f"{len(meshes)} meshes, {total.total()} runs, {total['fault']} faults")
    return 1 if total["fault"] else 0


if __name__ == "__main__":
    sys.exit(main())
