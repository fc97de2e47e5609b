# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads of one process, each with meshes of its own; nothing of the process is changed by them."""

import os
import subprocess
import sys
from pathlib import Path

from conftest import SAMPLE_MESHES
from mesh_files import obj, off, ply, text_stl
from reading_checks import write

ROUNDS = int(os.environ.get("LAPLACIAN_SIMPLIFY_ROUNDS", "2"))
"""How often the threads do their work; more find rarer faults."""

FILES = """
import os, sys, threading
from concurrent.futures import ThreadPoolExecutor
import laplacian_simplify as ls

names = sorted(os.listdir("."))
before = os.getcwd(), sorted(os.readlink(f"/proc/self/fd/{n}") for n in (0, 1, 2))

def work(name):
    report = ls.simplify(name, target_faces=6)          # a name within the working directory
    ls.write_mesh(report.mesh_set, f"../out/{name}.ply")
    open(name).close()                                  # which it also is for everybody else
    return report.faces, report.mesh_set.current_mesh().vertex_matrix().tobytes()

alone = {name: work(name) for name in names}
for _ in range(int(sys.argv[1])):
    with ThreadPoolExecutor(8) as pool:
        for name, found in zip(names, pool.map(work, names)):
            assert found == alone[name], name
after = os.getcwd(), sorted(os.readlink(f"/proc/self/fd/{n}") for n in (0, 1, 2))
assert before == after
os.write(1, b"below Python\\n")
print("in Python")
"""

FILTERS = """
import sys
from concurrent.futures import ThreadPoolExecutor
import laplacian_simplify as ls

def work(k):
    mesh_set = ls.read_mesh(sys.argv[1])
    if k % 3 == 0:
        report = ls.simplify(mesh_set, target_percent=30, effort="best", threads=1 + k % 2)
    elif k % 3 == 1:
        report = ls.simplify(mesh_set, target_percent=30, order="strict", threads=1 + k % 2)
    else:
        report = ls.weighted(mesh_set, target_percent=30)
    return report.faces, mesh_set.current_mesh().vertex_matrix().tobytes()

alone = [work(k) for k in range(3)]
for _ in range(int(sys.argv[2])):
    with ThreadPoolExecutor(6) as pool:
        for k, found in enumerate(pool.map(work, range(6))):
            assert found == alone[k % 3], k
print("done")
"""

COMMA = """
import locale, os, sys
import laplacian_simplify as ls

locale.setlocale(locale.LC_ALL, sys.argv[1])
before = locale.setlocale(locale.LC_ALL)
for name in ("box.obj", "box.off", "box.stl", "box.ply"):
    mesh_set = ls.read_mesh(name)
    report = ls.simplify(mesh_set, target_faces=8, feature_weight=2.5)
    for extension in ("obj", "off", "ply", "stl", "dae"):
        ls.write_mesh(mesh_set, f"{sys.argv[2]}/{name}.{extension}")
assert locale.setlocale(locale.LC_ALL) == before
assert locale.localeconv()["decimal_point"] == sys.argv[3]
"""


def _python(program: str, *arguments: object, cwd: Path, **environment: str) -> str:
    words = [sys.executable, "-P", "-c", program, *map(str, arguments)]
    done = subprocess.run(
        words, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True, timeout=3000, check=False
    )
    assert done.returncode == 0, done.stderr[-2000:]
    assert done.stderr == ""
    return done.stdout


def test_forty_files_in_eight_threads(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "out").mkdir()
    kinds = {"obj": obj(), "off": off(), "stl": text_stl(), "ply": ply()}
    for k in range(40):
        extension = list(kinds)[k % 4]
        write(tmp_path / "in" / f"{k}.{extension}", kinds[extension])
    assert _python(FILES, ROUNDS, cwd=tmp_path / "in") == "below Python\nin Python\n"
    assert len(list((tmp_path / "out").iterdir())) == 40


def test_best_strict_and_weighted_in_six_threads(tmp_path: Path) -> None:
    mesh = SAMPLE_MESHES / "painted_box.obj"
    assert _python(FILTERS, mesh, ROUNDS, cwd=tmp_path) == "done\n"


def test_a_comma_locale_changes_nothing(tmp_path: Path, german: dict[str, str]) -> None:
    """Not in a process that has it, and not in the command."""
    for name, content in (("box.obj", obj()), ("box.off", off()), ("box.stl", text_stl()), ("box.ply", ply())):
        write(tmp_path / name, content)
    for name in ("dots", "commas"):
        (tmp_path / name).mkdir()
    _python(COMMA, "C", "dots", ".", cwd=tmp_path)
    _python(COMMA, "de_DE.UTF-8", "commas", ",", cwd=tmp_path, **german)
    for path in (tmp_path / "dots").iterdir():
        if path.suffix != ".dae":  # it has the time in it
            assert (tmp_path / "commas" / path.name).read_bytes() == path.read_bytes(), path.name
    words = [sys.executable, "-P", "-m", "laplacian_simplify", "simplify", "box.obj", "command.obj", "--faces", "8"]
    environment = {**os.environ, **german, "LC_ALL": "de_DE.UTF-8"}
    subprocess.run([*words, "--feature-weight", "2.5"], cwd=tmp_path, env=environment, check=True, capture_output=True)
    expected = (tmp_path / "dots" / "box.obj.obj").read_text().replace("box.obj.obj", "command.obj")
    assert (tmp_path / "command.obj").read_text() == expected
