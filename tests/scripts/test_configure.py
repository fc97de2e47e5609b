# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A MeshLab that the plugin cannot fit is refused when the build is configured, with a sentence that says why."""

import os
import subprocess
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "laplacian-simplify"


def sources(version: str) -> Path:
    return CACHE / "sources" / f"meshlab-{version}"


def library(version: str) -> Path:
    return next((CACHE / "hosts" / f"meshlab-{version}").rglob("libmeshlab-common.so"))


def wheel_library() -> Path:
    return next((CACHE / "python").rglob("libmeshlab-common.so"))


def configure(build: Path, **settings: object) -> subprocess.CompletedProcess:
    command = ["cmake", "-S", PROJECT, "-B", build, "-G", "Ninja"]
    command += [f"-D{name}={value}" for name, value in settings.items()]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True)


def assert_refused(done: subprocess.CompletedProcess, *words: str) -> None:
    assert done.returncode != 0
    message = " ".join(done.stderr.split())
    for word in words:
        assert word in message


@pytest.mark.parametrize("version", ["2020.09", "2022.02", "2025.07"])
def test_any_meshlab_can_be_named(tmp_path: Path, version: str) -> None:
    settings = {"MESHLAB_SOURCE_DIR": sources(version), "MESHLAB_COMMON_LIBRARY": library(version)}
    done = configure(tmp_path, MESHLAB_SCALAR="float", **settings)
    assert done.returncode == 0, done.stderr
    assert f"Plugin for MeshLab {version}, float" in done.stdout


def test_double_is_refused_for_2020(tmp_path: Path) -> None:
    settings = {"MESHLAB_SOURCE_DIR": sources("2020.09"), "MESHLAB_COMMON_LIBRARY": library("2020.09")}
    assert_refused(configure(tmp_path, MESHLAB_SCALAR="double", **settings), "double", "cannot fit MeshLab 2020.09")


def test_scalar_of_another_build_is_refused(tmp_path: Path) -> None:
    settings = {"MESHLAB_SOURCE_DIR": sources("2025.07")}
    done = configure(tmp_path / "a", MESHLAB_SCALAR="double", MESHLAB_COMMON_LIBRARY=library("2025.07"), **settings)
    assert_refused(done, "MESHLAB_SCALAR = double cannot fit", "it was built with float")
    done = configure(tmp_path / "b", MESHLAB_SCALAR="float", MESHLAB_COMMON_LIBRARY=wheel_library(), **settings)
    assert_refused(done, "MESHLAB_SCALAR = float cannot fit", "it was built with double")


def test_word_that_is_no_scalar_is_refused(tmp_path: Path) -> None:
    settings = {"MESHLAB_SOURCE_DIR": sources("2025.07"), "MESHLAB_COMMON_LIBRARY": library("2025.07")}
    assert_refused(configure(tmp_path, MESHLAB_SCALAR="half", **settings), "'half' is neither float nor double")


def test_library_of_another_version_is_refused(tmp_path: Path) -> None:
    settings = {"MESHLAB_SOURCE_DIR": sources("2025.07"), "MESHLAB_COMMON_LIBRARY": library("2022.02")}
    assert_refused(configure(tmp_path, MESHLAB_SCALAR="float", **settings), "are MeshLab 2025.07", "is 2022.02")


@pytest.mark.parametrize("version", ["2020.12", "2021.07", "2026.01", "trunk"])
def test_unknown_version_is_refused(tmp_path: Path, version: str) -> None:
    tree = tmp_path / "meshlab"
    tree.mkdir()
    (tree / "ML_VERSION").write_text(version)
    (tree / "src").symlink_to(sources("2025.07") / "src")
    settings = {"MESHLAB_SOURCE_DIR": tree, "MESHLAB_COMMON_LIBRARY": library("2025.07")}
    done = configure(tmp_path / "build", MESHLAB_SCALAR="float", **settings)
    assert_refused(done, f"'{version}' is unknown", "it fits 2020.09 and 2022.02 to 2025.07")


def test_missing_library_is_refused(tmp_path: Path) -> None:
    settings = {"MESHLAB_SOURCE_DIR": sources("2025.07"), "MESHLAB_COMMON_LIBRARY": tmp_path / "none.so"}
    assert_refused(configure(tmp_path, MESHLAB_SCALAR="float", **settings), "none.so' does not exist")


def test_folder_without_meshlab_is_refused(tmp_path: Path) -> None:
    assert_refused(configure(tmp_path / "build", MESHLAB_SOURCE_DIR=tmp_path), "is no MeshLab source tree")


def test_host_that_was_not_fetched_names_the_command(tmp_path: Path) -> None:
    done = configure(tmp_path, LAPLACIAN_SIMPLIFY_HOST="meshlab-1999.01")
    assert_refused(done, "'meshlab-1999.01' is not there", "scripts/hosts meshlab-1999.01")
