# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertices of faces that share none: known by a hash of their coordinates, so equal ones become one without a table."""

from typing import Any

import numpy as np

from ..files.errors import DamageError
from .array_file import Array

# The finalizer of SplitMix64, whose output has no collisions for one word.
_FIRST, _SECOND, _STEP = (np.uint64(n) for n in (0xBF58476D1CE4E5B9, 0x94D049BB133111EB, 0x9E3779B97F4A7C15))


def welded(corners: Array, shown: str) -> tuple[Array, Array, Array]:
    """Ids, positions and faces of triangles that are given by the positions of their corners, three rows a face.

    Raises:
        MeshFileError: two different ones have the same hash.
    """
    corners = corners + corners.dtype.type(0)  # -0 becomes 0
    ids, first, local = np.unique(hashed(corners), return_index=True, return_inverse=True)
    positions = corners[first]
    check_collisions(positions[local], corners, shown)
    return ids, positions, local.reshape(-1, 3).astype(np.uint32)


def hashed(positions: Array) -> Any:
    """63 bits of each position, so that 500 million different ones collide somewhere with a chance of 1.4 %."""
    if positions.dtype.itemsize == 8:
        words = np.ascontiguousarray(positions, "<f8").view("<u8")
        mixed = _mix(_mix(words[:, 0]) ^ (words[:, 1] + _STEP))
        return (_mix(mixed ^ (words[:, 2] + _STEP)) >> np.uint64(1)).astype(np.int64)
    words = np.ascontiguousarray(positions, "<f4").view("<u4").astype(np.uint64)
    mixed = _mix(words[:, 0] | words[:, 1] << np.uint64(32))
    return (_mix(mixed ^ (words[:, 2] + _STEP)) >> np.uint64(1)).astype(np.int64)


def check_collisions(positions: Array, others: Array, shown: str) -> None:
    """Refuses vertices with the same id and different positions.

    Raises:
        MeshFileError: there are some.
    """
    if not np.array_equal(positions, others):
        raise DamageError(
            "",
            "two different vertices have the same hash",
            "convert the file to PLY whose faces share vertices, which numbers them",
        ).named(shown)


def _mix(words: Any) -> Any:
    words = (words ^ (words >> np.uint64(30))) * _FIRST
    words = (words ^ (words >> np.uint64(27))) * _SECOND
    return words ^ (words >> np.uint64(31))
