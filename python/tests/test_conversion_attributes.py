# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What meshes of other libraries store guides the simplification and is interpolated, with its seams and types."""

from typing import Any

import numpy as np
import pytest
from array_meshes import wave
from attribute_meshes import affine, cells_of, open_edges, shaded_box, sheet, side_of, textured_box

import laplacian_simplify as ls

VERTICES, FACES = sheet()
UV = affine(VERTICES)
HEIGHT = VERTICES[:, 0] - 2 * VERTICES[:, 1]
COLORS = np.rint(np.concatenate([VERTICES * [80, 80, 0] + [5, 10, 30], np.full((len(VERTICES), 1), 255)], axis=1))
COLORS = COLORS.astype(np.uint8)
IDS = np.arange(len(VERTICES))
OPTIONS: dict[str, Any] = {"target_percent": 10, "return_result": True, "measure_error": False}
STEP = 1.6
"""Of 255: colors are rounded once going in and once coming out, and in between a little by the fit."""


def height(points: np.ndarray) -> np.ndarray:
    return np.asarray(points[:, 0] - 2 * points[:, 1])


def colors(points: np.ndarray) -> np.ndarray:
    return np.asarray(points * [80, 80, 0] + [5, 10, 30])


def assert_fits(points: Any, values: Any, expected: np.ndarray, tolerance: float = 1e-5) -> None:
    assert len(points) < len(VERTICES) / 5
    assert np.abs(np.asarray(values) - expected).max() < tolerance


def test_values_of_trimesh() -> None:
    trimesh = pytest.importorskip("trimesh")
    attributes = {"height": HEIGHT.astype(np.float32), "id": IDS, "normal": np.tile([0.0, 0, 1], (len(VERTICES), 1))}
    mesh = trimesh.Trimesh(VERTICES, FACES, vertex_colors=COLORS, vertex_attributes=attributes, process=False)
    small, result = ls.simplify(mesh, **OPTIONS)
    assert_fits(small.vertices, small.vertex_attributes["height"], height(small.vertices))
    assert_fits(small.vertices, small.visual.vertex_colors[:, :3], colors(small.vertices), STEP)
    assert small.visual.vertex_colors.dtype == np.uint8
    assert small.vertex_attributes["height"].dtype == np.float32
    assert np.array_equal(small.vertex_attributes["id"], result.vertex_origin)
    assert np.allclose(small.vertex_attributes["normal"], [0, 0, 1])


def test_seams_of_textured_trimesh() -> None:
    trimesh = pytest.importorskip("trimesh")
    vertices, faces, texture = textured_box()
    material = trimesh.visual.material.SimpleMaterial()
    mesh = trimesh.Trimesh(
        vertices, faces, visual=trimesh.visual.TextureVisuals(uv=texture, material=material), process=False
    )
    small, result = ls.simplify(mesh, target_percent=10, return_result=True)
    corners = small.visual.uv[small.faces]
    assert (cells_of(corners) == side_of(small.vertices[small.faces])[:, None]).all()
    assert open_edges(small.vertices, small.faces) == 0
    assert small.visual.material is material
    assert len(small.visual.uv) == len(small.vertices) == result.report.vertices
    assert set(result.report.attribute_rms or ()) == {"visual.uv"}


def test_materials_of_trimesh_are_seams() -> None:
    trimesh = pytest.importorskip("trimesh")
    materials = (VERTICES[FACES][:, :, 0].mean(axis=1) < 1.55).astype(int)
    visual = trimesh.visual.TextureVisuals(uv=UV, face_materials=materials)
    small = ls.simplify(trimesh.Trimesh(VERTICES, FACES, visual=visual, process=False), target_percent=10)
    x = small.vertices[small.faces][:, :, 0]
    border = VERTICES[:, 0][VERTICES[:, 0] < 1.57].max()
    assert x[small.visual.face_materials == 1].max() == pytest.approx(border, abs=1e-6)
    assert x[small.visual.face_materials == 0].min() == pytest.approx(border, abs=1e-6)
    assert_fits(small.vertices, small.visual.uv, affine(small.vertices))


def test_patches_of_face_colors_stay_and_smooth_ones_are_interpolated() -> None:
    trimesh = pytest.importorskip("trimesh")
    middle = VERTICES[FACES].mean(axis=1)
    patches = np.where(middle[:, :1] < 1.55, [[200, 10, 10, 255]], [[10, 10, 200, 255]]).astype(np.uint8)
    hard = ls.simplify(trimesh.Trimesh(VERTICES, FACES, face_colors=patches, process=False), target_percent=10)
    x = hard.vertices[hard.faces][:, :, 0]
    border = VERTICES[:, 0][VERTICES[:, 0] < 1.57].max()
    assert x[hard.visual.face_colors[:, 0] == 200].max() == pytest.approx(border, abs=1e-6)
    smooth = np.concatenate([colors(middle), np.full((len(FACES), 1), 255)], axis=1).astype(np.uint8)
    options: dict[str, Any] = {"target_percent": 10}
    result = ls.simplify(trimesh.Trimesh(VERTICES, FACES, face_colors=smooth, process=False), **options)
    assert len(result.faces) <= len(FACES) // 10
    found = result.vertices[result.faces].mean(axis=1)
    inside = ((found > 0.5) & (found < 2.5))[:, :2].all(
        axis=1
    )  # at a border the mean of faces is not that of the place
    assert np.abs(result.visual.face_colors[inside, :3] - colors(found[inside])).max() < 6
    blind, was = ls.simplify(
        trimesh.Trimesh(VERTICES, FACES, face_colors=smooth, process=False),
        keep_attributes=False,
        return_result=True,
        **options,
    )
    assert np.array_equal(blind.visual.face_colors, smooth[was.face_origin])


def test_face_colors_of_soup_are_smooth_where_they_are() -> None:
    """Faces that share no vertices have neighbours all the same: by their places."""
    trimesh = pytest.importorskip("trimesh")
    middle = VERTICES[FACES].mean(axis=1)
    smooth = np.concatenate([colors(middle), np.full((len(FACES), 1), 255)], axis=1).astype(np.uint8)
    soup = trimesh.Trimesh(
        VERTICES[FACES].reshape(-1, 3), np.arange(FACES.size).reshape(-1, 3), face_colors=smooth, process=False
    )
    _, result = ls.simplify(soup, **OPTIONS)
    assert result.report.target_reached


def test_values_of_pyvista() -> None:
    pyvista = pytest.importorskip("pyvista")
    mesh = pyvista.PolyData.from_regular_faces(VERTICES.astype(np.float32), FACES)
    mesh.point_data["height"] = HEIGHT
    mesh.point_data["colors"] = COLORS[:, :3]
    mesh.point_data["id"] = IDS
    mesh.point_data["hole"] = np.where(HEIGHT > 1, np.nan, HEIGHT)
    mesh.active_texture_coordinates = UV.astype(np.float32)
    mesh = mesh.compute_normals(split_vertices=False)
    small, result = ls.simplify(mesh, **OPTIONS)
    points = np.asarray(small.points, dtype=float)
    assert_fits(points, small.point_data["height"], height(points))
    assert_fits(points, small.point_data["colors"], colors(points), STEP)
    assert_fits(points, small.active_texture_coordinates, affine(points))
    assert np.array_equal(small.point_data["id"], result.vertex_origin)
    expected = mesh.point_data["hole"][result.vertex_origin]
    assert np.array_equal(small.point_data["hole"], expected, equal_nan=True)  # what is not finite is not interpolated
    assert np.allclose(np.abs(small.point_data["Normals"]), [0, 0, 1])
    assert np.allclose(np.abs(small.cell_data["Normals"]), [0, 0, 1])
    assert {name: small.point_data[name].dtype for name in mesh.point_data} == {
        name: mesh.point_data[name].dtype for name in mesh.point_data
    }


def test_values_of_vedo() -> None:
    vedo = pytest.importorskip("vedo")
    mesh = vedo.Mesh([VERTICES, FACES])
    mesh.pointdata["height"] = HEIGHT
    small, _ = ls.simplify(mesh, **OPTIONS)
    assert_fits(small.vertices, small.pointdata["height"], height(np.asarray(small.vertices)))


def test_values_of_open3d() -> None:
    open3d = pytest.importorskip("open3d")
    vectors = open3d.utility
    mesh = open3d.geometry.TriangleMesh(vectors.Vector3dVector(VERTICES), vectors.Vector3iVector(FACES))
    mesh.vertex_colors = vectors.Vector3dVector(COLORS[:, :3] / 255)
    mesh.triangle_uvs = vectors.Vector2dVector(UV[FACES.ravel()])
    materials = (VERTICES[FACES][:, :, 0].mean(axis=1) < 1.55).astype(np.int32)
    mesh.triangle_material_ids = vectors.IntVector(materials)
    small, _ = ls.simplify(mesh, **OPTIONS)
    points, faces = np.asarray(small.vertices), np.asarray(small.triangles)
    assert_fits(points, 255 * np.asarray(small.vertex_colors), colors(points), STEP)
    assert_fits(points, np.asarray(small.triangle_uvs), affine(points[faces.ravel()]))
    x = points[faces][:, :, 0]
    border = VERTICES[:, 0][VERTICES[:, 0] < 1.57].max()
    assert x[np.asarray(small.triangle_material_ids) == 1].max() == pytest.approx(border, abs=1e-6)


def test_values_of_open3d_tensors() -> None:
    open3d = pytest.importorskip("open3d")
    tensor = open3d.core.Tensor
    mesh = open3d.t.geometry.TriangleMesh(tensor(VERTICES.astype(np.float32)), tensor(FACES.astype(np.int32)))
    mesh.vertex["colors"] = tensor(COLORS[:, :3])
    mesh.triangle["texture_uvs"] = tensor(UV[FACES].astype(np.float32))
    mesh.triangle["part"] = tensor(np.arange(len(FACES)))
    small, result = ls.simplify(mesh, **OPTIONS)
    points, faces = small.vertex.positions.numpy().astype(float), small.triangle.indices.numpy()
    assert_fits(points, small.vertex["colors"].numpy(), colors(points), STEP)
    assert_fits(points, small.triangle["texture_uvs"].numpy(), affine(points[faces]))
    assert small.triangle["texture_uvs"].numpy().dtype == np.float32
    assert np.array_equal(small.triangle["part"].numpy(), result.face_origin)


def test_values_of_meshio() -> None:
    meshio = pytest.importorskip("meshio")
    data = {"height": HEIGHT, "colors": COLORS, "uv": UV, "id": IDS}
    mesh = meshio.Mesh(VERTICES, [("triangle", FACES[:500]), ("triangle", FACES[500:])], point_data=data)
    small, result = ls.simplify(mesh, **OPTIONS)
    assert_fits(small.points, small.point_data["height"], height(small.points))
    assert_fits(small.points, small.point_data["colors"][:, :3], colors(small.points), STEP)
    assert_fits(small.points, small.point_data["uv"], affine(small.points))
    assert np.array_equal(small.point_data["id"], result.vertex_origin)


def test_values_of_pymeshlab() -> None:
    import pymeshlab

    mesh = pymeshlab.Mesh(
        VERTICES,
        FACES.astype(np.int32),
        v_scalar_array=HEIGHT,
        v_color_matrix=COLORS / 255,
        w_tex_coords_matrix=UV[FACES.ravel()],
    )
    small, result = ls.simplify(mesh, **OPTIONS)
    points, faces = small.vertex_matrix(), small.face_matrix()
    assert_fits(points, small.vertex_scalar_array(), height(points))
    assert_fits(points, 255 * small.vertex_color_matrix()[:, :3], colors(points), STEP + 1)  # which are bytes again
    assert_fits(points, small.wedge_tex_coord_matrix(), affine(points[faces.ravel()]))
    assert result.report.attribute_rms is None  # it was not to be measured


def test_attributes_of_arrays_are_refused() -> None:
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.Trimesh(*wave(), process=False)
    options: dict[str, Any] = {"face_labels": np.zeros(len(wave()[1]), int)}
    with pytest.raises(TypeError, match=r"face_labels is for arrays; a trimesh\.Trimesh has attributes of its own"):
        ls.simplify(mesh, target_percent=10, **options)


def assert_hard(vertices: np.ndarray, faces: np.ndarray, normals: np.ndarray) -> None:
    """No vertex of the shaded box is on two of its sides, and normals of vertices are those of their own side."""
    side = side_of(vertices[faces])
    of_side = np.full(len(vertices), -1)
    for k in range(3):
        of_side[faces[:, k]] = side
    assert (of_side[faces] == side[:, None]).all()
    along = np.abs(normals[np.arange(len(normals)), of_side % 3])
    assert (along > np.cos(np.pi / 3)).all()
    assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
    assert open_edges(vertices, faces) == 0


def test_normals_that_meshlab_computed_make_no_seams() -> None:
    """It has some for every mesh; where vertices are doubled along an edge, as in STL files, each from its own side."""
    import pymeshlab

    vertices, faces, _ = shaded_box()
    mesh = pymeshlab.Mesh(vertices, faces.astype(np.int32))
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(mesh)
    ls.simplify(mesh_set, target_percent=10)
    for small in (ls.simplify(mesh, **OPTIONS)[0], mesh_set.current_mesh()):
        assert len(np.unique(small.vertex_matrix(), axis=0)) == small.vertex_number()
        assert open_edges(small.vertex_matrix(), small.face_matrix()) == 0


def test_hard_normals_of_trimesh_stay_hard() -> None:
    trimesh = pytest.importorskip("trimesh")
    vertices, faces, normals = shaded_box()
    small, _ = ls.simplify(trimesh.Trimesh(vertices, faces, vertex_normals=normals, process=False), **OPTIONS)
    assert_hard(np.asarray(small.vertices), np.asarray(small.faces), np.asarray(small.vertex_normals))


def test_outdated_normals_of_trimesh_say_nothing() -> None:
    trimesh = pytest.importorskip("trimesh")
    vertices, faces, normals = shaded_box()
    mesh = trimesh.Trimesh(vertices, faces, vertex_normals=normals, process=False)
    mesh.vertices = 2 * vertices
    small, _ = ls.simplify(mesh, **OPTIONS)
    assert len(np.unique(small.vertices, axis=0)) == len(small.vertices)


def test_hard_normals_of_meshio_stay_hard() -> None:
    meshio = pytest.importorskip("meshio")
    vertices, faces, normals = shaded_box()
    small, _ = ls.simplify(meshio.Mesh(vertices, [("triangle", faces)], point_data={"normals": normals}), **OPTIONS)
    assert_hard(small.points, small.cells[0].data, small.point_data["normals"])


def test_hard_normals_of_pyvista_stay_hard() -> None:
    pyvista = pytest.importorskip("pyvista")
    vertices, faces, normals = shaded_box()
    mesh = pyvista.PolyData.from_regular_faces(vertices, faces)
    mesh.point_data["Normals"] = normals
    small, _ = ls.simplify(mesh, **OPTIONS)
    assert_hard(np.asarray(small.points), np.asarray(small.regular_faces), np.asarray(small.point_data["Normals"]))
