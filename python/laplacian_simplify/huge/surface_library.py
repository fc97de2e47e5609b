# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The C functions that measure, by ctypes; ``python/library/surface_arrays.h`` says what they do."""

import ctypes
from ctypes import c_int32, c_uint64, c_void_p
from functools import cache
from pathlib import Path
from typing import ClassVar

import numpy as np

from .array_file import Array


class _Surface(ctypes.Structure):
    _fields_: ClassVar = [
        ("positions", c_void_p),
        ("faces", c_void_p),
        ("vertex_count", c_uint64),
        ("face_count", c_uint64),
    ]


def distances(positions: Array, faces: Array, points: Array, threads: int) -> Array:
    """Of each point to the surface.

    Args:
        positions: float64, (n, 3).
        faces: uint32, (m, 3), at least one.
        points: float64, (k, 3).
        threads: the result does not depend on it.

    Raises:
        MemoryError: there is not enough memory.
    """
    found = np.empty(len(points))
    points = np.ascontiguousarray(points)
    surface, kept = _surface(positions, faces)
    failed = _library().laplacian_simplify_distances(
        ctypes.byref(surface), points.ctypes.data, len(points), threads, found.ctypes.data
    )
    del kept
    if failed:
        raise MemoryError
    return found


def descriptor(positions: Array, faces: Array) -> Array:
    """The Laplacian descriptor of every vertex; arguments and errors as of distances."""
    values = np.empty(len(positions))
    surface, kept = _surface(positions, faces)
    failed = _library().laplacian_simplify_descriptor(ctypes.byref(surface), 1, values.ctypes.data)
    del kept
    if failed:
        raise MemoryError
    return values


def edges(positions: Array, faces: Array, fixed: Array) -> tuple[int, int]:
    """Boundary and non-manifold edges, but for those between two fixed vertices; errors as of distances."""
    flags = np.ascontiguousarray(fixed, np.uint8)
    counts = c_uint64(), c_uint64()
    surface, kept = _surface(positions, faces)
    failed = _library().laplacian_simplify_edges(
        ctypes.byref(surface), flags.ctypes.data, ctypes.byref(counts[0]), ctypes.byref(counts[1])
    )
    del kept
    if failed:
        raise MemoryError
    return counts[0].value, counts[1].value


def _surface(positions: Array, faces: Array) -> tuple[_Surface, tuple[Array, Array]]:
    """The structure, and the arrays that it points to."""
    kept = np.ascontiguousarray(positions, np.float64), np.ascontiguousarray(faces, np.uint32)
    return _Surface(kept[0].ctypes.data, kept[1].ctypes.data, len(positions), len(faces)), kept


@cache
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(Path(__file__).parents[1] / "liblaplacian_simplify.so"))
    surface = ctypes.POINTER(_Surface)
    library.laplacian_simplify_distances.argtypes = [surface, c_void_p, c_uint64, c_int32, c_void_p]
    library.laplacian_simplify_descriptor.argtypes = [surface, c_int32, c_void_p]
    library.laplacian_simplify_edges.argtypes = [surface, c_void_p, ctypes.POINTER(c_uint64), ctypes.POINTER(c_uint64)]
    return library
