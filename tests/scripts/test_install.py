# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/install puts the plugin where the MeshLab that it is given looks for plugins."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
CACHE_HOME = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
PLUGIN = "libfilter_laplacian_simplify.so"


def root_of(version: str) -> Path:
    return CACHE_HOME / "laplacian-simplify" / "hosts" / f"meshlab-{version}" / "root"


def install(home: Path, *arguments: Path) -> subprocess.CompletedProcess:
    """Runs the script as a user with a new home."""
    environment = {key: value for key, value in os.environ.items() if key != "XDG_DATA_HOME"}
    environment |= {"HOME": str(home), "XDG_CACHE_HOME": str(CACHE_HOME), "LANG": "de_DE.UTF-8"}
    command = [str(PROJECT / "scripts" / "install"), *map(str, arguments)]
    return subprocess.run(command, env=environment, capture_output=True, text=True)


@pytest.mark.parametrize("version", ["2022.02", "2025.07"])
def test_later_versions_find_it_in_the_home(tmp_path: Path, version: str) -> None:
    done = install(tmp_path, root_of(version) / "usr/bin/meshlab")
    assert done.returncode == 0, done.stderr
    installed = tmp_path / ".local/share/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins" / version / PLUGIN
    assert installed.is_file()
    assert f"Installed: {installed}" in done.stderr


def test_2020_finds_it_among_its_own(tmp_path: Path) -> None:
    libraries = next(root_of("2020.09").glob("usr/lib/*/meshlab"))
    copy = tmp_path / "prefix/lib" / libraries.parent.name / "meshlab"
    (copy / "plugins").mkdir(parents=True)
    shutil.copy(libraries / "libmeshlab-common.so", copy)
    (tmp_path / "prefix/bin").mkdir()
    shutil.copy(root_of("2020.09") / "usr/bin/meshlab", tmp_path / "prefix/bin")
    done = install(tmp_path, tmp_path / "prefix/bin/meshlab")
    assert done.returncode == 0, done.stderr
    assert (copy / "plugins" / PLUGIN).is_file()


def test_program_without_library_is_refused(tmp_path: Path) -> None:
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin/meshlab").write_text("")
    done = install(tmp_path, tmp_path / "bin/meshlab")
    assert done.returncode == 1
    assert "no libmeshlab-common.so lies near" in done.stderr


def test_missing_program_is_refused(tmp_path: Path) -> None:
    done = install(tmp_path, tmp_path / "meshlab")
    assert done.returncode == 1
    assert "does not exist" in done.stderr
