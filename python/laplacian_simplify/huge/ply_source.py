# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary PLY in chunks: every row of an element has the same size, so each has its place."""

import os
import zlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..files.errors import DamageError, printable
from ..files.ply import as_bytes
from ..files.ply_header import Element, Header, parse_header
from .array_file import Array, bytes_of
from .chunk import Bounds, Chunk, bounds_of, without_degenerate
from .welding import welded

_LONGEST_HEADER = 1 << 20
_WINDOW = 1 << 20  # vertices that are mapped at a time
_INDEX_LISTS = ("vertex_indices", "vertex_index")
_COUNT_OF = "count of "


class PlySource:
    """A file, of which only the header is read at once. Rows are given by ranges of their numbers."""

    def __init__(self, path: str) -> None:
        """Reads the header.

        Raises:
            MeshFileError: it is no PLY file, or not one that can be read in chunks.
            OSError: it cannot be opened.
        """
        self._path, self._shown = path, printable(path)
        try:
            with Path(path).open("rb") as file:
                header = parse_header(file.read(_LONGEST_HEADER))
                self._places = _places(header, file)
            self._check(os.path.getsize(path))  # noqa: PTH202
        except DamageError as error:
            raise error.named(self._shown) from None
        self.vertices, self.faces = (self._places[name].rows for name in ("vertex", "face"))
        self._is_soup = self.vertices >= 3 * self.faces
        self._colors = [] if self._is_soup else _color_names(self._places["vertex"])
        self.colors = len(self._colors)
        self.notes = self._left_out()
        self.single = all(np.can_cast(self._places["vertex"].dtype[name], np.float32) for name in "xyz")

    def bounds(self, begin: int, end: int) -> Bounds:
        """The box of vertices."""
        place = self._places["vertex"]
        rows = self._read(place, begin, end)
        columns = [rows[name].astype(np.float64) for name in "xyz"]
        brightest = tuple(float(np.nan_to_num(rows[name]).max(initial=0)) for name in self._colors)
        return bounds_of(columns, self._shown, zlib.crc32(bytes_of(rows.view(np.uint8))), brightest)

    def chunk(self, begin: int, end: int, brightest: Sequence[float] = ()) -> Chunk:
        """Faces with their vertices, whose ids are their rows in the file, or hashes where faces share none.

        Raises:
            MeshFileError: a face is no triangle, or a vertex of it does not exist.
        """
        place = self._places["face"]
        rows = self._read(place, begin, end)
        checksum = zlib.crc32(bytes_of(rows.view(np.uint8)))
        for name in place.lists:
            uneven = np.flatnonzero(rows[_COUNT_OF + name] != place.lists[name])
            if len(uneven):
                found = int(rows[_COUNT_OF + name][uneven[0]])
                raise _uneven(begin + int(uneven[0]), name, found, place.lists[name]).named(self._shown)
        corners = np.ascontiguousarray(rows[place.index_list]).astype(np.int64)
        del rows
        outside = np.flatnonzero(((corners < 0) | (corners >= self.vertices)).any(axis=1))
        if len(outside):
            raise DamageError(
                f"face {begin + int(outside[0]):,}",
                f"it has a vertex outside of 0 to {self.vertices - 1:,}"
                + (f", as have {len(outside) - 1:,} faces after it" if len(outside) > 1 else ""),
            ).named(self._shown)
        ids, local = _numbered(corners)
        positions, colors = self._vertices(ids, brightest)
        if self._is_soup:
            ids, positions, local = welded(positions[local.reshape(-1)], self._shown)
        return without_degenerate(ids, positions, local, checksum, colors)

    def _left_out(self) -> list[str]:
        """Notes on what is passed over."""
        colors = "no colors of faces that share no vertices" if self._is_soup else "colors of vertices"
        kept = {"vertex": {*"xyz", *self._colors}, "face": {*_INDEX_LISTS}}
        notes = [
            f"{self._shown}: '{name}' of {shown} is left out: huge keeps positions, faces and {colors} only"
            for element, shown in (("vertex", "vertices"), ("face", "faces"))
            for name in self._places[element].names
            if name not in kept[element]
        ]
        if self._is_soup:
            notes.append(f"{self._shown}: vertices with equal coordinates are one, as there are three or more a face")
        return notes

    def _check(self, size: int) -> None:
        needed = max(place.start + place.rows * place.dtype.itemsize for place in self._places.values())
        if size < needed:
            raise DamageError("end of file", f"it has {size:,} bytes of {needed:,}", "it is cut off")
        if self._places["face"].rows == 0 or self._places["vertex"].rows == 0:
            raise DamageError("", "it has no faces", "")

    def _read(self, place: "_Place", begin: int, end: int) -> Array:
        with Path(self._path).open("rb") as file:
            file.seek(place.start + begin * place.dtype.itemsize)
            rows = np.fromfile(file, place.dtype, end - begin)
        if len(rows) != end - begin:
            raise DamageError("end of file", "it has become shorter").named(self._shown)
        return rows

    def _vertices(self, ids: Array, brightest: Sequence[float]) -> tuple[Array, Array | None]:
        """Positions and colors of ascending rows, in windows, so that address space is bounded, too."""
        place = self._places["vertex"]
        positions = np.empty((len(ids), 3), np.float32 if self.single else np.float64)
        colors = np.empty((len(ids), self.colors), np.uint8) if self.colors else None
        at = 0
        while at < len(ids):
            first = int(ids[at]) // _WINDOW * _WINDOW
            stop = int(np.searchsorted(ids, first + _WINDOW))
            rows = min(_WINDOW, place.rows - first)
            window = np.memmap(self._path, place.dtype, "r", place.start + first * place.dtype.itemsize, (rows,))
            picked = window[ids[at:stop] - first]
            for k, name in enumerate("xyz"):
                positions[at:stop, k] = picked[name]
            for k, name in enumerate(self._colors):
                assert colors is not None
                type_name = place.dtype[name].str[1:]
                colors[at:stop, k] = as_bytes(picked[name], type_name, brightest[k] if brightest else None)
            at = stop
        return positions, colors


class _Place:
    """Where the rows of an element are, and what is in one."""

    def __init__(self, element: Element, start: int, fields: list[Any], lists: dict[str, int]) -> None:
        self.start, self.rows, self.dtype, self.lists = start, element.rows, np.dtype(fields), lists
        self.names = [row.name for row in element.properties]
        self.index_list = next((name for name in _INDEX_LISTS if name in lists), "")


def _color_names(vertex: _Place) -> list[str]:
    """The properties that simplify takes as a color, but for intensity; none where there is no color."""
    for prefix in ("", "diffuse_"):
        names = [prefix + name for name in ("red", "green", "blue", "alpha")]
        if set(names[:3]) <= set(vertex.names):
            return [name for name in names if name in vertex.names]
    return []


def _places(header: Header, file: Any) -> dict[str, _Place]:
    """The places of vertices and faces.

    Raises:
        DamageError: the rows of one, or of what is before it, have no size that is known.
    """
    if not header.byte_order:
        raise DamageError("", "it is a text", "huge reads binary PLY; write it as binary, or use simplify")
    places: dict[str, _Place] = {}
    at = header.size
    for element in header.elements:
        places[element.name] = place = _place(element, header.byte_order, at, file)
        at += place.rows * place.dtype.itemsize
        if "vertex" in places and "face" in places:
            break
    for name in ("vertex", "face"):
        if name not in places:
            raise DamageError("header", f"it has no element '{name}'")
    if not {"x", "y", "z"} <= set(places["vertex"].dtype.names or ()):
        raise DamageError("header", "vertices have no x, y and z")
    if not places["face"].index_list:
        raise DamageError("header", f"faces have no list {' or '.join(_INDEX_LISTS)}")
    if places["face"].rows and places["face"].lists[places["face"].index_list] != 3:
        raise _uneven(0, places["face"].index_list, places["face"].lists[places["face"].index_list], 3)
    return places


def _place(element: Element, byte_order: str, start: int, file: Any) -> _Place:
    """Lists have the length that they have in the first row; of faces, each is looked at when it is read."""
    if element.has_lists() and element.name != "face":
        raise DamageError(
            f"line {element.line}", f"element '{element.name}' has lists", "huge cannot tell the size of its rows"
        )
    fields: list[Any] = []
    lists: dict[str, int] = {}
    at = start
    for row in element.properties:
        if row.count_type:
            size = int(row.count_type[1])
            file.seek(at)
            first = file.read(size)
            count = int(np.frombuffer(first, byte_order + row.count_type)[0]) if len(first) == size else 0
            lists[row.name] = count = min(max(count, 0), 1 << 16) if element.rows else 3
            fields.append((_COUNT_OF + row.name, byte_order + row.count_type))
            fields.append((row.name, byte_order + row.type, (count,)))
            at += size + count * int(row.type[1])
        else:
            fields.append((row.name, byte_order + row.type))
            at += int(row.type[1])
    return _Place(element, start, fields, lists)


def _uneven(face: int, name: str, found: int, wanted: int) -> DamageError:
    if name in _INDEX_LISTS:
        return DamageError(f"face {face:,}", f"it has {found} corners", "huge reads triangles; use simplify")
    return DamageError(f"face {face:,}", f"its list '{name}' has {found} numbers, that of the first face {wanted}")


def _numbered(corners: Array) -> tuple[Array, Array]:
    """Ascending values, and the place of each corner among them."""
    low, span = int(corners.min()), int(corners.max()) - int(corners.min()) + 1
    if span >= 4 * corners.size:
        ids, local = np.unique(corners, return_inverse=True)
        return ids, local.reshape(-1, 3).astype(np.uint32)
    used = np.zeros(span, bool)  # of a file in any sensible order: a mark is quicker than a sort
    corners -= low
    used[corners.reshape(-1)] = True
    place = np.cumsum(used, dtype=np.uint32) - np.uint32(1)
    return np.flatnonzero(used) + low, place[corners]
