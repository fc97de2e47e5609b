# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One process that runs filters in pymeshlab, job by job: numbers of a mesh and a setting in, a line of JSON out.

A job that takes more processor time or memory than it may ends the process, as a crash does.
"""

import json
import os
import resource
import sys

import numpy as np
import pymeshlab
from host_meshes import contents, fault_of_a_mesh, fault_of_a_report, mesh_set_of
from hostile_meshes import HostileMesh, corpus
from refusals import fault_of_a_refusal
from settings import GUIDED, LEVELS, SMOOTHING, WEIGHTED, Setting, settings

import laplacian_simplify as ls

MOST_SECONDS = 10
MOST_MEMORY = 6 << 30  # addresses: most of it is what the libraries reserve


def outcome(mesh: HostileMesh, setting: Setting) -> tuple[str, str]:
    """How a run ended (done, refused, not made or fault) and what there is to say about it."""
    try:
        mesh_set = mesh_set_of(mesh)
        original = mesh_set_of(mesh)
    except pymeshlab.PyMeshLabException as error:
        return "not made", str(error)
    before = contents(mesh_set)
    try:
        report = mesh_set.apply_filter(setting.filter, **setting.values)
    except pymeshlab.PyMeshLabException as error:
        message = str(error)
        changed = contents(mesh_set) != before
        fault = "the mesh was refused, and is another one" if changed else fault_of_a_refusal(message)
        return ("fault", f"{fault}: {message}") if fault else ("refused", message)
    fault = _fault(setting, original, mesh_set, before, report)
    return ("fault", fault) if fault else ("done", "")


def _fault(setting: Setting, original, mesh_set, before: list[list[bytes]], report) -> str:
    first, current = original.current_mesh(), mesh_set.current_mesh()
    if setting.filter == LEVELS:
        kept = _visible(contents(mesh_set)[0]) == _visible(before[0])
        layers = [mesh_set.mesh(i) for i in range(1, mesh_set.mesh_number())]
        faults = [fault_of_a_mesh(first, layer) for layer in layers]
        return next(filter(None, faults), "" if kept else "the original is another one")
    if setting.filter in (GUIDED, WEIGHTED):
        return fault_of_a_mesh(first, current) or fault_of_a_report(report, current)
    after = contents(mesh_set)[0]
    if after[1] != before[0][1] or (setting.filter != SMOOTHING and after[0] != before[0][0]):
        return "the mesh is another one"
    if not np.isfinite(current.vertex_matrix()).all():
        return "coordinates are no numbers"
    return _of_quality(setting, current, report)


def _visible(layer: list[bytes]) -> list[bytes]:
    return layer[:2]


def _of_quality(setting: Setting, mesh, report) -> str:
    values = [value for value in report.values() if isinstance(value, float)]
    if not np.isfinite(values).all():
        return f"a number is not finite: {dict(report)}"
    if setting.filter != SMOOTHING and setting.values.get("descriptor") != 5 and mesh.has_vertex_scalar():
        whole = not setting.values.get("selected_only") and setting.filter.startswith("compute_scalar")
        if whole and not np.isfinite(mesh.vertex_scalar_array()).all():
            return "the quality is not finite"
    return ""


def _limit_processor_time() -> None:
    """From here on; what the process has used before does not count."""
    used = resource.getrusage(resource.RUSAGE_SELF)
    seconds = int(used.ru_utime + used.ru_stime) + MOST_SECONDS + 1
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, resource.getrlimit(resource.RLIMIT_CPU)[1]))


def main() -> int:
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # the host writes there as it likes
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    meshes, all_settings = corpus(), settings()
    ls.load()
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    answers.write("ready\n")
    answers.flush()
    for line in sys.stdin:
        number, setting = map(int, line.split())
        _limit_processor_time()
        before = resource.getrusage(resource.RUSAGE_SELF)
        kind, said = outcome(meshes[number], all_settings[setting])
        after = resource.getrusage(resource.RUSAGE_SELF)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        answers.write(json.dumps([kind, said, seconds]) + "\n")
        answers.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
