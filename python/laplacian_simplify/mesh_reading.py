# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files in, with the faults that pymeshlab passes over in silence named."""

import re
from collections.abc import Iterator
from functools import cache
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from .native_log import caught_output

if TYPE_CHECKING:
    import pymeshlab

_NOT_FINITE = re.compile(r"mesh contains (\d+) vertices with NAN coords")


def read_mesh(path: str | Path) -> "pymeshlab.MeshSet":
    """A new mesh set with the mesh of the file as its only mesh.

    Raises:
        OSError: the file is missing, damaged, of an unknown format, holds several meshes or coordinates that are
            not finite; the text is one line that names the file and the reason.
    """
    import pymeshlab

    path = Path(path)
    _check_file(path)
    mesh_set = pymeshlab.MeshSet()
    mesh_set.set_verbosity(True)  # then what it repairs in silence is in its log
    try:
        with caught_output() as log:
            _lasting_mesh_set().apply_filter("get_geometric_measures")
            mesh_set.load_new_mesh(str(path.absolute()))
    except (pymeshlab.PyMeshLabException, RuntimeError, ValueError, MemoryError) as error:
        raise OSError(f"{path} cannot be read: {_reason(error)}") from None
    finally:
        mesh_set.set_verbosity(False)
    not_finite = _NOT_FINITE.search(log.text)
    if not_finite and int(not_finite[1]) > 0:
        raise OSError(f"{path} cannot be used: {_count(int(not_finite[1]))} with coordinates that are not finite")
    if path.suffix.lower() == ".obj":
        _check_obj(path, mesh_set.current_mesh().face_number())
    if mesh_set.mesh_number() != 1:
        raise OSError(f"{path} cannot be used: it holds {mesh_set.mesh_number()} meshes instead of one")
    return mesh_set


@cache
def _lasting_mesh_set() -> "pymeshlab.MeshSet":
    """A mesh set that is never destroyed.

    While pymeshlab reads, it writes into the log of the mesh set that ran a filter last, even if that one is
    gone; after a filter on this one the log is there.
    """
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.create_cube()
    return mesh_set


def _check_file(path: Path) -> None:
    if not path.exists():
        raise FileNotFoundError(f"{path} does not exist")
    if not path.is_file():
        raise IsADirectoryError(f"{path} is not a file")
    with path.open("rb") as file:  # also finds out whether it may be read
        if not file.read(1):
            raise OSError(f"{path} cannot be read: the file is empty")
    if path.suffix.lower() == ".off":
        _check_off(path)


def _check_off(path: Path) -> None:
    """Counts and indices of an OFF file: pymeshlab invents missing faces and crashes at wrong indices."""
    with path.open("rb") as file:
        if b"BINARY" in file.readline():
            return
        file.seek(0)
        lines = (line.partition(b"#")[0].split() for line in file)
        lines = (line for line in lines if line)
        try:
            first = next(lines)
            counts = first[1:] if len(first) > 1 else next(lines)
            vertices, faces = int(counts[0]), int(counts[1])
            found = sum(len(line) >= 3 for line in islice(lines, vertices))
        except (StopIteration, ValueError, IndexError):
            raise OSError(f"{path} cannot be read: it has no header of an OFF file") from None
        if found < vertices:
            raise OSError(f"{path} cannot be read: the file ends after {found} of {vertices} vertices")
        _check_off_faces(path, lines, vertices, faces)


def _check_off_faces(path: Path, lines: Iterator[list[bytes]], vertices: int, faces: int) -> None:
    found = 0
    for line in islice(lines, faces):
        try:
            corners = [int(index) for index in line[1 : 1 + int(line[0])]]
        except ValueError:
            raise OSError(f"{path} cannot be read: face {found} has an index that is no number") from None
        if len(corners) < int(line[0]):
            break
        if not all(0 <= corner < vertices for corner in corners):
            raise OSError(f"{path} cannot be read: face {found} has a vertex outside 0..{vertices - 1}")
        found += 1
    if found < faces:
        raise OSError(f"{path} cannot be read: the file ends after {found} of {faces} faces")


def _check_obj(path: Path, faces_read: int) -> None:
    """Looks for the reason where faces are missing: pymeshlab drops those with a wrong index without a word."""
    with path.open("rb") as file:
        corners = [line.split()[1:] for line in file if line.startswith(b"f ")]
    if faces_read >= sum(len(face) - 2 for face in corners):
        return
    with path.open("rb") as file:
        vertices = sum(line.startswith((b"v ", b"v\t")) for line in file)
    for face in corners:
        for corner in face:
            index = int(corner.partition(b"/")[0])
            if not 1 <= abs(index) <= vertices:
                raise OSError(f"{path} cannot be read: a face has the vertex {index}, which is outside 1..{vertices}")


def _count(vertices: int) -> str:
    return "1 vertex" if vertices == 1 else f"{vertices} vertices"


def _reason(error: Exception) -> str:
    """The last sentence of what pymeshlab says, on one line and without the path that stands before it anyway."""
    if isinstance(error, MemoryError | ValueError):
        return "it announces more elements than fit into memory"
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    reason = lines[-1] if lines else "unknown reason"
    if reason.startswith("Unknown format"):
        return f"the format '.{reason.split()[-1]}' is unknown"
    return reason.removeprefix("Error details: ").rstrip(".")
