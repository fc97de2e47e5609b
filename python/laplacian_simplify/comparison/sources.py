# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of any kind as surfaces: files, arrays, and meshes of other libraries."""

from os import PathLike, fspath
from typing import Any

import numpy as np

from ..conversions import library_of
from ..files.errors import printable
from ..files.reading import read_data
from ..files.source import STANDARD_INPUT
from ..running import is_mesh_source
from .surface import Surface, checked_surface


def surface_of(mesh: Any, letter: str) -> Surface:
    """The surface of a mesh.

    Args:
        mesh: the path of a file, a pair of arrays (vertices, faces), a pymeshlab.MeshSet, or a mesh of another library
            that simplify takes.
        letter: how messages name what has no name of its own.

    Raises:
        TypeError: it is something else.
        ValueError: it is no surface that can be measured.
        OSError: the file cannot be read.
    """
    if isinstance(mesh, str | PathLike):
        data = read_data(mesh)
        name = "standard input" if mesh == STANDARD_INPUT else printable(fspath(mesh))
        return checked_surface(name, data.vertices, data.triangles)
    if is_mesh_source(mesh):
        if mesh.mesh_number() == 0:
            raise ValueError(f"{letter} is a mesh set without a mesh")
        mesh = mesh.current_mesh()
    pair = _pair(mesh)
    if pair is None:
        pair = library_of(mesh, "compared").read(mesh)
    vertices, faces = pair
    _require(letter, "vertices", vertices, "fiu")
    _require(letter, "faces", faces, "iu")
    return checked_surface(letter, vertices, faces)


def _pair(mesh: Any) -> tuple[Any, Any] | None:
    """The arrays of a pair of them, as what simplify returns for arrays is, too."""
    from ..arrays import Simplified

    if isinstance(mesh, Simplified):
        return mesh.vertices, mesh.faces
    is_pair = isinstance(mesh, tuple | list) and len(mesh) == 2
    return (mesh[0], mesh[1]) if is_pair else None


def _require(letter: str, name: str, array: Any, kinds: str) -> None:
    if not isinstance(array, np.ndarray) or array.dtype.kind not in kinds:
        kind = "of integers" if kinds == "iu" else "of numbers"
        raise TypeError(f"the {name} of {letter} must be a NumPy array {kind}, not {type(array).__name__}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"the {name} of {letter} have the shape {array.shape}, not (n, 3)")
