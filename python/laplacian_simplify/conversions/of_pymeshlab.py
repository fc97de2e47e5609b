# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single meshes of pymeshlab, without the mesh set that they are in."""

import sys
from dataclasses import replace
from typing import Any

from ..arrays import ArrayOptions, Simplified
from ..attributes import Array, Attributes
from .face_colors import face_colors, label_or_spread
from .library import Arrays, Library, attributes_of


def _read(mesh: Any) -> Arrays:
    return mesh.vertex_matrix(), mesh.face_matrix()


def _complete(mesh: Any, options: ArrayOptions, quality: bool) -> ArrayOptions:
    selected = options.selected
    if selected is None and mesh.selected_face_number() > 0:
        selected = mesh.face_selection_array()
    stored = mesh.vertex_scalar_array() if quality and options.quality is None else options.quality
    return replace(options, selected=selected, quality=stored)


def _attributes(mesh: Any) -> Attributes:
    vertex: dict[str, Array] = {}  # normals are computed from the faces: they say nothing of hard edges
    corner: dict[str, Array] = {}
    labels = None
    if mesh.has_vertex_scalar():
        vertex["scalar"] = mesh.vertex_scalar_array()
    if mesh.has_vertex_color():
        vertex["color"] = mesh.vertex_color_matrix()
    if mesh.has_vertex_tex_coord():
        vertex["vertex uv"] = mesh.vertex_tex_coord_matrix()
    if mesh.has_wedge_tex_coord():
        corner["wedge uv"] = mesh.wedge_tex_coord_matrix().reshape(-1, 3, 2)
    if mesh.has_face_color():
        labels, spread = label_or_spread(*_read(mesh), mesh.face_color_matrix())
        vertex |= spread
    return attributes_of(vertex, corner, labels)


def _build(mesh: Any, result: Simplified) -> Any:
    data: dict[str, Any] = {"vertex_matrix": result.vertices, "face_matrix": result.faces}
    for name, values, parameter in (
        ("scalar", result.vertex_attributes, "v_scalar_array"),
        ("color", result.vertex_attributes, "v_color_matrix"),
        ("vertex uv", result.vertex_attributes, "v_tex_coords_matrix"),
    ):
        if name in values:
            data[parameter] = values[name]
    if "wedge uv" in result.corner_attributes:
        data["w_tex_coords_matrix"] = result.corner_attributes["wedge uv"].reshape(-1, 2)
    if mesh.has_face_scalar():
        data["f_scalar_array"] = mesh.face_scalar_array()[result.face_origin]
    if mesh.has_face_color():
        data["f_color_matrix"] = face_colors(mesh.face_color_matrix(), result)
    return sys.modules["pymeshlab"].Mesh(**data)


LIBRARY = Library("pymeshlab", "Mesh", _read, _attributes, _build, _complete)
