# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How well numbers tell features from the rest, and how much they come in groups."""

import numpy as np
from scipy.stats import rankdata

from mesh_topology import area_vectors, edges_of, unit_normals


def to_unit(values: np.ndarray) -> np.ndarray:
    """Scaled to [0, 1] with the 99.9 percentile as the top, as the filters do."""
    low, top = values.min(), np.percentile(values, 99.9)
    return np.clip((values - low) / (top - low), 0, 1) if top > low else np.zeros_like(values)


def separation(values: np.ndarray, is_feature: np.ndarray) -> float:
    """Probability that a feature vertex has a larger value than another (the area under the ROC curve)."""
    features, rest = int(is_feature.sum()), int((~is_feature).sum())
    if features == 0 or rest == 0:
        return float("nan")
    ranks = rankdata(values)[is_feature].sum()
    return float((ranks - features * (features + 1) / 2) / (features * rest))


def precision_and_recall(selected: np.ndarray, is_feature: np.ndarray) -> tuple[float, float]:
    """Percent of the selected that are features, and of the features that are selected."""
    both = float((selected & is_feature).sum())
    return 100 * both / max(1, selected.sum()), 100 * both / max(1, is_feature.sum())


def explained(values: np.ndarray, groups: np.ndarray) -> float:
    """Part of the variance of the values that lies between the groups, 0 to 1."""
    total = ((values - values.mean()) ** 2).sum()
    within = sum(((values[groups == g] - values[groups == g].mean()) ** 2).sum() for g in np.unique(groups))
    return float(1 - within / total) if total > 0 else 0.0


def largest_dihedral(mesh) -> np.ndarray:
    """For each vertex the largest angle (degrees) between the normals of two faces that share an edge at it."""
    edges = edges_of(mesh)
    order = np.argsort(edges.of_corner, kind="stable")
    start = np.concatenate([[0], np.cumsum(edges.face_count)[:-1]])
    shared = np.flatnonzero(edges.face_count == 2)
    normals = unit_normals(area_vectors(mesh))
    first, second = (normals[order[start[shared] + offset] // 3] for offset in (0, 1))
    angle = np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", first, second), -1, 1)))
    largest = np.zeros(len(mesh.vertices))
    for end in (0, 1):
        np.maximum.at(largest, edges.vertices[shared, end], angle)
    return largest


def grouping(values: np.ndarray, classes: int = 5) -> float:
    """Part of the variance that lies between the classes of an exact 1-D k-means over 512 bins."""
    return explained(values, segments(values, classes))


def segments(values: np.ndarray, classes: int) -> np.ndarray:
    """The class of each value, 0 the lowest, with the least sum of squares (values in 512 bins)."""
    bins = np.minimum((to_unit(values) * 512).astype(int), 511)
    used, place, count = np.unique(bins, return_inverse=True, return_counts=True)
    center = np.bincount(place, weights=to_unit(values)) / count
    sums = [np.concatenate([[0], np.cumsum(count * center**power)]) for power in range(3)]
    classes = min(classes, len(used))
    ends = np.arange(len(used) + 1)

    def cost(begin, end):
        weight = np.maximum(sums[0][end] - sums[0][begin], 1)
        return sums[2][end] - sums[2][begin] - (sums[1][end] - sums[1][begin]) ** 2 / weight

    best, cuts = cost(0, ends), []
    for _ in range(classes - 1):
        table = best[None, :] + cost(ends[None, :], ends[:, None])
        table[ends[None, :] > ends[:, None]] = np.inf
        cuts.append(table.argmin(axis=1))
        best = table.min(axis=1)
    borders, end = [], len(used)
    for cut in reversed(cuts):
        end = cut[end]
        borders.append(end)
    return np.searchsorted(sorted(borders), place, side="right")
