# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The corpus: bad and odd meshes by rules, always the same ones, in families of which each has its parameters."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np


@dataclass(frozen=True, eq=False)
class HostileMesh:
    """One mesh, and what a host may hold beside it."""

    name: str
    vertices: np.ndarray
    """float64, (n, 3)."""
    faces: np.ndarray
    """int32, (m, 3)."""
    data: dict[str, np.ndarray] = field(default_factory=dict)
    """Colors, texture coordinates and quality, by the names of pymeshlab.Mesh."""
    selected_faces: np.ndarray | None = None
    """bool, (m,)."""
    selected_vertices: np.ndarray | None = None
    """bool, (n,)."""
    deleted_faces: np.ndarray | None = None
    """bool, (m,): removed in the host before the filter runs."""

    @property
    def indices_are_valid(self) -> bool:
        """Others can only be in files and arrays: no host makes such a mesh."""
        return not self.faces.size or (self.faces.min() >= 0 and self.faces.max() < len(self.vertices))


def mesh(name: str, shape: tuple[Any, Any], **more: Any) -> HostileMesh:
    points = np.ascontiguousarray(np.reshape(shape[0], (-1, 3)), dtype=np.float64)
    faces = np.ascontiguousarray(np.reshape(shape[1], (-1, 3)), dtype=np.int32)
    return HostileMesh(name, points, faces, **more)


Family = Callable[[], Iterator[HostileMesh]]


def corpus() -> list[HostileMesh]:
    """All of them, in one order."""
    import attribute_families
    import coordinate_families
    import face_families
    import surface_families

    families: list[Family] = [
        family
        for module in (coordinate_families, face_families, surface_families, attribute_families)
        for family in module.FAMILIES
    ]
    with np.errstate(all="ignore"):
        return [each for family in families for each in family()]
