# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of trimesh. Texture coordinates are those of vertices, which trimesh doubles along seams."""

import sys
from typing import Any

import numpy as np

from ..arrays import Simplified
from ..attributes import Array, Attributes
from .face_colors import face_colors, label_or_spread
from .library import Arrays, Library, attributes_of, columns, of_faces

_COLORS = "visual.vertex_colors"
_NORMALS = "mesh.vertex_normals"
_TEXTURE = "visual."
"""Before the names of what belongs to the texture."""


def _read(mesh: Any) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def _attributes(mesh: Any) -> Attributes:
    vertex = columns(mesh.vertex_attributes)
    vertex |= _of_normals(mesh)
    visual, labels = mesh.visual, None
    if visual.kind == "texture":
        vertex |= {_TEXTURE + name: values for name, values in _of_texture(visual).items()}
        if visual.face_materials is not None:
            labels = np.asarray(visual.face_materials)
    elif visual.kind == "vertex":
        vertex[_COLORS] = np.asarray(visual.vertex_colors)
    elif visual.kind == "face":
        labels, spread = label_or_spread(mesh.vertices, mesh.faces, np.asarray(visual.face_colors))
        vertex |= spread
    return attributes_of(vertex, labels=labels, kinds=dict.fromkeys(_of_normals(mesh), "normal"))


def _of_normals(mesh: Any) -> dict[str, Array]:
    """Those that a file had, or that somebody has asked for: others are computed when they are asked for."""
    cache = getattr(mesh, "_cache", {})  # to ask it drops what is no longer true
    normals = np.asarray(cache["vertex_normals"]) if "vertex_normals" in cache else np.empty(0)
    return {_NORMALS: normals} if normals.shape == np.shape(mesh.vertices) else {}


def _of_texture(visual: Any) -> dict[str, Array]:
    """What a texture has at vertices, without what does not fit."""
    stored = {name: np.asarray(visual.vertex_attributes[name]) for name in visual.vertex_attributes.keys()}  # noqa: SIM118
    count = len(visual.mesh.vertices) if visual.mesh is not None else None
    return {name: values for name, values in stored.items() if values.ndim and len(values) == count}


def _build(mesh: Any, result: Simplified) -> Any:
    trimesh = sys.modules["trimesh"]
    own = columns(mesh.vertex_attributes)
    return trimesh.Trimesh(
        result.vertices,
        result.faces,
        vertex_normals=result.vertex_attributes.get(_NORMALS),
        vertex_attributes={name: result.vertex_attributes[name] for name in own},
        face_attributes=of_faces(mesh.face_attributes, result),
        metadata=dict(mesh.metadata),
        visual=_visual(mesh.visual, result),
        process=False,
    )


def _visual(visual: Any, result: Simplified) -> Any:
    colors = sys.modules["trimesh"].visual.ColorVisuals
    if visual.kind == "texture":
        materials = visual.face_materials
        small = type(visual)(
            material=visual.material,  # the same picture, not a copy
            face_materials=None if materials is None else np.asarray(materials)[result.face_origin],
        )
        for name in _of_texture(visual):
            small.vertex_attributes[name] = result.vertex_attributes[_TEXTURE + name]
        return small
    if visual.kind == "vertex":
        return colors(vertex_colors=result.vertex_attributes[_COLORS])
    if visual.kind == "face":
        return colors(face_colors=face_colors(np.asarray(visual.face_colors), result))
    return None


LIBRARY = Library("trimesh", "Trimesh", _read, _attributes, _build)
