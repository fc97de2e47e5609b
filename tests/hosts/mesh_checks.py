# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What every filter must have done to a mesh, whatever host ran it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pymeshlab

SINGLE_PRECISION = 1e-6
"""Relative error of a coordinate that a host kept and wrote as float."""


@dataclass(frozen=True)
class MeshData:
    """A mesh file, as pymeshlab reads it."""

    vertices: np.ndarray
    faces: np.ndarray
    quality: np.ndarray
    diagonal: float

    @staticmethod
    def read(file: Path) -> MeshData:
        mesh_set = pymeshlab.MeshSet()
        mesh_set.load_new_mesh(str(file))
        mesh = mesh_set.current_mesh()
        return MeshData(
            mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_scalar_array(), mesh.bounding_box().diagonal()
        )

    def near(self, other: MeshData) -> bool:
        """Whether both have the same faces and, but for rounding, the same vertices."""
        same_faces = np.array_equal(self.faces, other.faces)
        return same_faces and np.allclose(self.vertices, other.vertices, atol=SINGLE_PRECISION * other.diagonal)


def _descriptor(before: MeshData, after: MeshData) -> None:
    assert after.near(before)
    assert after.quality.min() >= 0
    assert 0.1 < after.quality.max() < 2
    assert np.median(after.quality) < 0.05, "most of the part is flat"


def _selection(before: MeshData, after: MeshData) -> None:
    assert after.near(before)
    assert set(np.unique(after.quality)) == {0, 1}, "class_as_quality with two classes"
    assert 0.01 < after.quality.mean() < 0.5


def _decimation(percent: float) -> Callable[[MeshData, MeshData], None]:
    def check(before: MeshData, after: MeshData) -> None:
        target = percent / 100 * len(before.faces)
        assert target - 2 <= len(after.faces) <= target + 1
        assert np.isfinite(after.vertices).all()
        assert np.isclose(after.diagonal, before.diagonal, rtol=0.01)

    return check


def _smooth(before: MeshData, after: MeshData) -> None:
    assert np.array_equal(after.faces, before.faces)
    moved = np.linalg.norm(after.vertices - before.vertices, axis=1)
    assert 1e-4 < moved.max() / before.diagonal < 0.05


@dataclass(frozen=True)
class Expectation:
    """What a filter must have done to the part: by a script, and by a click with its defaults."""

    changes: dict[str, object]
    """Values in the script that are not the defaults."""
    check: Callable[[MeshData, MeshData], None]
    """Of the mesh before and after the script."""
    log_of_defaults: str
    """A regular expression."""


# A filter that is new in the table has to be described here, or its tests fail.
EXPECTATIONS = {
    "descriptor": Expectation({}, _descriptor, r"of 11,840 vertices: from 0 to 0\.\d+"),
    "classify": Expectation({"class_as_quality": True}, _selection, r"[1-9][\d,]* of 11,840 vertices are features"),
    "simplify": Expectation({"target_percent": 10}, _decimation(10), r"23,680 -> 11,840 faces \(50 %\)"),
    "weighted": Expectation({"target_percent": 20}, _decimation(20), r"23,680 -> 11,840 faces \(50 %\)"),
    "lod": Expectation({"percents": "80,50"}, _decimation(50), r"10%: 23,680 -> 2,368 faces \(10 %\)"),
    "smooth": Expectation({}, _smooth, r"[1-9][\d,]* of 11,840 vertices moved"),
}
