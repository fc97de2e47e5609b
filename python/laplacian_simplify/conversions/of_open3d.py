# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of Open3D, those of vectors and those of tensors."""

import sys
from typing import Any

import numpy as np

from ..arrays import Simplified
from ..attributes import Array, Attributes, Kind
from .library import Arrays, Library, attributes_of, require_triangles


def _read(mesh: Any) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def _attributes(mesh: Any) -> Attributes:
    vertex = {"vertex_colors": np.asarray(mesh.vertex_colors)} if mesh.has_vertex_colors() else {}
    if mesh.has_vertex_normals():
        vertex["vertex_normals"] = np.asarray(mesh.vertex_normals)
    corner = {"triangle_uvs": np.asarray(mesh.triangle_uvs).reshape(-1, 3, 2)} if mesh.has_triangle_uvs() else {}
    labels = np.asarray(mesh.triangle_material_ids) if mesh.has_triangle_material_ids() else None
    return attributes_of(vertex, corner, labels)


def _build(mesh: Any, result: Simplified) -> Any:
    open3d = sys.modules["open3d"]
    vectors = open3d.utility
    small = open3d.geometry.TriangleMesh(vectors.Vector3dVector(result.vertices), vectors.Vector3iVector(result.faces))
    if "vertex_colors" in result.vertex_attributes:
        small.vertex_colors = vectors.Vector3dVector(result.vertex_attributes["vertex_colors"])
    if "triangle_uvs" in result.corner_attributes:
        small.triangle_uvs = vectors.Vector2dVector(result.corner_attributes["triangle_uvs"].reshape(-1, 2))
    if result.face_labels is not None:
        small.triangle_material_ids = vectors.IntVector(result.face_labels)
    if mesh.has_textures():
        small.textures = mesh.textures
    if mesh.has_triangle_normals():
        small.compute_triangle_normals()
    if "vertex_normals" in result.vertex_attributes:
        small.vertex_normals = vectors.Vector3dVector(result.vertex_attributes["vertex_normals"])
    return small


def _read_tensors(mesh: Any) -> Arrays:
    require_triangles("positions" in mesh.vertex and "indices" in mesh.triangle, "the mesh has none")
    return mesh.vertex.positions.cpu().numpy(), mesh.triangle.indices.cpu().numpy()


def _stored(data: Any, *others: str) -> dict[str, Array]:
    return {name: values.cpu().numpy() for name, values in data.items() if name not in others}


def _tensor_attributes(mesh: Any) -> Attributes:
    triangle = _stored(mesh.triangle, "indices", "normals")
    corner = {"texture_uvs": triangle["texture_uvs"]} if "texture_uvs" in triangle else {}
    materials = triangle.get("material_ids")
    vertex = {_at_vertices(name): values for name, values in _stored(mesh.vertex, "positions").items()}
    labels = None if materials is None else materials.reshape(-1)
    kinds: dict[str, Kind] = {_at_vertices("normals"): "normal"} if "normals" in mesh.vertex else {}
    return attributes_of(vertex, corner, labels, kinds)


def _at_vertices(name: str) -> str:
    """A name that none of a triangle has."""
    return "vertex." + name


def _build_tensors(mesh: Any, result: Simplified) -> Any:
    open3d = sys.modules["open3d"]
    device = mesh.device

    def tensor(values: Array) -> Any:
        return open3d.core.Tensor(np.ascontiguousarray(values), device=device)

    small = open3d.t.geometry.TriangleMesh(tensor(result.vertices), tensor(result.faces))
    for name in _stored(mesh.vertex, "positions"):
        small.vertex[name] = tensor(result.vertex_attributes[_at_vertices(name)])
    for name, values in _stored(mesh.triangle, "indices", "normals").items():
        small.triangle[name] = tensor(result.corner_attributes.get(name, values[result.face_origin]))
    if mesh.has_valid_material():
        small.material = mesh.material
    if "normals" in mesh.triangle:
        small.compute_triangle_normals()
    return small


LIBRARY = Library("open3d", "geometry.TriangleMesh", _read, _attributes, _build)
TENSORS = Library("open3d", "t.geometry.TriangleMesh", _read_tensors, _tensor_attributes, _build_tensors)
