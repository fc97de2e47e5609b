# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The zips: each into a MeshLab of its version, whose filter then runs; others are told which file to take."""

import os
import shutil
from pathlib import Path

import pytest

import script_hosts
from conftest import FLANGE, Run, faces_in, package, run, unpacked
from display import Display
from host_programs import HostProgram, built_plugin, install_host

VERSIONS = ["2020.09", "2022.02", "2025.07"]
PLUGIN = "libfilter_laplacian_simplify.so"


def zip_folder(version: str, folder: Path) -> Path:
    return unpacked(package(f"*-meshlab-{version}-float-linux-x86_64.zip"), folder / "unpacked")


def empty_host(version: str, folder: Path) -> tuple[HostProgram, Path]:
    """MeshLab of that version without the plugin, and where it looks for it; its library lies where MeshLab has it."""
    host = install_host(version, folder / "host", built_plugin(f"meshlab-{version}"))
    (installed,) = host.prefix.parent.rglob(PLUGIN)
    installed.unlink()
    libraries = host.prefix / "lib" / host.libraries.name / "meshlab"
    shutil.copy(host.libraries / "meshlab" / "libmeshlab-common.so", libraries)
    for program in (host.prefix / "bin").glob("meshlab*"):  # a link would lead out of the prefix
        copy = program.resolve()
        program.unlink()
        shutil.copy(copy, program)
    return host, installed


def call(script: Path, home: Path, *arguments: str | Path) -> Run:
    return run(script, *arguments, env={"HOME": str(home), "PATH": "/usr/bin:/bin", "LANG": "de_DE.UTF-8"})


def files_under(folder: Path) -> set[Path]:
    """All files and folders but those that the programs themselves make in a home."""
    return {path for path in folder.rglob("*") if not {"run", ".config", "script_runner"} & set(path.parts)}


@pytest.mark.parametrize("version", VERSIONS)
def test_installed_it_runs_and_uninstalled_nothing_is_left(
    version: str, display: Display, script: Path, tmp_path: Path
) -> None:
    (host, plugin), folder = empty_host(version, tmp_path), zip_folder(version, tmp_path)
    before = files_under(tmp_path / "host")
    done = call(folder / "install.sh", host.home, host.prefix / "bin" / "meshlab")
    assert done.returncode == 0, done.stdout
    assert list(host.prefix.parent.rglob(PLUGIN)) == [plugin]
    if version == "2020.09":
        start = script_hosts.meshlabserver(host, display.name)
    else:
        start = script_hosts.script_runner(host, display.name, plugin_folder=plugin.parent)
    ran = start(script, FLANGE, tmp_path / "small.ply")
    assert ran.status == 0, ran.output
    assert faces_in(tmp_path / "small.ply") == 1000
    done = call(folder / "uninstall.sh", host.home, host.prefix / "bin" / "meshlab")
    assert done.returncode == 0, done.stdout
    assert files_under(tmp_path / "host") <= before


@pytest.mark.parametrize("version", VERSIONS)
def test_another_meshlab_is_told_which_file_to_take(version: str, tmp_path: Path) -> None:
    other = VERSIONS[VERSIONS.index(version) - 1]
    (host, _), folder = empty_host(other, tmp_path), zip_folder(version, tmp_path)
    for name in ("install.sh", "uninstall.sh"):
        done = call(folder / name, host.home, host.prefix / "bin" / "meshlab")
        assert done.returncode == 1
        wanted = package(f"*-meshlab-{other}-float-linux-x86_64.zip").name
        assert f"fits MeshLab {version} only, but " in done.stdout
        assert f" is {other}; take {wanted} instead" in done.stdout
    assert list(host.prefix.parent.rglob(PLUGIN)) == []


def test_an_appimage_has_no_library_to_compare(tmp_path: Path) -> None:
    folder = zip_folder("2025.07", tmp_path)
    home, program = tmp_path / "home", tmp_path / "apps" / "MeshLab.AppImage"
    program.parent.mkdir()
    program.write_text("")
    done = call(folder / "install.sh", home, program)
    assert done.returncode == 0, done.stdout
    assert (home / ".local/share/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/2025.07" / PLUGIN).is_file()
    assert call(folder / "uninstall.sh", home, program).returncode == 0
    assert os.listdir(home / ".local" / "share") == []


def test_2020_has_to_be_found(tmp_path: Path) -> None:
    done = call(zip_folder("2020.09", tmp_path) / "install.sh", tmp_path)
    assert done.returncode == 1
    assert "name it: " in done.stdout
