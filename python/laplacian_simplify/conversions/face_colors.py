# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors of faces: as labels, with seams between them, where few edges separate two colors, and otherwise by way of the
vertices, whose colors are interpolated."""

from typing import Any

import numpy as np

from ..arrays import Simplified
from ..attributes import Array

_MOST_BORDERS = 0.2
"""Of all edges that two faces share: with more of them between colors these are no patches."""
NAME = "face colors"
"""Of the colors of faces as an attribute of vertices."""


def label_or_spread(vertices: Any, faces: Any, colors: Array) -> tuple[Array | None, dict[str, Array]]:
    """Labels of the faces or, where colors change everywhere, an attribute of vertices."""
    labels = np.unique(colors, axis=0, return_inverse=True)[1].reshape(-1)
    faces = np.asarray(faces).astype(np.intp)
    if len(faces) == 0 or faces.min() < 0 or faces.max() >= len(vertices):
        return labels, {}  # which is refused later
    places = np.unique(np.asarray(vertices), axis=0, return_inverse=True)[1].reshape(-1)
    at = places[faces]
    if _borders(at, labels) < _MOST_BORDERS:
        return labels, {}
    count = np.maximum(np.bincount(at.ravel(), minlength=len(places)), 1)
    wide = np.repeat(colors.astype(np.float64), 3, axis=0)
    means = [np.bincount(at.ravel(), wide[:, k], minlength=len(places)) / count for k in range(colors.shape[1])]
    return None, {NAME: (np.stack(means, axis=1) / _whole(colors)).astype(np.float32)[places]}


def _borders(at: Array, labels: Array) -> float:
    """The part of the edges between two faces that separates labels."""
    ends = np.sort(np.concatenate([at[:, [0, 1]], at[:, [1, 2]], at[:, [2, 0]]]), axis=1)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    shared = (ends[order[1:]] == ends[order[:-1]]).all(axis=1)
    sides = np.tile(labels, 3)[order]
    return float((sides[1:] != sides[:-1])[shared].mean()) if shared.any() else 0.0


def face_colors(colors: Array, result: Simplified) -> Array:
    """The colors of the result's faces."""
    spread = result.vertex_attributes.get(NAME)
    if spread is None:
        return colors[result.face_origin]
    mean: Array = spread.astype(np.float64)[result.faces.astype(np.intp)].mean(axis=1) * _whole(colors)
    rounded: Array = np.rint(mean) if colors.dtype.kind != "f" else mean
    return rounded.astype(colors.dtype)


def _whole(colors: Array) -> float:
    return float(np.iinfo(colors.dtype).max) if colors.dtype.kind != "f" else 1.0
