# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The input, read in chunks: what there is to do with any format."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol

from ..files.errors import MeshFileError, printable
from .chunk import Bounds, Chunk
from .ply_source import PlySource
from .stl_source import StlSource


class Source(Protocol):
    """A mesh file whose rows have one size each, so that any of them can be found."""

    faces: int
    vertices: int
    """Rows of positions; of a format without a table of vertices, three a face."""
    single: bool
    """Whether coordinates are stored in single precision."""
    colors: int
    """Bytes that the color of a vertex has; 0: it has none."""
    notes: list[str]
    """What of it is passed over, for people."""

    def bounds(self, begin: int, end: int) -> Bounds:
        """The box of these rows of positions."""

    def chunk(self, begin: int, end: int, brightest: Sequence[float] = ()) -> Chunk:
        """These faces. Colors that are real numbers are from 0 to 1 where the brightest of the whole file is not more,
        as Bounds has it, and otherwise up to 255."""


FORMATS: dict[str, Callable[[str], Source]] = {".ply": PlySource, ".stl": StlSource}


def open_source(path: str) -> Source:
    """Reads the header of a mesh file.

    Raises:
        MeshFileError: it cannot be read in chunks; the text says why.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in FORMATS:
        raise MeshFileError(
            f"{printable(path)} cannot be read in parts: that is for binary PLY and STL; convert it, or use simplify"
        )
    try:
        return FORMATS[suffix](path)
    except OSError as error:
        if isinstance(error, MeshFileError):
            raise
        raise MeshFileError(f"{printable(path)} cannot be read: {error.strerror or error}") from None
