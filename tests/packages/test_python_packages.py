# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel and the source distribution in environments that have nothing else."""

import os
import shutil
import sysconfig
import tarfile
import zipfile
from collections.abc import Callable
from email import message_from_bytes
from pathlib import Path

import pytest

from conftest import FLANGE, faces_in, package, run

ARRAYS = """
import sys
import numpy as np
import laplacian_simplify as ls
n = 41
x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))
vertices = np.stack([x, y, np.where(x < 0.5, x, 1 - x)], axis=-1).reshape(-1, 3)
corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
faces = np.concatenate([np.stack([corner, corner + 1, corner + n], 1),
                        np.stack([corner + 1, corner + n + 1, corner + n], 1)])
vertices, faces = ls.simplify(vertices, faces, target_percent=10)
print(0 < len(faces) <= 320, sorted(sys.modules.keys() & {"pymeshlab", "tqdm"}))
"""
FILTER = """
import sys
import pymeshlab
import laplacian_simplify as ls
ls.load()
mesh_set = pymeshlab.MeshSet()
mesh_set.load_new_mesh(sys.argv[1])
mesh_set.apply_filter("meshing_decimation_laplacian_quadric_edge_collapse", target_faces=1000)
print(mesh_set.current_mesh().face_number())
"""
ADVICE = "pip install 'laplacian-simplify[meshlab]'"


@pytest.fixture
def wheel() -> Path:
    return package("*.whl")


def simplify_file(python: Path, target: Path):
    return run(python.parent / "laplacian-simplify", "simplify", FLANGE, target, "--faces", "1000", cwd=target.parent)


def test_the_wheel_says_what_it_is(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as opened:
        names = opened.namelist()
        (metadata,) = [name for name in names if name.endswith(".dist-info/METADATA")]
        fields = message_from_bytes(opened.read(metadata))
    assert "py3-none-manylinux_2_34_x86_64" in wheel.name
    assert fields["License-Expression"] == "GPL-3.0-or-later"
    assert metadata.replace("METADATA", "licenses/LICENSE") in names
    assert fields.get_all("Classifier")
    assert [name for name in names if "Qt5" in name or "meshlab-common" in name] == []


def test_wheel_and_sources_have_the_parts_of_the_page(wheel: Path) -> None:
    """So that nobody needs Node.js, or a network."""
    with zipfile.ZipFile(wheel) as opened:
        names = opened.namelist()
    with tarfile.open(package("*.tar.gz")) as opened:
        sources = opened.getnames()
    for part in ("page.html", "viewer.js", "three.min.js"):
        assert f"laplacian_simplify/pictures/{part}" in names
        assert [name for name in sources if name.endswith(f"python/laplacian_simplify/pictures/{part}")]


def test_arrays_need_the_wheel_and_numpy_alone(
    wheel: Path, fresh_environment: Callable[..., Path], tmp_path: Path
) -> None:
    fresh_environment("numpy")
    python = fresh_environment(wheel, options=("--no-deps",))
    done = run(python, "-I", "-c", ARRAYS, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (0, "True []\n")


def test_files_without_pymeshlab_are_refused_with_the_way_out(
    wheel: Path, fresh_environment: Callable[..., Path], tmp_path: Path
) -> None:
    python = fresh_environment(wheel)
    done = simplify_file(python, tmp_path / "small.ply")
    assert done.returncode == 1
    assert ADVICE in done.stdout
    assert len(done.stdout.splitlines()) == 1
    code = f"import laplacian_simplify as ls; ls.simplify({str(FLANGE)!r}, target_faces=9)"
    assert f"ImportError: files and mesh sets need pymeshlab, which is not installed: python -m {ADVICE}" in (
        run(python, "-I", "-c", code, cwd=tmp_path).stdout
    )


def test_with_pymeshlab_the_filter_and_the_command_run(
    wheel: Path, fresh_environment: Callable[..., Path], tmp_path: Path
) -> None:
    python = fresh_environment(f"{wheel}[meshlab]")
    done = run(python, "-I", "-c", FILTER, FLANGE, cwd=tmp_path)
    assert done.returncode == 0, done.stdout
    assert done.stdout.splitlines()[-1] == "1000"
    done = simplify_file(python, tmp_path / "small.ply")
    assert done.returncode == 0, done.stdout
    assert faces_in(tmp_path / "small.ply") == 1000


def test_the_source_distribution_needs_a_compiler_alone(fresh_environment: Callable[..., Path], tmp_path: Path) -> None:
    """No git, no cmake, no Qt and no MeshLab: the path has the compiler and what it calls, the home is empty."""
    tools = tmp_path / "tools"
    tools.mkdir()
    names = {"cc", "c++", "gcc", "g++", "as", "ld", "ar", "ranlib", "nm", "strip", "objdump", "uname", "sh"}
    names |= {Path(str(sysconfig.get_config_var(name)).split()[0]).name for name in ("CC", "CXX")}
    for name in names:
        (tools / name).symlink_to(str(shutil.which(name)))
    (tmp_path / "home").mkdir()
    environment = {"PATH": str(tools), "HOME": str(tmp_path / "home"), "LC_ALL": "C.UTF-8"}
    if launcher := shutil.which("ccache"):  # it only saves time
        environment |= {"CMAKE_CXX_COMPILER_LAUNCHER": launcher, "CCACHE_DIR": os.environ.get("CCACHE_DIR", "")}
        environment["CCACHE_DIR"] = environment["CCACHE_DIR"] or str(Path.home() / ".cache" / "ccache")
    python = fresh_environment(package("*.tar.gz"), env=environment)
    done = run(python, "-I", "-c", ARRAYS, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (0, "True []\n")
    fresh_environment("pymeshlab")
    code = "import laplacian_simplify as ls; ls.load()"
    assert "was built from its sources without MeshLab" in run(python, "-I", "-c", code, cwd=tmp_path).stdout


def test_the_source_distribution_has_no_tests_and_no_pictures() -> None:
    with tarfile.open(package("*.tar.gz")) as opened:
        folders = {name.split("/")[1] for name in opened.getnames() if "/" in name}
    assert folders == {
        "CMakeLists.txt", "LICENSE", "PKG-INFO", "cmake", "filter_laplacian_simplify", "pyproject.toml", "python",
        "vcg_ext",
    }  # fmt: skip
