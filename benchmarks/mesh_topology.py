# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts of what must not appear in a triangle mesh, and the arrays that the metrics share.

A mesh is a pair of arrays: `vertices` (n x 3, float64) and `faces` (m x 3, integers).
"""

from dataclasses import dataclass

import igl
import numpy as np
import trimesh
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

SHARP_ANGLE_DEGREES = 30.0
DEGENERATE_AREA = 1e-14  # of the squared box diagonal
COUNTS = (
    "vertices",
    "faces",
    "boundary_edges",
    "non_manifold_edges",
    "non_manifold_vertices",
    "duplicate_faces",
    "degenerate_faces",
)


@dataclass(frozen=True)
class Mesh:
    """A triangle mesh without unreferenced vertices."""

    vertices: np.ndarray
    faces: np.ndarray

    @property
    def diagonal(self) -> float:
        """Length of the bounding box's diagonal."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))


@dataclass(frozen=True)
class Edges:
    """Every undirected edge once: its two vertices, and the edge of each of the 3m face corners.

    Corner c of face f (position f * 3 + c) owns the edge from its vertex to the next one.
    """

    vertices: np.ndarray
    of_corner: np.ndarray
    face_count: np.ndarray


def without_unreferenced(vertices: np.ndarray, faces: np.ndarray) -> Mesh:
    """The mesh of those vertices that some face uses, in their old order."""
    used, renumbered = np.unique(faces, return_inverse=True)
    return Mesh(np.ascontiguousarray(vertices[used]), renumbered.reshape(-1, 3).astype(np.int64))


def read_mesh(path) -> Mesh:
    """Reads PLY, OFF, OBJ or STL; polygons are cut into triangles.

    libigl reads all but PLY files with faces: it aborts where their properties are of several types.
    trimesh reads those, but not the triangle strips of some scans.
    :raises ValueError: if the file holds no face.
    """
    vertices, faces = [], []
    if str(path).lower().endswith(".ply"):
        loaded = trimesh.load(str(path), process=False, force="mesh")
        vertices, faces = loaded.vertices, getattr(loaded, "faces", [])
    if len(faces) == 0:
        vertices, faces = igl.read_triangle_mesh(str(path))
    if len(faces) == 0:
        raise ValueError(f"{path}: no faces")
    return without_unreferenced(np.asarray(vertices, dtype=np.float64)[:, :3], np.asarray(faces))


def welded(mesh: Mesh) -> Mesh:
    """Unites vertices at exactly the same place and drops faces that are degenerate or doubled by it."""
    vertices, renumbered = np.unique(mesh.vertices, axis=0, return_inverse=True)
    faces = renumbered.reshape(-1)[mesh.faces]
    faces = faces[~has_repeated_vertex(faces)]
    _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    return without_unreferenced(vertices, faces[np.sort(first)])


def has_repeated_vertex(faces: np.ndarray) -> np.ndarray:
    """True for each face that names a vertex twice."""
    following = np.roll(faces, -1, axis=1)
    return (faces == following).any(axis=1)


def area_vectors(mesh: Mesh) -> np.ndarray:
    """Normal of each face, as long as the face's area."""
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    return 0.5 * np.cross(b - a, c - a)


def unit_normals(vectors: np.ndarray) -> np.ndarray:
    """Rows scaled to length 1; rows of zeros stay."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 0)


def edges_of(mesh: Mesh) -> Edges:
    """All edges with the number of faces at each."""
    ends = np.stack([mesh.faces, np.roll(mesh.faces, -1, axis=1)], axis=2).reshape(-1, 2)
    ends.sort(axis=1)
    keys = ends[:, 0] * len(mesh.vertices) + ends[:, 1]
    unique, of_corner, count = np.unique(keys, return_inverse=True, return_counts=True)
    vertices = np.stack([unique // len(mesh.vertices), unique % len(mesh.vertices)], axis=1)
    return Edges(vertices, of_corner.reshape(-1), count)


def sharp_vertices(mesh: Mesh, edges: Edges) -> np.ndarray:
    """Vertices on an edge of two faces whose normals differ by more than 30 degrees."""
    face_of_corner = np.arange(3 * len(mesh.faces)) // 3
    order = np.argsort(edges.of_corner, kind="stable")
    start = np.concatenate([[0], np.cumsum(edges.face_count)[:-1]])
    shared = np.flatnonzero(edges.face_count == 2)
    first, second = (face_of_corner[order[start[shared] + offset]] for offset in (0, 1))
    normals = unit_normals(area_vectors(mesh))
    cosine = np.einsum("ij,ij->i", normals[first], normals[second])
    sharp = cosine < np.cos(np.radians(SHARP_ANGLE_DEGREES))
    return np.unique(edges.vertices[shared[sharp]])


def non_manifold_vertices(mesh: Mesh, edges: Edges) -> int:
    """Vertices whose faces fall into several fans that share no edge at the vertex."""
    corners = 3 * len(mesh.faces)
    order = np.argsort(edges.of_corner, kind="stable")
    same_edge = edges.of_corner[order[1:]] == edges.of_corner[order[:-1]]
    previous, following = order[:-1][same_edge], order[1:][same_edge]
    links = [_corners_at_shared_vertices(mesh, previous, following, end) for end in (0, 1)]
    rows = np.concatenate([link[0] for link in links])
    columns = np.concatenate([link[1] for link in links])
    graph = coo_array((np.ones(len(rows), dtype=np.int8), (rows, columns)), shape=(corners, corners))
    _, fan = connected_components(graph, directed=False)
    pairs = np.unique(np.stack([mesh.faces.reshape(-1), fan], axis=1), axis=0)
    return int((np.bincount(pairs[:, 0]) > 1).sum())


def _corners_at_shared_vertices(mesh: Mesh, edge_corner: np.ndarray, other_edge_corner: np.ndarray, end: int):
    """For pairs of corners that own the same edge: the two faces' corners at one of the edge's ends."""
    vertex_at = mesh.faces.reshape(-1)
    here = _following_corner(edge_corner) if end else edge_corner
    same = vertex_at[other_edge_corner] == vertex_at[here]
    return here, np.where(same, other_edge_corner, _following_corner(other_edge_corner))


def _following_corner(corner: np.ndarray) -> np.ndarray:
    return corner - corner % 3 + (corner + 1) % 3


def topology_counts(mesh: Mesh) -> dict:
    """Vertices, faces, and everything that makes a mesh not a manifold."""
    if len(mesh.faces) == 0:
        return dict.fromkeys(COUNTS, 0)
    edges = edges_of(mesh)
    area = np.linalg.norm(area_vectors(mesh), axis=1)
    degenerate = has_repeated_vertex(mesh.faces) | (area < DEGENERATE_AREA * mesh.diagonal**2)
    distinct = np.unique(np.sort(mesh.faces, axis=1), axis=0)
    counts = (
        len(mesh.vertices),
        len(mesh.faces),
        int((edges.face_count == 1).sum()),
        int((edges.face_count > 2).sum()),
        non_manifold_vertices(mesh, edges),
        len(mesh.faces) - len(distinct),
        int(degenerate.sum()),
    )
    return dict(zip(COUNTS, counts))
