# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of the corpus in a mesh set, and what a filter left of it."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pymeshlab
from hostile_meshes import HostileMesh


def mesh_set_of(mesh: HostileMesh) -> pymeshlab.MeshSet:
    """The mesh as the host holds it."""
    mesh_set = pymeshlab.MeshSet(verbose=False)
    if not len(mesh.vertices):  # pymeshlab makes none without vertices
        mesh_set.add_mesh(pymeshlab.Mesh(np.zeros((1, 3))))
        mesh_set.set_selection_all()
        mesh_set.meshing_remove_selected_vertices()
        return mesh_set
    mesh_set.add_mesh(pymeshlab.Mesh(mesh.vertices, mesh.faces, **mesh.data))
    if mesh.deleted_faces is not None:
        _select("face", mesh_set, mesh.deleted_faces)
        mesh_set.meshing_remove_selected_faces()
    if mesh.selected_faces is not None:
        _select("face", mesh_set, mesh.selected_faces)
    if mesh.selected_vertices is not None:
        _select("vertex", mesh_set, mesh.selected_vertices)
    return mesh_set


def _select(kind: str, mesh_set: pymeshlab.MeshSet, chosen: np.ndarray) -> None:
    """By runs of indices: the host's condition is a formula."""
    index = {"face": "fi", "vertex": "vi"}[kind]
    edges = np.flatnonzero(np.diff(np.concatenate([[0], chosen.astype(int), [0]])))
    runs = [f"({index} >= {a} && {index} < {b})" for a, b in zip(edges[::2], edges[1::2], strict=True)]
    filter_name = f"compute_selection_by_condition_per_{kind}"
    mesh_set.apply_filter(filter_name, condselect=" || ".join(runs) or "(0 == 1)")


_Reader = Callable[[pymeshlab.Mesh], np.ndarray]
_EVERYTHING: tuple[_Reader, ...] = (
    lambda m: m.vertex_matrix(),
    lambda m: m.face_matrix(),
    lambda m: m.vertex_selection_array(),
    lambda m: m.face_selection_array(),
    lambda m: m.vertex_scalar_array(),
    lambda m: m.vertex_color_matrix(),
    lambda m: m.face_scalar_array(),
    lambda m: m.face_color_matrix(),
    lambda m: m.wedge_tex_coord_matrix(),
    lambda m: m.vertex_tex_coord_matrix(),
)


def contents(mesh_set: pymeshlab.MeshSet) -> list[list[bytes]]:
    """Everything that a user could miss, layer by layer."""
    return [[_bytes(mesh, read) for read in _EVERYTHING] for mesh in mesh_set]


def _bytes(mesh: pymeshlab.Mesh, read: _Reader) -> bytes:
    try:
        return np.ascontiguousarray(read(mesh)).tobytes()
    except (pymeshlab.PyMeshLabException, pymeshlab.pmeshlab.MissingComponentException):  # the mesh has none
        return b""


def fault_of_a_mesh(before: pymeshlab.Mesh, after: pymeshlab.Mesh) -> str:
    """What is wrong with a simplified mesh, empty where nothing is."""
    faces, old = after.face_matrix(), before.face_matrix()
    if len(faces) > len(old):
        return f"{len(faces)} faces of {len(old)}"
    if faces.size and (faces.min() < 0 or faces.max() >= after.vertex_number()):
        return "an index is out of range"
    if not np.isfinite(after.vertex_matrix()).all() and np.isfinite(before.vertex_matrix()).all():
        return "coordinates are no numbers"
    if _with_a_vertex_twice(faces) > _with_a_vertex_twice(old):
        return "faces with a vertex twice"
    return ""


def _with_a_vertex_twice(faces: np.ndarray) -> int:
    a, b, c = faces.T
    return int(((a == b) | (b == c) | (c == a)).sum())


def fault_of_a_report(report: dict[str, Any], mesh: pymeshlab.Mesh) -> str:
    """What a simplification returned against the mesh that is there."""
    for name, number in report.items():
        if isinstance(number, float | int) and not np.isfinite(number):
            return f"{name} = {number}"
    if (report["faces"], report["vertices"]) != (mesh.face_number(), mesh.vertex_number()):
        return "the report counts other faces or vertices"
    return ""
