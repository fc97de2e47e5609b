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
MAX_ERRORS_HELP = (
    "in place of percents: each level is as small as it can be within this error, as of --max-error: "
    "0.1%,0.5% are parts of the bounding box's diagonal, 0.05,0.2 lengths in the mesh's units"
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


def error_bounds(text: str) -> list[dict[str, float]]:
    """The bounds of several levels.

    Raises:
        ValueError: some are neither; the text names the first.
    """
    bounds = []
    for word in text.split(","):
        try:
            bounds.append(error_bound(word.strip()))
        except ValueError:
            raise ValueError(
                f'max_errors = "{text}": "{word.strip()}" is neither a length nor, as 0.1%, a part'
            ) from None
    return bounds


def in_percent(values: dict[str, Any], mesh_set: "pymeshlab.MeshSet") -> dict[str, Any]:
    """The values with a length as percent of the diagonal of the box around the current mesh's faces.

    Raises:
        ValueError: the length is no positive number, or larger than the diagonal.
    """
    values = dict(values)
    bounds = values.get("max_errors")
    if isinstance(bounds, list):
        values["max_errors"] = [in_percent(bound, mesh_set)["max_error"] for bound in bounds]
    if LENGTH not in values:
        return values
    length = values.pop(LENGTH)
    mesh = mesh_set.current_mesh()
    corners = mesh.vertex_matrix()[np.unique(mesh.face_matrix())]
    diagonal = float(np.linalg.norm(np.ptp(corners, axis=0))) if len(corners) else 0.0
    if not 0 < length <= diagonal:
        raise ValueError(f"max_error = {length:g} is outside (0, {diagonal:g}] (the diagonal of the bounding box)")
    return values | {"max_error": 100 * length / diagonal}
