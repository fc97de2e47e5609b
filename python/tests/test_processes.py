# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Batches spread meshes over processes; a run must not leave anything behind that a forked child waits for."""

import subprocess
import sys

from conftest import SAMPLE_MESHES, run_command

# Many threads are asked for, so that workers exist on machines with one core, too.
PROGRAM = """
import os, sys
import laplacian_simplify as ls

def run():
    mesh_set = ls.read_mesh(sys.argv[1])
    return ls.simplify(mesh_set, target_percent=10, threads=3), mesh_set

before = run()
child = os.fork()
if child == 0:
    report, mesh_set = run()
    os._exit(0 if report.faces == before[0].faces else 1)
raise SystemExit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


def test_a_forked_process_simplifies_after_its_parent_did():
    mesh = SAMPLE_MESHES / "relief_scan.ply"
    words = [sys.executable, "-P", "-c", PROGRAM, str(mesh)]
    assert subprocess.run(words, timeout=120, check=False).returncode == 0


def test_nothing_is_imported_from_the_folder_that_the_command_runs_in(tmp_path):
    """Not even by the process that it starts, which Python 3.10 cannot be told with an option."""
    for name in ("json", "numpy", "pymeshlab"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit('not this one')")
    done = run_command("simplify", SAMPLE_MESHES / "painted_box.obj", "small.obj", "--percent", 10, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
