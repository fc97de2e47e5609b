# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other libraries in, meshes of the same type out.

None of the libraries is imported here: an object of one can only exist where its module has been imported. What is
stored at vertices and corners guides the simplification and is interpolated, or goes with those that remain where it
cannot be; what is stored at faces goes with those that remain. Normals are computed anew.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ..arrays import ArrayOptions, needs_quality, simplify_arrays
from ..attributes import Attributes
from ..tables import Filter
from . import face_colors, of_meshio, of_open3d, of_pymeshlab, of_pyvista, of_trimesh
from .library import Library

LIBRARIES = (
    of_trimesh.LIBRARY,
    of_pyvista.PYVISTA,
    of_open3d.LIBRARY,
    of_open3d.TENSORS,
    of_meshio.LIBRARY,
    of_pymeshlab.LIBRARY,
    of_pyvista.VEDO,
)
_ATTRIBUTES = {
    "vertex_attributes": "vertex",
    "corner_attributes": "corner",
    "face_labels": "labels",
    "attribute_kinds": "kinds",
}


def library_of(mesh: object, done: str = "simplified") -> Library:
    """The row of the library that the mesh is of.

    Args:
        mesh: an object of any type.
        done: what was to be done with it.

    Raises:
        TypeError: it is of none; the text lists what is accepted.
    """
    for row in LIBRARIES:
        known = row.type()
        if known is not None and isinstance(mesh, known):
            return row
    names = ", ".join(row.name for row in LIBRARIES)
    kind = f"{type(mesh).__module__}.{type(mesh).__qualname__}".removeprefix("builtins.")
    raise TypeError(
        f"{kind} cannot be {done}; accepted are two NumPy arrays (vertices, faces), the path of a mesh file, "
        f"pymeshlab.MeshSet, {names}"
    )


def simplify_object(
    row: Filter,
    mesh: Any,
    faces: Any,
    numbers: Mapping[str, float],
    of_arrays: Mapping[str, Any],
    return_result: bool,
) -> Any:
    """Simplifies arrays, or a mesh of another library.

    Args:
        row: the filter.
        mesh: the vertices, or the mesh.
        faces: with vertices, else None.
        numbers: checked values of the filter's parameters.
        of_arrays: what only arrays have: fields of ArrayOptions, and keywords of simplify for attributes.
        return_result: return a mesh together with the result.

    Raises:
        TypeError, ValueError: as simplification.simplify.
    """
    given = {name: value for name, value in of_arrays.items() if name in _ATTRIBUTES and value is not None}
    options = ArrayOptions(**{name: value for name, value in of_arrays.items() if name not in _ATTRIBUTES})
    if isinstance(mesh, np.ndarray):
        if faces is None:
            raise TypeError("the faces are missing: simplify(vertices, faces, target_percent=10)")
        if return_result:
            raise TypeError("return_result is for meshes of other libraries; for arrays the result is what is returned")
        return simplify_arrays(row, mesh, faces, numbers, replace(options, attributes=_attributes(given)))
    library = library_of(mesh)
    if faces is not None:
        raise TypeError(f"faces is for arrays; a {library.name} has faces of its own")
    for name in given:
        raise TypeError(f"{name} is for arrays; a {library.name} has attributes of its own")
    options = library.complete(mesh, options, needs_quality(row, numbers))
    vertices, triangles = library.read(mesh)
    attributes = library.attributes(mesh)
    if not numbers.get("keep_attributes", True):
        own = {name: values for name, values in attributes.vertex.items() if name != face_colors.NAME}
        attributes = replace(attributes, vertex=own)
    options = replace(options, attributes=attributes)
    result = simplify_arrays(row, vertices, triangles, numbers, options)
    small = library.build(mesh, result)
    return (small, result) if return_result else small


def _attributes(given: Mapping[str, Any]) -> Attributes:
    """The attributes of arrays.

    Raises:
        TypeError: there is no dictionary where there should be one.
    """
    for name, value in given.items():
        if name != "face_labels" and not isinstance(value, Mapping):
            raise TypeError(f"{name} must be a dictionary of names, not {type(value).__name__}")
    return Attributes(**{_ATTRIBUTES[name]: value for name, value in given.items()})
