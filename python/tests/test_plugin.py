# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin is loaded once, into the one pymeshlab that it fits; the wheel brings it along."""

import subprocess
import sys
import sysconfig
import zipfile
from importlib.metadata import requires
from pathlib import Path

import pymeshlab
import pytest
import tomllib
from conftest import SAMPLE_MESHES

import laplacian_simplify as ls
from laplacian_simplify.plugin import check_pymeshlab
from laplacian_simplify.tables import filter_named, filters

PROJECT = Path(__file__).parents[2]


def test_loading_twice_is_loading_once() -> None:
    ls.load()
    plugins = pymeshlab.plugin_number()
    ls.load()
    assert pymeshlab.plugin_number() == plugins
    for row in filters():
        assert pymeshlab.filter_list().count(row.python_name) == 1


@pytest.mark.parametrize("version", ["2025.7", "2023.12.post3", "2026.1"])
def test_every_other_pymeshlab_is_refused(version: str) -> None:
    with pytest.raises(ImportError) as raised:
        check_pymeshlab(version)
    assert f"needs pymeshlab {ls.PYMESHLAB_VERSION}, but {version} is installed" in str(raised.value)
    assert "pip install" in str(raised.value)


def test_the_package_requires_the_version_that_it_checks() -> None:
    project = tomllib.loads((PROJECT / "pyproject.toml").read_text())["project"]
    assert f"pymeshlab=={ls.PYMESHLAB_VERSION}" in project["optional-dependencies"]["meshlab"]
    assert not [name for name in project["dependencies"] if name.startswith("pymeshlab")]
    assert f'pymeshlab=={ls.PYMESHLAB_VERSION}; extra == "meshlab"' in (requires("laplacian-simplify") or [])


def test_without_pymeshlab_files_are_refused_with_the_way_out(tmp_path: Path) -> None:
    """Both where the functions are called and in the process that works for the command."""
    (tmp_path / "pymeshlab.py").write_text("raise AssertionError('imported')")
    code = (
        "import importlib.util, sys; import laplacian_simplify as ls; import laplacian_simplify.plugin as plugin\n"
        "plugin.find_spec = lambda name: None\n"
        "for call in (ls.load, lambda: ls.simplify('none.ply', target_faces=1), lambda: ls.read_mesh('none.ply')):\n"
        "    try: call()\n"
        "    except ImportError as error: print(error)\n"
    )
    words = [sys.executable, "-c", code]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines() == 3 * [
        "files and mesh sets need pymeshlab, which is not installed: "
        "python -m pip install 'laplacian-simplify[meshlab]'"
    ]


def test_importing_loads_nothing() -> None:
    """Nothing that takes its time: the package alone is ready at once."""
    slow = {"pymeshlab", "numpy", "tqdm", "dask", "json", "ctypes", "argparse", "importlib.metadata"}
    code = (
        f"import sys; before = set(sys.modules); import laplacian_simplify; print({slow} & (set(sys.modules) - before))"
    )
    done = subprocess.run([sys.executable, "-P", "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


def test_filters_are_methods_of_mesh_sets() -> None:
    """As MeshLab copies a call for pymeshlab: with every parameter, and choices as their texts."""
    ls.load()
    for row in filters():
        assert callable(getattr(pymeshlab.MeshSet, row.python_name))
    ms = ls.read_mesh(SAMPLE_MESHES / "painted_box.obj")
    row = filter_named("meshing_decimation_laplacian_quadric_edge_collapse")
    defaults = {parameter.id: parameter.default for parameter in row.parameters if parameter.default is not None}
    texts = {parameter.id: parameter.options[int(parameter.default or 0)].text for parameter in row.parameters
             if parameter.options}  # fmt: skip
    report = ms.meshing_decimation_laplacian_quadric_edge_collapse(**{**defaults, **texts, "target_faces": 300})
    assert report["faces"] == ms.current_mesh().face_number() == 300
    assert ms.apply_coord_umbrella_smoothing(steps=1)["moved"] > 0


def test_the_package_has_types(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        assert "laplacian_simplify/py.typed" in archive.namelist()


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    words = [sys.executable, "-m", "pip", "wheel", "--no-deps", "--no-index", "--no-build-isolation", "-w", str(folder)]
    subprocess.run([*words, str(PROJECT)], check=True, capture_output=True)
    return next(folder.glob("*.whl"))


def test_the_wheel_carries_plugin_tables_and_hints(wheel: Path) -> None:
    names = {Path(name).name for name in zipfile.ZipFile(wheel).namelist()}
    assert {
        "libfilter_laplacian_simplify.so",
        "liblaplacian_simplify.so",
        "tables.json",
        "py.typed",
        "entry_points.txt",
    } <= names
    assert wheel.name.startswith("laplacian_simplify-")
    assert "py3-none-" in wheel.name


def test_the_wheel_works_in_a_fresh_environment(wheel: Path, tmp_path: Path) -> None:
    """Its dependencies are lent by this environment, so that nothing is downloaded."""
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(tmp_path / "fresh")], check=True)
    packages = next((tmp_path / "fresh" / "lib").glob("python3.*")) / "site-packages"
    lent = sysconfig.get_paths()["purelib"]
    words = [sys.executable, "-m", "pip", "install", "--no-deps", "--no-index", "--prefix", str(tmp_path / "fresh")]
    subprocess.run([*words, "--ignore-installed", str(wheel)], check=True, capture_output=True)
    (packages / "lent.pth").write_text(lent + "\n")
    command = tmp_path / "fresh" / "bin" / "laplacian-simplify"
    source, target = PROJECT / "sample_meshes" / "flange.ply", tmp_path / "small.ply"
    done = subprocess.run(
        [tmp_path / "fresh" / "bin" / "python", "-I", command, "simplify", source, target, "--faces", "1000"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert target.is_file()
