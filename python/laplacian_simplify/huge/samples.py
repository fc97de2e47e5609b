# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of a block by which surfaces are compared, and what is counted of the mesh before."""

from pathlib import Path
from typing import Any

import numpy as np

from . import surface_library
from .array_file import Array, save_arrays
from .edges import edges_of_block
from .gather import Block

_FEATURE_SHARE = 2  # vertices by which features are compared, a sample


def sample(folder: Path, mesh: Block, fixed: Array, density: float, file: str) -> dict[str, Any]:
    """Writes points of the surface, each with the area that it stands for, and vertices with their descriptor.

    Args:
        folder: of the work.
        mesh: a block.
        fixed: which of its vertices other blocks have, too.
        density: points a face.
        file: to write.
    """
    count = max(1, round(density * len(mesh.triangles)))
    points, area = spread(mesh.positions, mesh.triangles, count)
    edges = edges_of_block(mesh.ids, mesh.positions, mesh.triangles, fixed)
    arrays = {"points": points, "weights": np.full(len(points), area / max(len(points), 1)), **edges.shared}
    arrays |= _features(mesh, fixed, _FEATURE_SHARE * count)
    return {
        **save_arrays(folder / file, arrays),
        "boundary_edges": edges.boundary,
        "non_manifold_edges": edges.non_manifold,
        "low": mesh.positions.min(axis=0).tolist(),
        "high": mesh.positions.max(axis=0).tolist(),
    }


def spread(positions: Array, triangles: Array, count: int) -> tuple[Array, float]:
    """Points spread evenly by area, and the area: stratified along the faces, of low discrepancy within them."""
    a, b, c = (positions[triangles[:, k]].astype(np.float64) for k in range(3))
    up_to = np.cumsum(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)
    if not up_to[-1] > 0:
        return np.empty((0, 3)), 0.0
    face = np.searchsorted(up_to, up_to[-1] * (np.arange(count) + 0.5) / count)
    number = np.arange(1, count + 1)  # the two-dimensional golden ratio sequence
    u, v = np.fmod(number * 0.7548776662466927, 1)[:, None], np.fmod(number * 0.5698402909980532, 1)[:, None]
    outside = u + v > 1
    u, v = np.where(outside, 1 - u, u), np.where(outside, 1 - v, v)
    return (1 - u - v) * a[face] + u * b[face] + v * c[face], float(up_to[-1])


def _features(mesh: Block, fixed: Array, count: int) -> dict[str, Array]:
    """Some vertices, evenly over those whose faces are all here, and the descriptor at them."""
    free = np.flatnonzero(~fixed)
    step = max(len(free) // count, 1)
    picked = free[step // 2 :: step]
    values = surface_library.descriptor(mesh.positions, mesh.triangles)[picked]
    return {"corners": mesh.positions[picked], "descriptor": values}
