# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From where two surfaces are seen, in the picture and at first on the page: both from the same place."""

from dataclasses import dataclass

import numpy as np

from ..comparison.surface import Surface
from ..huge.array_file import Array

_THREE_QUARTERS = np.array([1.0, -1.35, 1.05])  # from the right, the front and above, with z up
_LEAST_SHARE = 0.3
_MOST_POINTS = 200_000


@dataclass(frozen=True, eq=False)
class View:
    """A parallel projection in which 1 is the diagonal of the box around both, and the origin its center."""

    center: Array
    scale: float
    """1 / the diagonal."""
    direction: Array
    """To who looks."""
    up: Array
    middle: Array
    """What is in the middle of the picture, in that unit."""
    width: float
    """Of what is seen, in that unit."""
    height: float

    def placed(self, positions: Array) -> Array:
        """Positions in that unit."""
        return (positions - self.center) * self.scale


def view_of(before: Surface, after: Surface) -> View:
    """A three-quarter view with z up, turned to where the box shows most: to the face of a plate that stands upright,
    from above on one that lies."""
    low = np.minimum(before.box[0], after.box[0])
    high = np.maximum(before.box[1], after.box[1])
    size = high - low
    diagonal = float(np.linalg.norm(size)) or 1.0
    thickness = np.maximum(size / diagonal, 1e-3)
    shares = (1 / thickness) ** 0.5  # the sides of a box have areas like 1 / its thickness there
    direction = _THREE_QUARTERS * np.maximum(shares / shares.max(), _LEAST_SHARE)
    direction /= np.linalg.norm(direction)
    right = np.cross([0.0, 0.0, 1.0], direction)
    right /= np.linalg.norm(right)
    up = np.cross(direction, right)
    center, scale = (low + high) / 2, 1 / diagonal
    seen = [(_some(surface) - center) * scale @ np.stack([right, up], axis=1) for surface in (before, after)]
    lowest, highest = np.concatenate(seen).min(axis=0), np.concatenate(seen).max(axis=0)
    middle = (lowest + highest) / 2
    width, height = np.maximum(highest - lowest, 1e-3)
    return View(center, scale, direction, up, middle[0] * right + middle[1] * up, float(width), float(height))


def _some(surface: Surface) -> Array:
    return surface.positions[:: max(1, len(surface.positions) // _MOST_POINTS)]
