# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as arrays, and as a mesh set for the filter."""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from conftest import SAMPLE_MESHES

import laplacian_simplify as ls

UP = np.array([0, 0, 0.25])


@cache
def sample_arrays(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a sample mesh; nobody can change them."""
    mesh_set = ls.read_mesh(SAMPLE_MESHES / name)
    mesh = mesh_set.current_mesh()
    arrays = mesh.vertex_matrix().copy(), mesh.face_matrix().copy()
    for array in arrays:
        array.setflags(write=False)
    return arrays


def wave(side: int = 30) -> tuple[np.ndarray, np.ndarray]:
    """A relief of 2 (side - 1)^2 faces with an open border."""
    x, y = np.meshgrid(np.linspace(0, 3, side), np.linspace(0, 3, side))
    vertices = np.stack([x.ravel(), y.ravel(), (np.sin(2 * x) * np.cos(y)).ravel()], axis=1)
    at = np.arange(side * side).reshape(side, side)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    return vertices, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def mesh_set_of(vertices: np.ndarray, faces: np.ndarray, **data: Any):
    """The same mesh for the filter."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(vertices.astype(np.float64), faces.astype(np.int32), **data))
    return mesh_set


def write_off(path: Path, vertices: np.ndarray, faces: np.ndarray) -> Path:
    """The mesh as a file, to the last bit."""
    rows = [f"{x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()] + [f"3 {a} {b} {c}" for a, b, c in faces.tolist()]
    path.write_text("\n".join(["OFF", f"{len(vertices)} {len(faces)} 0", *rows, ""]), encoding="utf-8")
    return path
