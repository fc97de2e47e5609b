# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OFF files: polygons of any number of corners, with colors of vertices and faces."""

import re

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted, shortened
from .mesh_data import Floats, Integers, MeshData, check_finite, check_indices
from .numbers import parse_numbers
from .source import Source
from .text_lines import Lines
from .triangulate import triangulate

_LARGEST_INDEX = 2**53
_HEADER = re.compile(r"((?P<st>ST)|(?P<c>C)|(?P<n>N)|(?P<four>4)|(?P<many>n))*OFF", re.ASCII)


def read_off(source: Source) -> MeshData:
    """Reads an OFF file in text.

    Raises:
        DamageError: names the vertex or the face.
    """
    lines = Lines(source.read())
    kind, counts, first = _header(lines)
    vertices, faces = _counts(counts, lines, first)
    data = _vertices(lines, first, vertices, kind)
    _faces(lines, first + vertices, faces, data)
    return data


def _header(lines: Lines) -> tuple["re.Match[str]", list[bytes], int]:
    """The letters of the first line, the words with the counts, and the line after these."""
    words = lines.words(0) if len(lines) else []
    kind = _HEADER.fullmatch(words[0].decode("latin-1")) if words else None
    if kind is None:
        quoted = shortened(words[0]) if words else "nothing"
        raise DamageError(lines.name(0), f"{quoted} instead of 'OFF'", "this is no OFF file")
    if len(words) > 1 and words[1].upper() == b"BINARY":
        raise DamageError(lines.name(0), "binary OFF is not read", "convert it to PLY or to OFF in text")
    if kind["four"] or kind["many"]:
        raise DamageError(lines.name(0), f"{kind[0]} has vertices in more than three dimensions", "only three are read")
    if len(words) > 1:
        return kind, words[1:], 1
    return kind, lines.words(1) if len(lines) > 1 else [], 2


def _counts(words: list[bytes], lines: Lines, first: int) -> tuple[int, int]:
    """Numbers of vertices and faces; the number of edges, which may be missing, means nothing."""
    if len(words) not in (2, 3) or not all(re.fullmatch(rb"\d{1,18}", word) for word in words[:2]):
        raise DamageError(
            lines.name(first - 1), "it has no numbers of vertices and faces", "it is damaged, or no OFF file"
        )
    vertices, faces = int(words[0]), int(words[1])
    found = max(len(lines) - first, 0)
    if vertices > found:
        raise DamageError("end of file", f"the file ends after {found:,} of {vertices:,} vertices", "it is cut off")
    if vertices + faces > found:
        raise DamageError(
            "end of file", f"the file ends after {found - vertices:,} of {faces:,} faces", "it is cut off"
        )
    if vertices + faces < found:
        raise DamageError(
            lines.name(first + vertices + faces),
            f"it goes on after the {vertices:,} vertices and {faces:,} faces that its header announces",
            "the counts are wrong, or the file is damaged",
        )
    return vertices, faces


def _vertices(lines: Lines, first: int, count: int, kind: "re.Match[str]") -> MeshData:
    sizes = lines.word_counts(first, first + count)
    least = 3 + (3 if kind["n"] else 0) + (2 if kind["st"] else 0)
    normals_at, colors_at = 3, least - (2 if kind["st"] else 0)
    if kind[0].startswith("NC"):  # MeshLab's: with the colors first
        normals_at, colors_at = 7, 3
        least += 4
    short = sizes < least
    if short.any():
        vertex = int(np.argmax(short))
        raise DamageError(
            f"{lines.name(first + vertex)}, vertex {vertex}",
            f"{sizes[vertex]} numbers instead of {least}",
            "every vertex stands on a line of its own",
        )
    numbers = _numbers(lines, first, first + count)
    starts = np.cumsum(sizes) - sizes
    points = numbers[starts[:, None] + np.arange(3)] if count else np.empty((0, 3))
    check_finite(points)
    data = MeshData(points, np.empty((0, 3), np.int64))
    if kind["n"] and count:
        data.vertex_normals = numbers[starts[:, None] + np.arange(normals_at, normals_at + 3)]
    if kind["c"]:
        real = lines.words_with(b".", first, first + count)
        size = np.full(count, 4) if colors_at < normals_at else sizes - least
        data.vertex_colors = _colors(numbers, starts + colors_at, size, real)
    return data


def _faces(lines: Lines, first: int, count: int, data: MeshData) -> None:
    sizes = lines.word_counts(first, first + count)
    numbers = _numbers(lines, first, first + count)
    starts = np.cumsum(sizes) - sizes
    if not count:
        return
    corners = _corner_counts(numbers[starts], sizes, lines, first)
    within = np.arange(int(corners.sum())) - np.repeat(np.cumsum(corners) - corners, corners)
    face = np.repeat(np.arange(count), corners)
    values = numbers[np.repeat(starts + 1, corners) + within]
    sound = (values == np.floor(values)) & (np.abs(values) < _LARGEST_INDEX)
    if not sound.all():
        bad = int(face[np.argmin(sound)])
        raise DamageError(f"{lines.name(first + bad)}, face {bad}", "a vertex index is no whole number")
    indices = values.astype(np.int64)
    check_indices(indices, len(data.vertices), face)
    few = int((corners < 3).sum())
    if few:
        data.notes.append(f"{counted(few, 'face')} with fewer than three corners left out")
    cut = triangulate(data.vertices, indices, corners)
    data.triangles, data.faux = cut.of_corners(indices), cut.faux
    colors = _colors(numbers, starts + 1 + corners, sizes - 1 - corners, lines.words_with(b".", first, first + count))
    data.face_colors = None if colors is None else cut.of_polygons(colors)


def _corner_counts(announced: Floats, sizes: Integers, lines: Lines, first: int) -> Integers:
    sound = (announced >= 1) & (announced == np.floor(announced)) & (announced < sizes)
    if not sound.all():
        face = int(np.argmin(sound))
        raise DamageError(
            f"{lines.name(first + face)}, face {face}",
            f"it announces {announced[face]:g} corners and has {sizes[face] - 1}",
            "the file is cut off or damaged",
        )
    return announced.astype(np.int64)


def _numbers(lines: Lines, first: int, last: int) -> Floats:
    return parse_numbers(lines.data, *lines.span(first, last))


def _colors(numbers: Floats, places: Integers, sizes: Integers, real: NDArray[np.bool_]) -> NDArray[np.uint8] | None:
    """Three or four numbers a row: bytes, or from 0 to 1 where a word has a point; white where a row has none.

    A single number, a place in a color map, says nothing without the map and counts as none.
    """
    has = (sizes == 3) | (sizes == 4)
    if not has.any():
        return None
    colors = np.full((len(sizes), 4), 255.0)
    for size in (3, 4):
        rows = np.flatnonzero(sizes == size)
        words = places[rows, None] + np.arange(size)
        scale = np.where(real[words].any(axis=1), 255.0, 1.0)[:, None]
        colors[rows[:, None], np.arange(size)] = numbers[words] * scale
    return np.asarray(np.clip(np.nan_to_num(colors), 0, 255), dtype=np.uint8)
