# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in processes of their own: without pymeshlab, in pools, in another locale, and what an import costs."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

TESTS = Path(__file__).parent

WITHOUT_PYMESHLAB = """
import sys
for name in ("pymeshlab", "trimesh", "pyvista", "open3d", "meshio", "vedo", "tqdm"):
    sys.modules[name] = None  # importing it fails
import laplacian_simplify as ls
from array_meshes import wave

vertices, faces = ls.simplify(*wave(), target_percent=10)
assert len(faces) == 167
try:
    ls.simplify(7, target_percent=10)
except TypeError as error:
    assert "trimesh.Trimesh" in str(error)
try:
    ls.simplify("mesh.ply", target_percent=10)
except ImportError as error:
    print("a file needs", error.name)
"""

IMPORT = """
import sys
before = set(sys.modules)
import laplacian_simplify as ls
assert ls.__version__.count(".") == 2
print(*sorted({name.split(".")[0] for name in set(sys.modules) - before} & {"numpy", "pymeshlab", "tqdm", "ctypes"}))
"""

# A module of its own: what a pool calls has to be importable where the processes are started anew.
POOL = """
import multiprocessing, sys
import laplacian_simplify as ls
from array_meshes import wave

def work(k):
    vertices, faces = ls.simplify(*wave(), target_percent=10, threads=1 + k % 3)
    return vertices.tobytes() + faces.tobytes()

def main():
    alone = work(2)  # on several threads, which may not be waited for in a copy of this process
    with multiprocessing.get_context(sys.argv[1]).Pool(2) as pool:
        assert set(pool.map(work, range(6))) == {alone}
    print("done")

if __name__ == "__main__":
    main()
"""

COMMA = """
import locale, sys
import laplacian_simplify as ls
from array_meshes import wave

locale.setlocale(locale.LC_ALL, sys.argv[1])
result = ls.simplify(*wave(), target_percent=12.5, feature_weight=2.5)
assert locale.localeconv()["decimal_point"] == sys.argv[2]
print(result.vertices.tobytes().hex(), {**result.report.to_dict(), "seconds": 0})
"""


def _python(*words: object, **environment: str) -> str:
    paths = os.pathsep.join([str(TESTS), *filter(None, [os.environ.get("PYTHONPATH")])])
    variables = {**os.environ, **environment, "PYTHONPATH": paths}
    words = (sys.executable, "-P", *map(str, words))
    done = subprocess.run(words, env=variables, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def test_no_other_library_is_needed() -> None:
    assert _python("-c", WITHOUT_PYMESHLAB) == "a file needs pymeshlab\n"


def test_an_import_loads_nothing_that_takes_time() -> None:
    assert _python("-c", IMPORT) == "\n"


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_pools(method: str, tmp_path: Path) -> None:
    program = tmp_path / "pool.py"
    program.write_text(POOL)
    assert _python(program, method) == "done\n"


def test_a_comma_locale_changes_nothing(german: dict[str, str]) -> None:
    assert _python("-c", COMMA, "de_DE.UTF-8", ",", **german) == _python("-c", COMMA, "C", ".")
