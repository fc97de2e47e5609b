# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors of vertices: what they guide in a part of a mesh, and what becomes of them."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from ..attributes import Attributes, Channels
from ..library import MeshArrays, Outcome, run
from ..small import Small
from .array_file import Array

_LEAST_SHARE = 50
_MOST_WEIGHT = 100.0
"""Both as in the engine."""
_PARTS = float(1 << 20)
"""Of the side of the grid's cube, in whose squares areas are counted: whole numbers add up the same in any order."""
_NAME = "color"
_ROWS = 1 << 16


def counted_area(positions: Array, triangles: Array, side: float) -> int:
    """The area of all faces, the same for any division of them into chunks."""
    areas = _areas(positions, triangles, _PARTS / side)
    return sum(int(np.rint(some).astype(np.int64).sum()) for some in areas)


def whole_area(counted: list[int], side: float) -> float:
    """That of all chunks together, in the mesh's own unit."""
    return sum(counted) * (side / _PARTS) ** 2


def expected_face(area: float, target: int, faces: int) -> float:
    """The area of a face of the result, by which the engine knows how far from the surface a color is worth to go."""
    return area / max(target, faces // _LEAST_SHARE, 1)


def weight_in_part(weight: float, face: float, mesh: MeshArrays, target: int) -> float:
    """The attribute weight that means in a part of a mesh what the weight means in the whole.

    The engine takes the length that colors count as from the faces that it expects of the mesh that it is given.

    Args:
        weight: for the whole mesh.
        face: expected_face of the whole mesh; 0: the mesh is the whole.
        mesh: the part.
        target: its faces to keep, as the engine is told.
    """
    if not face > 0:
        return weight
    area = sum(float(areas.sum()) for areas in _areas(mesh.vertices, mesh.faces))
    own = expected_face(area, target, len(mesh.faces))
    return min(weight * float(np.sqrt(face / own)), _MOST_WEIGHT) if own > 0 else weight


def run_with_colors(
    mesh: MeshArrays, colors: Array | None, parameters: Mapping[str, float], *, guide: bool
) -> tuple[Outcome, Array | None]:
    """Runs the engine and returns what colors have become, float32 from 0 to 1.

    Args:
        mesh: without attributes.
        colors: of its vertices, as chunks have them; None: there are none.
        parameters: of library.run.
        guide: colors guide the collapse and are fitted to the result; otherwise vertices keep theirs.
    """
    if colors is None:
        return run(mesh, parameters, None), None
    numbers = np.divide(colors, 255, dtype=np.float64).astype(np.float32) if colors.dtype == np.uint8 else colors
    if not guide:
        outcome = run(mesh, parameters, None)
        return outcome, numbers[outcome.vertex_origin]
    attributes = Attributes(vertex={_NAME: numbers}, kinds={_NAME: "color"})
    channels = Channels(attributes, len(mesh.vertices), len(mesh.faces))
    mesh = replace(
        mesh, corner_values=channels.at_corners(mesh.faces), channel_kinds=np.array(channels.kinds, np.int32)
    )
    outcome = run(mesh, parameters, None)
    values, faces, origin = outcome.corner_values, outcome.faces, outcome.vertex_origin
    if values is not None:  # vertices that were welded may have several colors; the others have one
        old, faces = channels.split(faces, values, len(origin))
        origin = origin[old]
        outcome = replace(outcome, vertices=outcome.vertices[old], faces=faces, vertex_origin=origin)
    results = channels.results(values, origin, outcome.face_origin, Small(outcome.vertices, faces, None))
    return outcome, results["vertex_attributes"][_NAME]


def as_bytes(colors: Array) -> Array:
    """As files have them."""
    numbers: Array = np.rint(255 * np.clip(colors, 0, 1)).astype(np.uint8)
    return numbers


def _areas(positions: Array, triangles: Array, scale: float = 1.0) -> Iterator[Array]:
    """Of all faces of the scaled mesh, some at a time."""
    for begin in range(0, len(triangles), _ROWS):
        corners = triangles[begin : begin + _ROWS]
        a, b, c = (scale * positions[corners[:, k]].astype(np.float64) for k in range(3))
        yield np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
