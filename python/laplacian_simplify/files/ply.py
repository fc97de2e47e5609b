# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""PLY files."""

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted
from .mesh_data import Colors, Floats, Integers, MeshData, check_finite, check_indices
from .ply_header import Element, Header, parse_header
from .ply_tables import Columns, Lists, read_tables
from .source import Source
from .textures import use_textures
from .triangulate import Triangulation, triangulate

_FAUX_FLAGS = 0x1C0000  # where VCG keeps the three bits of MeshData.faux in the property "flags"
_FAUX_SHIFT = 18

_NONE = Lists(np.empty(0), np.empty(0, np.int64))  # stands for a column of numbers that is not there

# What MeshLab's reader takes as it stands, in little-endian files of triangles: everything else is written anew for it.
_PLAIN_HEADER = re.compile(
    rb"ply\nformat binary_little_endian 1\.0\n"
    rb"((comment|obj_info) [ -~]*\n|element \w+ \d+\n|property [\w ]+\n)*end_header\n"
)
_PLAIN_VERTEX = {
    **dict.fromkeys(("x", "y", "z", "nx", "ny", "nz", "quality"), ("f4", "f8")),
    **dict.fromkeys(("red", "green", "blue", "alpha"), ("u1",)),
}
_PLAIN_FACE = {
    "vertex_indices": ("i4", "u4"),
    **dict.fromkeys(("red", "green", "blue", "alpha"), ("u1",)),
    "quality": ("f4", "f8"),
}


def read_ply(source: Source) -> MeshData | None:
    """Reads a PLY file; nothing where it is a range grid, which MeshLab meshes.

    Raises:
        DamageError: names the line of the header, or the element and the row.
    """
    content = source.read()
    header = parse_header(content)
    if header.element("range_grid"):
        return None
    vertex = header.element("vertex")
    if vertex is None:
        raise DamageError("header", "it has no element 'vertex'", "the file is damaged, or holds no mesh")
    if {"x", "y", "z"} - {row.name for row in vertex.properties if not row.count_type}:
        raise DamageError("header", "element 'vertex' lacks one of the numbers x, y, z", "the file is damaged")
    tables = read_tables(content, header)
    data = _vertices(tables["vertex"], vertex)
    _add_faces(data, tables, header)
    use_textures(data, header.textures, source.folder)
    edges = header.element("edge")
    if edges and edges.rows:
        data.notes.append(f"{counted(edges.rows, 'edge')} left out")
    data.as_it_stands = source.is_the_file_itself and _is_plain(content[: header.size], header, tables)
    return data


def _vertices(columns: Columns, element: Element) -> MeshData:
    positions = _numbers(columns, "x", "y", "z")
    assert positions is not None  # the header has them
    data = MeshData(positions, np.empty((0, 3), np.int64))
    check_finite(data.vertices)
    data.vertex_normals = _numbers(columns, "nx", "ny", "nz")
    data.vertex_colors = _colors(columns, element)
    for name in ("quality", "confidence"):
        if name in columns and data.vertex_quality is None:
            data.vertex_quality = _numbers(columns, name)[:, 0]  # type: ignore[index]
    for names in (("texture_u", "texture_v"), ("s", "t")):
        if data.vertex_uv is None:
            data.vertex_uv = _numbers(columns, *names)
    return data


def _numbers(columns: Columns, *names: str) -> Floats | None:
    """Columns side by side; nothing where one is missing."""
    picked = [columns.get(name) for name in names]
    if any(column is None or isinstance(column, Lists) for column in picked):
        return None
    return np.stack([np.asarray(column, dtype=np.float64) for column in picked], axis=1)


def _colors(columns: Columns, element: Element) -> Colors | None:
    """Four bytes a row, from whatever numbers the file has."""
    types = {row.name: row.type for row in element.properties}

    def of_column(name: str) -> NDArray[np.uint8]:
        return as_bytes(np.asarray(columns[name]), types[name])

    for prefix in ("", "diffuse_"):
        names = [prefix + name for name in ("red", "green", "blue", "alpha")]
        if all(name in columns and not isinstance(columns[name], Lists) for name in names[:3]):
            picked = [of_column(name) for name in names[:3]]
            opaque = np.full(len(picked[0]), 255, np.uint8)
            picked.append(of_column(names[3]) if not isinstance(columns.get(names[3], _NONE), Lists) else opaque)
            return np.stack(picked, axis=1)
    if not isinstance(columns.get("intensity", _NONE), Lists):
        gray = of_column("intensity")
        return np.stack([gray, gray, gray, np.full_like(gray, 255)], axis=1)
    return None


def as_bytes(column: NDArray[Any], type_name: str, brightest: float | None = None) -> NDArray[np.uint8]:
    """Colors as they may be: bytes, two bytes, or real numbers from 0 to 1.

    Args:
        column: of one part of them.
        type_name: that of its property.
        brightest: the largest of all, where the column is a part.
    """
    if column.dtype == np.uint8:
        return column
    numbers = np.nan_to_num(column.astype(np.float64))
    if type_name == "u2":
        numbers = numbers // 257
    elif type_name[0] == "f" and (numbers.max(initial=0) if brightest is None else brightest) <= 1:
        numbers = numbers * 255
    return np.asarray(np.clip(numbers, 0, 255), dtype=np.uint8)


def _add_faces(data: MeshData, tables: dict[str, Columns], header: Header) -> None:
    element = header.element("face")
    if element is None:
        if "tristrips" in tables:
            data.triangles = _strips(tables["tristrips"], len(data.vertices))
        return
    columns = tables["face"]
    lists = _vertex_lists(columns)
    rows = np.arange(len(lists.counts))
    indices = _whole(lists.values)
    few = lists.counts < 3
    check_indices(indices, len(data.vertices), 3 if _all_are(lists.counts, 3) else np.repeat(rows, lists.counts))
    if few.any():
        data.notes.append(f"{counted(int(few.sum()), 'face')} with fewer than three corners left out")
    cut = triangulate(data.vertices, indices, lists.counts)
    data.triangles = cut.of_corners(indices)
    data.faux = cut.faux
    colors = _colors({name: column for name, column in columns.items() if name != "intensity"}, element)
    data.face_colors = None if colors is None else cut.of_polygons(colors)
    quality = _numbers(columns, "quality")
    data.face_quality = None if quality is None else cut.of_polygons(quality[:, 0])
    _add_wedges(data, columns, lists.counts, cut)
    flags = columns.get("flags")
    if data.faux is None and flags is not None and not isinstance(flags, Lists):
        data.faux = ((_whole(flags) & _FAUX_FLAGS) >> _FAUX_SHIFT).astype(np.uint8)


def _vertex_lists(columns: Columns) -> Lists:
    for name in ("vertex_indices", "vertex_index"):
        column = columns.get(name)
        if isinstance(column, Lists):
            return column
    raise DamageError("header", "element 'face' has no list 'vertex_indices'", "the file is damaged, or holds no mesh")


def _whole(values: NDArray[Any]) -> Integers:
    """Indices, which some files have as real numbers."""
    if values.dtype.kind in "iu":
        return np.ascontiguousarray(values, dtype=np.int32 if values.dtype == np.int32 else np.int64)
    with np.errstate(invalid="ignore"):
        sound = (np.abs(values) < 2**53) & (values == np.floor(values))
    if not sound.all():
        raise DamageError("element 'face'", f"the index {float(values[np.argmin(sound)]):g} is no whole number")
    return values.astype(np.int64)


def _all_are(counts: Integers, number: int) -> bool:
    return len(counts) > 0 and int(counts.min()) == number == int(counts.max())


def _add_wedges(data: MeshData, columns: Columns, corners: Integers, cut: Triangulation) -> None:
    """Texture coordinates at the corners of faces, where every face has a pair for each."""
    lists = columns.get("texcoord")
    if not isinstance(lists, Lists):
        return
    if (lists.counts != 2 * corners).any():
        if lists.counts.any():
            data.notes.append("texture coordinates left out: some faces have too few or too many of them")
        return
    pairs = np.asarray(lists.values, dtype=np.float64).reshape(-1, 2)
    data.wedge_uv = cut.of_corners(pairs)
    number = columns.get("texnumber")
    if number is not None and not isinstance(number, Lists):
        data.texture_of_face = cut.of_polygons(_whole(number))


def _strips(columns: Columns, vertices: int) -> Integers:
    """Strips of triangles, divided by -1, as old files have them: every other triangle is turned round."""
    lists = _vertex_lists(columns)
    indices = _whole(lists.values)
    ends = np.zeros(len(indices), dtype=bool)
    ends[np.cumsum(lists.counts)[lists.counts > 0] - 1] = True
    check_indices(indices[indices != -1], vertices, np.zeros(len(indices), np.int64))
    triangles, strip = [], []
    for index, last in zip(indices.tolist(), ends.tolist(), strict=True):
        if index >= 0:
            strip.append(index)
            if len(strip) >= 3:
                a, b, c = strip[-3:]
                triangles.append((a, b, c) if len(strip) % 2 else (b, a, c))
        if index < 0 or last:
            strip = []
    return np.array(triangles, dtype=np.int64).reshape(-1, 3)


def _is_plain(text: bytes, header: Header, tables: dict[str, Columns]) -> bool:
    """Whether MeshLab's reader takes the file exactly as it stands."""
    names = [element.name for element in header.elements]
    if header.byte_order != "<" or header.textures or names != ["vertex", "face"] or not _PLAIN_HEADER.fullmatch(text):
        return False
    vertex, face = header.elements
    lists = tables["face"].get("vertex_indices")
    return (
        _are_known(vertex, _PLAIN_VERTEX)
        and _are_known(face, _PLAIN_FACE)
        and len({row.type for row in vertex.properties if row.name in ("x", "y", "z")}) == 1
        and isinstance(lists, Lists)
        and _all_are(lists.counts, 3)
    )


def _are_known(element: Element, known: dict[str, tuple[str, ...]]) -> bool:
    return all(
        row.type in known.get(row.name, ()) and row.count_type == ("u1" if row.name == "vertex_indices" else "")
        for row in element.properties
    )
