# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the trials of the packages share. scripts/package has built them and runs these."""

import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "tests" / "hosts"))

from display import Display, running_display  # noqa: E402
from filter_scripts import values_of, write_script  # noqa: E402
from host_programs import CACHE  # noqa: E402

PACKAGES = PROJECT / "build" / "packages"
FLANGE = PROJECT / "sample_meshes" / "flange.ply"
Run = subprocess.CompletedProcess


def package(pattern: str) -> Path:
    """The one package whose name matches."""
    (found,) = PACKAGES.glob(pattern)
    return found


def run(*words: str | Path, **options) -> Run:
    """Runs a command in an environment of its own but for what is given; output is kept."""
    return subprocess.run([*map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)


def unpacked(archive: Path, folder: Path) -> Path:
    """The folder of an archive, unpacked with the modes of its files."""
    with zipfile.ZipFile(archive) as opened:
        for row in opened.infolist():
            os.chmod(opened.extract(row, folder), row.external_attr >> 16)
    (top,) = folder.iterdir()
    return top


@pytest.fixture
def fresh_environment(tmp_path: Path) -> Callable[..., Path]:
    """A virtual environment with nothing but what pip installs into it from files; the result is its Python."""

    def make(*packages: str | Path, options: tuple[str, ...] = (), env: dict[str, str] | None = None) -> Path:
        python = tmp_path / "fresh" / "bin" / "python"
        if not python.exists():
            run("/usr/bin/python3", "-m", "venv", tmp_path / "fresh", check=True)
        words = [python, "-m", "pip", "install", "--no-index", "--find-links", CACHE / "wheelhouse", *options]
        done = run(*words, *packages, env=env, cwd=tmp_path)
        assert done.returncode == 0, done.stdout
        return python

    return make


@pytest.fixture(scope="session")
def display(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Display]:
    with running_display(tmp_path_factory.mktemp("display") / "server.log") as running:
        yield running


@pytest.fixture
def script(tmp_path: Path) -> Path:
    """A script for MeshLab that keeps 1000 faces."""
    tables = json.loads((PROJECT / "build" / "pymeshlab-2025.7" / "tables.json").read_text(encoding="utf-8"))
    (row,) = [row for row in tables["filters"] if row["id"] == "simplify"]
    return write_script(tmp_path / "script.mlx", (row, values_of(row, target_faces=1000, target_percent=0)))


def faces_in(file: Path) -> int:
    """How many faces the header of a PLY file announces."""
    header = file.read_bytes().partition(b"end_header")[0].decode("ascii")
    return int(header.partition("element face ")[2].split()[0])
