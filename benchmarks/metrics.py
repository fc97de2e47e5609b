#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far is a simplified mesh from its original? The one metric tool of the benchmark.

    metrics.py ORIGINAL SIMPLIFIED [--json] [--samples N]

Distances are exact distances from a point to a mesh (libigl's tree of boxes, float64), in percent of
the diagonal of the original's bounding box. Samples are spread over each surface by area, 200,000 on
each side, with a fixed seed: the same pair of files gives the same figures.

rms               sqrt((F + B) / 2) with F and B the mean squared distances original -> simplified and back
feature_rms       original -> simplified at the 10 % of the original's vertices with the largest descriptor
sharp_rms         original -> simplified at the original's vertices on edges with a dihedral over 30 degrees
hausdorff         largest distance of both directions, over the samples and all vertices
normal_deviation  mean angle (degrees) between the face normals at a sample and at its closest point,
                  mean of both directions
folded_faces      faces whose normal is more than 90 degrees from the original's at the point closest to
                  their centroid
perceptual        how different both look, from 0 to 1: see perceptual.py
new_*             how many more of them the simplified mesh has than the original
"""

import argparse
import json
import sys

import igl
import numpy as np

from mesh_topology import Mesh, area_vectors, edges_of, read_mesh, sharp_vertices, topology_counts, unit_normals
from perceptual import Look, perceptual_difference

SAMPLES = 200_000
SEED = 20120501
FEATURE_PART = 0.1


class Surface:
    """A mesh with what closest-point queries and sampling need."""

    def __init__(self, mesh: Mesh):
        self.mesh = mesh
        vectors = area_vectors(mesh)
        self.areas = np.linalg.norm(vectors, axis=1)
        self.normals = unit_normals(vectors)
        self._vertices = np.asfortranarray(mesh.vertices)
        self._faces = np.asfortranarray(mesh.faces)
        self._tree = igl.AABB()
        self._tree.init(self._vertices, self._faces)

    def closest(self, points: np.ndarray):
        """Squared distance of each point and the face of its closest point."""
        squared, face, _ = self._query(points)
        return np.asarray(squared).reshape(-1), np.asarray(face).reshape(-1)

    def closest_points(self, points: np.ndarray) -> np.ndarray:
        """The surface's point closest to each point."""
        return np.asarray(self._query(points)[2]).reshape(-1, 3)

    def _query(self, points: np.ndarray):
        return self._tree.squared_distance(self._vertices, self._faces, np.asfortranarray(points))

    def samples(self, count: int):
        """Points spread evenly over the area, and the face of each."""
        random = np.random.default_rng(SEED)
        steps = (np.arange(count) + random.random(count)) / count
        cumulated = np.cumsum(self.areas)
        face = np.minimum(np.searchsorted(cumulated, steps * cumulated[-1]), len(self.areas) - 1)
        root, along = np.sqrt(random.random(count)), random.random(count)
        weights = np.stack([1 - root, root * (1 - along), root * along], axis=1)
        corners = self.mesh.vertices[self.mesh.faces[face]]
        return np.einsum("ij,ijk->ik", weights, corners), face


def vertex_normals(mesh: Mesh) -> np.ndarray:
    """Unit normals: the faces' normals weighted by their angle at the vertex."""
    corners = mesh.vertices[mesh.faces]
    normals = unit_normals(area_vectors(mesh))
    total = np.zeros_like(mesh.vertices)
    for corner in range(3):
        one = unit_normals(corners[:, (corner + 1) % 3] - corners[:, corner])
        other = unit_normals(corners[:, (corner + 2) % 3] - corners[:, corner])
        angle = np.arccos(np.clip(np.einsum("ij,ij->i", one, other), -1, 1))
        np.add.at(total, mesh.faces[:, corner], normals * angle[:, None])
    return unit_normals(total)


def laplacian_descriptor(mesh: Mesh) -> np.ndarray:
    """l = |sum (v_j - v_i) . n| / sum |v_j - v_i| over the one-ring: the paper's Eq. 5."""
    ends = edges_of(mesh).vertices
    vector = mesh.vertices[ends[:, 1]] - mesh.vertices[ends[:, 0]]
    normals = vertex_normals(mesh)
    lengths = np.linalg.norm(vector, axis=1)
    count = len(mesh.vertices)
    total_length = sum(np.bincount(ends[:, end], weights=lengths, minlength=count) for end in (0, 1))
    height = sum(
        np.bincount(ends[:, end], weights=sign * np.einsum("ij,ij->i", vector, normals[ends[:, end]]), minlength=count)
        for end, sign in ((0, 1), (1, -1))
    )
    return np.divide(np.abs(height), total_length, out=np.zeros(count), where=total_length > 0)


class ValidOriginal:
    """What counting faults needs of the original; cheap, and the same for every simplified mesh."""

    def __init__(self, mesh: Mesh):
        self.mesh = mesh
        self.surface = Surface(mesh)
        self.topology = topology_counts(mesh)


class Original(ValidOriginal):
    """The original with everything that does not depend on the simplified mesh, for repeated measuring."""

    def __init__(self, mesh: Mesh, samples: int = SAMPLES):
        super().__init__(mesh)
        self.points, self.sample_face = self.surface.samples(samples)
        self.sample_count = samples
        self.look = Look(self.surface, mesh.diagonal)
        feature_count = max(1, int(round(FEATURE_PART * len(mesh.vertices))))
        self.features = np.argsort(-laplacian_descriptor(mesh), kind="stable")[:feature_count]
        self.sharp = sharp_vertices(mesh, edges_of(mesh))


def measure(original: Original, simplified: Mesh) -> dict:
    """All metrics of the module's description."""
    surface = Surface(simplified)
    points, sample_face = surface.samples(original.sample_count)
    forward, forward_face = surface.closest(original.points)
    backward, backward_face = original.surface.closest(points)
    from_vertices, _ = surface.closest(original.mesh.vertices)
    to_vertices, _ = original.surface.closest(simplified.vertices)

    percent = 100 / original.mesh.diagonal
    forward_angle = _angles(original.surface.normals[original.sample_face], surface.normals[forward_face])
    backward_angle = _angles(surface.normals[sample_face], original.surface.normals[backward_face])
    largest = max(part.max() for part in (forward, backward, from_vertices, to_vertices))
    return {
        "rms": percent * np.sqrt((forward.mean() + backward.mean()) / 2),
        "forward_rms": percent * np.sqrt(forward.mean()),
        "backward_rms": percent * np.sqrt(backward.mean()),
        "feature_rms": percent * np.sqrt(from_vertices[original.features].mean()),
        "sharp_rms": percent * np.sqrt(from_vertices[original.sharp].mean()) if len(original.sharp) else None,
        "hausdorff": percent * np.sqrt(largest),
        "normal_deviation": (forward_angle.mean() + backward_angle.mean()) / 2,
        "perceptual": perceptual_difference(original.look, Look(surface, original.mesh.diagonal)),
        **faults(original, simplified),
    }


def faults(original: ValidOriginal, simplified: Mesh) -> dict:
    """Folded faces and topology alone, which need neither samples nor distances."""
    return {
        "folded_faces": _folded_faces(original.surface, simplified),
        **_topology(original.topology, topology_counts(simplified)),
    }


def _angles(normals: np.ndarray, others: np.ndarray) -> np.ndarray:
    return np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", normals, others), -1, 1)))


def _folded_faces(original: Surface, simplified: Mesh) -> int:
    if len(simplified.faces) == 0:
        return 0
    centroids = simplified.vertices[simplified.faces].mean(axis=1)
    _, face = original.closest(centroids)
    normals = unit_normals(area_vectors(simplified))
    return int((np.einsum("ij,ij->i", normals, original.normals[face]) < 0).sum())


def _topology(before: dict, after: dict) -> dict:
    faults = ("non_manifold_edges", "non_manifold_vertices", "duplicate_faces", "degenerate_faces")
    return {**after, **{f"new_{fault}": max(0, after[fault] - before[fault]) for fault in faults}}


def measure_files(original_path, simplified_path, samples: int = SAMPLES) -> dict:
    """Metrics of two mesh files, as plain numbers."""
    values = measure(Original(read_mesh(original_path), samples), read_mesh(simplified_path))
    return plain_numbers(values)


def plain_numbers(values: dict) -> dict:
    """The same values without numpy's types, for JSON."""
    return {key: value.item() if isinstance(value, np.generic) else value for key, value in values.items()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("original")
    parser.add_argument("simplified")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--samples", type=int, default=SAMPLES)
    arguments = parser.parse_args()
    try:
        values = measure_files(arguments.original, arguments.simplified, arguments.samples)
    except (OSError, RuntimeError, ValueError) as error:
        print(f"metrics.py: {error}", file=sys.stderr)
        return 1
    if arguments.json:
        print(json.dumps(values, indent=1))
    else:
        for key, value in values.items():
            print(f"{key:24} {value:.6g}" if isinstance(value, float) else f"{key:24} {value}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
