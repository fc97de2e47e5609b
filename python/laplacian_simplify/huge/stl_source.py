# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary STL in chunks."""

import os
import zlib
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..files.errors import DamageError, printable
from .array_file import Array, bytes_of
from .chunk import Bounds, Chunk, bounds_of, without_degenerate
from .welding import welded

_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEADER = 84


class StlSource:
    """A file, of which only the header is read at once. Facets are given by ranges of their numbers."""

    single = True
    colors = 0

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

    def chunk(self, begin: int, end: int, brightest: Sequence[float] = ()) -> Chunk:  # noqa: ARG002
        """Facets with their vertices."""
        corners = self._corners(begin, end).reshape(-1, 3)
        ids, positions, triangles = welded(corners, self._shown)
        return without_degenerate(ids, positions, triangles, zlib.crc32(bytes_of(corners)))

    def _corners(self, begin: int, end: int) -> Array:
        with Path(self._path).open("rb") as file:
            file.seek(_HEADER + begin * _FACET.itemsize)
            facets = np.fromfile(file, _FACET, end - begin)
        if len(facets) != end - begin:
            raise DamageError("end of file", "it has become shorter").named(self._shown)
        corners: Array = np.ascontiguousarray(facets["corners"]) + np.float32(0)  # -0 becomes 0
        return corners
