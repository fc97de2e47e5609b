# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error bound as the command takes it: in percent of the diagonal, or as a length in the mesh's own units."""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import pymeshlab

MAX_ERROR_HELP = (
    "no point of either surface is farther than this from the other, which is proven: 0.1% is a part of the bounding "
    "box's diagonal, 0.05 a length in the mesh's units; with a target, whichever comes first"
)
LENGTH = "max_error_length"
"""Key of a bound that is a length, before the mesh is known."""


def error_bound(text: str) -> dict[str, float]:
    """The parameter, or the length that it is to be made of.

    Raises:
        ValueError: the text is neither.
    """
    number = float(text.removesuffix("%"))
    return {"max_error" if text.endswith("%") else LENGTH: number}


def in_percent(values: dict[str, Any], mesh_set: "pymeshlab.MeshSet") -> dict[str, Any]:
    """The values with a length as percent of the diagonal of the box around the current mesh's faces.

    Raises:
        ValueError: the length is no positive number, or larger than the diagonal.
    """
    values = dict(values)
    if LENGTH not in values:
        return values
    length = values.pop(LENGTH)
    mesh = mesh_set.current_mesh()
    corners = mesh.vertex_matrix()[np.unique(mesh.face_matrix())]
    diagonal = float(np.linalg.norm(np.ptp(corners, axis=0))) if len(corners) else 0.0
    if not 0 < length <= diagonal:
        raise ValueError(f"max_error = {length:g} is outside (0, {diagonal:g}] (the diagonal of the bounding box)")
    return values | {"max_error": 100 * length / diagonal}
