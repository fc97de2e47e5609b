# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes whose attributes are known everywhere."""

import numpy as np
from array_meshes import wave

CELLS = 3
"""The six sides of the box lie in the cells of a texture of 3 by 2, within a margin."""
_MARGIN = 0.02


def sheet(side: int = 30) -> tuple[np.ndarray, np.ndarray]:
    """A flat square from 0 to 3 with an open border."""
    vertices, faces = wave(side)
    return vertices * [1, 1, 0], faces


def affine(points: np.ndarray) -> np.ndarray:
    """Texture coordinates that are affine in the place, (n, 2)."""
    return points[..., :2] @ [[0.2, 0.1], [-0.05, 0.3]] + [0.2, 0.05]


def textured_box(side: int = 21) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices, faces and a uv a vertex of a bulging box whose sides have vertices of their own along its edges."""
    at = np.linspace(-1, 1, side)
    s, t = (grid.ravel() for grid in np.meshgrid(at, at))
    cells = np.stack([(s + 1) / 2, (t + 1) / 2], axis=1) * (1 - 2 * _MARGIN) + _MARGIN
    axes = np.eye(3)
    vertices, faces, texture = [], [], []
    for k in range(6):
        out = axes[k % 3] * (1 if k < 3 else -1)
        u = axes[(k + 1) % 3] * (1 if k < 3 else -1)
        v = axes[(k + 2) % 3]
        flat = out + s[:, None] * u + t[:, None] * v
        vertices.append(flat / (1 + 0.3 * np.linalg.norm(flat, axis=1, keepdims=True)))
        faces.append(wave(side)[1] + k * side * side)
        texture.append(np.add(cells, [k % CELLS, k // CELLS]) / [CELLS, 2])
    places = np.round(np.concatenate(vertices), 9)  # on both sides of an edge the same
    return places, np.concatenate(faces), np.concatenate(texture)


def shaded_box() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The box with vertices of its own on every side, and normals of those: hard edges."""
    vertices, faces, _ = textured_box()
    corners = vertices[faces]
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, faces[:, k], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    return vertices, faces, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def cells_of(corners: np.ndarray) -> np.ndarray:
    """The cell of every face's three corners, (m, 3)."""
    column, row = np.floor(corners[..., 0] * CELLS), np.floor(corners[..., 1] * 2)
    return (column + CELLS * row).astype(int)


def side_of(corners: np.ndarray) -> np.ndarray:
    """The side of the box that every face is on, by the middle of its corners, (m,)."""
    middle = corners.mean(axis=1)
    axis = np.abs(middle).argmax(axis=1)
    return axis + 3 * (middle[np.arange(len(middle)), axis] < 0)


def open_edges(vertices: np.ndarray, faces: np.ndarray) -> int:
    """Edges of one face, where vertices at the same place are one."""
    _, place = np.unique(vertices, axis=0, return_inverse=True)
    at = place.reshape(-1)[faces]
    ends = np.sort(np.concatenate([at[:, [0, 1]], at[:, [1, 2]], at[:, [2, 0]]]), axis=1)
    _, count = np.unique(ends, axis=0, return_counts=True)
    return int((count == 1).sum())
