# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A file of named arrays: 8 bytes with the length of a table, the table as JSON, and the arrays one after the other.

Numbers are little-endian as the table says; a name has [type, shape, offset behind the table].
"""

import json
import os
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from ..files.errors import MeshFileError, printable
from ..files.staging import unwritable

Array: TypeAlias = np.ndarray[Any, Any]


def save_arrays(path: Path, arrays: Mapping[str, Array]) -> dict[str, Any]:
    """Writes a file whole or not at all, and returns its name, size and checksum.

    Raises:
        MeshFileError: it cannot be written; the text names the folder.
    """
    table, at = {}, 0
    for name, array in arrays.items():
        table[name] = [array.dtype.str, list(array.shape), at]
        at += array.nbytes
    head = json.dumps(table).encode()
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    checksum = size = 0
    pieces: list[Any] = [len(head).to_bytes(8, "little"), head, *map(bytes_of, arrays.values())]
    try:
        with part.open("wb") as file:
            for piece in pieces:
                file.write(piece)
                checksum = zlib.crc32(piece, checksum)
                size += len(piece)
        part.replace(path)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise unwritable(printable(path), error, path.parent) from None
    return {"file": path.name, "size": size, "checksum": checksum}


def is_whole(folder: Path, written: Mapping[str, Any]) -> bool:
    """Whether a file is there as save_arrays has written it."""
    path = folder / written["file"]
    try:
        if path.stat().st_size != written["size"]:
            return False
        checksum = 0
        with path.open("rb") as file:
            while piece := file.read(1 << 20):
                checksum = zlib.crc32(piece, checksum)
    except OSError:
        return False
    return bool(checksum == written["checksum"])


class ArrayFile:
    """A file to read from, array by array or in parts."""

    def __init__(self, path: Path) -> None:
        """Reads its table.

        Raises:
            MeshFileError: it is missing or damaged.
        """
        self._path = path
        try:
            with path.open("rb") as file:
                length = int.from_bytes(file.read(8), "little")
                self._table: dict[str, Any] = json.loads(file.read(min(length, 1 << 24)))
        except (OSError, ValueError) as error:
            raise MeshFileError(f"{printable(path)} is damaged or missing: {error}") from None
        self._start = 8 + length

    def __contains__(self, name: str) -> bool:
        return name in self._table

    def __len__(self) -> int:
        return len(self._table)

    def rows(self, name: str) -> int:
        """How many rows an array has."""
        return int(self._table[name][1][0])

    def columns(self, name: str) -> int:
        """How many numbers a row of an array has; 0 where there is no such array."""
        return int(np.prod(self._table[name][1][1:], dtype=np.int64)) if name in self._table else 0

    def read(self, name: str, begin: int = 0, end: int | None = None) -> Array:
        """Rows of an array, all of them by default.

        Raises:
            MeshFileError: the file is cut off.
        """
        kind, shape, at = self._table[name]
        dtype, width = np.dtype(kind), int(np.prod(shape[1:], dtype=np.int64))
        end = shape[0] if end is None else end
        with self._path.open("rb") as file:
            file.seek(self._start + at + begin * width * dtype.itemsize)
            array = np.fromfile(file, dtype, (end - begin) * width)
        if len(array) != (end - begin) * width:
            raise MeshFileError(f"{printable(self._path)} is damaged: it is cut off")
        return array.reshape([end - begin, *shape[1:]])


def bytes_of(array: Any) -> memoryview:
    """The bytes of an array, which has to be contiguous to be taken without a copy."""
    contiguous: Any = np.ascontiguousarray(array)
    return memoryview(contiguous).cast("B") if array.size else memoryview(b"")
