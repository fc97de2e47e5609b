# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sample meshes, bad files, and the command as users run it."""

import subprocess
import sys
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

SAMPLE_MESHES = Path(__file__).parents[2] / "sample_meshes"
SAMPLE_NAMES = (*sorted(path.name for path in SAMPLE_MESHES.glob("*.ply")), "painted_box.obj")


def run_command(*arguments: object, cwd: Path | None = None) -> "subprocess.CompletedProcess[str]":
    """python -m laplacian_simplify, with its streams caught."""
    words = [sys.executable, "-P", "-m", "laplacian_simplify", *map(str, arguments)]
    return subprocess.run(words, cwd=cwd, capture_output=True, text=True, timeout=300, check=False)


def faces_in(path: Path) -> int:
    """Faces of a mesh file; the mesh set is held on to, because its mesh goes with it."""
    import laplacian_simplify as ls

    mesh_set = ls.read_mesh(path)
    return mesh_set.current_mesh().face_number()


def positions_and_faces(mesh_set) -> tuple[np.ndarray, np.ndarray]:
    mesh = mesh_set.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix()


def non_manifold_edges(faces: np.ndarray) -> int:
    """Edges of three or more faces."""
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    return sum(count > 2 for count in Counter(map(tuple, edges)).values())


def assert_one_line(text: str) -> None:
    """A message for people: one line, and no trace of a crash."""
    assert text.startswith("laplacian-simplify"), text
    assert text.count("\n") == 1, text
    assert "Traceback" not in text


@pytest.fixture
def german(tmp_path: Path) -> dict[str, str]:
    """The variables of an environment in which de_DE.UTF-8, with its decimal comma, can be set."""
    folder = tmp_path / "locales"
    folder.mkdir()
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], check=True, capture_output=True)
    return {"LOCPATH": str(folder)}


@pytest.fixture
def load_sample():
    """Loads a sample mesh into a new mesh set."""
    import pymeshlab

    import laplacian_simplify as ls

    ls.load()

    def load(name: str) -> "pymeshlab.MeshSet":
        return ls.read_mesh(SAMPLE_MESHES / name)

    return load
