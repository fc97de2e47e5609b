# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances between the mesh before and the result, in both directions and one block of either at a time."""

from pathlib import Path
from typing import Any

import numpy as np

from . import surface_library
from .array_file import ArrayFile, save_arrays
from .gather import Part, gather
from .samples import spread


def sample_result(folder: Path, block: str, density: float, file: str) -> dict[str, Any]:
    """Writes points of a block of the result, each with the area that it stands for."""
    source = ArrayFile(folder / block)
    positions, triangles = source.read("positions"), source.read("triangles")
    points, area = spread(positions, triangles, max(1, round(density * len(triangles))))
    written = save_arrays(
        folder / file, {"points": points, "weights": np.full(len(points), area / max(len(points), 1))}
    )
    return {**written, "low": positions.min(axis=0).tolist(), "high": positions.max(axis=0).tolist(), "area": area}


def nearest(
    folder: Path, parts: list[Part], block: str, low: list[float], high: list[float], reach: float, points: str,
    threads: int, shown: str, file: str,
) -> dict[str, Any]:  # fmt: skip
    """Writes how far points near a part of a surface are from it.

    Args:
        folder: of the work.
        parts: of a block before; none where it is one of the result.
        block: that one's file.
        low: corner of the part's box.
        high: the other one.
        reach: points farther from the box are passed over.
        points: file with points and their numbers.
        threads: to use.
        shown: name of the mesh.
        file: to write.
    """
    source = ArrayFile(folder / points)
    positions, numbers = source.read("points"), source.read("numbers")
    near = is_near(positions, low, high, reach)
    positions, numbers = positions[near], numbers[near]
    if parts:
        mesh = gather(folder, parts, shown)
        found = surface_library.distances(mesh.positions, mesh.triangles, positions, threads)
    else:
        result = ArrayFile(folder / block)
        found = surface_library.distances(result.read("positions"), result.read("triangles"), positions, threads)
    return save_arrays(folder / file, {"numbers": numbers, "distances": found})


def is_near(points: Any, low: list[float], high: list[float], reach: float) -> Any:
    """bool: which points are at most so far from a box."""
    away = np.maximum(np.maximum(np.array(low) - points, points - np.array(high)), 0)
    return (away**2).sum(axis=1) <= reach**2
