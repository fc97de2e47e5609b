# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A checked mesh becomes one of MeshLab: through a PLY file of the kind that MeshLab reads exactly."""

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ..turns import forget_failures, plain_path, with_own_folder
from .errors import MeshFileError
from .mesh_data import MeshData
from .source import Source, scratch_named
from .texture_names import encoded
from .textures import leave_out_damaged

if TYPE_CHECKING:
    import pymeshlab

_FAUX_SHIFT = 18  # see ply.py
# Diagonals of the first, the other and the last triangle of a fan, as in MeshData.faux.
_FIRST_OF_FAN, _WITHIN_FAN, _LAST_OF_FAN = 4, 5, 1
_MOST_LOOKED_AT, _LONGEST_FAN = 1000, 200
Column: TypeAlias = tuple[str, str, Any]
_PLY_TYPE = {"f8": "double", "f4": "float", "u1": "uchar", "i4": "int"}


def to_mesh_set(data: MeshData, source: Source) -> "pymeshlab.MeshSet":
    """A new mesh set with the mesh as its only one.

    Raises:
        MeshFileError: MeshLab did not take over what was read.
    """
    mesh_set = _from_the_file_itself(data, source) if data.as_it_stands else None
    if mesh_set is None:
        mesh_set = with_own_folder(_load, _written_for_meshlab(data, source))
    if leave_out_damaged(data, mesh_set.current_mesh().textures()):
        mesh_set = with_own_folder(_load, _written_for_meshlab(data, source))
    mesh = mesh_set.current_mesh()
    mesh.set_label(Path(source.shown).name.encode("utf-8", "replace").decode())
    if not _is_taken_over(mesh, data):
        counts = f"{mesh.vertex_number()} vertices and {mesh.face_number()} faces"
        expected = f"{len(data.vertices)} and {len(data.triangles)}"
        raise MeshFileError(
            f"{source.shown} cannot be read: MeshLab made {counts} of {expected}, or moved them; please report this"
        )
    return mesh_set


def _from_the_file_itself(data: MeshData, source: Source) -> "pymeshlab.MeshSet | None":
    """What MeshLab's reader makes of the file; nothing where it is not what is in it."""
    import pymeshlab

    with suppress(pymeshlab.PyMeshLabException):
        mesh_set = with_own_folder(_load, source.path)
        if _is_taken_over(mesh_set.current_mesh(), data):
            return mesh_set
    return None


def _load(path: Path) -> "pymeshlab.MeshSet":
    import pymeshlab

    forget_failures()
    mesh_set = pymeshlab.MeshSet()
    with plain_path(path) as plain:
        mesh_set.load_new_mesh(plain)
    return mesh_set


def _is_taken_over(mesh: "pymeshlab.Mesh", data: MeshData) -> bool:
    """Whether MeshLab has as many vertices and faces, in the same box."""
    if (mesh.vertex_number(), mesh.face_number()) != (len(data.vertices), len(data.triangles)):
        return False
    if not len(data.vertices):
        return True
    box = mesh.bounding_box()
    columns = data.vertices.T  # one at a time: over both axes at once NumPy takes twenty times as long
    low, high = [column.min() for column in columns], [column.max() for column in columns]
    return bool(np.allclose(box.min(), low, rtol=1e-12, atol=0) and np.allclose(box.max(), high, rtol=1e-12, atol=0))


def _written_for_meshlab(data: MeshData, source: Source) -> Path:
    """The mesh as a file, with links to its textures beside it."""
    with scratch_named(source.shown):
        return _write(data, source.scratch)


def _write(data: MeshData, folder: Path) -> Path:
    names = _textures(data, folder)
    vertex: list[Column] = [(name, "f8", data.vertices[:, k]) for k, name in enumerate("xyz")]
    if data.vertex_normals is not None:
        vertex += [(name, "f8", data.vertex_normals[:, k]) for k, name in enumerate(("nx", "ny", "nz"))]
    if data.vertex_colors is not None:
        vertex += _colors(data.vertex_colors)
    if data.vertex_quality is not None:
        vertex.append(("quality", "f8", data.vertex_quality))
    if data.vertex_uv is not None:
        vertex += [(name, "f4", data.vertex_uv[:, k]) for k, name in enumerate(("texture_u", "texture_v"))]
    face: list[Column] = [("vertex_indices", "i4", data.triangles)]
    if data.faux is not None:
        face.append(("flags", "i4", data.faux.astype(np.int32) << _FAUX_SHIFT))
    if data.wedge_uv is not None:
        face.append(("texcoord", "f4", data.wedge_uv.reshape(-1, 6)))
        if data.texture_of_face is not None:
            face.append(("texnumber", "i4", data.texture_of_face))
    if data.face_colors is not None:
        face += _colors(data.face_colors)
    if data.face_quality is not None:
        face.append(("quality", "f8", data.face_quality))
    path = folder / "mesh.ply"
    vertex_table, face_tables = _table(vertex), _face_tables(face, data)
    rows = {"vertex": len(vertex_table), "face": sum(len(table) for table in face_tables)}
    with path.open("wb") as file:
        file.write(b"ply\nformat binary_little_endian 1.0\n")
        file.write("".join(f"comment TextureFile {name}\n" for name in names).encode())
        for element, columns in (("vertex", vertex), ("face", face)):
            file.write(f"element {element} {rows[element]}\n{_properties(columns)}".encode())
        file.write(b"end_header\n")
        for table in (vertex_table, *face_tables):
            file.write(table.view(np.uint8).data)
    return path


def _face_tables(columns: list[Column], data: MeshData) -> list[Any]:
    """The rows of all faces. One polygon is written as such: it tells MeshLab that the mesh is made of polygons.

    MeshLab takes no polygons where there are texture coordinates; there the plugin's filters tell it.
    """
    first, count = _a_fan(data) if data.wedge_uv is None else (0, 0)
    if not count:
        return [_table(columns)]
    corners = np.concatenate([data.triangles[first], data.triangles[first + 1 : first + count, 2]])
    before = [(name, kind, values[:first]) for name, kind, values in columns]
    after = [(name, kind, values[first + count :]) for name, kind, values in columns]
    polygon = [
        (name, kind, corners[None] if name == "vertex_indices" else values[first : first + 1])
        for name, kind, values in columns
    ]
    return [_table(before), _table(polygon), _table(after)]


def _a_fan(data: MeshData) -> tuple[int, int]:
    """The first triangle and the number of triangles of a polygon that was cut up as a fan; no triangles: none was."""
    if data.faux is None:
        return 0, 0
    for first in np.flatnonzero(data.faux == _FIRST_OF_FAN)[:_MOST_LOOKED_AT].tolist():
        count = 1
        while first + count < len(data.faux) and data.faux[first + count] == _WITHIN_FAN and count < _LONGEST_FAN:
            count += 1
        part = data.triangles[first : first + count + 1]
        if (
            len(part) == count + 1
            and data.faux[first + count] == _LAST_OF_FAN
            and (part[:, 0] == part[0, 0]).all()
            and (part[1:, 1] == part[:-1, 2]).all()
        ):
            return first, count + 1
    return 0, 0


def _textures(data: MeshData, folder: Path) -> list[str]:
    names = []
    for texture in data.textures:
        name = encoded(texture.name)
        if (folder / name).is_symlink() or (folder / name).exists():  # it is written for the second time
            pass
        elif isinstance(texture.image, bytes):
            (folder / name).write_bytes(texture.image)
        else:
            (folder / name).symlink_to(texture.image)
        names.append(name)
    return names


def _colors(colors: Any) -> list[Column]:
    return [(name, "u1", colors[:, k]) for k, name in enumerate(("red", "green", "blue", "alpha"))]


def _properties(columns: list[Column]) -> str:
    lists = {"vertex_indices", "texcoord"}
    return "".join(
        f"property {'list uchar ' if name in lists else ''}{_PLY_TYPE[kind]} {name}\n" for name, kind, _ in columns
    )


def _table(columns: list[Column]) -> Any:
    """The rows as they stand in the file; a list has its length before it."""
    fields: list[Any] = []
    for name, kind, values in columns:
        if values.ndim == 2:
            fields += [("length of " + name, "u1"), (name, "<" + kind, values.shape[1:])]
        else:
            fields.append((name, "<" + kind))
    table = np.zeros(len(columns[0][2]), dtype=fields)
    for name, _, values in columns:
        table[name] = values
        if values.ndim == 2:
            table["length of " + name] = values.shape[1]
    return table
