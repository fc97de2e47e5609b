# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats that only MeshLab reads: in a process of their own, which may crash, and within bounds, which it may hit."""

import contextlib
import resource
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from ..child import Child, ChildCrashError, Stage
from ..plugin import require_pymeshlab
from ..turns import plain_path
from .errors import DamageError
from .mesh_data import MeshData
from .source import Source

MESHLAB_READS = (
    "3ds", "apts", "asc", "bre", "ctm", "dae", "e57", "fbx", "nxs", "nxz", "pdb", "pts", "ptx", "qobj", "tri",
    "txt", "vmi", "wrl", "x3d", "x3dv", "xyz",
)  # fmt: skip

_SECONDS, _SECONDS_PER_MEGABYTE = 10, 1
_MEGABYTES, _MEGABYTES_PER_MEGABYTE = 1000, 100
_MEGABYTE = 1 << 20


def read_by_meshlab(source: Source) -> MeshData:
    """Reads a file with MeshLab's own reader.

    Raises:
        DamageError: what MeshLab says, or that it crashed or did not end.
        ImportError: pymeshlab is not installed.
    """
    from .ply import read_ply

    require_pymeshlab()
    size = source.path.stat().st_size // _MEGABYTE + 1
    path = source.path
    if not source.is_the_file_itself or path.suffix.lower() != "." + source.format:
        path = source.scratch / f"input.{source.format}"
        path.symlink_to(source.path)
    folder = source.scratch / "by_meshlab"
    folder.mkdir()
    seconds = _SECONDS + _SECONDS_PER_MEGABYTE * size
    arguments = {
        "path": str(path),
        "folder": str(folder),
        "seconds": seconds,
        "memory": (_MEGABYTES + _MEGABYTES_PER_MEGABYTE * size) * _MEGABYTE,
    }
    child = Child("files.others:convert", arguments)
    try:
        layers = child.answer(timeout=6 * seconds)
    except ChildCrashError as crash:
        what = "did not end" if crash.cause == "SIGXCPU" else f"crashed ({crash.cause})"
        raise _meshlab(source, what) from None
    except subprocess.TimeoutExpired:
        raise _meshlab(source, "did not end") from None
    except MemoryError:
        raise _meshlab(source, "needs more memory than a file of this size can be worth") from None
    except (OSError, RuntimeError, ValueError) as error:
        raise DamageError("", str(error)) from None
    if layers != 1:
        raise DamageError("", f"it holds {layers} meshes instead of one", "merge them first")
    (folder / "dummy.png").unlink(missing_ok=True)  # MeshLab puts it in place of textures that it does not find
    data = read_ply(Source(source.shown, folder / "mesh.ply", folder, folder, "ply"))
    assert data is not None
    data.notes = [note.replace("texture 'dummy.png'", "a texture that it refers to") for note in data.notes]
    data.as_it_stands = False
    return data


def _meshlab(source: Source, what: str) -> DamageError:
    return DamageError("", f"MeshLab's reader of .{source.format} {what}", "the file is damaged, or convert it to PLY")


def convert(_stage: Stage, *, path: str, folder: str, seconds: int, memory: int) -> int:
    """What the process does: writes the mesh as PLY into the folder and returns the number of meshes in the file."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        taken = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (taken + memory, taken + memory))
    try:
        with plain_path(Path(path)) as plain:
            mesh_set.load_new_mesh(plain)
    except pymeshlab.PyMeshLabException as error:
        raise OSError(_reason(error)) from None
    if mesh_set.mesh_number() == 1:
        _freeze(mesh_set)
        with plain_path(Path(folder) / "mesh.ply") as plain:
            mesh_set.save_current_mesh(plain, save_vertex_normal=True)
    return int(mesh_set.mesh_number())


def _freeze(mesh_set: Any) -> None:
    """Some readers keep where a mesh stands as a matrix of its own."""
    if not np.array_equal(mesh_set.current_mesh().transform_matrix(), np.eye(4)):
        mesh_set.apply_filter("apply_matrix_freeze")


def _reason(error: Exception) -> str:
    """The last sentence of what pymeshlab says, on one line."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    reason = lines[-1] if lines else "unknown reason"
    return reason.removeprefix("Error details: ").rstrip(".")
