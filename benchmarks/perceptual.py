# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How different do two surfaces look? A distance says nothing of a bump that catches the light.

After G. Lavoué, "A Multiscale Metric for 3D Mesh Visual Quality Assessment" (MSDM2), Computer Graphics Forum 30 (5),
2011: curvature is compared between closest points over small neighbourhoods by its mean, its standard deviation and
its covariance, as structural similarity compares pictures. Written anew; simpler than the paper's in these points:

- Points spread by area stand for vertices, so no tessellation weighs more than another.
- Curvature is (|k1| + |k2|) / 2 by normal cycles: |dihedral angle| x length / 2 of the edges inside a ball. The ball's
  area is that of a disc and points weigh less towards the rim (Epanechnikov's kernel) instead of an exact cut.
- Neighbourhoods are balls in space, not on the surface.
- Two scales, 1 and 2 % of the original's box diagonal, in place of three.

A value of 0 means that both look alike, 1 that they have nothing in common. It does not change when the two change
places, nor with position, turn or common scale, as long as the diagonal that counts as unit of length does the same.
"""

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial import KDTree

from mesh_topology import Mesh, area_vectors, edges_of, unit_normals

POINTS = 10_000
SCALES = (0.01, 0.02)  # radius in which curvature is taken, in diagonals
WINDOW = 3.0  # radius of a neighbourhood, in radii of curvature
MEAN_WEIGHT, DEVIATION_WEIGHT, STRUCTURE_WEIGHT = 1.0, 1.0, 0.5
STABILITY = 1.0  # the curvature, in 1 / diagonal, below which differences fade
POOLING = 3.0  # Minkowski's exponent: bad places count more than many good ones


class Look:
    """What one surface (metrics.Surface) shows: its curvature at points spread by area, at every scale.

    Lengths are in `diagonal`, the box diagonal of the original of the two that are compared.
    """

    def __init__(self, surface, diagonal: float):
        self._surface, self._diagonal = surface, diagonal
        places, self._masses = edge_masses(surface.mesh, diagonal, min(SCALES) / 2)
        self._bends = KDTree(places) if len(places) else None
        self.points, _ = surface.samples(POINTS)
        tree = KDTree(self.points / diagonal)
        self._windows = {radius: kernel(tree, tree, WINDOW * radius) for radius in SCALES}
        self._values = {radius: self.curvature(tree, radius) for radius in SCALES}

    def curvature(self, points: KDTree, radius: float) -> np.ndarray:
        """(|k1| + |k2|) / 2 of this surface around each point, in 1 / diagonal."""
        if self._bends is None:
            return np.zeros(points.n)
        return 2 / (np.pi * radius**2) * (kernel(points, self._bends, radius) @ self._masses)

    def difference_to(self, other: "Look") -> float:
        """One way: differences at the points of this surface and their closest points on the other, pooled."""
        partners = KDTree(other._surface.closest_points(self.points) / self._diagonal)
        local = np.zeros(len(self.points))
        for radius in SCALES:
            theirs = other.curvature(partners, radius)
            local += local_difference(self._windows[radius], self._values[radius], theirs) / len(SCALES)
        return float(np.mean(local**POOLING) ** (1 / POOLING))


def perceptual_difference(one: Look, other: Look) -> float:
    """Mean of both ways."""
    return (one.difference_to(other) + other.difference_to(one)) / 2


def edge_masses(mesh: Mesh, diagonal: float, spacing: float):
    """Points along the edges of two faces, at most `spacing` apart, and |dihedral angle| x length / 2 of each."""
    edges = edges_of(mesh)
    order = np.argsort(edges.of_corner, kind="stable")
    start = np.concatenate([[0], np.cumsum(edges.face_count)[:-1]])
    shared = np.flatnonzero(edges.face_count == 2)
    first, second = (order[start[shared] + offset] // 3 for offset in (0, 1))
    vectors = area_vectors(mesh)
    normals = unit_normals(vectors)
    sine = np.linalg.norm(np.cross(normals[first], normals[second]), axis=1)
    angle = np.arctan2(sine, np.einsum("ij,ij->i", normals[first], normals[second]))
    has_area = (vectors[first].any(axis=1)) & (vectors[second].any(axis=1))
    bent = has_area & (angle > 0)
    ends = mesh.vertices[edges.vertices[shared[bent]]] / diagonal
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    parts = np.maximum(1, np.ceil(length / spacing)).astype(int)
    edge = np.repeat(np.arange(len(parts)), parts)
    along = (np.arange(len(edge)) - np.repeat(np.cumsum(parts) - parts, parts) + 0.5) / parts[edge]
    places = ends[edge, 0] + along[:, None] * (ends[edge, 1] - ends[edge, 0])
    return places, (angle[bent] * length / parts / 2)[edge]


def kernel(points: KDTree, others: KDTree, radius: float) -> csr_array:
    """1 - (distance / radius)^2 for each pair nearer than the radius."""
    pairs = points.sparse_distance_matrix(others, radius, output_type="ndarray")
    weights = 1 - (pairs["v"] / radius) ** 2
    return csr_array((weights, (pairs["i"], pairs["j"])), shape=(points.n, others.n))


def local_difference(window: csr_array, values: np.ndarray, others: np.ndarray) -> np.ndarray:
    """MSDM2's weighted mean of the differences of mean, deviation and structure in each window."""
    weight = window @ np.ones(len(values))

    def mean(quantity: np.ndarray) -> np.ndarray:
        return (window @ quantity) / weight

    mean_a, mean_b = mean(values), mean(others)
    deviation_a = np.sqrt(np.maximum(mean(values**2) - mean_a**2, 0))
    deviation_b = np.sqrt(np.maximum(mean(others**2) - mean_b**2, 0))
    covariance = mean(values * others) - mean_a * mean_b
    product = deviation_a * deviation_b
    terms = (
        MEAN_WEIGHT * np.abs(mean_a - mean_b) / (np.maximum(mean_a, mean_b) + STABILITY)
        + DEVIATION_WEIGHT * np.abs(deviation_a - deviation_b) / (np.maximum(deviation_a, deviation_b) + STABILITY)
        + STRUCTURE_WEIGHT * np.minimum(np.abs(product - covariance) / (product + STABILITY), 1)
    )
    return terms / (MEAN_WEIGHT + DEVIATION_WEIGHT + STRUCTURE_WEIGHT)
