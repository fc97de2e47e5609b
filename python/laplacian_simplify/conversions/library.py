# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told of a type of meshes of another library, and what the modules for them share."""

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..arrays import ArrayOptions, Simplified
from ..attributes import Array, Attributes, Kind, is_normal, kind_of

Arrays: TypeAlias = tuple[Any, Any]


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
            columns_of = values.shape[-1] if values.ndim == most else 1
            is_kept = values.dtype.kind != "f" or bool(np.isfinite(values).all())
            is_kept |= values.ndim == most and kind_of(name, values, columns_of) == "normal"
            if values.ndim > most or not is_kept:
                told[name] = "origin"
    return Attributes(dict(vertex), dict(corner or {}), labels, told)


def columns(data: Any) -> dict[str, Array]:
    """Named columns."""
    return {name: np.asarray(data[name]) for name in data.keys()}  # noqa: SIM118


def of_faces(data: Any, result: Simplified) -> dict[str, Array]:
    """The rows of named columns that remain. Normals are computed anew."""
    taken = {name: values[result.face_origin] for name, values in columns(data).items()}
    names = [name for name, values in taken.items() if is_normal(name) and values.ndim == 2]
    if names:
        corners = result.vertices[result.faces].astype(np.float64)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        unit = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
        taken |= {name: unit.astype(taken[name].dtype) for name in names}
    return taken
