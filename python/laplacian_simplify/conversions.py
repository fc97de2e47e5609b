# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other libraries in, meshes of the same type out.

None of the libraries is imported here: an object of one can only exist where its module has been imported. What is
stored with vertices and faces goes with those that remain, as in the filter; normals are left out, or computed anew
where the library keeps them as part of the mesh.
"""

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from .arrays import Array, ArrayOptions, Simplified, needs_quality, simplify_arrays
from .tables import Filter

Arrays = tuple[Any, Any]
_NORMALS = {"normals", "normal", "pointnormals", "cellnormals"}


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


def library_of(mesh: object) -> Library:
    """The row of the library that the mesh is of.

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
        f"{kind} cannot be simplified; accepted are two NumPy arrays (vertices, faces), the path of a mesh file, "
        f"pymeshlab.MeshSet, {names}"
    )


def _require_triangles(all_are: bool, remedy: str) -> None:
    if not all_are:
        raise ValueError(f"only triangles can be simplified: {remedy}")


def _taken(data: Any, origin: Array) -> dict[str, Array]:
    """The rows of named columns that remain, without normals."""
    return {name: np.asarray(data[name])[origin] for name in data.keys() if name.lower() not in _NORMALS}  # noqa: SIM118


def _read_trimesh(mesh: Any) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def _build_trimesh(mesh: Any, result: Simplified) -> Any:
    visual = None
    if mesh.visual.kind == "texture":
        uv = None if mesh.visual.uv is None else mesh.visual.uv[result.vertex_origin]
        visual = type(mesh.visual)(uv=uv, material=mesh.visual.material)  # the same picture, not a copy
    elif mesh.visual.defined:
        visual = mesh.visual.copy()
        visual.update_vertices(result.vertex_origin)
        visual.update_faces(result.face_origin)
    return sys.modules["trimesh"].Trimesh(
        result.vertices,
        result.faces,
        vertex_attributes=_taken(mesh.vertex_attributes, result.vertex_origin),
        face_attributes=_taken(mesh.face_attributes, result.face_origin),
        metadata=dict(mesh.metadata),
        visual=visual,
        process=False,
    )


def _read_pyvista(mesh: Any) -> Arrays:
    others = mesh.n_lines + mesh.n_verts + mesh.n_strips
    _require_triangles(mesh.is_all_triangles and others == 0, "apply triangulate(), without lines, vertices and strips")
    return np.asarray(mesh.points), np.asarray(mesh.regular_faces)


def _build_pyvista(mesh: Any, result: Simplified) -> Any:
    small = sys.modules["pyvista"].PolyData.from_regular_faces(result.vertices, result.faces)
    for source, target, origin in (
        (mesh.point_data, small.point_data, result.vertex_origin),
        (mesh.cell_data, small.cell_data, result.face_origin),
    ):
        for name, values in _taken(source, origin).items():
            target[name] = values
    for name in mesh.field_data.keys():  # noqa: SIM118
        small.field_data[name] = mesh.field_data[name]
    return small


def _read_open3d(mesh: Any) -> Arrays:
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def _build_open3d(mesh: Any, result: Simplified) -> Any:
    open3d = sys.modules["open3d"]
    vectors = open3d.utility
    small = open3d.geometry.TriangleMesh(vectors.Vector3dVector(result.vertices), vectors.Vector3iVector(result.faces))
    if mesh.has_vertex_colors():
        small.vertex_colors = vectors.Vector3dVector(np.asarray(mesh.vertex_colors)[result.vertex_origin])
    if mesh.has_triangle_uvs():
        corners = np.asarray(mesh.triangle_uvs).reshape(-1, 3, 2)[result.face_origin]
        small.triangle_uvs = vectors.Vector2dVector(corners.reshape(-1, 2))
    if mesh.has_triangle_material_ids():
        small.triangle_material_ids = vectors.IntVector(np.asarray(mesh.triangle_material_ids)[result.face_origin])
    if mesh.has_textures():
        small.textures = mesh.textures
    if mesh.has_triangle_normals():
        small.compute_triangle_normals()
    if mesh.has_vertex_normals():
        small.compute_vertex_normals()
    return small


def _read_open3d_tensors(mesh: Any) -> Arrays:
    _require_triangles("positions" in mesh.vertex and "indices" in mesh.triangle, "the mesh has none")
    return mesh.vertex.positions.cpu().numpy(), mesh.triangle.indices.cpu().numpy()


def _build_open3d_tensors(mesh: Any, result: Simplified) -> Any:
    open3d = sys.modules["open3d"]
    device = mesh.device

    def tensor(values: Array) -> Any:
        return open3d.core.Tensor(np.ascontiguousarray(values), device=device)

    small = open3d.t.geometry.TriangleMesh(tensor(result.vertices), tensor(result.faces))
    for source, target, origin, place in (
        (mesh.vertex, small.vertex, result.vertex_origin, "positions"),
        (mesh.triangle, small.triangle, result.face_origin, "indices"),
    ):
        for name, values in source.items():
            if name not in (place, "normals"):
                target[name] = tensor(values.cpu().numpy()[origin])
    if "normals" in mesh.triangle:
        small.compute_triangle_normals()
    if "normals" in mesh.vertex:
        small.compute_vertex_normals()
    return small


def _read_meshio(mesh: Any) -> Arrays:
    kinds = {block.type for block in mesh.cells}
    _require_triangles(kinds <= {"triangle"}, f"the mesh has cells of the types {', '.join(sorted(kinds))}")
    blocks = [np.asarray(block.data) for block in mesh.cells]
    return np.asarray(mesh.points), np.concatenate(blocks) if blocks else np.empty((0, 3), np.int64)


def _build_meshio(mesh: Any, result: Simplified) -> Any:
    first = np.cumsum([0, *(len(block.data) for block in mesh.cells)])
    bounds = np.searchsorted(result.face_origin, first)
    parts = [slice(bounds[k], bounds[k + 1]) for k in range(len(mesh.cells))]
    origins = [result.face_origin[part] - first[k] for k, part in enumerate(parts)]

    def of_blocks(blocks: Any, remaining: Callable[[Array, Array], Array]) -> list[Array]:
        return [remaining(np.asarray(values), origin) for values, origin in zip(blocks, origins, strict=True)]

    def members(old: Array, origin: Array) -> Array:
        return np.flatnonzero(np.isin(origin, old))

    return sys.modules["meshio"].Mesh(
        result.vertices,
        [("triangle", result.faces[part]) for part in parts],
        point_data=_taken(mesh.point_data, result.vertex_origin),
        cell_data={name: of_blocks(blocks, lambda old, at: old[at]) for name, blocks in mesh.cell_data.items()},
        field_data=dict(mesh.field_data),
        point_sets={name: members(old, result.vertex_origin) for name, old in mesh.point_sets.items()},
        cell_sets={name: of_blocks(blocks, members) for name, blocks in mesh.cell_sets.items()},
        info=mesh.info,
    )


def _read_pymeshlab(mesh: Any) -> Arrays:
    return mesh.vertex_matrix(), mesh.face_matrix()


def _complete_pymeshlab(mesh: Any, options: ArrayOptions, quality: bool) -> ArrayOptions:
    selected = options.selected
    if selected is None and mesh.selected_face_number() > 0:
        selected = mesh.face_selection_array()
    stored = mesh.vertex_scalar_array() if quality and options.quality is None else options.quality
    return ArrayOptions(selected, options.locked, stored, options.progress)


def _build_pymeshlab(mesh: Any, result: Simplified) -> Any:
    vertex, face = result.vertex_origin, result.face_origin
    data: dict[str, Any] = {"vertex_matrix": result.vertices, "face_matrix": result.faces}
    if mesh.has_vertex_scalar():
        data["v_scalar_array"] = mesh.vertex_scalar_array()[vertex]
    if mesh.has_face_scalar():
        data["f_scalar_array"] = mesh.face_scalar_array()[face]
    if mesh.has_vertex_color():
        data["v_color_matrix"] = mesh.vertex_color_matrix()[vertex]
    if mesh.has_face_color():
        data["f_color_matrix"] = mesh.face_color_matrix()[face]
    if mesh.has_vertex_tex_coord():
        data["v_tex_coords_matrix"] = mesh.vertex_tex_coord_matrix()[vertex]
    if mesh.has_wedge_tex_coord():
        data["w_tex_coords_matrix"] = mesh.wedge_tex_coord_matrix().reshape(-1, 3, 2)[face].reshape(-1, 2)
    return sys.modules["pymeshlab"].Mesh(**data)


def _read_vedo(mesh: Any) -> Arrays:
    cells = mesh.cells
    _require_triangles(all(len(cell) == 3 for cell in cells), "apply triangulate()")
    return np.asarray(mesh.vertices), np.asarray(cells, dtype=np.int64).reshape(-1, 3)


def _build_vedo(mesh: Any, result: Simplified) -> Any:
    small = sys.modules["vedo"].Mesh([result.vertices, result.faces])
    for source, target, origin in (
        (mesh.pointdata, small.pointdata, result.vertex_origin),
        (mesh.celldata, small.celldata, result.face_origin),
    ):
        for name, values in _taken(source, origin).items():
            target[name] = values
    return small


LIBRARIES = (
    Library("trimesh", "Trimesh", _read_trimesh, _build_trimesh),
    Library("pyvista", "PolyData", _read_pyvista, _build_pyvista),
    Library("open3d", "geometry.TriangleMesh", _read_open3d, _build_open3d),
    Library("open3d", "t.geometry.TriangleMesh", _read_open3d_tensors, _build_open3d_tensors),
    Library("meshio", "Mesh", _read_meshio, _build_meshio),
    Library("pymeshlab", "Mesh", _read_pymeshlab, _build_pymeshlab, _complete_pymeshlab),
    Library("vedo", "Mesh", _read_vedo, _build_vedo),
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
        of_arrays: what only arrays have, as ArrayOptions.
        return_result: return a mesh together with the result.

    Raises:
        TypeError, ValueError: as filters.simplify.
    """
    options = ArrayOptions(**of_arrays)
    if isinstance(mesh, np.ndarray):
        if faces is None:
            raise TypeError("the faces are missing: simplify(vertices, faces, target_percent=10)")
        if return_result:
            raise TypeError("return_result is for meshes of other libraries; for arrays the result is what is returned")
        return simplify_arrays(row, mesh, faces, numbers, options)
    library = library_of(mesh)
    if faces is not None:
        raise TypeError(f"faces is for arrays; a {library.name} has faces of its own")
    options = library.complete(mesh, options, needs_quality(row, numbers))
    result = simplify_arrays(row, *library.read(mesh), numbers, options)
    small = library.build(mesh, result)
    return (small, result) if return_result else small
