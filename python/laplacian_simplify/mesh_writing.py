# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files out: the file appears whole, with its companions, or not at all."""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from .native_log import caught_output

if TYPE_CHECKING:
    import pymeshlab

_WITHOUT_SHARED_VERTICES = (".stl",)  # read back, these lose the faces that have no area


def write_mesh(mesh_set: "pymeshlab.MeshSet", path: str | Path, *, source: str | Path | None = None) -> None:
    """Writes the current mesh, whole or not at all; source as for staged_output.

    Raises:
        OSError: it could not be written; the text is one line that names the file and the reason.
    """
    with staged_output(path, source=source) as staged:
        save_checked(mesh_set, staged, shown=path)


@contextmanager
def staged_output(path: str | Path, *, source: str | Path | None = None) -> Iterator[Path]:
    """A path to write to, in a folder beside the output; on success what was written replaces the output.

    Textures and material files that are written beside it go with it. Where the source, the file that the mesh
    came from, lies in the same folder, textures that are there stay: they are the source's own.

    Raises:
        OSError: nothing can be written there.
    """
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        raise IsADirectoryError(f"{path} cannot be written: it exists and is not a file")
    if not target.parent.is_dir():
        raise NotADirectoryError(f"{path} cannot be written: {target.parent} is not a folder")
    try:
        folder = tempfile.TemporaryDirectory(prefix=".laplacian-simplify-", dir=target.parent)
    except OSError as error:
        raise OSError(f"{path} cannot be written: {error.strerror}") from None
    with folder:
        staged = Path(folder.name) / target.name
        yield staged
        try:
            _publish(staged, target, keep=source is not None and _folder(source) == target.parent)
        except OSError as error:
            raise OSError(f"{path} cannot be written: {error.strerror}") from None


def _folder(path: str | Path) -> Path:
    return Path(os.path.realpath(path)).parent


def _publish(staged: Path, target: Path, *, keep: bool) -> None:
    """Moves companions first, so that the mesh never refers to a file that is not there yet."""
    for companion in [file for file in staged.parent.rglob("*") if file.is_file() and file != staged]:
        place = target.parent / companion.relative_to(staged.parent)
        named_after_mesh = companion.name.startswith(target.name)
        if named_after_mesh or not keep or not place.exists():
            place.parent.mkdir(parents=True, exist_ok=True)
            companion.replace(place)
    staged.replace(target)


def check_format(path: Path, *, shown: str | Path) -> None:
    """Refuses, before any work is done, a name whose format pymeshlab cannot write.

    Raises:
        OSError: names shown and the reason.
    """
    import pymeshlab

    probe = pymeshlab.MeshSet()
    probe.create_cube()
    with tempfile.TemporaryDirectory(dir=path.parent) as folder:
        save_checked(probe, Path(folder) / ("probe" + path.suffix), shown=shown)


def save_checked(mesh_set: "pymeshlab.MeshSet", path: Path, *, shown: str | Path) -> None:
    """Saves the current mesh and reads it back: not every loss is noticed while it is written.

    Raises:
        OSError: names shown, which stands for the path, and the reason.
    """
    import pymeshlab

    try:
        with caught_output():
            mesh_set.save_current_mesh(str(path))
    except pymeshlab.PyMeshLabException as error:
        reason = str(error).strip().splitlines()[-1]
        reason = f"the format '{path.suffix}' is unknown" if "Unknown format" in reason else reason
        raise OSError(f"{shown} cannot be written: {reason}") from None
    faces = mesh_set.current_mesh().face_number()
    found = _faces_of(path)
    if found is not None and found != faces and path.suffix.lower() not in _WITHOUT_SHARED_VERTICES:
        raise OSError(f"{shown} cannot be written: the format '{path.suffix}' keeps {found} of {faces} faces")


def _faces_of(path: Path) -> int | None:
    """Faces of a mesh file, nothing where the format can only be written."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    try:
        with caught_output():
            mesh_set.load_new_mesh(str(path))
    except pymeshlab.PyMeshLabException as error:
        if "Unknown format" in str(error):
            return None
        return 0
    return int(mesh_set.current_mesh().face_number())
