# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a format has enough digits for a mesh, which may lie far from the origin."""

import numpy as np

from .errors import MeshFileError, printable
from .mesh_data import Floats
from .output_formats import OutputFormat

TOLERABLE_SHIFT = 1e-5
"""Part of the diagonal of the bounding box by which writing may move a vertex: a hundredth of an edge of a mesh of a
million faces."""


def check_digits(row: OutputFormat, vertices: Floats, shown: object) -> None:
    """Refuses a format that would move vertices when it rounds their coordinates.

    Raises:
        MeshFileError: names the file and what helps.
    """
    if not len(vertices):
        return
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    shift = float(np.abs(vertices).max()) * row.relative_error + row.absolute_error
    if shift <= TOLERABLE_SHIFT * diagonal:
        return
    where = "(" + ", ".join(f"{value:.6g}" for value in (low + high) / 2) + ")"
    raise MeshFileError(
        f"{printable(shown)} cannot be written: .{row.extension} has too few digits for a mesh of size {diagonal:.3g} "
        f"around {where}; write PLY, or move the mesh to the origin first"
    )
