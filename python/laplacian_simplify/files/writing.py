# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes into files, with what a format cannot hold refused or said."""

import os
import shutil
import subprocess
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..child import Child, ChildCrashError, Stage
from ..turns import forget_failures, plain_path, with_own_folder
from .digits import check_digits
from .errors import DamageError, MeshFileError, printable
from .mesh_data import Texture
from .obj import read_obj
from .off import read_off
from .output_formats import OutputFormat, lost, output_format
from .ply import read_ply
from .reading import MeshFileWarning
from .source import Source
from .staging import check_room, staged_output
from .texture_names import encoded

if TYPE_CHECKING:
    import pymeshlab

_READ_BACK = {"ply": read_ply, "obj": read_obj, "off": read_off}
_SECONDS, _FACES_PER_SECOND = 60, 10_000
_STL_HEADER, _STL_FACET = 84, 50


def write_mesh(
    mesh_set: "pymeshlab.MeshSet", path: str | os.PathLike[str], *, source: str | os.PathLike[str] | None = None
) -> None:
    """Writes the current mesh, whole or not at all; what the format does not keep is a MeshFileWarning.

    Args:
        source: the file that the mesh came from; its textures are left alone where the output lies in its folder.

    Raises:
        OSError: it could not be written; the text is one line that names the file and the reason.
    """
    row = output_format(os.fspath(path))
    with staged_output(path, source=source) as staged:
        notes = save(mesh_set, staged, row, shown=printable(os.fspath(path)))
    for note in notes:
        warnings.warn(f"{os.fspath(path)}: {note}", MeshFileWarning, stacklevel=2)


def save(
    mesh_set: "pymeshlab.MeshSet", path: Path, row: OutputFormat, *, shown: str, textures: Sequence[Texture] = ()
) -> list[str]:
    """Saves the current mesh and reads it back: not every loss is noticed while it is written.

    Args:
        path: in a folder of its own, with a plain name.
        shown: how messages name it.
        textures: images as the input had them, which take the place of those that MeshLab would encode anew.

    Returns:
        What the format did not keep, a sentence each.

    Raises:
        MeshFileError: it could not be written; names shown and the reason.
    """
    mesh = mesh_set.current_mesh()
    vertices = mesh.vertex_matrix()
    check_digits(row, vertices, shown)
    notes = _notes(row, lost(row, mesh))
    expected = mesh.face_number()
    try:
        if row.in_own_process:
            _save_in_own_process(mesh_set, path, row, shown, expected)
        else:
            options = _options_for_obj(mesh) if row.extension == "obj" else {}
            if row.extension == "off" and mesh.has_vertex_color():
                options["save_vertex_normal"] = False  # MeshLab writes both in an order that no reader expects
            with_own_folder(_save, mesh_set, path, options)
    except MeshFileError:
        check_room(path, shown)
        raise
    _restore(path.parent, textures)
    found = _faces_in(path, row, expected)
    if found != expected:
        check_room(path, shown)
        raise MeshFileError(f"{shown} cannot be written: .{row.extension} keeps {found} of {expected} faces")
    return notes


def keeps_polygons(row: OutputFormat, mesh: "pymeshlab.Mesh") -> bool:
    """Whether a mesh of polygons is written as one."""
    return "polygons" in row.keeps and not (row.extension == "obj" and _options_for_obj(mesh))


def _options_for_obj(mesh: "pymeshlab.Mesh") -> dict[str, Any]:
    """MeshLab loses the texture coordinates of polygons and rounds their vertices."""
    if mesh.has_wedge_tex_coord() or not _holds_single_precision(mesh.vertex_matrix()):
        return {"save_polygonal": False}
    return {}


def _notes(row: OutputFormat, names: list[str]) -> list[str]:
    if not names:
        return []
    return [f".{row.extension} does not keep {', '.join(names)}; PLY keeps all"]


def _holds_single_precision(vertices: Any) -> bool:
    try:
        check_digits(output_format("x.stl"), vertices, "")
    except MeshFileError:
        return False
    return True


def _save(mesh_set: "pymeshlab.MeshSet", path: Path, options: dict[str, Any]) -> None:
    import pymeshlab

    forget_failures()
    if mesh_set.current_mesh().face_number():
        mesh_set.apply_filter("apply_normal_normalization_per_vertex")
    try:
        with plain_path(path) as plain:
            mesh_set.save_current_mesh(plain, **options)
    except pymeshlab.PyMeshLabException as error:
        raise MeshFileError(str(error).strip().splitlines()[-1]) from None


def _restore(folder: Path, textures: Sequence[Texture]) -> None:
    """Puts the images of the input in place of those that MeshLab wrote under the same names."""
    for texture in textures:
        place = folder / encoded(texture.name)
        if not place.is_file():
            continue
        if isinstance(texture.image, bytes):
            place.write_bytes(texture.image)
        else:
            shutil.copyfile(texture.image, place)


def _faces_in(path: Path, row: OutputFormat, expected: int) -> int:
    """Faces of a mesh file that was just written; those expected where the format can only be written."""
    if not path.is_file():
        return 0
    if row.extension == "stl":  # read back, it loses faces without an area
        whole, rest = divmod(path.stat().st_size - _STL_HEADER, _STL_FACET)
        return whole if rest == 0 else 0
    read = _READ_BACK.get(row.extension)
    if read is None:
        return expected
    try:
        data = read(Source(path.name, path, path.parent, path.parent, row.extension))
    except DamageError:
        return 0
    return len(data.triangles) if data else 0


def _save_in_own_process(mesh_set: "pymeshlab.MeshSet", path: Path, row: OutputFormat, shown: str, faces: int) -> None:
    """Hands the mesh, as PLY, to a process that writes it in another format."""
    interim = path.with_name("interim.ply")
    with_own_folder(_save, mesh_set, interim, {"save_vertex_normal": True})
    seconds = _SECONDS + faces // _FACES_PER_SECOND
    try:
        child = Child("files.writing:convert", {"source": str(interim), "target": str(path), "faces": faces})
        child.answer(timeout=seconds)
    except (ChildCrashError, subprocess.TimeoutExpired) as crash:
        reason = (
            f"crashed ({crash.cause})" if isinstance(crash, ChildCrashError) else f"did not end in {seconds} seconds"
        )
        raise MeshFileError(
            f"{shown} cannot be written: MeshLab's writer of .{row.extension} {reason}; write PLY"
        ) from None
    except (OSError, RuntimeError, ValueError) as error:
        raise MeshFileError(f"{shown} cannot be written: {error}") from None
    finally:
        interim.unlink(missing_ok=True)


def convert(_stage: Stage, *, source: str, target: str, faces: int) -> None:
    """What the process does: reads PLY, writes another format and reads that back where MeshLab can."""
    import pymeshlab

    mesh_set, again = pymeshlab.MeshSet(), pymeshlab.MeshSet()
    with plain_path(Path(source)) as plain:
        mesh_set.load_new_mesh(plain)
    box = mesh_set.current_mesh().bounding_box()
    try:
        with plain_path(Path(target)) as plain:
            mesh_set.save_current_mesh(plain)
    except pymeshlab.PyMeshLabException as error:
        raise OSError(str(error).strip().splitlines()[-1]) from None
    if not Path(target).is_file() or not Path(target).stat().st_size:
        raise OSError("MeshLab wrote nothing")
    try:
        with plain_path(Path(target)) as plain:
            again.load_new_mesh(plain)
    except pymeshlab.PyMeshLabException as error:
        if "Unknown format" in str(error):
            return
        raise OSError("MeshLab cannot read what it wrote") from None
    found = sum(mesh.face_number() for mesh in again)
    if found != faces:
        raise OSError(f"{Path(target).suffix} keeps {found} of {faces} faces")
    moved = max(abs(a - b) for a, b in zip(_corners(box), _corners(again.current_mesh().bounding_box()), strict=True))
    if again.mesh_number() == 1 and moved > 1e-3 * box.diagonal():
        raise OSError(f"{Path(target).suffix} moves the mesh by {moved:.3g}; move it to the origin first, or write PLY")


def _corners(box: Any) -> list[float]:
    return [*box.min(), *box.max()]
