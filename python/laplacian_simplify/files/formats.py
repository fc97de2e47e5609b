# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which reader serves which format, and why."""

from collections.abc import Callable
from dataclasses import dataclass

from .errors import MeshFileError
from .gltf import read_gltf
from .mesh_data import MeshData
from .obj import read_obj
from .off import read_off
from .others import MESHLAB_READS, read_by_meshlab
from .ply import read_ply
from .source import Source
from .stl import read_stl
from .threemf import read_3mf


@dataclass(frozen=True)
class Reader:
    """A row of the table."""

    extensions: tuple[str, ...]
    read: Callable[[Source], MeshData | None]
    """Nothing where MeshLab's own reader is to be asked."""
    why: str
    """Why not MeshLab's own reader, or a library's."""


READERS = (
    Reader(
        ("ply",),
        read_ply,
        "MeshLab's reader knows 13 of the 48 pairs of list types and reads others beyond its memory; plyfile takes "
        "seconds for a million faces in text. Little-endian triangles, the usual case, are checked here and then "
        "read by MeshLab from the file itself.",
    ),
    Reader(
        ("stl",),
        read_stl,
        "MeshLab's reader never ends on a text with CR line ends, takes a file that is cut off as it is, rounds text "
        "to seven digits and needs twelve seconds to join the vertices of a million facets.",
    ),
    Reader(
        ("obj",),
        read_obj,
        "MeshLab's reader crashes on a wrong index, takes decimal commas for the end of a number and depends on the "
        "locale; trimesh takes index 0 for the last vertex; both lose textures with a blank in their name.",
    ),
    Reader(
        ("off",),
        read_off,
        "MeshLab's reader puts every polygon of five corners or more onto the first vertices of the file, and "
        "crashes on a wrong index.",
    ),
    Reader(
        ("glb", "gltf"),
        read_gltf,
        "MeshLab's reader leaves the transformations of nodes out of the coordinates; trimesh reads sparse and "
        "compressed numbers as zeros and needs Pillow for textures.",
    ),
    Reader(
        ("3mf",),
        read_3mf,
        "MeshLab's reader makes a layer of every object; trimesh needs lxml and networkx for it and passes over "
        "objects that are missing.",
    ),
    Reader(
        MESHLAB_READS,
        read_by_meshlab,
        "MeshLab's own readers, in a process of their own with bounds on memory and time: nothing else reads these.",
    ),
)


def reader_of(source: Source) -> Reader:
    """The row for a file.

    Raises:
        MeshFileError: no row has its extension.
    """
    for reader in READERS:
        if source.format in reader.extensions:
            return reader
    known = ", ".join(extension for reader in READERS for extension in reader.extensions)
    raise MeshFileError(f"{source.shown} cannot be read: the format '.{source.format}' is unknown; known are {known}")
