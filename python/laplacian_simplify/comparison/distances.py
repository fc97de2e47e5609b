# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances between two surfaces in both directions.

Each direction is measured at points spread evenly by area and at all vertices on faces. The distance of a point is that
to the closest point of the other surface, in double precision, so what sampling leaves open is what lies between the
points. A distance changes by no more than the way to the next point.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..huge.array_file import Array
from ..huge.samples import spread
from ..huge.surface_library import descriptor, distances
from .arguments import SAMPLES
from .surface import Surface

_FEATURE_SHARE = 0.1
"""Of the vertices, those with the largest descriptor, as in the reports of simplify."""


@dataclass(frozen=True, eq=False)
class OneWay:
    """From one surface to the other, in the unit of the coordinates."""

    at_points: Array
    """At points that stand for the same area each; none where the surface has no area."""
    at_corners: Array
    """At the vertices on faces."""
    area: float

    @property
    def largest(self) -> float:
        return float(max(self.at_points.max(initial=0), self.at_corners.max(initial=0)))

    @property
    def mean(self) -> float:
        return float(self.at_points.mean()) if len(self.at_points) else 0.0

    @cached_property
    def mean_square(self) -> float:
        return float((self.at_points**2).mean()) if len(self.at_points) else 0.0

    @property
    def square_error(self) -> float:
        """Standard error of the mean square, if the points were random; these are spread more evenly than that."""
        return float((self.at_points**2).std() / np.sqrt(len(self.at_points))) if len(self.at_points) else 0.0

    @property
    def spacing(self) -> float:
        """Edge of the square that a point stands for."""
        return float(np.sqrt(self.area / len(self.at_points))) if len(self.at_points) else 0.0


@dataclass(frozen=True, eq=False)
class Distances:
    """In both directions."""

    forward: OneWay
    backward: OneWay
    feature_rms: float | None
    """Of the first surface, at the tenth of its vertices with the largest descriptor; None where it is flat."""

    @property
    def largest(self) -> float:
        return max(self.forward.largest, self.backward.largest)

    @property
    def rms(self) -> float:
        return float(np.sqrt((self.forward.mean_square + self.backward.mean_square) / 2))

    @property
    def rms_error(self) -> float:
        """By how much sampling may have changed the rms."""
        if not self.rms > 0:
            return 0.0
        return float(np.hypot(self.forward.square_error, self.backward.square_error) / 2 / (2 * self.rms))

    @property
    def spacing(self) -> float:
        return max(self.forward.spacing, self.backward.spacing)


def measure(a: Surface, b: Surface, samples: int = SAMPLES, threads: int = 0) -> Distances:
    """Measures from a to b and back.

    Args:
        a: the first surface.
        b: the other one.
        samples: points a side, beside the vertices.
        threads: 0 all; the result does not depend on it.

    Raises:
        MemoryError: there is not enough memory.
    """
    forward = _one_way(a, b, samples, threads)
    return Distances(forward, _one_way(b, a, samples, threads), _feature_rms(a, forward.at_corners))


def _one_way(of: Surface, to: Surface, samples: int, threads: int) -> OneWay:
    points, area = spread(of.positions, of.faces, samples)
    return OneWay(
        distances(to.positions, to.faces, points, threads),
        distances(to.positions, to.faces, of.positions, threads),
        area,
    )


def _feature_rms(a: Surface, at_corners: Array) -> float | None:
    values = descriptor(a.positions, a.faces)
    if not values.max(initial=0) > 0:
        return None
    count = -(-len(values) * _FEATURE_SHARE // 1)
    features = np.argsort(-values, kind="stable")[: int(count)]
    return float(np.sqrt((at_corners[features] ** 2).mean()))
