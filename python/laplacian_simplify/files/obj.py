# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OBJ files: polygons with texture coordinates, materials and vertex colors."""

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted
from .materials import Materials
from .mesh_data import Colors, Floats, Integers, MeshData, check_finite
from .obj_faces import Faces, read_faces
from .obj_statements import Statements
from .source import Source
from .textures import use_textures
from .triangulate import Triangulation, triangulate


def read_obj(source: Source) -> MeshData:
    """Reads an OBJ file.

    Raises:
        DamageError: names the line.
    """
    statements = Statements(source.read())
    vertices = statements.numbers("v", least=3)
    data = MeshData(vertices.first(3), np.empty((0, 3), np.int64))
    try:
        check_finite(data.vertices)
    except DamageError as damage:
        raise statements.with_line("v", damage) from None
    data.vertex_colors = _vertex_colors(vertices.all, vertices.sizes)
    texture_vertices = statements.numbers("vt", least=1)
    normals = statements.numbers("vn", least=3)
    faces = read_faces(statements, len(data.vertices), len(texture_vertices.sizes), len(normals.sizes))
    cut = triangulate(data.vertices, faces.vertex, faces.sizes)
    data.triangles, data.faux = cut.of_corners(faces.vertex), cut.faux
    _add_materials(data, statements, faces, cut, source)
    if faces.texture is not None:
        _add_texture_coordinates(data, faces.texture, texture_vertices.padded(2), cut)
    if faces.normal is not None:
        _add_normals(data, faces, normals.first(3))
    if faces.too_small:
        data.notes.append(f"{counted(faces.too_small, 'face')} with fewer than three corners left out")
    left_out = statements.count("l") + statements.count("p")
    if left_out:
        data.notes.append(f"{counted(left_out, 'line or point element', 'line or point elements')} left out")
    return data


def _vertex_colors(numbers: Floats, sizes: Integers) -> Colors | None:
    """Colors that stand behind coordinates: from 0 to 1, or bytes; white for vertices without one."""
    colored = np.flatnonzero(sizes >= 6)
    if not len(colored):
        return None
    starts = np.cumsum(sizes) - sizes
    rgb = np.nan_to_num(numbers[starts[colored, None] + np.arange(3, 6)])
    rgb *= np.where((rgb <= 1).all(axis=1), 255.0, 1.0)[:, None]
    colors = np.full((len(sizes), 4), 255, dtype=np.uint8)
    colors[colored, :3] = np.clip(rgb, 0, 255)
    return colors


def _add_materials(data: MeshData, statements: Statements, faces: Faces, cut: Triangulation, source: Source) -> None:
    """The colors of materials on faces, and which texture each face has."""
    if not statements.count("usemtl") and faces.texture is None:
        return
    materials = Materials(source.path if source.is_the_file_itself else source.folder / source.path.name)
    for library in statements.names("mtllib"):
        materials.add_library(library, source.folder)
    uses = [materials.number_of(name) for name in statements.names("usemtl")]
    data.notes += materials.notes
    colors = np.array([materials.colors[0], *(materials.colors[number] for number in uses)], dtype=np.uint8)
    textures = np.array([0, *(materials.texture_of[number] for number in uses)], dtype=np.int64)
    use = np.searchsorted(statements.lines("usemtl"), faces.line, side="right")
    data.face_colors = cut.of_polygons(colors[use])
    data.texture_of_face = cut.of_polygons(textures[use])
    use_textures(data, materials.textures, source.folder)


def _add_texture_coordinates(data: MeshData, texture: Integers, coordinates: Floats, cut: Triangulation) -> None:
    """Corners without texture coordinates have zeros, where others of the file have some."""
    pairs = np.concatenate([coordinates, [[0.0, 0.0]]])
    data.wedge_uv = pairs[cut.of_corners(texture)]  # -1 is the last


def _add_normals(data: MeshData, faces: Faces, normals: Floats) -> None:
    """Normals of vertices, where all faces around each have the same; others are computed from the faces."""
    assert faces.normal is not None
    of_vertex = np.full(len(data.vertices), -1, dtype=np.int64)
    of_vertex[faces.vertex] = faces.normal
    if (of_vertex[faces.vertex] == faces.normal).all() and (of_vertex >= 0).all():
        found: NDArray[np.float64] = normals[of_vertex]
        if np.isfinite(found).all():
            data.vertex_normals = found
    elif hard := _vertices_on_hard_edges(faces, of_vertex, normals):
        left_out = counted(hard, "vertex", "vertices")
        data.notes.append(f"hard edges left out: MeshLab has one normal a vertex, and {left_out} have several")


def _vertices_on_hard_edges(faces: Faces, of_vertex: Integers, normals: Floats) -> int:
    """Vertices around which faces have normals that are more than 30 degrees apart."""
    assert faces.normal is not None
    given = (faces.normal >= 0) & (of_vertex[faces.vertex] >= 0)
    vertex, one, other = faces.vertex[given], normals[faces.normal[given]], normals[of_vertex[faces.vertex[given]]]
    with np.errstate(invalid="ignore"):
        lengths = np.linalg.norm(one, axis=1) * np.linalg.norm(other, axis=1)
        apart = (one * other).sum(axis=1) < np.cos(np.pi / 6) * lengths
    return len(np.unique(vertex[apart]))
