# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every code block of the pages runs. Those that are not run are in NOT_RUN, with the reason."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

import pytest
from code_blocks import PROJECT, Block, blocks_of, pages

sys.path.insert(0, str(PROJECT / "tests" / "hosts"))
from host_programs import CACHE, built_plugin, install_host  # noqa: E402

NOT_RUN = {
    ("README.md", "scripts/simplify"): "python/tests/test_readme.py runs it; the other line is scripts/test itself",
    ("README.md", "<!DOCTYPE FilterScript>"): "python/tests/test_readme.py runs it",
    ("CONTRIBUTING.md", "cmake -B build/mine"): "needs a MeshLab that somebody built",
    ("python/README.md", "pip install laplacian_simplify-"): "needs a source tree of MeshLab; tests/packages installs",
    ("docs/recipes.md", "import bpy"): "needs Blender, 350 MB; tried with bpy 5.0.1",
    ("docs/scale.md", "laplacian-simplify huge"): "for a mesh larger than memory; python/tests/test_huge.py runs it",
    ("docs/scale.md", "dask scheduler"): "needs several machines; python/tests/test_batch.py has a scheduler",
    ("docs/scale.md", "from dask_jobqueue"): "needs a cluster with SLURM",
}
"""By page and the beginning of the block."""

PASSED_OVER = {
    "pip install": "tests/packages installs into empty environments",
    "python -m pip install": "the same",
    "scripts/install": "tests/scripts/test_install.py does",
    "snakemake": "not among the pinned packages; tried with Snakemake 9",
}
"""Lines of shell that are not run, by their beginning."""

LANGUAGES = {"sh", "python"}
ONLY_FILES = {"cpp", "cmake", "xml"}

PREPARED = {
    "python/README.md": """
import gzip, shutil, numpy as np, trimesh
shutil.copy("sample_meshes/flange.ply", "input.ply")
mesh = trimesh.load("input.ply")
mesh.export("part.stl"), mesh.export("small.ply"), mesh.export("output_of_another_tool.stl")
with gzip.open("input.stl.gz", "wb") as file:
    file.write(mesh.export(file_type="stl"))
vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
colors = np.zeros((len(vertices), 4), np.uint8)
kelvin, uv = np.zeros(len(vertices)), np.zeros((len(faces), 3, 2))
materials = np.zeros(len(faces), int)
""",
    "docs/scale.md": """
import pathlib, shutil
pathlib.Path("scans/more").mkdir(parents=True, exist_ok=True)
shutil.copy("sample_meshes/flange.ply", "scans")
shutil.copy("sample_meshes/painted_box.obj", "scans/more")
""",
}
"""Python that runs before every block of a page: what it speaks of as the reader's own."""


def is_run(block: Block) -> bool:
    return not any(page == block.page and block.text.startswith(start) for page, start in NOT_RUN)


def shell_that_runs(block: Block) -> Block:
    kept = [line for line in block.text.splitlines() if not line.startswith(tuple(PASSED_OVER))]
    return Block(**{**asdict(block), "text": "\n".join(kept)}) if block.language == "sh" else block


def pages_with_code() -> list[str]:
    wanted = LANGUAGES | ONLY_FILES
    return [page for page in pages() if any(block.language in wanted and is_run(block) for block in blocks_of(page))]


def write_program(file: Path, *command: object) -> None:
    words = " ".join(shlex.quote(str(word)) for word in command)
    file.write_text(f'#!/bin/sh\nexec {words} "$@"\n')
    file.chmod(0o755)


@pytest.fixture(scope="session")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The commands that are in the path of a reader who has installed the package and MeshLab 2020.09."""
    folder = tmp_path_factory.mktemp("bin")
    for name in ("python", "python3"):
        write_program(folder / name, sys.executable)
    compiler = ["ccache"] if shutil.which("ccache") else []
    text = f'#!/bin/sh\nexec {" ".join(compiler)} g++ "$@" -O0\n'  # compiles in a third of the time
    (folder / "c++").write_text(text)
    (folder / "c++").chmod(0o755)
    write_program(folder / "laplacian-simplify", sys.executable, "-P", "-m", "laplacian_simplify")
    host = install_host("2020.09", tmp_path_factory.mktemp("meshlab-2020.09"), built_plugin("meshlab-2020.09"))
    settings = [f"{name}={value}" for name, value in host.environment("").items() if name != "DISPLAY"]
    write_program(folder / "meshlabserver", "env", *settings, *host.command("meshlabserver"))
    return folder


@pytest.fixture
def reader(tmp_path: Path, programs: Path) -> dict[str, str]:
    """Environment of a reader in ``tmp_path``, which looks like a checkout of the project."""
    for name in ("sample_meshes", "vcg_ext", "cmake", "CMakeLists.txt", "docs"):
        (tmp_path / name).symlink_to(PROJECT / name)
    paths = os.pathsep.join([str(programs), os.environ["PATH"]])
    vcglib = CACHE / "sources" / "meshlab-2025.07" / "src" / "vcglib"
    return {**os.environ, "PATH": paths, "LAPLACIAN_SIMPLIFY": str(PROJECT), "VCGLIB": str(vcglib), "CXX": "c++"}


@pytest.mark.parametrize("page", pages_with_code())
def test_blocks_run(page: str, tmp_path: Path, reader: dict[str, str]) -> None:
    blocks = [shell_that_runs(block) for block in blocks_of(page) if is_run(block)]
    runs = [block for block in blocks if block.language in LANGUAGES or block.file or block.is_output]
    own = Block(page, 1, "python", PREPARED.get(page, ""))
    steps = [step for block in runs for step in ([block] if block.is_output else [own, block])]
    plan = tmp_path / "blocks.json"
    plan.write_text(json.dumps([asdict(step) for step in steps]))
    command = [sys.executable, PROJECT / "tests" / "documentation" / "run_page.py", plan]
    done = subprocess.run(command, cwd=tmp_path, env=reader, capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, done.stderr


def test_every_block_says_what_it_is() -> None:
    """A language that is run, a file that others use, or ``text``, which nobody would run."""
    blocks = [block for page in pages() for block in blocks_of(page) if is_run(block)]
    known = LANGUAGES | {"text"}
    unknown = [block for block in blocks if block.language not in known and not block.file]
    assert [f"{block.page}:{block.line} {block.language or 'no language'}" for block in unknown] == []
    assert len(blocks) > 20


def test_every_exception_is_needed() -> None:
    blocks = [block for page in pages() for block in blocks_of(page)]
    starts = [(block.page, block.text) for block in blocks]
    idle = [key for key in NOT_RUN if not any(page == key[0] and text.startswith(key[1]) for page, text in starts)]
    idle += [start for start in PASSED_OVER if not any(f"\n{start}" in f"\n{block.text}" for block in blocks)]
    idle += [page for page in PREPARED if page not in pages_with_code()]
    assert idle == []


def test_the_reference_has_every_public_name() -> None:
    import laplacian_simplify as ls

    page = (PROJECT / "docs" / "python_api.md").read_text(encoding="utf-8")
    assert [name for name in ls.__all__ if f":: {name}\n" not in page] == []
