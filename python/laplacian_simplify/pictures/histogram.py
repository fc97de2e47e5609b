# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How often which distance is, as a picture in SVG."""

import math

import numpy as np

from ..comparison.distances import OneWay
from ..huge.array_file import Array

_BINS = 40
_WIDTH, _HEIGHT, _LEFT, _RIGHT, _BOTTOM, _TOP = 640, 230, 52, 24, 40, 10
_DECADES = 4  # of the logarithmic scale, which ends at 100 %


def shares(way: OneWay, limit: float) -> tuple[Array, float]:
    """Percent of the surface in bins of equal width up to a limit, and what is beyond it."""
    count = max(len(way.at_points), 1)
    inside, _ = np.histogram(way.at_points, bins=_BINS, range=(0, limit))
    return 100 * inside / count, 100 * int((way.at_points > limit).sum()) / count


def histogram(forward: OneWay, backward: OneWay, limit: float, percent: float) -> str:
    """Both directions over each other, as an SVG element without text that could be anything but numbers.

    Args:
        forward: drawn as bars.
        backward: drawn as a line.
        limit: where it ends, in the unit of the coordinates.
        percent: percent of the diagonal that 1 in this unit is.
    """
    bars, line = shares(forward, limit)[0], shares(backward, limit)[0]
    wide, tall = (_WIDTH - _LEFT - _RIGHT) / _BINS, _HEIGHT - _TOP - _BOTTOM
    parts = [f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" role="img" aria-label="Histogram of the distances">']
    for k in range(_DECADES + 1):
        y = _TOP + tall * (1 - k / _DECADES)
        parts.append(f'<line class="grid" x1="{_LEFT}" x2="{_WIDTH - _RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>')
        parts.append(f'<text x="{_LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** (k + 2 - _DECADES):g}</text>')
    for k in range(5):
        x = _LEFT + wide * _BINS * k / 4
        parts.append(f'<text x="{x:.1f}" y="{_HEIGHT - 22}" text-anchor="middle">{limit * percent * k / 4:.3g}</text>')
    for k, value in enumerate(bars):
        high = tall * _high(float(value))
        x, y = _LEFT + k * wide, _TOP + tall - high
        parts.append(f'<rect class="bar" x="{x:.2f}" y="{y:.2f}" width="{wide - 1:.2f}" height="{high:.2f}"/>')
    steps = []
    for k, value in enumerate(line):
        y = _TOP + tall * (1 - _high(float(value)))
        steps.append(f"{_LEFT + k * wide:.2f},{y:.2f} {_LEFT + (k + 1) * wide:.2f},{y:.2f}")
    parts.append(f'<polyline class="line" points="{" ".join(steps)}"/>')
    parts.append(
        f'<text x="{_LEFT + wide * _BINS / 2:.1f}" y="{_HEIGHT - 4}" text-anchor="middle">'
        "distance, % of the bounding box's diagonal; upwards: % of the surface, logarithmic</text></svg>"
    )
    return "".join(parts)


def _high(share: float) -> float:
    """Part of the height for a percentage of the surface."""
    return max(0.0, 1 + (math.log10(share) - 2) / _DECADES) if share > 0 else 0.0
