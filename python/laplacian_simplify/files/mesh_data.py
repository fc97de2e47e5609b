# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as arrays: what every reader makes, and the checks that all of them share."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted

Floats = NDArray[np.float64]
Integers = NDArray[np.integer[Any]]
Colors = NDArray[np.uint8]

LARGEST_COORDINATE = 1e18
"""Beyond it squares of coordinates overflow in single precision; the filters refuse the same."""


@dataclass
class Texture:
    """An image that faces refer to."""

    name: str
    """As the mesh file has it."""
    image: Path | bytes
    """Where the image is, or the image itself."""


@dataclass
class MeshData:
    """Triangles with what hangs on them; arrays that a file has nothing for are None."""

    vertices: Floats
    triangles: Integers
    faux: NDArray[np.uint8] | None = None
    """Bit k: edge k is a diagonal of the polygon that the triangle is a part of."""
    vertex_normals: Floats | None = None
    vertex_colors: Colors | None = None
    vertex_quality: Floats | None = None
    vertex_uv: Floats | None = None
    face_colors: Colors | None = None
    face_quality: Floats | None = None
    wedge_uv: Floats | None = None
    """Three pairs for every triangle."""
    texture_of_face: Integers | None = None
    textures: list[Texture] = field(default_factory=list)
    as_it_stands: bool = False
    """MeshLab's own reader may take the file itself."""
    notes: list[str] = field(default_factory=list)
    """What the user should know: parts of the file that were left out."""

    def select_faces(self, keep: NDArray[np.bool_]) -> None:
        """Leaves out the other faces."""
        self.as_it_stands = False
        for name in ("triangles", "faux", "face_colors", "face_quality", "wedge_uv", "texture_of_face"):
            values = getattr(self, name)
            if values is not None:
                setattr(self, name, values[keep])


def check_finite(vertices: Floats) -> None:
    """Refuses coordinates that are not finite numbers of a usable size."""
    if not len(vertices) or np.abs(vertices).max() <= LARGEST_COORDINATE:  # NaN is not
        return
    with np.errstate(invalid="ignore"):
        usable = np.abs(vertices).max(axis=1, initial=0) <= LARGEST_COORDINATE
    bad = len(vertices) - int(np.count_nonzero(usable))
    raise DamageError(
        f"vertex {int(np.argmin(usable))}",
        f"{counted(bad, 'vertex', 'vertices')} with coordinates that are not finite numbers up to 1e18",
    )


def check_indices(indices: Integers, vertices: int, face_of_index: Integers | int) -> None:
    """Refuses indices outside 0..vertices-1.

    Args:
        face_of_index: the face that every index belongs to, or the number of corners that all faces have.
    """
    if not len(indices):
        return
    if indices.min() >= 0 and indices.max() < vertices:
        return
    at = int(np.argmax((indices < 0) | (indices >= vertices)))
    face = at // face_of_index if isinstance(face_of_index, int) else int(face_of_index[at])
    allowed = f"0..{vertices - 1}" if vertices else "nothing: there are no vertices"
    raise DamageError(f"face {face}", f"vertex index {int(indices[at])} is outside {allowed}")


def drop_degenerate(data: MeshData) -> None:
    """Leaves out triangles with the same vertex at two corners, as MeshLab does when it has read a file."""
    a, b, c = data.triangles.T
    sound = (a != b) & (b != c) & (c != a)
    dropped = len(sound) - int(np.count_nonzero(sound))
    if dropped:
        data.select_faces(sound)
        data.notes.append(f"{counted(dropped, 'face')} with the same vertex at two corners left out")


def clear_doubtful_diagonals(data: MeshData) -> None:
    """Leaves diagonals only where exactly two triangles, which run through them in opposite directions, have them.

    Around what is left, parts of polygons without a vertex twice, MeshLab's writers find their way.
    """
    if data.faux is None or not data.faux.any():
        return
    start, end = data.triangles.reshape(-1), np.roll(data.triangles, -1, axis=1).reshape(-1)
    is_faux = ((data.faux[:, None] >> np.arange(3)) & 1).reshape(-1).astype(bool)
    edge = np.minimum(start, end) * len(data.vertices) + np.maximum(start, end)
    order = np.argsort(edge, kind="stable")
    edge, forward, of_polygon = edge[order], (start < end)[order], is_faux[order]
    first = np.flatnonzero(np.concatenate([[True], edge[1:] != edge[:-1]]))
    pair = first[np.diff(first, append=len(edge)) == 2]
    pair = pair[(forward[pair] != forward[pair + 1]) & of_polygon[pair] & of_polygon[pair + 1]]
    kept = np.zeros(len(edge), dtype=bool)
    kept[order[pair]] = kept[order[pair + 1]] = True
    data.faux = (kept.reshape(-1, 3) << np.arange(3)).sum(axis=1).astype(np.uint8)
