# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""STL files, binary and text; corners at the same place become one vertex."""

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted, shortened
from .mesh_data import Floats, Integers, MeshData, check_finite
from .numbers import is_number, line_of, not_a_number, parse_numbers
from .source import Source
from .text_lines import cleaned

_HEADER = 84
_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_WORDS = (b"endfacet", b"endloop", b"facet", b"normal", b"outer", b"loop", b"vertex")
_IN_A_FACET = {b"vertex": 3}  # how often a word stands in a facet; the others once
_INDENT = 64  # blanks before the word solid
_MOST_LOOKED_AT_FOR_COLOR = 1000


def read_stl(source: Source) -> MeshData:
    """Reads an STL file.

    Raises:
        DamageError: it is longer or shorter than its number of facets says, or a line is none of STL.
    """
    content = source.read()
    announced = int.from_bytes(content[80:_HEADER], "little") if len(content) >= _HEADER else 0
    if len(content) == _HEADER + announced * _FACET.itemsize and len(content) >= _HEADER:
        return _binary(content, announced)
    if not _looks_like_text(content):
        raise _wrong_length(content, announced)
    return _welded(_text(content))


def _looks_like_text(content: bytes) -> bool:
    start = content[:1000].removeprefix(b"\xef\xbb\xbf")
    return b"\0" not in start and re.match(rb"\s*solid\b", start, re.I) is not None


def _wrong_length(content: bytes, announced: int) -> DamageError:
    if len(content) < _HEADER:
        return DamageError(
            "", "it is too short for an STL file and does not begin with 'solid'", "it is cut off or no STL"
        )
    expected = _HEADER + announced * _FACET.itemsize
    return DamageError(
        "byte 80",
        f"the header announces {counted(announced, 'facet')}, which take {expected:,} bytes, "
        f"but the file has {len(content):,}",
        "it is cut off, or damaged" if len(content) < expected else "the count is wrong, or two files were joined",
    )


def _binary(content: bytes, facets: int) -> MeshData:
    table = np.frombuffer(content, _FACET, facets, _HEADER)
    data = _welded(table["corners"].reshape(-1, 3))
    attributes = table["attribute"]
    rgb = b"COLOR=" in content[:80] and b"MATERIAL=" in content[:80]  # as Materialise Magics has it
    if (attributes[:_MOST_LOOKED_AT_FOR_COLOR] != 0).any():
        data.face_colors = _colors(attributes, rgb)
    return data


def _colors(attributes: NDArray[np.uint16], rgb: bool) -> NDArray[np.uint8]:
    """Three times five bits, in one of two orders."""
    parts = [((attributes >> shift) % 32 * 8).astype(np.uint8) for shift in (0, 5, 10)]
    if not rgb:
        parts.reverse()
    return np.stack([*parts, np.full(len(attributes), 255, np.uint8)], axis=1)


def _welded(corners: NDArray[Any]) -> MeshData:
    """Vertices in the order in which they come first, as MeshLab's reader has them."""
    points = corners.astype(np.float64)
    check_finite(points)
    first, vertex_of_corner = _first_of_equal(points)
    return MeshData(points[first], vertex_of_corner.reshape(-1, 3))


def _first_of_equal(points: Floats) -> tuple[Integers, Integers]:
    """Which points come first at their place, in their order, and which of these is at the place of every point."""
    if not len(points):
        return np.empty(0, np.int64), np.empty(0, np.int64)
    points = points + 0.0  # -0 is 0
    hashes = _hash(points)
    order = np.argsort(hashes, kind="stable")  # the first of equal ones stays first
    new = _changes(points[order])
    if np.count_nonzero(new) != np.count_nonzero(_changes(hashes[order, None])):  # two points with the same hash
        order = np.lexsort((points[:, 2], points[:, 1], points[:, 0]))
        new = _changes(points[order])
    first_of_group = order[new]
    rank = np.argsort(np.argsort(first_of_group))
    vertex_of_corner = np.empty(len(points), np.int64)
    vertex_of_corner[order] = rank[np.cumsum(new) - 1]
    return np.sort(first_of_group), vertex_of_corner


def _hash(points: Floats) -> NDArray[np.uint64]:
    """A number for every point, the same for equal ones."""
    bits = points.view(np.uint64)
    mixed = bits[:, 0] * np.uint64(0x9E3779B97F4A7C15)
    for column in (1, 2):
        mixed = (mixed ^ (mixed >> np.uint64(29)) ^ bits[:, column]) * np.uint64(0xBF58476D1CE4E5B9)
    return np.asarray(mixed ^ (mixed >> np.uint64(32)))


def _changes(ordered: NDArray[Any]) -> NDArray[np.bool_]:
    """Where a row differs from the one before."""
    return np.concatenate([[True], (ordered[1:] != ordered[:-1]).any(axis=1)])


def _text(content: bytes) -> Floats:
    """Corners of all facets, in the precision in which they are written."""
    lower, is_closed = _without_names(cleaned(content).lower())
    facets = lower.count(b"endfacet")
    numbers = lower
    for word in _WORDS:
        if numbers.count(word) != facets * _IN_A_FACET.get(word, 1):
            raise _misplaced(lower)
        numbers = numbers.replace(word, b" " * len(word))
    try:
        values = parse_numbers(numbers)
    except DamageError:
        raise _misplaced(lower) from None
    if len(values) != 12 * facets:
        raise _misplaced(lower)
    if not is_closed:
        raise DamageError(
            "end of file", f"there is no line 'endsolid' after {counted(facets, 'facet')}", "it is cut off"
        )
    return values.reshape(-1, 4, 3)[:, 1:].reshape(-1, 3)


def _without_names(lower: bytes) -> tuple[bytes, bool]:
    """The text without the lines solid and endsolid, and whether the last of them is endsolid."""
    text, at, is_closed = bytearray(lower), lower.find(b"solid"), False
    while at >= 0:
        before = lower[max(at - _INDENT, 0) : at].rpartition(b"\n")
        if before[2].strip() in (b"", b"end") and (before[1] or at <= _INDENT):
            end = lower.find(b"\n", at)
            end = len(lower) if end < 0 else end
            start = at - len(before[2])
            text[start:end] = b" " * (end - start)
            is_closed = before[2].strip() == b"end"
            at = end
        at = lower.find(b"solid", at + 1)
    return bytes(text), is_closed


def _misplaced(text: bytes) -> DamageError:
    """Looks for the first word that is not the one that has to come there."""
    number = b"a number"
    facet = [b"facet", b"normal", *[number] * 3, b"outer", b"loop"]
    facet += [b"vertex", *[number] * 3] * 3 + [b"endloop", b"endfacet"]
    expected = 0
    for word in re.finditer(rb"\S+", text):
        wanted = facet[expected]
        if is_number(word[0]) if wanted is number else word[0] == wanted:
            expected = (expected + 1) % len(facet)
            continue
        if wanted is not number and wanted.startswith(word[0]) and not text[word.end() :].strip():
            return _ends_within(wanted)
        what, remedy = f"{shortened(word[0])} where {shortened(wanted)} has to stand", ""
        if wanted is number and b"," in word[0]:
            what, remedy = not_a_number(word[0])
        return DamageError(f"line {line_of(text, word.start())}", what.replace("'a number'", "a number"), remedy)
    return _ends_within(facet[expected]) if expected else DamageError("", "it has no facets that can be read")


def _ends_within(wanted: bytes) -> DamageError:
    what = f"it ends within a facet, before {shortened(wanted)}".replace("'a number'", "a number")
    return DamageError("end of file", what, "it is cut off")
