# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces of an OBJ file: corners as v, v/vt, v//vn or v/vt/vn, counted from 1 or, below 0, from the end."""

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, shortened
from .mesh_data import Integers
from .numbers import count_words, word_starts
from .obj_statements import Statements

_CORNER = re.compile(rb"[+-]?\d+(/([+-]?\d+)?(/([+-]?\d+)?)?)?")
_ENDS = (b" ", b"\n", b"\t")
_SLASH_TO_BLANK = bytes.maketrans(b"/", b" ")
_LONGEST_NUMBER = 18
_ABSENT = -(2**62)
"""Stands for an index that a corner does not have."""
_PARTS = (("v", "vertex"), ("vt", "texture vertex"), ("vn", "normal"))


@dataclass
class Faces:
    """Corners one face after the other, counted from 0; -1 for a texture vertex or normal that a corner lacks."""

    vertex: Integers
    texture: Integers | None
    normal: Integers | None
    sizes: Integers
    """Corners of every face."""
    line: Integers
    """The line that every face stands on."""
    too_small: int = 0
    """Faces of one or two corners, which are not among these."""


def read_faces(statements: Statements, vertices: int, textures: int, normals: int) -> Faces:
    """The faces, with every index in its range.

    Raises:
        DamageError: names the line.
    """
    lines = statements.lines("f")
    text, sizes = statements.text_of("f")
    if not len(lines):
        empty = np.empty(0, np.int64)
        return Faces(empty, None, None, empty, empty)
    if sizes.min() == 0:
        line = int(lines[int(np.argmin(sizes))])
        raise DamageError(statements.name(line), "a face without corners", "the file is damaged")
    parts = _corners(text)
    if parts is None:
        raise _bad_corner(statements, lines)
    line_of_corner = np.repeat(lines, sizes)
    found: list[Integers | None] = []
    for k, (keyword, name) in enumerate(_PARTS):
        number = (vertices, textures, normals)[k]
        column = parts[:, k] if k < parts.shape[1] else None
        if column is None or (k > 0 and (column == _ABSENT).all()):
            found.append(None)
            continue
        found.append(_from_zero(column, number, keyword, name, line_of_corner, statements))
    assert found[0] is not None
    faces = Faces(found[0], found[1], found[2], sizes, lines)
    return _without_small(faces) if sizes.min() < 3 else faces


def _corners(text: bytes) -> Integers | None:
    """A row for every corner with as many columns as the corners have parts; nothing where one is no corner."""
    slashes = text.count(b"/")
    if not slashes:
        numbers = _whole_numbers(text, count_words(text))
        return None if numbers is None else numbers.reshape(-1, 1)
    starts = word_starts(text)
    width = slashes // len(starts) + 1
    if slashes != (width - 1) * len(starts) or width > 3 or not _evenly(text, starts, width - 1):
        return _mixed_corners(text)
    doubled = text.count(b"//")
    if text.endswith(b"/") or any(b"/" + end in text for end in _ENDS):
        return _mixed_corners(text)
    if not doubled:
        numbers = _whole_numbers(text.translate(_SLASH_TO_BLANK), len(starts) * width)
        return None if numbers is None else numbers.reshape(-1, width)
    if width == 3 and doubled == len(starts):  # v//vn
        numbers = _whole_numbers(text.translate(_SLASH_TO_BLANK), len(starts) * 2)
        if numbers is None:
            return None
        pairs = numbers.reshape(-1, 2)
        return np.stack([pairs[:, 0], np.full(len(pairs), _ABSENT), pairs[:, 1]], axis=1)
    return _mixed_corners(text)


def _evenly(text: bytes, starts: Integers, number: int) -> bool:
    """Whether every word has this number of slashes, which all words together have."""
    places = np.flatnonzero(np.frombuffer(text, np.uint8) == ord("/")).reshape(-1, number)
    return bool((places[:, 0] > starts).all() and (places[:-1, -1] < starts[1:]).all())


def _mixed_corners(text: bytes) -> Integers | None:
    """Corners of several kinds in one file, one by one."""
    rows = []
    for word in text.split():
        if not _CORNER.fullmatch(word):
            return None
        parts = [int(part) if part else _ABSENT for part in word.split(b"/")]
        rows.append((*parts, *[_ABSENT] * (3 - len(parts))))
    try:
        return np.array(rows, dtype=np.int64)
    except OverflowError:
        return None


def _whole_numbers(text: bytes, expected: int) -> Integers | None:
    """Integers of at most 18 digits, so that none is too large for its type."""
    if (np.diff(word_starts(text)) > _LONGEST_NUMBER).any() and re.search(rb"\d{19}", text):
        return None
    try:
        numbers: NDArray[np.int64] = np.fromstring(text, dtype=np.int64, sep=" ")
    except (ValueError, DeprecationWarning, OverflowError):
        return None
    return numbers if len(numbers) == expected else None


def _from_zero(
    column: Integers, number: int, keyword: str, name: str, line_of_corner: Integers, statements: Statements
) -> Integers:
    """Indices from 0 on, -1 where there is none."""
    absent = column == _ABSENT
    below = (column < 0) & ~absent
    indices = column - 1
    if below.any():
        indices[below] = column[below] + statements.before(keyword, line_of_corner[below])
    indices[absent] = 0
    wrong = ((indices < 0) | (indices >= number)) & ~absent
    if wrong.any():
        at = int(np.argmax(wrong))
        line, index = int(line_of_corner[at]), int(column[at])
        if index == 0:
            what, remedy = f"{name} index 0", "OBJ counts from 1"
        elif number:
            what, remedy = f"{name} index {index} is outside 1..{number}", ""
        else:
            what, remedy = f"{name} index {index}, but the file has no '{keyword}' lines", ""
        raise DamageError(f"{statements.name(line)}, {statements.quoted(line)}", what, remedy)
    indices[absent] = -1
    return indices


def _bad_corner(statements: Statements, lines: NDArray[np.int64]) -> DamageError:
    for line in lines.tolist():
        for word in statements.words(line)[1:]:
            if not _CORNER.fullmatch(word) or re.search(rb"\d{19}", word):
                return DamageError(statements.name(line), f"{shortened(word)} is no corner of a face")
    return DamageError("", "a face cannot be read")


def _without_small(faces: Faces) -> Faces:
    """Without faces of one or two corners, which some programs write for points and edges."""
    keep = faces.sizes >= 3
    of_corner = np.repeat(keep, faces.sizes)
    return Faces(
        faces.vertex[of_corner],
        None if faces.texture is None else faces.texture[of_corner],
        None if faces.normal is None else faces.normal[of_corner],
        faces.sizes[keep],
        faces.line[keep],
        int((~keep).sum()),
    )
