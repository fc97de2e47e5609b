# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told of a type of meshes of another library, and what the modules for them share."""

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..arrays import ArrayOptions, Simplified
from ..attributes import Array, Attributes, Kind

Arrays: TypeAlias = tuple[Any, Any]
_NORMALS = {"normals", "normal", "pointnormals", "cellnormals"}


@dataclass(frozen=True)
class Library:
    """A type of meshes of another library."""

    module: str
    type_name: str
    read: Callable[[Any], Arrays]
    """Vertices and faces.

    Raises:
        ValueError: the mesh has something that cannot be simplified; the text says what.
    """
    attributes: Callable[[Any], Attributes]
    """What it stores at vertices and corners; all of it comes back in the result."""
    build: Callable[[Any, Simplified], Any]
    """The result as a mesh, with what the input has beside vertices and faces."""
    complete: Callable[[Any, ArrayOptions, bool], ArrayOptions] = lambda _mesh, options, _quality: options
    """The options with what the mesh itself says: its selection, and its quality where that is asked for."""

    @property
    def name(self) -> str:
        """As messages show it."""
        return f"{self.module}.{self.type_name}"

    def type(self) -> type | None:
        """The type of its meshes; None where the library has not been imported."""
        found: Any = sys.modules.get(self.module)
        for part in self.type_name.split("."):
            found = getattr(found, part, None)
        return found if isinstance(found, type) else None


def require_triangles(all_are: bool, remedy: str) -> None:
    """
    Raises:
        ValueError: not all are triangles.
    """
    if not all_are:
        raise ValueError(f"only triangles can be simplified: {remedy}")


def attributes_of(
    vertex: Mapping[str, Array],
    corner: Mapping[str, Array] | None = None,
    labels: Array | None = None,
    kinds: Mapping[str, Kind] | None = None,
) -> Attributes:
    """The attributes of a mesh. What cannot be interpolated, as it is not finite or of many dimensions, goes with the
    vertices that remain."""
    told: dict[str, Kind] = dict(kinds or {})
    for arrays, most in ((vertex, 2), (corner or {}, 3)):
        for name, values in arrays.items():
            finite = values.dtype.kind != "f" or bool(np.isfinite(values).all())
            if values.ndim > most or not finite:
                told[name] = "origin"
    return Attributes(dict(vertex), dict(corner or {}), labels, told)


def is_normal(name: str) -> bool:
    """Whether it names normals."""
    return name.lower() in _NORMALS


def columns(data: Any) -> dict[str, Array]:
    """Named columns without normals."""
    return {name: np.asarray(data[name]) for name in data.keys() if not is_normal(name)}  # noqa: SIM118


def taken(data: Any, origin: Array) -> dict[str, Array]:
    """The rows of named columns that remain, without normals."""
    return {name: values[origin] for name, values in columns(data).items()}


def normals_like(data: Any, result: Simplified, *, at_faces: bool = False) -> dict[str, Array]:
    """Normals under the names and of the types of those in the data, computed anew: of faces, or of vertices, weighted
    by area. Vertices that were split have the same."""
    names = [name for name in data.keys() if is_normal(name) and np.asarray(data[name]).ndim == 2]  # noqa: SIM118
    if not names:
        return {}
    corners = result.vertices[result.faces].astype(np.float64)
    normals: Array = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    if not at_faces:
        _, place = np.unique(result.vertex_origin, return_inverse=True)
        at = place.reshape(-1)[result.faces.astype(np.intp)].ravel()
        weights = np.repeat(normals, 3, axis=0)
        count = len(result.vertices)
        sums = [np.bincount(at, weights[:, k], minlength=count) for k in range(3)]
        normals = np.stack(sums, axis=1)[place.reshape(-1)]
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    unit = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    return {name: unit.astype(np.asarray(data[name]).dtype) for name in names}
