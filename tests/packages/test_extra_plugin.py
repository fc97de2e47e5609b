# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder for MeshLab's extra-plugins collection, built by MeshLab's own build in a copy of its sources."""

import shutil
from pathlib import Path

import pytest

import script_hosts
from conftest import FLANGE, PROJECT, faces_in, package, run, unpacked
from display import Display
from host_programs import CACHE, install_host

WORK = PROJECT / "build" / "packaging" / "meshlab"  # it stays, so that only what has changed is compiled again
NAME = "filter_laplacian_simplify"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """MeshLab's sources as links, with the folder among its plugins."""
    copy = WORK / "source"
    shutil.rmtree(copy, ignore_errors=True)
    copy.mkdir(parents=True)
    run("cp", "-as", f"{CACHE}/sources/meshlab-2025.07/.", copy, check=True)
    folder = unpacked(package("*-extra-plugin.zip"), tmp_path / "unpacked") / NAME
    run("cp", "-rp", folder, copy / "src" / "meshlabplugins", check=True)
    return copy


def test_it_is_built_in_a_meshlab_source_tree_and_runs(
    tree: Path, display: Display, script: Path, tmp_path: Path
) -> None:
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DMESHLAB_ALLOW_OPTIONAL_EXTERNAL_LIBRARIES=OFF"]
    options.append(f"-DMESHLAB_PLUGINS=meshlabplugins/{NAME}")
    if shutil.which("ccache"):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    configured = run("cmake", "-S", tree, "-B", WORK / "build", "-G", "Ninja", *options)
    assert configured.returncode == 0, configured.stdout
    built = run("cmake", "--build", WORK / "build", "--target", NAME)
    assert built.returncode == 0, built.stdout
    (plugin,) = (WORK / "build").rglob(f"lib{NAME}.so")
    host = install_host("2025.07", tmp_path / "host", plugin)
    (installed,) = host.home.rglob(plugin.name)
    runner = script_hosts.script_runner(host, display.name, plugin_folder=installed.parent)
    ran = runner(script, FLANGE, tmp_path / "small.ply")
    assert ran.status == 0, ran.output
    assert faces_in(tmp_path / "small.ply") == 1000
