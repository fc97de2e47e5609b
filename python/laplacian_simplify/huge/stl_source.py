# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary STL in chunks. A vertex is known by a hash of its coordinates, so equal ones become one without a table."""

import os
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from ..files.errors import DamageError, printable
from .array_file import Array, bytes_of
from .chunk import Bounds, Chunk, bounds_of, without_degenerate

_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEADER = 84
# The finalizer of SplitMix64, whose output has no collisions for one word.
_FIRST, _SECOND, _STEP = (np.uint64(n) for n in (0xBF58476D1CE4E5B9, 0x94D049BB133111EB, 0x9E3779B97F4A7C15))


class StlSource:
    """A file, of which only the header is read at once. Facets are given by ranges of their numbers."""

    single = True

    def __init__(self, path: str) -> None:
        """Reads the header.

        Raises:
            MeshFileError: it is no binary STL, or is cut off.
            OSError: it cannot be opened.
        """
        self._path, self._shown = path, printable(path)
        self.notes: list[str] = []
        with Path(path).open("rb") as file:
            header = file.read(_HEADER)
        size = os.path.getsize(path)  # noqa: PTH202
        self.faces = int.from_bytes(header[80:], "little") if len(header) == _HEADER else 0
        self.vertices = 3 * self.faces
        needed = _HEADER + self.faces * _FACET.itemsize
        if header.lstrip().startswith(b"solid") and size != needed:
            raise DamageError("", "it is a text", "huge reads binary STL; write it as binary, or use simplify").named(
                self._shown
            )
        if self.faces == 0 or size < needed:
            problem = f"it has {size:,} bytes of {needed:,}" if self.faces else "it has no facets"
            raise DamageError("end of file", problem, "it is cut off" if self.faces else "").named(self._shown)

    def bounds(self, begin: int, end: int) -> Bounds:
        """The box of rows of positions, of which a facet has three."""
        corners = self._corners(begin // 3, (end + 2) // 3)
        return bounds_of(list(corners.reshape(-1, 3).T.astype(np.float64)), self._shown, zlib.crc32(bytes_of(corners)))

    def chunk(self, begin: int, end: int) -> Chunk:
        """Facets with their vertices, whose ids are hashes."""
        corners = self._corners(begin, end).reshape(-1, 3)
        ids, first, local = np.unique(hashed(corners), return_index=True, return_inverse=True)
        check_collisions(corners[first[local]], corners, self._shown)
        triangles = local.reshape(-1, 3).astype(np.uint32)
        return without_degenerate(ids, corners[first], triangles, zlib.crc32(bytes_of(corners)))

    def _corners(self, begin: int, end: int) -> Array:
        with Path(self._path).open("rb") as file:
            file.seek(_HEADER + begin * _FACET.itemsize)
            facets = np.fromfile(file, _FACET, end - begin)
        if len(facets) != end - begin:
            raise DamageError("end of file", "it has become shorter").named(self._shown)
        corners: Array = np.ascontiguousarray(facets["corners"]) + np.float32(0)  # -0 becomes 0
        return corners


def hashed(positions: Array) -> Any:
    """63 bits of each position, so that 500 million different ones collide somewhere with a chance of 1.4 %."""
    words = np.ascontiguousarray(positions, "<f4").view("<u4").astype(np.uint64)
    mixed = _mix(words[:, 0] | words[:, 1] << np.uint64(32))
    return (_mix(mixed ^ (words[:, 2] + _STEP)) >> np.uint64(1)).astype(np.int64)


def check_collisions(positions: Array, others: Array, shown: str) -> None:
    """Refuses vertices with the same id and different positions.

    Raises:
        MeshFileError: there are some.
    """
    if not np.array_equal(positions, others):
        raise DamageError(
            "", "two different vertices have the same hash", "convert the file to PLY, which numbers its vertices"
        ).named(shown)


def _mix(words: Any) -> Any:
    words = (words ^ (words >> np.uint64(30))) * _FIRST
    words = (words ^ (words >> np.uint64(27))) * _SECOND
    return words ^ (words >> np.uint64(31))
