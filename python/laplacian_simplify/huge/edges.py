# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary and non-manifold edges of a mesh in blocks: within one at once, between them by the ids of their ends."""

from dataclasses import dataclass

import numpy as np

from . import surface_library
from .array_file import Array


@dataclass(frozen=True, eq=False)
class EdgeCounts:
    """Of one block."""

    boundary: int
    """Edges that no other block has."""
    non_manifold: int
    shared: dict[str, Array]
    """Edges between vertices that others may have, too: their ids, and faces of this block."""


def edges_of_block(ids: Array, positions: Array, triangles: Array, fixed: Array) -> EdgeCounts:
    """Counts the edges of a block whose fixed vertices are those of others, too."""
    boundary, non_manifold = surface_library.edges(positions, triangles, fixed)
    at_seams = triangles[fixed[triangles].sum(axis=1, dtype=np.uint8) >= 2]
    pairs = np.concatenate([at_seams[:, [k, (k + 1) % 3]] for k in range(3)])
    pairs = pairs[fixed[pairs].all(axis=1)].astype(np.int64)
    keys, counts = np.unique(pairs.min(axis=1) << 32 | pairs.max(axis=1), return_counts=True)
    ends = np.stack([ids[keys >> 32], ids[keys & 0xFFFFFFFF]], axis=1)
    return EdgeCounts(boundary, non_manifold, {"edge_ends": ends, "edge_faces": counts.astype(np.int64)})


def edges_between_blocks(ends: list[Array], faces: list[Array]) -> tuple[int, int]:
    """Boundary and non-manifold edges among those that several blocks may have; ids ascend within each end."""
    all_ends = np.concatenate([np.empty((0, 2), np.int64), *ends])
    all_faces = np.concatenate([np.empty(0, np.int64), *faces])
    if len(all_ends) == 0:
        return 0, 0
    order = np.lexsort((all_ends[:, 1], all_ends[:, 0]))
    begins = np.append(True, (all_ends[order[1:]] != all_ends[order[:-1]]).any(axis=1))
    sums = np.add.reduceat(all_faces[order], np.flatnonzero(begins))
    return int(np.count_nonzero(sums == 1)), int(np.count_nonzero(sums > 2))
