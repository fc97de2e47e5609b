# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bytes of a mesh file, wherever they come from, and the format that they are in."""

import gzip
import os
import re
import stat
import sys
import zlib
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory, gettempdir
from typing import BinaryIO

from .errors import DamageError, MeshFileError, printable

STANDARD_INPUT = "-"
_GZIP = b"\x1f\x8b"
_PIECE = 1 << 20
# Meshes in text shrink to a tenth; what grows beyond this from a file is there to fill disks.
_MOST_UNPACKED, _MOST_GROWTH = 1 << 30, 200


@dataclass
class Source:
    """A file that is there and can be read."""

    shown: str
    """How messages name it."""
    path: Path
    """Where its bytes are: the file itself, or an unpacked copy in the scratch folder."""
    folder: Path
    """Where files that it refers to are looked for."""
    scratch: Path
    """A folder that is there until the mesh has been read."""
    format: str
    """Extension in lower case, by the name or by the content."""
    is_the_file_itself: bool = True
    """Not a copy, and with a name that every library opens."""

    def read(self) -> bytes:
        """All its bytes."""
        return self.path.read_bytes()


@contextmanager
def open_source(given: str | os.PathLike[str]) -> Iterator[Source]:
    """Finds a file, or takes standard input for ``-``, and unpacks it where it is compressed.

    Raises:
        MeshFileError: it is missing, not a file, empty, may not be read or is of an unknown format.
    """
    name = os.fspath(given)
    shown = "standard input" if name == STANDARD_INPUT else printable(name)
    with ExitStack() as stack:
        with scratch_named(shown):
            folder = stack.enter_context(TemporaryDirectory(prefix="laplacian-simplify-", ignore_cleanup_errors=True))
        scratch = Path(folder)
        try:
            if name == STANDARD_INPUT:
                yield _standard_input(shown, scratch)
            else:
                yield _file(name, shown, scratch)
        except DamageError as damage:
            raise damage.named(shown) from None


@contextmanager
def scratch_named(shown: str) -> Iterator[None]:
    """What the system says about the folder for scratch files, as a sentence about the file that is read."""
    try:
        yield
    except MeshFileError:
        raise
    except OSError as error:
        where = error.filename or gettempdir()
        raise MeshFileError(
            f"{shown} cannot be read: there is no room for a copy in {printable(where)} ({error.strerror or error}); "
            "free space there, or set TMPDIR to another folder"
        ) from None


def _file(name: str, shown: str, scratch: Path) -> Source:
    path = Path.cwd() / name
    start = _start_of(path, shown)
    source = Source(shown, path, path.parent, scratch, _extension(path.name), _is_plain_name(path))
    if start.startswith(_GZIP):
        source.path, source.is_the_file_itself = scratch / "unpacked", False
        with path.open("rb") as file, scratch_named(shown):
            _unpack(file, source.path)
        source.format = _extension(re.sub(r"\.gz$", "", path.name, flags=re.I))
        start = _start_of(source.path, shown)
    source.format = source.format or _format_of(start, source.path.stat().st_size)
    if not source.format:
        raise MeshFileError(
            f"{shown} cannot be read: its name has no extension, and its content is none of PLY, STL, OBJ, OFF, GLB "
            "and 3MF; rename it to the format that it is in"
        )
    return source


def _standard_input(shown: str, scratch: Path) -> Source:
    stream = getattr(sys.stdin, "buffer", None)
    if stream is None or stream.isatty():
        raise MeshFileError("standard input cannot be read: it is closed or a terminal; pipe a mesh into the command")
    path = scratch / "standard_input"
    with scratch_named(shown):
        _copy(stream, path)
    start = _start_of(path, shown)
    if start.startswith(_GZIP):
        with path.open("rb") as file, scratch_named(shown):
            _unpack(file, scratch / "unpacked")
        path = scratch / "unpacked"
        start = _start_of(path, shown)
    found = _format_of(start, path.stat().st_size)
    if not found:
        raise MeshFileError("standard input cannot be read: it is none of PLY, STL, OBJ, OFF, GLB and 3MF")
    return Source(shown, path, Path.cwd(), scratch, found, is_the_file_itself=False)


def _start_of(path: Path, shown: str) -> bytes:
    """The first bytes of a file that can be read."""
    try:
        kind = path.stat().st_mode
        if stat.S_ISDIR(kind):
            raise IsADirectoryError(f"{shown} is not a file but a folder")
        if not stat.S_ISREG(kind):
            raise MeshFileError(f"{shown} is not a file but a device or a pipe; use - to read from standard input")
        with path.open("rb") as file:
            start = file.read(1024)
    except FileNotFoundError:
        raise FileNotFoundError(f"{shown} does not exist") from None
    except (IsADirectoryError, MeshFileError):
        raise
    except (OSError, ValueError) as error:
        raise MeshFileError(f"{shown} cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if not start:
        raise MeshFileError(f"{shown} cannot be read: the file is empty")
    return start


def _copy(stream: BinaryIO, target: Path) -> None:
    with target.open("wb") as file:
        while piece := stream.read(_PIECE):
            file.write(piece)


def _unpack(packed: BinaryIO, target: Path) -> None:
    """Unpacks a .gz file, which must not grow beyond reason."""
    most = max(_MOST_UNPACKED, _MOST_GROWTH * os.fstat(packed.fileno()).st_size)
    size = 0
    try:
        with gzip.open(packed) as content, target.open("wb") as file:
            while piece := content.read(_PIECE):
                size += len(piece)
                if size > most:
                    raise DamageError("gzip", f"it unpacks to more than {most:,} bytes", "unpack it by hand")
                file.write(piece)
    except (EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise DamageError(
            "gzip", f"it cannot be unpacked ({str(error).rstrip('.')})", "it is cut off or damaged"
        ) from None


def _extension(name: str) -> str:
    return Path(name).suffix.lower().lstrip(".")


def _is_plain_name(path: Path) -> bool:
    """Whether libraries below Python find a file of this name in every locale."""
    return str(path).isascii() and str(path).isprintable()


def _format_of(start: bytes, size: int) -> str:
    """The format by the content; empty where it is none that is known by sight."""
    text = start.removeprefix(b"\xef\xbb\xbf").lstrip()
    for signature, found in ((b"ply", "ply"), (b"glTF", "glb"), (b"PK\3\4", "3mf")):
        if start.removeprefix(b"\xef\xbb\xbf").startswith(signature):
            return found
    if size >= 84 and len(start) >= 84 and size == 84 + 50 * int.from_bytes(start[80:84], "little"):
        return "stl"
    if re.match(rb"(ST)?C?N?4?n?OFF\b", text):
        return "off"
    if re.match(rb"solid\b", text, re.I):
        return "stl"
    if re.search(rb"(?m)^\s*(v|f)\s+[-+\d.]", text):
        return "obj"
    return ""
