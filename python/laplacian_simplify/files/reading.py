# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files in."""

import os
import struct
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ..plugin import require_pymeshlab
from .errors import DamageError
from .formats import reader_of
from .handover import to_mesh_set
from .mesh_data import MeshData, Texture, clear_doubtful_diagonals, drop_degenerate
from .others import read_by_meshlab
from .source import Source, open_source

if TYPE_CHECKING:
    import pymeshlab

# What damage may end in beneath the checks of a reader.
_SURPRISES = (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError, struct.error)


class MeshFileWarning(UserWarning):
    """Something of a file could not be taken over."""


@dataclass
class Reading:
    """What a file was read into."""

    mesh_set: "pymeshlab.MeshSet"
    notes: list[str]
    """What could not be taken over, a sentence each."""
    textures: list[Texture]
    has_polygons: bool


def read_mesh(path: str | os.PathLike[str]) -> "pymeshlab.MeshSet":
    """A new mesh set with the mesh of the file as its only mesh; what is left out is a MeshFileWarning.

    Raises:
        OSError: the file is missing, damaged, of an unknown format or holds coordinates that are not finite; the text
            is one line that names the file, the place and the reason.
        ImportError: pymeshlab is not installed.
    """
    reading = read(path)
    for note in reading.notes:
        warnings.warn(f"{os.fspath(path)}: {note}", MeshFileWarning, stacklevel=2)
    return reading.mesh_set


def read_data(path: str | os.PathLike[str]) -> MeshData:
    """The mesh of a file as arrays; pymeshlab is needed only for the formats that MeshLab alone reads.

    Raises:
        OSError, ImportError: as read_mesh.
    """
    with open_source(path) as source:
        return _checked(source)


def read(path: str | os.PathLike[str]) -> Reading:
    """As read_mesh, with notes in place of warnings."""
    require_pymeshlab()
    with open_source(path) as source:
        data = _checked(source)
        mesh_set = to_mesh_set(data, source)
        has_polygons = data.faux is not None and bool(data.faux.any())
        return Reading(mesh_set, data.notes, [_lasting(texture, source) for texture in data.textures], has_polygons)


def _lasting(texture: Texture, source: Source) -> Texture:
    """A texture that is still there when the scratch folder is gone."""
    if isinstance(texture.image, Path) and texture.image.is_relative_to(os.path.realpath(source.scratch)):
        return Texture(texture.name, texture.image.read_bytes())
    return texture


def _checked(source: Source) -> MeshData:
    try:
        data = reader_of(source).read(source) or read_by_meshlab(source)
    except _SURPRISES as error:
        text = " ".join(str(error).split())[:200]
        raise DamageError("", f"it is damaged ({type(error).__name__}: {text})") from error
    except MemoryError:
        raise DamageError("", "there is not enough memory for it") from None
    drop_degenerate(data)
    clear_doubtful_diagonals(data)
    return data
