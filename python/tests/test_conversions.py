# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other libraries come back as such, with the arrays of the plain call and what was stored with them: here
that of vertices and faces that remain, as keep_attributes = False has it."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from array_meshes import wave

import laplacian_simplify as ls
from laplacian_simplify.conversions import LIBRARIES, library_of

VERTICES, FACES = wave()
VALUES, FACE_VALUES = np.arange(len(VERTICES), dtype=np.float64), np.arange(len(FACES), dtype=np.float64)
COLORS = np.random.default_rng(1).integers(0, 256, (len(VERTICES), 4), dtype=np.uint8)


def _trimesh() -> Any:
    library = pytest.importorskip("trimesh")
    return library.Trimesh(
        VERTICES,
        FACES,
        vertex_colors=COLORS,
        vertex_attributes={"values": VALUES},
        face_attributes={"values": FACE_VALUES},
        metadata={"name": "wave"},
        process=False,
    )


def _pyvista() -> Any:
    library = pytest.importorskip("pyvista")
    mesh = library.PolyData.from_regular_faces(VERTICES, FACES)
    mesh.point_data["values"] = VALUES
    mesh.cell_data["values"] = FACE_VALUES
    mesh.field_data["name"] = ["wave"]
    return mesh


def _open3d() -> Any:
    library = pytest.importorskip("open3d")
    vectors = library.utility
    mesh = library.geometry.TriangleMesh(vectors.Vector3dVector(VERTICES), vectors.Vector3iVector(FACES))
    mesh.vertex_colors = vectors.Vector3dVector(COLORS[:, :3] / 255)
    mesh.triangle_uvs = vectors.Vector2dVector(VERTICES[FACES.ravel(), :2])
    mesh.compute_vertex_normals()
    return mesh


def _open3d_tensors() -> Any:
    library = pytest.importorskip("open3d")
    mesh = library.t.geometry.TriangleMesh(library.core.Tensor(VERTICES), library.core.Tensor(FACES))
    mesh.vertex["heights"] = library.core.Tensor(VALUES)
    mesh.triangle["heights"] = library.core.Tensor(FACE_VALUES)
    return mesh


def _meshio() -> Any:
    library = pytest.importorskip("meshio")
    return library.Mesh(
        VERTICES,
        [("triangle", FACES[:500]), ("triangle", FACES[500:])],
        point_data={"values": VALUES},
        cell_data={"values": [FACE_VALUES[:500], FACE_VALUES[500:]]},
        point_sets={"left": np.flatnonzero(VERTICES[:, 0] < 1)},
        cell_sets={"first": [np.arange(100), np.arange(0)]},
    )


def _pymeshlab() -> Any:
    import pymeshlab

    return pymeshlab.Mesh(VERTICES, FACES.astype(np.int32), v_scalar_array=VALUES, v_color_matrix=COLORS / 255)


def _vedo() -> Any:
    library = pytest.importorskip("vedo")
    mesh = library.Mesh([VERTICES, FACES])
    mesh.pointdata["values"] = VALUES
    mesh.celldata["values"] = FACE_VALUES
    return mesh


MAKERS = {
    "trimesh.Trimesh": _trimesh,
    "pyvista.PolyData": _pyvista,
    "open3d.geometry.TriangleMesh": _open3d,
    "open3d.t.geometry.TriangleMesh": _open3d_tensors,
    "meshio.Mesh": _meshio,
    "pymeshlab.Mesh": _pymeshlab,
    "vedo.Mesh": _vedo,
}


@pytest.mark.parametrize("row", LIBRARIES, ids=lambda row: row.name)
def test_same_type_in_same_type_out(row) -> None:
    mesh = MAKERS[row.name]()
    small, result = ls.simplify(mesh, target_percent=10, keep_attributes=False, return_result=True)
    assert type(small) is type(mesh)
    assert library_of(mesh) is row
    before, after = row.read(mesh), row.read(small)
    assert np.array_equal(before[0], VERTICES.astype(before[0].dtype))  # it is as it was
    expected = ls.simplify(*before, target_percent=10)
    assert after[0].dtype == before[0].dtype
    assert np.array_equal(after[0], expected.vertices)
    assert np.array_equal(after[1], expected.faces)
    assert result.report.faces == len(after[1])
    assert type(ls.simplify(mesh, target_faces=100, measure_error=False)) is type(mesh)


# What is stored at a vertex or a face, of each library.
STORED: dict[str, Callable[[Any], tuple[Any, Any]]] = {
    "trimesh.Trimesh": lambda mesh: (mesh.vertex_attributes["values"], mesh.face_attributes["values"]),
    "pyvista.PolyData": lambda mesh: (mesh.point_data["values"], mesh.cell_data["values"]),
    "open3d.t.geometry.TriangleMesh": lambda mesh: (mesh.vertex["heights"].numpy(), mesh.triangle["heights"].numpy()),
    "meshio.Mesh": lambda mesh: (mesh.point_data["values"], np.concatenate(mesh.cell_data["values"])),
    "vedo.Mesh": lambda mesh: (mesh.pointdata["values"], mesh.celldata["values"]),
}


@pytest.mark.parametrize("name", STORED)
def test_values_go_with_what_remains(name: str) -> None:
    small, result = ls.simplify(MAKERS[name](), target_percent=10, keep_attributes=False, return_result=True)
    at_vertices, at_faces = STORED[name](small)
    assert np.array_equal(at_vertices, VALUES[result.vertex_origin])
    assert np.array_equal(at_faces, FACE_VALUES[result.face_origin])


def test_colors_and_metadata_of_trimesh() -> None:
    small, result = ls.simplify(_trimesh(), target_percent=10, keep_attributes=False, return_result=True)
    assert np.array_equal(small.visual.vertex_colors, COLORS[result.vertex_origin])
    assert small.metadata["name"] == "wave"


def test_texture_coordinates_of_trimesh() -> None:
    trimesh = pytest.importorskip("trimesh")
    visual = trimesh.visual.TextureVisuals(uv=VERTICES[:, :2])
    mesh = trimesh.Trimesh(VERTICES, FACES, visual=visual, process=False)
    small, result = ls.simplify(mesh, target_percent=10, keep_attributes=False, return_result=True)
    assert np.array_equal(small.visual.uv, VERTICES[result.vertex_origin, :2])
    assert len(mesh.visual.uv) == len(VERTICES)


def test_colors_texture_coordinates_and_normals_of_open3d() -> None:
    small, result = ls.simplify(_open3d(), target_percent=10, keep_attributes=False, return_result=True)
    assert np.allclose(np.asarray(small.vertex_colors), COLORS[result.vertex_origin, :3] / 255)
    corners = VERTICES[FACES][result.face_origin][:, :, :2]
    assert np.array_equal(np.asarray(small.triangle_uvs).reshape(-1, 3, 2), corners)
    assert np.allclose(np.linalg.norm(np.asarray(small.vertex_normals), axis=1), 1)


def test_sets_of_meshio() -> None:
    small, result = ls.simplify(_meshio(), target_percent=10, keep_attributes=False, return_result=True)
    assert np.array_equal(
        result.vertex_origin[small.point_sets["left"]] % 30 < 10, [True] * len(small.point_sets["left"])
    )
    first, second = small.cell_sets["first"]
    assert (result.face_origin[first] < 100).all()
    assert len(first) == (result.face_origin < 100).sum()
    assert len(second) == 0
    assert len(small.cells) == 2


def test_selection_quality_and_colors_of_pymeshlab() -> None:
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(_pymeshlab())
    mesh_set.compute_selection_by_condition_per_face(condselect="x0 + x1 + x2 < 4")
    options = {"target_percent": 10, "descriptor": "vertex_quality"}
    small, result = ls.simplify(mesh_set.current_mesh(), **options, keep_attributes=False, return_result=True)
    report = ls.simplify(mesh_set, **options, keep_attributes=False)
    assert np.array_equal(small.vertex_matrix(), mesh_set.current_mesh().vertex_matrix())
    assert small.vertex_number() == report.vertices
    assert np.array_equal(small.vertex_scalar_array(), VALUES[result.vertex_origin])
    assert np.allclose(small.vertex_color_matrix(), COLORS[result.vertex_origin] / 255, atol=1 / 255)


def test_faces_of_more_corners_are_refused() -> None:
    meshio = pytest.importorskip("meshio")
    quad = meshio.Mesh(np.zeros((4, 3)), [("quad", [[0, 1, 2, 3]]), ("triangle", [[0, 1, 2]])])
    with pytest.raises(ValueError, match=r"only triangles can be simplified: .* types quad, triangle"):
        ls.simplify(quad, target_faces=1)


def test_polygons_of_pyvista_are_refused() -> None:
    pyvista = pytest.importorskip("pyvista")
    with pytest.raises(ValueError, match=r"apply triangulate\(\)"):
        ls.simplify(pyvista.Plane(), target_faces=1)
    strips = pyvista.PolyData(np.eye(3), faces=[3, 0, 1, 2], strips=[3, 0, 1, 2])
    with pytest.raises(ValueError, match="without lines, vertices and strips"):
        ls.simplify(strips, target_faces=1)


@pytest.mark.parametrize(
    "mesh", [7, None, b"mesh.ply", {"vertices": 3}, (VERTICES, FACES)], ids=lambda m: type(m).__name__
)
def test_everything_else_is_a_type_error_that_lists_what_is_accepted(mesh) -> None:
    with pytest.raises(TypeError, match="cannot be simplified; accepted are two NumPy arrays") as refusal:
        ls.simplify(mesh, target_percent=10)
    assert all(row.name in str(refusal.value) for row in LIBRARIES)
    with pytest.raises(TypeError, match=r"must be a pymeshlab\.MeshSet or the path of a mesh file"):
        ls.smooth(mesh)


def test_what_is_for_others_is_refused(load_sample) -> None:
    pytest.importorskip("trimesh")
    with pytest.raises(TypeError, match=r"faces is for arrays; a trimesh\.Trimesh has faces of its own"):
        ls.simplify(_trimesh(), FACES, target_percent=10)
    for options in ({"faces": FACES}, {"locked": np.ones(3, bool)}, {"progress": print}, {"return_result": True}):
        with pytest.raises(TypeError, match=f"{next(iter(options))} is for arrays and meshes of other libraries"):
            ls.simplify(load_sample("painted_box.obj"), target_percent=10, **options)
