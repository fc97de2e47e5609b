# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of pyvista and of vedo, both of which keep named arrays at points and cells."""

import sys
from typing import Any

import numpy as np

from ..arrays import Simplified
from ..attributes import Attributes, Kind
from .library import Arrays, Library, attributes_of, columns, of_faces, require_triangles


def _read_pyvista(mesh: Any) -> Arrays:
    others = mesh.n_lines + mesh.n_verts + mesh.n_strips
    require_triangles(mesh.is_all_triangles and others == 0, "apply triangulate(), without lines, vertices and strips")
    return np.asarray(mesh.points), np.asarray(mesh.regular_faces)


def _pyvista_attributes(mesh: Any) -> Attributes:
    texture = mesh.point_data.active_texture_coordinates_name
    points = columns(mesh.point_data)
    kinds: dict[str, Kind] = {}
    if texture in points and points[texture].dtype.kind == "f" and points[texture].shape[1:] == (2,):
        kinds[texture] = "texture"
    return attributes_of(points, kinds=kinds)


def _build_pyvista(mesh: Any, result: Simplified) -> Any:
    small = sys.modules["pyvista"].PolyData.from_regular_faces(result.vertices, result.faces)
    _fill(small.point_data, small.cell_data, mesh.cell_data, result)
    texture = mesh.point_data.active_texture_coordinates_name
    if texture in small.point_data:
        small.point_data.active_texture_coordinates_name = texture
    for name in mesh.field_data.keys():  # noqa: SIM118
        small.field_data[name] = mesh.field_data[name]
    return small


def _fill(points: Any, cells: Any, old_cells: Any, result: Simplified) -> None:
    for target, values in ((points, result.vertex_attributes), (cells, of_faces(old_cells, result))):
        for name, array in values.items():
            target[name] = array


def _read_vedo(mesh: Any) -> Arrays:
    cells = mesh.cells
    require_triangles(all(len(cell) == 3 for cell in cells), "apply triangulate()")
    return np.asarray(mesh.vertices), np.asarray(cells, dtype=np.int64).reshape(-1, 3)


def _vedo_attributes(mesh: Any) -> Attributes:
    return attributes_of(columns(mesh.pointdata))


def _build_vedo(mesh: Any, result: Simplified) -> Any:
    small = sys.modules["vedo"].Mesh([result.vertices, result.faces])
    _fill(small.pointdata, small.celldata, mesh.celldata, result)
    return small


PYVISTA = Library("pyvista", "PolyData", _read_pyvista, _pyvista_attributes, _build_pyvista)
VEDO = Library("vedo", "Mesh", _read_vedo, _vedo_attributes, _build_vedo)
